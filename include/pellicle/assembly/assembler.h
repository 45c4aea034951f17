// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
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
  std::vector<double> constraints; ///< g, in the order of PotentialSet::constraints
};

/**
 * The loop over cells: gathers nodal values, forms the inputs of points, lets potentials and constraints add,
 * contracts. Works in plain R^3 and knows neither charts nor matrices; what a cell yields is handed to a visitor.
 */
class Assembler
{
public:
  /** Potentials and constraints that take part, by their indices in the set; and the fields whose derivatives are
   * wanted. */
  struct Selection
  {
    std::vector<std::size_t> energies, constraints;
    std::vector<bool> fields;
  };

  /** All terms, all fields. */
  static Selection everything(const PotentialSet &set, const FieldLayout &layout);
  /** The terms that declare internal fields, and the derivatives with respect to these fields. */
  static Selection internal(const PotentialSet &set, const FieldLayout &layout);

  Assembler(const SurfaceDiscretization &discretization, const FieldLayout &layout, const Communicator &communicator,
            Selection selection);

  /** element: derivatives of energies + multipliers . constraints; constraint_gradients[k]: of g_k alone, rows as in
   * Element. */
  using Visitor = std::function<void(std::size_t cell, const Element &element,
                                     const std::vector<std::vector<double>> &constraint_gradients)>;

  /** One loop over the cells of this process. Returns the values of the selected terms (others zero). */
  TermValues loop(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers,
                  Order order, const Visitor &visitor = {});

  /** One cell of such a loop; adds the values of its terms to `values_of_terms`. */
  void evaluate(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers, Order order,
                std::size_t cell, TermValues &values_of_terms, Element &element,
                std::vector<std::vector<double>> &constraint_gradients);

  const AssemblyCounters &counters() const { return counts; }

private:
  const SurfaceDiscretization &discretization;
  const FieldLayout &layout;
  const Communicator &communicator;
  Selection selection;
  Contraction contraction;
  AssemblyCounters counts;
  std::vector<double> inputs; // of the points of one cell
  PointSums total, single;
};

/** Inputs of all points of one cell for all fields of a layout: inputs[q * n_inputs + offset + 3 s + c]. */
void gather_inputs(const SurfaceDiscretization &discretization, const FieldLayout &layout, const FieldValues &values,
                   std::size_t cell, std::vector<double> &inputs);
} // namespace pellicle
