// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <boost/math/quadrature/gauss.hpp>

#include <type_traits>

namespace pellicle
{
namespace
{
template <typename Integrand>
std::shared_ptr<const Potential> on_line(const std::string &name, const SubstrateChart &chart,
                                         const Integrand &integrand, const UnitRule &rule, const std::string &edge)
{
  return std::visit(
      [&](const auto &substrate) -> std::shared_ptr<const Potential>
      {
        using Density = BaseIntegral<std::decay_t<decltype(substrate)>, Integrand>;
        return std::make_shared<DensityPotential<Density>>(name, Density{substrate, integrand, &rule},
                                                           Where{Where::Part::edge, edge});
      },
      chart);
}
/** A plane on which x . n = 0. */
bool passes_through_origin(const SubstrateChart &chart)
{
  const auto *plane = std::get_if<PlaneChart>(&chart);
  return plane != nullptr && plane->height == 0.;
}
} // namespace

const UnitRule &ray_rule()
{
  static const UnitRule rule = []
  {
    using Gauss = boost::math::quadrature::gauss<double, 20>;
    UnitRule result;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
      for (const double side : {-1., 1.})
      {
        result.points.push_back(0.5 * (1. + side * Gauss::abscissa()[i]));
        result.weights.push_back(0.5 * Gauss::weights()[i]);
      }
    return result;
  }();
  return rule;
}

const UnitRule &middle_rule()
{
  static const UnitRule rule{{0.5}, {1.}};
  return rule;
}

std::shared_ptr<const Potential> make_wetting(const std::string &name, const SubstrateChart &chart,
                                              const WettingIntegrand &integrand, const std::string &edge)
{
  const bool uniform = std::holds_alternative<PlaneChart>(chart) && !integrand.cosine.degrees;
  return on_line(name, chart, integrand, uniform ? middle_rule() : ray_rule(), edge);
}

std::shared_ptr<const Potential> make_base_volume(const std::string &name, const SubstrateChart &chart,
                                                  const std::string &edge)
{
  if (passes_through_origin(chart))
    return nullptr;
  return on_line(name, chart, BaseVolumeIntegrand{}, ray_rule(), edge);
}

std::shared_ptr<const Potential> make_base_gravity(const std::string &name, const SubstrateChart &chart,
                                                   const Vector3<double> &force, const std::string &edge)
{
  if (passes_through_origin(chart))
    return nullptr;
  return on_line(name, chart, BaseGravityIntegrand{force}, ray_rule(), edge);
}
} // namespace pellicle
