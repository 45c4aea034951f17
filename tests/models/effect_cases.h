// SPDX-License-Identifier: LGPL-2.1-or-later
// Every effect of every library in a small scene, and what it adds to the scene without it.
#pragma once

#include <pellicle/models/director_scene.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/models/ridge_scene.h>
#include <pellicle/models/shell_scene.h>
#include <pellicle/models/vesicle_scene.h>
#include <pellicle/potentials/wetting/free_contact_line.h>

#include "equilibrium_runs.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pellicle::test
{
using Names = std::vector<std::string>;

/** An effect, the effects beside it, and the fields, terms and inequalities that the scene has because of it. Terms are
 * written as "set: kind 'name'", with "on region" where they act on one alone. */
struct EffectCase
{
  std::string effect;
  Names beside;
  Names fields, terms, inequalities;
  std::function<void(SurfaceScene &)> change = {}; ///< of the scene, with and without the effect
};

struct EffectCases
{
  EffectLibrary library;
  std::function<std::unique_ptr<SurfaceScene>(const EffectLibrary &, const Names &)> make;
  std::vector<EffectCase> cases;
};

template <typename Scene>
std::unique_ptr<SurfaceScene> coarse_scene(const EffectLibrary &library, const Names &effects)
{
  auto scene = std::make_unique<Scene>();
  list_effects(*scene, library, effects, {});
  scene->mesh.symmetry    = "axial";
  scene->mesh.degree      = 2;
  scene->mesh.refinements = 1;
  return scene;
}

inline void start_as_cap(SurfaceScene &scene)
{
  dynamic_cast<VesicleScene &>(scene).vesicle.start_shape = "cap";
}

inline EffectCases vesicle_cases()
{
  const std::string bending = "helfrich bending", area = "area constraint", volume = "volume constraint";
  const auto on_surface = [](const std::string &term) { return Names{"surface: " + term}; };
  std::vector<EffectCase> cases{
      {bending, {"surface tension", volume}, {"moment"}, on_surface("energy 'helfrich bending'"), {}},
      {area, {bending, volume}, {}, on_surface("constraint 'area constraint'"), {}},
      {volume, {bending, area}, {}, on_surface("constraint 'volume constraint'"), {}},
      {"bilayer coupling", {bending, area, volume}, {}, on_surface("constraint 'bilayer coupling'"), {}},
      {"area difference elasticity",
       {bending, area, volume},
       {},
       on_surface("constraint 'area difference elasticity'"),
       {}},
      {"gaussian curvature",
       {bending, "line tension"},
       {"edge conormal", "edge multiplier"},
       // Of bending: the balance of moments at the rim, and the conormal's place in the plane normal to it.
       {"edge rim: energy 'gaussian curvature'", "edge rim: energy 'helfrich bending'",
        "edge rim: energy 'helfrich bending'"},
       {},
       start_as_cap},
      {"line tension", {bending, area}, {}, {"edge rim: energy 'line tension'"}, {}, start_as_cap},
      {"lipid domain",
       {bending, area},
       {},
       {"surface: energy 'helfrich bending' on region 'membrane'",
        "surface: energy 'helfrich bending' on region 'domain'",
        "surface: constraint 'lipid domain' on region 'domain'"},
       {}},
      {"tether",
       {bending},
       {},
       {"surface: energy 'surface tension'", "edge tip: energy 'helfrich bending'", "edge tip: constraint 'tether'",
        "edge ring: energy 'helfrich bending'"},
       {}},
      {"surface tension", {bending, volume}, {}, on_surface("energy 'surface tension'"), {}},
      {"pressure", {bending, area}, {}, on_surface("energy 'pressure'"), {}}};
  for (const char *skin : {"neo-hookean skin", "incompressible rubber skin", "skalak skin", "tu-ou-yang skin"})
    cases.push_back({skin, {bending, volume}, {}, on_surface(std::string("energy '") + skin + "'"), {}});
  return {standard_effects(), coarse_scene<VesicleScene>, std::move(cases)};
}

inline EffectCases droplet_cases()
{
  const std::string surface = "liquid surface", volume = "volume constraint", wetting = "wetting";
  const auto whole_drop = [](SurfaceScene &scene)
  {
    DropletScene &drop         = dynamic_cast<DropletScene &>(scene);
    drop.droplet.base          = "membrane";
    drop.droplet.contact_angle = 180.;
  };
  const auto heavy = [](SurfaceScene &scene) { dynamic_cast<DropletScene &>(scene).droplet.bond_number = 0.5; };
  std::vector<EffectCase> cases{
      {surface, {volume, wetting}, {}, {"surface: energy 'liquid surface'"}, {}},
      {volume, {surface, wetting}, {}, {"surface: constraint 'volume constraint'"}, {}},
      {wetting, {surface, volume}, {}, {"edge contact line: energy 'wetting'"}, {}},
      {"gravity", {surface, volume, wetting}, {}, {"surface: energy 'gravity'"}, {}, heavy},
      {"contact", {surface, volume}, {}, {}, {"contact"}, whole_drop},
      {"line pinning", {surface, volume, wetting}, {}, {"edge contact line: energy 'line pinning'"}, {"line pinning"}},
      {"line tension", {surface, volume, wetting}, {}, {"edge contact line: energy 'line tension'"}, {}},
      {"pressure", {surface, wetting}, {}, {"surface: energy 'pressure'"}, {}}};
  for (const char *skin : {"neo-hookean skin", "incompressible rubber skin"})
    cases.push_back({skin, {surface, volume}, {}, {std::string("surface: energy '") + skin + "'"}, {}, whole_drop});
  return {droplet_effects(), coarse_scene<DropletScene>, std::move(cases)};
}

inline EffectCases ridge_cases()
{
  const std::string surface = "liquid surface", volume = "volume constraint", solid = "solid", skins = "solid skins";
  const auto sticky = [](SurfaceScene &scene)
  {
    dynamic_cast<RidgeScene &>(scene).line.motion = "free";
    for (const auto &listed : scene.effects)
      if (auto *line = dynamic_cast<FreeContactLineEffect *>(listed.get()))
        line->parameters = {1e-3, 1e-3};
  };
  const auto heavy = [](SurfaceScene &scene) { dynamic_cast<RidgeScene &>(scene).droplet.body_force = 0.1; };
  return {ridge_effects(),
          coarse_scene<RidgeScene>,
          {{surface, {volume, solid, skins}, {}, {"surface: energy 'liquid surface' on region 'liquid gas'"}, {}},
           {volume,
            {surface, solid, skins},
            {},
            {"surface: constraint 'volume constraint' on region 'liquid gas'",
             "surface: constraint 'volume constraint' on region 'solid liquid'"},
            {}},
           {solid, {surface, volume, skins}, {}, {"body substrate: energy 'solid'"}, {}},
           {skins,
            {surface, volume, solid},
            {},
            {"surface: energy 'solid skins' on region 'solid liquid'",
             "surface: energy 'solid skins' on region 'solid gas'"},
            {}},
           {"free contact line",
            {surface, volume, solid, skins},
            {},
            {"edge contact line: energy 'line pinning'"},
            {"line pinning"},
            sticky},
           {"gravity",
            {surface, volume, solid, skins},
            {},
            {"surface: energy 'gravity' on region 'liquid gas'", "surface: energy 'gravity' on region 'solid liquid'"},
            {},
            heavy},
           {"line tension", {surface, volume, solid, skins}, {}, {"edge contact line: energy 'line tension'"}, {}}}};
}

/** Its own effects: the others are those of vesicles. */
inline EffectCases director_cases()
{
  const std::string bending = "helfrich bending", area = "area constraint", volume = "volume constraint",
                    director = "director";
  return {director_effects(),
          coarse_scene<DirectorScene>,
          {{director,
            {bending, area, volume},
            {"director", "director shear"},
            {"surface: energy 'tilt'", "surface: energy 'director gradient'"},
            {}},
           {"spontaneous director curvature",
            {director, bending, area, volume},
            {},
            {"surface: energy 'spontaneous director curvature'"},
            {}},
           {"in-plane directors", {director, bending, area, volume}, {}, {"surface: energy 'normal director'"}, {}},
           {"director friction", {director, "skalak skin"}, {}, {"surface: dissipation 'director friction'"}, {}}}};
}

inline EffectCases shell_cases()
{
  const auto shell = [](const EffectLibrary &library, const Names &effects)
  {
    auto scene              = std::make_unique<ShellScene>();
    scene->mesh.degree      = 2;
    scene->mesh.refinements = 0;
    list_effects(*scene, library, effects, {});
    return scene;
  };
  return {director_effects(),
          shell,
          {{"cosserat shell",
            {"point loads"},
            {"shell director", "shell stress 1", "shell stress 2"},
            {"surface: energy 'shell strain'", "surface: energy 'shell bending'"},
            {}},
           {"dead load", {"cosserat shell"}, {}, {"surface: energy 'dead load'"}, {}},
           {"point loads",
            {"cosserat shell"},
            {},
            {"edge load point a: energy 'point loads'", "edge load point b: energy 'point loads'"},
            {}}}};
}
} // namespace pellicle::test
