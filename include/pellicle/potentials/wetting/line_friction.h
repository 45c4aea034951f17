// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/potential.h>
#include <pellicle/potentials/wetting/substrate_chart.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * What the friction of a contact line depends on beside its place. It is shared with whoever changes it between
 * equilibria. Until its lists are filled there is no friction.
 */
struct LineFrictionState
{
  std::size_t n_points = 1;        ///< quadrature points of a cell of the line
  std::vector<double> coefficient; ///< by cell: gamma (cos(theta) - cos(theta of slip)); 0: nothing slips there
  std::vector<double> start;       ///< by point: density of the wetted area at the beginning of the load step
  double dissipated = 0.;          ///< before the load step, per unit of the line's parameter
};

/**
 * Energy that a contact line dissipates when it slips over its substrate, on top of what earlier load steps cost:
 *
 *     D = D_before + sum over cells c of f_c (S_c(x) - S_c(x_0)),    f_c = gamma (cos(theta) - cos(theta_c)),
 *
 * S_c the wetted area in the sector between cell c and the origin of the substrate's chart, theta_c the advancing or
 * the receding angle: f_c is positive where the line advances and negative where it recedes. Sectors are not what the
 * line sweeps, but their differences add up to it over neighbouring cells that slip alike, as ends of a slipping part
 * stay where they are. So the variation with respect to nodes that slip is that of f_c times the swept area, and the
 * equilibrium angle there is theta_c in place of theta.
 */
std::shared_ptr<const Potential> make_line_friction(const std::string &name, const SubstrateChart &chart,
                                                    std::shared_ptr<const LineFrictionState> state,
                                                    const std::string &edge);

/** Density of the wetted area's line integral at a point x of the line with derivative dx along its parameter. */
double wetted_area_density(const SubstrateChart &chart, const Vector3<double> &x, const Vector3<double> &dx);

/**
 * The same for a line that slips over the material of a soft substrate: S_c is the area of the undeformed top, in the
 * plane z = const, between the material points of cell c and the axis. With f_c = Y where the line advances and -Y
 * where it recedes, the force that opposes its motion is Y per length of the line of material points.
 */
std::shared_ptr<const Potential> make_material_line_friction(const std::string &name,
                                                             std::shared_ptr<const LineFrictionState> state,
                                                             const std::string &edge);
/** (1/2)(X dY - Y dX) at a material point X of the line with derivative dX. */
double material_area_density(const Vector3<double> &X, const Vector3<double> &dX);
} // namespace pellicle
