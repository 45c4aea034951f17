// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/contact_elements.h>
#include <pellicle/assembly/contact_search.h>
#include <pellicle/assembly/pair_term.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/kinematics/gap_second_variation.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * The area that a contact pressure acts on, and with it what is kept of the tangent. p: multiplier, t = [p - eps g]_+,
 * phi = (t^2 - p^2)/(2 eps), the augmented form of -p g; N, Dd g as in ClosestPoint.
 *
 * | measure           | energy | force        | tangent                                                              |
 * |-------------------|--------|--------------|----------------------------------------------------------------------|
 * | `reference`       | phi dA | -t N dA      | (eps N N^T - t Dd g) dA: p per reference area, no terms of dJ         |
 * | `current`         | phi da | derivative   | (135) of Sauer 2014 complete: also -t (N dJ^T + dJ N^T) + phi DdJ     |
 * | `current_reduced` | phi da | -t N da (66) | its derivative (145), unsymmetric: - t N dJ^T                         |
 *
 * The force of `current_reduced` lacks phi dJ, which vanishes where g = 0, and derives from no energy.
 */
enum class ContactMeasure
{
  reference,
  current,
  current_reduced
};

/** Which gaps a pair holds back. */
enum class ContactSides
{
  one, ///< g >= 0, the pressure only pushes
  two  ///< g = 0: a line that liquid pulls along pushes or pulls (q of (15) and (61), Sauer 2014)
};

/** How surfaces resist each other. */
struct ContactLaw
{
  double penalty = 0.; ///< eps > 0: pressure per depth
  SearchLimits limits;
  std::string second_variation = "full"; ///< one of gap_second_variations()
  ContactMeasure measure       = ContactMeasure::reference;
  /** Slave points in each direction of a cell beyond degree + 1. The master's shape functions have kinks within slave
   * cells of another mesh, which more points integrate better. */
  unsigned int extra_gauss_points = 0;
  ContactSides sides              = ContactSides::one;
};

/** A slave point as it was last seen. */
struct ContactPoint
{
  double multiplier = 0.; ///< p
  double pressure   = 0.; ///< t = [p - eps g]_+ per unit of the measure's area, without [ ]_+ on two sides
  std::optional<ContactPartner> partner; ///< none: too far, or beside the master
};

/**
 * Frictionless contact of a slave surface or line with a master that deforms: every slave point has g >= 0 to its
 * closest point of the master, enforced by penalty and multiplier,
 *
 *     energy = sum over points ([p - eps g]_+^2 - p^2)/(2 eps) dA
 *
 * whose derivative turns a point on and off by itself; Newton's method on it is an active-set method. With p = 0 this
 * is a penalty. augment() moves the pressure to the multipliers (Uzawa), after which the remaining gap shrinks.
 *
 *     pairs.evaluate(x, Order::hessian) ... Newton steps until equilibrium, then
 *     while (pairs.augment().relative() > tolerance) { Newton steps again }
 */
class ContactPairs : public PairTerm
{
public:
  /** `reference`: positions at which areas are measured. Throws UserError unless eps > 0 and the variation exists. */
  ContactPairs(const SurfaceCells &slave, SurfaceCells master, const NodalVectors &reference, const ContactLaw &law,
               std::string name = "contact");
  /** A slave with points of its own choice, such as a line, which has no current measure (asserted). */
  ContactPairs(SlavePoints slave, SurfaceCells master, const ContactLaw &law, std::string name = "contact");

  const std::string &name() const override { return own_name; }
  void distribute(const Communicator &communicator) override { slave_points.distribute(communicator); }

  /** Finds closest points at these positions and forms energy and elements. Throws SolveError as ContactSearch does,
   * and for touching points at centres of curvature. */
  ContactElements evaluate(const NodalVectors &positions, Order order) override;

  MultiplierChange pending() const override;
  /** p <- t */
  MultiplierChange augment() override;
  /** Multipliers, and numbers of the partners' cells: among equally near ones the last one stays. */
  std::vector<double> memory() const override;
  void recall(const std::vector<double> &memory) override;

  /** [cell * n_gauss + q], as last evaluated; only those of this process are kept up to date. */
  const std::vector<ContactPoint> &points() const { return states; }
  const SlavePoints &slave() const { return slave_points; }
  const SurfaceCells &master() const { return search.master(); }

private:
  bool touches(const ContactPoint &state) const;
  void add_point(const WalkPoint &at, double area, const ContactPoint &state, ContactElementSums &sums) const;

  std::string own_name;
  SlavePoints slave_points;
  ContactSearch search;
  ContactLaw law;
  const GapSecondVariation &second_variation;
  std::vector<ContactPoint> states;
};
} // namespace pellicle
