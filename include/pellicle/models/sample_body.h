// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_problem.h>
#include <pellicle/models/surface_sample.h>

namespace pellicle
{
/**
 * A body and its fields at equidistant points of every cell, in units of `unit`. Of a body of revolution that is the
 * section y = 0, r >= 0.
 *
 * Fields: `displacement` and `material_position` of the points, and, per cell in its own polynomials of degree k - 1
 * (without continuity: derivatives of positions jump between cells), by projection from the quadrature points,
 *
 * - `volume_ratio` J;
 * - `cauchy_stress`, of all potentials on the body together: j sigma = sum_a dw/dx,a (x) x,a with their density w per
 *   unit of parametric volume and j = x,1 . (x,2 x x,3). In a section y is the direction around the axis;
 * - `von_mises_stress` and `mean_pressure`, -tr(sigma)/3;
 * - `elastic_energy_density`, w per volume of the reference.
 *
 * @param material_position  nodal places of the undeformed body, internal units.
 */
SurfaceSample sample_body(const SurfaceProblem &problem, const SurfaceDiscretization &discretization,
                          const BulkPart &body, const NodalVectors &material_position, const Scales &unit);
} // namespace pellicle
