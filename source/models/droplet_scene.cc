// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/models/droplet_measures.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/droplet_start.h>
#include <pellicle/models/free_motions.h>
#include <pellicle/models/line_pinning.h>
#include <pellicle/models/nodal_contact.h>
#include <pellicle/models/sample_substrate.h>
#include <pellicle/potentials/wetting/line_pinning.h>

#include <cmath>

namespace pellicle
{
namespace
{
constexpr double degree = pi / 180.;

/** Throws UserError, naming the parameter, if its text is no function of x and y. */
ExpressionOfPlace function_of_place(const std::string &parameter, const std::string &text)
{
  try
  {
    return ExpressionOfPlace(text);
  }
  catch (const UserError &error)
  {
    throw UserError(parameter + ": " + error.what());
  }
}

/** Throws UserError unless the samples of f up to a distance from the origin are contact angles of caps. */
void check_is_angle(const std::string &parameter, const FunctionOfPlace &f, const double reach)
{
  for (const double r : {0., 0.3, 0.7, 1.})
    for (int i = 0; i < 8; ++i)
    {
      const double x = r * reach * std::cos(0.25 * pi * i), y = r * reach * std::sin(0.25 * pi * i);
      const double angle = f.at(x, y).value;
      if (!(angle > 0. && angle < 180.))
        throw UserError(parameter + " = " + f.text() + " is " + exact_text(angle) + " at x = " + exact_text(x) +
                        ", y = " + exact_text(y) + ". Allowed where the drop may be: degrees in (0, 180).");
    }
}

/** Throws UserError unless f(x, y) is a function of the distance to the z axis alone, as far as samples tell. */
void check_axisymmetric(const std::string &parameter, const FunctionOfPlace &f, const double reach)
{
  constexpr double tolerance = 1e-9;
  double largest             = 0.;
  for (const double r : {0.1, 0.37, 0.71, 1., 1.3})
    for (const double angle : {0.4, 1.1, 2.3, 3.1, 4.4, 5.6})
    {
      const double x = r * reach, here = f.at(x * std::cos(angle), x * std::sin(angle)).value,
                   there = f.at(x, 0.).value;
      largest            = std::max(largest, std::abs(there));
      if (std::abs(here - there) > tolerance * (largest + reach))
        throw UserError(parameter + " = " + f.text() + " differs around the z axis (" + exact_text(there) +
                        " at x = " + exact_text(x) + ", y = 0, and " + exact_text(here) + " " +
                        exact_text(angle / degree) + " degrees further): set Mesh/Symmetry = none.");
    }
}
} // namespace

void DropletParameters::bind(ParameterSection &section)
{
  section.number("Volume", volume, Range::positive(), dimensions::volume,
                 "Volume V of the drop, target of the volume constraint; it makes the start shape and, with R_eq = "
                 "(3V/4 pi)^(1/3), the unit of length.");
  section.number("Contact angle", contact_angle, {0., 180., true, false, false}, dimensions::none,
                 "Contact angle theta through the liquid in degrees, in (0, 180]: of the effect wetting, and of the "
                 "start shape.");
  section.word("Contact angle field", angle_field,
               "Contact angle in degrees as a function of the place x, y, such as 90 + 20*tanh(x/0.1), for a patterned "
               "substrate. Empty: Contact angle everywhere.");
  section.number("Surface tension", surface_tension, Range::positive(), dimensions::tension,
                 "Surface tension gamma of the liquid-gas surface.");
  section.number("Bond number", bond_number, Range::any(), dimensions::none,
                 "rho g R_eq^2/gamma of the effect gravity, R_eq = (3V/4 pi)^(1/3). Negative: a hanging drop.");
  section.number("Inclination", inclination, Range::between(-180., 180.), dimensions::none,
                 "Angle a of the substrate with the horizontal in degrees: gravity pulls along (sin a, 0, -cos a) in "
                 "the substrate's frame.");
  section.choice(
      "Base", base, {"eliminated", "membrane"},
      "eliminated: the surface is the liquid-gas surface alone, the wetted base enters by integrals along the "
      "contact line. membrane: the whole surface of the drop, with the effect contact; needed for a contact "
      "angle of 180 degrees, where there is no line, and for elastic skins.");
  section.number("Reference volume", reference_volume, Range::non_negative(), dimensions::volume,
                 "Volume of the sphere at which elastic skins are free of stress. 0: Volume.");
}

void DropletScene::add_own_sections(std::vector<ParameterSection> &all)
{
  add_section(all, "Droplet", droplet);
  add_section(all, "Substrate", substrate);
}

void DropletScene::check() const
{
  const bool axial = mesh.symmetry == "axial";
  if (mesh.symmetry == "axial mirror")
    throw UserError(
        "Mesh/Symmetry = axial mirror: a drop on a substrate has no mirror plane z = 0. Take axial or none.");
  check_part();
  if (!mesh.file.empty())
    throw UserError("Mesh/File = " + mesh.file + ": drops make their own mesh. Remove it.");
  if (droplet.contact_angle == 180. && is_cap_only())
    throw UserError("Droplet/Contact angle = 180 is not possible with the surface of the cap alone: the contact line "
                    "shrinks to a point. It needs the base-membrane formulation: set Droplet/Base = membrane and list "
                    "'contact' instead of 'wetting' in Effects.");
  if (is_cap_only() && has_effect("contact"))
    throw UserError("The effect 'contact' needs the whole surface of the drop: set Droplet/Base = membrane.");
  if (!is_cap_only() && !has_effect("contact"))
    throw UserError(
        "Droplet/Base = membrane needs the effect 'contact': nothing else holds the base on the substrate.");
  if (!is_cap_only() && !has_line() && has_effect("wetting"))
    throw UserError("Droplet/Contact angle = " + exact_text(droplet.contact_angle) +
                    " with Droplet/Base = membrane: there is no contact line. Remove 'wetting' from Effects.");
  if (has_line() && !is_cap_only() && has_two_plates())
    throw UserError("Droplet/Base = membrane between two plates is for a contact angle of 180 degrees only; for " +
                    exact_text(droplet.contact_angle) + " set Droplet/Base = eliminated.");
  if (has_two_plates() && substrate.shape != "plane")
    throw UserError("Substrate/Plate distance = " + exact_text(substrate.plate_distance) +
                    " needs Substrate/Shape = plane below it, not " + substrate.shape + ".");
  if (!is_cap_only() && substrate.shape != "plane")
    throw UserError("Droplet/Base = membrane starts on a plane: set Substrate/Shape = plane.");
  const bool has_skin = has_effect("neo-hookean skin") || has_effect("incompressible rubber skin");
  if (!has_effect("liquid surface") && !has_skin)
    throw UserError("The list Effects has neither 'liquid surface' nor an elastic skin: nothing holds the liquid "
                    "together.");
  if (has_line() && !has_effect("wetting") && !has_effect("line pinning"))
    throw UserError(
        "The list Effects has no 'wetting': nothing makes the drop meet the substrate at Droplet/Contact angle "
        "= " +
        exact_text(droplet.contact_angle) + " (without it the angle would be 90).");
  if (!has_effect("volume constraint") && !has_effect("pressure"))
    throw UserError("The list Effects has neither 'volume constraint' nor 'pressure': nothing keeps the drop from "
                    "shrinking to a point.");
  if (has_skin && (is_cap_only() || has_line()))
    throw UserError("Elastic skins need a closed surface without contact line: set Droplet/Base = membrane and "
                    "Droplet/Contact angle = 180.");
  if (!has_effect("gravity") && droplet.bond_number != 0.)
    throw UserError("Droplet/Bond number = " + exact_text(droplet.bond_number) +
                    " has no effect in this scene: add 'gravity' to Effects.");
  if (axial && has_effect("gravity") && !is_level())
    throw UserError(
        "Droplet/Inclination = " + exact_text(droplet.inclination) +
        " with Mesh/Symmetry = axial: on an inclined substrate the drop is not axisymmetric. Set Symmetry to "
        "none.");
  if (!droplet.angle_field.empty())
  {
    const ExpressionOfPlace field = function_of_place("Droplet/Contact angle field", droplet.angle_field);
    check_is_angle("Droplet/Contact angle field", field, own_length());
    if (axial)
      check_axisymmetric("Droplet/Contact angle field", field, own_length());
  }
  if (substrate.shape == "height field")
  {
    const ExpressionOfPlace height = function_of_place("Substrate/Height", substrate.height);
    if (axial)
      check_axisymmetric("Substrate/Height", height, own_length());
  }
  check_line_pinning();
  SurfaceScene::check();
}

// Gravity along x leaves the plane y = 0.
void DropletScene::check_part() const
{
  const MirrorPlanes planes = mesh.mirror_planes();
  if (!planes.any())
    return;
  const std::string choice = "Mesh/Symmetry = " + mesh.symmetry;
  if (planes.normal_to[2])
    throw UserError(choice + ": a drop on a substrate has no mirror plane z = 0. Take quarter, half or none.");
  if (planes.normal_to[0] && is_pulled_along())
    throw UserError("Droplet/Inclination = " + exact_text(droplet.inclination) + " with " + choice +
                    ": a drop that is pulled along x is symmetric at y = 0 only. Set Symmetry to half.");
  if (!droplet.angle_field.empty() || substrate.shape == "height field")
    throw UserError(choice + " with a contact angle or a height that depends on the place is not possible: set it to "
                             "none.");
}

void DropletScene::check_line_pinning() const
{
  const auto *pinning = find<LinePinningEffect>();
  if (pinning == nullptr)
  {
    if (is_pulled_along() && substrate.shape == "plane" && droplet.angle_field.empty())
      throw UserError("Droplet/Inclination = " + exact_text(droplet.inclination) +
                      " with Droplet/Bond number = " + exact_text(droplet.bond_number) +
                      ": nothing holds the drop on the inclined plane, it has no equilibrium. Add 'line pinning' to "
                      "Effects, give a Droplet/Contact angle field that holds it, or set Inclination to 0.");
    return;
  }
  pinning->check();
  if (!has_effect("wetting"))
    throw UserError("The list Effects has 'line pinning' without 'wetting', whose contact angle lies between the "
                    "advancing and the receding one: add 'wetting'.");
  if (!is_cap_only())
    throw UserError("Droplet/Base = membrane with 'line pinning' is not possible: set Base to eliminated.");
  if (!droplet.angle_field.empty())
    throw UserError("Droplet/Contact angle field = " + droplet.angle_field +
                    " with 'line pinning' is not possible: advancing and receding angles are the same everywhere. "
                    "Remove one of the two.");
  if (!branch.parameter.empty())
    throw UserError("Continuation/Parameter = " + branch.parameter +
                    " with 'line pinning' is not possible: what the line has dissipated does not come back along a "
                    "branch. Use section Load.");
  const double advancing = pinning->parameters.advancing_angle, receding = pinning->parameters.receding_angle;
  if (droplet.contact_angle > advancing || droplet.contact_angle < receding)
    throw UserError("Droplet/Contact angle = " + exact_text(droplet.contact_angle) +
                    " must lie between Line pinning/Receding angle = " + exact_text(receding) +
                    " and Line pinning/Advancing angle = " + exact_text(advancing) + ".");
}

// Multiples of 180 degrees leave some round-off in the sine.
bool DropletScene::is_level() const
{
  return std::abs(std::sin(droplet.inclination * degree)) < 1e-14;
}

Vector3<double> DropletScene::direction_of_gravity() const
{
  const double a = droplet.inclination * degree;
  return {is_level() ? 0. : std::sin(a), 0., -std::cos(a)};
}

bool DropletScene::is_pulled_along() const
{
  return has_effect("gravity") && droplet.bond_number != 0. && !is_level();
}

bool DropletScene::is_fixed(const std::string &parameter) const
{
  return SurfaceScene::is_fixed(parameter) || parameter == "Droplet/Surface tension";
}

double DropletScene::equivalent_radius() const
{
  return std::cbrt(3. * droplet.volume / (4. * pi));
}

double DropletScene::own_energy(const double length) const
{
  return droplet.surface_tension * length * length;
}

void DropletScene::set_targets(const Scales &scales, SceneTargets &targets) const
{
  targets.volume = droplet.volume / scales.of(dimensions::volume);
  DropletTargets drop;
  drop.surface_tension = droplet.surface_tension / scales.of(dimensions::tension);
  drop.contact_angle   = droplet.contact_angle * degree;
  if (!droplet.angle_field.empty())
    drop.contact_angle_field = std::make_shared<ExpressionOfPlace>(droplet.angle_field, scales.length);
  const double radius        = own_length() / scales.length;
  drop.force_per_bond_number = drop.surface_tension / (radius * radius) * direction_of_gravity();
  drop.body_force            = droplet.bond_number * drop.force_per_bond_number;
  drop.unit_of_place         = scales.length;
  drop.has_base_membrane     = !is_cap_only() && has_line();

  const Substrate lower                = make_substrate(substrate, scales.length);
  const std::optional<Substrate> upper = make_upper_plate(substrate, scales.length);
  drop.bodies                          = {lower.body};
  drop.walls                           = {lower.chart};
  if (is_cap_only())
    drop.bases.push_back({contact_line, lower.chart});
  if (upper)
  {
    drop.bodies.push_back(upper->body);
    drop.walls.push_back(upper->chart);
    if (is_cap_only())
      drop.bases.push_back({upper_contact_line, upper->chart});
  }
  targets.droplet = drop;
}

bool DropletScene::has_two_plates() const
{
  return std::isfinite(substrate.plate_distance);
}

bool DropletScene::has_line() const
{
  return droplet.contact_angle < 180.;
}

std::vector<SceneEdge> DropletScene::edges() const
{
  if (!has_line())
    return {};
  std::vector<SceneEdge> lines{{contact_line, EdgeSupport::on_body}};
  if (has_two_plates())
    lines.push_back({upper_contact_line, EdgeSupport::on_body});
  return lines;
}

NodalConditions DropletScene::conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const
{
  NodalConditions conditions = SurfaceScene::conditions(surface, targets);
  auto &body                 = conditions["position"].body;
  body.resize(surface.n_nodes);
  for (const EdgeLoop &loop : surface.edges)
    for (const std::size_t node : loop.cell_nodes)
      body[node] = targets.drop().bodies[loop.name == contact_line ? 0 : 1];
  return conditions;
}

std::vector<std::unique_ptr<ActiveSet>> DropletScene::active_sets(const SurfaceDiscretization &surface,
                                                                  const SceneTargets &targets) const
{
  std::vector<std::unique_ptr<ActiveSet>> list;
  if (targets.drop().pinning)
    for (const EdgeLoop &loop : surface.edges)
      list.push_back(std::make_unique<LinePinning>(loop, targets));
  if (!has_effect("contact"))
    return list;
  std::vector<bool> on_line(surface.n_nodes, false);
  for (const EdgeLoop &loop : surface.edges)
    for (const std::size_t node : loop.cell_nodes)
      on_line[node] = true;
  list.push_back(std::make_unique<NodalContact>(surface, targets.drop().bodies, std::move(on_line)));
  return list;
}

// Motions of the whole drop over its substrate that cost no energy: they are a gauge.
std::vector<RigidMotion> DropletScene::free_motions() const
{
  if (mesh.symmetry == "axial" || !droplet.angle_field.empty())
    return {};
  if (substrate.shape == "height field")
  {
    const double weight = has_effect("gravity") ? droplet.bond_number : 0.;
    return free_motions_over(ExpressionOfPlace(substrate.height, own_length(), own_length()), 1.,
                             weight * direction_of_gravity());
  }
  if (is_pulled_along())
    return {};
  std::vector<RigidMotion> motions{{{}, {{0., 0., 1.}}}};
  if (substrate.shape == "plane")
  {
    motions.push_back({{{1., 0., 0.}}, {}});
    motions.push_back({{{0., 1., 0.}}, {}});
    return motions;
  }
  // Rotations about the sphere's centre c: r x (x - c). With gravity they do cost energy, but hold the drop on the
  // axis, where it is in balance by symmetry.
  const double c = (substrate.side == "outside" ? -1. : 1.) * substrate.radius / own_length();
  motions.push_back({{{0., c, 0.}}, {{1., 0., 0.}}});
  motions.push_back({{{-c, 0., 0.}}, {{0., 1., 0.}}});
  return motions;
}

SurfaceDiscretization DropletScene::start_mesh() const
{
  SurfaceDiscretization surface = !has_line()        ? resting_sphere(*this)
                                  : !is_cap_only()   ? cap_with_base(*this)
                                  : has_two_plates() ? droplet_bridge(*this)
                                                     : droplet_cap(*this);
  surface.rigid_motions         = free_motions();
  return symmetric_part(surface, mesh.mirror_planes());
}

std::optional<NodalVectors> DropletScene::reference_positions() const
{
  const double volume = droplet.reference_volume > 0. ? droplet.reference_volume : droplet.volume;
  return symmetric_part(sphere_of_volume(*this, volume), mesh.mirror_planes()).positions;
}

SurfaceMeasures DropletScene::measures(const Scales & /*scales*/) const
{
  return measure_droplet;
}

Surroundings DropletScene::surroundings() const
{
  return sample_substrate;
}

DropletScene make_droplet_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                                const std::vector<std::string> &analyses)
{
  DropletScene scene;
  list_effects(scene, library, effects, analyses);
  return scene;
}
} // namespace pellicle
