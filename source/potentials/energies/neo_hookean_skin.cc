// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/energies/neo_hookean_skin.h>

namespace pellicle
{
void NeoHookeanSkin::bind(ParameterSection &section)
{
  section.number(
      "Shear modulus", shear_modulus, Range::positive(), dimensions::tension,
      "Surface shear modulus mu in (mu/2)(l1^2 + l2^2 - 2 - 2 ln(l1 l2)) per area of the reference, l1 and "
      "l2 the principal stretches. The area modulus for small strains is mu as well. Positive tensions pull.");
}

std::string NeoHookeanSkin::description()
{
  return "Elastic skin, neo-Hookean: (mu/2)(l1^2 + l2^2 - 2 - 2 ln(l1 l2)) per area of the reference, l1 and l2 the "
         "principal stretches.";
}
} // namespace pellicle
