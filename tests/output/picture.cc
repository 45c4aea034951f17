// SPDX-License-Identifier: LGPL-2.1-or-later
// A picture from end to end: a biconcave surface, its VTU file, the renderer, the PNG.
#include "sample_shapes.h"
#include "temporary_directory.h"

#include <pellicle/base/constants.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/picture.h>
#include <pellicle/output/program.h>
#include <pellicle/output/vtu.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pellicle;
using pellicle::testing::TemporaryDirectory;

namespace
{
/** True if the reason is that a package is missing, for which a test cannot be blamed. */
bool is_not_installed(const std::string &reason)
{
  return reason.find("apt-get install") != std::string::npos;
}
} // namespace

TEST(Picture, OfABiconcaveSurface)
{
  const TemporaryDirectory directory;
  const auto vtu = directory.path() / "shape.vtu", png = directory.path() / "picture.png";
  write_vtu(vtu, pellicle::testing::biconcave_sample(3, 4));
  if (const auto reason = render_picture(vtu, "", png, "Biconcave, \"drawn\" as a test; $HOME"))
  {
    if (is_not_installed(*reason))
      GTEST_SKIP() << *reason;
    FAIL() << *reason;
  }
  ASSERT_TRUE(std::filesystem::exists(png));
  EXPECT_GT(std::filesystem::file_size(png), 10000u);
  EXPECT_EQ(pellicle::testing::n_files_in(directory.path()), 2u);
  const ProgramEnd colours =
      run_program({"/usr/bin/python3", PELLICLE_SOURCE_DIR "/tests/output/check_picture.py", png.string()}, 60.);
  EXPECT_EQ(colours.exit_status, 0) << colours.output;
}

/** A square in the plane z = 0. */
SurfaceSample flat_sample()
{
  constexpr unsigned int n = 4, k = 2;
  SurfaceSample sample;
  sample.degree  = k;
  sample.n_cells = n * n;
  for (unsigned int cell = 0; cell < sample.n_cells; ++cell)
    for (unsigned int p = 0; p < sample.points_per_cell(); ++p)
      sample.points.insert(sample.points.end(),
                           {cell % n + p % (k + 1) / double(k), cell / n + p / (k + 1) / double(k), 0.});
  sample.fields = {{"mean_curvature_outward", 1, std::vector<double>(sample.n_points(), 0.)}};
  return sample;
}

/** Directors in a surface of revolution, round the axis, or along the axis in the plane. */
void add_directors(SurfaceSample &sample, const bool round)
{
  SampledField director{"director", 3, {}}, tilt{"tilt", 3, {}};
  for (std::size_t i = 0; i < sample.n_points(); ++i)
  {
    const double x = sample.points[3 * i], y = sample.points[3 * i + 1], r = std::hypot(x, y);
    if (round && r > 0.)
      director.values.insert(director.values.end(), {-y / r, x / r, 0.});
    else
      director.values.insert(director.values.end(), {0., 0., 1.});
    for (unsigned int c = 0; c < 3; ++c)
      tilt.values.push_back(round && r > 0. ? director.values[3 * i + c] : 0.);
  }
  sample.fields.push_back(director);
  sample.fields.push_back(tilt);
}

TEST(Picture, DirectorsAreNeedles)
{
  const TemporaryDirectory directory;
  const auto vtu = directory.path() / "shape.vtu", with = directory.path() / "with.png",
             without = directory.path() / "without.png";
  for (const bool is_flat : {false, true})
  {
    SCOPED_TRACE(is_flat ? "flat" : "sphere");
    SurfaceSample sample = is_flat ? flat_sample() : pellicle::testing::sphere_sample(1.3, 3, 2);
    for (const auto &png : {without, with})
    {
      write_vtu(vtu, sample);
      if (const auto reason = render_picture(vtu, "", png, "Directors"))
      {
        if (is_not_installed(*reason))
          GTEST_SKIP() << *reason;
        FAIL() << *reason;
      }
      add_directors(sample, !is_flat);
    }
    const ProgramEnd needles = run_program(
        {"/usr/bin/python3", PELLICLE_SOURCE_DIR "/tests/output/check_needles.py", with.string(), without.string()},
        60.);
    EXPECT_EQ(needles.exit_status, 0) << needles.output;
  }
}

/** A hemisphere on the top of a body of radius 2 or, as a block, of half width 2, that has a ridge at r = 1. */
class DropOnRidge
{
public:
  SurfaceSample surface, body;

  explicit DropOnRidge(const bool axial)
  {
    surface.degree = body.degree = 2;
    SampledField region{"region", 1, {}};
    for (unsigned int number = 0; number < 3; ++number)
      for (unsigned int c = 0; c < 16 * n; ++c)
        for (unsigned int p = 0; p < 9; ++p)
        {
          const double s = (c % n + (p % 3) / 2.) / n, phi = 2. * pi / 16. * (c / n + (p / 3) / 2.);
          const double r = number == 0 ? std::sin(pi / 2. * s) : number == 1 ? 1. - s : 1. + s;
          const double z = number == 0 ? std::cos(pi / 2. * s) + height(1.) : height(r);
          surface.points.insert(surface.points.end(), {r * std::cos(phi), r * std::sin(phi), z});
          region.values.push_back(number);
          surface.n_cells += p == 0;
        }
    surface.fields = {region};

    SampledField material{"material_position", 3, {}}, displacement{"displacement", 3, {}};
    body.dimension = axial ? 2 : 3;
    body.n_cells   = axial ? n * n : n * n * n;
    for (unsigned int c = 0; c < body.n_cells; ++c)
      for (unsigned int p = 0; p < body.points_per_cell(); ++p)
      {
        const auto at  = [&](const unsigned int i, const unsigned int j) { return (i + j / 2.) / n; };
        const double X = axial ? 2. * at(c % n, p % 3) : 4. * at(c % n, p % 3) - 2.,
                     Y = axial ? 0. : 2. * at(c / n / n, p / 9), Z = at(c / n % n, p / 3 % 3) - 1.,
                     u = (1. + Z) * height(std::hypot(X, Y));
        material.values.insert(material.values.end(), {X, Y, Z});
        displacement.values.insert(displacement.values.end(), {0., 0., u});
        body.points.insert(body.points.end(), {X, Y, Z + u});
      }
    body.fields = {material, displacement};
  }

private:
  static constexpr unsigned int n = 8;
  static double height(const double r) { return 0.15 * std::exp(-std::pow((r - 1.) / 0.4, 2)) - 0.05; }
};

TEST(Picture, OfADropInSection)
{
  for (const bool axial : {true, false})
  {
    const TemporaryDirectory directory;
    const auto vtu = directory.path() / "drop.vtu", body = directory.path() / "body.vtu",
               png = directory.path() / "picture.png";
    const DropOnRidge scene(axial);
    write_vtu(vtu, scene.surface);
    write_vtu(body, scene.body);
    if (const auto reason = render_section(vtu, body, png, "Ridge"))
    {
      if (is_not_installed(*reason))
        GTEST_SKIP() << *reason;
      FAIL() << *reason;
    }
    const ProgramEnd colours =
        run_program({"/usr/bin/python3", PELLICLE_SOURCE_DIR "/tests/output/check_picture.py", png.string()}, 60.);
    EXPECT_EQ(colours.exit_status, 0) << colours.output;
    const auto without_body = render_section(vtu, vtu, png, "");
    ASSERT_TRUE(without_body);
    EXPECT_NE(without_body->find("there is no scalar field 'displacement:2'"), std::string::npos) << *without_body;
  }
}

TEST(Picture, GivesAReasonInsteadOfAPicture)
{
  const TemporaryDirectory directory;
  const auto png = directory.path() / "picture.png";
  write_whole_file(directory.path() / "broken.vtu", "this is not XML");
  for (const char *name : {"missing.vtu", "broken.vtu"})
  {
    const auto reason = render_picture(directory.path() / name, "", png, "");
    ASSERT_TRUE(reason);
    EXPECT_EQ(reason->rfind("No picture: ", 0), 0u) << *reason;
    EXPECT_TRUE(is_not_installed(*reason) || reason->find(name) != std::string::npos) << *reason;
    EXPECT_FALSE(std::filesystem::exists(png));
  }
}
