// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/shell_shapes.h>
#include <pellicle/models/surface_scene.h>

#include <string>
#include <vector>

namespace pellicle
{
/** Section "Shell": the undeformed shell, in the user's units. */
struct ShellParameters
{
  std::string shape      = "hemisphere";
  double radius          = 10.;
  double length          = 10.;
  double width           = 10.;
  double angle           = 18.; ///< degrees
  std::string load_shape = "1";

  void bind(ParameterSection &section);
};

/** A Cosserat shell: the effect "cosserat shell" and its loads on one of the shapes of ShellShape. */
class ShellScene : public SurfaceScene
{
public:
  ShellParameters shell;

  void check() const override;
  SurfaceDiscretization start_mesh() const override;
  bool has_origin() const override { return true; }
  std::vector<SceneEdge> edges() const override { return {}; }
  NodalConditions conditions(const SurfaceDiscretization &surface, const SceneTargets &targets) const override;
  /** `load_point_displacement`, the largest size of a load point's displacement along its direction, and that of each
   * point, `displacement_at_load_point_a` and so on, positive along the direction. */
  SurfaceMeasures measures(const Scales &scales) const override;
  void add_references(const SurfaceDiscretization &start, SceneTargets &targets) const override;

protected:
  void add_own_sections(std::vector<ParameterSection> &all) override;
  double own_length() const override;
  void set_targets(const Scales &scales, SceneTargets &targets) const override;
  bool is_fixed(const std::string &parameter) const override;

private:
  /** With lengths divided by `unit`. */
  ShellShape shape(double unit) const;
};

/** A scene with the named effects of a library, parameters at their defaults. Throws UserError for an unknown effect.
 */
ShellScene make_shell_scene(const EffectLibrary &library, const std::vector<std::string> &effects,
                            const std::vector<std::string> &analyses);
} // namespace pellicle
