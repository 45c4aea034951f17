// SPDX-License-Identifier: LGPL-2.1-or-later
// An effect that a scene does not list leaves no field, no loop and no matrix entries.
#include "effect_cases.h"

#include <pellicle/assembly/cell_loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** What there is to be seen of a scene's effects once its system has been built. */
struct Built
{
  Names fields, terms, inequalities;
  std::vector<int> row_start, columns; ///< of the matrix
  std::size_t unknowns = 0, calls = 0, calls_of_a_loop = 0, loops = 0;
};

Built build(const EffectCases &family, const EffectCase &of, const EffectLibrary &library, const Names &effects)
{
  const std::unique_ptr<SurfaceScene> scene = family.make(library, effects);
  if (of.change)
    of.change(*scene);
  scene->newton.max_iterations = 1;
  Communicator communicator;
  Timing timing;
  Record record;
  SurfaceModel model(*scene, communicator, timing);
  model.solve(0, record); // one iteration: it need not converge, nor need there be an equilibrium

  const SurfaceProblem &problem     = model.equilibrium();
  const std::vector<CellLoop> loops = cell_loops(problem.discretization(), problem.potentials());
  Built built;
  for (const Field &field : problem.layout().fields())
    built.fields.push_back(field.name);
  for (const CellLoop &loop : loops)
    for (const LoopTerm &term : loop.terms)
      built.terms.push_back(loop.over + ": " + kind_name(term.kind) + " '" + term.name + "'" +
                            (term.region.empty() ? "" : " on region '" + term.region + "'"));
  for (const auto &inequality : model.inequalities())
    built.inequalities.push_back(inequality->name());
  built.row_start                  = problem.matrix().row_start;
  built.columns                    = problem.matrix().columns;
  built.unknowns                   = problem.numbering().size();
  const AssemblyCounters &counters = *problem.counters()[0];
  built.calls                      = counters.potential_calls;
  built.loops                      = counters.loops;
  built.calls_of_a_loop            = potential_calls(loops, problem.discretization());
  return built;
}

EffectLibrary without(const EffectLibrary &library, const std::string &effect)
{
  EffectLibrary rest("effect");
  for (const std::string &name : library.names())
    if (name != effect)
      rest.add(name, [&library, name] { return library.create(name); });
  return rest;
}

Names sorted(Names names)
{
  std::sort(names.begin(), names.end());
  return names;
}

Names added(const Names &with, const Names &without_it)
{
  const Names more = sorted(with), fewer = sorted(without_it);
  Names result;
  std::set_difference(more.begin(), more.end(), fewer.begin(), fewer.end(), std::back_inserter(result));
  return result;
}

class EffectsLeftOut : public testing::TestWithParam<EffectCases (*)()>
{
};

TEST_P(EffectsLeftOut, AreNowhere)
{
  const EffectCases family = GetParam()();
  for (const EffectCase &of : family.cases)
  {
    SCOPED_TRACE(of.effect);
    Names all = of.beside;
    all.push_back(of.effect);
    const Built with = build(family, of, family.library, all), left_out = build(family, of, family.library, of.beside),
                unheard_of = build(family, of, without(family.library, of.effect), of.beside);

    EXPECT_EQ(added(with.fields, left_out.fields), sorted(of.fields));
    EXPECT_EQ(added(with.terms, left_out.terms), sorted(of.terms));
    EXPECT_EQ(added(with.inequalities, left_out.inequalities), sorted(of.inequalities));

    EXPECT_EQ(left_out.fields, unheard_of.fields);
    EXPECT_EQ(left_out.terms, unheard_of.terms);
    EXPECT_EQ(left_out.unknowns, unheard_of.unknowns);
    EXPECT_EQ(left_out.row_start, unheard_of.row_start);
    EXPECT_EQ(left_out.columns, unheard_of.columns);

    // The list of loops is what the assembler really visits, and each term is called once a cell.
    for (const Built *built : {&with, &left_out})
    {
      EXPECT_GT(built->loops, 0u);
      EXPECT_EQ(built->calls, built->loops * built->calls_of_a_loop);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, EffectsLeftOut,
                         testing::Values(vesicle_cases, droplet_cases, ridge_cases, director_cases, shell_cases));

// An effect without a case would be an effect without a proof.
TEST(EffectCasesList, HasEveryEffectOfEveryLibrary)
{
  for (const auto &families : {std::vector<EffectCases>{vesicle_cases()}, std::vector<EffectCases>{droplet_cases()},
                               std::vector<EffectCases>{ridge_cases()},
                               std::vector<EffectCases>{vesicle_cases(), director_cases(), shell_cases()}})
  {
    Names cases;
    for (const EffectCases &family : families)
      for (const EffectCase &of : family.cases)
        cases.push_back(of.effect);
    EXPECT_EQ(sorted(cases), sorted(families.back().library.names()));
  }
}
} // namespace
