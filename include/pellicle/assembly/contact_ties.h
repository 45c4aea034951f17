// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/contact_elements.h>
#include <pellicle/assembly/contact_search.h>
#include <pellicle/assembly/pair_term.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pellicle
{
/** A slave point that sticks to a material point of the master. */
struct TiedPoint
{
  std::size_t slave_cell  = 0;
  unsigned int q          = 0; ///< number of the point in its cell
  std::size_t master_cell = 0;
  std::array<double, 2> xi{}; ///< xi_0
  std::vector<double> shapes; ///< M_K(xi_0)
  Vector3<double> multiplier; ///< f
  Vector3<double> traction;   ///< f - eps g, as last evaluated
};

/**
 * Sticking contact: g = x - x_m(cell_0, xi_0) = 0 at every tied slave point. The vector contains the normal gap and the
 * tangential ones (17) of Sauer 2014, but no parameters, which jump where a point changes cell:
 *
 *     energy = sum over points (-f . g + (eps/2) |g|^2) dA,  f - eps g: traction of the master on the slave
 *
 * Quadratic: the matrix is constant, Dd g = 0. Areas are of the reference state. augment(): f <- f - eps g (Uzawa).
 * On a line f contains q and q_alpha, which act on the contact line of a drop that does not slip.
 */
class ContactTies : public PairTerm
{
public:
  /** Ties all slave points that have a partner at these positions within the limits to the material point that is then
   * closest; others are left free. Positions are also the reference for areas. Throws UserError unless eps > 0. */
  ContactTies(const SurfaceCells &slave, SurfaceCells master, const NodalVectors &positions, double penalty,
              const SearchLimits &limits, std::string name = "tie");
  /** The same for a slave with points of its own choice, such as a line. */
  ContactTies(SlavePoints slave, SurfaceCells master, const NodalVectors &positions, double penalty,
              const SearchLimits &limits, std::string name = "tie");

  const std::string &name() const override { return own_name; }
  void distribute(const Communicator &communicator) override { slave.distribute(communicator); }
  ContactElements evaluate(const NodalVectors &positions, Order order) override;
  MultiplierChange pending() const override;
  /** f <- f - eps g */
  MultiplierChange augment() override;
  /** Multipliers. */
  std::vector<double> memory() const override;
  void recall(const std::vector<double> &memory) override;
  /** Nodes of the cells that are tied, on both sides. */
  std::vector<std::size_t> material_nodes() const override;

  const std::vector<TiedPoint> &points() const { return ties; }
  /** x - x_m of a tied point. */
  Vector3<double> gap(const TiedPoint &tie, const NodalVectors &positions) const;

private:
  std::string own_name;
  SlavePoints slave;
  SurfaceCells master;
  double penalty;
  std::vector<TiedPoint> ties;
};
} // namespace pellicle
