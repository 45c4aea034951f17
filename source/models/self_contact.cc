// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/models/self_contact.h>

#include <cmath>
#include <sstream>

namespace pellicle
{
namespace
{
constexpr double near_poles = 0.05; // in units of the radius of the sphere of equal area

std::string rounded(const double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}
} // namespace

std::optional<std::string> SelfContactWatch::look(const std::vector<std::pair<std::string, double>> &quantities,
                                                  const std::string &place)
{
  double area = 0., thickness = 0.;
  for (const auto &[name, value] : quantities)
    if (name == "area")
      area = value;
    else if (name == "axis_thickness")
      thickness = value;
    else if (name == "liquid_gas_area")
      return std::nullopt; // a drop may be flat
  // Zero: the axis misses the surface, as that of a torus does, or there is no such quantity.
  if (!(area > 0.) || !std::isfinite(thickness) || thickness == 0.)
    return std::nullopt;
  const double relative = thickness / std::sqrt(area / (4. * pi));
  const Contact found   = relative < 0. ? Contact::through : relative < near_poles ? Contact::near : Contact::none;
  if (found <= worst)
    return std::nullopt;
  worst                  = found;
  const std::string at   = place.empty() ? "" : "At " + place + " ";
  const std::string size = rounded(thickness);
  return at +
         (found == Contact::through ? "the membrane has gone through itself: axis_thickness is " + size + ". "
                                    : "the poles nearly touch: axis_thickness is " + size + ", " + rounded(relative) +
                                          " of the radius of the sphere of equal area. ") +
         "Contact of the membrane with itself is not part of the model: what comes with thinner shapes is no vesicle.";
}
} // namespace pellicle
