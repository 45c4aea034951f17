// SPDX-License-Identifier: LGPL-2.1-or-later
// Sampled bodies against homogeneous deformations, whose stresses have a closed form.
#include "body_runs.h"

#include "../mpi_environment.h"

#include <pellicle/models/sample_body.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double mu = 0.7, lambda = 1.3;

double determinant(const Matrix3 &F)
{
  const auto column = [&](const unsigned int j) { return Vector3<double>(F(0, j), F(1, j), F(2, j)); };
  return dot(column(0), cross(column(1), column(2)));
}

/** sigma = (mu/J)(F F^T - 1) + (lambda/J) ln J 1. */
Matrix3 cauchy_stress(const Matrix3 &F)
{
  const double J = determinant(F);
  Matrix3 sigma  = identity3((lambda * std::log(J) - mu) / J);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        sigma(i, j) += mu / J * F(i, k) * F(j, k);
  return sigma;
}

const SampledField &field(const SurfaceSample &sample, const std::string &name)
{
  for (const SampledField &candidate : sample.fields)
    if (candidate.name == name)
      return candidate;
  throw std::runtime_error("no field " + name);
}

void check(const SurfaceDiscretization &body, const Matrix3 &F, const unsigned int dimension)
{
  PotentialSet set;
  set.energies.push_back(solid(body, {mu, lambda}));
  NodalConditions conditions;
  BodyRun run(body, set, conditions);
  NodalVectors positions;
  for (std::size_t I = 0; I < body.n_nodes; ++I)
  {
    const Vector3<double> x =
        F * Vector3<double>(body.positions[3 * I], body.positions[3 * I + 1], body.positions[3 * I + 2]);
    positions.insert(positions.end(), {x[0], x[1], x[2]});
  }
  run.place(positions);
  Scales unit;
  unit.length                = 2.;
  unit.energy                = 4.;
  const SurfaceSample sample = sample_body(run.problem, body, body.bulks[0], body.positions, unit);
  ASSERT_EQ(sample.dimension, dimension);
  ASSERT_EQ(sample.n_cells, body.bulks[0].n_cells);

  const Matrix3 sigma = cauchy_stress(F);
  const double J = determinant(F), pressure_unit = 0.5;
  double I1 = 0.;
  for (const double f : F.entries)
    I1 += f * f;
  const double W               = mu / 2. * (I1 - 3. - 2. * std::log(J)) + lambda / 2. * std::log(J) * std::log(J);
  const std::vector<double> &X = field(sample, "material_position").values, &u = field(sample, "displacement").values;
  double extent = 0.;
  for (std::size_t p = 0; p < sample.n_points(); ++p)
  {
    const Vector3<double> x = F * Vector3<double>(X[3 * p], X[3 * p + 1], X[3 * p + 2]);
    for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(sample.points[3 * p + c], x[c], 1e-12);
      EXPECT_NEAR(u[3 * p + c], x[c] - X[3 * p + c], 1e-12);
    }
    extent = std::max(extent, X[3 * p]);
    EXPECT_NEAR(field(sample, "volume_ratio").values[p], J, 1e-12);
    EXPECT_NEAR(field(sample, "elastic_energy_density").values[p], pressure_unit * W, 1e-12);
    for (unsigned int c = 0; c < 9; ++c)
      EXPECT_NEAR(field(sample, "cauchy_stress").values[9 * p + c], pressure_unit * sigma.entries[c], 1e-12);
    EXPECT_NEAR(field(sample, "mean_pressure").values[p],
                -pressure_unit * (sigma(0, 0) + sigma(1, 1) + sigma(2, 2)) / 3., 1e-12);
  }
  EXPECT_NEAR(extent, 2., 1e-12); // the unit of length
}

TEST(SampleBody, HomogeneousDeformations)
{
  const std::vector<double> ends{0., 0.4, 1.};
  for (const unsigned int degree : {2u, 3u})
  {
    check(block("body", {ends, ends, ends}, degree), {{{1.2, 0.3, -0.2, 0.1, 0.8, 0.25, -0.15, 0.05, 1.1}}}, 3);
    check(cylinder("body", {ends, ends}, degree), {{{1.2, 0., 0., 0., 1.2, 0., 0., 0., 0.8}}}, 2);
  }
}

TEST(SampleBody, VonMisesStressOfSimpleShear)
{
  const SurfaceDiscretization body = block("body", {{0., 1.}, {0., 1.}, {0., 1.}}, 2);
  PotentialSet set;
  set.energies.push_back(solid(body, {mu, 0.}));
  BodyRun run(body, set, {});
  const double g         = 0.3;
  NodalVectors positions = body.positions;
  for (std::size_t I = 0; I < body.n_nodes; ++I)
    positions[3 * I] += g * positions[3 * I + 2];
  run.place(positions);
  const SurfaceSample sample = sample_body(run.problem, body, body.bulks[0], body.positions, Scales{});
  // sigma_xz = mu g, sigma_xx = mu g^2: sqrt(sigma_xx^2 + 3 sigma_xz^2)
  for (const double value : field(sample, "von_mises_stress").values)
    EXPECT_NEAR(value, mu * g * std::sqrt(g * g + 3.), 1e-12);
}
} // namespace
