// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>
#include <pellicle/base/scales.h>
#include <pellicle/potentials/director/director_targets.h>
#include <pellicle/potentials/dissipation.h>
#include <pellicle/potentials/potential.h>
#include <pellicle/potentials/reference_metric.h>
#include <pellicle/potentials/shell/shell_targets.h>
#include <pellicle/potentials/wetting/droplet_targets.h>
#include <pellicle/potentials/wetting/ridge_targets.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * A scalar constraint g(fields) = target with its multiplier lambda. The Lagrangian gains
 *
 *     lambda (g - target) - lambda^2 / (2 stiffness),
 *
 * so that an infinite stiffness is the constraint by a Lagrange multiplier, and a finite one is exactly the penalty
 * energy (stiffness/2) (g - target)^2 with lambda = stiffness (g - target), without its bad conditioning.
 */
struct Constraint
{
  std::shared_ptr<const Potential> measure; ///< g, integral of a density
  /** Further parts of g on other cells than the measure's (the volume over a curved base as an integral along the
   * base's line); no two of them on the same cell. */
  std::vector<std::shared_ptr<const Potential>> further_parts = {};
  /**
   * r of a further term - (lambda^2/2) r of the Lagrangian, where g(fields) stands for g - lambda r: measures of
   * curvature by way of an internal field, which the multiplier shifts (see BilayerCurvature). Usually null. It acts
   * where the measure does.
   */
  std::shared_ptr<const Potential> self_term;
  double target    = 0.;
  double stiffness = std::numeric_limits<double>::infinity();
  std::string quantity;         ///< reported name of g, e.g. "volume"
  bool is_own_quantity = false; ///< whether g is reported for the constraint's sake (area and volume always are)
  std::string multiplier;       ///< reported name of the multiplier, e.g. "pressure"
  double multiplier_sign = 1.;  ///< reported multiplier = sign * lambda
  Dimension dimension;          ///< of g; the multiplier's is energy / dimension
  /** Part 0 is the measure, the others are the further ones. */
  const Potential &part(const std::size_t p) const { return p == 0 ? *measure : *further_parts[p - 1]; }
  std::size_t n_parts() const { return 1 + further_parts.size(); }
  /** For a finite stiffness that is physics: the reported name of (stiffness/2) (g - target)^2, which then counts in
   * the total energy. Empty: a penalty. */
  std::string energy;
};

/** A value with a name and a dimension, for reports. */
struct NamedQuantity
{
  std::string name;
  double value = 0.; ///< internal units
  Dimension dimension;
};

/** The lists that make a scene: energies, constraints and dissipation potentials. What is not listed costs nothing. */
struct PotentialSet
{
  std::vector<std::shared_ptr<const Potential>> energies;
  std::vector<Constraint> constraints;
  std::vector<NamedQuantity> prescribed; ///< forces, only for reports
  std::vector<NamedQuantity> constants;  ///< energies that no shape changes, only for reports
  std::vector<Dissipation> dissipations = {};
};

/** Coefficients of the bending energy (kappa/2)(2H + C0)^2. */
struct BendingLaw
{
  double rigidity              = 0.; ///< kappa
  double spontaneous_curvature = 0.; ///< C0
};

/** What holds an edge loop. */
enum class EdgeSupport
{
  free,    ///< nothing
  hinged,  ///< its place is held
  on_body, ///< it stays on a rigid body and moves over it
  clamped, ///< its place and the tangent plane there are held
  inner,   ///< no rim: the surface goes on
  far_side ///< an inner line again, seen from the other side, where the surface is split along it
};

/** An edge loop of the scene's surface. */
struct SceneEdge
{
  std::string name;
  EdgeSupport support = EdgeSupport::free;
  /** Outward unit conormals at the quadrature points, for a clamp; null while a scene is only checked. */
  std::shared_ptr<const std::vector<Vector3<double>>> conormals = nullptr;
  double length = 0.; ///< of the edge on the start shape; 0 while a scene is only checked
};

/** What effects may take from the scene besides their own parameters, and from each other; internal units. */
struct SceneTargets
{
  double area             = 0.; ///< `Vesicle/Area`
  double volume           = 0.; ///< from `Vesicle/Reduced volume`
  double volume_of_sphere = 0.; ///< of the given area
  /** Bending by region (0: the membrane outside all other regions); empty without bending. */
  std::vector<BendingLaw> bending = {};
  /** Whether the scene lists the bending energy. */
  bool has_bending() const { return !bending.empty() && bending[0].rigidity > 0.; }
  double gaussian_modulus      = 0.; ///< kappa_G; 0 without the effect
  double gaussian_difference   = 0.; ///< kappa_G of the domain minus that of the membrane
  std::vector<SceneEdge> edges = {};
  int euler_characteristic     = 2;
  /** Of scenes with a drop. */
  std::optional<DropletTargets> droplet = std::nullopt;
  /** The same for effects that need one. Throws UserError if the scene has none. */
  const DropletTargets &drop() const;
  /** Of scenes with a soft substrate. */
  std::optional<RidgeTargets> substrate = std::nullopt;
  /** The same for effects that need one. Throws UserError if the scene has none. */
  const RidgeTargets &soft_substrate() const;
  /** Of scenes with a shell. */
  std::optional<ShellTargets> shell = std::nullopt;
  /** The same for effects that need one. Throws UserError if the scene has none. */
  const ShellTargets &shell_targets() const;
  /** Whether the surface keeps the shape it starts with. */
  bool surface_is_held = false;
  /** Squared distances of neighbouring nodes on the start shape, at every quadrature point (squared_node_distances()),
   * from scenes with effects in mixed form; null while a scene is only checked. */
  std::shared_ptr<const std::vector<double>> cell_sizes = nullptr;
  /** Metric of the reference shape at every quadrature point, for elastic skins; null while a scene is only checked. */
  std::shared_ptr<const std::vector<ReferenceMetric>> reference = nullptr;
  /** Where the directors start, at every quadrature point, for what is carried along from there; null while a scene is
   * only checked. */
  std::shared_ptr<const std::vector<DirectorPoint>> director_start = nullptr;
  /** Directors by region (0: the membrane outside all other regions); one law for all if they do not differ, empty
   * without directors. */
  std::vector<DirectorLaw> directors = {};
  /** Region 0 of it, for effects that need directors. Throws UserError if the scene has none. */
  const DirectorLaw &director_law() const;
  /** Where the law of that number holds. */
  Where region_of_directors(std::size_t law) const;
};

/**
 * Derivative of a scene's energies and constraints with respect to a parameter, per unit of the parameter as the user
 * gives it; energies and targets in internal units. What continuation needs.
 */
struct ParameterDerivative
{
  std::string parameter;                         ///< "Section/Name"
  std::shared_ptr<const Potential> energy;       ///< dE/dp; null: none
  std::string quantity;                          ///< the constraint of this quantity has the target's derivative ...
  double target                            = 0.; ///< ... dg_0/dp
  std::shared_ptr<const Potential> measure = nullptr; ///< ... and the measure's, dg/dp at fixed fields; null: none
};

/**
 * An entry of the scene's list `Effects`: its parameters, and the energies and constraints that it adds. The parameters
 * are read in the user's units; contribute() scales them.
 */
class Effect
{
public:
  virtual ~Effect() = default;

  /** Name in the list `Effects`; with a capital first letter also the name of its section. */
  virtual const std::string &name() const = 0;
  /** One sentence with formula and signs, for the manual. */
  virtual std::string description() const = 0;
  /** Binds the parameters (none by default). */
  virtual void bind(ParameterSection & /*section*/) {}
  /** Cross-checks of parameters; throws UserError. */
  virtual void check() const {}
  /** An energy typical of the effect, in the user's units, given the scene's length; none if the effect has none. */
  virtual std::optional<double> typical_energy(double /*length*/) const { return std::nullopt; }
  /** Tells the other effects of the scene what they may need; called for all effects before contribute(). */
  virtual void prepare(const Scales & /*scales*/, SceneTargets & /*targets*/) const {}
  /** Derivatives with respect to the parameters in which continuation is possible. */
  virtual std::vector<ParameterDerivative> derivatives(const Scales & /*scales*/,
                                                       const SceneTargets & /*targets*/) const
  {
    return {};
  }
  /** Adds energies, constraints and dissipation potentials in internal units. */
  virtual void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const = 0;
};

/** The parts of the surface that together bound the liquid or the vesicle. */
std::vector<Where> boundary_of_liquid(const SceneTargets &targets);

/** Names of the regions that a surface may have, by their numbers: "membrane" (0) and "domain" (1). */
const std::string &region_name(std::size_t region);

/** "surface tension" -> "Surface tension": the section of an effect. */
std::string section_name(const std::string &effect_name);
} // namespace pellicle
