// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/field_mass.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/models/stability.h>
#include <pellicle/solvers/eigenvalues.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
void StabilityParameters::bind(ParameterSection &section)
{
  section.integer("Eigenvalues", eigenvalues, 0, 100,
                  "Number of lowest eigenvalues of the second variation to compute where Analyses lists stability, in "
                  "energy per length^4 (second variation of a displacement of unit L2 norm; of directors on a held "
                  "surface: energy per length^2). Their modes are written to "
                  "the VTU files.");
  section.flag("Follow unstable mode", follow_unstable_mode,
               "Where an equilibrium has a negative eigenvalue: go downhill along its mode, to a stable one.");
}

std::optional<Stability> analyse_stability(SurfaceProblem &problem, LinearSolver &solver,
                                           const unsigned int n_eigenvalues)
{
  problem.use_chart(problem.needs_material_chart() ? PositionChart::material : PositionChart::graph,
                    problem.state().fields[0]);
  problem.linearize();
  solver.factorize(problem.matrix());
  const std::optional<Inertia> inertia = solver.inertia();
  if (!inertia)
    return std::nullopt;
  Stability result;
  result.negative_eigenvalues = inertia->negative - problem.expected_negative_pivots();
  if (n_eigenvalues == 0)
    return result;

  constexpr double scale = 1.; // of eigenvalues, internal units
  result.field           = problem.field_that_moves();
  const SparseMatrix mass =
      field_mass(problem.discretization(), problem.state().fields[0], problem.numbering(), result.field);
  Eigenpairs pairs;
  try
  {
    pairs = lowest_eigenpairs(problem.matrix(), mass, solver, problem.expected_negative_pivots(), n_eigenvalues, scale);
  }
  catch (const SolveError &error)
  {
    result.failure = error.what(); // the count stands, and so does the equilibrium
    return result;
  }
  result.lowest = pairs.values;
  for (const std::vector<double> &vector : pairs.vectors)
  {
    NodalVectors mode  = problem.displacements(vector, result.field);
    const auto largest = std::max_element(mode.begin(), mode.end(),
                                          [](const double a, const double b) { return std::abs(a) < std::abs(b); });
    if (*largest < 0.)
      for (double &component : mode)
        component = -component;
    result.modes.push_back(std::move(mode));
  }
  return result;
}
} // namespace pellicle
