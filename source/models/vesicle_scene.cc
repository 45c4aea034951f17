// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/near_match.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/split_line.h>
#include <pellicle/models/neck.h>
#include <pellicle/models/rim_conormals.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/models/tether_measures.h>
#include <pellicle/models/vesicle_scene.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/tether.h>
#include <pellicle/potentials/edges/gaussian_curvature.h>
#include <pellicle/potentials/energies/helfrich_bending.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pellicle
{
namespace
{
constexpr const char *domain_boundary = "domain boundary"; // around the region of the effect "lipid domain"

// A third of the scale on which the membrane bends at the tip, on the mesh of two refinements; or what equal cells
// have.
double smallest_tether_cell(const TetherParameters &tether, const StartShape &shape)
{
  const double equal = (tether.ring_radius - tether.tip_radius) / (shape.radial_cells << shape.refinements);
  return std::min(equal, tether.tip_radius * 4. / (3. * (1u << shape.refinements)));
}
} // namespace

void VesicleParameters::bind(ParameterSection &section)
{
  section.number("Area", area, Range::positive(), dimensions::area,
                 "Area A of the membrane; the start shape is scaled to it. It sets the unit of length.");
  section.number("Reduced volume", reduced_volume, {0., 1., true, false, false}, dimensions::none,
                 "Reduced volume v = 3 V/(4 pi (A/4 pi)^1.5) in (0, 1]: makes the start shapes prolate, oblate and "
                 "stomatocyte, and is the target of the volume constraint.");
  std::vector<std::string> shapes = start_shape_names();
  shapes.insert(shapes.end(), {"cap", "disc", "tube"});
  section.choice(
      "Start shape", start_shape, shapes,
      "Shape at the start, scaled to Area: spheroids and stomatocyte of the given reduced volume, ellipsoid "
      "(Semi axes), biconcave, torus (Torus ratio), file (Mesh/File); open ones: cap (Cap angle), flat disc, "
      "tube (Tube ratio). The effect tether makes a shape of its own.");
  section.numbers("Semi axes", semi_axes, Range::positive(), dimensions::none,
                  "Ratio of the three semi axes of the start shape `ellipsoid`.");
  section.number("Torus ratio", torus_ratio, {1., 1e6, true, false, false}, dimensions::none,
                 "R/r of the start shape `torus`.");
  section.number(
      "Cap angle", cap_angle, {0., 180., true, true, false}, dimensions::none,
      "Angle from the pole to the rim of the start shape `cap`, seen from the centre of its sphere, in degrees.");
  section.number("Tube ratio", tube_ratio, {1e-3, 1e3, true, true, false}, dimensions::none,
                 "Length over radius of the start shape `tube`, an open cylinder about the z axis.");
  section.choice(
      "Rim", rim, {"free", "hinged", "clamped"},
      "What holds the rims of an open start shape: nothing; their place; their place and the tangent plane of "
      "the start shape.");
  section.choice("Reference shape", reference_shape,
                 {"start shape", "sphere", "prolate", "oblate", "stomatocyte", "ellipsoid", "biconcave"},
                 "Shape at which elastic skins are free of stress: the start shape, or another one. Material points of "
                 "both belong together by the sphere that they are maps of.");
  section.number("Reference area", reference_area, Range::positive(), dimensions::area,
                 "Area of the reference shape, if it is not the start shape.");
  section.number("Reference reduced volume", reference_reduced_volume, {0., 1., true, false, false}, dimensions::none,
                 "Reduced volume of the reference shape, where that makes it (prolate, oblate, stomatocyte).");
  section.number("Node noise", node_noise, Range::between(0., 0.5), dimensions::none,
                 "Random displacement of the nodes of the start shape, uniform in [-f, f] times the node spacing in "
                 "each component.");
  section.integer("Random seed", random_seed, 0, 2147483647, "Seed of the node noise.");
}

void PhaseDiagramParameters::bind(ParameterSection &section)
{
  section.numbers("Reduced volumes", reduced_volumes, {0., 1., true, true, false}, dimensions::none,
                  "Reduced volumes at which the analysis `phase diagram` computes every branch that exists there.");
  section.word("Branches", branches,
               "Branches of the analysis `phase diagram`, named by the start shapes they begin with: prolate, oblate, "
               "stomatocyte.");
  section.integer("Fold points", fold_points, 0, 10000,
                  "Points along the arc by which a branch is followed where it ends before the last reduced volume: "
                  "through the fold and some way back.");
}

std::vector<std::string> PhaseDiagramParameters::branch_names() const
{
  std::vector<std::string> names;
  std::istringstream list(branches);
  for (std::string name; std::getline(list, name, ',');)
  {
    const auto first = name.find_first_not_of(" \t"), last = name.find_last_not_of(" \t");
    names.push_back(first == std::string::npos ? "" : name.substr(first, last - first + 1));
  }
  return names;
}

void PhaseDiagramParameters::check() const
{
  const std::vector<std::string> known{"prolate", "oblate", "stomatocyte"};
  for (const std::string &name : branch_names())
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UserError("Phase diagram/Branches: '" + name + "' is no branch." + suggestion(name, known));
  if (reduced_volumes.empty())
    throw UserError("Phase diagram/Reduced volumes is empty: give at least one number between 0 and 1.");
}

void VesicleScene::add_own_sections(std::vector<ParameterSection> &all)
{
  add_section(all, "Vesicle", vesicle);
}

void VesicleScene::add_further_sections(std::vector<ParameterSection> &all)
{
  add_section(all, "Phase diagram", phase_diagram);
}

void VesicleScene::check() const
{
  if (has_analysis("phase diagram"))
  {
    phase_diagram.check();
    for (const char *needed : {"helfrich bending", "area constraint", "volume constraint"})
      if (!has_effect(needed))
        throw UserError(std::string("The analysis 'phase diagram' varies the reduced volume of a vesicle: add '") +
                        needed + "' to Effects.");
  }
  const std::vector<SceneEdge> rims = edges();
  const auto is_free                = [](const SceneEdge &edge) { return edge.support == EdgeSupport::free; };
  if (std::any_of(rims.begin(), rims.end(), is_free) && has_effect("pressure"))
    throw UserError(
        "The effect 'pressure' needs a volume, which a surface with a free rim does not have: set Vesicle/Rim "
        "to hinged or clamped.");
  if (vesicle.reference_shape != "start shape" &&
      (!edges().empty() || vesicle.start_shape == "torus" || vesicle.start_shape == "file"))
    throw UserError("Vesicle/Reference shape = " + vesicle.reference_shape +
                    " and Vesicle/Start shape = " + vesicle.start_shape +
                    " have no material points in common: take a closed start shape without domain.");
  if (vesicle.semi_axes.size() != 3)
    throw UserError("Section Vesicle: 'Semi axes' has " + std::to_string(vesicle.semi_axes.size()) +
                    " numbers, three are needed, for example 1, 1, 1.2.");
  if (vesicle.start_shape == "file" && mesh.file.empty())
    throw UserError("Vesicle/Start shape is 'file', but Mesh/File names no file.");
  if (vesicle.start_shape != "file" && !mesh.file.empty())
    throw UserError("Mesh/File is '" + mesh.file + "', but Vesicle/Start shape is '" + vesicle.start_shape +
                    "': set it to 'file', or remove Mesh/File.");
  check_part();
  if (!edges().empty() && has_effect("volume constraint") && !has_effect("lipid domain"))
    throw UserError("The effect 'volume constraint' needs a closed surface, but the start shape is open. Prescribe a "
                    "pressure instead, or take a closed start shape.");
  if (has_effect("area constraint") && has_effect("volume constraint") && vesicle.reduced_volume >= 1.)
    throw UserError("Vesicle/Reduced volume = 1 with both area and volume constraint: only the sphere has it, and "
                    "there the two constraints are not "
                    "independent. Use a value below 1, or drop one of the two constraints.");
  SurfaceScene::check();
}

void VesicleScene::check_part() const
{
  const MirrorPlanes planes = mesh.mirror_planes();
  if (!planes.any())
    return;
  const std::string choice = "Mesh/Symmetry = " + mesh.symmetry;
  if (!edges().empty() || vesicle.start_shape == "torus" || vesicle.start_shape == "file")
    throw UserError(choice + " is for closed start shapes without domain or tether: prolate, oblate, ellipsoid, "
                             "biconcave, stomatocyte. Set it to none.");
  if (planes.normal_to[2] && vesicle.start_shape == "stomatocyte")
    throw UserError(choice + ": a stomatocyte is not symmetric at z = 0. Set it to quarter.");
  if (vesicle.node_noise != 0.)
    throw UserError("Vesicle/Node noise = " + exact_text(vesicle.node_noise) + " with " + choice +
                    ": noise has no symmetry. Set one of the two to none (0).");
}

bool VesicleScene::is_fixed(const std::string &parameter) const
{
  return parameter == "Vesicle/Area" || SurfaceScene::is_fixed(parameter);
}

double VesicleScene::own_length() const
{
  const auto *tether  = find<TetherEffect>();
  const auto *bending = find<HelfrichBendingEffect>();
  if (tether != nullptr && bending != nullptr)
    return std::sqrt(bending->parameters.bending_rigidity / (2. * tether->parameters.tension));
  return std::sqrt(vesicle.area / (4. * pi));
}

void VesicleScene::set_targets(const Scales &scales, SceneTargets &targets) const
{
  targets.area             = vesicle.area / scales.of(dimensions::area);
  targets.volume           = target_volume() / scales.of(dimensions::volume);
  targets.volume_of_sphere = targets.volume / vesicle.reduced_volume;
}

double VesicleScene::target_volume() const
{
  return vesicle.reduced_volume * 4. * pi / 3. * std::pow(vesicle.area / (4. * pi), 1.5);
}

StartShape VesicleScene::start_shape() const
{
  StartShape shape;
  shape.name           = vesicle.start_shape;
  shape.area           = vesicle.area;
  shape.reduced_volume = vesicle.reduced_volume;
  shape.semi_axes      = {{vesicle.semi_axes[0], vesicle.semi_axes[1], vesicle.semi_axes[2]}};
  shape.torus_ratio    = vesicle.torus_ratio;
  shape.cap_angle      = vesicle.cap_angle * pi / 180.;
  shape.tube_ratio     = vesicle.tube_ratio;
  shape.file           = mesh.file;
  shape.degree         = static_cast<unsigned int>(mesh.degree);
  shape.refinements    = static_cast<unsigned int>(mesh.refinements);
  shape.cut            = mesh.cut;
  shape.axial          = mesh.is_axial();
  shape.mirror         = mesh.symmetry == "axial mirror";
  if (const auto *domain = find<LipidDomainEffect>())
    shape.region_fraction = domain->parameters.area_fraction;
  if (const auto *tether = find<TetherEffect>())
  {
    shape.name          = "annulus";
    shape.inner_radius  = tether->parameters.tip_radius;
    shape.outer_radius  = tether->parameters.ring_radius;
    shape.smallest_cell = smallest_tether_cell(tether->parameters, shape);
  }
  return shape;
}

std::optional<StartShape> VesicleScene::reference_shape() const
{
  if (vesicle.reference_shape == "start shape")
    return std::nullopt;
  StartShape shape     = start_shape();
  shape.name           = vesicle.reference_shape;
  shape.area           = vesicle.reference_area;
  shape.reduced_volume = vesicle.reference_reduced_volume;
  if (vesicle.reference_shape == "sphere")
  {
    shape.name      = "ellipsoid";
    shape.semi_axes = {{1., 1., 1.}};
  }
  return shape;
}

bool VesicleScene::splits_domain() const
{
  const auto *gaussian = find<GaussianCurvatureEffect>();
  return has_effect("lipid domain") && gaussian != nullptr && gaussian->parameters.domain_difference != 0.;
}

std::vector<SceneEdge> VesicleScene::edges() const
{
  const EdgeSupport rim = vesicle.rim == "free"     ? EdgeSupport::free
                          : vesicle.rim == "hinged" ? EdgeSupport::hinged
                                                    : EdgeSupport::clamped;
  if (has_effect("tether"))
    return {{"tip", EdgeSupport::clamped}, {"ring", EdgeSupport::clamped}};
  if (has_effect("lipid domain"))
  {
    std::vector<SceneEdge> line{{domain_boundary, EdgeSupport::inner}};
    if (splits_domain())
      line.push_back({far_side(domain_boundary), EdgeSupport::far_side});
    return line;
  }
  if (vesicle.start_shape == "cap" || vesicle.start_shape == "disc")
    return {{"rim", rim}};
  if (vesicle.start_shape == "tube")
    return {{"upper rim", rim}, {"lower rim", rim}};
  return {};
}

SurfaceDiscretization VesicleScene::start_mesh() const
{
  return symmetric_part(make_start_shape(start_shape()), mesh.mirror_planes());
}

std::optional<NodalVectors> VesicleScene::reference_positions() const
{
  if (const std::optional<StartShape> shape = reference_shape())
    return symmetric_part(make_start_shape(*shape), mesh.mirror_planes()).positions;
  return std::nullopt;
}

std::string VesicleScene::split_line() const
{
  return splits_domain() ? domain_boundary : "";
}

std::map<std::string, std::vector<Vector3<double>>>
VesicleScene::rim_conormals(const SurfaceDiscretization &start) const
{
  std::map<std::string, std::vector<Vector3<double>>> all;
  for (const EdgeLoop &loop : start.edges)
    if (loop.is_rim)
      all[loop.name] = start_conormals(start, loop, start_shape());
  return all;
}

SurfaceMeasures VesicleScene::measures(const Scales & /*scales*/) const
{
  return [](const SurfaceModel &model)
  {
    const SurfaceDiscretization &surface = model.mesh();
    const NodalVectors positions         = model.positions();
    std::vector<NamedQuantity> list;
    if (const std::optional<double> neck = neck_radius(surface, positions))
      list.push_back({"neck_radius", *neck, dimensions::length});
    for (const EdgeLoop &loop : surface.edges)
      if (!loop.is_rim)
        list.push_back({"domain_boundary_length", loop_length(loop, positions), dimensions::length});
    for (const auto &[name, length] : tether_measures(surface, positions))
      list.push_back({name, length, dimensions::length});
    return list;
  };
}

std::string VesicleScene::headline_quantity() const
{
  return has_effect("helfrich bending") ? "bending_energy" : "total_energy";
}

// A file brings its own cells, which are many.
LevelRange VesicleScene::level_range() const
{
  LevelRange range = SurfaceScene::level_range();
  if (!mesh.file.empty())
    range.first.refinements = 0;
  return range;
}

VesicleScene make_vesicle_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                                const std::vector<std::string> &analyses)
{
  VesicleScene scene;
  list_effects(scene, library, effects, analyses);
  return scene;
}
} // namespace pellicle
