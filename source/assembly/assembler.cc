// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/assembler.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>
#include <numeric>
#include <utility>

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
  all.dissipations.resize(set.dissipations.size());
  std::iota(all.energies.begin(), all.energies.end(), 0);
  std::iota(all.dissipations.begin(), all.dissipations.end(), 0);
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

Assembler::Assembler(const SurfaceDiscretization &discretization, const FieldLayout &layout, const PotentialSet &set,
                     const Communicator &communicator, const Selection &selection)
    : discretization(discretization)
    , layout(layout)
    , communicator(communicator)
    , work(n_sets(discretization))
{
  for (const std::size_t k : selection.energies)
    place(*set.energies[k], {k, Term::all_regions, 0, layout.offsets(*set.energies[k]), {}}, &Work::energies);
  for (const std::size_t k : selection.dissipations)
  {
    const Potential &over_step = *set.dissipations[k].over_step;
    place(over_step, {k, Term::all_regions, 0, layout.offsets(over_step), {}}, &Work::dissipations);
  }
  for (const std::size_t k : selection.constraints)
  {
    const Constraint &constraint = set.constraints[k];
    for (std::size_t p = 0; p < constraint.n_parts(); ++p)
      place(constraint.part(p),
            {k, Term::all_regions, p, layout.offsets(constraint.part(p)),
             constraint.self_term ? layout.offsets(*constraint.self_term) : std::vector<unsigned int>{}},
            &Work::constraints);
  }
  for (std::size_t s = 0; s < work.size(); ++s)
    if (!work[s].energies.empty() || !work[s].constraints.empty() || !work[s].dissipations.empty())
      work[s].contraction = std::make_unique<Contraction>(tables_of(discretization, s), layout, selection.fields);
  for (const Cell &cell : own_cells(discretization, communicator))
    if (work[cell.set].contraction)
      cells.push_back(cell);
}

void Assembler::place(const Potential &potential, Term term, std::vector<Term> Work::*list)
{
  const Where &where = potential.where();
  if (where.part == Where::Part::region)
  {
    const auto &names = discretization.region_names;
    const auto found  = std::find(names.begin(), names.end(), where.name);
    PELLICLE_ASSERT(found != names.end(), "a potential acts on a region that this surface does not have");
    term.region = static_cast<unsigned int>(found - names.begin());
  }
  (work[set_of(discretization, where)].*list).push_back(std::move(term));
}

bool Assembler::acts(const Term &term, const Cell &cell) const
{
  return term.region == Term::all_regions || term.region == discretization.cell_region[cell.index];
}

void gather_inputs(const ShapeTables &tables, const std::size_t *nodes, const FieldLayout &layout,
                   const FieldValues &values, std::vector<double> &inputs)
{
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
  TermValues result{std::vector<double>(set.energies.size(), 0.),
                    std::vector<double>(set.constraints.size(), 0.),
                    std::vector<double>(set.constraints.size(), 0.),
                    {},
                    std::vector<double>(set.dissipations.size(), 0.)};
  Element element;
  std::vector<std::vector<double>> constraint_gradients(set.constraints.size());

  ++counts.loops;
  for (const Cell &cell : cells)
  {
    evaluate(set, values, multipliers, order, cell, result, element, constraint_gradients);
    if (visitor)
      visitor(cell, element, constraint_gradients);
  }

  std::vector<double> sums;
  for (std::vector<double> *list : {&result.energies, &result.constraints, &result.compliances, &result.dissipations})
    sums.insert(sums.end(), list->begin(), list->end());
  communicator.sum(sums);
  auto next = sums.begin();
  for (std::vector<double> *list : {&result.energies, &result.constraints, &result.compliances, &result.dissipations})
    for (double &value : *list)
      value = *next++;
  return result;
}

void Assembler::evaluate(const PotentialSet &set, const FieldValues &values, const std::vector<double> &multipliers,
                         const Order order, const Cell &cell, TermValues &values_of_terms, Element &element,
                         std::vector<std::vector<double>> &constraint_gradients)
{
  const ShapeTables &tables = tables_of(discretization, cell.set);
  Work &here                = work[cell.set];
  const auto integral       = [&](const PointSums &sums)
  { return std::inner_product(sums.value.begin(), sums.value.end(), tables.weights.begin(), 0.); };
  ++counts.cells;
  gather_inputs(tables, cell.nodes, layout, values, inputs);
  const bool has_regions = cell.set == 0 && !discretization.cell_region.empty();
  const CellPoints points{cell.index * tables.n_points, tables.n_points, layout.n_inputs(), inputs.data(),
                          has_regions ? discretization.cell_region[cell.index] : 0};
  total.reset(tables.n_points, layout.n_inputs(), order);

  double before       = 0.;
  const auto add_term = [&](const Term &term, const Potential &potential, double &value)
  {
    if (!acts(term, cell))
      return;
    ++counts.potential_calls;
    potential.add(points, term.offsets.data(), 1., order, total);
    const double after = integral(total);
    value += after - before;
    before = after;
  };
  for (const Term &term : here.energies)
    add_term(term, *set.energies[term.index], values_of_terms.energies[term.index]);
  for (const Term &term : here.dissipations)
    add_term(term, *set.dissipations[term.index].over_step, values_of_terms.dissipations[term.index]);
  for (std::vector<double> &gradient : constraint_gradients)
    gradient.clear();
  const Order at_most_gradient = std::min(order, Order::gradient);
  for (const Term &term : here.constraints)
  {
    if (!acts(term, cell))
      continue;
    ++counts.potential_calls;
    const Constraint &constraint = set.constraints[term.index];
    const Potential &measure     = constraint.part(term.part);
    const double lambda          = multipliers[term.index];
    single.reset(tables.n_points, layout.n_inputs(), at_most_gradient);
    measure.add(points, term.offsets.data(), 1., at_most_gradient, single);
    const double measured = integral(single);
    values_of_terms.constraints[term.index] += measured;
    if (constraint.self_term && term.part == 0)
    {
      // Minus one, so that a multiplier of zero still yields the compliance.
      constraint.self_term->add(points, term.self_offsets.data(), -1., Order::value, single);
      const double compliance = measured - integral(single);
      values_of_terms.compliances[term.index] += compliance;
      values_of_terms.constraints[term.index] -= lambda * compliance;
      if (order >= Order::gradient)
        constraint.self_term->add(points, term.self_offsets.data(), -lambda, at_most_gradient, single);
    }
    if (order >= Order::gradient)
    {
      here.contraction->gradient(single, constraint_gradients[term.index]);
      measure.add(points, term.offsets.data(), lambda, order, total);
      if (constraint.self_term && term.part == 0)
        constraint.self_term->add(points, term.self_offsets.data(), -0.5 * lambda * lambda, order, total);
    }
  }
  element.n_rows = here.contraction->n_rows();
  if (order >= Order::gradient)
    here.contraction->gradient(total, element.gradient);
  if (order == Order::hessian)
    here.contraction->matrix(total, element.matrix);
}
} // namespace pellicle
