// SPDX-License-Identifier: LGPL-2.1-or-later
// Directors that relax on a surface that is held: rates in closed form, the energy law, what is refused.
#include "../expect_user_error.h"
#include "../mpi_environment.h"
#include "shapes.h"

#include <pellicle/base/constants.h>
#include <pellicle/models/relaxation_system.h>
#include <pellicle/models/surface_motion.h>
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/director_gradient.h>
#include <pellicle/potentials/director/tilt_energy.h>
#include <pellicle/potentials/dissipations/director_friction.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace
{
using namespace pellicle;
using Vector = Vector3<double>;
using Field  = std::function<Vector(const Vector &x)>;

const double K = 0.8, eta = 1.6, infinite = std::numeric_limits<double>::infinity();

/** Held directors at the rim, or nowhere. */
enum class Rim
{
  none,
  held
};

/** Directors on a surface that is held. */
class Relaxation
{
public:
  Relaxation(SurfaceDiscretization surface, const double tilt_modulus, const Field &directors,
             const Rim rim = Rim::none, const bool mixed = true)
      : mesh(std::move(surface))
  {
    mesh.rigid_motions.clear();
    NodalVectors &start = mesh.start_values[std::string(director)];
    for (std::size_t I = 0; I < mesh.n_nodes; ++I)
    {
      const Vector O = directors(test_shapes::node(mesh.positions, I));
      for (unsigned int c = 0; c < 3; ++c)
        start.push_back(O[c] / norm(O));
    }
    if (mixed)
    {
      const double direct = std::min(10. * K, 0.5 * tilt_modulus);
      set.energies.push_back(std::make_shared<DensityPotential<MixedTiltEnergy>>(
          "tilt energy", MixedTiltEnergy{tilt_modulus, std::make_shared<const std::vector<double>>(
                                                           mesh.n_cells * mesh.tables.n_points, direct)}));
    }
    else
      set.energies.push_back(std::make_shared<DensityPotential<TiltEnergy>>("tilt energy", TiltEnergy{tilt_modulus}));
    set.energies.push_back(std::make_shared<DensityPotential<DirectorGradientEnergy>>("director gradient energy",
                                                                                      DirectorGradientEnergy{K}));
    set.dissipations.push_back(make_dissipation("director friction", DirectorFrictionInLab{eta}));
    conditions["position"].only.assign(mesh.n_nodes, held());
    if (rim == Rim::held)
    {
      conditions[std::string(director)].only.resize(mesh.n_nodes);
      for (const EdgeLoop &loop : mesh.edges)
        for (const std::size_t node : loop.cell_nodes)
          conditions[std::string(director)].only[node] = held();
    }
  }

  SurfaceMotion &start(const TimeParameters &time)
  {
    problem = std::make_unique<SurfaceProblem>(mesh, set, conditions, communicator, "mumps", timing);
    solver  = make_linear_solver("mumps");
    motion  = make_motion(time, {newton, *problem, *solver, communicator, timing});
    return *motion;
  }

  /** Goes on to the end; returns the state's share of `mode` relative to that at the start. */
  double decay(const TimeParameters &time, const Field &mode)
  {
    start(time);
    const double before = share(mode);
    for (int i = 1; i <= time.n_intervals(); ++i)
    {
      const StepResult result = motion->advance(time.time_after(i), i, nobody);
      EXPECT_TRUE(result.converged) << result.failure;
    }
    return share(mode) / before;
  }

  const NodalVectors &directors() const { return problem->state().fields[problem->layout().index(director)]; }

  double share(const Field &mode) const
  {
    double sum = 0., all = 0.;
    for (std::size_t I = 0; I < mesh.n_nodes; ++I)
    {
      const Vector m = mode(test_shapes::node(mesh.positions, I));
      sum += dot(m, test_shapes::node(directors(), I));
      all += dot(m, m);
    }
    return sum / all;
  }

  SurfaceDiscretization mesh;
  PotentialSet set;
  NodalConditions conditions;
  NewtonParameters newton;
  Communicator communicator;
  Timing timing;
  Observer nobody;
  std::unique_ptr<SurfaceProblem> problem;
  std::unique_ptr<LinearSolver> solver;
  std::unique_ptr<SurfaceMotion> motion;
};

SurfaceDiscretization sphere(const bool in_space, const unsigned int refinements, const double R)
{
  const SmoothShape shape = ellipsoid({{R, R, R}});
  return in_space ? on_cube_sphere(shape, 3, refinements) : on_meridian(shape, 3, refinements, false);
}

Vector outward(const Vector &x)
{
  return (1. / norm(x)) * x;
}
/** grad Y of Y = 3 z^2 - 1 on the unit sphere, up to a factor. */
Vector gradient_mode(const Vector &x)
{
  const Vector n = outward(x);
  return n[2] * (Vector(0., 0., 1.) - n[2] * n);
}
/** n x grad Y of Y = x y + 2 y z. */
Vector curl_mode(const Vector &x)
{
  const Vector n = outward(x);
  return cross(n, Vector(n[1], n[0] + 2. * n[2], 2. * n[1]));
}
Field perturbed(const Field &base, const Field &mode, const double amplitude)
{
  return [=](const Vector &x) { return base(x) + amplitude * mode(x); };
}

TimeParameters until(const double end, const int n_steps, const std::string &integrator = "minimising")
{
  TimeParameters time;
  time.end_time   = end;
  time.step       = end / n_steps;
  time.integrator = integrator;
  return time;
}

constexpr double small = 1e-4; // amplitude of modes; what is of second order in it does not show

// Rate [k_t + K (l (l + 1) - 2)/R^2]/eta, l = 2; a minimising step divides by 1 + rate dt.
TEST(DirectorRelaxation, RatesOnASphere)
{
  const double R = 1.4;
  for (const double k_t : {0.9, 40.})
    for (const bool in_space : {false, true})
    {
      const double rate = (k_t + 4. * K / (R * R)) / eta, dt = 0.1 / rate;
      const Field mode = in_space ? curl_mode : gradient_mode;
      // The normals are not quite an equilibrium of the discrete sphere: what counts is the difference of two motions.
      double before = 0., after = 0.;
      for (const double sign : {1., -1.})
      {
        Relaxation relaxation(sphere(in_space, in_space ? 1 : 3, R), k_t, perturbed(outward, mode, sign * small));
        const double ratio = relaxation.decay(until(2. * dt, 2), mode), end = relaxation.share(mode);
        before += sign * end / ratio;
        after += sign * end;
      }
      EXPECT_NEAR((std::pow(after / before, -0.5) - 1.) / dt / rate, 1., in_space ? 1.5e-4 * (1. + k_t) : 1e-5) << k_t;
    }
}

// Flat disc of radius b, held at the rim: J_1(q r) e_r and, in space, J_1(q r) e_phi, rate (k_t + K q^2)/eta.
TEST(DirectorRelaxation, RatesOnADisc)
{
  const double b = 2., q = 3.8317059702075125 / b, k_t = 1.2, rate = (k_t + K * q * q) / eta, dt = 0.2 / rate;
  for (const bool in_space : {false, true})
  {
    const Field mode = [=](const Vector &x)
    {
      const double r = std::hypot(x[0], x[1]), J = r > 0. ? std::cyl_bessel_j(1., q * r) / r : 0.;
      return in_space ? Vector(-J * x[1], J * x[0], 0.) : Vector(J * x[0], J * x[1], 0.);
    };
    const Field up = [](const Vector &) { return Vector(0., 0., 1.); };
    Relaxation relaxation(disc(pi * b * b, 3, in_space ? 1 : 3, !in_space), k_t, perturbed(up, mode, small), Rim::held);
    const double ratio = relaxation.decay(until(3. * dt, 3), mode);
    EXPECT_NEAR((std::pow(ratio, -1. / 3.) - 1.) / dt / rate, 1., in_space ? 1e-3 : 1e-5) << in_space;
  }
}

TEST(DirectorRelaxation, MinimisingStepsAreOfFirstOrderAndIdaIsAccurate)
{
  const double R = 1., k_t = 2., rate = (k_t + 4. * K) / eta, end = 1. / rate, exact = std::exp(-1.);
  const auto decay = [&](const TimeParameters &time)
  {
    Relaxation relaxation(sphere(false, 3, R), k_t, perturbed(outward, gradient_mode, small));
    return relaxation.decay(time, gradient_mode);
  };
  const double coarse = decay(until(end, 10)) - exact, fine = decay(until(end, 20)) - exact;
  EXPECT_NEAR(coarse / fine, 2., 0.1);
  EXPECT_GT(fine, 1e-3);

  TimeParameters time     = until(end, 2, "ida");
  time.relative_tolerance = 1e-8;
  time.absolute_tolerance = 1e-11;
  EXPECT_NEAR(decay(time), exact, 2e-6);
}

// dF/dy + alpha dF/dy' along a random direction, at vectors that are not of unit length.
TEST(DirectorRelaxation, TangentIsConsistent)
{
  for (const bool in_space : {false, true})
  {
    Relaxation relaxation(sphere(in_space, 0, 1.), 7., perturbed(outward, gradient_mode, 0.4));
    relaxation.start(until(1., 1));
    relaxation.problem->use_chart(PositionChart::material, relaxation.mesh.positions);
    RelaxationSystem system(*relaxation.problem, 1.7, relaxation.communicator, relaxation.timing);
    const std::size_t n = system.size();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-0.3, 0.3);
    std::vector<double> y = system.start(), v(n), d(n), ahead, behind;
    for (std::size_t i = 0; i < n; ++i)
    {
      y[i] += any(random);
      v[i] = any(random);
      d[i] = any(random);
    }
    const double alpha = 3.1, step = 1e-5;
    const auto F = [&](const double s, std::vector<double> &result)
    {
      std::vector<double> y_there = y, v_there = v;
      for (std::size_t i = 0; i < n; ++i)
      {
        y_there[i] += s * d[i];
        v_there[i] += s * alpha * d[i];
      }
      system.residual(0., y_there, v_there, result);
    };
    F(step, ahead);
    F(-step, behind);
    const SparseMatrix &A = system.tangent(0., y, v, alpha);
    double largest = 0., error = 0.;
    for (std::size_t i = 0; i < n; ++i)
    {
      double product = 0.;
      for (int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
        product += A.values[k] * d[A.columns[k]];
      largest = std::max(largest, std::abs(product));
      error   = std::max(error, std::abs(product - (ahead[i] - behind[i]) / (2. * step)));
    }
    EXPECT_LT(error, 1e-8 * largest);
  }
}

/** Directors far from equilibrium: turned by up to 2.5, and some at random. */
Field wild(const double noise)
{
  auto random = std::make_shared<std::mt19937>(5);
  return [=](const Vector &x)
  {
    const Vector n = outward(x);
    std::uniform_real_distribution<double> any(-noise, noise);
    const double angle = 2.5 * std::sin(3. * n[2]) * (1. - n[2] * n[2]);
    const Vector e     = cross(Vector(n[1], -n[0], 0.), n); // along the meridian
    return std::cos(angle) * n + std::sin(angle) / (norm(e) + 1e-300) * e +
           Vector(any(*random), noise > 0. ? any(*random) : 0., any(*random));
  };
}

// The law E' + dt D <= E is checked within advance(); here it is checked from outside, step by step.
TEST(DirectorRelaxation, EnergyLawFarFromEquilibrium)
{
  for (const double k_t : {5., infinite})
  {
    const bool finite = std::isfinite(k_t);
    Relaxation relaxation(sphere(true, 0, 1.), k_t, finite ? wild(0.3) : Field(outward));
    SurfaceMotion &motion = relaxation.start(until(2., 20));
    const double at_start = motion.balance().energy();
    double energy = at_start, lowest = 0.;
    for (int i = 1; i <= 20; ++i)
    {
      const StepResult result = motion.advance(0.1 * i, i, relaxation.nobody);
      ASSERT_TRUE(result.converged) << result.failure;
      EXPECT_LE(motion.balance().energy(), energy * (1. + 1e-12)) << i;
      EXPECT_NEAR(motion.balance().energy(), relaxation.problem->energy(), 1e-12);
      EXPECT_GE(motion.dissipation(), 0.);
      energy = motion.balance().energy();
      lowest = std::min(lowest, motion.balance().relative_error());
    }
    if (finite)
    {
      EXPECT_LT(energy, 0.6 * at_start); // it has moved far
      EXPECT_GT(lowest, -1.);
      EXPECT_LT(motion.balance().relative_error(), 0.) << "steps lose more than they dissipate";
    }
  }
}

// The same motion with IDA ends where short minimising steps do, and energy and dissipation balance within tolerances.
TEST(DirectorRelaxation, IdaBalancesEnergyFarFromEquilibrium)
{
  const double end = 0.5;
  double energies[2], last_error = 1.;
  for (const bool mixed : {true, false})
  {
    for (const double tolerance : {1e-4, 1e-6})
    {
      Relaxation relaxation(sphere(false, 2, 1.), 5., wild(0.), Rim::none, mixed);
      TimeParameters time     = until(end, 5, "ida");
      time.relative_tolerance = tolerance;
      time.absolute_tolerance = 0.1 * tolerance;
      SurfaceMotion &motion   = relaxation.start(time);
      const double at_start   = motion.balance().energy();
      for (int i = 1; i <= 5; ++i)
      {
        const StepResult result = motion.advance(time.time_after(i), i, relaxation.nobody);
        ASSERT_TRUE(result.converged) << result.failure;
        EXPECT_TRUE(result.warnings.empty());
        EXPECT_LT(std::abs(motion.balance().relative_error()), 30. * tolerance);
      }
      for (std::size_t I = 0; I < relaxation.mesh.n_nodes; ++I)
        ASSERT_NEAR(norm(test_shapes::node(relaxation.directors(), I)), 1., 30. * tolerance);
      EXPECT_LT(motion.balance().energy(), 0.7 * at_start);
      energies[mixed] = motion.balance().energy();
      last_error      = std::abs(motion.balance().relative_error());
    }
    EXPECT_LT(last_error, 3e-5);
  }
  EXPECT_NEAR(energies[0] / energies[1], 1., 1e-3); // two discretisations of one motion

  Relaxation steps(sphere(false, 2, 1.), 5., wild(0.));
  SurfaceMotion &motion = steps.start(until(end, 100));
  for (int i = 1; i <= 100; ++i)
    ASSERT_TRUE(motion.advance(i * end / 100, i, steps.nobody).converged);
  EXPECT_NEAR(motion.balance().energy() / energies[1], 1., 2e-2);
}

TEST(DirectorRelaxation, RefusesWhatIsNotDefined)
{
  const auto start = [](Relaxation &relaxation, const TimeParameters &time) { relaxation.start(time); };
  Relaxation index_2(sphere(false, 1, 1.), infinite, outward);
  EXPECT_USER_ERROR(start(index_2, until(1., 1, "ida")), "Director/Tilt modulus = inf", "index 2",
                    "Time/Integrator = minimising");

  Relaxation at_once(sphere(false, 1, 1.), 1., outward);
  at_once.set.dissipations.clear();
  EXPECT_USER_ERROR(start(at_once, until(1., 1)), "no listed effect dissipates", "director friction");

  Relaxation fluid(sphere(false, 1, 1.), 1., outward);
  fluid.conditions.clear();
  EXPECT_USER_ERROR(start(fluid, until(1., 1)), "material points", "Hold the surface");
}
} // namespace
