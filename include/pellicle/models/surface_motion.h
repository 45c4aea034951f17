// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/base/observer.h>
#include <pellicle/models/equilibrium_search.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/solvers/energy_balance.h>
#include <pellicle/solvers/time_stepping.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** What a motion works with. */
struct MotionSetting
{
  const NewtonParameters &newton;
  SurfaceProblem &problem;
  LinearSolver &solver;
  const Communicator &communicator;
  Timing &timing;
};

/**
 * A surface that moves down its energy against the listed dissipation potentials, from the problem's state at time 0.
 * What has no friction is in equilibrium with the rest at every time, at time 0 as well. After a failure the problem is
 * at the last state that was reached.
 */
class SurfaceMotion
{
public:
  virtual ~SurfaceMotion() = default;

  /** To a later time; iterations are reported to the observer as those of `step`. Never throws for a motion that
   * fails: the result says why. */
  virtual StepResult advance(double to, int step, Observer &observer) = 0;

  double time() const { return now; }
  /** Energy dissipated per unit of time at the present time; internal units. */
  double dissipation() const { return power; }
  const EnergyBalance &balance() const { return books; }
  /** Writes what make_motion() needs, beside the problem's state, to go on. */
  virtual void write(Archive &archive) { exchange(archive); }

protected:
  /** Settles what has no friction, within an instant: throws SolveError. Or goes on as an archive says. */
  SurfaceMotion(const MotionSetting &setting, double interval, Archive *earlier);
  void exchange(Archive &archive) { archive | now | power | books; }
  /** The minimum over a step: false, at the state before, if Newton's method fails (`result` says why). */
  bool solve_step(double length, int step, Observer &observer, StepResult &result);

  MotionSetting setting;
  double now   = 0.;
  double power = 0.;
  EnergyBalance books{0.};
};

/** Throws UserError where friction acts at material points of a surface that is free to move, and nothing but friction
 * says where these go: a fluid membrane flows without cost. */
void check_material_points(const PotentialSet &set, bool is_held);

/**
 * The motion that section Time asks for. Throws UserError where nothing dissipates, where material points are not
 * defined (a free surface on which no energy holds the points), or where the integrator cannot be used; SolveError if
 * nothing balances the state at time 0.
 *
 * @param earlier  of a motion that goes on from the problem's state, what SurfaceMotion::write() wrote; null: it
 * begins.
 */
std::unique_ptr<SurfaceMotion> make_motion(const TimeParameters &time, const MotionSetting &setting,
                                           Archive *earlier = nullptr);
} // namespace pellicle
