// SPDX-License-Identifier: LGPL-2.1-or-later
// The effects of directors: what they contribute, in which units, and what they refuse.
#include "expect_user_error.h"

#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/director/in_plane_directors.h>
#include <pellicle/potentials/director/spontaneous_curvature_effect.h>
#include <pellicle/potentials/director/tilt_energy.h>
#include <pellicle/potentials/potential_library.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pellicle;

SceneTargets targets_with(const double cell_size)
{
  SceneTargets targets;
  targets.cell_sizes     = std::make_shared<const std::vector<double>>(1, cell_size);
  targets.director_start = std::make_shared<const std::vector<DirectorPoint>>(
      1, DirectorPoint{{1., 0.1, 0.2}, {-0.2, 0.9, 0.1}, {0.3, -0.2, 0.8}});
  return targets;
}

/** Value at some point; the potential reads position, director and perhaps the shear. */
double value_at_a_point(const Potential &potential)
{
  std::vector<unsigned int> offsets;
  unsigned int n = 0;
  for (const FieldUse &use : potential.fields())
  {
    offsets.push_back(n);
    n += 3 * n_slots(use.derivatives);
  }
  std::vector<double> inputs;
  for (unsigned int i = 0; i < n; ++i)
    inputs.push_back(std::sin(1. + 2.3 * i));
  PointSums sums;
  sums.reset(1, n, Order::value);
  potential.add({0, 1, n, inputs.data()}, offsets.data(), 1., Order::value, sums);
  return sums.value[0];
}

PotentialSet contributions(const Scales &scales, const std::vector<const Effect *> &effects, SceneTargets targets)
{
  for (const Effect *effect : effects)
    effect->prepare(scales, targets);
  PotentialSet set;
  for (const Effect *effect : effects)
    effect->contribute(scales, targets, set);
  return set;
}

TEST(DirectorEffects, EnergiesHaveTheNamesOfTheReports)
{
  DirectorEffect director;
  SpontaneousDirectorCurvatureEffect curvature;
  const PotentialSet set = contributions(Scales{}, {&director, &curvature}, targets_with(1.));
  ASSERT_EQ(set.energies.size(), 3u);
  EXPECT_EQ(set.energies[0]->name(), "tilt");
  EXPECT_EQ(set.energies[1]->name(), "director gradient");
  EXPECT_EQ(set.energies[2]->name(), "spontaneous director curvature");
  EXPECT_EQ(set.energies[0]->fields().size(), 3u);
  director.parameters.shear = "direct";
  EXPECT_EQ(contributions(Scales{}, {&director}, targets_with(1.)).energies[0]->fields().size(), 2u);
}

// Scenes are checked before there is a mesh.
TEST(DirectorEffects, NeedNoMeshToBeListed)
{
  const EffectLibrary library = director_effects();
  const auto director = library.create("director"), curvature = library.create("spontaneous director curvature");
  static_cast<SpontaneousDirectorCurvatureEffect &>(*curvature).parameters.form = "transported";
  EXPECT_EQ(contributions(Scales{}, {director.get(), curvature.get()}, SceneTargets{}).energies.size(), 3u);
}

TEST(DirectorEffects, DirectPartOfTheTiltModulus)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto direct     = [](const double k_t, const double K, const double h_squared, const bool is_held)
  {
    SceneTargets targets    = targets_with(h_squared);
    targets.surface_is_held = is_held;
    return (*direct_tilt_modulus({k_t, K, 0.}, targets))[0];
  };
  for (const double k_t : {infinity, 1e3})
  {
    EXPECT_DOUBLE_EQ(direct(k_t, 2., 0.1, true), 2.);
    EXPECT_DOUBLE_EQ(direct(k_t, 2., 0.1, false), 20.);
  }
  EXPECT_DOUBLE_EQ(direct(2., 2., 0.1, true), 1.8);
  EXPECT_DOUBLE_EQ(direct(10., 2., 0.1, false), 9.);
}

// The whole in internal units times the unit of energy per area is the whole in the user's units.
TEST(DirectorEffects, ModuliAreScaled)
{
  const Scales scales{0.2, 5.};
  DirectorEffect director;
  director.parameters = {30., 4., -0.8, "mixed"};
  SpontaneousDirectorCurvatureEffect curvature;
  curvature.parameters.spontaneous_curvature = 0.7;
  SceneTargets targets;
  director.prepare(scales, targets);
  EXPECT_DOUBLE_EQ(targets.director_law().tilt_modulus, 30. * 0.04 / 5.);
  EXPECT_DOUBLE_EQ(targets.director_law().bending_modulus, 0.8);
  EXPECT_DOUBLE_EQ(targets.director_law().gaussian_modulus, -0.16);

  // B = -C0 K/(2 K + kappa_G), with C0 = .14 in internal units.
  EXPECT_DOUBLE_EQ(targets.director_law().isotropic_curvature(0.14), -0.14 * 0.8 / 1.44);
  DirectorEffect in_units;
  in_units.parameters = {30. * 0.04 / 5., 0.8, -0.16, "mixed"};
  SpontaneousDirectorCurvatureEffect curvature_in_units;
  curvature_in_units.parameters.spontaneous_curvature = 0.14;
  const PotentialSet set  = contributions(scales, {&director, &curvature}, targets_with(0.3)),
                     same = contributions(Scales{}, {&in_units, &curvature_in_units}, targets_with(0.3));
  for (std::size_t e = 0; e < set.energies.size(); ++e)
  {
    EXPECT_NEAR(value_at_a_point(*set.energies[e]), value_at_a_point(*same.energies[e]), 1e-14) << e;
    EXPECT_NE(value_at_a_point(*set.energies[e]), 0.);
  }
}

/** Derivative of the energies at a point by differences, and as offered. */
template <typename SetParameter>
void compare_derivative(const std::string &name, DirectorEffect &director,
                        SpontaneousDirectorCurvatureEffect &curvature, const double cell_size, const double value,
                        const SetParameter &set_parameter)
{
  const Scales scales{0.5, 3.};
  const auto energy = [&](const double p)
  {
    set_parameter(p);
    double sum = 0.;
    for (const auto &potential : contributions(scales, {&director, &curvature}, targets_with(cell_size)).energies)
      sum += value_at_a_point(*potential);
    return sum;
  };
  const double h = 1e-3 * value, slope = (energy(value + h) - energy(value - h)) / (2. * h);
  set_parameter(value);
  SceneTargets targets = targets_with(cell_size);
  director.prepare(scales, targets);
  for (const Effect *effect : {static_cast<const Effect *>(&director), static_cast<const Effect *>(&curvature)})
    for (const ParameterDerivative &derivative : effect->derivatives(scales, targets))
      if (derivative.parameter == name)
      {
        EXPECT_NEAR(value_at_a_point(*derivative.energy), slope, 1e-5 * std::abs(slope)) << name;
        return;
      }
  ADD_FAILURE() << name << " is not offered";
}

TEST(DirectorEffects, DerivativesWithRespectToParameters)
{
  DirectorEffect director;
  director.parameters.gaussian_modulus = -0.3;
  SpontaneousDirectorCurvatureEffect curvature;
  curvature.parameters.spontaneous_curvature = 0.4;
  const auto tilt_modulus                    = [&](const double p) { director.parameters.tilt_modulus = p; };
  for (const double cell_size : {0.001, 10.}) // k_0 = k_t/2, and that of the cell
    compare_derivative("Director/Tilt modulus", director, curvature, cell_size, 3., tilt_modulus);
  director.parameters.shear = "direct";
  compare_derivative("Director/Tilt modulus", director, curvature, 1., 3., tilt_modulus);
  compare_derivative("Spontaneous director curvature/Spontaneous curvature", director, curvature, 1., 0.7,
                     [&](const double p) { curvature.parameters.spontaneous_curvature = p; });
}

// In the place of the tilt, with nothing left of it, not even the fields of the mixed form.
TEST(DirectorEffects, InPlaneDirectors)
{
  const Scales scales{0.2, 5.};
  DirectorEffect director;
  director.parameters = {0., 4., 0., "mixed"};
  InPlaneDirectorsEffect in_plane;
  in_plane.parameters.modulus = 3.;
  const PotentialSet set      = contributions(scales, {&director, &in_plane}, targets_with(1.));
  ASSERT_EQ(set.energies.size(), 2u);
  EXPECT_EQ(set.energies[0]->name(), "director gradient");
  EXPECT_EQ(set.energies[1]->name(), "normal director");
  for (const auto &energy : set.energies)
    EXPECT_EQ(energy->fields().size(), 2u);
  EXPECT_TRUE(director.derivatives(scales, targets_with(1.)).empty());

  const DensityPotential<NormalDirectorEnergy> expected("", NormalDirectorEnergy{3. * 0.04 / 5.});
  EXPECT_DOUBLE_EQ(value_at_a_point(*set.energies[1]), value_at_a_point(expected));
  const auto derivatives = in_plane.derivatives(scales, targets_with(1.));
  ASSERT_EQ(derivatives.size(), 1u);
  EXPECT_EQ(derivatives[0].parameter, "In-plane directors/Modulus");
  EXPECT_NEAR(value_at_a_point(*derivatives[0].energy), value_at_a_point(expected) / 3., 1e-15);
  EXPECT_USER_ERROR(contributions(scales, {&in_plane}, SceneTargets{}), "add 'director' to Effects");
}

// Energies of either region, in units of its moduli, and the jump of the null term inside the domain.
TEST(DirectorEffects, DomainHasModuliOfItsOwn)
{
  const Scales scales{0.2, 5.};
  DirectorEffect director, in_domain;
  director.parameters  = {30., 4., -0.8, "mixed", 0.5, 3.};
  in_domain.parameters = {15., 12., -0.8, "mixed"};
  SpontaneousDirectorCurvatureEffect curvature;
  curvature.parameters.spontaneous_curvature = 0.7;
  const PotentialSet set   = contributions(scales, {&director, &curvature}, targets_with(0.3)),
                     alone = contributions(scales, {&in_domain, &curvature}, targets_with(0.3));
  const std::vector<const char *> names{"tilt", "director gradient", "tilt", "director gradient",
                                        "domain null lagrangian", "spontaneous director curvature",
                                        "spontaneous director curvature"};
  ASSERT_EQ(set.energies.size(), names.size());
  for (std::size_t e = 0; e < names.size(); ++e)
  {
    EXPECT_EQ(set.energies[e]->name(), names[e]);
    EXPECT_EQ(set.energies[e]->where().part, Where::Part::region);
    EXPECT_EQ(set.energies[e]->where().name, region_name(e < 2 || e == 5 ? 0 : 1));
  }
  const auto same = [&](const std::size_t e, const Potential &expected)
  { EXPECT_NEAR(value_at_a_point(*set.energies[e]), value_at_a_point(expected), 1e-14) << e; };
  same(2, *alone.energies[0]);
  same(3, *alone.energies[1]);
  same(4, *null_lagrangian({0., 8. / 5., 0.}));
  same(6, *alone.energies[2]);
  for (const auto &energy : alone.energies)
    EXPECT_EQ(energy->where().part, Where::Part::surface);

  EXPECT_TRUE(director.parameters.shear_jumps());
  EXPECT_FALSE(in_domain.parameters.shear_jumps());
  director.parameters.tilt_modulus = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(director.parameters.shear_jumps()) << "the directors are normal on both sides";
}

// dE/dk_t counts the domain by its ratio.
TEST(DirectorEffects, DerivativeInTheDomain)
{
  constexpr double step = 1e-3, k_t = 3.;
  for (const std::string shear : {"mixed", "direct"})
  {
    const auto energy_at = [&](const double value)
    {
      DirectorEffect effect;
      effect.parameters = {value, 1., 0., shear, 4.};
      return contributions(Scales{0.2, 5.}, {&effect}, targets_with(0.01)).energies[2];
    };
    DirectorEffect effect;
    effect.parameters    = {k_t, 1., 0., shear, 4.};
    SceneTargets targets = targets_with(0.01);
    effect.prepare(Scales{0.2, 5.}, targets);
    const auto derivatives = effect.derivatives(Scales{0.2, 5.}, targets);
    ASSERT_EQ(derivatives.size(), 2u);
    EXPECT_EQ(derivatives[1].energy->where().name, region_name(1));
    const double difference =
        (value_at_a_point(*energy_at(k_t + step)) - value_at_a_point(*energy_at(k_t - step))) / (2. * step);
    EXPECT_NEAR(value_at_a_point(*derivatives[1].energy), difference, 1e-6 * std::abs(difference)) << shear;
  }
}

TEST(DirectorEffects, WhatIsRefused)
{
  DirectorEffect director;
  director.parameters.tilt_modulus = std::numeric_limits<double>::infinity();
  director.check();
  EXPECT_TRUE(director.derivatives(Scales{}, SceneTargets{}).empty());
  director.parameters.shear = "direct";
  EXPECT_USER_ERROR(director.check(), "Director/Tilt modulus = inf", "Director/Shear = mixed");

  SpontaneousDirectorCurvatureEffect curvature;
  EXPECT_USER_ERROR(contributions(Scales{}, {&curvature}, SceneTargets{}), "add 'director' to Effects");
  director.parameters = {1., 1., -2.5, "mixed"};
  EXPECT_USER_ERROR(contributions(Scales{}, {&director, &curvature}, SceneTargets{}), "Director/Gaussian modulus > -2",
                    "-0.25");
}
} // namespace
