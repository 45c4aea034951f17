// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/height_field.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace pellicle
{
namespace
{
constexpr unsigned int most_steps    = 100;
constexpr unsigned int most_halvings = 40;
constexpr double rounding            = std::numeric_limits<double>::epsilon();
/** Of 1 - g k, below which a foot counts as a centre of curvature: derivatives of the foot are then over 1e6. */
constexpr double least_distance_from_focus = 1e-6;

/** A symmetric 2 x 2 matrix. */
struct Symmetric2
{
  double xx = 0., xy = 0., yy = 0.;

  double determinant() const { return xx * yy - xy * xy; }
  bool is_positive_definite() const { return xx > 0. && determinant() > 0.; }
  std::pair<double, double> solve(const double x, const double y) const
  {
    return {(yy * x - xy * y) / determinant(), (xx * y - xy * x) / determinant()};
  }
};

/** A place (u, v) of the surface seen from the point x; the distance to it is to become least. */
struct Candidate
{
  double u = 0., v = 0.;
  PlaceSample H;
  double above         = 0.;         ///< x_z - H
  double halved_square = 0.;         ///< |r|^2/2, r = x - (u, v, H)
  double slope_u = 0., slope_v = 0.; ///< its derivatives, -r . a_a

  Candidate(const FunctionOfPlace &height, const Vector3<double> &x, const double u, const double v)
      : u(u)
      , v(v)
      , H(height.at(u, v))
      , above(x[2] - H.value)
      , halved_square(0.5 * ((x[0] - u) * (x[0] - u) + (x[1] - v) * (x[1] - v) + above * above))
      , slope_u(u - x[0] - above * H.dx)
      , slope_v(v - x[1] - above * H.dy)
  {
  }

  bool is_finite() const { return std::isfinite(halved_square + slope_u + slope_v + H.dxx + H.dxy + H.dyy); }

  Symmetric2 metric() const { return {1. + H.dx * H.dx, H.dx * H.dy, 1. + H.dy * H.dy}; }

  /** Second derivatives of |r|^2/2: a_ab - r . x,ab, at the foot a - g b. */
  Symmetric2 second_derivatives() const
  {
    const Symmetric2 a = metric();
    return {a.xx - above * H.dxx, a.xy - above * H.dxy, a.yy - above * H.dyy};
  }

  /** Size of the round-off in the slopes. */
  double noise() const
  {
    const double steepness = 1. + std::abs(H.dx) + std::abs(H.dy);
    return rounding * (std::abs(u) + std::abs(v) + (std::abs(above) + std::abs(H.value)) * steepness);
  }

  double slope() const { return std::hypot(slope_u, slope_v); }

  bool is_flat() const { return slope() <= 8. * noise(); }
};

/** A step towards a lesser distance, downhill in any case: Newton's where that is a step to a minimum, else that of
 * Gauss and Newton. */
std::pair<double, double> downhill_step(const Candidate &foot)
{
  const Symmetric2 newton = foot.second_derivatives();
  return (newton.is_positive_definite() ? newton : foot.metric()).solve(-foot.slope_u, -foot.slope_v);
}

/** From a saddle or maximum of the distance along the direction in which it falls most; `least` is the negative
 * eigenvalue of its second derivatives. */
Candidate leave_saddle(const FunctionOfPlace &height, const Vector3<double> &x, const Candidate &foot,
                       const double least)
{
  const Symmetric2 A = foot.second_derivatives();
  // Either column of A - (other eigenvalue) is the eigenvector; take the longer one.
  const double other = A.xx + A.yy - least;
  const double ax = A.xx - other, bx = A.xy, ay = A.xy, by = A.yy - other;
  const bool first = std::hypot(ax, ay) >= std::hypot(bx, by);
  const double du = first ? ax : bx, dv = first ? ay : by;
  const double length = 1e-3 * std::abs(foot.above) / std::hypot(du, dv);
  return {height, x, foot.u + length * du, foot.v + length * dv};
}

/** Whether the distance can be lowered from a place without slope. */
bool is_saddle(const Candidate &foot, double &least_eigenvalue)
{
  const Symmetric2 A = foot.second_derivatives();
  least_eigenvalue   = 0.5 * (A.xx + A.yy) - std::hypot(0.5 * (A.xx - A.yy), A.xy);
  return least_eigenvalue < -least_distance_from_focus * foot.metric().determinant();
}

/** One step of the search with the fraction of it by which the distance falls; `foot` itself when there is none. */
Candidate lower(const FunctionOfPlace &height, const Vector3<double> &x, const Candidate &foot)
{
  const auto [du, dv]  = downhill_step(foot);
  const double descent = foot.slope_u * du + foot.slope_v * dv;
  double fraction      = 1.;
  for (unsigned int halvings = 0; halvings < most_halvings; ++halvings, fraction *= 0.5)
  {
    const Candidate trial(height, x, foot.u + fraction * du, foot.v + fraction * dv);
    // Near the foot the distance does not change within round-off: there the slope decides.
    const bool falls = trial.halved_square <= foot.halved_square + 1e-4 * fraction * descent;
    const bool close = -descent <= 1e3 * rounding * foot.halved_square && trial.slope() < foot.slope();
    if (trial.is_finite() && (falls || close))
      return trial;
  }
  return foot;
}

/** The foot of x, where the slopes vanish up to round-off; `fail` throws. */
template <typename Fail>
Candidate find_foot(const FunctionOfPlace &height, const Vector3<double> &x, const Fail &fail)
{
  Candidate foot(height, x, x[0], x[1]);
  if (!foot.is_finite())
    fail("the height or a derivative of it is not finite there");
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    double least_eigenvalue = 0.;
    if (foot.is_flat() && foot.above > 0. && is_saddle(foot, least_eigenvalue))
      foot = leave_saddle(height, x, foot, least_eigenvalue);
    if (foot.is_flat())
      return foot;
    const Candidate next = lower(height, x, foot);
    if (next.u == foot.u && next.v == foot.v)
    {
      if (foot.slope() <= 1e4 * foot.noise()) // heights of less than full precision
        return foot;
      fail("the search for the closest point of the surface got stuck, as it does at kinks and steps of the height");
    }
    foot = next;
  }
  fail("the search for the closest point of the surface did not converge");
  return foot;
}

std::string at_point(const Vector3<double> &x)
{
  char text[100];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", x[0], x[1], x[2]);
  return text;
}
} // namespace

HeightField::HeightField(std::shared_ptr<const FunctionOfPlace> height)
    : height(std::move(height))
    , description("height field " + this->height->text())
{
}

GapSample HeightField::gap(const Vector3<double> &x) const
{
  const auto fail = [&](const std::string &reason)
  {
    throw SolveError("The distance of the point " + at_point(x) + " from the " + description +
                     " is not defined: " + reason + ". (Coordinates in units of the scene's length.)");
  };
  const Candidate foot = find_foot(*height, x, fail);
  const PlaceSample &H = foot.H;
  const Symmetric2 a = foot.metric(), a_gb = foot.second_derivatives();
  // det(a - g b)/det a = (1 - g k_1)(1 - g k_2)
  if (!a_gb.is_positive_definite() || a_gb.determinant() <= least_distance_from_focus * a.determinant())
    fail("it is at or beyond a centre of curvature of the surface, where no closest point is unique");

  const double W = std::sqrt(a.determinant()); // = |a_1 x a_2|
  GapSample sample;
  sample.foot   = {foot.u, foot.v, H.value};
  sample.normal = {-H.dx / W, -H.dy / W, 1. / W};
  sample.gap    = dot(x - sample.foot, sample.normal);

  // (a - g b)^-1 b a^-1, symmetric: rows of (a - g b)^-1 b, then times a^-1.
  const Vector3<double> base[2] = {{1., 0., H.dx}, {0., 1., H.dy}};
  const Symmetric2 b{H.dxx / W, H.dxy / W, H.dyy / W};
  const auto column_x = a_gb.solve(b.xx, b.xy), column_y = a_gb.solve(b.xy, b.yy);
  const auto row_x = a.solve(column_x.first, column_y.first), row_y = a.solve(column_x.second, column_y.second);
  const double mixed = 0.5 * (row_x.second + row_y.first);
  sample.hessian     = -row_x.first * outer(base[0], base[0]) - row_y.second * outer(base[1], base[1]) -
                   mixed * (outer(base[0], base[1]) + outer(base[1], base[0]));
  return sample;
}
} // namespace pellicle
