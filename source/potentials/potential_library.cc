// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/constraints/bilayer_curvature.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/tether.h>
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/contact/contact_effect.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/director/in_plane_directors.h>
#include <pellicle/potentials/director/spontaneous_curvature_effect.h>
#include <pellicle/potentials/dissipations/director_friction.h>
#include <pellicle/potentials/edges/gaussian_curvature.h>
#include <pellicle/potentials/edges/line_tension.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/energies/helfrich_bending.h>
#include <pellicle/potentials/energies/incompressible_rubber_skin.h>
#include <pellicle/potentials/energies/liquid_surface.h>
#include <pellicle/potentials/energies/neo_hookean_skin.h>
#include <pellicle/potentials/energies/pressure.h>
#include <pellicle/potentials/energies/skalak_skin.h>
#include <pellicle/potentials/energies/surface_tension.h>
#include <pellicle/potentials/energies/tu_ou_yang_skin.h>
#include <pellicle/potentials/potential_library.h>
#include <pellicle/potentials/shell/cosserat_shell.h>
#include <pellicle/potentials/shell/shell_loads.h>
#include <pellicle/potentials/solids/solid_effect.h>
#include <pellicle/potentials/wetting/free_contact_line.h>
#include <pellicle/potentials/wetting/line_pinning.h>
#include <pellicle/potentials/wetting/solid_skins.h>
#include <pellicle/potentials/wetting/wetting.h>

#include <cctype>

namespace pellicle
{
EffectLibrary standard_effects()
{
  EffectLibrary library("effect");
  library.add("helfrich bending", [] { return std::make_unique<HelfrichBendingEffect>(); });
  library.add("area constraint", [] { return std::make_unique<AreaConstraintEffect>(); });
  library.add("volume constraint", [] { return std::make_unique<VolumeConstraintEffect>(); });
  library.add("bilayer coupling", [] { return std::make_unique<BilayerCouplingEffect>(); });
  library.add("area difference elasticity", [] { return std::make_unique<AreaDifferenceElasticityEffect>(); });
  library.add("gaussian curvature", [] { return std::make_unique<GaussianCurvatureEffect>(); });
  library.add("line tension", [] { return std::make_unique<LineTensionEffect>(); });
  library.add("lipid domain", [] { return std::make_unique<LipidDomainEffect>(); });
  library.add("tether", [] { return std::make_unique<TetherEffect>(); });
  library.add("surface tension", [] { return std::make_unique<SurfaceTensionEffect>(); });
  library.add("pressure", [] { return std::make_unique<PressureEffect>(); });
  library.add(NeoHookeanSkin::name, [] { return std::make_unique<SkinEffect<NeoHookeanSkin>>(); });
  library.add(IncompressibleRubberSkin::name, [] { return std::make_unique<SkinEffect<IncompressibleRubberSkin>>(); });
  library.add(SkalakSkin::name, [] { return std::make_unique<SkinEffect<SkalakSkin>>(); });
  library.add(TuOuYangSkin::name, [] { return std::make_unique<SkinEffect<TuOuYangSkin>>(); });
  return library;
}

EffectLibrary droplet_effects()
{
  EffectLibrary library("effect");
  library.add("liquid surface", [] { return std::make_unique<LiquidSurfaceEffect>(); });
  library.add("volume constraint", [] { return std::make_unique<VolumeConstraintEffect>(); });
  library.add("wetting", [] { return std::make_unique<WettingEffect>(); });
  library.add("gravity", [] { return std::make_unique<GravityEffect>(); });
  library.add("contact", [] { return std::make_unique<ContactEffect>(); });
  library.add("line pinning", [] { return std::make_unique<LinePinningEffect>(); });
  library.add("line tension", [] { return std::make_unique<LineTensionEffect>(); });
  library.add("pressure", [] { return std::make_unique<PressureEffect>(); });
  library.add(NeoHookeanSkin::name, [] { return std::make_unique<SkinEffect<NeoHookeanSkin>>(); });
  library.add(IncompressibleRubberSkin::name, [] { return std::make_unique<SkinEffect<IncompressibleRubberSkin>>(); });
  return library;
}

EffectLibrary ridge_effects()
{
  EffectLibrary library("effect");
  library.add("liquid surface", [] { return std::make_unique<LiquidSurfaceEffect>(); });
  library.add("volume constraint", [] { return std::make_unique<VolumeConstraintEffect>(); });
  library.add("solid", [] { return std::make_unique<SolidEffect>(); });
  library.add("solid skins", [] { return std::make_unique<SolidSkinsEffect>(); });
  library.add("free contact line", [] { return std::make_unique<FreeContactLineEffect>(); });
  library.add("gravity", [] { return std::make_unique<GravityEffect>(); });
  library.add("line tension", [] { return std::make_unique<LineTensionEffect>(); });
  return library;
}

EffectLibrary director_effects()
{
  EffectLibrary library = standard_effects();
  library.add("director", [] { return std::make_unique<DirectorEffect>(); });
  library.add("spontaneous director curvature", [] { return std::make_unique<SpontaneousDirectorCurvatureEffect>(); });
  library.add("in-plane directors", [] { return std::make_unique<InPlaneDirectorsEffect>(); });
  library.add("director friction", [] { return std::make_unique<DirectorFrictionEffect>(); });
  library.add("cosserat shell", [] { return std::make_unique<CosseratShellEffect>(); });
  library.add("dead load", [] { return std::make_unique<DeadLoadEffect>(); });
  library.add("point loads", [] { return std::make_unique<PointLoadsEffect>(); });
  return library;
}

const DropletTargets &SceneTargets::drop() const
{
  if (!droplet)
    throw UserError("The effects 'liquid surface', 'wetting' and 'gravity' need a drop: they belong to scenes with a "
                    "section Droplet.");
  return *droplet;
}

const RidgeTargets &SceneTargets::soft_substrate() const
{
  if (!substrate)
    throw UserError("The effects 'solid', 'solid skins' and 'free contact line' need a soft substrate: they belong to "
                    "scenes of wetting_ridge.");
  return *substrate;
}

const DirectorLaw &SceneTargets::director_law() const
{
  if (directors.empty())
    throw UserError("The effects of directors other than 'director' need it besides them: add 'director' to Effects.");
  return directors[0];
}

Where SceneTargets::region_of_directors(const std::size_t law) const
{
  return directors.size() == 1 ? Where{} : Where{Where::Part::region, region_name(law)};
}

const ShellTargets &SceneTargets::shell_targets() const
{
  if (!shell)
    throw UserError(
        "The effects 'cosserat shell', 'dead load' and 'point loads' need a shell: they belong to scenes with "
        "a section Shell.");
  return *shell;
}

std::vector<Where> boundary_of_liquid(const SceneTargets &targets)
{
  std::vector<Where> parts;
  if (targets.droplet)
    for (const std::string &region : targets.droplet->bounded_by)
      parts.push_back({Where::Part::region, region});
  return parts.empty() ? std::vector<Where>{Where()} : parts;
}

const std::string &region_name(const std::size_t region)
{
  static const std::vector<std::string> names{"membrane", "domain"};
  return names.at(region);
}

std::string section_name(const std::string &effect_name)
{
  std::string name = effect_name;
  if (!name.empty())
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}
} // namespace pellicle
