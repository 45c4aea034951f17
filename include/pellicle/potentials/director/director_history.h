// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_point.h>
#include <pellicle/potentials/director/director_targets.h>

#include <vector>

namespace pellicle
{
/** Spontaneous curvature at a material point as (44) of Hu, Zhang & E 2007 has it: two vectors b_a, orthogonal to the
 * director, and the state to which they belong. */
struct DirectorHistory
{
  DirectorPoint at;
  FirstDerivatives<double> b; ///< b_1 b_2, with b_a . O = 0
};

/** b_a = B (I - O O) a_a at each of the given points. */
std::vector<DirectorHistory> isotropic_history(const std::vector<DirectorPoint> &points, double B);

/**
 * b_a after a motion of tangent plane and director from where `before` was: one step of
 *
 *     d_t b_a = S_a^p b_p + (zeta/2) O x b_a - (O_t . b_a) O,
 *
 * S the rate of strain, zeta the vorticity. Its stretch is the root U of F^T F = U^2 (U_a^p a_p = U a_a) in the
 * convected base, its rotation that which carries O to the new director d along the shortest way after a turn about O
 * by the angle of the material about its normal:
 *
 *     b_a' = U_a^p R b_p,  R = (O -> d) turn(O, theta),  theta the angle of (n' -> n) F = turn(n, theta) U.
 *
 * So b_a' . d = 0 exactly; where O = n rigid motions carry b_a with them and b_a = B a_a stays so, both exactly; the
 * error of a step is of third order. Needs O . d > -1 and n . n' > -1: steps below half a turn. With tilt the law
 * itself is not objective: a rigid spin omega turns b_a about O at the rate omega . n, not omega . O.
 */
template <typename Number>
FirstDerivatives<Number> transported(const DirectorHistory &before, const TangentPlane<Number> &now,
                                     const Vector3<Number> &d)
{
  const auto number = [](const Vector3<double> &v) { return Vector3<Number>(v[0], v[1], v[2]); };
  const TangentPlane<double> old(before.at.x_1, before.at.x_2);
  const Vector3<Number> n = number(old.normal), O = number(before.at.O);

  // U = (U^2 + det U I)/tr U, with (U^2)_a^p = a'_ag a^gp of the old metric.
  const Number det_U   = now.jacobian / old.jacobian;
  const Number trace_2 = old.inverse_metric(0, 0) * now.metric(0, 0) +
                         2. * old.inverse_metric(0, 1) * now.metric(0, 1) + old.inverse_metric(1, 1) * now.metric(1, 1);
  using std::sqrt;
  const Number trace_U = sqrt(trace_2 + 2. * det_U);

  // F^ = (n' -> n) F: its trace is tr U cos(theta), its skew part tr U sin(theta).
  Number cosine(0.), sine(0.);
  const Vector3<Number> bisector = (1. / (1. + dot(n, now.normal))) * (n + now.normal);
  for (unsigned int a = 0; a < 2; ++a)
  {
    const Vector3<Number> F_a = now.base[a] - dot(n, now.base[a]) * bisector, dual = number(old.dual[a]);
    cosine += dot(dual, F_a) / trace_U;
    sine += dot(n, cross(dual, F_a)) / trace_U;
  }

  FirstDerivatives<Number> rotated, result;
  const Vector3<Number> director_bisector = (1. / (1. + dot(O, d))) * (O + d);
  for (unsigned int p = 0; p < 2; ++p)
  {
    const Vector3<Number> b = number(before.b[p]), turned = cosine * b + sine * cross(O, b);
    rotated[p] = turned - dot(d, turned) * director_bisector;
  }
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int p = 0; p < 2; ++p)
    {
      const Number square = now.metric(a, 0) * old.inverse_metric(0, p) + now.metric(a, 1) * old.inverse_metric(1, p);
      const Number U      = (a == p ? Number(square + det_U) : square) / trace_U;
      result[a] += U * rotated[p];
    }
  return result;
}

/** Carries all b_a along to new states of their points and makes those the state to which they belong. */
void transport(std::vector<DirectorHistory> &history, const std::vector<DirectorPoint> &now);

} // namespace pellicle
