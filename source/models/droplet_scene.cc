// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/models/droplet_measures.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/droplet_start.h>
#include <pellicle/models/free_motions.h>

#include <cmath>

namespace pellicle
{
namespace
{
constexpr double degree = pi / 180.;

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
  if (!mesh.file.empty())
    throw UserError("Mesh/File = " + mesh.file + ": drops make their own mesh. Remove it.");
  if (droplet.contact_angle == 180.)
    throw UserError(
        "Droplet/Contact angle = 180 is not possible with the surface of the cap alone: the contact line "
        "shrinks to a point. It needs the base-membrane formulation: Droplet/Base = membrane with the effect "
        "'contact'.");
  if (!has_effect("liquid surface"))
    throw UserError("The list Effects has no 'liquid surface': nothing holds the liquid together.");
  if (!has_effect("gravity") && droplet.bond_number != 0.)
    throw UserError("Droplet/Bond number = " + exact_text(droplet.bond_number) +
                    " has no effect in this scene: add 'gravity' to Effects.");
  if (axial && has_effect("gravity") && std::sin(droplet.inclination * degree) != 0.)
    throw UserError(
        "Droplet/Inclination = " + exact_text(droplet.inclination) +
        " with Mesh/Symmetry = axial: on an inclined substrate the drop is not axisymmetric. Set Symmetry to "
        "none.");
  if (!droplet.angle_field.empty())
  {
    const ExpressionOfPlace field(droplet.angle_field);
    if (axial)
      check_axisymmetric("Droplet/Contact angle field", field, own_length());
  }
  if (substrate.shape == "height field" && axial)
    check_axisymmetric("Substrate/Height", ExpressionOfPlace(substrate.height), own_length());
  SurfaceScene::check();
}

bool DropletScene::is_fixed(const std::string &parameter) const
{
  return SurfaceScene::is_fixed(parameter) || parameter == "Droplet/Surface tension";
}

double DropletScene::own_length() const
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
  const double radius = own_length() / scales.length, a = droplet.inclination * degree;
  drop.force_per_bond_number =
      drop.surface_tension / (radius * radius) * Vector3<double>(std::sin(a), 0., -std::cos(a));
  drop.body_force    = droplet.bond_number * drop.force_per_bond_number;
  drop.unit_of_place = scales.length;
  drop.substrate     = make_substrate(substrate, scales.length).chart;
  targets.droplet    = drop;
}

std::vector<SceneEdge> DropletScene::edges() const
{
  return {{contact_line, EdgeSupport::on_body}};
}

NodalConditions DropletScene::conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const
{
  NodalConditions conditions = SurfaceScene::conditions(surface, targets);
  const Substrate rigid      = make_substrate(substrate, targets.drop().unit_of_place);
  auto &body                 = conditions["position"].body;
  body.resize(surface.n_nodes);
  for (const EdgeLoop &loop : surface.edges)
    if (loop.name == contact_line)
      for (const std::size_t node : loop.cell_nodes)
        body[node] = rigid.body;
  return conditions;
}

// Motions of the whole drop over its substrate that cost no energy: they are a gauge.
std::vector<RigidMotion> DropletScene::free_motions() const
{
  if (mesh.symmetry == "axial" || !droplet.angle_field.empty())
    return {};
  if (substrate.shape == "height field")
  {
    const double a = droplet.inclination * degree, weight = has_effect("gravity") ? droplet.bond_number : 0.;
    return free_motions_over(ExpressionOfPlace(substrate.height, own_length(), own_length()), 1.,
                             weight * Vector3<double>(std::sin(a), 0., -std::cos(a)));
  }
  const bool inclined =
      has_effect("gravity") && droplet.bond_number != 0. && std::sin(droplet.inclination * degree) != 0.;
  if (inclined)
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
  SurfaceDiscretization surface = droplet_cap(*this);
  surface.rigid_motions         = free_motions();
  return surface;
}

SurfaceMeasures DropletScene::measures(const Scales & /*scales*/) const
{
  return measure_droplet;
}

DropletScene make_droplet_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                                const std::vector<std::string> &analyses)
{
  DropletScene scene;
  list_effects(scene, library, effects, analyses);
  return scene;
}
} // namespace pellicle
