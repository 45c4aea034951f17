// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/base/constants.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/surface_quality.h>
#include <pellicle/models/shell_scene.h>
#include <pellicle/models/shell_supports.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/potentials/shell/cosserat_shell.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
std::string quantity_at(const LoadPoint &point)
{
  std::string name = "displacement_at_" + point.edge;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::vector<ShellReference> references_of(const SurfaceDiscretization &surface)
{
  std::vector<std::array<Vector3<double>, 3>> places;
  for_all_points(surface.tables, surface.cell_nodes, surface.positions, 3,
                 [&](const WalkPoint &X) {
                   places.push_back({{X[0], X[1], X[2]}});
                 });
  std::vector<ShellReference> references;
  references.reserve(places.size());
  for_all_points(surface.tables, surface.cell_nodes, surface.start_values.at(shell_director), 3,
                 [&](const WalkPoint &D)
                 {
                   const auto &[X, X_1, X_2] = places[references.size()];
                   references.emplace_back(std::array<Vector3<double>, 3>{{X_1, X_2, D[0]}},
                                           std::array<Vector3<double>, 2>{{D[1], D[2]}}, X);
                 });
  return references;
}
} // namespace

void ShellParameters::bind(ParameterSection &section)
{
  section.choice(
      "Shape", shape, shell_shape_names(),
      "The undeformed shell. plate: a rectangle with hard simple supports. cylinder: about z, open ends. roof: "
      "part of a cylinder about y that rests on diaphragms at its curved ends. hemisphere: z > 0 with a hole "
      "around the pole. sphere: closed. Shapes with planes of symmetry are computed between these; energies, "
      "forces and areas are those of the whole.");
  section.number("Radius", radius, Range::positive(), dimensions::length, "Radius of all shapes but the plate.");
  section.number("Length", length, Range::positive(), dimensions::length,
                 "Length of a cylinder or a roof; side of a plate along x.");
  section.number("Width", width, Range::positive(), dimensions::length, "Side of a plate along y.");
  section.number("Angle", angle, {0., 90., true, true, false}, dimensions::none,
                 "In degrees: polar angle of the hole of a hemisphere; half the angle that a roof spans.");
  section.word("Load shape", load_shape,
               "Function of x and y of the undeformed shell, in the user's units, by which a dead load is multiplied, "
               "for example sin(pi*x)*sin(pi*y).");
}

void ShellScene::add_own_sections(std::vector<ParameterSection> &all)
{
  add_section(all, "Shell", shell);
}

void ShellScene::check() const
{
  if (mesh.symmetry != "none")
    throw UserError("Mesh/Symmetry = " + mesh.symmetry + ": shells are computed in space. Set it to none.");
  if (!mesh.file.empty())
    throw UserError("Mesh/File = " + mesh.file + ": shells make their own mesh (Shell/Shape). Remove it.");
  const std::vector<std::string> possible{"cosserat shell", "dead load", "point loads", "pressure"};
  for (const auto &effect : effects)
    if (std::find(possible.begin(), possible.end(), effect->name()) == possible.end())
      throw UserError("The list Effects has '" + effect->name() +
                      "' beside 'cosserat shell': a shell can have 'dead load', 'point loads' and 'pressure' only.");
  if (has_effect("pressure") && shell.shape != "sphere")
    throw UserError("The effect 'pressure' needs a volume, which Shell/Shape = " + shell.shape +
                    " does not enclose. Take the sphere, or a dead load.");
  if (shell.load_shape != "1" && !has_effect("dead load"))
    throw UserError("Shell/Load shape = " + shell.load_shape +
                    " has no effect in this scene: add 'dead load' to Effects, or set it to 1.");
  const ExpressionOfPlace readable(shell.load_shape);
  SurfaceScene::check();
}

bool ShellScene::is_fixed(const std::string &parameter) const
{
  return parameter.rfind("Shell/", 0) == 0 || SurfaceScene::is_fixed(parameter);
}

double ShellScene::own_length() const
{
  return shell.shape == "plate" ? shell.length : shell.radius;
}

ShellShape ShellScene::shape(const double unit) const
{
  ShellShape result;
  result.name       = shell.shape;
  result.radius     = shell.radius / unit;
  result.length     = shell.length / unit;
  result.width      = shell.width / unit;
  result.angle      = shell.angle * pi / 180.;
  result.degree     = static_cast<unsigned int>(mesh.degree);
  result.refinement = mesh.refinement();
  return result;
}

SurfaceDiscretization ShellScene::start_mesh() const
{
  const ShellShape wanted       = shape(1.);
  SurfaceDiscretization surface = shell_mesh(wanted);
  NodalVectors &directors       = surface.start_values[shell_director];
  directors.reserve(surface.positions.size());
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const Vector3<double> n = shell_normal(wanted, vector_at(surface.positions, I));
    directors.insert(directors.end(), {n[0], n[1], n[2]});
  }
  for (const LoadPoint &point : shell_load_points(wanted))
    surface.edges.push_back(point_loop(point.edge, nearest_node(surface, point.place), shell_load_copies(wanted)));
  return surface;
}

NodalConditions ShellScene::conditions(const SurfaceDiscretization &surface, const SceneTargets & /*targets*/) const
{
  return shell_supports(shape(own_length()), surface);
}

void ShellScene::set_targets(const Scales &scales, SceneTargets &targets) const
{
  ShellTargets of_shell;
  of_shell.load_points = shell_load_points(shape(scales.length));
  if (shell.load_shape != "1")
    of_shell.load_shape = std::make_shared<ExpressionOfPlace>(shell.load_shape, scales.length);
  targets.shell = of_shell;
}

void ShellScene::add_references(const SurfaceDiscretization &start, SceneTargets &targets) const
{
  targets.cell_sizes       = std::make_shared<const std::vector<double>>(squared_node_distances(start));
  targets.shell->reference = std::make_shared<const std::vector<ShellReference>>(references_of(start));
}

SurfaceMeasures ShellScene::measures(const Scales &scales) const
{
  return [points = shell_load_points(shape(scales.length))](const SurfaceModel &model)
  {
    std::vector<NamedQuantity> list;
    double largest = 0.;
    for (const LoadPoint &point : points)
    {
      const std::size_t node = nearest_node(model.mesh(), point.place);
      const double along = dot(point.direction, vector_at(model.equilibrium().state().fields[0], node) - point.place);
      list.push_back({quantity_at(point), along, dimensions::length});
      largest = std::max(largest, std::abs(along));
    }
    list.push_back({"load_point_displacement", largest, dimensions::length});
    return list;
  };
}

ShellScene make_shell_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                            const std::vector<std::string> &analyses)
{
  ShellScene scene;
  list_effects(scene, library, effects, analyses);
  return scene;
}
} // namespace pellicle
