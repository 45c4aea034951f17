// SPDX-License-Identifier: LGPL-2.1-or-later
// A picture from end to end: a biconcave surface, its VTU file, the renderer, the PNG.
#include "sample_shapes.h"
#include "temporary_directory.h"

#include <pellicle/output/atomic_file.h>
#include <pellicle/output/picture.h>
#include <pellicle/output/program.h>
#include <pellicle/output/vtu.h>

#include <gtest/gtest.h>

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
