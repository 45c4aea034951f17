// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/energies/skalak_skin.h>

namespace pellicle
{
void SkalakSkin::bind(ParameterSection &section)
{
  section.number("Shear modulus", shear_modulus, Range::positive(), dimensions::tension,
                 "Surface shear modulus G in (G/4)(I1^2 + 2 I1 - 2 I2 + C I2^2) per area of the reference, "
                 "I1 = l1^2 + l2^2 - 2 and I2 = (l1 l2)^2 - 1 of the principal stretches l1 and l2. Positive tensions "
                 "pull.");
  section.number("Area dilation parameter", area_dilation_parameter,
                 Range{-0.5, Range::any().upper, true, false, false}, dimensions::none,
                 "Resistance C to change of area: the area modulus for small strains is G (1 + 2 C). Red blood cells "
                 "have C >> 1; for C < 0 a large stretch is unstable.");
}

std::string SkalakSkin::description()
{
  return "Elastic skin of red blood cells (Skalak): (G/4)(I1^2 + 2 I1 - 2 I2 + C I2^2) per area of the reference, "
         "I1 = l1^2 + l2^2 - 2, I2 = (l1 l2)^2 - 1, l1 and l2 the principal stretches.";
}
} // namespace pellicle
