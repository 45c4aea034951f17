// SPDX-License-Identifier: LGPL-2.1-or-later
// The effects of a drop on a soft substrate: what they contribute, their parameters, their derivatives.
#include "expect_user_error.h"

#include <pellicle/potentials/potential_library.h>
#include <pellicle/potentials/solids/body_pressure.h>
#include <pellicle/potentials/solids/solid_effect.h>
#include <pellicle/potentials/solids/volume_laws.h>
#include <pellicle/potentials/wetting/free_contact_line.h>
#include <pellicle/potentials/wetting/solid_skins.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace pellicle;

/** Internal units; gamma_SL = .3, gamma_SG = .2, gamma_LG = .5 at a load of 1/2. */
SceneTargets soft_targets(const double E, const double nu)
{
  SceneTargets targets;
  RidgeTargets substrate;
  substrate.solid_liquid_tension = 0.3;
  substrate.solid_gas_tension    = 0.2;
  substrate.young_modulus        = E;
  substrate.poisson_ratio        = nu;
  substrate.load                 = 0.5;
  substrate.bulk_reference       = std::make_shared<const std::vector<ReferenceBasis>>(
      1, ReferenceBasis({1.1, 0.2, -0.1}, {0.1, 0.9, 0.3}, {-0.2, 0.15, 1.3}));
  targets.substrate                  = substrate;
  targets.droplet                    = DropletTargets{};
  targets.droplet->surface_tension   = 0.5;
  targets.droplet->has_base_membrane = true;
  targets.droplet->bounded_by        = {liquid_gas_region, solid_liquid_region};
  return targets;
}

/** Density of all energies together at a point: place, x,1, x,2, x,3 and the pressure. */
double energy_at(const PotentialSet &set, const std::vector<double> &x)
{
  double sum = 0.;
  for (const auto &energy : set.energies)
  {
    const unsigned int n = static_cast<unsigned int>(x.size()), offsets[2] = {0, 12};
    PointSums sums;
    sums.reset(1, n, Order::value);
    energy->add({0, 1, n, x.data()}, offsets, 1., Order::value, sums);
    sum += sums.value[0];
  }
  return sum;
}

PotentialSet contribution(const std::string &law, const SceneTargets &targets, const Scales &scales = {})
{
  SolidEffect solid;
  solid.parameters.volumetric_law = law;
  PotentialSet set;
  solid.contribute(scales, targets, set);
  return set;
}

const std::vector<double> stretched{0.4, -0.6, 0.9, 1.3, 0.3, -0.1, 0.2, 0.8, 0.4, -0.2, 0.25, 1.5, 0.7, 0., 0.};

double energy_of(const NeoHookeanSolid &law, const SceneTargets &targets)
{
  PotentialSet set;
  set.energies.push_back(std::make_shared<DensityPotential<ElasticBody<NeoHookeanSolid>>>(
      "solid", ElasticBody<NeoHookeanSolid>{law, targets.soft_substrate().bulk_reference}));
  return energy_at(set, stretched);
}

TEST(SolidEffect, LawOfASoftSolid)
{
  const SceneTargets targets = soft_targets(1.7, 0.3);
  for (const auto law : {VolumetricLaw::logarithmic, VolumetricLaw::quadratic})
  {
    const PotentialSet set =
        contribution(law == VolumetricLaw::quadratic ? "quadratic" : "logarithmic", targets, Scales{2., 3.});
    ASSERT_EQ(set.energies.size(), 1u);
    EXPECT_EQ(set.energies[0]->where().part, Where::Part::bulk);
    EXPECT_EQ(set.energies[0]->where().name, substrate_body);
    EXPECT_DOUBLE_EQ(energy_at(set, stretched), energy_of(NeoHookeanSolid::from_young(1.7, 0.3, law), targets));
  }
}

// The pressure that makes the mixed energy stationary makes it the energy of the displacements, for finite lambda.
TEST(SolidEffect, MixedFormHasTheSameEnergyAtItsPressure)
{
  const double E = 1.7, nu = 0.47;
  const SceneTargets targets = soft_targets(E, nu);
  const Vector3<double> x1(stretched[3], stretched[4], stretched[5]), x2(stretched[6], stretched[7], stretched[8]),
      x3(stretched[9], stretched[10], stretched[11]);
  const double J    = dot(x1, cross(x2, x3)) / (*targets.substrate->bulk_reference)[0].volume,
               lame = E * nu / ((1. + nu) * (1. - 2. * nu));
  for (const auto law : {VolumetricLaw::logarithmic, VolumetricLaw::quadratic})
  {
    const bool quadratic   = law == VolumetricLaw::quadratic;
    const PotentialSet set = contribution(quadratic ? "quadratic" : "logarithmic", targets);
    ASSERT_EQ(set.energies.size(), 2u);
    EXPECT_EQ(set.energies[1]->fields()[1].name, "body pressure");
    std::vector<double> x = stretched;
    const double p        = quadratic ? 0.5 * lame * (1. / J - J) : -lame * std::log(J);
    x[12]                 = p;
    const double expected = energy_of(NeoHookeanSolid::from_young(E, nu, law), targets);
    EXPECT_NEAR(energy_at(set, x), expected, 1e-13);
    for (const double step : {-0.1, 0.1}) // a maximum
    {
      x[12] = p + step;
      EXPECT_LT(energy_at(set, x), expected - 1e-5);
    }
  }
}

// With nu -> 1/2 both laws become p (1 - J), to which 1/2 itself leads.
TEST(SolidEffect, IncompressibleIsTheLimitOfBothLaws)
{
  const SceneTargets incompressible = soft_targets(1.7, 0.5), nearly = soft_targets(1.7, 0.5 - 1e-9);
  std::vector<double> x    = stretched; // of J = 1
  const PotentialSet exact = contribution("quadratic", incompressible);
  ASSERT_EQ(exact.energies.size(), 2u);
  const double volume = (*incompressible.substrate->bulk_reference)[0].volume,
               j      = dot(Vector3<double>(x[3], x[4], x[5]),
                            cross(Vector3<double>(x[6], x[7], x[8]), Vector3<double>(x[9], x[10], x[11])));
  for (unsigned int c = 9; c < 12; ++c)
    x[c] *= volume / j;
  EXPECT_NEAR(energy_at(exact, x), energy_at(contribution("logarithmic", incompressible), x), 1e-15);
  EXPECT_NEAR(energy_at(exact, x), energy_at(contribution("quadratic", nearly), x), 1e-8);
  EXPECT_NEAR(energy_at(exact, x), energy_at(contribution("logarithmic", nearly), x), 1e-8);
  const double without_pressure = energy_of({1.7 / 3., 0.}, incompressible);
  PotentialSet alone;
  alone.energies.push_back(exact.energies[0]);
  EXPECT_DOUBLE_EQ(energy_at(alone, stretched), without_pressure);
}

template <typename Law>
void compare_with_automatic(const Law &law)
{
  using Density = OnGivenReference<BodyPressure<Law>>;
  const DensityPotential<Density> potential("test", {{law}, soft_targets(1., 0.).substrate->bulk_reference});
  const unsigned int n = 15, offsets[2] = {0, 12};
  PointSums hand, automatic;
  hand.reset(1, n, Order::hessian);
  automatic.reset(1, n, Order::hessian);
  potential.add({0, 1, n, stretched.data()}, offsets, 1., Order::hessian, hand);
  potential.add_automatic(stretched.data(), offsets, {}, 1., Order::hessian, n, automatic.gradient.data(),
                          automatic.hessian.data());
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_NEAR(hand.gradient[i], automatic.gradient[i], 1e-13) << i;
  for (unsigned int i = 0; i < n * n; ++i)
    EXPECT_NEAR(hand.hessian[i], automatic.hessian[i], 1e-13) << i / n << "," << i % n;
}

TEST(BodyPressure, HandWrittenDerivativesAreTheAutomaticOnes)
{
  compare_with_automatic(LinearVolumeLaw{0.});
  compare_with_automatic(LinearVolumeLaw{0.3});
  compare_with_automatic(LogarithmicVolumeLaw{0.3});
  compare_with_automatic(QuadraticVolumeLaw{0.3});
}

// A line that sticks costs nothing extra: no field "material position".
TEST(SolidEffect, FreeLinesMakeTheReferenceAField)
{
  for (const double nu : {0.3, 0.5})
    for (const bool is_free : {false, true})
    {
      SceneTargets targets            = soft_targets(1.7, nu);
      targets.substrate->line_is_free = is_free;
      const PotentialSet set          = contribution("logarithmic", targets);
      ASSERT_EQ(set.energies.size(), nu == 0.5 ? 2u : 1u);
      for (const auto &energy : set.energies)
      {
        const std::vector<FieldUse> fields = energy->fields();
        EXPECT_EQ(fields[0].name, "position");
        EXPECT_EQ(std::count_if(fields.begin(), fields.end(),
                                [](const FieldUse &use) { return use.name == "material position"; }),
                  is_free ? 1 : 0);
        EXPECT_FALSE(energy->reparametrisation_invariant());
      }
    }
}

TEST(SolidEffect, PressureNodesFromThePoissonRatioOn)
{
  EXPECT_FALSE(SolidEffect::uses_pressure(0.3));
  EXPECT_TRUE(SolidEffect::uses_pressure(0.49));
  EXPECT_TRUE(SolidEffect::uses_pressure(0.5));
}

TEST(RidgeEffects, ListedEffectsNeedNoReferenceToBeChecked)
{
  const EffectLibrary library       = ridge_effects();
  SceneTargets targets              = soft_targets(1., 0.5);
  targets.substrate->bulk_reference = nullptr;
  targets.substrate->line_is_free   = true;
  targets.edges                     = {{contact_line, EdgeSupport::inner}};
  for (const std::string &name : library.names())
  {
    PotentialSet set;
    const std::unique_ptr<Effect> effect = library.create(name);
    effect->prepare(Scales{}, targets);
    EXPECT_NO_THROW(effect->contribute(Scales{}, targets, set)) << name;
    EXPECT_FALSE(effect->description().empty());
  }
}

TEST(RidgeEffects, SoftSubstratesAreAskedForWhereThereIsNone)
{
  PotentialSet set;
  EXPECT_USER_ERROR(SolidEffect().contribute(Scales{}, SceneTargets{}, set), "soft substrate");
  EXPECT_USER_ERROR(SolidSkinsEffect().contribute(Scales{}, SceneTargets{}, set), "soft substrate");
}

TEST(SolidSkins, TensionsActOnTheirRegions)
{
  PotentialSet set;
  SolidSkinsEffect().contribute(Scales{2., 3.}, soft_targets(1., 0.3), set);
  ASSERT_EQ(set.energies.size(), 2u);
  const double area = 1.3 * 0.8 - 0.3 * 0.2;
  const std::vector<double> x{0., 0., 0., 1.3, 0.3, 0., 0.2, 0.8, 0.};
  for (const auto &energy : set.energies)
  {
    PotentialSet alone;
    alone.energies.push_back(energy);
    EXPECT_EQ(energy->where().part, Where::Part::region);
    EXPECT_NEAR(energy_at(alone, x), (energy->where().name == solid_liquid_region ? 0.3 : 0.2) * area, 1e-15);
  }
  EXPECT_NE(set.energies[0]->where().name, set.energies[1]->where().name);
}

/** Power of the skins' energy on the wetted part in a uniform dilatation of an area stretched equally by l, divided by
 * twice that area: the tension in the surface. */
double tension_of_skin(const SolidSkinsEffect &effect, const SceneTargets &targets, const Scales &scales,
                       const double l)
{
  PotentialSet set;
  effect.contribute(scales, targets, set);
  const auto energy = [&](const double stretch)
  {
    PotentialSet wetted;
    for (const auto &term : set.energies)
      if (term->where().name == solid_liquid_region)
        wetted.energies.push_back(term);
    return energy_at(wetted, {0., 0., 0., stretch, 0., 0., 0., stretch, 0.});
  };
  const double h = 1e-4;
  return (energy(l * (1. + h)) - energy(l * (1. - h))) / (2. * h) / (2. * l * l);
}

// Upsilon = gamma + mu_s (1 - 1/J_s) under equal stretch, in internal units; gamma alone without modulus.
TEST(SolidSkins, StressDependsOnStrainWithAShearModulus)
{
  const Scales scales{2., 3.};
  SceneTargets targets              = soft_targets(1., 0.3);
  targets.substrate->skin_reference = std::make_shared<const std::vector<ReferenceMetric>>(1);
  SolidSkinsEffect effect;
  EXPECT_FALSE(effect.typical_energy(2.).has_value());
  EXPECT_NEAR(tension_of_skin(effect, targets, scales, 1.3), 0.3, 1e-7);
  const double modulus                   = 0.4;
  effect.parameters.solid_liquid_modulus = modulus * scales.of(dimensions::tension);
  EXPECT_DOUBLE_EQ(effect.typical_energy(2.).value(), 4. * effect.parameters.solid_liquid_modulus);
  for (const double l : {0.8, 1., 1.3})
    EXPECT_NEAR(tension_of_skin(effect, targets, scales, l), 0.3 + modulus * (1. - 1. / (l * l)), 1e-7);
}

// Nothing of it is assembled without modulus, and the reference is a field only where the line is free.
TEST(SolidSkins, ReferenceOfTheirElasticPart)
{
  SceneTargets targets = soft_targets(1., 0.3);
  for (const double modulus : {0., 0.4})
    for (const bool is_free : {false, true})
    {
      targets.substrate->line_is_free = is_free;
      SolidSkinsEffect effect;
      effect.parameters.solid_gas_modulus = modulus;
      PotentialSet set;
      effect.contribute(Scales{}, targets, set);
      ASSERT_EQ(set.energies.size(), modulus > 0. ? 3u : 2u);
      const auto &last = *set.energies.back();
      EXPECT_EQ(last.where().name, solid_gas_region);
      EXPECT_EQ(last.fields().size(), is_free && modulus > 0. ? 2u : 1u);
    }
}

TEST(FreeContactLine, TellsTheSceneItsThresholds)
{
  const Scales scales{2., 3.};
  FreeContactLineEffect effect;
  ParameterSection section(section_name(effect.name()));
  effect.bind(section);
  for (const ParameterSection::Entry &entry : section.entries())
    EXPECT_EQ(std::string(entry.dimension.text()), "energy/length^2");
  effect.parameters.advancing_threshold = 0.6;
  SceneTargets targets                  = soft_targets(1., 0.3);
  effect.prepare(scales, targets);
  EXPECT_DOUBLE_EQ(targets.substrate->thresholds.advancing, 0.8); // .6/(3/4)
  EXPECT_EQ(targets.substrate->thresholds.receding, 0.);

  PotentialSet set;
  effect.contribute(scales, targets, set);
  EXPECT_TRUE(set.energies.empty() && set.constraints.empty());
}

TEST(FreeContactLine, OneDirectionAtLeastMustBePossible)
{
  FreeContactLineEffect effect;
  effect.parameters.advancing_threshold = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(effect.check());
  effect.parameters.receding_threshold = effect.parameters.advancing_threshold;
  EXPECT_USER_ERROR(effect.check(), "never move");
}

// dE/dp per unit of the parameter as the user gives it: the energy of a parameter of 1, times the load.
TEST(RidgeEffects, DerivativesByTensionsAndModulus)
{
  const Scales scales{2., 3.};
  const SceneTargets targets = soft_targets(1.7 / scales.of(dimensions::pressure), 0.3);
  const auto slope_of        = [&](const Effect &effect, const std::string &parameter)
  {
    for (const ParameterDerivative &derivative : effect.derivatives(scales, targets))
      if (derivative.parameter == parameter)
      {
        PotentialSet alone;
        alone.energies.push_back(derivative.energy);
        return energy_at(alone, stretched);
      }
    return std::nan("");
  };
  EXPECT_NEAR(1.7 * slope_of(SolidEffect(), "Substrate/Young modulus"),
              energy_at(contribution("logarithmic", targets), stretched), 1e-13);
  const double area         = norm(cross(Vector3<double>(stretched[3], stretched[4], stretched[5]),
                                         Vector3<double>(stretched[6], stretched[7], stretched[8])));
  const double tension_unit = scales.of(dimensions::tension);
  EXPECT_NEAR(slope_of(SolidSkinsEffect(), "Tensions/Solid liquid"), 0.5 * area / tension_unit, 1e-15);
  EXPECT_NEAR(slope_of(SolidSkinsEffect(), "Tensions/Solid gas"), 0.5 * area / tension_unit, 1e-15);
  EXPECT_NEAR(slope_of(*ridge_effects().create("liquid surface"), "Tensions/Liquid gas"), 0.5 * area / tension_unit,
              1e-15);
}

// All tensions are proportional to the load, and gravity to the body force.
TEST(RidgeEffects, DerivativesByTheLoads)
{
  SceneTargets targets                   = soft_targets(1.7, 0.3);
  targets.droplet->force_per_bond_number = {0.6, 0., -0.8};
  targets.droplet->body_force            = 0.7 * targets.droplet->force_per_bond_number;
  const auto slope_over_energy           = [&](const char *name, const std::string &parameter)
  {
    const std::unique_ptr<Effect> effect = ridge_effects().create(name);
    PotentialSet whole, slope;
    effect->contribute(Scales{}, targets, whole);
    for (const ParameterDerivative &derivative : effect->derivatives(Scales{}, targets))
      if (derivative.parameter == parameter)
        slope.energies.push_back(derivative.energy);
    EXPECT_EQ(slope.energies.size(), whole.energies.size());
    return energy_at(slope, stretched) / energy_at(whole, stretched);
  };
  EXPECT_NEAR(slope_over_energy("liquid surface", "Tensions/Scale"), 1. / 0.5, 1e-14);
  EXPECT_NEAR(slope_over_energy("solid skins", "Tensions/Scale"), 1. / 0.5, 1e-14);
  EXPECT_NEAR(slope_over_energy("gravity", "Droplet/Body force"), 1. / 0.7, 1e-14);
}
} // namespace
