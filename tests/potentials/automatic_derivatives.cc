// SPDX-License-Identifier: LGPL-2.1-or-later
// Hand-written derivatives against automatic differentiation of the same density.
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/director_gradient.h>
#include <pellicle/potentials/director/in_plane_directors.h>
#include <pellicle/potentials/director/spontaneous_director_curvature.h>
#include <pellicle/potentials/director/tilt_energy.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/energies/helfrich_bending.h>
#include <pellicle/potentials/energies/incompressible_rubber_skin.h>
#include <pellicle/potentials/energies/mesh_distortion.h>
#include <pellicle/potentials/energies/neo_hookean_skin.h>
#include <pellicle/potentials/energies/pressure.h>
#include <pellicle/potentials/energies/skalak_skin.h>
#include <pellicle/potentials/energies/surface_tension.h>
#include <pellicle/potentials/energies/tu_ou_yang_skin.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{
using namespace pellicle;

template <typename Density>
void compare(const Density &density)
{
  const DensityPotential<Density> potential("test", density);
  std::vector<unsigned int> offsets;
  unsigned int n = 0;
  for (const FieldUse &use : potential.fields())
  {
    offsets.push_back(n);
    n += 3 * n_slots(use.derivatives);
  }
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int trial = 0; trial < 5; ++trial)
  {
    std::vector<double> inputs(n);
    for (double &x : inputs)
      x = uniform(random);
    PointSums hand, automatic;
    hand.reset(1, n, Order::hessian);
    automatic.reset(1, n, Order::hessian);
    const double factor = -1.7;
    potential.add({0, 1, n, inputs.data()}, offsets.data(), factor, Order::hessian, hand);
    automatic.value[0] = potential.add_automatic(inputs.data(), offsets.data(), {0}, factor, Order::hessian, n,
                                                 automatic.gradient.data(), automatic.hessian.data());
    double largest     = 0.;
    for (const double h : automatic.hessian)
      largest = std::max(largest, std::abs(h));
    EXPECT_NEAR(hand.value[0], automatic.value[0], 1e-12 * largest);
    for (unsigned int i = 0; i < n; ++i)
      EXPECT_NEAR(hand.gradient[i], automatic.gradient[i], 1e-12 * largest) << i;
    for (unsigned int i = 0; i < n * n; ++i)
      EXPECT_NEAR(hand.hessian[i], automatic.hessian[i], 1e-12 * largest) << i / n << "," << i % n;
  }
}

TEST(AutomaticDerivatives, HelfrichBending)
{
  compare(HelfrichBending{1.3, 0.8});
}
TEST(AutomaticDerivatives, SurfaceTension)
{
  compare(SurfaceTension{0.6});
}
TEST(AutomaticDerivatives, Pressure)
{
  compare(Pressure{2.1});
}
TEST(AutomaticDerivatives, Gravity)
{
  compare(Gravity{{0.3, -0.2, -1.1}});
}
TEST(AutomaticDerivatives, TotalArea)
{
  compare(TotalArea{});
}
TEST(AutomaticDerivatives, EnclosedVolume)
{
  compare(EnclosedVolume{});
}

std::shared_ptr<const std::vector<ReferenceMetric>> skew_reference()
{
  return std::make_shared<const std::vector<ReferenceMetric>>(1, ReferenceMetric{1.3, 0.2, 0.9});
}

TEST(AutomaticDerivatives, MeshDistortion)
{
  compare(MeshDistortion{skew_reference()});
}
TEST(AutomaticDerivatives, ElasticSkins)
{
  compare(ElasticSkin<NeoHookeanSkin>{{1.3}, skew_reference()});
  compare(ElasticSkin<IncompressibleRubberSkin>{{1.3}, skew_reference()});
  compare(ElasticSkin<SkalakSkin>{{1.3, 2.1}, skew_reference()});
  compare(ElasticSkin<TuOuYangSkin>{{1.3, 0.4}, skew_reference()});
}

TEST(AutomaticDerivatives, Directors)
{
  const auto direct = std::make_shared<const std::vector<double>>(1, 0.7);
  compare(DirectorGradientEnergy{1.3});
  compare(TiltEnergy{2.1});
  compare(NormalDirectorEnergy{1.7});
  compare(MixedTiltEnergy{2.1, direct});
  compare(SpontaneousDirectorCurvature{0.3, -0.7, 1.1, 0.6});
  compare(MixedTiltEnergy{std::numeric_limits<double>::infinity(), direct});
}
} // namespace
