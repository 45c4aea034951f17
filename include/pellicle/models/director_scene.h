// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/inclusions.h>
#include <pellicle/models/vesicle_scene.h>

#include <string>
#include <vector>

namespace pellicle
{
/** Section "Surface": which surface carries the directors, and whether it moves. */
struct CarrierParameters
{
  std::string shape  = "vesicle";
  std::string motion = "free";

  void bind(ParameterSection &section);
};

/** Section "Director field": directors at the start, and what holds them at rims. */
struct DirectorFieldParameters
{
  std::string start  = "normal";
  double angle       = 0.;
  double noise       = 0.;
  int random_seed    = 1;
  std::string at_rim = "free";

  void bind(ParameterSection &section);
};

/** A membrane with directors: a vesicle, an open membrane, or one around inclusions; held or free to move. */
class DirectorScene : public VesicleScene
{
public:
  CarrierParameters carrier;
  InclusionParameters inclusion;
  DirectorFieldParameters field;
  TimeParameters time;

  void check() const override;
  /** The moment, or the shear of directors. */
  bool splits_domain() const override;
  SurfaceDiscretization start_mesh() const override;
  std::map<std::string, std::vector<Vector3<double>>> rim_conormals(const SurfaceDiscretization &start) const override;
  std::vector<SceneEdge> edges() const override;
  NodalConditions conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const override;
  SurfaceMeasures measures(const Scales &scales) const override;
  std::string headline_quantity() const override { return "total_energy"; }
  void add_references(const SurfaceDiscretization &start, SceneTargets &targets) const override;
  const TimeParameters *motion() const override { return time.end_time > 0. ? &time : nullptr; }

protected:
  void add_own_sections(std::vector<ParameterSection> &all) override;
  void add_further_sections(std::vector<ParameterSection> &all) override;
  double own_length() const override;
  void set_targets(const Scales &scales, SceneTargets &targets) const override;
  bool is_fixed(const std::string &parameter) const override;

private:
  bool has_inclusion() const { return has_inclusions(carrier.shape); }
  bool is_held() const { return carrier.motion == "held"; }
  void check_time() const;
  void check_domain() const;
  InclusionMembrane around_inclusions() const;
};
} // namespace pellicle
