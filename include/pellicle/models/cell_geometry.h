// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <deal.II/base/polynomial.h>

#include <array>
#include <vector>

namespace pellicle
{
/** Position and its parametric derivatives at a point of a cell. On a meridian those with respect to the second
 * parameter are zero. */
struct CellPoint
{
  Vector3<double> x;
  std::array<Vector3<double>, 2> first;  ///< x,1 x,2
  std::array<Vector3<double>, 3> second; ///< x,11 x,12 x,22
};

/** A point of the surface by cell and unit coordinates (a meridian uses the first only). */
struct CellSite
{
  std::size_t cell = 0;
  std::array<double, 2> xi{};
};

/**
 * The piecewise polynomial surface (or the bare meridian, not revolved) at any point of its cells, for searches that go
 * where no table was made. Refers to its arguments, which must outlive it.
 */
class CellGeometry
{
public:
  CellGeometry(const SurfaceDiscretization &discretization, const NodalVectors &positions);

  std::size_t n_cells() const { return surface.n_cells; }
  unsigned int n_parameters() const { return surface.kind == SurfaceDiscretization::Kind::surface ? 2 : 1; }

  /** Also outside the unit cell, where the cell's polynomial is continued. */
  CellPoint at(const CellSite &site) const;

  /** Samples of every cell lie on a grid of so many points a direction, edges included: 2 k + 3, fine enough for each
   * feature of a polynomial of degree k to start a Newton iteration. */
  unsigned int n_samples_a_direction() const { return n_grid; }
  unsigned int n_samples() const { return n_parameters() == 2 ? n_grid * n_grid : n_grid; }
  std::array<double, 2> sample_coordinates(unsigned int sample) const;
  const Vector3<double> &sample(const std::size_t cell, const unsigned int i) const
  {
    return samples[cell * n_samples() + i];
  }

private:
  const SurfaceDiscretization &surface;
  const NodalVectors &positions;
  std::vector<dealii::Polynomials::Polynomial<double>> basis; ///< one-dimensional, of FE_Q's support points
  unsigned int n_grid;
  std::vector<Vector3<double>> samples;
};
} // namespace pellicle
