// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/expression_of_place.h>
#include <pellicle/kinematics/height_field.h>
#include <pellicle/kinematics/rigid_bodies.h>
#include <pellicle/models/substrate.h>

#include <cmath>

namespace pellicle
{
void SubstrateParameters::bind(ParameterSection &section)
{
  section.choice("Shape", shape, {"plane", "sphere", "height field"},
                 "Surface of the rigid substrate: the plane z = 0, a sphere that touches it at the origin, or z = "
                 "Height.");
  section.number("Radius", radius, Range::positive(), dimensions::length, "Radius of the sphere.");
  section.choice("Side", side, {"outside", "inside"},
                 "Where the drop is: on top of the sphere (below z = 0), or at the bottom of a spherical cavity (above "
                 "z = 0).");
  section.word("Height", height,
               "Height H(x, y) of the substrate `height field`, for example 0.05*cos(2*pi*x)*cos(2*pi*y): numbers, x, "
               "y, + - * / ^, pi and functions that can be differentiated. It must be smooth where the line runs.");
  section.number("Plate distance", plate_distance, Range::positive().or_infinite(), dimensions::length,
                 "Height of a second plate above the plane z = 0, which squeezes the drop. inf: there is none.");
}

std::optional<Substrate> make_upper_plate(const SubstrateParameters &parameters, const double unit)
{
  if (!std::isfinite(parameters.plate_distance))
    return std::nullopt;
  const double h = parameters.plate_distance / unit;
  return Substrate{std::make_shared<HalfSpace>(Vector3<double>(0., 0., h), Vector3<double>(0., 0., -1.)),
                   PlaneChart{h, -1.}};
}

Substrate make_substrate(const SubstrateParameters &parameters, const double unit)
{
  const Vector3<double> up(0., 0., 1.);
  if (parameters.shape == "sphere")
  {
    const double radius = parameters.radius / unit, side = parameters.side == "outside" ? 1. : -1.;
    return {std::make_shared<Ball>(Vector3<double>(0., 0., -side * radius), radius, side < 0.),
            SphereChart{radius, side}};
  }
  if (parameters.shape == "height field")
  {
    const auto height = std::make_shared<const ExpressionOfPlace>(parameters.height, unit, unit);
    return {std::make_shared<HeightField>(height), HeightChart{height}};
  }
  return {std::make_shared<HalfSpace>(Vector3<double>(), up), PlaneChart{}};
}
} // namespace pellicle
