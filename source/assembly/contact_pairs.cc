// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/contact_pairs.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/surface_point.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
/** How the area element J of a slave point changes with the pair's nodes: (27), (112) of Sauer 2014. */
class AreaChange
{
public:
  AreaChange(const WalkPoint &at, const ShapeTables &tables, const std::size_t n_nodes)
      : plane(at[1], at[2])
      , tables(tables)
      , q(at.q)
      , n_nodes(n_nodes)
  {
  }

  /** dJ/J = a^a . dx,a */
  std::vector<double> relative() const
  {
    std::vector<double> sum = row(0, plane.dual[0]), second = row(1, plane.dual[1]);
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += second[i];
    return sum;
  }

  /** matrix += factor DdJ/J */
  void add_second(const double factor, ContactElementSums &sums) const
  {
    const std::vector<double> first = relative();
    sums.add_outer(factor, first, first);
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
      {
        sums.add_outer(factor * plane.inverse_metric(a, b), row(a, plane.normal), row(b, plane.normal));
        sums.add_outer(-factor, row(a, plane.dual[b]), row(b, plane.dual[a]));
      }
  }

private:
  /** v . dx,a of the slave. */
  std::vector<double> row(const unsigned int a, const Vector3<double> &v) const
  {
    std::vector<double> result(3 * n_nodes, 0.);
    for (unsigned int c = 0; c < 3; ++c)
      for (std::size_t I = 0; I < tables.n_nodes; ++I)
        result[c * n_nodes + I] = tables.tables[1 + a][q * tables.n_nodes + I] * v[c];
    return result;
  }

  TangentPlane<double> plane;
  const ShapeTables &tables;
  std::size_t q, n_nodes;
};
} // namespace

ContactPairs::ContactPairs(const SurfaceCells &slave, SurfaceCells master, const NodalVectors &reference,
                           const ContactLaw &law, std::string name)
    : ContactPairs(SlavePoints(slave, reference, slave.degree + 1 + law.extra_gauss_points), std::move(master), law,
                   std::move(name))
{
}

ContactPairs::ContactPairs(SlavePoints slave, SurfaceCells master, const ContactLaw &law, std::string name)
    : own_name(std::move(name))
    , slave_points(std::move(slave))
    , search(std::move(master), law.limits)
    , law(law)
    , second_variation(gap_second_variation(law.second_variation))
    , states(slave_points.size())
{
  if (!(law.penalty > 0.))
    throw UserError("The penalty of contact is " + std::to_string(law.penalty) + "; it must be > 0.");
  PELLICLE_ASSERT(law.measure == ContactMeasure::reference || !slave_points.on_line,
                  "contact on lines is per reference length");
}

bool ContactPairs::touches(const ContactPoint &state) const
{
  return state.partner && (state.pressure > 0. || law.sides == ContactSides::two);
}

ContactElements ContactPairs::evaluate(const NodalVectors &positions, const Order order)
{
  search.update(positions);
  ContactElementSums sums(slave_points, search.master(), order);
  for_all_cells(slave_points.tables, slave_points.cell_nodes, positions, 3,
                [&](const WalkCell &cell)
                {
                  for (unsigned int q = 0; q < cell.tables.n_points && slave_points.is_own(cell.number); ++q)
                  {
                    const WalkPoint at  = cell[q];
                    const std::size_t i = cell.number * cell.tables.n_points + q;
                    ContactPoint &state = states[i];
                    const double p      = state.multiplier;
                    const auto previous = state.partner ? std::optional(state.partner->cell) : std::nullopt;
                    state.partner       = search.closest(at[0], cross(at[1], at[2]), previous);
                    state.pressure      = state.partner ? p - law.penalty * state.partner->gap : 0.;
                    if (law.sides == ContactSides::one)
                      state.pressure = std::max(0., state.pressure);
                    const bool of_reference = law.measure == ContactMeasure::reference;
                    const double area       = of_reference ? slave_points.reference_areas[i] : at.area();
                    sums.sums.energy += area * (state.pressure * state.pressure - p * p) / (2. * law.penalty);
                    if (touches(state))
                    {
                      ++sums.sums.n_active;
                      sums.select(cell.number, state.partner->cell, slave_points.shapes(q));
                      if (sums.wants(Order::gradient))
                        add_point(at, area, state, sums);
                    }
                  }
                });
  return std::move(sums.sums);
}

// The three measures differ by the terms of dJ; see ContactMeasure.
void ContactPairs::add_point(const WalkPoint &at, const double area, const ContactPoint &state,
                             ContactElementSums &sums) const
{
  const MasterPoint master = master_point(search.shape(state.partner->cell), state.partner->at);
  const ClosestPoint point(at[0], master);
  const double t = state.pressure, phi = (t * t - state.multiplier * state.multiplier) / (2. * law.penalty);
  const std::vector<double> N = sums.at_nodes(point.N);
  const AreaChange change(at, slave_points.tables, sums.n_nodes());
  const std::vector<double> dJ = law.measure == ContactMeasure::reference ? std::vector<double>() : change.relative();

  sums.add_gradient(-t * area, N);
  if (law.measure == ContactMeasure::current)
    sums.add_gradient(phi * area, dJ);
  if (!sums.wants(Order::hessian))
    return;

  DenseMatrix matrix(point.n_rows());
  matrix.add_outer(law.penalty, point.N, point.N);
  second_variation.add(point, -t, matrix);
  sums.add_matrix(area, matrix);
  if (law.measure != ContactMeasure::reference)
    sums.add_outer(-t * area, N, dJ);
  if (law.measure == ContactMeasure::current)
  {
    sums.add_outer(-t * area, dJ, N);
    change.add_second(phi * area, sums);
  }
}

MultiplierChange ContactPairs::pending() const
{
  MultiplierChange change;
  for (const ContactPoint &state : states)
  {
    change.largest_change   = std::max(change.largest_change, std::abs(state.pressure - state.multiplier));
    change.largest_traction = std::max(change.largest_traction, std::abs(state.pressure));
  }
  return change;
}

MultiplierChange ContactPairs::augment()
{
  const MultiplierChange change = pending();
  for (ContactPoint &state : states)
    state.multiplier = state.pressure;
  return change;
}

std::vector<double> ContactPairs::memory() const
{
  std::vector<double> list(2 * states.size(), 0.);
  for (std::size_t i = 0; i < states.size(); ++i)
    if (slave_points.is_own(i / slave_points.tables.n_points))
    {
      list[2 * i]     = states[i].multiplier;
      list[2 * i + 1] = states[i].partner ? 1. + static_cast<double>(states[i].partner->cell) : 0.;
    }
  return list;
}

void ContactPairs::recall(const std::vector<double> &memory)
{
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    states[i]            = ContactPoint();
    states[i].multiplier = memory[2 * i];
    if (memory[2 * i + 1] > 0.)
    {
      states[i].partner.emplace();
      states[i].partner->cell = static_cast<std::size_t>(memory[2 * i + 1] - 1.);
    }
  }
}
} // namespace pellicle
