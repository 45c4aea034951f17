// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/closest_point.h>
#include <pellicle/kinematics/dense_matrix.h>

#include <string>
#include <vector>

namespace pellicle
{
/**
 * A way to compute the second variation of the gap, Dd g = u . matrix u, for the tangent of contact.
 *
 * | name    | formula, symbols of ClosestPoint                                                  | |
 * |---------|-----------------------------------------------------------------------------------|------------------------|
 * | `full`  | -(Q_a D^aT + D^a Q_a^T + b_ab D^a D^bT) + g a^ab q_a q_b^T, q_a = Q_a + b_ag D^g  | (115) of Sauer 2014 |
 * | `equal` | -(Q_a D^aT + D_hat^a Q_a^T + b_ab D_hat^a D^bT)                                   | (117): the same
 * matrix | | `hat`   | `equal` with D_hat for D                                                          | exact at g =
 * 0 only    | | `none`  | 0                                                                                 | Newton
 * turns linear    |
 *
 * On edges and at vertices, except for `none`, B_i B_i^T/g is added: the normal turns about an edge like that of a tube
 * of radius g. The paper calls (117) a reduced and unsymmetric form of (115); with D from (39) and D_hat from (42) the
 * two agree at every gap, so that `full` and `equal` check each other.
 */
struct GapSecondVariation
{
  std::string name;
  void (*add)(const ClosestPoint &point, double factor, DenseMatrix &matrix); ///< matrix += factor Dd g
};

/** The table above, in its order. */
const std::vector<GapSecondVariation> &gap_second_variations();

/** Throws UserError with the names that exist for one that does not. */
const GapSecondVariation &gap_second_variation(const std::string &name);

/** Dd xi^a (116), exact at every gap; reads second derivatives of shape functions and third ones of the master. */
DenseMatrix parameter_second_variation(const ClosestPoint &point, const MasterPoint &master, unsigned int a);

/** (118): the derivative of D_hat^a; rows: variation, columns: linearisation. Unsymmetric, for D_hat^a derives from no
 * function. */
DenseMatrix simplified_parameter_second_variation(const ClosestPoint &point, const MasterPoint &master, unsigned int a);
} // namespace pellicle
