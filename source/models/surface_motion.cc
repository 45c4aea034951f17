// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/models/relaxation_system.h>
#include <pellicle/models/surface_motion.h>
#include <pellicle/solvers/ida_integrator.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double instant       = 1e-7;       // of an interval
constexpr double smallest_step = 1. / 1024.; // of an interval

/** Steps that minimise E + dt D((y - y_old)/dt). */
class MinimisingMotion : public SurfaceMotion
{
public:
  MinimisingMotion(const MotionSetting &of, const double interval, Archive *earlier)
      : SurfaceMotion(of, interval, earlier)
      , smallest(smallest_step * interval)
  {
  }

  StepResult advance(const double to, const int step, Observer &observer) override
  {
    StepResult result;
    result.converged =
        walk_time(now, to, smallest, [&](const double length) { return make_step(length, step, observer, result); });
    if (result.converged)
    {
      now            = to;
      result.failure = "";
    }
    return result;
  }

private:
  bool make_step(const double length, const int step, Observer &observer, StepResult &result)
  {
    const SurfaceState before = setting.problem.state();
    const double power_before = power;
    if (!solve_step(length, step, observer, result))
      return false;
    try
    {
      books.add_minimising_step(setting.problem.energy(), setting.problem.step_dissipation());
    }
    catch (const SolveError &error)
    {
      result.failure = error.what();
      power          = power_before;
      setting.problem.set_state(before);
      return false;
    }
    now += length;
    return true;
  }

  const double smallest;
};

/** Variable order and step. One that goes on starts the integrator anew, with short steps of first order. */
class IntegratedMotion : public SurfaceMotion
{
public:
  IntegratedMotion(const MotionSetting &of, const TimeParameters &time, Archive *earlier)
      : SurfaceMotion(of, time.interval(), earlier)
      , dissipated_before(books.dissipated())
      , energy_tolerance(time.energy_tolerance)
      , system(setting.problem, 1. / time.interval(), setting.communicator, setting.timing)
      , solver(make_linear_solver(setting.newton.linear_solver))
      , integrator(system, *solver, {time.relative_tolerance, time.absolute_tolerance}, now, system.start(),
                   now + time.interval())
  {
    if (earlier != nullptr)
      *earlier | has_warned;
    take_state();
  }

  void write(Archive &archive) override
  {
    exchange(archive);
    archive | has_warned;
  }

  StepResult advance(const double to, int /*step*/, Observer & /*observer*/) override
  {
    StepResult result;
    const IdaStatistics before = integrator.statistics();
    try
    {
      integrator.advance(to);
    }
    catch (const SolveError &error)
    {
      result.failure = error.what();
      return result;
    }
    now = to;
    take_state();
    books.set(setting.problem.energy(), dissipated_before + integrator.dissipated());
    const double error = std::abs(books.relative_error());
    if (error > energy_tolerance && !has_warned)
    {
      has_warned = true;
      result.warnings.push_back("At time " + exact_text(now) + " energy_balance_error is " + exact_text(error) +
                                ", more than Time/Energy tolerance = " + exact_text(energy_tolerance) +
                                ". Smaller tolerances of ida help.");
    }
    result.converged  = true;
    result.iterations = integrator.statistics().steps - before.steps;
    return result;
  }

private:
  void take_state()
  {
    SurfaceState state = setting.problem.state();
    state.fields       = system.fields(integrator.y());
    setting.problem.set_state(std::move(state));
    power = system.dissipated_power(integrator.y(), integrator.rate());
  }

  const double dissipated_before; ///< by the motion that goes on
  const double energy_tolerance;
  RelaxationSystem system;
  std::unique_ptr<LinearSolver> solver;
  IdaIntegrator integrator;
  bool has_warned = false;
};

void check_that_motion_is_defined(const SurfaceProblem &problem)
{
  const PotentialSet &set = problem.potentials();
  if (set.dissipations.empty())
    throw UserError("Time/End time is positive, but no listed effect dissipates: how fast anything moves is not "
                    "defined. List 'director friction', or set Time/End time = 0.");
  check_material_points(set, problem.numbering().n_unknowns_of(0) == 0);
}
} // namespace

void check_material_points(const PotentialSet &set, const bool is_held)
{
  PotentialSet statics = set;
  statics.dissipations.clear();
  if (!is_held && !is_reparametrisation_invariant(set) && is_reparametrisation_invariant(statics))
    throw UserError("The listed friction acts at material points, and on this surface, free to move, no effect says "
                    "where these go: a fluid membrane can flow without cost. Hold the surface (Surface/Motion = held), "
                    "or list an elastic skin.");
}

// Two steps so short that nothing with friction moves far. What has none settles in the first one; where that takes a
// jump of something with friction, against a constraint, the second one forgets the impulse.
SurfaceMotion::SurfaceMotion(const MotionSetting &of, const double interval, Archive *earlier)
    : setting(of)
{
  if (earlier != nullptr)
  {
    exchange(*earlier);
    return;
  }
  Observer nobody;
  StepResult result;
  for (int i = 0; i < 2; ++i)
    if (!solve_step(instant * interval, 0, nobody, result))
      throw SolveError("The start of the motion cannot be balanced: " + result.failure);
  books = EnergyBalance(setting.problem.energy());
}

bool SurfaceMotion::solve_step(const double length, const int step, Observer &observer, StepResult &result)
{
  SurfaceProblem &problem   = setting.problem;
  const SurfaceState before = problem.state();
  NewtonParameters newton   = setting.newton;
  newton.initial_drag       = 0.; // friction is drag enough
  problem.begin_time_step(length);
  EquilibriumSearch search(newton, problem, setting.solver, setting.timing, before.fields[0], step, observer);
  const bool done = search.run();
  result.iterations += search.result().iterations;
  result.rejected += search.result().rejected;
  result.relative_residual = search.result().relative_residual;
  result.failure           = search.result().failure;
  if (done)
    power = 2. * problem.step_dissipation() / length;
  else
    problem.set_state(before);
  return done;
}

std::unique_ptr<SurfaceMotion> make_motion(const TimeParameters &time, const MotionSetting &setting, Archive *earlier)
{
  SurfaceProblem &problem = setting.problem;
  problem.use_chart(problem.needs_material_chart() ? PositionChart::material : PositionChart::graph,
                    problem.state().fields[0]);
  check_that_motion_is_defined(problem);
  if (time.integrator == "ida")
    return std::make_unique<IntegratedMotion>(setting, time, earlier);
  return std::make_unique<MinimisingMotion>(setting, time.interval(), earlier);
}
} // namespace pellicle
