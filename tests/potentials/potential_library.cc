// SPDX-License-Identifier: LGPL-2.1-or-later
// Tests that run over every listed effect by its being listed: derivatives to second order, symmetry, rigid motions,
// reparametrisation.
#include "expect_user_error.h"

#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/energies/mesh_distortion.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/potentials/shell/cosserat_shell.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace pellicle;

struct ListedPotential
{
  std::string name;
  std::shared_ptr<const Potential> potential;

  bool is_on_edge() const { return potential->where().part == Where::Part::edge; }
  /** Heights, given conormals and dead loads single out directions in space, and so does the state that b_a remember:
   * (44) of Hu, Zhang & E turns them about O at the rate of the spin about n. */
  bool is_isotropic() const
  {
    const bool remembers =
        potential->name() == "spontaneous director curvature" && !potential->reparametrisation_invariant();
    for (const char *const part : {"tip", "clamped rim", "load point"})
      if (potential->where().name == part)
        return false;
    return potential->name() != "dead load" && !remembers;
  }
};

/** A scene in which every effect finds what it acts on. */
SceneTargets generous_targets()
{
  SceneTargets targets{12., 4.};
  targets.volume_of_sphere = 4.2;
  targets.bending          = {{0.8, 0.3}};
  targets.gaussian_modulus = -0.6;
  targets.reference        = std::make_shared<const std::vector<ReferenceMetric>>(1, ReferenceMetric{1.3, 0.2, 0.9});
  const auto conormal      = std::make_shared<const std::vector<Vector3<double>>>(1, Vector3<double>(0.6, -0.48, 0.64));
  targets.directors        = {{1.7, 0.8, -0.6}};
  targets.cell_sizes       = std::make_shared<const std::vector<double>>(1, 1.6);
  targets.director_start   = std::make_shared<const std::vector<DirectorPoint>>(
      1, DirectorPoint{{1.1, 0.1, 0.2}, {-0.2, 0.9, 0.1}, {0.3, -0.2, 0.8}});
  targets.shell = ShellTargets{std::make_shared<const std::vector<ShellReference>>(
                                   1, ShellReference({{{1.1, 0.1, 0.2}, {-0.2, 0.9, 0.1}, {-0.1, -0.1, 1.}}},
                                                     {{{0.2, 0., 0.1}, {0., 0.3, 0.}}}, {})),
                               {{"load point", {0.6, -0.48, 0.64}, {0.1, 0.2, 0.}}}};
  targets.edges = {{"free rim", EdgeSupport::free},
                   {"hinged rim", EdgeSupport::hinged},
                   {"clamped rim", EdgeSupport::clamped, conormal},
                   {"line", EdgeSupport::inner}};
  return targets;
}

/** Variants that a choice among words makes. */
std::vector<std::unique_ptr<Effect>> variants(const EffectLibrary &library, const std::string &name)
{
  std::vector<std::unique_ptr<Effect>> all;
  all.push_back(library.create(name));
  ParameterSection section(section_name(name));
  all[0]->bind(section);
  for (std::size_t e = 0; e < section.entries().size(); ++e)
    for (std::size_t choice = 1; choice < section.entries()[e].choices.size(); ++choice)
    {
      all.push_back(library.create(name));
      ParameterSection of_variant(section_name(name));
      all.back()->bind(of_variant);
      *std::get<std::string *>(of_variant.entries()[e].target) = of_variant.entries()[e].choices[choice];
    }
  return all;
}

// Every energy and constraint of every effect, and their derivatives with respect to parameters; with parameters away
// from special values and a skew reference; and the mesh energy.
std::vector<ListedPotential> listed_potentials()
{
  const EffectLibrary library = director_effects(); // these include the standard ones
  std::vector<ListedPotential> all;
  for (const std::string &name : library.names())
  {
    for (const std::unique_ptr<Effect> &effect : variants(library, name))
    {
      ParameterSection section(section_name(name));
      effect->bind(section);
      double value = 0.7;
      for (const ParameterSection::Entry &entry : section.entries())
        if (const auto number = std::get_if<double *>(&entry.target))
          **number =
              std::isfinite(entry.range.upper) ? 0.4 * entry.range.lower + 0.6 * entry.range.upper : (value += 0.4);
      PotentialSet set;
      SceneTargets targets = generous_targets();
      effect->prepare(Scales{}, targets);
      effect->contribute(Scales{}, targets, set);
      EXPECT_FALSE(set.energies.empty() && set.constraints.empty() && set.dissipations.empty()) << name;
      for (const auto &energy : set.energies)
        all.push_back({name, energy});
      for (const Constraint &constraint : set.constraints)
      {
        all.push_back({name, constraint.measure});
        if (constraint.self_term)
          all.push_back({name + ", self term", constraint.self_term});
      }
      for (const ParameterDerivative &derivative : effect->derivatives(Scales{}, targets))
        if (derivative.energy)
          all.push_back({"derivative with respect to " + derivative.parameter, derivative.energy});
    }
  }
  all.push_back({"null lagrangian", null_lagrangian({1.7, 0.8, -0.6})});
  all.push_back({"mesh distortion", make_mesh_distortion({{1.3, 0.2, 0.9}})});
  return all;
}

// One random point: inputs with well separated base vectors, and the potential's offsets.
struct Point
{
  std::vector<unsigned int> offsets, slots; ///< of each field
  std::vector<bool> turns; ///< of each vector of inputs: it turns with the surface; no number, no stress of a reference
  unsigned int n_inputs = 0;
  std::vector<double> inputs;

  Point(const Potential &potential, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for (const FieldUse &use : potential.fields())
    {
      offsets.push_back(n_inputs);
      slots.push_back(n_slots(use.derivatives));
      n_inputs += 3 * slots.back();
      turns.resize(n_inputs / 3,
                   use.space != FieldSpace::edge_scalars && use.name != shell_stress_1 && use.name != shell_stress_2);
    }
    for (unsigned int i = 0; i < n_inputs; ++i)
      inputs.push_back(uniform(random));
    const std::vector<FieldUse> fields = potential.fields();
    for (std::size_t f = 0; f < offsets.size(); ++f)
    {
      if (fields[f].space == FieldSpace::unit_vectors || fields[f].name == shell_director)
        inputs[offsets[f] + 2] += 1.; // near e_z
      if (slots[f] > 1)
      {
        inputs[offsets[f] + 3] += 1.; // ,1 near e_x
        inputs[offsets[f] + 7] += 1.; // ,2 near e_y
      }
    }
  }
};

PointSums derivatives(const Potential &potential, const Point &point, const std::vector<double> &inputs,
                      const Order order)
{
  PointSums sums;
  sums.reset(1, point.n_inputs, order);
  potential.add({0, 1, point.n_inputs, inputs.data()}, point.offsets.data(), 1., order, sums);
  return sums;
}

TEST(PotentialLibrary, DerivativesAgreeWithCentralDifferencesToSecondOrder)
{
  std::mt19937 random(7);
  for (const ListedPotential &listed : listed_potentials())
  {
    const Point point(*listed.potential, random);
    const PointSums at = derivatives(*listed.potential, point, point.inputs, Order::hessian);
    std::vector<double> direction(point.n_inputs);
    for (double &d : direction)
      d = std::uniform_real_distribution<double>(-1., 1.)(random);
    // The error of a central difference falls by four when the step is halved, so it is a sign or factor that is wrong
    // if it does not.
    double previous_value = 0., previous_gradient = 0.;
    for (int level = 0; level < 2; ++level)
    {
      const double h           = level == 0 ? 2e-2 : 1e-2;
      std::vector<double> plus = point.inputs, minus = point.inputs;
      for (unsigned int i = 0; i < point.n_inputs; ++i)
      {
        plus[i] += h * direction[i];
        minus[i] -= h * direction[i];
      }
      const PointSums up   = derivatives(*listed.potential, point, plus, Order::gradient),
                      down = derivatives(*listed.potential, point, minus, Order::gradient);
      double slope = 0., error_gradient = 0.;
      for (unsigned int i = 0; i < point.n_inputs; ++i)
      {
        slope += at.gradient[i] * direction[i];
        double curvature = 0.;
        for (unsigned int j = 0; j < point.n_inputs; ++j)
          curvature += at.hessian[i * point.n_inputs + j] * direction[j];
        error_gradient = std::max(error_gradient, std::abs((up.gradient[i] - down.gradient[i]) / (2. * h) - curvature));
      }
      const double error_value = std::abs((up.value[0] - down.value[0]) / (2. * h) - slope);
      if (level == 1)
      {
        EXPECT_LT(error_value, 0.3 * previous_value + 1e-10) << listed.name;
        EXPECT_LT(error_gradient, 0.3 * previous_gradient + 1e-10) << listed.name;
        EXPECT_LT(error_value, 1e-2) << listed.name;
      }
      previous_value    = error_value;
      previous_gradient = error_gradient;
    }
  }
}

TEST(PotentialLibrary, HessiansAreSymmetric)
{
  std::mt19937 random(11);
  for (const ListedPotential &listed : listed_potentials())
  {
    const Point point(*listed.potential, random);
    const PointSums at = derivatives(*listed.potential, point, point.inputs, Order::hessian);
    double largest     = 0.;
    for (const double h : at.hessian)
      largest = std::max(largest, std::abs(h));
    for (unsigned int i = 0; i < point.n_inputs; ++i)
      for (unsigned int j = 0; j < i; ++j)
        EXPECT_NEAR(at.hessian[i * point.n_inputs + j], at.hessian[j * point.n_inputs + i], 1e-13 * largest)
            << listed.name;
  }
}

TEST(PotentialLibrary, GradientOnlyEqualsGradientOfHessianCall)
{
  std::mt19937 random(13);
  for (const ListedPotential &listed : listed_potentials())
  {
    const Point point(*listed.potential, random);
    const PointSums full = derivatives(*listed.potential, point, point.inputs, Order::hessian),
                    half = derivatives(*listed.potential, point, point.inputs, Order::gradient),
                    none = derivatives(*listed.potential, point, point.inputs, Order::value);
    EXPECT_NEAR(full.value[0], none.value[0], 1e-14 * std::abs(none.value[0])) << listed.name;
    for (unsigned int i = 0; i < point.n_inputs; ++i)
      EXPECT_NEAR(full.gradient[i], half.gradient[i], 1e-13) << listed.name;
  }
}

// Rotation by a random unit quaternion, about the origin: densities of closed surfaces that read the position itself
// (volume) are invariant under translation only as integrals, which the assembly tests cover.
TEST(PotentialLibrary, DensitiesAreInvariantUnderRotation)
{
  std::mt19937 random(17);
  const double a = 0.3, b = 0.5, c = 0.1, d = std::sqrt(1. - a * a - b * b - c * c);
  const double R[3][3] = {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                          {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                          {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
  for (const ListedPotential &listed : listed_potentials())
  {
    if (!listed.is_isotropic())
      continue;
    const Point point(*listed.potential, random);
    std::vector<double> rotated = point.inputs;
    for (unsigned int k = 0; k < point.n_inputs; k += 3)
      for (unsigned int i = 0; i < 3 && point.turns[k / 3]; ++i)
        rotated[k + i] = R[i][0] * point.inputs[k] + R[i][1] * point.inputs[k + 1] + R[i][2] * point.inputs[k + 2];
    const double before = derivatives(*listed.potential, point, point.inputs, Order::value).value[0];
    EXPECT_NEAR(derivatives(*listed.potential, point, rotated, Order::value).value[0], before,
                1e-13 * (1. + std::abs(before)))
        << listed.name;
  }
}

// Under a linear change of parameters xi = B xi' a density per parametric area must change by det B if the integral is
// invariant, and only then; a density per parametric length of an edge by the scale of its parameter.
TEST(PotentialLibrary, ReparametrisationInvarianceIsAsDeclared)
{
  std::mt19937 random(19);
  constexpr double area_change[2][2] = {{1.2, 0.3}, {-0.2, 0.9}}, length_change[2][2] = {{1.2, 0.}, {0., 1.}};
  for (const ListedPotential &listed : listed_potentials())
  {
    const auto &B    = listed.is_on_edge() ? length_change : area_change;
    const double det = B[0][0] * B[1][1] - B[0][1] * B[1][0];
    const Point point(*listed.potential, random);
    std::vector<double> changed = point.inputs;
    for (std::size_t f = 0; f < point.offsets.size(); ++f)
      for (unsigned int c = 0; point.slots[f] > 1 && c < 3; ++c)
        for (unsigned int s = 0; s < 2; ++s)
          changed[point.offsets[f] + 3 * (1 + s) + c] =
              point.inputs[point.offsets[f] + 3 + c] * B[0][s] + point.inputs[point.offsets[f] + 6 + c] * B[1][s];
    const double before = derivatives(*listed.potential, point, point.inputs, Order::value).value[0];
    const double after  = derivatives(*listed.potential, point, changed, Order::value).value[0];
    if (listed.potential->reparametrisation_invariant())
      EXPECT_NEAR(after, det * before, 1e-13 * (1. + std::abs(before))) << listed.name;
    else
      EXPECT_GT(std::abs(after - det * before), 1e-6) << listed.name;
  }
}

TEST(PotentialLibrary, UnknownEffectsAreAnsweredWithNearMatches)
{
  EXPECT_USER_ERROR(standard_effects().create("helfrich bendin"), "helfrich bending");
}
} // namespace
