// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/cells.h>
#include <pellicle/assembly/contraction.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace pellicle
{
/** What a loop over the cells did: shows that effects that are not listed cost nothing. Of this process, since
 * construction. */
struct AssemblyCounters
{
  std::size_t loops           = 0; ///< over the cells
  std::size_t cells           = 0; ///< visited
  std::size_t potential_calls = 0; ///< one per potential or constraint and cell
};

/** Values of the listed terms, summed over all cells of all processes. */
struct TermValues
{
  std::vector<double> energies;    ///< in the order of PotentialSet::energies
  std::vector<double> constraints; ///< g - lambda r, in the order of PotentialSet::constraints
  std::vector<double> compliances; ///< r of each constraint, see Constraint::self_term
  std::vector<double> pairs;       ///< energies of pair terms, which the assembler does not know
  /** dt D of the time step, in the order of PotentialSet::dissipations; zero without a step. */
  std::vector<double> dissipations = {};
};

/**
 * The loop over cells, of the surface, its edge loops and bodies: gathers nodal values, forms the inputs of points,
 * lets potentials and constraints add, contracts. Works in plain R^3 and knows neither charts nor matrices; what a cell
 * yields is handed to a visitor. Sets of cells on which nothing acts are not visited.
 */
class Assembler
{
public:
  /** Potentials and constraints that take part, by their indices in the set; and the fields whose derivatives are
   * wanted. */
  struct Selection
  {
    std::vector<std::size_t> energies, constraints, dissipations;
    std::vector<bool> fields;
  };

  /** All terms, all fields. */
  static Selection everything(const PotentialSet &set, const FieldLayout &layout);
  /** The terms that declare internal fields, and the derivatives with respect to these fields. */
  static Selection internal(const PotentialSet &set, const FieldLayout &layout);

  /** `set` may change its numbers from call to call, but not its terms. Asserts that the parts of the surface on which
   * its potentials act exist. */
  Assembler(const SurfaceDiscretization &discretization, const FieldLayout &layout, const PotentialSet &set,
            const Communicator &communicator, const Selection &selection);

  /** element: derivatives of energies + dissipations over the step + multipliers . constraints;
   * constraint_gradients[k]: of g_k - lambda_k r_k alone, rows as in Element. */
  using Visitor = std::function<void(const Cell &cell, const Element &element,
                                     const std::vector<std::vector<double>> &constraint_gradients)>;

  /** One loop over the cells of this process. Returns the values of the selected terms (others zero). */
  TermValues loop(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers,
                  Order order, const Visitor &visitor = {});

  /** One cell of such a loop; adds the values of its terms to `values_of_terms`. */
  void evaluate(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers, Order order,
                const Cell &cell, TermValues &values_of_terms, Element &element,
                std::vector<std::vector<double>> &constraint_gradients);

  const AssemblyCounters &counters() const { return counts; }

private:
  /** A term where it acts: its index in the list, and the offsets of its fields. */
  struct Term
  {
    static constexpr unsigned int all_regions = static_cast<unsigned int>(-1);

    std::size_t index   = 0;
    unsigned int region = all_regions;
    std::size_t part    = 0;                         ///< of a constraint
    std::vector<unsigned int> offsets, self_offsets; ///< of the potential; of a constraint's self term
  };
  /** What acts on one set of cells. */
  struct Work
  {
    std::vector<Term> energies, constraints, dissipations;
    std::unique_ptr<Contraction> contraction;
  };

  void place(const Potential &potential, Term term, std::vector<Term> Work::*list);
  bool acts(const Term &term, const Cell &cell) const;

  const SurfaceDiscretization &discretization;
  const FieldLayout &layout;
  const Communicator &communicator;
  std::vector<Cell> cells;
  std::vector<Work> work; ///< by set of cells
  AssemblyCounters counts;
  std::vector<double> inputs; // of the points of one cell
  PointSums total, single;
};

/** Inputs of all points of one cell for all fields of a layout: inputs[q * n_inputs + offset + 3 s + c]. */
void gather_inputs(const ShapeTables &tables, const std::size_t *nodes, const FieldLayout &layout,
                   const FieldValues &values, std::vector<double> &inputs);
} // namespace pellicle
