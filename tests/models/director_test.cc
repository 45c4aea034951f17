// SPDX-License-Identifier: LGPL-2.1-or-later
// Directors on surfaces that are held, against closed forms and independent spectral solutions (to 1e-12).
#include "director_runs.h"

#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/refined_quads.h>
#include <pellicle/potentials/director/director_fields.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

void expect_few_quadratic_steps(const Solved &solved, const std::string &what)
{
  ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
  EXPECT_LE(solved.record.iterations.size(), 8u) << what;
  expect_quadratic_tail(solved.record.iterations, 1e-2, 100., 1e-12);
}

// O = n: (K/2) |grad n|^2 is K (H-trace)^2/2 - K kappa_G, that is K/R^2 on a sphere. Energies are of order 2k.
TEST(Directors, OnSphere)
{
  for (const bool axial : {false, true})
    for (const int degree : {2, 3})
    {
      const std::string what = (axial ? "axial, degree " : "degree ") + std::to_string(degree);
      std::vector<double> energy, null;
      for (const int r : {1, 2})
      {
        DirectorScene scene = director_scene("ellipsoid", {axial ? "axial" : "none", degree, r}, 1.);
        effect<DirectorEffect>(scene).parameters.gaussian_modulus = -0.4;
        const Solved solved(scene);
        ASSERT_TRUE(solved.result.converged) << what;
        energy.push_back(relative_error(solved.quantity("total_energy"), 4. * pi));
        null.push_back(relative_error(solved.quantity("null_lagrangian_energy"), 4. * pi * 0.6));
      }
      EXPECT_GT(std::log2(energy[0] / energy[1]), 2. * degree - 0.4) << what;
      EXPECT_GT(std::log2(null[0] / null[1]), 2. * degree - 0.4) << what;
      EXPECT_LT(energy[1], degree == 3 ? 1e-6 : 1e-4) << what;
      EXPECT_LT(null[1], degree == 3 ? 1e-7 : 1e-5) << what;
    }
}

// O = Q n with Q the rotation by alpha: with c = cos alpha the tilt energy is 2 pi R^2 k_t (1 - c^2 - 2 c (1 - c)/3 -
// (1 - c)^2/5), that of the gradient and the null term are as for O = n.
TEST(Directors, TurnedOnSphere)
{
  for (const double alpha : {0.5, 2.})
  {
    const double c = std::cos(alpha), d = 1. - c;
    const double exact = 2. * pi * 9. * 3. * (1. - c * c - 2. * c * d / 3. - d * d / 5.);
    std::vector<double> error;
    for (const int r : {1, 2})
    {
      DirectorScene scene                            = director_scene("ellipsoid", {"none", 3, r}, 3.);
      scene.vesicle.area                             = 36. * pi;
      scene.field.start                              = "turned";
      scene.field.angle                              = alpha;
      effect<DirectorEffect>(scene).parameters.shear = "direct";
      const Unsolved turned(scene);
      error.push_back(relative_error(turned.quantity("tilt_energy"), exact));
      EXPECT_LT(relative_error(turned.quantity("director_gradient_energy"), 4. * pi), r == 2 ? 1e-5 : 2e-4);
      EXPECT_LT(relative_error(turned.quantity("null_lagrangian_energy"), 4. * pi), r == 2 ? 1e-7 : 1e-5);
    }
    EXPECT_LT(error[1], 1e-6);
    EXPECT_GT(std::log2(error[0] / error[1]), 5.6);
  }
}

// However the directors start, they end as normals.
TEST(Directors, ComeBackToNormals)
{
  DirectorScene scene     = director_scene("ellipsoid", {"none", 3, 1}, 1.);
  const double of_normals = Solved(scene).quantity("total_energy");
  scene.field.noise       = 0.05;
  for (const char *start : {"normal", "turned", "towards z"})
  {
    scene.field.start = start;
    scene.field.angle = 0.5;
    const Solved solved(scene);
    expect_few_quadratic_steps(solved, start);
    EXPECT_LT(relative_error(solved.quantity("total_energy"), of_normals), 1e-12) << start;
  }
}

struct TorusEnergy
{
  double k_t, energy;
};
/** Clifford's torus of r = 1, the least energy over directors. */
const std::vector<TorusEnergy> torus_energies{
    {10., 37.846363804208},       {50., 39.100251528461},
    {100., 39.285313836854},      {400., 39.429344635444},
    {1600., 39.466097907625},     {1e4, 39.476444127444},
    {1e6, 39.478397865193},       {1.6e7, 39.47841760435743 - 2. * pi *pi / 1.6e7},
    {infinite, 39.47841760435743}};

// k_t h^2/K = .65 ... 1e6 and infinite, h^2 = .065: the mixed form's error is uniform, the direct one's grows with k_t.
TEST(Directors, TorusWithoutLocking)
{
  double plain_at_one = 0., plain_at_stiff = 0.;
  for (const double k_t : {10., 1e4})
  {
    const double energy = k_t == 10. ? torus_energies[0].energy : torus_energies[5].energy;
    const Solved solved(on_torus(1, k_t, "direct"));
    (k_t == 10. ? plain_at_one : plain_at_stiff) = relative_error(solved.quantity("total_energy"), energy);
  }
  EXPECT_LT(plain_at_one, 1e-4);
  EXPECT_GT(plain_at_stiff, 100. * plain_at_one);
  for (const TorusEnergy &of : torus_energies)
  {
    const Solved solved(on_torus(1, of.k_t));
    const std::string what = "k_t = " + std::to_string(of.k_t);
    expect_few_quadratic_steps(solved, what);
    EXPECT_LT(relative_error(solved.quantity("total_energy"), of.energy), 3. * plain_at_one) << what;
    EXPECT_LT(relative_error(solved.quantity("total_energy"), of.energy), 5e-5) << what;
  }
}

// E(k_t) = E(inf) - 2 pi^2 K^2/k_t (1 + O(1/k_t)), the second term by ratios of an independent solution.
TEST(Directors, TorusInTheLimit)
{
  const double limit = Solved(on_torus(2, infinite)).quantity("total_energy");
  EXPECT_LT(relative_error(limit, 4. * pi * pi), 1e-6);
  for (const auto &[k_t, ratio] : {std::pair<double, double>{10., 0.82680811}, {1600., 0.99859700}})
  {
    const Solved solved(on_torus(2, k_t));
    const double energy = solved.quantity("total_energy");
    EXPECT_NEAR((limit - energy) * k_t / (2. * pi * pi), ratio, 1e-3 * ratio) << k_t;
    EXPECT_LT(std::abs(solved.quantity("null_lagrangian_energy")), 1e-5) << k_t;
  }
}

TEST(Directors, NoiseOnTorusAndAroundDisc)
{
  for (const auto &make : std::vector<std::function<DirectorScene()>>{[] { return on_torus(1, 100.); },
                                                                      [] {
                                                                        return around_disc({"none", 3, 0}, 0.5);
                                                                      }})
  {
    DirectorScene scene = make();
    const double energy = Solved(scene).quantity("total_energy");
    scene.field.noise   = 0.05;
    for (const int seed : {1, 2})
    {
      scene.field.random_seed = seed;
      const Solved solved(scene);
      expect_few_quadratic_steps(solved, scene.carrier.shape);
      EXPECT_LT(relative_error(solved.quantity("total_energy"), energy), 1e-12);
    }
  }
}

/** A sheet z = h cos(q x) from a crest to the next trough, where directors are normal by symmetry; width `width`. */
class WavySheet : public DirectorScene
{
public:
  double amplitude = 1e-3, wave_number = 1., width = 0.5;

  SurfaceDiscretization start_mesh() const override
  {
    SurfaceDiscretization sheet               = flat();
    sheet.mesh_reference                      = sheet.positions;
    sheet.start_values[std::string(director)] = nodal_normals(sheet, sheet.positions);
    for (const std::size_t I : crest_and_trough(sheet))
    {
      NodalVectors &O = sheet.start_values[std::string(director)];
      O[3 * I] = O[3 * I + 1] = 0.;
      O[3 * I + 2]            = 1.;
    }
    return sheet;
  }
  bool has_origin() const override { return true; }
  std::vector<SceneEdge> edges() const override { return {{"rim", EdgeSupport::hinged}}; }
  NodalConditions conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const override
  {
    NodalConditions list    = DirectorScene::conditions(surface, targets);
    FieldConditions &fields = list[std::string(director)];
    fields.only.resize(surface.n_nodes);
    for (const std::size_t I : crest_and_trough(flat()))
      fields.only[I] = held();
    return list;
  }

private:
  SurfaceDiscretization flat() const
  {
    constexpr unsigned int n = 6;
    std::vector<QuadVertices> quads;
    for (unsigned int i = 0; i < n; ++i)
      quads.push_back({{i, i + 1, n + 1 + i, n + 2 + i}});
    const auto point = [&](const unsigned int patch, const double u, const double v)
    {
      const double x = (patch + u) / n * pi / wave_number;
      return Vector3<double>(x, width * v, amplitude * std::cos(wave_number * x));
    };
    SurfaceDiscretization sheet =
        place_nodes(refine_quads(corner_points(quads, 2 * (n + 1), point), quads, mesh.refinements, mesh.degree), quads,
                    mesh.degree, point);
    sheet.edges = find_rims(sheet, [](const Vector3<double> &) { return "rim"; });
    return sheet;
  }
  std::vector<std::size_t> crest_and_trough(const SurfaceDiscretization &sheet) const
  {
    std::vector<std::size_t> nodes;
    for (std::size_t I = 0; I < sheet.n_nodes; ++I)
      if (const double x = sheet.positions[3 * I]; x < 1e-9 || x > pi / wave_number - 1e-9)
        nodes.push_back(I);
    return nodes;
  }
};

// A wave of wave number q costs (h^2/4) K q^4/(1 + K q^2/k_t) per area; the tilt energy is the share K q^2/(k_t + K
// q^2). Energies of the nonlinear model per period and width.
TEST(Directors, WavesInASheet)
{
  struct Case
  {
    double k_t, q, h, energy;
  };
  for (const Case &c : {Case{10., 1., 1e-3, 1.427995832866e-06}, Case{10., 2., 0.1, 8.804678892812e-02},
                        Case{100., 1., 0.1, 1.545681824088e-02}, Case{1., 2., 1e-3, 2.513270574137e-06},
                        Case{infinite, 1., 1e-3, 1.570795345048e-06}, Case{infinite, 2., 0.1, 1.226280986839e-01}})
  {
    auto scene        = director_scene<WavySheet>("ellipsoid", {"none", 3, 1}, c.k_t);
    scene.amplitude   = c.h;
    scene.wave_number = c.q;
    const Solved solved(scene);
    const std::string what = "k_t = " + std::to_string(c.k_t) + ", q = " + std::to_string(c.q);
    ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
    const double energy = 2. * solved.quantity("total_energy") / scene.width;
    EXPECT_LT(relative_error(energy, c.energy), 1e-6) << what;
    if (c.h == 1e-3)
    {
      const double q4 = std::pow(c.q, 4), softer = 1. + c.q * c.q / c.k_t;
      EXPECT_LT(relative_error(energy, 0.25 * c.h * c.h * q4 / softer * 2. * pi / c.q), 1e-5) << what;
    }
  }
}

/** Angles of directors on a meridian of a flat ring, by radius. */
std::map<double, double> tilt_by_radius(const SurfaceModel &model)
{
  std::map<double, double> angles;
  const NodalVectors &x = model.equilibrium().state().fields[0], O = directors_of(model);
  for (std::size_t I = 0; I < model.mesh().n_nodes; ++I)
    angles[x[3 * I] * model.scales().length] = std::atan2(O[3 * I], O[3 * I + 2]);
  return angles;
}

// Small tilt decays as K_1(r/l), l = sqrt(K/k_t): e^(-r/l) sqrt(l/r) far out.
TEST(Directors, DecayLengthOfTilt)
{
  for (const double l : {0.5, 1., 2.})
  {
    const Solved solved(around_disc({"axial", 4, 3}, 0.01, 1. / (l * l)));
    ASSERT_TRUE(solved.result.converged);
    const double first = std::cyl_bessel_k(1., 1. / l);
    for (const auto &[r, angle] : tilt_by_radius(solved.model))
    {
      if (r > 1. + 6. * l)
        break;
      EXPECT_NEAR(angle / (0.01 * std::cyl_bessel_k(1., r / l) / first), 1., 2e-3) << "l = " << l << ", r = " << r;
    }
  }
}

TEST(Directors, AroundDisc)
{
  const Solved axial(around_disc({"axial", 3, 2}, 0.5));
  expect_few_quadratic_steps(axial, "axial");
  EXPECT_LT(relative_error(axial.quantity("total_energy"), 1.3141297247384), 1e-9);
  EXPECT_LT(relative_error(axial.quantity("tilt_energy"), 0.343405091394), 1e-7);
  // The null term is the area on the sphere of directors: 2 pi (cos(tilt) - 1).
  EXPECT_LT(relative_error(axial.quantity("null_lagrangian_energy"), 2. * pi * (std::cos(0.5) - 1.)), 1e-7);
  const Solved space(around_disc({"none", 3, 1}, 0.5));
  expect_few_quadratic_steps(space, "space");
  EXPECT_LT(relative_error(space.quantity("total_energy"), 1.3141297247384), 1e-7);
  const Solved steep(around_disc({"axial", 3, 2}, 1.2, 100.));
  expect_few_quadratic_steps(steep, "steep");
  EXPECT_LT(relative_error(steep.quantity("total_energy"), 42.5896426854383), 1e-9);
}
} // namespace
