// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sample_shapes.h"
#include "temporary_directory.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/output/program.h>
#include <pellicle/output/vtu.h>

#include <gtest/gtest.h>

using namespace pellicle;
using pellicle::testing::content_of;
using pellicle::testing::sphere_sample;
using pellicle::testing::TemporaryDirectory;

namespace
{
constexpr int no_vtk = 77; // what check_vtu.py says when VTK is not installed

/** Lets VTK read the file: see check_vtu.py. */
ProgramEnd check_with_vtk(const std::filesystem::path &vtu, const unsigned int degree, const unsigned int n_cells,
                          const double radius)
{
  return run_program({"/usr/bin/python3", PELLICLE_SOURCE_DIR "/tests/output/check_vtu.py", vtu.string(),
                      std::to_string(degree), std::to_string(n_cells), std::to_string(radius)},
                     60.);
}
} // namespace

class VtuDegree : public ::testing::TestWithParam<unsigned int>
{
};

TEST_P(VtuDegree, IsTheSphereToVtk)
{
  const TemporaryDirectory directory;
  const unsigned int degree = GetParam();
  SurfaceSample sample      = sphere_sample(2., degree, 4);
  SampledField normal{"director", 3, {}};
  for (const double x : sample.points)
    normal.values.push_back(x / 2.);
  sample.fields.push_back(normal);

  const auto path = directory.path() / "sphere.vtu";
  write_vtu(path, sample);
  const ProgramEnd end = check_with_vtk(path, degree, 96, 2.);
  if (end.exit_status == no_vtk || end.exit_status == 127)
    GTEST_SKIP() << "VTK for Python is not installed";
  EXPECT_EQ(end.exit_status, 0) << end.output;
}

INSTANTIATE_TEST_SUITE_P(Degrees, VtuDegree, ::testing::Values(1u, 2u, 3u, 5u));

TEST(SolutionFiles, NumbersFilesAndListsThem)
{
  const TemporaryDirectory directory;
  const SurfaceSample sample = sphere_sample(1., 2, 1);
  SolutionFiles files(directory.path());
  EXPECT_EQ(files.write(sample, 0, 0.95).filename(), "solution_0000.vtu");
  EXPECT_EQ(files.write(sample, 12, 0.65).filename(), "solution_0012.vtu");
  EXPECT_EQ(content_of(directory.path() / "solution_0000.vtu"), content_of(directory.path() / "solution_0012.vtu"));

  const std::string index = content_of(directory.path() / "solution.pvd");
  for (const char *part :
       {"timestep=\"0.95\"", "file=\"solution_0000.vtu\"", "timestep=\"0.65\"", "file=\"solution_0012.vtu\""})
    EXPECT_NE(index.find(part), std::string::npos) << index;
  EXPECT_EQ(pellicle::testing::n_files_in(directory.path()), 3u);
}

TEST(SolutionFiles, RefuseADirectoryThatCannotBeWritten)
{
  EXPECT_THROW(SolutionFiles("/dev/null/below").write(sphere_sample(1., 1, 1), 0, 0.), UserError);
}
