// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the equations with respect to the scene's parameters, as continuation uses them, against central
// differences of the residual at states that are no equilibria.
#include "branch_runs.h"

#include <pellicle/models/edge_conditions.h>
#include <pellicle/models/rim_conormals.h>
#include <pellicle/models/surface_branch.h>
#include <pellicle/potentials/constraints/bilayer_curvature.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/tether.h>
#include <pellicle/potentials/edges/line_tension.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A scene's problem on its deformed start shape, in internal units that are not the user's. */
class Deformed
{
public:
  explicit Deformed(const VesicleScene &scene)
      : unit(scene.scales())
      , mesh(make_start_shape(scene.start_shape()))
  {
    for (double &x : mesh.positions)
      x /= unit.length;
    for (double &x : mesh.mesh_reference)
      x /= unit.length;
    for (const EdgeLoop &loop : mesh.edges)
      conormals[loop.name] =
          loop.is_rim
              ? std::make_shared<const std::vector<Vector3<double>>>(start_conormals(mesh, loop, scene.start_shape()))
              : nullptr;
    PotentialSet set                 = potentials_of(scene);
    const NodalConditions conditions = edge_conditions(mesh, targets);
    if (conditions.find("position") != conditions.end())
      mesh.rigid_motions.clear();
    problem = std::make_unique<SurfaceProblem>(mesh, std::move(set), conditions, communicator, "mumps", timing);

    SurfaceState state = problem->state();
    for (std::size_t I = 0; I < mesh.n_nodes; ++I)
    {
      double *x = &state.fields[0][3 * I];
      if (scene.has_effect("tether")) // its tip stays flat
        x[2] = 0.3 * (scene.find<TetherEffect>()->parameters.ring_radius / unit.length - std::hypot(x[0], x[1]));
      else
      {
        x[0] *= 1. + 0.1 * x[2];
        x[1] *= 1. + 0.1 * x[2];
        x[2] += 0.1 * x[2] * x[2];
      }
    }
    for (std::size_t k = 0; k < state.multipliers.size(); ++k)
      state.multipliers[k] = k % 2 == 0 ? 0.7 : -1.3;
    problem->set_state(state);
  }

  PotentialSet potentials_of(const VesicleScene &scene)
  {
    targets = scene.targets(unit);
    for (SceneEdge &edge : targets.edges)
      edge.conormals = conormals.at(edge.name);
    return scene.potentials(unit, targets);
  }

  Communicator communicator;
  Timing timing;
  Scales unit;
  SurfaceDiscretization mesh;
  std::map<std::string, std::shared_ptr<const std::vector<Vector3<double>>>> conormals;
  SceneTargets targets;
  std::unique_ptr<SurfaceProblem> problem;
};

double norm_of(const std::vector<double> &v)
{
  double sum = 0.;
  for (const double x : v)
    sum += x * x;
  return std::sqrt(sum);
}

/** K times a change of the internal fields, which follow the parameter by themselves. */
std::vector<double> response(const SurfaceProblem &problem, const FieldValues &change)
{
  const Numbering &numbering = problem.numbering();
  std::vector<double> direction(numbering.size(), 0.), result(direction);
  for (std::size_t f = 1; f < change.size(); ++f)
    for (std::size_t I = 0; I < numbering.charts[f].nodes.size(); ++I)
      for (unsigned int a = 0; a < numbering.count(f, I); ++a)
        for (unsigned int c = 0; c < 3; ++c)
          direction[numbering.first_of(f, I) + a] +=
              numbering.charts[f].nodes[I].columns[3 * a + c] * change[f][3 * I + c];
  const SparseMatrix &K = problem.matrix();
  for (int row = 0; row < K.size; ++row)
    for (int i = K.row_start[row]; i < K.row_start[row + 1]; ++i)
    {
      result[row] += K.values[i] * direction[K.columns[i]];
      if (K.symmetry == MatrixSymmetry::symmetric && K.columns[i] != row)
        result[K.columns[i]] += K.values[i] * direction[row];
    }
  return result;
}

/** Relative defect of dR/dp in a chart; all equations are linear in their parameters, so the step may be large. */
double defect(const SceneAt &scene_at, const std::string &name, const double value, const PositionChart chart)
{
  Deformed deformed(scene_at(value));
  SurfaceProblem &problem = *deformed.problem;
  SceneParameter parameter;
  parameter.name        = name;
  parameter.value       = value;
  parameter.potentials  = [&](const double p) { return deformed.potentials_of(scene_at(p)); };
  parameter.derivatives = [&](const double p)
  {
    std::vector<ParameterDerivative> list;
    for (const ParameterDerivative &derivative : scene_at(p).derivatives(deformed.unit, deformed.targets))
      if (derivative.parameter == name)
        list.push_back(derivative);
    EXPECT_FALSE(list.empty()) << name;
    return list;
  };
  const NodalVectors reference = problem.state().fields[0];
  SurfaceBranch along(problem, parameter, chart, reference);
  const double step = 0.01 * std::abs(value);
  const auto at     = [&](const double p)
  {
    along.set_parameter(p);
    along.linearize();
    return problem.residual();
  };
  const std::vector<double> above = at(value + step);
  FieldValues change              = problem.state().fields;
  const std::vector<double> below = at(value - step);
  for (std::size_t f = 0; f < change.size(); ++f)
    for (std::size_t i = 0; i < change[f].size(); ++i)
      change[f][i] = (change[f][i] - problem.state().fields[f][i]) / (2. * step);
  at(value);
  const std::vector<double> exact = along.residual_derivative(), of_fields = response(problem, change);
  std::vector<double> difference(exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i)
    difference[i] = (above[i] - below[i]) / (2. * step) - of_fields[i] - exact[i];
  EXPECT_GT(norm_of(exact), 0.) << name;
  return norm_of(difference) / norm_of(exact);
}

struct Case
{
  std::vector<std::string> effects;
  std::string parameter;
  double value;
  std::function<void(VesicleScene &, double)> set;
};

VesicleScene scene_of(const Case &which, const double value)
{
  VesicleScene scene                                                    = scene_with(which.effects);
  scene.vesicle.area                                                    = 4. * pi * 1.7 * 1.7;
  scene.vesicle.start_shape                                             = "prolate";
  scene.vesicle.reduced_volume                                          = 0.8;
  scene.mesh.degree                                                     = 3;
  scene.mesh.refinements                                                = 1;
  scene.mesh.symmetry                                                   = "axial";
  effect<HelfrichBendingEffect>(scene).parameters.bending_rigidity      = 2.3;
  effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = 0.4;
  if (scene.has_effect("lipid domain"))
  {
    effect<LipidDomainEffect>(scene).parameters.bending_rigidity      = 3.1;
    effect<LipidDomainEffect>(scene).parameters.spontaneous_curvature = -0.6;
    effect<LipidDomainEffect>(scene).parameters.area_fraction         = 0.3;
  }
  else if (scene.has_effect("line tension"))
    scene.vesicle.start_shape = "cap";
  which.set(scene, value);
  return scene;
}

const std::string bending = "helfrich bending";

void set_curvature(VesicleScene &scene, const double value)
{
  effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = value;
}
void set_domain_curvature(VesicleScene &scene, const double value)
{
  effect<LipidDomainEffect>(scene).parameters.spontaneous_curvature = value;
}
void set_domain_fraction(VesicleScene &scene, const double value)
{
  effect<LipidDomainEffect>(scene).parameters.area_fraction = value;
}
void set_line_tension(VesicleScene &scene, const double value)
{
  effect<LineTensionEffect>(scene).parameters.line_tension = value;
}
void set_volume(VesicleScene &scene, const double value)
{
  scene.vesicle.reduced_volume = value;
}

std::vector<Case> all_cases()
{
  const std::string C0 = "Helfrich bending/Spontaneous curvature";
  return {
      {{bending}, C0, 0.4, set_curvature},
      {{bending, "bilayer coupling"}, C0, 0.4, set_curvature},
      {{bending, "area difference elasticity"}, C0, 0.4, set_curvature},
      {{bending, "lipid domain"}, C0, 0.4, set_curvature},
      {{bending, "lipid domain", "bilayer coupling"}, C0, 0.4, set_curvature},
      {{bending, "volume constraint"}, "Vesicle/Reduced volume", 0.8, set_volume},
      {{bending, "volume constraint"},
       "Vesicle/Reduced volume",
       0.8,
       [](VesicleScene &scene, const double value)
       {
         set_volume(scene, value);
         effect<VolumeConstraintEffect>(scene).parameters.stiffness = 50.;
       }},
      {{bending, "bilayer coupling"},
       "Bilayer coupling/Integrated mean curvature",
       20.,
       [](VesicleScene &scene, const double value)
       { effect<BilayerCouplingEffect>(scene).parameters.integrated_mean_curvature = value; }},
      {{bending, "area difference elasticity"},
       "Area difference elasticity/Integrated mean curvature",
       20.,
       [](VesicleScene &scene, const double value)
       { effect<AreaDifferenceElasticityEffect>(scene).parameters.integrated_mean_curvature = value; }},
      {{bending, "line tension"}, "Line tension/Line tension", 1.5, set_line_tension},
      {{bending, "line tension", "lipid domain"}, "Line tension/Line tension", 1.5, set_line_tension},
      {{bending, "lipid domain"}, "Lipid domain/Spontaneous curvature", -0.6, set_domain_curvature},
      {{bending, "lipid domain", "bilayer coupling"}, "Lipid domain/Spontaneous curvature", -0.6, set_domain_curvature},
      {{bending, "lipid domain"}, "Lipid domain/Area fraction", 0.3, set_domain_fraction},
      {{bending, "tether"},
       "Tether/Length",
       4.,
       [](VesicleScene &scene, const double value) { effect<TetherEffect>(scene).parameters.length = value; }},
      {{bending, "tether"},
       "Tether/Force",
       3.,
       [](VesicleScene &scene, const double value)
       {
         effect<TetherEffect>(scene).parameters.control = "force";
         effect<TetherEffect>(scene).parameters.force   = value;
       }},
      {{bending, "tether"},
       "Tether/Tension",
       0.5,
       [](VesicleScene &scene, const double value) { effect<TetherEffect>(scene).parameters.tension = value; }},
      {{bending, "surface tension"},
       "Surface tension/Surface tension",
       0.9,
       [](VesicleScene &scene, const double value) { effect<SurfaceTensionEffect>(scene).parameters.tension = value; }},
      {{bending, "pressure"},
       "Pressure/Pressure",
       1.1,
       [](VesicleScene &scene, const double value) { effect<PressureEffect>(scene).parameters.pressure = value; }},
  };
}

std::string title(const Case &which)
{
  std::string text = which.parameter + " with";
  for (const std::string &name : which.effects)
    text += " " + name + ",";
  return text;
}

TEST(ParameterDerivatives, AgreeWithDifferencesOfTheResidual)
{
  for (const Case &which : all_cases())
  {
    const SceneAt scene_at = [&](const double value) { return scene_of(which, value); };
    for (const PositionChart chart : {PositionChart::graph, PositionChart::ale})
      EXPECT_LT(defect(scene_at, which.parameter, which.value, chart), 1e-8)
          << title(which) << (chart == PositionChart::ale ? " ALE" : " graph");
  }
}

TEST(ParameterDerivatives, InSpace)
{
  for (const Case &which : all_cases())
    if (which.effects.back() != "tether" && which.effects.back() != "line tension")
    {
      const SceneAt scene_at = [&](const double value)
      {
        VesicleScene scene     = scene_of(which, value);
        scene.mesh.symmetry    = "none";
        scene.mesh.refinements = 0;
        return scene;
      };
      EXPECT_LT(defect(scene_at, which.parameter, which.value, PositionChart::graph), 1e-8) << title(which);
    }
}

// None that an effect of the library offers is missing above.
TEST(ParameterDerivatives, AllAreTested)
{
  std::set<std::string> tested, offered;
  for (const Case &which : all_cases())
  {
    tested.insert(which.parameter);
    const VesicleScene scene = scene_of(which, which.value);
    for (const ParameterDerivative &derivative : scene.derivatives(scene.scales(), scene.targets(scene.scales())))
      offered.insert(derivative.parameter);
  }
  const EffectLibrary library = standard_effects();
  for (const std::string &name : library.names())
    for (const ParameterDerivative &derivative : library.create(name)->derivatives(Scales{}, SceneTargets{}))
      offered.insert(derivative.parameter);
  EXPECT_EQ(tested, offered);
}
} // namespace
