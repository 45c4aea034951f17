// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/body_nodes.h>
#include <pellicle/base/constants.h>
#include <pellicle/base/exact_text.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/line_shift.h>
#include <pellicle/discretization/ridge_mesh.h>
#include <pellicle/models/material_line_pinning.h>
#include <pellicle/models/ridge_measures.h>
#include <pellicle/models/ridge_scene.h>
#include <pellicle/potentials/solids/moving_reference.h>
#include <pellicle/potentials/solids/solid_effect.h>
#include <pellicle/potentials/wetting/free_contact_line.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double degree = pi / 180.;

const BulkPart &substrate_of(const SurfaceDiscretization &mesh)
{
  return mesh.bulks.front();
}

/** One number for each node of the line; the nodes of its meridian plane follow. */
FieldConditions shift_of_material(const SurfaceDiscretization &mesh)
{
  const LineShift shift = line_shift(mesh);
  FieldConditions conditions;
  conditions.leader = shift.leader;
  conditions.only.resize(mesh.n_nodes);
  for (std::size_t I = 0; I < mesh.n_nodes; ++I)
  {
    const double w = shift.weight[I];
    if (w == 0.)
      continue;
    AdmissibleDirections along;
    along.count   = 1;
    along.columns = {
        {{{w * shift.direction[3 * I], w * shift.direction[3 * I + 1], w * shift.direction[3 * I + 2]}}, {}, {}}};
    conditions.only[I] = along;
  }
  return conditions;
}

/** Unit normal of a lateral face at one of its nodes. */
Vector3<double> side_normal(const SurfaceDiscretization &mesh, const std::size_t node, const std::string &shape,
                            const double half_width)
{
  const double x = mesh.positions[3 * node], y = mesh.positions[3 * node + 1];
  if (shape == "cylinder")
    return (1. / std::hypot(x, y)) * Vector3<double>(x, y, 0.);
  return std::abs(x) > half_width * (1. - 1e-9) ? Vector3<double>(std::copysign(1., x), 0., 0.)
                                                : Vector3<double>(0., std::copysign(1., y), 0.);
}
} // namespace

void RestingDropParameters::bind(ParameterSection &section)
{
  section.number("Volume", volume, Range::positive(), dimensions::volume,
                 "Volume V of the drop, target of the volume constraint.");
  section.number("Body force", body_force, Range::non_negative(), {1, -4},
                 "Weight rho g of the liquid per volume, of the effect gravity.");
  section.number("Inclination", inclination, Range::between(-180., 180.), dimensions::none,
                 "Angle a of the undeformed substrate with the horizontal in degrees: gravity pulls along (sin a, 0, "
                 "-cos a) in the substrate's frame.");
}

void ContactLineParameters::bind(ParameterSection &section)
{
  section.number("Radius", radius, Range::positive(), dimensions::length,
                 "Radius of the contact line on the undeformed substrate: where it is pinned, or starts.");
  section.choice("Motion", motion, {"pinned", "free"},
                 "pinned: the line keeps its material points. free: it moves over the material until the Eshelby force "
                 "on it vanishes, or is below the thresholds of 'free contact line'.");
  section.number("Cell size", cell_size, Range::positive(), dimensions::length,
                 "Size of the cells at the line; they grow geometrically away from it.");
}

void TensionParameters::bind(ParameterSection &section)
{
  section.number("Liquid gas", liquid_gas, Range::positive(), dimensions::tension, "Surface tension gamma_LG.");
  section.number("Solid liquid", solid_liquid, Range::non_negative(), dimensions::tension,
                 "Surface tension gamma_SL of the wetted top of the substrate, of the effect solid skins.");
  section.number("Solid gas", solid_gas, Range::non_negative(), dimensions::tension,
                 "Surface tension gamma_SG of its dry top.");
  section.number("Scale", scale, Range::non_negative(), dimensions::none,
                 "Factor on all three tensions, for section Load or Continuation.");
}

void SoftSubstrateParameters::bind(ParameterSection &section)
{
  section.choice("Shape", shape, {"cylinder", "block"}, "Circular cylinder about the z axis, or a square block.");
  section.number("Half width", half_width, Range::positive(), dimensions::length,
                 "Radius of the cylinder, or half the edge of the block. The contact line must be inside.");
  section.number("Thickness", thickness, Range::positive(), dimensions::length,
                 "Thickness of the undeformed substrate, from z = -Thickness to z = 0.");
  section.number("Young modulus", young, Range::positive(), dimensions::pressure,
                 "Young's modulus E of small strains.");
  section.number("Poisson ratio", poisson, {-1., 0.5, true, false, false}, dimensions::none,
                 "Poisson's ratio nu of small strains, in (-1, 1/2]; 1/2: incompressible.");
  section.choice("Lateral faces", lateral, {"free", "sliding", "clamped"},
                 "free: no traction. sliding: no normal (radial) displacement, free vertically. clamped: held.");
  section.choice("Bottom", bottom, {"clamped", "sliding"}, "clamped: held. sliding: held vertically only.");
  section.integer("Azimuthal cells", azimuthal_cells, 8, 512,
                  "Cells around the whole contact line in space, a multiple of 8.");
  section.choice("Part", part, {"half", "whole"},
                 "In space: half of the model, y >= 0, whose mirror image is the rest (the scene is symmetric), or the "
                 "whole, which may break the symmetry.");
}

void RidgeScene::add_own_sections(std::vector<ParameterSection> &all)
{
  add_section(all, "Droplet", droplet);
  add_section(all, "Contact line", line);
  add_section(all, "Tensions", tensions);
  add_section(all, "Substrate", substrate);
}

void RidgeScene::check() const
{
  if (mesh.symmetry == "axial mirror")
    throw UserError("Mesh/Symmetry = axial mirror: a drop on a substrate has no mirror plane z = 0. Take axial or "
                    "none.");
  if (mesh.mirror_planes().any())
    throw UserError("Mesh/Symmetry = " + mesh.symmetry +
                    ": half of a drop on a soft substrate is what Substrate/Part = half gives with Symmetry = none.");
  if (!mesh.file.empty())
    throw UserError("Mesh/File = " + mesh.file + ": drops on soft substrates make their own mesh. Remove it.");
  if (is_axial() && substrate.shape == "block")
    throw UserError("Substrate/Shape = block with Mesh/Symmetry = axial: a block is not axisymmetric. Set Symmetry to "
                    "none, or Shape to cylinder.");
  if (is_axial() && has_effect("gravity") && std::abs(std::sin(droplet.inclination * degree)) > 1e-14)
    throw UserError("Droplet/Inclination = " + exact_text(droplet.inclination) +
                    " with Mesh/Symmetry = axial: on an inclined substrate the drop is not axisymmetric. Set Symmetry "
                    "to none.");
  if (!free_motions().empty() && substrate.lateral == "free" && has_effect("gravity") && droplet.inclination != 0.)
    throw UserError("Droplet/Inclination = " + exact_text(droplet.inclination) +
                    " with Substrate/Bottom = sliding and Lateral faces = free: nothing holds the substrate on the "
                    "slope. Clamp the bottom, or let the lateral faces slide.");
  check_not_idle("Droplet/Body force", droplet.body_force, "gravity");
  check_not_idle("Droplet/Inclination", droplet.inclination, "gravity");
  check_not_idle("Tensions/Solid liquid", tensions.solid_liquid, "solid skins");
  check_not_idle("Tensions/Solid gas", tensions.solid_gas, "solid skins");
  for (const char *needed : {"solid", "liquid surface"})
    if (!has_effect(needed))
      throw UserError(std::string("The list Effects has no '") + needed +
                      "': a drop on a soft substrate needs it. Add it.");
  if (!has_effect("volume constraint"))
    throw UserError("The list Effects has no 'volume constraint': nothing keeps the drop from shrinking to a point. "
                    "Add it.");
  if (line_sticks() && !branch.parameter.empty())
    throw UserError("Continuation/Parameter = " + branch.parameter +
                    " with thresholds of 'free contact line' is not possible: what the line has dissipated does not "
                    "come back along a branch. Use section Load, or set both thresholds to 0.");
  start_mesh();
  SurfaceScene::check();
}

// Of a substrate in space that slides on its bottom; a mirror plane leaves the one along x.
std::vector<RigidMotion> RidgeScene::free_motions() const
{
  if (is_axial() || substrate.bottom == "clamped" || substrate.lateral == "clamped")
    return {};
  std::vector<RigidMotion> motions;
  const bool is_whole = substrate.part == "whole", is_free = substrate.lateral == "free";
  if (is_free)
    motions.push_back({{{1., 0., 0.}}, {}});
  if (is_free && is_whole)
    motions.push_back({{{0., 1., 0.}}, {}});
  if (is_whole && (is_free || substrate.shape == "cylinder"))
    motions.push_back({{}, {{0., 0., 1.}}});
  return motions;
}

bool RidgeScene::line_sticks() const
{
  const auto *effect = find<FreeContactLineEffect>();
  return line_is_free() && effect != nullptr &&
         (effect->parameters.advancing_threshold > 0. || effect->parameters.receding_threshold > 0.);
}

void RidgeScene::check_not_idle(const std::string &parameter, const double value, const std::string &effect) const
{
  if (value != 0. && !has_effect(effect))
    throw UserError(parameter + " = " + exact_text(value) + " has no effect in this scene: add '" + effect +
                    "' to Effects, or set it to 0.");
}

// Poisson's ratio decides whether cells have pressures of their own.
bool RidgeScene::is_fixed(const std::string &parameter) const
{
  for (const char *section :
       {"Contact line/", "Substrate/Shape", "Substrate/Half width", "Substrate/Thickness", "Substrate/Lateral faces",
        "Substrate/Bottom", "Substrate/Poisson ratio", "Substrate/Part", "Substrate/Azimuthal", "Free contact line/"})
    if (parameter.rfind(section, 0) == 0)
      return true;
  return SurfaceScene::is_fixed(parameter);
}

// Tensions act where stresses of the substrate or of the drop answer: the larger of both is the scene's energy.
double RidgeScene::own_energy(const double length) const
{
  return tensions.liquid_gas * length * length;
}

void RidgeScene::set_targets(const Scales &scales, SceneTargets &targets) const
{
  targets.volume           = droplet.volume / scales.of(dimensions::volume);
  const double per_tension = tensions.scale / scales.of(dimensions::tension);
  DropletTargets drop;
  drop.surface_tension       = tensions.liquid_gas * per_tension;
  const double a             = droplet.inclination * degree;
  drop.force_per_bond_number = 1. / scales.of({1, -4}) * Vector3<double>(std::sin(a), 0., -std::cos(a));
  drop.body_force            = droplet.body_force * drop.force_per_bond_number;
  drop.unit_of_place         = scales.length;
  drop.has_base_membrane     = true;
  drop.bounded_by            = {liquid_gas_region, solid_liquid_region};
  targets.droplet            = drop;

  RidgeTargets soft;
  soft.solid_liquid_tension = tensions.solid_liquid * per_tension;
  soft.solid_gas_tension    = tensions.solid_gas * per_tension;
  soft.young_modulus        = substrate.young / scales.of(dimensions::pressure);
  soft.poisson_ratio        = substrate.poisson;
  soft.load                 = tensions.scale;
  soft.line_is_free         = line_is_free();
  targets.substrate         = soft;
}

void RidgeScene::add_references(const SurfaceDiscretization &start, SceneTargets &targets) const
{
  targets.substrate->bulk_reference =
      std::make_shared<const std::vector<ReferenceBasis>>(reference_bases(substrate_of(start), start.positions));
  targets.substrate->skin_reference = targets.reference;
}

std::vector<LoadStage> RidgeScene::load_stages() const
{
  std::vector<LoadStage> stages{{"tensions", "Tensions/Scale"}};
  if (has_effect("gravity"))
  {
    stages.push_back({"gravity", "Droplet/Body force"});
    if (droplet.inclination != 0.)
      stages.push_back({"inclination", "Droplet/Inclination"});
  }
  return stages;
}

std::vector<SceneEdge> RidgeScene::edges() const
{
  return {{contact_line, EdgeSupport::inner}};
}

SurfaceDiscretization RidgeScene::start_mesh() const
{
  const double per_refinement = std::pow(2., 2 - mesh.refinements);
  RidgeShape shape;
  shape.ring_radius = line.radius;
  shape.cap_volume  = droplet.volume;
  shape.half_width  = substrate.half_width;
  shape.thickness   = substrate.thickness;
  shape.cell_size   = line.cell_size;
  shape.growth      = 1. + 0.5 * per_refinement;
  // The skin pulls free sides in at their upper edge, which is as singular as a pinned line and folds where cells are
  // small. It is no part of the question and keeps coarse cells.
  const double finest_at_edge = substrate.lateral == "free" ? 0.25 : 0.;
  shape.coarsest              = std::min(0.5, std::max(finest_at_edge, 0.25 * per_refinement));
  shape.degree                = static_cast<unsigned int>(mesh.degree);
  RidgePlanShape plan;
  plan.outline  = substrate.shape == "block" ? RidgePlanShape::Outline::block : RidgePlanShape::Outline::cylinder;
  plan.n_around = static_cast<unsigned int>(substrate.azimuthal_cells);
  plan.half     = substrate.part == "half";
  SurfaceDiscretization made = is_axial() ? axial_ridge(shape) : ridge_in_space(shape, plan);
  if (SolidEffect::uses_pressure(substrate.poisson))
    add_pressure_nodes(made, 0);
  if (substrate.bottom == "sliding")
    keep_on_plane(made, substrate_of(made).faces.at("bottom"), {0., 0., 1.});
  if (substrate.lateral == "sliding")
    for (const std::size_t node : substrate_of(made).faces.at("side"))
      keep_on_plane(made, node, side_normal(made, node, substrate.shape, substrate.half_width));
  made.rigid_motions = free_motions();
  return made;
}

NodalConditions RidgeScene::conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const
{
  NodalConditions conditions = SurfaceScene::conditions(surface, targets);
  const auto &faces          = substrate_of(surface).faces;
  if (substrate.bottom == "clamped")
    hold_nodes(conditions, "position", faces.at("bottom"), surface.n_nodes);
  if (substrate.lateral == "clamped")
    hold_nodes(conditions, "position", faces.at("side"), surface.n_nodes);
  if (line_is_free())
    conditions[material_position] = shift_of_material(surface);
  return conditions;
}

std::vector<std::unique_ptr<ActiveSet>> RidgeScene::active_sets(const SurfaceDiscretization &surface,
                                                                const SceneTargets &targets) const
{
  std::vector<std::unique_ptr<ActiveSet>> list;
  if (line_sticks())
    list.push_back(std::make_unique<MaterialLinePinning>(surface, targets));
  return list;
}

SurfaceMeasures RidgeScene::measures(const Scales & /*scales*/) const
{
  return measure_ridge;
}

// Where the surface has a corner, the solution is singular, and no degree helps. Meshes grow by a factor that Mesh/
// Refinements sets, so that a level has nothing in common with the one before.
LevelRange RidgeScene::level_range() const
{
  LevelRange range;
  range.first = {static_cast<unsigned int>(mesh.degree), static_cast<unsigned int>(std::min(mesh.refinements, 1))};
  range.highest_degree   = range.first.degree;
  range.most_refinements = 8;
  range.dimension        = is_axial() ? 2 : 3;
  return range;
}

// The scene's own cells at the line belong to its own refinements.
std::vector<std::pair<std::string, double>> RidgeScene::level_settings(const LevelMesh &level) const
{
  const double finer = std::ldexp(1., static_cast<int>(level.refinements) - mesh.refinements);
  std::vector<std::pair<std::string, double>> settings = SurfaceScene::level_settings(level);
  settings.emplace_back("Contact line/Cell size", line.cell_size / finer);
  if (!is_axial())
    settings.emplace_back("Substrate/Azimuthal cells",
                          8. * std::max(1., std::round(substrate.azimuthal_cells * finer / 8.)));
  return settings;
}

RidgeScene make_ridge_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                            const std::vector<std::string> &analyses)
{
  RidgeScene scene;
  list_effects(scene, library, effects, analyses);
  return scene;
}
} // namespace pellicle
