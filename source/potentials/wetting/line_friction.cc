// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/wetting/base_integral.h>
#include <pellicle/potentials/wetting/line_friction.h>

#include <type_traits>
#include <utility>

namespace pellicle
{
namespace
{
template <typename Chart>
BaseIntegral<Chart, AreaIntegrand> wetted_area(const Chart &chart)
{
  return {chart, {}, std::is_same<Chart, PlaneChart>::value ? &middle_rule() : &ray_rule()};
}

template <typename Chart>
struct LineFriction
{
  static constexpr std::array<FieldUse, 1> fields   = BaseIntegral<Chart, AreaIntegrand>::fields;
  static constexpr bool reparametrisation_invariant = true;

  BaseIntegral<Chart, AreaIntegrand> area;
  std::shared_ptr<const LineFrictionState> state;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    const double coefficient = state->coefficient.empty() ? 0. : state->coefficient[data.index / state->n_points];
    if (coefficient == 0.)
      return Number(state->dissipated);
    return coefficient * (area.along_line(inputs[0].value(), inputs[0].d1()) - state->start[data.index]) +
           state->dissipated;
  }
};
} // namespace

std::shared_ptr<const Potential> make_line_friction(const std::string &name, const SubstrateChart &chart,
                                                    std::shared_ptr<const LineFrictionState> state,
                                                    const std::string &edge)
{
  return std::visit(
      [&](const auto &substrate) -> std::shared_ptr<const Potential>
      {
        using Density = LineFriction<std::decay_t<decltype(substrate)>>;
        return std::make_shared<DensityPotential<Density>>(name, Density{wetted_area(substrate), std::move(state)},
                                                           Where{Where::Part::edge, edge});
      },
      chart);
}

double wetted_area_density(const SubstrateChart &chart, const Vector3<double> &x, const Vector3<double> &dx)
{
  return std::visit([&](const auto &substrate) { return wetted_area(substrate).along_line(x, dx); }, chart);
}
} // namespace pellicle
