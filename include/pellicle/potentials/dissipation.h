// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/density_potential.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** The beginning of a time step, as one potential of a step sees it. Whoever steps in time fills it. */
struct StepStart
{
  double length = std::numeric_limits<double>::infinity(); ///< of the step, dt; infinite: there is none, nothing moves
  /** Inputs of all points, point after point in the order of PointData::index, the potential's fields in its own order:
   * value and derivatives of a field as in CellPoints. */
  std::vector<double> inputs;
};

/**
 * A dissipation potential D, half of what is dissipated per unit of time. It is homogeneous of degree two in the rates,
 * and depends on the state besides, which a step takes from where it begins. Over a step of length dt the principle of
 * Onsager,
 *
 *     sum of energies(y) + dt sum of dissipations((y - y_old)/dt) -> stationary,
 *
 * sees it as an ordinary potential of the new state y.
 */
struct Dissipation
{
  std::shared_ptr<const Potential> over_step; ///< dt D((y - y_old)/dt)
  std::shared_ptr<StepStart> start;           ///< y_old and dt, which over_step reads
};

/**
 * The density dt D((y - y_old)/dt) of a step. A density of dissipation is a class with
 *
 *     static constexpr std::array<FieldUse, n> fields;
 *     static constexpr bool reparametrisation_invariant;
 *     template <typename Number>
 *     Number density(const PointInputs<Number, n> &rates, const PointInputs<double, n> &start, const PointData &data)
 * const;
 *
 * per unit of parametric area: `rates` are those of the fields and of their parametric derivatives at fixed parameters,
 * `start` is the state at the beginning of the step.
 */
template <typename Density>
struct OverStep
{
  static constexpr auto fields                      = Density::fields;
  static constexpr bool reparametrisation_invariant = Density::reparametrisation_invariant;
  static constexpr unsigned int n_fields            = std::tuple_size<std::decay_t<decltype(Density::fields)>>::value;

  Density dissipation;
  std::shared_ptr<const StepStart> step;

  template <typename Number>
  Number density(const PointInputs<Number, n_fields> &inputs, const PointData &data) const
  {
    if (std::isinf(step->length))
      return Number(0.);
    PointInputs<Number, n_fields> rates;
    PointInputs<double, n_fields> start;
    const double *old = step->inputs.data() + data.index * n_inputs();
    for (unsigned int f = 0; f < n_fields; ++f)
      for (unsigned int s = 0; s < n_slots(fields[f].derivatives); ++s)
        for (unsigned int c = 0; c < 3; ++c, ++old)
        {
          start[f].slots[s][c] = *old;
          rates[f].slots[s][c] = (inputs[f].slots[s][c] - *old) / step->length;
        }
    return step->length * dissipation.density(rates, start, data);
  }

private:
  static constexpr std::size_t n_inputs()
  {
    std::size_t n = 0;
    for (unsigned int f = 0; f < n_fields; ++f)
      n += 3 * n_slots(fields[f].derivatives);
    return n;
  }
};

/** The entry of PotentialSet::dissipations for a density of dissipation. */
template <typename Density>
Dissipation make_dissipation(const std::string &name, Density density, Where where = {})
{
  auto start = std::make_shared<StepStart>();
  return {std::make_shared<DensityPotential<OverStep<Density>>>(name, OverStep<Density>{std::move(density), start},
                                                                std::move(where)),
          start};
}
} // namespace pellicle
