// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/edges/edge_bending.h>
#include <pellicle/potentials/energies/helfrich_bending.h>

#include <algorithm>

namespace pellicle
{
// With f = S/J - C0 N.P - J |P|^2/(2 kappa), S quadratic in x,a and linear in P,b, every block below is one product
// rule; the library-wide test compares them with automatic differentiation.
void HelfrichBending::add_derivatives(const PointInputs<double, 2> &inputs, const PointData & /*data*/,
                                      const PointDerivativeView &view) const
{
  constexpr unsigned int position = 0, moment = 1;
  const Vector3<double> &x1 = inputs[position].d1(), &x2 = inputs[position].d2();
  const Vector3<double> &P = inputs[moment].value(), &P1 = inputs[moment].d1(), &P2 = inputs[moment].d2();

  const AreaDerivatives area(x1, x2);
  const double J = area.J, a11 = dot(x1, x1), a12 = dot(x1, x2), a22 = dot(x2, x2);
  const double x1P1 = dot(x1, P1), x2P2 = dot(x2, P2), mixed = dot(x1, P2) + dot(x2, P1);
  const double S    = a22 * x1P1 - a12 * mixed + a11 * x2P2;
  const double half = dot(P, P) / (2. * kappa); // |P|^2/(2 kappa)

  const Vector3<double> S_x[2] = {a22 * P1 - a12 * P2 + (2. * x2P2) * x1 - mixed * x2,
                                  a11 * P2 - a12 * P1 + (2. * x1P1) * x2 - mixed * x1};
  const Vector3<double> S_P[2] = {a22 * x1 - a12 * x2, a11 * x2 - a12 * x1};
  const double f_J             = -S / (J * J) - half; // df/dJ at fixed S

  view.add_gradient(position, 1, (1. / J) * S_x[0] + f_J * area.dJ[0] - C0 * cross(x2, P));
  view.add_gradient(position, 2, (1. / J) * S_x[1] + f_J * area.dJ[1] - C0 * cross(P, x1));
  view.add_gradient(moment, 1, (1. / J) * S_P[0]);
  view.add_gradient(moment, 2, (1. / J) * S_P[1]);
  view.add_gradient(moment, 0, (-J / kappa) * P - (C0 * J) * area.normal);
  if (!view.wants_hessian())
    return;

  const Matrix3 S_xx[3] = {identity3(2. * x2P2) - outer(P2, x2) - outer(x2, P2),
                           2. * (outer(P1, x2) + outer(x1, P2)) - outer(P2, x1) - outer(x2, P1) - identity3(mixed),
                           identity3(2. * x1P1) - outer(P1, x1) - outer(x1, P1)};
  const double f_JJ     = 2. * S / (J * J * J);
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = a; b < 2; ++b)
    {
      Matrix3 block = (1. / J) * S_xx[a + b] -
                      (1. / (J * J)) * (outer(S_x[a], area.dJ[b]) + outer(area.dJ[a], S_x[b])) +
                      f_JJ * outer(area.dJ[a], area.dJ[b]) + f_J * area.d2J(a, b);
      if (a != b)
        block = block + C0 * cross_matrix(P);
      view.add_hessian(position, 1 + a, position, 1 + b, block);
    }

  const Matrix3 S_xP[2][2] = {{identity3(a22) - outer(x2, x2), 2. * outer(x1, x2) - outer(x2, x1) - identity3(a12)},
                              {2. * outer(x2, x1) - outer(x1, x2) - identity3(a12), identity3(a11) - outer(x1, x1)}};
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = 0; b < 2; ++b)
      view.add_hessian(position, 1 + a, moment, 1 + b,
                       (1. / J) * S_xP[a][b] - (1. / (J * J)) * outer(area.dJ[a], S_P[b]));

  view.add_hessian(position, 1, moment, 0, (-1. / kappa) * outer(area.dJ[0], P) - C0 * cross_matrix(x2));
  view.add_hessian(position, 2, moment, 0, (-1. / kappa) * outer(area.dJ[1], P) + C0 * cross_matrix(x1));
  view.add_hessian(moment, 0, moment, 0, identity3(-J / kappa));
}

namespace
{
/** -n . P per unit of C0. */
struct SpontaneousCurvatureDerivative
{
  static constexpr std::array<FieldUse, 2> fields{
      {{"position", Derivatives::first, FieldRole::independent}, {"moment", Derivatives::none, FieldRole::internal}}};
  static constexpr bool reparametrisation_invariant = true;

  double factor = 1.;

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    return -factor * dot(cross(inputs[0].d1(), inputs[0].d2()), inputs[1].value());
  }
};
} // namespace

std::shared_ptr<const Potential> spontaneous_curvature_derivative(const double factor, const Where &where)
{
  return std::make_shared<DensityPotential<SpontaneousCurvatureDerivative>>(
      "spontaneous curvature", SpontaneousCurvatureDerivative{factor}, where);
}

void HelfrichBendingParameters::bind(ParameterSection &section)
{
  section.number("Bending rigidity", bending_rigidity, Range::positive(), dimensions::energy,
                 "Bending rigidity kappa in (kappa/2)(2H + C0)^2 per area, where 2H = -2/R on a sphere of radius R.");
  section.number("Spontaneous curvature", spontaneous_curvature, Range::any(), dimensions::curvature,
                 "Spontaneous curvature C0 in (kappa/2)(2H + C0)^2. Positive: convex outward is favoured; the "
                 "stress-free sphere has R = 2/C0.");
}

const std::string &HelfrichBendingEffect::name() const
{
  static const std::string text = "helfrich bending";
  return text;
}

std::string HelfrichBendingEffect::description() const
{
  return "Bending energy (kappa/2)(2H + C0)^2 per area, C0 uniform.";
}

std::optional<double> HelfrichBendingEffect::typical_energy(double /*length*/) const
{
  return parameters.bending_rigidity;
}

void HelfrichBendingEffect::prepare(const Scales &scales, SceneTargets &targets) const
{
  const HelfrichBendingParameters p = scaled(parameters, scales);
  targets.bending.resize(std::max<std::size_t>(targets.bending.size(), 1));
  targets.bending[0] = {p.bending_rigidity, p.spontaneous_curvature};
}

void HelfrichBendingEffect::contribute(const Scales & /*scales*/, const SceneTargets &targets, PotentialSet &set) const
{
  const auto add = [&](const BendingLaw &law, const Where &where)
  {
    set.energies.push_back(std::make_shared<DensityPotential<HelfrichBending>>(
        name(), HelfrichBending{law.rigidity, law.spontaneous_curvature}, where));
  };
  if (targets.bending.size() == 1)
    add(targets.bending[0], {});
  else
    for (std::size_t region = 0; region < targets.bending.size(); ++region)
      add(targets.bending[region], {Where::Part::region, region_name(region)});

  // An edge's share of the same energy: without it the moment could not do work on the slope there.
  for (const SceneEdge &edge : targets.edges)
  {
    const Where where{Where::Part::edge, edge.name};
    if (edge.support == EdgeSupport::clamped)
      set.energies.push_back(
          std::make_shared<DensityPotential<ClampedEdge>>(name(), ClampedEdge{edge.conormals}, where));
    else if (edge.support == EdgeSupport::inner || edge.support == EdgeSupport::far_side
                 ? targets.gaussian_difference != 0.
                 : targets.gaussian_modulus != 0.)
    {
      set.energies.push_back(std::make_shared<DensityPotential<HingedEdge>>(
          name(), HingedEdge{edge.support == EdgeSupport::far_side ? 1. : -1.}, where));
      if (edge.support != EdgeSupport::far_side)
        set.energies.push_back(
            std::make_shared<DensityPotential<ConormalConstraint>>(name(), ConormalConstraint{}, where));
    }
  }
}

std::vector<ParameterDerivative> HelfrichBendingEffect::derivatives(const Scales &scales,
                                                                    const SceneTargets &targets) const
{
  const Where where =
      targets.bending.size() > 1 ? Where{Where::Part::region, region_name(0)} : Where{Where::Part::surface, ""};
  return {{"Helfrich bending/Spontaneous curvature",
           spontaneous_curvature_derivative(1. / scales.of(dimensions::curvature), where), "", 0.}};
}
} // namespace pellicle
