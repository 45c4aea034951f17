// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop over cells, its counters, charts, and the bordered system against plain dense computations.
#include "sample_problem.h"

#include <pellicle/assembly/bordered_system.h>
#include <pellicle/base/constants.h>
#include <pellicle/base/observer.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/potentials/energies/mesh_distortion.h>

#include "../mpi_environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

// Energy, gradient and matrix of a cell: plain sums over points, slots, nodes, with automatic derivatives, against the
// contraction with the hand-written ones.
TEST(Contraction, EqualsAPlainLoop)
{
  for (const auto &named : small_surfaces())
  {
    const auto &name    = named.first;
    const auto &surface = named.second;
    const DensityPotential<HelfrichBending> bending("helfrich bending", HelfrichBending{1.3, 0.4});
    PotentialSet set;
    set.energies.push_back(std::make_shared<DensityPotential<HelfrichBending>>(bending));
    Lagrangian lagrangian(surface, set);
    const FieldValues fields                = lagrangian.rough_fields();
    const ShapeTables &tables               = surface.tables;
    const unsigned int n                    = lagrangian.layout.n_inputs();
    const std::vector<unsigned int> offsets = lagrangian.layout.offsets(bending);
    const std::size_t n_rows                = 6 * surface.n_local();

    std::vector<double> inputs;
    lagrangian.assembler.loop(
        set, fields, {}, Order::hessian,
        [&](const Cell &cell, const Element &element, const auto &)
        {
          ASSERT_EQ(element.n_rows, n_rows);
          gather_inputs(tables, cell.nodes, lagrangian.layout, fields, inputs);
          std::vector<double> gradient(n_rows, 0.), matrix(n_rows * n_rows, 0.);
          for (unsigned int q = 0; q < tables.n_points; ++q)
          {
            std::vector<double> g(n, 0.), h(n * n, 0.);
            bending.add_automatic(&inputs[q * n], offsets.data(), PointData{q}, 1., Order::hessian, n, g.data(),
                                  h.data());
            // d input_i / d (value of row): only within the same field.
            std::vector<double> d(n * n_rows, 0.);
            for (unsigned int f = 0; f < 2; ++f)
              for (unsigned int s = 0; s < 3; ++s)
                for (unsigned int b = 0; b < 3; ++b)
                  for (unsigned int c = 0; c < 3; ++c)
                    for (std::size_t I = 0; I < surface.n_local(); ++I)
                      d[(offsets[f] + 3 * s + b) * n_rows + (3 * f + c) * surface.n_local() + I] =
                          tables.map[s][3 * b + c] * tables.tables[s][q * surface.n_local() + I];
            for (std::size_t row = 0; row < n_rows; ++row)
              for (unsigned int i = 0; i < n; ++i)
              {
                gradient[row] += tables.weights[q] * g[i] * d[i * n_rows + row];
                if (d[i * n_rows + row] != 0.)
                  for (unsigned int j = 0; j < n; ++j)
                    for (std::size_t column = 0; column < n_rows; ++column)
                      matrix[row * n_rows + column] +=
                          tables.weights[q] * h[i * n + j] * d[i * n_rows + row] * d[j * n_rows + column];
              }
          }
          for (std::size_t k = 0; k < n_rows; ++k)
            EXPECT_NEAR(element.gradient[k], gradient[k], 1e-11) << name;
          for (std::size_t k = 0; k < n_rows * n_rows; ++k)
          {
            EXPECT_NEAR(element.matrix[k], matrix[k], 1e-11) << name;
            EXPECT_EQ(element.matrix[k], element.matrix[k % n_rows * n_rows + k / n_rows]) << name;
          }
        });
  }
}

TEST(Assembler, WhatIsNotListedCostsNothing)
{
  const auto surface = on_cube_sphere(ellipsoid({{1.1, 0.9, 1.3}}), 2, 1);
  Communicator communicator;
  Timing timing;
  const auto problem_with = [&](const std::vector<std::string> &effects)
  {
    return SurfaceProblem(surface, make_vesicle_scene(standard_effects(), effects, {}).potentials(Scales{}), {},
                          communicator, "mumps", timing);
  };

  SurfaceProblem drop = problem_with({"surface tension", "volume constraint"});
  drop.use_chart(PositionChart::graph, surface.positions);
  drop.linearize();
  EXPECT_FALSE(drop.layout().has("moment"));
  EXPECT_EQ(drop.layout().n_inputs(), 9u);
  const std::vector<const AssemblyCounters *> counters = drop.counters();
  ASSERT_EQ(counters.size(), 2u);
  EXPECT_EQ(counters[0]->loops, 2u); // values of the start, then the matrix
  EXPECT_EQ(counters[0]->cells, 2 * surface.n_cells);
  EXPECT_EQ(counters[0]->potential_calls, 2 * 2 * surface.n_cells);
  EXPECT_EQ(counters[1]->loops, 0u);
  EXPECT_EQ(counters[1]->cells, 0u);
  EXPECT_EQ(counters[1]->potential_calls, 0u);

  SurfaceProblem vesicle = problem_with({"helfrich bending", "surface tension", "volume constraint"});
  EXPECT_TRUE(vesicle.layout().has("moment"));
  EXPECT_EQ(vesicle.counters()[0]->potential_calls, 3 * vesicle.counters()[0]->cells);
  // The elimination of the moment sees bending only.
  EXPECT_GT(vesicle.counters()[1]->loops, 0u);
  EXPECT_EQ(vesicle.counters()[1]->potential_calls, vesicle.counters()[1]->cells);
}

TEST(Assembler, NoUnknownsOfWhatIsNotListed)
{
  Communicator communicator;
  Timing timing;
  const auto names = [&](const std::vector<std::string> &effects)
  {
    VesicleScene scene     = make_vesicle_scene(standard_effects(), effects, {});
    scene.mesh.degree      = 2;
    scene.mesh.refinements = 0;
    scene.newton.chart     = "graph";
    SurfaceModel model(scene, communicator, timing);
    Observer nobody;
    model.solve(0, nobody);
    std::string result;
    for (const auto &[name, count] : model.unknown_counts())
      result += name + " " + std::to_string(count) + ", ";
    return result;
  };
  // 26 nodes of six cells of degree 2.
  EXPECT_EQ(names({"surface tension", "volume constraint"}).find("moment"), std::string::npos);
  EXPECT_NE(names({"surface tension", "volume constraint"}).find("position 26, multipliers 1"), std::string::npos)
      << names({"surface tension", "volume constraint"});
  EXPECT_NE(names({"helfrich bending", "volume constraint"}).find("moment 78"), std::string::npos)
      << names({"helfrich bending", "volume constraint"});
}

TEST(NodalChart, NormalsAndAreasOfASphere)
{
  const SmoothShape sphere                                             = ellipsoid({{2., 2., 2.}});
  const std::vector<std::pair<SurfaceDiscretization, double>> surfaces = {{on_cube_sphere(sphere, 3, 2), 16. * pi},
                                                                          {on_meridian(sphere, 3, 3, false), 16. * pi},
                                                                          {on_meridian(sphere, 3, 2, true), 16. * pi}};
  for (const auto &[surface, area] : surfaces)
  {
    const NodalVectors normals      = nodal_normals(surface, surface.positions);
    const std::vector<double> areas = nodal_areas(surface, surface.positions);
    double sum                      = 0.;
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
    {
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(normals[3 * I + c], surface.positions[3 * I + c] / 2., 2e-3);
      EXPECT_GT(areas[I], 0.);
      sum += areas[I];
    }
    EXPECT_NEAR(sum, area, 1e-4 * area);
  }
}

TEST(NodalChart, PolesAndMirrorPlane)
{
  const SmoothShape shape = ellipsoid({{0.7, 0.7, 1.4}});
  const auto whole = on_meridian(shape, 3, 2, false), half = on_meridian(shape, 3, 2, true);
  const auto normal = [](const SurfaceDiscretization &surface, const bool last)
  {
    const NodalVectors normals = nodal_normals(surface, surface.positions);
    double extreme             = last ? 1e9 : -1e9;
    std::size_t node           = 0;
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
      if (const double z = surface.positions[3 * I + 2]; last ? z < extreme : z > extreme)
      {
        extreme = z;
        node    = I;
      }
    return Vector3<double>(normals[3 * node], normals[3 * node + 1], normals[3 * node + 2]);
  };
  EXPECT_EQ(pellicle::norm(normal(whole, false) - Vector3<double>(0., 0., 1.)), 0.);
  EXPECT_EQ(pellicle::norm(normal(whole, true) - Vector3<double>(0., 0., -1.)), 0.);
  EXPECT_EQ(pellicle::norm(normal(half, false) - Vector3<double>(0., 0., 1.)), 0.);
  EXPECT_EQ(pellicle::norm(normal(half, true) - Vector3<double>(1., 0., 0.)), 0.);
}

using Dense = std::vector<std::vector<double>>;

Dense dense(const SparseMatrix &matrix)
{
  Dense result(matrix.size, std::vector<double>(matrix.size, 0.));
  for (int i = 0; i < matrix.size; ++i)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
    {
      result[i][matrix.columns[k]] = matrix.values[k];
      if (matrix.symmetry == MatrixSymmetry::symmetric)
        result[matrix.columns[k]][i] = matrix.values[k];
    }
  return result;
}

/** Builds K, the constraint gradients and the residual in R^3, multiplies with a dense Z, and compares everything. */
void check_bordered_system(const SurfaceDiscretization &surface, const bool ale, const std::string &what)
{
  Lagrangian physics(surface, all_terms());
  const FieldValues fields = physics.rough_fields();
  PotentialSet mesh_set;
  mesh_set.energies.push_back(make_mesh_distortion(reference_metric(surface, surface.positions)));
  Lagrangian mesh(surface, mesh_set);

  const NodalVectors normals = nodal_normals(surface, fields[0]);
  BorderedSystem system(
      surface,
      Numbering({ale ? ale_chart(surface, fields[0], normals) : graph_chart(surface, fields[0], normals),
                 free_chart(surface)},
                2, 1),
      physics.communicator);
  const Numbering &numbering = system.numbering();
  const std::size_t n = numbering.n_nodal, m = 3 * surface.n_nodes;
  EXPECT_EQ(numbering.size(), n + 3);

  // Step 1: dense matrices in R^3, field after field
  Dense K(2 * m, std::vector<double>(2 * m, 0.)),
      K_mesh = K, gradient(5, std::vector<double>(2 * m, 0.)); // r, mesh r, g0, g1, rigid
  system.begin();
  TermValues mesh_values{{0.}, {}, {}, {}};
  Element mesh_element;
  std::vector<std::vector<double>> none;
  physics.assembler.loop(
      physics.set, fields, physics.multipliers, Order::hessian,
      [&](const Cell &cell, const Element &element, const auto &g)
      {
        mesh.assembler.evaluate(mesh_set, {fields[0]}, {}, Order::hessian, cell, mesh_values, mesh_element, none);
        system.add_cell(cell, element, g, ale ? &mesh_element : nullptr);
        physics.for_rows(cell,
                         [&](const std::size_t f, const std::size_t i, const std::size_t row)
                         {
                           gradient[0][f * m + i] += element.gradient[row];
                           for (int k = 0; k < 2; ++k)
                             gradient[2 + k][f * m + i] += g[k][row];
                           physics.for_rows(cell,
                                            [&](const std::size_t e, const std::size_t j, const std::size_t column) {
                                              K[f * m + i][e * m + j] += element.matrix[row * element.n_rows + column];
                                            });
                         });
        mesh.for_rows(cell,
                      [&](const std::size_t, const std::size_t i, const std::size_t row)
                      {
                        gradient[1][i] += mesh_element.gradient[row];
                        mesh.for_rows(cell, [&](const std::size_t, const std::size_t j, const std::size_t column)
                                      { K_mesh[i][j] += mesh_element.matrix[row * mesh_element.n_rows + column]; });
                      });
      });
  const NodalVectors rigid = random_vectors(surface, 1., 77);
  std::copy(rigid.begin(), rigid.end(), gradient[4].begin());
  system.set_constraint(0, 0., 0.25);
  system.set_constraint(1, 0.125, -0.5);
  system.set_rigid_motion(0, rigid, 1e-2, 0.75);
  system.finish();

  // Step 2: Z, and which of its columns have mesh equations
  Dense Z(2 * m, std::vector<double>(n, 0.));
  std::vector<bool> is_mesh(n, false);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
    for (std::size_t f = 0; f < 2; ++f)
      for (unsigned int a = 0; a < numbering.count(f, I); ++a)
      {
        const std::size_t unknown = numbering.first[2 * I + f] + a;
        is_mesh[unknown]          = numbering.charts[f].nodes[I].mesh_equation[a];
        for (unsigned int c = 0; c < 3; ++c)
          Z[f * m + 3 * I + c][unknown] = numbering.charts[f].nodes[I].columns[3 * a + c];
      }
  const auto restricted = [&](const std::vector<double> &v, const std::size_t unknown)
  {
    double result = 0.;
    for (std::size_t i = 0; i < 2 * m; ++i)
      result += Z[i][unknown] * v[i];
    return result;
  };

  // Step 3: comparison
  const Dense matrix = dense(system.matrix());
  EXPECT_EQ(system.matrix().symmetry, ale ? MatrixSymmetry::general : MatrixSymmetry::symmetric);
  for (std::size_t b = 0; b < n; ++b)
  {
    std::vector<double> KZ(2 * m, 0.), MZ(2 * m, 0.);
    for (std::size_t i = 0; i < 2 * m; ++i)
      for (std::size_t j = 0; j < 2 * m; ++j)
      {
        KZ[i] += K[i][j] * Z[j][b];
        MZ[i] += K_mesh[i][j] * Z[j][b];
      }
    for (std::size_t a = 0; a < n; ++a)
      EXPECT_NEAR(matrix[a][b], restricted(is_mesh[a] ? MZ : KZ, a), 1e-10) << what << " at " << a << ", " << b;
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(matrix[n + k][b], restricted(gradient[2 + k], b), 1e-12) << what;
      EXPECT_NEAR(matrix[b][n + k], is_mesh[b] ? 0. : restricted(gradient[2 + k], b), 1e-12) << what;
      EXPECT_NEAR(system.constraint_gradient(k)[b], restricted(gradient[2 + k], b), 1e-12) << what;
    }
    EXPECT_NEAR(matrix[n + 2][b], restricted(gradient[4], b), 1e-12) << what;
    EXPECT_NEAR(matrix[b][n + 2], restricted(gradient[4], b), 1e-12) << what;
    EXPECT_NEAR(system.residual()[b], restricted(gradient[is_mesh[b] ? 1 : 0], b) + 0.75 * restricted(gradient[4], b),
                1e-11)
        << what;
  }
  EXPECT_EQ(matrix[n][n], 0.);
  EXPECT_EQ(matrix[n + 1][n + 1], -0.125);
  EXPECT_EQ(matrix[n + 2][n + 2], -1e-2);
  EXPECT_EQ(matrix[n][n + 1], 0.);
  EXPECT_EQ(system.residual()[n], 0.25);
  EXPECT_EQ(system.residual()[n + 1], -0.5);
  EXPECT_GE(system.contribution_norm(), 0.);

  // Step 4: prolongation is Z u
  std::vector<double> u(n);
  for (std::size_t i = 0; i < n; ++i)
    u[i] = std::sin(1. + static_cast<double>(i));
  NodalVectors moved(m, 0.);
  system.prolongate(u, 2., 0, moved);
  for (std::size_t i = 0; i < m; ++i)
  {
    double wanted = 0.;
    for (std::size_t j = 0; j < n; ++j)
      wanted += 2. * Z[i][j] * u[j];
    EXPECT_NEAR(moved[i], wanted, 1e-14) << what;
  }
}

TEST(BorderedSystem, GraphChart)
{
  for (const auto &[name, surface] : small_surfaces())
    check_bordered_system(surface, false, name);
}

TEST(BorderedSystem, AleChart)
{
  for (const auto &[name, surface] : small_surfaces())
    check_bordered_system(surface, true, name);
}

TEST(BorderedSystem, AleColumnsAreOrthonormal)
{
  for (const auto &[name, surface] : small_surfaces())
  {
    const NodalChart chart = ale_chart(surface, surface.positions, nodal_normals(surface, surface.positions));
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
    {
      const NodalChart::Node &node = chart.nodes[I];
      EXPECT_EQ(node.count, surface.admissible.empty() ? 3u : surface.admissible[I].count) << name;
      for (unsigned int a = 0; a < node.count; ++a)
      {
        EXPECT_EQ(node.mesh_equation[a], a > 0);
        for (unsigned int b = 0; b < node.count; ++b)
        {
          double product = 0.;
          for (unsigned int c = 0; c < 3; ++c)
            product += node.columns[3 * a + c] * node.columns[3 * b + c];
          EXPECT_NEAR(product, a == b ? 1. : 0., 1e-14) << name;
        }
      }
    }
  }
}
} // namespace
