// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/constraints/bilayer_curvature.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/surface_tension.h>

namespace pellicle
{
namespace
{
/** What both effects share; target and stiffness are left to them. */
Constraint curvature_constraint(const std::string &effect, const SceneTargets &targets)
{
  if (!targets.has_bending())
    throw UserError("The effect '" + effect +
                    "' needs curvature, which only the bending energy computes: add 'helfrich bending' to Effects.");
  Constraint constraint;
  constraint.measure = std::make_shared<DensityPotential<BilayerCurvature>>(effect, BilayerCurvature{targets.bending});
  constraint.self_term  = std::make_shared<DensityPotential<BilayerSelfTerm>>(effect, BilayerSelfTerm{targets.bending});
  constraint.quantity   = "integrated_mean_curvature";
  constraint.multiplier = "bilayer_coupling_multiplier";
  constraint.dimension  = dimensions::length;
  return constraint;
}

/** Derivatives with respect to the target M0, and to spontaneous curvatures: g has the term C0 A/2, of each region. */
std::vector<ParameterDerivative> curvature_derivatives(const std::string &section, const Scales &scales,
                                                       const SceneTargets &targets)
{
  const std::string quantity = "integrated_mean_curvature";
  std::vector<ParameterDerivative> list{
      {section + "/Integrated mean curvature", nullptr, quantity, 1. / scales.of(dimensions::length)}};
  const std::vector<std::string> sections{"Helfrich bending", "Lipid domain"};
  for (std::size_t region = 0; region < targets.bending.size(); ++region)
  {
    const Where where =
        targets.bending.size() > 1 ? Where{Where::Part::region, region_name(region)} : Where{Where::Part::surface, ""};
    const SurfaceTension half_area{0.5 / scales.of(dimensions::curvature)};
    list.push_back({sections.at(region) + "/Spontaneous curvature", nullptr, quantity, 0.,
                    std::make_shared<DensityPotential<SurfaceTension>>("half the area", half_area, where)});
  }
  return list;
}

void bind_target(ParameterSection &section, double &integrated_mean_curvature)
{
  section.number("Integrated mean curvature", integrated_mean_curvature, Range::any(), dimensions::length,
                 "M0, the wanted integral M of the mean curvature H_out (half the trace, positive on a sphere: 4 pi R "
                 "there). M times twice the distance of the monolayers is their difference in area.");
}
} // namespace

// With N = x,1 x x,2 = J n: g = P . N/(2 kappa) + C0 J/2.
void BilayerCurvature::add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                                       const PointDerivativeView &view) const
{
  constexpr unsigned int position = 0, moment = 1;
  const BendingLaw &law     = laws[data.region];
  const Vector3<double> &x1 = inputs[position].d1(), &x2 = inputs[position].d2(), &P = inputs[moment].value();
  const double s = 0.5 / law.rigidity;
  add_area_derivatives(inputs[position], position, 0.5 * law.spontaneous_curvature, view);
  view.add_gradient(position, 1, s * cross(x2, P));
  view.add_gradient(position, 2, s * cross(P, x1));
  view.add_gradient(moment, 0, s * cross(x1, x2));
  if (!view.wants_hessian())
    return;
  view.add_hessian(position, 1, position, 2, -s * cross_matrix(P));
  view.add_hessian(position, 1, moment, 0, s * cross_matrix(x2));
  view.add_hessian(position, 2, moment, 0, -s * cross_matrix(x1));
}

void BilayerCouplingParameters::bind(ParameterSection &section)
{
  bind_target(section, integrated_mean_curvature);
}

const std::string &BilayerCouplingEffect::name() const
{
  static const std::string text = "bilayer coupling";
  return text;
}

std::string BilayerCouplingEffect::description() const
{
  return "Holds the integrated mean curvature M at a value M0; its multiplier is Q in E + Q (M - M0).";
}

void BilayerCouplingEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  Constraint constraint = curvature_constraint(name(), targets);
  constraint.target     = scaled(parameters, scales).integrated_mean_curvature;
  set.constraints.push_back(constraint);
}

void AreaDifferenceElasticityParameters::bind(ParameterSection &section)
{
  bind_target(section, integrated_mean_curvature);
  section.number("Stiffness", stiffness, Range::positive(), {1, -2},
                 "Stiffness kbar of the energy (kbar/2)(M - M0)^2. The multiplier Q = kbar (M - M0) is reported.");
}

const std::string &AreaDifferenceElasticityEffect::name() const
{
  static const std::string text = "area difference elasticity";
  return text;
}

std::string AreaDifferenceElasticityEffect::description() const
{
  return "Energy (kbar/2)(M - M0)^2 of the integrated mean curvature M: the monolayers' areas can differ, at a price.";
}

void AreaDifferenceElasticityEffect::contribute(const Scales &scales, const SceneTargets &targets,
                                                PotentialSet &set) const
{
  const AreaDifferenceElasticityParameters p = scaled(parameters, scales);
  Constraint constraint                      = curvature_constraint(name(), targets);
  constraint.target                          = p.integrated_mean_curvature;
  constraint.stiffness                       = p.stiffness;
  constraint.energy                          = "area_difference_energy";
  set.constraints.push_back(constraint);
}

std::vector<ParameterDerivative> BilayerCouplingEffect::derivatives(const Scales &scales,
                                                                    const SceneTargets &targets) const
{
  return curvature_derivatives("Bilayer coupling", scales, targets);
}

std::vector<ParameterDerivative> AreaDifferenceElasticityEffect::derivatives(const Scales &scales,
                                                                             const SceneTargets &targets) const
{
  return curvature_derivatives("Area difference elasticity", scales, targets);
}
} // namespace pellicle
