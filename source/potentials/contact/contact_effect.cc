// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/contact/contact_effect.h>

namespace pellicle
{
const std::string &ContactEffect::name() const
{
  static const std::string text = "contact";
  return text;
}

std::string ContactEffect::description() const
{
  return "Frictionless contact with the rigid bodies of section Substrate: gap >= 0, pressure >= 0, one of them zero.";
}
} // namespace pellicle
