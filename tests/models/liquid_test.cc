// SPDX-License-Identifier: LGPL-2.1-or-later
#include "liquid_runs.h"

#include "../mpi_environment.h"

#include <gtest/gtest.h>
#include <cstdio>

namespace
{
using namespace pellicle;
using namespace pellicle::test;
const double V0 = 2. * pi / 3.;

struct Print : Observer
{
  void on_iteration(const IterationReport &r) override
  { std::printf("   it %d res %.2e E %.12f step %.2e rej %d drag?\n", r.iteration, r.relative_residual, r.energy, r.step_length, r.rejected); }
};

void run(bool axial, double theta, unsigned k, unsigned r, double g, int kind, double mu, double compliance)
{
  const double th = theta*pi/180.;
  SurfaceDiscretization drop = filled_cap(th, cap_area(th, V0), k, r, axial);
  drop.tables = axial ? make_meridian_tables(k, 2*k, false) : make_surface_tables(k, 2*k);
  const auto reference = std::make_shared<const std::vector<ReferenceBasis>>(reference_bases(drop.bulks[0], drop.positions));
  double vol = 0, mn=1e9; for (std::size_t i=0;i<reference->size();++i){ vol += drop.bulks[0].tables.weights[i % drop.bulks[0].tables.n_points]*(*reference)[i].volume; mn=std::min(mn,(*reference)[i].volume);}
  std::printf("axial %d theta %g k %u r %u g %g kind %d mu %g c %g: cells %zu nodes %zu V %.12f minJ %g\n", axial, theta, k, r, g, kind, mu, compliance, drop.bulks[0].n_cells, drop.n_nodes, vol-V0, mn);
  PotentialSet set = surfaces_of_drop(th);
  const Vector3<double> f(0.,0.,-g);
  if (kind == 0)
  {
    set.energies.push_back(std::make_shared<DensityPotential<Gravity>>("gravity", Gravity{f}));
    Constraint c; c.measure = std::make_shared<DensityPotential<EnclosedVolume>>("volume", EnclosedVolume{}); c.target = vol; 
    if (compliance > 0) c.stiffness = 1./compliance/vol;
    set.constraints.push_back(c);
    drop.n_nodes = drop.bulks[0].faces["cap"].size(); drop.positions.resize(3*drop.n_nodes); drop.mesh_reference.resize(3*drop.n_nodes); drop.admissible.resize(drop.n_nodes);
    drop.bulks.clear();
  }
  else
  {
    if (kind < 4) add_pressure_nodes(drop, 0);
    if (kind == 1) set.energies.push_back(std::make_shared<DensityPotential<BodyForce>>("weight", BodyForce{f}, in_liquid));
    else set.energies.push_back(std::make_shared<DensityPotential<BodyForce>>("weight", BodyForce{f}, in_liquid));
    if (kind < 4) set.energies.push_back(std::make_shared<DensityPotential<IncompressibleLiquid>>("liquid", IncompressibleLiquid{reference, compliance}, in_liquid));
    else set.energies.push_back(std::make_shared<DensityPotential<ElasticBody<CompressibleLiquid>>>("liquid", ElasticBody<CompressibleLiquid>{{1./compliance}, reference}, in_liquid));
    set.energies.push_back(std::make_shared<DensityPotential<ShearDrag>>("drag", ShearDrag{mu}, in_liquid));
  }
  BodyRun run(drop, set, graph_of_cap(drop, drop.positions));
  run.problem.set_conditions(graph_of_cap(drop, drop.positions));
  run.problem.use_chart(PositionChart::material, {});
  run.parameters.tolerance = 1e-12;
  run.parameters.max_iterations = 25;
  Print p;
  const double t0 = run.timing.total();
  const NewtonResult result = Newton(run.parameters, *run.solver, run.timing).solve(run.problem, 0, p);
  const NodalVectors &x = run.positions();
  double a = 0; for (auto I : drop.edges[0].cell_nodes) a = std::max(a, std::hypot(x[3*I],x[3*I+1]));
  double h=0; for (std::size_t I=0;I<drop.n_nodes;++I) h = std::max(h, x[3*I+2]);
  double E = run.problem.values().energies[0]+run.problem.values().energies[1]+run.problem.values().energies[2];
  double plo=1e9, phi=-1e9;
  if (kind==0) plo=phi= -run.problem.state().multipliers[0];
  else if (kind < 4) {
    const auto &pf = run.problem.state().fields[1];
    const auto &t = drop.bulks[0].tables;
    for (std::size_t c = 0; c < drop.bulks[0].n_cells; ++c) for (unsigned q=0;q<t.n_points;++q) { double v=0,z=0; for (unsigned i=0;i<t.n_nodes;++i) { auto I = drop.bulks[0].cell_nodes[c*t.n_nodes+i]; double N=t.tables[0][q*t.n_nodes+i]; v+=N*pf[3*I]; z+=N*x[3*I+2]; } if (kind!=1) v += g*z; plo=std::min(plo,v); phi=std::max(phi,v);} }
  std::printf("  conv %d it %d rej %d res %.1e n %zu a %.12f h %.12f E %.12f p_v %.12f..%.12f  sec %.3f asm %.3f %s\n", result.converged, result.iterations, result.rejected, result.relative_residual, run.problem.residual().size(), a, h, E, plo, phi, run.timing.total()-t0, 0., result.failure.c_str());
}

TEST(Explore, A)
{
  const char *s = std::getenv("CASES");
  int axial, kind; double theta, g, mu, c; unsigned k, r; int n;
  while (s && std::sscanf(s, "%d %lf %u %u %lf %d %lf %lf;%n", &axial, &theta, &k, &r, &g, &kind, &mu, &c, &n) == 8) { run(axial, theta, k, r, g, kind, mu, c); s += n; }
}
}
