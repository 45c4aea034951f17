// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/energies/incompressible_rubber_skin.h>

namespace pellicle
{
void IncompressibleRubberSkin::bind(ParameterSection &section)
{
  section.number("Shear modulus", shear_modulus, Range::positive(), dimensions::tension,
                 "Surface shear modulus mu, that of the rubber times the thickness at the reference, in "
                 "(mu/2)(l1^2 + l2^2 + 1/(l1 l2)^2 - 3) per area of the reference, l1 and l2 the principal stretches. "
                 "The area modulus for small strains is 3 mu. Positive tensions pull.");
}

std::string IncompressibleRubberSkin::description()
{
  return "Elastic skin of incompressible rubber: (mu/2)(l1^2 + l2^2 + 1/(l1 l2)^2 - 3) per area of the reference, l1 "
         "and l2 the principal stretches.";
}
} // namespace pellicle
