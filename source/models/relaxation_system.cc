// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/relaxation_system.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/tilt_energy.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace pellicle
{
namespace
{
constexpr int nowhere = -1;

PotentialSet energies_of(const PotentialSet &set)
{
  PotentialSet energies;
  energies.energies = set.energies;
  return energies;
}

PotentialSet friction_of(const PotentialSet &set)
{
  PotentialSet friction;
  for (const Dissipation &dissipation : set.dissipations)
    friction.energies.push_back(dissipation.over_step);
  return friction;
}

void refuse_what_is_not_of_index_1(const SurfaceProblem &problem)
{
  const Numbering &numbering = problem.numbering();
  if (numbering.n_unknowns_of(0) > 0)
    throw UserError("Time/Integrator = ida needs a surface that is held: where it moves without friction of its own, "
                    "the motion is no system of index 1. Hold the surface, or use Time/Integrator = minimising.");
  for (const Constraint &constraint : problem.potentials().constraints)
    for (std::size_t p = 0; p < constraint.n_parts(); ++p)
      for (const FieldUse &use : constraint.part(p).fields())
        if (numbering.n_unknowns_of(problem.layout().index(use.name)) > 0)
          throw UserError("Time/Integrator = ida cannot hold the " + constraint.quantity +
                          ": a constraint on what moves makes a system of index 2. Use Time/Integrator = minimising.");
  for (const auto &energy : problem.potentials().energies)
    if (const auto *tilt = dynamic_cast<const DensityPotential<MixedTiltEnergy> *>(energy.get());
        tilt != nullptr && std::isinf(tilt->density().tilt_modulus))
      refuse_index_2();
}
} // namespace

void refuse_index_2()
{
  throw UserError(
      "Time/Integrator = ida cannot be used with Director/Tilt modulus = inf: the shear of directors is then "
      "the multiplier of a constraint, and the motion a system of index 2. Use Time/Integrator = "
      "minimising, or a finite tilt modulus.");
}

// Unit vectors get the direction that they have as a further column; whatever else has unknowns keeps them.
Numbering RelaxationSystem::numbering_of(const SurfaceProblem &problem)
{
  std::vector<NodalChart> charts = problem.numbering().charts;
  for (NodalChart &chart : charts)
  {
    for (std::size_t I = 0; I < chart.unit_vectors.size(); ++I)
      if (NodalChart::Node &node = chart.nodes[I]; node.count > 0)
      {
        std::copy_backward(node.columns.begin(), node.columns.begin() + 3 * node.count,
                           node.columns.begin() + 3 * node.count + 3);
        std::copy(chart.unit_vectors[I].begin(), chart.unit_vectors[I].end(), node.columns.begin());
        ++node.count;
      }
    chart.unit_vectors.clear();
  }
  return {std::move(charts), 0, 0};
}

RelaxationSystem::RelaxationSystem(SurfaceProblem &problem, const double gamma, const Communicator &communicator,
                                   Timing &timing)
    : problem(problem)
    , gamma(gamma)
    , communicator(communicator)
    , timing(timing)
    , energies(energies_of(problem.potentials()))
    , assembler(problem.discretization(), problem.layout(), energies, communicator,
                Assembler::everything(energies, problem.layout()))
    , system(problem.discretization(), numbering_of(problem), communicator)
    , pattern(system.matrix())
    , fields_start(problem.state().fields)
{
  refuse_what_is_not_of_index_1(problem);
  const Numbering &numbering = system.numbering();
  differential.assign(numbering.size(), false);
  y_start.assign(numbering.size(), 0.);
  for (std::size_t f = 0; f < numbering.n_fields(); ++f)
    for (std::size_t I = 0; I < problem.numbering().charts[f].unit_vectors.size(); ++I)
      if (const unsigned int count = numbering.count(f, I); count > 0 && numbering.charts[f].leads(I))
      {
        const UnitVector vector{numbering.first_of(f, I), count};
        unit_vectors.push_back(vector);
        y_start[vector.first] = 1.;
        for (unsigned int a = 0; a < count; ++a)
          differential[vector.first + a] = true;
      }
  // M is the second derivative of 1 D((y - y_old)/1).
  problem.begin_time_step(1.);
  const PotentialSet rates = friction_of(problem.potentials());
  Assembler of_friction(problem.discretization(), problem.layout(), rates, communicator,
                        Assembler::everything(rates, problem.layout()));
  assemble(of_friction, rates, fields_start, Order::hessian);
  friction = system.matrix().values;

  make_general_pattern();
}

// That of the system and, for each unit vector, the square block on the diagonal: a process that has none of a node's
// cells knows only the diagonal.
void RelaxationSystem::make_general_pattern()
{
  general.symmetry = MatrixSymmetry::general;
  general.size     = system.matrix().size;
  general.row_start.assign(1, 0);
  std::vector<std::pair<int, int>> blocks(general.size);
  for (int i = 0; i < general.size; ++i)
    blocks[i] = {i, i};
  for (const UnitVector &vector : unit_vectors)
    for (std::size_t i = vector.first; i < vector.first + vector.count; ++i)
      blocks[i] = {static_cast<int>(vector.first), static_cast<int>(vector.first + vector.count)};
  for (int i = 0; i < general.size; ++i)
  {
    std::map<int, int> row;
    for (int column = blocks[i].first; column < blocks[i].second; ++column)
      row[column] = nowhere;
    for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k)
      row[pattern.columns[k]] = pattern.origin[k];
    for (const auto &[column, place] : row)
    {
      general.columns.push_back(column);
      origin.push_back(place);
    }
    general.row_start.push_back(static_cast<int>(general.columns.size()));
  }
  general.values.resize(general.columns.size());
}

void RelaxationSystem::assemble(Assembler &with, const PotentialSet &set, const FieldValues &values, const Order order)
{
  const Timing::Scope scope(timing, "assembly");
  system.begin();
  with.loop(set, values, {}, order,
            [&](const Cell &cell, const Element &element, const auto &none)
            {
              if (order == Order::hessian)
                system.add_cell(cell, element, none, nullptr);
              else
                system.add_cell_residual(cell, element, none, nullptr);
            });
  system.finish();
}

FieldValues RelaxationSystem::fields(const std::vector<double> &y) const
{
  std::vector<double> increment(y.size());
  for (std::size_t i = 0; i < y.size(); ++i)
    increment[i] = y[i] - y_start[i];
  FieldValues values = fields_start;
  for (std::size_t f = 0; f < values.size(); ++f)
    system.add_columns(increment, 1., f, values[f]);
  return values;
}

std::vector<double> RelaxationSystem::friction_times(const std::vector<double> &rate) const
{
  std::vector<double> product(rate.size(), 0.);
  for (std::size_t i = 0; i < product.size(); ++i)
    for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k)
      product[i] += friction[pattern.origin[k]] * rate[pattern.columns[k]];
  communicator.sum(product);
  return product;
}

double RelaxationSystem::length_equation(const UnitVector &vector, const std::vector<double> &y,
                                         const std::vector<double> &rate) const
{
  double sum = -gamma;
  for (std::size_t i = vector.first; i < vector.first + vector.count; ++i)
    sum += y[i] * (rate[i] + gamma * y[i]);
  return sum;
}

void RelaxationSystem::residual(double /*time*/, const std::vector<double> &y, const std::vector<double> &rate,
                                std::vector<double> &result)
{
  assemble(assembler, energies, fields(y), Order::gradient);
  result = friction_times(rate);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] += system.residual()[i];
  for (const UnitVector &vector : unit_vectors)
  {
    double along = length_equation(vector, y, rate);
    for (std::size_t i = vector.first; i < vector.first + vector.count; ++i)
      along -= y[i] * result[i];
    for (std::size_t i = vector.first; i < vector.first + vector.count; ++i)
      result[i] += along * y[i];
  }
}

const SparseMatrix &RelaxationSystem::tangent(double /*time*/, const std::vector<double> &y,
                                              const std::vector<double> &rate, const double alpha)
{
  assemble(assembler, energies, fields(y), Order::hessian);
  std::vector<double> h            = friction_times(rate);
  const std::vector<double> &E_val = system.matrix().values;
  for (std::size_t k = 0; k < general.values.size(); ++k)
    general.values[k] = origin[k] == nowhere ? 0. : E_val[origin[k]] + alpha * friction[origin[k]];
  for (std::size_t i = 0; i < h.size(); ++i)
    h[i] += system.residual()[i];
  const bool first_process = communicator.rank() == 0;
  for (const UnitVector &vector : unit_vectors)
  {
    // All rows of a node have the same columns: (I - O O) is applied column by column.
    const std::size_t i = vector.first;
    const int row_size  = general.row_start[i + 1] - general.row_start[i];
    for (int k = 0; k < row_size; ++k)
    {
      double along = 0.;
      for (unsigned int a = 0; a < vector.count; ++a)
        along += y[i + a] * general.values[general.row_start[i + a] + k];
      for (unsigned int a = 0; a < vector.count; ++a)
        general.values[general.row_start[i + a] + k] -= along * y[i + a];
    }
    if (!first_process)
      continue;
    // What is left: the derivatives of O (. . .) with respect to the O's that are written out, and to O'.
    double along = length_equation(vector, y, rate);
    for (unsigned int a = 0; a < vector.count; ++a)
      along -= y[i + a] * h[i + a];
    const auto begin = general.columns.begin() + general.row_start[i], end = begin + row_size;
    const auto own = std::lower_bound(begin, end, static_cast<int>(i)) - begin;
    for (unsigned int a = 0; a < vector.count; ++a)
      for (unsigned int b = 0; b < vector.count; ++b)
        general.values[general.row_start[i + a] + own + b] +=
            (a == b ? along : 0.) + y[i + a] * (rate[i + b] + (2. * gamma + alpha) * y[i + b] - h[i + b]);
  }
  return general;
}

double RelaxationSystem::dissipated_power(const std::vector<double> & /*y*/, const std::vector<double> &rate)
{
  const std::vector<double> product = friction_times(rate);
  return std::inner_product(rate.begin(), rate.end(), product.begin(), 0.);
}
} // namespace pellicle
