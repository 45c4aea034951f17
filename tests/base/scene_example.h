// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameters of an imaginary application that has every kind of parameter.
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/base/scene_text.h>

#include <limits>
#include <string>
#include <vector>

namespace pellicle::test_scene
{
struct Vesicle
{
  double area           = 4. * pi;
  double reduced_volume = 1.;
  double stiffness      = std::numeric_limits<double>::infinity();
  std::string shape     = "prolate";
  std::string file;
  std::vector<double> axes = {1., 1. / 3., 0.1};
  int seed                 = 1;
  bool noisy               = false;

  void bind(ParameterSection &section)
  {
    section.number("Area", area, Range::positive(), dimensions::area, "Area of the membrane.");
    section.number(
        "Reduced volume", reduced_volume, Range{0., 1., true, false, false}, dimensions::none,
        "v = 3 V / (4 pi (A / 4 pi)^1.5): how much of the sphere of the same area the vesicle fills. A sphere has "
        "1, a stomatocyte about 0.6, and nothing is below 0 | above 1.");
    section.number("Stiffness", stiffness, Range::positive().or_infinite(), dimensions::pressure,
                   "inf: exact constraint.");
    section.choice("Start shape", shape, {"prolate", "oblate", "file"}, "Shape at the start.");
    section.word("File", file, "Mesh file.");
    section.numbers("Semi axes", axes, Range::positive(), dimensions::length, "Of the ellipsoid.");
    section.integer("Random seed", seed, 0, std::numeric_limits<int>::max(), "Of the noise.");
    section.flag("Noisy", noisy, "Whether nodes are perturbed.");
  }
};

struct Mesh
{
  int degree = 3;
  void bind(ParameterSection &section) { section.integer("Degree", degree, 2, 5, "Polynomial degree."); }
};

struct Quality
{
  double weight = 0.1;
  void bind(ParameterSection &section)
  {
    section.number("Weight", weight, Range::any(), dimensions::none, "Weight of the mesh energy.");
  }
};

struct Bending
{
  double rigidity = 1e-19;
  void bind(ParameterSection &section)
  {
    section.number("Bending rigidity", rigidity, Range::positive(), dimensions::energy, "kappa.");
  }
};

struct Pressure
{
  double pressure = 0.;
  void bind(ParameterSection &section)
  {
    section.number("Pressure", pressure, Range::any(), dimensions::pressure, "P, inside minus outside.");
  }
};

template <typename Struct>
ParameterSection bound(const std::string &name, Struct &parameters)
{
  ParameterSection section(name);
  parameters.bind(section);
  return section;
}

/** All structs; the effect 'pressure' is not listed. */
struct Parameters
{
  Vesicle vesicle;
  Mesh mesh;
  Quality quality;
  Bending bending;
  Pressure pressure;

  std::vector<ParameterSection> listed()
  {
    return {bound("Vesicle", vesicle), bound("Mesh", mesh), bound("Mesh/Quality", quality),
            bound("Helfrich bending", bending), ParameterSection("Area constraint")};
  }
};

inline const std::vector<std::string> unlisted_sections = {"Pressure"};

/** Everything that the syntax of scene files offers. */
inline const char *const every_construct = R"(# a comment
set Effects = helfrich bending, \
              area constraint   # comment behind an entry

subsection Mesh
  set Degree = 4
  subsection Inner part
	set	File=a b.msh
  end
  set Refinements =
end # of Mesh
SUBSECTION Vesicle
  SET Reduced volume   =   2 * (0.4) = x
END
)";

inline const std::vector<std::string> effects = {"helfrich bending", "area constraint"}, analyses = {"stability"};

inline SceneDescription description(Parameters &parameters)
{
  return {"vesicle",
          effects,
          analyses,
          {"helfrich bending", "area constraint", "pressure"},
          {"stability", "spectrum"},
          parameters.listed(),
          {{"pressure", bound("Pressure", parameters.pressure)}}};
}

} // namespace pellicle::test_scene
