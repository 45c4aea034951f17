// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/effect.h>

namespace pellicle
{
struct DirectorParameters
{
  double tilt_modulus     = 1.;
  double bending_modulus  = 1.;
  double gaussian_modulus = 0.;
  std::string shear       = "mixed";
  double domain_tilt      = 1.; ///< k_t inside a lipid domain over that outside
  double domain_bending   = 1.; ///< K inside over K outside

  void bind(ParameterSection &section);
  /** Whether a lipid domain differs from the rest. */
  bool has_domain() const { return domain_tilt != 1. || domain_bending != 1.; }
  /** Whether the shear k_t O_tan is a field, and jumps at the line around the domain. */
  bool shear_jumps() const;
  /** By region: that of the membrane, and where it differs that of the domain. */
  std::vector<DirectorLaw> laws() const;
};

/**
 * The effect "director": the energies "tilt" (k_t/2) |O_tan|^2 and "director gradient" (K/2) |grad O|^2
 * of (23) of Hu, Zhang & E 2007, the former unless k_t = 0. The null Lagrangian is not among them, see
 * null_lagrangian(); but where its weight mu_2 jumps at a line, the jump times its integral over the domain, the energy
 * "domain null lagrangian", which depends on the directors of the line alone.
 */
class DirectorEffect : public Effect
{
public:
  const std::string &name() const override;
  std::string description() const override;
  void bind(ParameterSection &section) override { parameters.bind(section); }
  void check() const override;
  std::optional<double> typical_energy(double length) const override;
  void prepare(const Scales &scales, SceneTargets &targets) const override;
  /** By Director/Tilt modulus, unless it is 0 or infinite. */
  std::vector<ParameterDerivative> derivatives(const Scales &scales, const SceneTargets &targets) const override;
  void contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const override;

  DirectorParameters parameters;
};

/** k_0 = min(c K/h^2, 9 k_t/10), c = 1/10 on a surface that is held and 1 on one that moves, at every quadrature point,
 * the part of the tilt modulus that MixedTiltEnergy leaves in displacement form; null while the scene is only checked.
 */
std::shared_ptr<const std::vector<double>> direct_tilt_modulus(const DirectorLaw &law, const SceneTargets &targets);

/** (K + kappa_G)/2 e^ab (O,a x O,b) . O, named "null lagrangian": for reports. */
std::shared_ptr<const Potential> null_lagrangian(const DirectorLaw &law);
} // namespace pellicle
