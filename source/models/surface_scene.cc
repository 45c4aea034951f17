// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/models/edge_conditions.h>
#include <pellicle/models/surface_scene.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
void MeshParameters::bind(ParameterSection &section)
{
  section.integer("Degree", degree, 2, 5,
                  "Polynomial degree k of position and moment. Curvature converges at order k, energies at order 2k.");
  section.integer("Refinements", refinements, 0, 8,
                  "Refinements r of the coarsest mesh: a closed surface has 6 * 4^r cells, a meridian 4 * 2^r from "
                  "pole to pole, a cap 12 * 4^r and 2 * 2^r from pole to rim.");
  section.choice("Symmetry", symmetry, {"none", "half", "quarter", "octant", "axial", "axial mirror"},
                 "none: a surface in space. half, quarter, octant: the part y >= 0 of it, x, y >= 0, or x, y, z >= 0, "
                 "whose mirror images are the rest; the numbers are those of the whole, and only deformations with "
                 "these symmetries are possible. axial: a meridian, revolved about the z axis. axial mirror: its upper "
                 "half, mirrored at z = 0.");
  section.word("File", file,
               "Gmsh MSH 4.1 file with quadrilaterals or triangles, for Vesicle/Start shape = file. Relative to the "
               "scene file.");
}

MirrorPlanes MeshParameters::mirror_planes() const
{
  return {{symmetry == "quarter" || symmetry == "octant",
           symmetry == "half" || symmetry == "quarter" || symmetry == "octant", symmetry == "octant"}};
}

void BranchParameters::bind(ParameterSection &section)
{
  section.word(
      "Parameter", parameter,
      "Parameter of the scene, as Section/Name, along which the branch of equilibria is followed by arc length, "
      "through folds, after the first solve. Possible are Vesicle/Reduced volume, targets and coefficients of the "
      "listed effects: loads, tensions, spontaneous curvature. Empty: no continuation.");
  section.choice("Direction", direction, {"increasing", "decreasing"}, "Which way the parameter goes at first.");
  section.choice(
      "At bifurcation", at_bifurcation, {"report", "switch"},
      "Where the number of negative eigenvalues changes off a fold, another branch crosses. report: a message, "
      "and straight on. switch: onto the other branch, along the critical mode (once).");
  section.number("Amplitude", amplitude, Range::positive(), dimensions::none,
                 "Length of the first step along the critical mode, measured as First step.");
  section.number(
      "Scale", scale, Range::non_negative(), dimensions::none,
      "Change of the parameter that counts as much as displacements of the size of the surface, in the "
      "parameter's unit. 0: the distance of the bounds if both are finite, else the parameter's value (one unit "
      "if that is zero).");
  steps.bind(section);
}

void OutputParameters::bind(ParameterSection &section)
{
  section.flag("Solution", solution,
               "Write solution_NNNN.vtu (high-order cells with curvatures) after each step, and solution.pvd.");
  section.flag("Picture", picture,
               "Draw picture.png of the final surface, coloured by mean curvature, if the renderer is installed.");
}

void CheckpointParameters::bind(ParameterSection &section)
{
  section.integer("Every", every, 0, 1000000000,
                  "Write a checkpoint, from which --restart goes on, after each so many load steps, time steps or "
                  "points of a branch. 0: never.");
  section.integer("Keep", keep, 1, 1000, "Number of checkpoints that are kept, the last ones.");
}

std::vector<ParameterSection> SurfaceScene::sections()
{
  std::vector<ParameterSection> all;
  add_section(all, "Mesh", mesh);
  add_own_sections(all);
  for (const auto &effect : effects)
    add_section(all, section_name(effect->name()), *effect);
  add_section(all, "Load", load);
  add_section(all, "Newton", newton);
  add_section(all, "Continuation", branch);
  add_further_sections(all);
  add_section(all, "Stability", stability);
  add_section(all, "Accuracy", accuracy);
  add_section(all, "Output", output);
  add_section(all, "Checkpoint", checkpoint);
  return all;
}

bool SurfaceScene::has_effect(const std::string &name) const
{
  return std::any_of(effects.begin(), effects.end(), [&](const auto &effect) { return effect->name() == name; });
}

bool SurfaceScene::has_analysis(const std::string &name) const
{
  return std::find(analyses.begin(), analyses.end(), name) != analyses.end();
}

void SurfaceScene::check() const
{
  for (const auto &effect : effects)
    effect->check();
  if (stability.follow_unstable_mode && !has_analysis("stability"))
    throw UserError("Stability/Follow unstable mode needs the stability of each equilibrium: list it, 'set Analyses = "
                    "stability'.");
  if (load.parameter.empty() && !(load.from.empty() && load.to.empty()))
    throw UserError("Section Load: 'From' or 'To' is set, but 'Parameter' names no parameter.");
  if (!load.parameter.empty() && load.to.empty() && load.from.empty())
    throw UserError("Section Load: 'Parameter' is '" + load.parameter +
                    "', but neither 'From' nor 'To' gives a value to come from or to go to.");
  if (is_fixed(load.parameter))
    throw UserError("Load/Parameter = " + load.parameter +
                    " cannot change during a run: it shapes the mesh, the scale or the run itself.");
  if (accuracy.is_wanted())
    check_accuracy();
  const PotentialSet set = potentials(Scales{}, targets(Scales{}));
  for (const NamedQuantity &prescribed : set.prescribed)
    for (const Constraint &constraint : set.constraints)
      if (constraint.multiplier == prescribed.name && !std::isfinite(constraint.stiffness))
        throw UserError("The list Effects prescribes the " + prescribed.name + " and holds the " + constraint.quantity +
                        " exactly: the multiplier of the constraint is the " + prescribed.name +
                        " and would only take up the prescribed one. Drop one of the two effects, or give the "
                        "constraint a finite Stiffness.");
  if (set.energies.empty())
    throw UserError("The list Effects holds no energy: nothing determines the shape. List 'helfrich bending' or "
                    "'surface tension'.");
}

bool SurfaceScene::is_fixed(const std::string &parameter) const
{
  for (const char *section :
       {"Mesh/", "Newton/", "Output/", "Checkpoint/", "Stability/", "Continuation/", "Load/", "Accuracy/"})
    if (parameter.rfind(section, 0) == 0)
      return true;
  return false;
}

Scales SurfaceScene::scales() const
{
  Scales scales;
  scales.length  = own_length();
  double largest = own_energy(scales.length);
  for (const auto &effect : effects)
    if (const std::optional<double> energy = effect->typical_energy(scales.length))
      largest = std::max(largest, *energy);
  scales.energy = largest > 0. ? largest : 1.;
  return scales;
}

NodalConditions SurfaceScene::conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const
{
  return edge_conditions(surface, targets);
}

// Coarse, but with cells enough for the shape to be recognised: on six cells a vesicle may find another branch.
LevelRange SurfaceScene::level_range() const
{
  LevelRange range;
  range.dimension         = mesh.is_axial() ? 1 : 2;
  const LevelMesh own     = {static_cast<unsigned int>(mesh.degree), static_cast<unsigned int>(mesh.refinements)};
  range.first.degree      = std::min(own.degree, range.dimension == 1 ? 3u : 2u);
  range.first.refinements = std::min(own.refinements, 1u);
  return range;
}

std::vector<std::pair<std::string, double>> SurfaceScene::level_settings(const LevelMesh &level) const
{
  return {{"Mesh/Degree", level.degree}, {"Mesh/Refinements", level.refinements}};
}

void SurfaceScene::check_accuracy() const
{
  const std::string target = "Accuracy/Target = " + exact_text(accuracy.target);
  if (mesh.mirror_planes().any() && accuracy.refinement == "adaptive")
    throw UserError("Accuracy/Refinement = adaptive with Mesh/Symmetry = " + mesh.symmetry +
                    " is not possible: the images of a cell would have to be cut with it. Set one of the two to "
                    "uniform (none).");
  if (!branch.parameter.empty())
    throw UserError(target + " with Continuation/Parameter = " + branch.parameter +
                    " is not possible: the target is for one equilibrium, a branch has many. Give up one of the two; "
                    "section Load leads to an equilibrium with the target.");
  if (motion() != nullptr)
    throw UserError(target + " with Time/End time is not possible: the target is for an equilibrium. Set one of the "
                             "two to 0.");
  for (const std::string &analysis : analyses)
    if (analysis != "stability")
      throw UserError(target + " with the analysis '" + analysis +
                      "' is not possible: the target is for one equilibrium. Set Target to 0.");
}

SceneTargets SurfaceScene::targets(const Scales &scales) const
{
  SceneTargets targets;
  set_targets(scales, targets);
  targets.edges = edges();
  for (const auto &effect : effects)
    effect->prepare(scales, targets);
  return targets;
}

PotentialSet SurfaceScene::potentials(const Scales &scales, const SceneTargets &targets) const
{
  PotentialSet set;
  for (const auto &effect : effects)
    effect->contribute(scales, targets, set);
  return set;
}

std::vector<ParameterDerivative> SurfaceScene::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  std::vector<ParameterDerivative> list;
  for (const auto &effect : effects)
    for (ParameterDerivative &derivative : effect->derivatives(scales, targets))
      list.push_back(std::move(derivative));
  return list;
}

void list_effects(SurfaceScene &scene, const EffectLibrary &library, const std::vector<std::string> &effects,
                  const std::vector<std::string> &analyses)
{
  for (const std::string &name : effects)
    scene.effects.push_back(library.create(name));
  scene.analyses = analyses;
}
} // namespace pellicle
