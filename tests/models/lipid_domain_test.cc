// SPDX-License-Identifier: LGPL-2.1-or-later
#include "equilibrium_runs.h"

#include <pellicle/discretization/edge_loops.h>
#include <pellicle/potentials/constraints/lipid_domain.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;
struct Vesicle
{
  double C0;
  double energy, sd, so, pressure, rb, height;
};
constexpr Vesicle known[] = {
    {1, 1.000155778965, -2.523022956, -4.468020097, -9.643297849, 0.6015503824, 2.856132587},
    {3, 0.787266770438, -0.039217225, -2.702331897, -5.434166168, 0.5627070517, 2.794189109},
    {6, 0.926116196968, -2.728891579, 1.140696798, 3.138834624, 0.5420577828, 2.674154482},
};
SurfaceScene scene_of(const Vesicle &v, int degree, int refinements, const std::string &symmetry)
{
  SurfaceScene scene = scene_with({"helfrich bending", "lipid domain", "area constraint", "volume constraint"});
  scene.vesicle.reduced_volume                = .9;
  scene.mesh.degree                           = degree;
  scene.mesh.refinements                      = refinements;
  scene.mesh.symmetry                         = symmetry;
  effect<LipidDomainEffect>(scene).parameters = {.15, 1., v.C0};
  return scene;
}
void report(const Solved &s, const Vesicle &exact, int d, int r)
{
  const auto &m = s.model.mesh();
  printf("C0 %g d %d r %d (%zu cells): %s %d it %g s E %.2e dsigma %.2e sigma %.2e P %.2e area %.2e rb %.2e h %.2e neg "
         "%d\n",
         exact.C0, d, r, m.n_cells, s.result.failure.c_str(), s.result.iterations, s.seconds,
         s.energy() / exact.energy - 1, s.quantity("domain_tension") - exact.sd + exact.so,
         s.quantity("tension") - exact.so, s.quantity("pressure") - exact.pressure,
         s.quantity("domain_area") / (4 * pi * .15) - 1, loop_length(m.edges[0], s.positions()) / (2 * pi) - exact.rb,
         s.shape().height - exact.height, s.result.converged ? s.negative_eigenvalues() : -1);
}
TEST(LipidDomain, Axial)
{
  for (const auto &v : known)
    for (int d : {3, 4, 5})
      for (int r : {2, 3, 4})
      {
        Solved s(scene_of(v, d, r, "axial"));
        report(s, v, d, r);
      }
}
TEST(LipidDomain, Space)
{
  for (const auto &v : known)
    for (int r : {0, 1})
    {
      Solved s(scene_of(v, 3, r, "none"));
      report(s, v, 3, r);
    }
}
} // namespace
