// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/gap.h>
#include <pellicle/potentials/potential.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** The area per which pressures and energies of contact are counted. */
enum class ContactMeasure
{
  /** Of the reference, dA. No term with a change of area, yet the same equilibria: the pressure per current area is
   * lambda dA/da. */
  reference,
  /** Of the current surface, da = J dxi1 dxi2: Pi_c of Sauer 2014, all eight terms of (135), for comparison. */
  current
};

/** Multipliers and areas at all quadrature points, by PointData::index. */
struct ContactPoints
{
  std::shared_ptr<const std::vector<double>> multipliers;     ///< lambda >= 0, pressure; updated between solves
  std::shared_ptr<const std::vector<double>> reference_areas; ///< dA per unit of parametric area; only for dA
};

/**
 * Frictionless contact of the surface with a rigid body,
 *
 *     E = integral of ([lambda - eps g]_+^2 - lambda^2)/(2 eps) over the area,
 *
 * with the gap g of x, at every quadrature point (ContactResponse has the law). Per area
 *
 *     dE/dx = -t n_p,    d2E/dx dx = eps n_p n_p^T - t Hess g,    t = [lambda - eps g]_+.
 *
 * Several bodies are given as a NearestBody. SolveErrors of the body are passed on.
 */
class RigidContact : public Potential
{
public:
  /** @param penalty eps > 0, in units of pressure over length. */
  RigidContact(std::shared_ptr<const RigidBody> body, double penalty, ContactPoints points,
               ContactMeasure measure = ContactMeasure::reference, Where where = {});

  const std::string &name() const override;
  const Where &where() const override { return part; }
  std::vector<FieldUse> fields() const override;
  bool reparametrisation_invariant() const override { return false; }
  void add(const CellPoints &points, const unsigned int *field_offsets, double factor, Order order,
           PointSums &sums) const override;

private:
  std::shared_ptr<const RigidBody> body;
  double penalty;
  ContactPoints data;
  ContactMeasure measure;
  Where part;
};
} // namespace pellicle
