// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies as sets of cells: volumes, derivatives of everything that acts on a body and its surface, a body alone.
#include "sample_problem.h"

#include <pellicle/assembly/body_nodes.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/potentials/edges/line_tension.h>
#include <pellicle/potentials/solids/incompressible_liquid.h>
#include <pellicle/potentials/solids/neo_hookean_solid.h>

#include "../expect_user_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

struct BodyVolume
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::bulk, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return bulk_volume_density(inputs[0]);
  }
};

const std::vector<double> uneven{0., 0.3, 1.1}, upwards{-0.8, -0.5, 0.};

std::vector<std::pair<std::string, SurfaceDiscretization>> small_bodies(const unsigned int degree)
{
  return {{"block", block("body", {uneven, {-0.2, 0.7}, upwards}, degree)},
          {"cylinder", cylinder("body", {uneven, upwards}, degree)},
          {"hollow cylinder", cylinder("body", {{0.4, 0.8, 1.1}, upwards}, degree)}};
}

const Where in_body{Where::Part::bulk, "body"};

TEST(Bodies, VolumesAndTopFaces)
{
  const double volumes[] = {1.1 * 0.9 * 0.8, pi * 1.21 * 0.8, pi * (1.21 - 0.16) * 0.8},
               areas[]   = {1.1 * 0.9, pi * 1.21, pi * (1.21 - 0.16)},
               rims[]    = {2. * (1.1 + 0.9), 2. * pi * 1.1, 2. * pi * 1.1};
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    std::size_t k = 0;
    for (const auto &[name, body] : small_bodies(degree))
    {
      PotentialSet set;
      set.energies.push_back(std::make_shared<DensityPotential<BodyVolume>>("volume", BodyVolume{}, in_body));
      set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("tension", SurfaceTension{1.}));
      set.energies.push_back(
          std::make_shared<DensityPotential<LineTension>>("line", LineTension{1.}, Where{Where::Part::edge, "rim"}));
      Lagrangian lagrangian(body, set);
      const TermValues values = lagrangian.assembler.loop(set, {body.positions}, {}, Order::value);
      EXPECT_NEAR(values.energies[0], volumes[k], 1e-13) << name;
      EXPECT_NEAR(values.energies[1], areas[k], 1e-13) << name;
      EXPECT_NEAR(values.energies[2], rims[k], 1e-13) << name;
      for_all_points(body.tables, body.cell_nodes, body.positions, 3,
                     [&, of = name](const WalkPoint &x) { EXPECT_GT(cross(x[1], x[2])[2], 0.) << of; });
      ++k;
    }
  }
}

TEST(Bodies, DerivativesOfAllSetsTogether)
{
  for (const auto &named : small_bodies(2))
  {
    const auto &name = named.first;
    auto body        = named.second;
    add_pressure_nodes(body, 0);
    const auto reference =
        std::make_shared<const std::vector<ReferenceBasis>>(reference_bases(body.bulks[0], body.positions));
    PotentialSet set;
    set.energies.push_back(std::make_shared<DensityPotential<ElasticBody<NeoHookeanSolid>>>(
        "solid", ElasticBody<NeoHookeanSolid>{{1.3, 0.6}, reference}, in_body));
    set.energies.push_back(std::make_shared<DensityPotential<IncompressibleLiquid>>(
        "liquid", IncompressibleLiquid{{}, reference}, in_body));
    set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("tension", SurfaceTension{0.7}));
    set.energies.push_back(
        std::make_shared<DensityPotential<LineTension>>("line", LineTension{0.4}, Where{Where::Part::edge, "rim"}));
    Lagrangian lagrangian(body, set);
    ASSERT_EQ(lagrangian.layout.fields()[0].n_slots, 4u);

    const NodalChart pressures = bulk_scalar_chart(body);
    std::mt19937 random(4);
    const auto with_pressures = [&](FieldValues fields)
    {
      fields[1].assign(fields[1].size(), 0.);
      for (std::size_t I = 0; I < body.n_nodes; ++I)
        if (pressures.nodes[I].count == 1)
          fields[1][3 * I] = random() / 2147483648. - 1.;
      return fields;
    };
    const FieldValues fields    = with_pressures(lagrangian.rough_fields());
    const FieldValues direction = with_pressures(lagrangian.directions(1., 7));
    const double eps            = 3e-6;
    const FieldValues ahead = sum(fields, eps, direction), behind = sum(fields, -eps, direction);
    const FieldValues gradient = lagrangian.gradient(fields), product = lagrangian.matrix_times(fields, direction);
    ASSERT_TRUE(std::isfinite(lagrangian.value(fields)));
    EXPECT_NEAR((lagrangian.value(ahead) - lagrangian.value(behind)) / (2. * eps), test::dot(gradient, direction),
                1e-7 * test::norm(gradient))
        << name;
    const FieldValues difference = sum(lagrangian.gradient(ahead), -1., lagrangian.gradient(behind));
    const FieldValues error      = sum(product, -0.5 / eps, difference);
    EXPECT_LT(test::norm(error), 1e-7 * test::norm(product)) << name;
  }
}

TEST(Bodies, PressureNodesAreNoPlaces)
{
  for (const unsigned int degree : {2u, 3u})
    for (auto [name, body] : small_bodies(degree))
    {
      const std::size_t n_places = body.n_nodes;
      add_pressure_nodes(body, 0);
      const std::size_t n_modes = name == "block" ? (degree == 2 ? 4 : 10) : (degree == 2 ? 3 : 6);
      EXPECT_EQ(body.n_nodes, n_places + n_modes * body.bulks[0].n_cells) << name;
      std::size_t n_pressures = 0, n_positions = 0;
      const NodalChart pressures = bulk_scalar_chart(body), positions = free_chart(body);
      for (std::size_t I = 0; I < body.n_nodes; ++I)
      {
        n_pressures += pressures.nodes[I].count;
        EXPECT_TRUE(pressures.nodes[I].count == 0 || positions.nodes[I].count == 0) << name;
        n_positions += I < n_places ? positions.nodes[I].count : 0;
      }
      EXPECT_EQ(n_pressures, body.n_nodes - n_places) << name;
      EXPECT_GT(n_positions, n_places) << name;
      // The volume does not notice them, nor does a drag hold them.
      PotentialSet set;
      set.energies.push_back(std::make_shared<DensityPotential<BodyVolume>>("volume", BodyVolume{}, in_body));
      Lagrangian lagrangian(body, set);
      const double volume               = lagrangian.value({body.positions});
      const std::vector<double> weights = nodal_weights(body, body.positions);
      double sum                        = 0.;
      for (std::size_t I = 0; I < body.n_nodes; ++I)
      {
        sum += weights[I];
        EXPECT_EQ(weights[I] > 0., I < n_places) << name;
      }
      const double top = name == "block" ? 0.99 : name == "cylinder" ? pi * 1.21 : pi * 1.05;
      EXPECT_NEAR(sum, volume + top, 1e-12) << name;
    }
}

TEST(Bodies, ABodyAlone)
{
  for (auto [name, body] : small_bodies(2))
  {
    body.n_cells = 0;
    body.cell_nodes.clear();
    body.edges.clear();
    PotentialSet set;
    set.energies.push_back(std::make_shared<DensityPotential<BodyVolume>>("volume", BodyVolume{}, in_body));
    Lagrangian lagrangian(body, set);
    EXPECT_GT(lagrangian.value({body.positions}), 0.5) << name;
    EXPECT_EQ(lagrangian.assembler.counters().cells, body.bulks[0].n_cells) << name;
    EXPECT_GT(nodal_weights(body, body.positions)[0], 0.) << name;
  }
}

TEST(Bodies, Refusals)
{
  expect_user_error([] { block("body", {{0., 1.}, {0., 1.}, {0., 0.}}, 2); }, {"along z", "greater"});
  expect_user_error([] { block("body", {{0., 1.}, {0., 1.}, {0., 1.}}, 4); }, {"Degree = 4", "from 1 to 3"});
  expect_user_error([] { cylinder("body", {{-0.5, 1.}, {0., 1.}}, 2); }, {"r >= 0", "-0.5"});
  expect_user_error([] { cell_ends(0., 1., 4, 0.3); }, {"0.3", "0.25"});
  expect_user_error(
      []
      {
        const SurfaceDiscretization body = block("slab", {{0., 1.}, {0., 1.}, {0., 1.}}, 2);
        NodalVectors folded              = body.positions;
        for (std::size_t I = 0; I < body.n_nodes; ++I)
          folded[3 * I + 2] *= -1.;
        reference_bases(body.bulks[0], folded);
      },
      {"slab", "inside out"});
}
} // namespace
