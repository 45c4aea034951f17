// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace pellicle
{
/** How many parametric derivatives of a field a density reads. */
enum class Derivatives
{
  none   = 1, ///< the value
  first  = 3, ///< value, ,1 ,2
  bulk   = 4, ///< value, ,1 ,2 ,3, in a body
  second = 6  ///< value, ,1 ,2, ,11 ,12 ,22
};

/** Number of input vectors ("slots": value, ,1, ,2, ...) of a field with these derivatives. */
constexpr unsigned int n_slots(const Derivatives derivatives)
{
  return static_cast<unsigned int>(derivatives);
}

/** What a solve does with a field. */
enum class FieldRole
{
  independent, ///< an unknown of Newton's method
  internal,    ///< eliminated at every state by its own block of equations (the moment of the (x, P) form)
  multiplier   ///< an unknown in which the sum of energies is linear, or concave and nearly quadratic: a Lagrange
               ///< multiplier at every point
};

/** What the values of a field are. */
enum class FieldSpace
{
  vectors,             ///< of R^3, at all nodes
  material_places,     ///< of R^3, where the nodes of bodies are in the undeformed body; fixed but for conditions
  edge_conormals,      ///< unit vectors at the nodes of edge loops
  edge_scalars,        ///< numbers at the nodes of edge loops, the first component of the vectors
  bulk_scalars,        ///< numbers at the pressure nodes of bodies, the first component of the vectors
  unit_vectors,        ///< of length one at all nodes of the surface
  lower_degree_vectors ///< of R^3, continuous, of degree k - 1
};

/** A field that a density reads: its name, how far it is differentiated, its role, and what its values are. */
struct FieldUse
{
  std::string_view name;
  Derivatives derivatives = Derivatives::first;
  FieldRole role          = FieldRole::independent;
  FieldSpace space        = FieldSpace::vectors;
};

/**
 * Value and parametric derivatives of one field at one point.
 *
 * | code            | symbol       |
 * |-----------------|--------------|
 * | value           | x            |
 * | d1, d2          | x,1  x,2     |
 * | d11, d12, d22   | x,11 x,12 x,22, on a surface |
 * | d3              | x,3, in a body, in the place of d11 |
 */
template <typename Number>
struct FieldAtPoint
{
  std::array<Vector3<Number>, 6> slots{};

  const Vector3<Number> &value() const { return slots[0]; }
  const Vector3<Number> &d1() const { return slots[1]; }
  const Vector3<Number> &d2() const { return slots[2]; }
  const Vector3<Number> &d11() const { return slots[3]; }
  const Vector3<Number> &d12() const { return slots[4]; }
  const Vector3<Number> &d22() const { return slots[5]; }
  const Vector3<Number> &d3() const { return slots[3]; }
};

/** All fields that a density declares, in the order of its declaration. */
template <typename Number, unsigned int n_fields>
using PointInputs = std::array<FieldAtPoint<Number>, n_fields>;

/** What a density may know of a point besides the fields. Densities keep their own data per point (reference metric,
 * history). */
struct PointData
{
  std::size_t index =
      0; ///< running number of the quadrature point within its set of cells: cell * (points a cell) + point
  unsigned int region = 0; ///< index into the surface's list of regions; 0: the membrane outside all others
};
} // namespace pellicle
