// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/material_position.h>
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

struct MaterialArea
{
  static constexpr std::array<FieldUse, 1> fields{
      {{material_position, Derivatives::first, FieldRole::independent, FieldSpace::material_places}}};

  template <typename Number>
  Number along_line(const Vector3<Number> &X, const Vector3<Number> &dX) const
  {
    return 0.5 * (X[0] * dX[1] - X[1] * dX[0]);
  }
};

template <typename Area>
struct LineFriction
{
  static constexpr std::array<FieldUse, 1> fields   = Area::fields;
  static constexpr bool reparametrisation_invariant = true;

  Area area;
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
        using Density = LineFriction<decltype(wetted_area(substrate))>;
        return std::make_shared<DensityPotential<Density>>(name, Density{wetted_area(substrate), std::move(state)},
                                                           Where{Where::Part::edge, edge});
      },
      chart);
}

double wetted_area_density(const SubstrateChart &chart, const Vector3<double> &x, const Vector3<double> &dx)
{
  return std::visit([&](const auto &substrate) { return wetted_area(substrate).along_line(x, dx); }, chart);
}

std::shared_ptr<const Potential> make_material_line_friction(const std::string &name,
                                                             std::shared_ptr<const LineFrictionState> state,
                                                             const std::string &edge)
{
  using Density = LineFriction<MaterialArea>;
  return std::make_shared<DensityPotential<Density>>(name, Density{{}, std::move(state)},
                                                     Where{Where::Part::edge, edge});
}

double material_area_density(const Vector3<double> &X, const Vector3<double> &dX)
{
  return MaterialArea().along_line(X, dX);
}
} // namespace pellicle
