// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/polygon_mesh.h>
#include <pellicle/discretization/rounding.h>
#include <pellicle/discretization/surface_quality.h>

#include <cmath>

namespace pellicle
{
namespace
{
/** Between strongly turning normals a patch may overlap itself: then its own normal turns against those of its corners.
 */
void check_folds(const RefinedQuads &mesh, const RoundedSurface &rounded, const SurfaceDiscretization &surface,
                 const std::string &file)
{
  const auto check_cell = [&](const WalkCell &cell)
  {
    Vector3<double> outwards;
    for (const unsigned int corner : mesh.patches[mesh.cell_places[cell.number].patch])
      outwards += rounded.normals[corner];
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const Vector3<double> x = cell[q][0];
      if (!(dot(cross(cell[q][1], cell[q][2]), outwards) > 0.))
        throw UserError(file + ": the surface folds over when it is rounded near (" + exact_text(x[0]) + ", " +
                        exact_text(x[1]) + ", " + exact_text(x[2]) +
                        "): the facets there are too coarse or too distorted. Refine or repair the mesh.");
    }
  };
  for_all_cells(surface.tables, surface.cell_nodes, surface.positions, 3, check_cell);
}
} // namespace

SurfaceDiscretization from_file(const std::string &file, const double area, const unsigned int degree,
                                const Refinement &refinement)
{
  PolygonMesh mesh = read_msh(file);
  orient_closed_surface(mesh);
  const RoundedSurface rounded = round_polygons(mesh);
  const RefinedQuads quads     = refine_quads(rounded.vertices, rounded.quads, refinement, degree);
  const auto point             = [&](const PatchPoint &site)
  { return rounded_point(rounded, quads.patches[site.patch], site.xi, site.eta); };

  SurfaceDiscretization result = place_nodes(quads, degree, point);
  check_folds(quads, rounded, result, file);
  const double factor = std::sqrt(area / surface_quality(result, result.positions).area);
  for (double &coordinate : result.positions)
    coordinate *= factor;
  return result;
}
} // namespace pellicle
