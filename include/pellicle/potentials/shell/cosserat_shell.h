// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/effect.h>
#include <pellicle/potentials/shell/shell_material.h>
#include <pellicle/potentials/shell/shell_strain_derivatives.h>

#include <memory>
#include <vector>

namespace pellicle
{
/** Names of the fields of a shell beside the position: the director d_3, no unit vector, and the six components of the
 * stress S11 S22 S33 and S23 S13 S12 in Cartesian coordinates of the reference. */
constexpr const char *shell_director = "shell director";
constexpr const char *shell_stress_1 = "shell stress 1";
constexpr const char *shell_stress_2 = "shell stress 2";

/** References of the quadrature points, by PointData::index. */
using ShellReferences = std::shared_ptr<const std::vector<ShellReference>>;

const ShellReference &reference_at(const ShellReferences &references, const PointData &data);

/**
 * Energy of the strains Ebar (membrane, transverse shear and thickness), integral of (m/rho_0) W(Ebar), in a mixed form
 * that does not lock. Of a thin shell these strains cost so much more than bending that polynomials, which cannot be
 * free of all of them at once, do not bend at all. After Arnold & Brezzi (Math. Comp. 66, 1, 1997) a share t of W, as
 * much as bending costs on the scale of a cell, is kept, and the rest is written with a stress of its own (Hellinger-
 * Reissner):
 *
 *     w = (m/rho_0) {t W(Ebar) + (1 - t) (S : Ebar - W*(S))},   t = min(1/2, c h^2/s^2),
 *
 * s the distance of neighbouring nodes. The largest value over S at every point would be (m/rho_0) W(Ebar), at the
 * stress of Ebar: the form is exact for all t, and S does not jump where t does. S is continuous and of one degree less
 * than the position, so that strains are only seen where they are more than the error of interpolation.
 *
 * W is a sum of two parts, transverse shear and all else, each with its own c, found by experiment (doc/numerics.md):
 * the share of membrane strains is what is left of locking and is kept small; that of transverse shear decides how far
 * a force at a point pushes the surface away from the director, which else are tied by S alone.
 */
struct ShellStrainEnergy
{
  static constexpr std::array<FieldUse, 4> fields{
      {{"position", Derivatives::first, FieldRole::independent},
       {shell_director, Derivatives::first, FieldRole::independent},
       {shell_stress_1, Derivatives::none, FieldRole::multiplier, FieldSpace::lower_degree_vectors},
       {shell_stress_2, Derivatives::none, FieldRole::multiplier, FieldSpace::lower_degree_vectors}}};
  static constexpr bool reparametrisation_invariant = false;
  static constexpr double kept_plain                = 0.3;
  static constexpr double kept_shear                = 10.;

  ShellMaterial material; ///< internal units
  ShellReferences reference;
  std::shared_ptr<const std::vector<double>> squared_node_distance; ///< s^2, by PointData::index

  /** The shares t of membrane and thickness strains, and of transverse shear. */
  struct Shares
  {
    double plain, shear;
  };
  Shares kept(const PointData &data) const;

  template <typename Number>
  Number density(const PointInputs<Number, 4> &inputs, const PointData &data) const
  {
    const ShellReference &D = reference_at(reference, data);
    const ShellStrains<Number> strains(inputs[0], inputs[1], D, D.first_moments(material.thickness));
    const Symmetric6<Number> S = stress(inputs);
    const Weights P            = weights(D.normal, data);
    Number product             = Number(0.);
    for (unsigned int s = 0; s < 6; ++s)
      for (unsigned int r = 0; r < 6; ++r)
        product += P[s][r] * S[s] * strains.strain[r];
    const Number kept_energy = kept_part(strains.strain, D.normal, data);
    const Number dual_energy = dual_part(S, D.normal, data);
    return D.volume(material.thickness) * (kept_energy + product - dual_energy);
  }

  void add_derivatives(const PointInputs<double, 4> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;

private:
  /** The sum of (1 - t) S : Ebar over both parts is that of S_s P_sr Ebar_r. */
  using Weights = std::array<std::array<double, 6>, 6>;
  Weights weights(const Vector3<double> &N, const PointData &data) const;

  template <typename Number>
  Number kept_part(const Symmetric6<Number> &E, const Vector3<double> &N, const PointData &data) const
  {
    const Shares t = kept(data);
    return t.plain * material.plain_energy(E, N) + t.shear * material.shear_energy(E, N);
  }
  template <typename Number>
  Number dual_part(const Symmetric6<Number> &S, const Vector3<double> &N, const PointData &data) const
  {
    const Shares t = kept(data);
    return (1. - t.plain) * material.plain_complementary_energy(S, N) +
           (1. - t.shear) * material.shear_complementary_energy(S, N);
  }
  template <typename Number>
  static Symmetric6<Number> stress(const PointInputs<Number, 4> &inputs)
  {
    const Vector3<Number> &a = inputs[2].value(), &b = inputs[3].value();
    return {{a[0], a[1], a[2], b[0], b[1], b[2]}};
  }
};

/** Energy of the couples beta_a, integral of (m/rho_0) (1/2) beta_a . K^ab . beta_b. */
struct ShellBendingEnergy
{
  static constexpr std::array<FieldUse, 2> fields{{{"position", Derivatives::first, FieldRole::independent},
                                                   {shell_director, Derivatives::first, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  ShellMaterial material; ///< internal units
  ShellReferences reference;

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData &data) const
  {
    const ShellReference &D = reference_at(reference, data);
    const ShellStrains<Number> strains(inputs[0], inputs[1], D, D.first_moments(material.thickness));
    return D.volume(material.thickness) * material.bending_energy(strains.couple, D);
  }

  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const;
};

/** The effect "cosserat shell". */
class CosseratShellEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  /** E h^3: what bending costs. */
  std::optional<double> typical_energy(double length) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  ShellMaterial parameters; ///< the user's units
};
} // namespace pellicle
