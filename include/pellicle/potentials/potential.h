// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/matrix3.h>
#include <pellicle/kinematics/vector3.h>
#include <pellicle/potentials/point_inputs.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace pellicle
{
/** How far a potential is to be differentiated. Each order includes the lower ones. */
enum class Order
{
  value,
  gradient,
  hessian
};

/** The inputs of all quadrature points of one cell: inputs[q * n_inputs + field offset + 3 * slot + component]. */
struct CellPoints
{
  std::size_t first_point = 0; ///< running number of the cell's first point
  unsigned int n_points   = 0;
  unsigned int n_inputs   = 0; ///< of all fields of the scene together
  const double *inputs    = nullptr;
  unsigned int region     = 0; ///< of the cell, index into the surface's list of regions
};

/**
 * Sums over potentials of value, gradient and Hessian with respect to the inputs, at each point of one cell. Per unit
 * of parametric area: quadrature weights enter when `assembly` contracts the sums with the shape tables.
 */
struct PointSums
{
  unsigned int n_inputs = 0;
  std::vector<double> value;    ///< [q]
  std::vector<double> gradient; ///< [q * n_inputs + i]
  std::vector<double> hessian;  ///< [(q * n_inputs + i) * n_inputs + j], symmetric

  void reset(const unsigned int n_points, const unsigned int inputs, const Order order)
  {
    n_inputs = inputs;
    value.assign(n_points, 0.);
    if (order >= Order::gradient)
      gradient.assign(std::size_t(n_points) * inputs, 0.);
    if (order == Order::hessian)
      hessian.assign(std::size_t(n_points) * inputs * inputs, 0.);
  }
};

/** The part of a scene over which a potential is integrated. */
struct Where
{
  enum class Part
  {
    surface, ///< all cells
    region,  ///< the cells of one region
    edge,    ///< an edge loop
    bulk     ///< a body
  };
  Part part = Part::surface;
  std::string name; ///< of the region, the edge loop or the body
};

/**
 * One term of the variational principle, seen from a cell: it only adds. A potential knows neither shape functions nor
 * unknowns.
 *
 * The value at a point is a density per unit of parametric area (on an edge loop: of parametric length, in a body: of
 * parametric volume); the potential is its integral over where().
 */
class Potential
{
public:
  virtual ~Potential() = default;

  /** Name under which it is reported, e.g. "helfrich bending". */
  virtual const std::string &name() const = 0;

  /** Where it acts. */
  virtual const Where &where() const
  {
    static const Where everywhere;
    return everywhere;
  }

  /** The fields it reads, in the order of the offsets given to add(). */
  virtual std::vector<FieldUse> fields() const = 0;

  /**
   * True if the integral does not change when the surface is parametrised anew. Only if all listed potentials are may
   * the tangential equations be replaced by mesh equations (doc/architecture.md, contract 5).
   */
  virtual bool reparametrisation_invariant() const = 0;

  /**
   * Adds `factor` times the density and its derivatives at all points of a cell.
   *
   * @param field_offsets  for each of fields(): where its inputs start within the inputs of a point.
   */
  virtual void add(const CellPoints &points, const unsigned int *field_offsets, double factor, Order order,
                   PointSums &sums) const = 0;
};

/**
 * Where a density with hand-written derivatives adds them at one point, in blocks of three: field (in the density's own
 * order) and slot (0 value, 1 ",1", 2 ",2", ...).
 */
class PointDerivativeView
{
public:
  PointDerivativeView(double *gradient, double *hessian, const unsigned int n_inputs, const unsigned int *field_offsets,
                      const double factor)
      : gradient(gradient)
      , hessian(hessian)
      , n_inputs(n_inputs)
      , offsets(field_offsets)
      , factor(factor)
  {
  }

  /** Whether second derivatives are wanted. */
  bool wants_hessian() const { return hessian != nullptr; }

  void add_gradient(const unsigned int field, const unsigned int slot, const Vector3<double> &g) const
  {
    double *const target = gradient + offsets[field] + 3 * slot;
    for (unsigned int c = 0; c < 3; ++c)
      target[c] += factor * g[c];
  }

  /** Adds the block d2/(d a d b) and, unless a and b are the same input, its transpose at (b, a). */
  void add_hessian(const unsigned int field_a, const unsigned int slot_a, const unsigned int field_b,
                   const unsigned int slot_b, const Matrix3 &block) const
  {
    const unsigned int a = offsets[field_a] + 3 * slot_a, b = offsets[field_b] + 3 * slot_b;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        hessian[(a + i) * n_inputs + b + j] += factor * block(i, j);
    if (a != b)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          hessian[(b + j) * n_inputs + a + i] += factor * block(i, j);
  }

private:
  double *gradient;
  double *hessian;
  unsigned int n_inputs;
  const unsigned int *offsets;
  double factor;
};
} // namespace pellicle
