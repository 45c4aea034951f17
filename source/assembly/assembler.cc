// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/assembler.h>

#include <algorithm>
#include <numeric>

namespace pellicle
{
namespace
{
bool declares_internal(const Potential &potential)
{
  const std::vector<FieldUse> uses = potential.fields();
  return std::any_of(uses.begin(), uses.end(), [](const FieldUse &use) { return use.role == FieldRole::internal; });
}
} // namespace

Assembler::Selection Assembler::everything(const PotentialSet &set, const FieldLayout &layout)
{
  Selection all;
  all.energies.resize(set.energies.size());
  all.constraints.resize(set.constraints.size());
  std::iota(all.energies.begin(), all.energies.end(), 0);
  std::iota(all.constraints.begin(), all.constraints.end(), 0);
  all.fields.assign(layout.fields().size(), true);
  return all;
}

Assembler::Selection Assembler::internal(const PotentialSet &set, const FieldLayout &layout)
{
  Selection some;
  for (std::size_t k = 0; k < set.energies.size(); ++k)
    if (declares_internal(*set.energies[k]))
      some.energies.push_back(k);
  for (std::size_t k = 0; k < set.constraints.size(); ++k)
    if (declares_internal(*set.constraints[k].measure))
      some.constraints.push_back(k);
  for (const Field &field : layout.fields())
    some.fields.push_back(field.role == FieldRole::internal);
  return some;
}

Assembler::Assembler(const SurfaceDiscretization &discretization, const FieldLayout &layout,
                     const Communicator &communicator, Selection selection)
    : discretization(discretization)
    , layout(layout)
    , communicator(communicator)
    , selection(std::move(selection))
    , contraction(discretization.tables, layout, this->selection.fields)
{
}

void gather_inputs(const SurfaceDiscretization &discretization, const FieldLayout &layout, const FieldValues &values,
                   const std::size_t cell, std::vector<double> &inputs)
{
  const ShapeTables &tables = discretization.tables;
  const std::size_t *nodes  = discretization.cell_nodes.data() + cell * tables.n_nodes;
  std::vector<double> one_field(std::size_t(tables.n_points) * 18);
  inputs.resize(std::size_t(tables.n_points) * layout.n_inputs());
  for (std::size_t f = 0; f < layout.fields().size(); ++f)
  {
    const Field &field = layout.fields()[f];
    evaluate_field(tables, nodes, values[f], field.n_slots, one_field.data());
    for (unsigned int q = 0; q < tables.n_points; ++q)
      std::copy_n(one_field.data() + 18 * q, 3 * field.n_slots,
                  inputs.data() + std::size_t(q) * layout.n_inputs() + field.offset);
  }
}

TermValues Assembler::loop(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers,
                           const Order order, const Visitor &visitor)
{
  TermValues result{std::vector<double>(set.energies.size(), 0.), std::vector<double>(set.constraints.size(), 0.)};
  Element element;
  std::vector<std::vector<double>> constraint_gradients(set.constraints.size());

  ++counts.loops;
  const auto [first, last] = communicator.own_range(discretization.n_cells);
  for (std::size_t cell = first; cell < last; ++cell)
  {
    evaluate(set, values, multipliers, order, cell, result, element, constraint_gradients);
    if (visitor)
      visitor(cell, element, constraint_gradients);
  }

  std::vector<double> sums = result.energies;
  sums.insert(sums.end(), result.constraints.begin(), result.constraints.end());
  communicator.sum(sums);
  std::copy_n(sums.begin(), result.energies.size(), result.energies.begin());
  std::copy(sums.begin() + static_cast<std::ptrdiff_t>(result.energies.size()), sums.end(), result.constraints.begin());
  return result;
}

void Assembler::evaluate(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers,
                         const Order order, const std::size_t cell, TermValues &values_of_terms, Element &element,
                         std::vector<std::vector<double>> &constraint_gradients)
{
  const ShapeTables &tables = discretization.tables;
  const auto integral       = [&](const PointSums &sums)
  { return std::inner_product(sums.value.begin(), sums.value.end(), tables.weights.begin(), 0.); };
  ++counts.cells;
  gather_inputs(discretization, layout, values, cell, inputs);
  const CellPoints points{cell * tables.n_points, tables.n_points, layout.n_inputs(), inputs.data()};
  total.reset(tables.n_points, layout.n_inputs(), order);

  double before = 0.;
  for (const std::size_t k : selection.energies)
  {
    ++counts.potential_calls;
    set.energies[k]->add(points, layout.offsets(*set.energies[k]).data(), 1., order, total);
    const double after = integral(total);
    values_of_terms.energies[k] += after - before;
    before = after;
  }
  for (const std::size_t k : selection.constraints)
  {
    ++counts.potential_calls;
    const Potential &measure                = *set.constraints[k].measure;
    const std::vector<unsigned int> offsets = layout.offsets(measure);
    single.reset(tables.n_points, layout.n_inputs(), std::min(order, Order::gradient));
    measure.add(points, offsets.data(), 1., std::min(order, Order::gradient), single);
    values_of_terms.constraints[k] += integral(single);
    if (order >= Order::gradient)
    {
      contraction.gradient(single, constraint_gradients[k]);
      measure.add(points, offsets.data(), multipliers[k], order, total);
    }
  }
  element.n_rows = contraction.n_rows();
  if (order >= Order::gradient)
    contraction.gradient(total, element.gradient);
  if (order == Order::hessian)
    contraction.matrix(total, element.matrix);
}
} // namespace pellicle
