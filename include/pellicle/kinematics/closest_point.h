// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/surface_point.h>

#include <array>
#include <vector>

namespace pellicle
{
/**
 * A point x_p of a master cell x_m = sum_K x_K M_K(xi), and what is free there: both parameters inside the cell, one on
 * an edge between cells, none at a vertex. Only the derivatives in free parameters are read; on an edge the free one is
 * number 0.
 */
struct MasterPoint
{
  unsigned int n_parameters = 2; ///< free ones
  Vector3<double> x;             ///< x_p
  FirstDerivatives<double> first;
  SecondDerivatives<double> second;
  std::array<Vector3<double>, 4> third; ///< ,111 ,112 ,122 ,222; for second variations of parameters only
  /** Of an edge or vertex: any vector on the master's outer side there. */
  Vector3<double> outward;

  std::vector<double> values;                       ///< M_K
  std::array<std::vector<double>, 2> first_values;  ///< M_K,a
  std::array<std::vector<double>, 3> second_values; ///< M_K,11 ,12 ,22

  std::size_t n_nodes() const { return values.size(); }
  const Vector3<double> &third_derivative(unsigned int a, unsigned int b, unsigned int c) const
  {
    return third[a + b + c];
  }
};

/**
 * The closest point x_p of a surface that deforms to a point x that moves, and how gap and parameters of x_p change
 * with both: section 3.2 of Sauer 2014. u are the increments of x and of the master cell's nodes; row of component c:
 * c (1 + n_nodes) for x, c (1 + n_nodes) + 1 + K for master node K.
 *
 * | code            | symbol                                                                              |
 * |-----------------|-------------------------------------------------------------------------------------|
 * | normal          | n_p, outward; on edges and at vertices along x - x_p                                |
 * | gap             | g = (x - x_p) . n_p (16), negative in the master                                    |
 * | base[a]         | a_a                                                                                 |
 * | metric, inverse_metric | a_ab, a^ab of the free parameters                                            |
 * | curvature       | b_ab = n_p . x,ab                                                                   |
 * | c               | c^ab = (a_ab - g b_ab)^-1 (40)                                                      |
 * | N               | dg = N . u = (dx - dx_p) . n_p: (38), which is (41) at every gap, for n_p is a unit vector |
 * | T[a]            | T_a . u = (dx - dx_p) . a_a                                                         |
 * | Q[a]            | Q_a . u = n_p . dx_p,a                                                              |
 * | D[a]            | dxi^a = D^a . u, D^a = c^ab (T_b + g Q_b) (39)                                      |
 * | D_hat[a]        | a^ab T_b (42), D^a at g = 0                                                         |
 * | across[i], B[i] | unit vectors normal to n_p and all a_a: none inside a cell, one on an edge, two at a vertex; B_i
 * . u = (dx - dx_p) . across_i |
 */
struct ClosestPoint
{
  /**
   * x - x_p is orthogonal to the free a_a (18), which is not checked.
   * Throws SolveError where a_ab - g b_ab is not positive definite, so that x_p is not closest and moves without bound
   * (x at or beyond the centre of curvature); and for x on an edge or vertex itself, where n_p has no direction.
   */
  ClosestPoint(const Vector3<double> &x, const MasterPoint &master);

  unsigned int n_parameters;
  double gap = 0.;
  Vector3<double> normal;
  FirstDerivatives<double> base;
  SymmetricSurfaceTensor<double> metric, inverse_metric, curvature, c;
  std::vector<Vector3<double>> across;

  std::vector<double> N;
  std::array<std::vector<double>, 2> T, Q, D, D_hat;
  std::vector<std::vector<double>> B;

  std::size_t n_rows() const { return N.size(); }

private:
  void place(const Vector3<double> &x, const MasterPoint &master);
  void make_vectors(const MasterPoint &master);
};

/** [v; -M_K v]: (dx - dx_p) . v as a row over x and master nodes. */
std::vector<double> relative_row(const Vector3<double> &v, const MasterPoint &master);
/** [0; m_K v]: v . sum_K m_K dx_K, for m = M_K,a: v . dx_p,a. */
std::vector<double> master_row(const Vector3<double> &v, const std::vector<double> &m);
} // namespace pellicle
