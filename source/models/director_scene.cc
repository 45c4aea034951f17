// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/body_nodes.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/discretization/surface_quality.h>
#include <pellicle/models/director_defects.h>
#include <pellicle/models/director_scene.h>
#include <pellicle/models/director_start.h>
#include <pellicle/models/relaxation_system.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/models/surface_motion.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/director/director_fields.h>
#include <pellicle/potentials/director/spontaneous_curvature_effect.h>
#include <pellicle/potentials/dissipations/director_friction.h>

#include <cmath>
#include <numeric>

namespace pellicle
{
namespace
{
std::vector<std::size_t> all_nodes(const SurfaceDiscretization &surface)
{
  std::vector<std::size_t> nodes(surface.n_nodes);
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}
} // namespace

void CarrierParameters::bind(ParameterSection &section)
{
  std::vector<std::string> shapes{"vesicle"};
  shapes.insert(shapes.end(), inclusion_shape_names().begin(), inclusion_shape_names().end());
  section.choice("Shape", shape, shapes,
                 "The surface that carries the directors. vesicle: the start shape of section Vesicle, closed or open. "
                 "inclusion: a flat membrane around a disc, of section Inclusion. two inclusions: the same around two "
                 "of them, in space. inclusion on vesicle: a sphere of Vesicle/Area around an inclusion at its lowest "
                 "point.");
  section.choice("Motion", motion, {"free", "held"},
                 "free: the surface takes the shape of least energy. held: it stays as it starts, only the directors "
                 "are solved for.");
}

void DirectorFieldParameters::bind(ParameterSection &section)
{
  section.choice("Start", start, director_start_names(),
                 "Directors at the start. normal: the unit normals n. turned: n turned about the z axis by Angle. "
                 "towards z: tilted towards +z by Angle times the sine of the normal's polar angle. meridional, "
                 "azimuthal: in the surface, in the plane of n and z or at right angles to it. With "
                 "Director/Tilt modulus = inf always normal, but for the noise.");
  section.number("Angle", angle, Range::between(-3.2, 3.2), dimensions::none, "Angle in radians, see Start.");
  section.number("Noise", noise, Range::between(0., 0.5), dimensions::none,
                 "Random part of the directors at the start: uniform in [-f, f] in each component.");
  section.integer("Random seed", random_seed, 0, 2147483647, "Seed of the noise.");
  section.choice("At rim", at_rim, {"free", "held"},
                 "Directors at the rims of an open start shape: free to turn, or held as they start. At an inclusion, "
                 "and on the rim around it, they are held.");
}

void DirectorScene::add_own_sections(std::vector<ParameterSection> &all)
{
  add_section(all, "Surface", carrier);
  VesicleScene::add_own_sections(all);
  add_section(all, "Inclusion", inclusion);
  add_section(all, "Director field", field);
}

void DirectorScene::add_further_sections(std::vector<ParameterSection> &all)
{
  VesicleScene::add_further_sections(all);
  add_section(all, "Time", time);
}

void DirectorScene::check() const
{
  if (find<DirectorEffect>() == nullptr)
    throw UserError("The list Effects has no 'director': this application solves for directors. Add it, or use the "
                    "application 'vesicle'.");
  if (mesh.mirror_planes().any())
    throw UserError("Mesh/Symmetry = " + mesh.symmetry +
                    ": directors are computed on the whole surface or on a meridian. Set it to none or axial.");
  inclusion.check(carrier.shape, mesh.symmetry);
  if (has_inclusion() && std::isinf(find<DirectorEffect>()->parameters.tilt_modulus))
    throw UserError("Director/Tilt modulus = inf: directors that stay normal cannot be tilted at an inclusion. Take a "
                    "finite modulus, or Surface/Shape = vesicle.");
  check_domain();
  VesicleScene::check();
  check_time();
}

void DirectorScene::check_domain() const
{
  const DirectorParameters &law = find<DirectorEffect>()->parameters;
  const auto *domain            = find<LipidDomainEffect>();
  if (domain == nullptr && law.has_domain())
    throw UserError("Director/Domain tilt ratio = " + exact_text(law.domain_tilt) +
                    " and Domain bending ratio = " + exact_text(law.domain_bending) +
                    ": there is no domain. Add 'lipid domain' to Effects, or leave both at 1.");
  if (domain != nullptr && has_inclusion())
    throw UserError(
        "The effect 'lipid domain' starts around the north pole of a closed surface: it needs Surface/Shape "
        "= vesicle.");
  const LipidDomainParameters none;
  if (domain != nullptr && !has_effect("helfrich bending") &&
      (domain->parameters.bending_rigidity != none.bending_rigidity ||
       domain->parameters.spontaneous_curvature != none.spontaneous_curvature))
    throw UserError("Lipid domain/Bending rigidity and Spontaneous curvature are those of 'helfrich bending', which "
                    "Effects does not list: directors in the domain have Director/Domain tilt ratio and Domain bending "
                    "ratio.");
}

bool DirectorScene::splits_domain() const
{
  return VesicleScene::splits_domain() ||
         (has_effect("lipid domain") && find<DirectorEffect>()->parameters.has_shear_field());
}

void DirectorScene::check_time() const
{
  time.check();
  const bool has_friction = find<DirectorFrictionEffect>() != nullptr;
  if (motion() == nullptr && has_friction)
    throw UserError("The list Effects has 'director friction', but Time/End time is 0: an equilibrium knows no "
                    "friction. Give an end time, or drop the effect.");
  if (motion() == nullptr)
    return;
  if (!has_friction)
    throw UserError("Time/End time is positive, but the list Effects has no 'director friction': how fast directors "
                    "turn is not defined. Add it.");
  check_material_points(potentials(Scales{}), is_held());
  if (!load.parameter.empty() || !branch.parameter.empty() || !analyses.empty())
    throw UserError("A scene that moves in time (Time/End time > 0) can have neither Load/Parameter nor "
                    "Continuation/Parameter nor Analyses: these are for equilibria.");
  if (time.integrator == "ida" && std::isinf(find<DirectorEffect>()->parameters.tilt_modulus))
    refuse_index_2();
}

void DirectorScene::set_targets(const Scales &scales, SceneTargets &targets) const
{
  VesicleScene::set_targets(scales, targets);
  if (has_inclusion())
    targets.area = around_inclusions().area(vesicle.area) / scales.of(dimensions::area);
  targets.surface_is_held = is_held();
}

bool DirectorScene::is_fixed(const std::string &parameter) const
{
  for (const char *section : {"Surface/", "Inclusion/", "Director field/", "Time/"})
    if (parameter.rfind(section, 0) == 0)
      return true;
  return VesicleScene::is_fixed(parameter);
}

double DirectorScene::own_length() const
{
  return has_inclusion() && around_inclusions().is_flat() ? inclusion.radius : VesicleScene::own_length();
}

InclusionMembrane DirectorScene::around_inclusions() const
{
  const DirectorParameters &law = find<DirectorEffect>()->parameters;
  return {carrier.shape, inclusion, std::sqrt(law.bending_modulus / law.tilt_modulus)};
}

SurfaceDiscretization DirectorScene::start_mesh() const
{
  SurfaceDiscretization mesh = has_inclusion() ? around_inclusions().mesh(start_shape()) : VesicleScene::start_mesh();
  // Without tilt only normals are admissible; from far off multipliers at full steps do not lead back to them.
  const auto *effect     = find<DirectorEffect>();
  const bool is_normal   = effect != nullptr && std::isinf(effect->parameters.tilt_modulus);
  NodalVectors directors = start_directors(mesh, is_normal ? "normal" : field.start, field.angle);
  add_director_noise(mesh, field.noise, field.random_seed, directors);
  if (has_inclusion())
    around_inclusions().tilt(mesh, start_shape(), directors);
  mesh.start_values[std::string(director)] = std::move(directors);
  return mesh;
}

std::map<std::string, std::vector<Vector3<double>>>
DirectorScene::rim_conormals(const SurfaceDiscretization &start) const
{
  if (has_inclusion())
    return {};
  return VesicleScene::rim_conormals(start);
}

std::vector<SceneEdge> DirectorScene::edges() const
{
  if (has_inclusion())
  {
    std::vector<SceneEdge> rims;
    for (const std::string &name : around_inclusions().rims())
      rims.push_back({name, EdgeSupport::hinged});
    return rims;
  }
  return VesicleScene::edges();
}

NodalConditions DirectorScene::conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const
{
  NodalConditions conditions = VesicleScene::conditions(surface, targets);
  if (is_held())
    hold_nodes(conditions, "position", all_nodes(surface), surface.n_nodes);
  if (has_inclusion() || field.at_rim == "held")
    for (const EdgeLoop &loop : surface.edges)
      if (loop.is_rim)
        hold_nodes(conditions, std::string(director), loop.cell_nodes, surface.n_nodes);
  return conditions;
}

void DirectorScene::add_references(const SurfaceDiscretization &start, SceneTargets &targets) const
{
  targets.cell_sizes = std::make_shared<const std::vector<double>>(squared_node_distances(start));
  if (find<SpontaneousDirectorCurvatureEffect>() == nullptr)
    return;
  std::vector<DirectorPoint> points;
  const NodalVectors &directors = start.start_values.at(std::string(director));
  for_all_points(start.tables, start.cell_nodes, start.positions, 3,
                 [&](const WalkPoint &x) {
                   points.push_back({x[1], x[2], {}});
                 });
  std::size_t next = 0;
  for_all_points(start.tables, start.cell_nodes, directors, 1, [&](const WalkPoint &O) { points[next++].O = O[0]; });
  targets.director_start = std::make_shared<const std::vector<DirectorPoint>>(std::move(points));
}

SurfaceMeasures DirectorScene::measures(const Scales &scales) const
{
  return [of_vesicle = VesicleScene::measures(scales)](const SurfaceModel &model)
  {
    std::vector<NamedQuantity> list = of_vesicle(model);
    PotentialSet null;
    null.energies.push_back(null_lagrangian(model.scene_targets().director_law()));
    list.push_back({"null_lagrangian_energy", model.equilibrium().value_of(null), dimensions::energy});
    if (const auto defects = director_defects(model))
    {
      list.push_back({"defects", static_cast<double>(defects->size()), dimensions::none});
      const double charge = std::accumulate(defects->begin(), defects->end(), 0.,
                                            [](const double sum, const Defect &d) { return sum + d.charge; });
      list.push_back({"defect_charge", charge, dimensions::none});
    }
    return list;
  };
}
} // namespace pellicle
