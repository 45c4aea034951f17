// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/energies/tu_ou_yang_skin.h>

namespace pellicle
{
void TuOuYangSkin::bind(ParameterSection &section)
{
  section.number(
      "Young modulus", young_modulus, Range::positive(), dimensions::tension,
      "Surface Young's modulus Y, the three-dimensional one times the thickness, in "
      "(k_d/2)(tr E)^2 + (k_s/2) det E per area of the reference, k_d = Y/(1 - nu^2), k_s = -2 Y/(1 + nu), E "
      "Green's strain. Positive tensions pull.");
  section.number(
      "Poisson ratio", poisson_ratio, Range{-1., 1., true, true, false}, dimensions::none,
      "Poisson ratio nu in the surface: shear modulus Y/(2(1 + nu)), area modulus Y/(2(1 - nu)). At most 1/2 "
      "for a skin of isotropic material.");
}

std::string TuOuYangSkin::description()
{
  return "Elastic skin for small strains (Tu & Ou-Yang): (k_d/2)(tr E)^2 + (k_s/2) det E per area of the reference, E "
         "Green's strain, k_d = Y/(1 - nu^2), k_s = -2 Y/(1 + nu).";
}
} // namespace pellicle
