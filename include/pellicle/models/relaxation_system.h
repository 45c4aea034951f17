// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/assembler.h>
#include <pellicle/assembly/bordered_system.h>
#include <pellicle/base/expanded_pattern.h>
#include <pellicle/base/timing.h>
#include <pellicle/solvers/implicit_system.h>

#include <vector>

namespace pellicle
{
class SurfaceProblem;

/** Throws the UserError that a tilt modulus of infinity makes a system of index 2. */
[[noreturn]] void refuse_index_2();

/**
 * Unit vectors O_I at the nodes of a surface that is held, turning down their energy against friction. With M the
 * second derivative of the dissipation potentials, which does not depend on O, and h_I = dE/dO_I + sum_J M_IJ O_J', the
 * three equations of a node are
 *
 *     (I - O_I O_I) h_I + O_I (O_I . O_I' + gamma (|O_I|^2 - 1)) = 0:
 *
 * two of motion and one that keeps the length, whose error decays as exp(-2 gamma t). Fields that are multipliers
 * (shear of directors) have their own equations dE/dq = 0 and are algebraic: of index 1 if E is strictly concave in
 * them. Unknowns of a node are the components of O_I along O_I(0) and along two directions across it (one on a
 * meridian), and increments of the multipliers.
 */
class RelaxationSystem : public ImplicitSystem
{
public:
  /**
   * From the problem's present state, in its present chart; keeps references to it. `gamma` is about one over a time of
   * interest. Throws UserError where the surface is free to move or a potential is not of the kind above.
   */
  RelaxationSystem(SurfaceProblem &problem, double gamma, const Communicator &communicator, Timing &timing);

  const std::vector<bool> &is_differential() const override { return differential; }
  void residual(double time, const std::vector<double> &y, const std::vector<double> &rate,
                std::vector<double> &result) override;
  const SparseMatrix &tangent(double time, const std::vector<double> &y, const std::vector<double> &rate,
                              double alpha) override;
  double dissipated_power(const std::vector<double> &y, const std::vector<double> &rate) override;

  /** The unknowns of the present state. */
  const std::vector<double> &start() const { return y_start; }
  /** Nodal values of all fields. */
  FieldValues fields(const std::vector<double> &y) const;

private:
  /** Unknowns first .. first + count - 1 are the components of a unit vector. */
  struct UnitVector
  {
    std::size_t first  = 0;
    unsigned int count = 0;
  };

  static Numbering numbering_of(const SurfaceProblem &problem);
  void make_general_pattern();
  void assemble(Assembler &assembler, const PotentialSet &set, const FieldValues &values, Order order);
  /** M v, complete on every process. */
  std::vector<double> friction_times(const std::vector<double> &rate) const;
  /** O . O' + gamma (|O|^2 - 1). */
  double length_equation(const UnitVector &vector, const std::vector<double> &y, const std::vector<double> &rate) const;

  const SurfaceProblem &problem;
  const double gamma;
  const Communicator &communicator;
  Timing &timing;
  PotentialSet energies;
  Assembler assembler;
  BorderedSystem system;
  ExpandedPattern pattern;
  std::vector<UnitVector> unit_vectors;
  std::vector<bool> differential;
  FieldValues fields_start;
  std::vector<double> y_start;
  std::vector<double> friction; ///< values of M in the system's pattern
  SparseMatrix general;         ///< dF/dy + alpha dF/dy'
  std::vector<int> origin;      ///< of its entries in the system's pattern, or nowhere
};
} // namespace pellicle
