// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_tensors.h>
#include <pellicle/kinematics/vector3.h>

namespace pellicle
{
/** First parametric derivatives ,1 ,2 of a vector field. */
template <typename Number>
using FirstDerivatives = std::array<Vector3<Number>, 2>;

/** Second parametric derivatives ,11 ,12 ,22 of a vector field. */
template <typename Number>
using SecondDerivatives = SymmetricSurfaceTensor<Vector3<Number>>;

/**
 * Geometry of a surface x(u1, u2) that needs first derivatives only. Everything is computed by the constructor, top to
 * bottom.
 *
 * | code               | symbol                                       |
 * |--------------------|----------------------------------------------|
 * | base[a]            | a_a = x,a                                    |
 * | metric(a, b)       | a_ab = a_a . a_b                             |
 * | area_vector        | a_1 x a_2 = J n                              |
 * | jacobian           | J = norm(a_1 x a_2): dA = J du1 du2          |
 * | normal             | n = a_1 x a_2 / J, outward on a closed surface |
 * | inverse_metric(a, b) | a^ab: a^ag a_gb = delta^a_b                |
 * | dual[a]            | a^a = a^ab a_b: a^a . a_b = delta^a_b        |
 *
 * Nothing is checked. Where the parametrisation degenerates (a_1 parallel to a_2) base, metric, area_vector and
 * jacobian (= 0) are still right, while normal, inverse_metric and dual, and derivatives of the jacobian with automatic
 * differentiation, are not finite.
 */
template <typename Number>
struct TangentPlane
{
  TangentPlane(const Vector3<Number> &x_1, const Vector3<Number> &x_2)
      : base{{x_1, x_2}}
      , metric(dot(x_1, x_1), dot(x_1, x_2), dot(x_2, x_2))
      , area_vector(cross(x_1, x_2))
      , jacobian(norm(area_vector))
      , normal(area_vector / jacobian)
  {
    const Number det_inverse = 1. / dot(area_vector, area_vector); // det a_ab = J^2
    inverse_metric           = SymmetricSurfaceTensor<Number>(
        Number(metric(1, 1) * det_inverse), Number(-metric(0, 1) * det_inverse), Number(metric(0, 0) * det_inverse));
    for (unsigned int a = 0; a < 2; ++a)
      dual[a] = inverse_metric(a, 0) * base[0] + inverse_metric(a, 1) * base[1];
  }

  FirstDerivatives<Number> base;
  SymmetricSurfaceTensor<Number> metric;
  Vector3<Number> area_vector;
  Number jacobian;
  Vector3<Number> normal;
  SymmetricSurfaceTensor<Number> inverse_metric;
  FirstDerivatives<Number> dual;
};

/**
 * All geometry at a point of a surface: the tangent plane and what second derivatives add. On a surface made of C0
 * elements this is the geometry inside one element; the kinks between elements are not in it.
 *
 * | code                     | symbol                                                     |
 * |--------------------------|------------------------------------------------------------|
 * | second(a, b)             | x,ab                                                       |
 * | curvature(a, b)          | b_ab = n . x,ab                                            |
 * | mixed_curvature[a][b]    | b^a_b = a^ag b_gb                                          |
 * | mean_curvature           | H = b^a_a / 2, -1/R on a sphere                            |
 * | gauss_curvature          | K = det b^a_b, 1/R^2 on a sphere                           |
 * | christoffel[g](a, b)     | Gamma^g_ab = a^g . x,ab                                    |
 */
template <typename Number>
struct SurfacePoint : TangentPlane<Number>
{
  SurfacePoint(const Vector3<Number> &x_1, const Vector3<Number> &x_2, const Vector3<Number> &x_11,
               const Vector3<Number> &x_12, const Vector3<Number> &x_22)
      : TangentPlane<Number>(x_1, x_2)
      , second(x_11, x_12, x_22)
      , curvature(normal_part(x_11), normal_part(x_12), normal_part(x_22))
  {
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
        mixed_curvature[a][b] =
            this->inverse_metric(a, 0) * curvature(0, b) + this->inverse_metric(a, 1) * curvature(1, b);
    mean_curvature  = 0.5 * (mixed_curvature[0][0] + mixed_curvature[1][1]);
    gauss_curvature = mixed_curvature[0][0] * mixed_curvature[1][1] - mixed_curvature[0][1] * mixed_curvature[1][0];
    for (unsigned int g = 0; g < 2; ++g)
      christoffel[g] =
          SymmetricSurfaceTensor<Number>(dot(this->dual[g], x_11), dot(this->dual[g], x_12), dot(this->dual[g], x_22));
  }

  SecondDerivatives<Number> second;
  SymmetricSurfaceTensor<Number> curvature;
  std::array<std::array<Number, 2>, 2> mixed_curvature;
  Number mean_curvature;
  Number gauss_curvature;
  std::array<SymmetricSurfaceTensor<Number>, 2> christoffel;

private:
  Number normal_part(const Vector3<Number> &x_ab) const { return dot(this->normal, x_ab); }
};
} // namespace pellicle
