// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sample_shapes.h"
#include "temporary_directory.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/output/program.h>
#include <pellicle/output/vtu.h>

#include <gtest/gtest.h>

#include <cmath>

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

/** The unit block in 2 x 1 x 3 cells, x = (X + .2 Y^k, Y, Z (1 + .3 X)) in polynomials that the cells hold. */
SurfaceSample bent_block(const unsigned int k)
{
  SurfaceSample sample;
  sample.dimension = 3;
  sample.degree    = k;
  sample.n_cells   = 6;
  SampledField material{"material_position", 3, {}}, tensor{"cauchy_stress", 9, {}};
  for (unsigned int cell = 0; cell < 6; ++cell)
    for (unsigned int p = 0; p < sample.points_per_cell(); ++p)
    {
      const unsigned int n = k + 1;
      const double X = (cell % 2 + double(p % n) / k) / 2., Y = double(p / n % n) / k,
                   Z = (cell / 2 + double(p / n / n) / k) / 3.;
      material.values.insert(material.values.end(), {X, Y, Z});
      sample.points.insert(sample.points.end(), {X + .2 * std::pow(Y, k), Y, Z * (1. + .3 * X)});
      for (unsigned int c = 0; c < 9; ++c)
        tensor.values.push_back(c);
    }
  sample.fields = {material, tensor};
  return sample;
}

class VtuOfBodies : public ::testing::TestWithParam<unsigned int>
{
};

TEST_P(VtuOfBodies, IsTheBlockToVtk)
{
  const TemporaryDirectory directory;
  const auto path = directory.path() / "block.vtu";
  write_vtu(path, bent_block(GetParam()));
  const ProgramEnd end = run_program({"/usr/bin/python3", PELLICLE_SOURCE_DIR "/tests/output/check_hexahedra.py",
                                      path.string(), std::to_string(GetParam()), "6", "1.15"},
                                     60.);
  if (end.exit_status == no_vtk || end.exit_status == 127)
    GTEST_SKIP() << "VTK for Python is not installed";
  EXPECT_EQ(end.exit_status, 0) << end.output;
}

INSTANTIATE_TEST_SUITE_P(Degrees, VtuOfBodies, ::testing::Values(1u, 2u, 3u));

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

TEST(SolutionFiles, BodiesAreFurtherParts)
{
  const TemporaryDirectory directory;
  SolutionFiles files(directory.path());
  files.write(sphere_sample(1., 2, 1), 3, 1.5, {{"substrate", bent_block(2)}});
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "substrate_0003.vtu"));
  const std::string index = content_of(directory.path() / "solution.pvd");
  for (const char *part : {R"(timestep="1.5" group="" part="0" file="solution_0003.vtu")",
                           R"(timestep="1.5" group="" part="1" file="substrate_0003.vtu")"})
    EXPECT_NE(index.find(part), std::string::npos) << index;
}

TEST(SolutionFiles, RefuseADirectoryThatCannotBeWritten)
{
  EXPECT_THROW(SolutionFiles("/dev/null/below").write(sphere_sample(1., 1, 1), 0, 0.), UserError);
}
