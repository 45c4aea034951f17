// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/potentials/shell/cosserat_shell.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
/** Value, gradient and Hessian of a function of six numbers, by automatic differentiation. */
struct OfSix
{
  std::array<double, 6> gradient;
  std::array<double, 36> hessian;

  template <typename Function>
  OfSix(const std::array<double, 6> &at, const Function &function)
  {
    using Number   = SecondOrder<6>;
    const Number f = function(seed<Number>(at));
    gradient       = gradient_of(f);
    hessian        = hessian_of(f);
  }
};
} // namespace

void ShellMaterial::bind(ParameterSection &section)
{
  section.number("Young modulus", young, Range::positive(), dimensions::pressure, "Young's modulus E.");
  section.number("Poisson ratio", poisson, {-1., 0.5, true, true, false}, dimensions::none,
                 "Poisson's ratio nu, in (-1, 1/2).");
  section.number("Thickness", thickness, Range::positive(), dimensions::length, "Thickness h of the undeformed shell.");
  section.choice(
      "Shear correction", shear_correction, {"none", "5/6"},
      "Factor on the energy of transverse shear. none: the shear is constant over the thickness, as the model "
      "has it. 5/6: as if the shear stress were the parabola of a plate.");
}

double ShellMaterial::bending_stiffness() const
{
  return young * thickness * thickness * thickness / (12. * (1. - poisson * poisson));
}

const ShellReference &reference_at(const ShellReferences &references, const PointData &data)
{
  PELLICLE_ASSERT(references && data.index < references->size(), "a shell needs its reference");
  return (*references)[data.index];
}

ShellStrainEnergy::Shares ShellStrainEnergy::kept(const PointData &data) const
{
  constexpr double largest = 0.5;
  const double ratio       = material.thickness * material.thickness / (*squared_node_distance)[data.index];
  return {std::min(largest, kept_plain * ratio), std::min(largest, kept_shear * ratio)};
}

// The part of transverse shear in S : E is 2 (S N)_tan . (E N)_tan.
ShellStrainEnergy::Weights ShellStrainEnergy::weights(const Vector3<double> &N, const PointData &data) const
{
  const Shares t = kept(data);
  std::array<Vector3<double>, 6> on_normal; // of the tensor with component s alone
  for (unsigned int s = 0; s < 6; ++s)
  {
    const auto [p, q] = symmetric_index[s];
    on_normal[s][p] += N[q];
    if (p != q)
      on_normal[s][q] += N[p];
    on_normal[s] -= dot(on_normal[s], N) * N;
  }
  Weights P{};
  for (unsigned int s = 0; s < 6; ++s)
    for (unsigned int r = 0; r < 6; ++r)
    {
      const double strain_of_component = r < 3 ? 1. : 0.5; // strains are doubled off the diagonal
      P[s][r]                          = (s == r ? 1. - t.plain : 0.) +
                (t.plain - t.shear) * 2. * strain_of_component * dot(on_normal[s], on_normal[r]);
    }
  return P;
}

void ShellStrainEnergy::add_derivatives(const PointInputs<double, 4> &inputs, const PointData &data,
                                        const PointDerivativeView &view) const
{
  const ShellReference &D                      = reference_at(reference, data);
  const std::array<Vector3<double>, 2> moments = D.first_moments(material.thickness);
  const ShellStrainDerivatives strains(inputs[0], inputs[1], D, moments);
  const Symmetric6<double> S = stress(inputs);
  const double volume        = D.volume(material.thickness);
  const OfSix W(strains.strains.strain, [&](const auto &E) { return kept_part(E, D.normal, data); });
  const OfSix dual(S, [&](const auto &s) { return dual_part(s, D.normal, data); });

  ShellStrainDerivatives::Gradient by_strain{};
  ShellStrainDerivatives::Hessian by_strains{};
  std::array<double, 6> by_stress;
  const Weights P = weights(D.normal, data);
  for (unsigned int s = 0; s < 6; ++s)
  {
    by_strain[s] = volume * W.gradient[s];
    by_stress[s] = -volume * dual.gradient[s];
    for (unsigned int r = 0; r < 6; ++r)
    {
      by_strain[s] += volume * P[r][s] * S[r];
      by_stress[s] += volume * P[s][r] * strains.strains.strain[r];
      by_strains[s][r] = volume * W.hessian[6 * s + r];
    }
  }
  strains.add(by_strain, by_strains, view);
  for (unsigned int f = 0; f < 2; ++f)
    view.add_gradient(2 + f, 0, {by_stress[3 * f], by_stress[3 * f + 1], by_stress[3 * f + 2]});
  if (!view.wants_hessian())
    return;
  for (unsigned int f = 0; f < 2; ++f)
  {
    for (unsigned int k = 0; k < ShellStrainDerivatives::n_vectors; ++k)
    {
      const std::array<Symmetric6<double>, 3> of_strain = strains.of_strain(k);
      Matrix3 block;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int r = 0; r < 6; ++r)
            block(i, j) += volume * P[3 * f + j][r] * of_strain[i][r];
      view.add_hessian(ShellStrainDerivatives::input[k][0], ShellStrainDerivatives::input[k][1], 2 + f, 0, block);
    }
    for (unsigned int g = f; g < 2; ++g)
    {
      Matrix3 block;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          block(i, j) = -volume * dual.hessian[6 * (3 * f + i) + 3 * g + j];
      view.add_hessian(2 + f, 0, 2 + g, 0, block);
    }
  }
}

void ShellBendingEnergy::add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                                         const PointDerivativeView &view) const
{
  const ShellReference &D                      = reference_at(reference, data);
  const std::array<Vector3<double>, 2> moments = D.first_moments(material.thickness);
  const ShellStrainDerivatives strains(inputs[0], inputs[1], D, moments);
  const auto &[beta_1, beta_2] = strains.strains.couple;
  const double volume          = D.volume(material.thickness);
  const OfSix bending({{beta_1[0], beta_1[1], beta_1[2], beta_2[0], beta_2[1], beta_2[2]}},
                      [&](const auto &beta)
                      {
                        using Number = std::decay_t<decltype(beta[0])>;
                        return material.bending_energy(
                            std::array<Vector3<Number>, 2>{{Vector3<Number>(beta[0], beta[1], beta[2]),
                                                            Vector3<Number>(beta[3], beta[4], beta[5])}},
                            D);
                      });
  ShellStrainDerivatives::Gradient by_strain{};
  ShellStrainDerivatives::Hessian by_strains{};
  for (unsigned int s = 0; s < 6; ++s)
  {
    by_strain[6 + s] = volume * bending.gradient[s];
    for (unsigned int r = 0; r < 6; ++r)
      by_strains[6 + s][6 + r] = volume * bending.hessian[6 * s + r];
  }
  strains.add(by_strain, by_strains, view);
}

const std::string &CosseratShellEffect::name() const
{
  static const std::string text = "cosserat shell";
  return text;
}

std::string CosseratShellEffect::description() const
{
  return "Shell of thickness h with an extensible director d_3 (Rubin): energy of membrane, transverse shear and "
         "thickness "
         "strains, Saint Venant-Kirchhoff with E and nu, and of bending with E h^3/(12 (1 - nu^2)); finite rotations. "
         "Does not lock in thin shells.";
}

std::optional<double> CosseratShellEffect::typical_energy(const double /*length*/) const
{
  return parameters.young * std::pow(parameters.thickness, 3);
}

void CosseratShellEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  const ShellMaterial material     = scaled(parameters, scales);
  const ShellReferences &reference = targets.shell_targets().reference;
  set.energies.push_back(std::make_shared<DensityPotential<ShellStrainEnergy>>(
      "shell strain", ShellStrainEnergy{material, reference, targets.cell_sizes}));
  set.energies.push_back(
      std::make_shared<DensityPotential<ShellBendingEnergy>>("shell bending", ShellBendingEnergy{material, reference}));
}
} // namespace pellicle
