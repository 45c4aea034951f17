// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
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
  std::vector<double> inputs(std::size_t(surface.tables.n_points) * 18);
  for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
  {
    Vector3<double> outwards;
    for (const unsigned int corner : mesh.patches[mesh.cell_patch[cell]])
      outwards += rounded.normals[corner];
    evaluate_field(surface.tables, &surface.cell_nodes[cell * surface.n_local()], surface.positions, 3, inputs.data());
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const double *const x = &inputs[std::size_t(q) * 18];
      const Vector3<double> a1(x[3], x[4], x[5]), a2(x[6], x[7], x[8]);
      if (!(dot(cross(a1, a2), outwards) > 0.))
        throw UserError(file + ": the surface folds over when it is rounded near (" + exact_text(x[0]) + ", " +
                        exact_text(x[1]) + ", " + exact_text(x[2]) +
                        "): the facets there are too coarse or too distorted. Refine or repair the mesh.");
    }
  }
}
} // namespace

SurfaceDiscretization from_file(const std::string &file, const double area, const unsigned int degree,
                                const unsigned int refinements)
{
  PolygonMesh mesh = read_msh(file);
  orient_closed_surface(mesh);
  const RoundedSurface rounded = round_polygons(mesh);
  const RefinedQuads quads     = refine_quads(rounded.vertices, rounded.quads, refinements, degree);
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
