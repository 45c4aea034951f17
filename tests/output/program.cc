// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/picture.h>
#include <pellicle/output/program.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

using namespace pellicle;

TEST(RunProgram, GivesStatusAndOutput)
{
  const ProgramEnd end = run_program({"/bin/sh", "-c", "echo out; echo err >&2; exit 7"}, 10.);
  EXPECT_TRUE(end.started);
  EXPECT_FALSE(end.timed_out);
  EXPECT_EQ(end.exit_status, 7);
  EXPECT_EQ(end.output, "out\nerr\n");
}

TEST(RunProgram, MissingProgram)
{
  EXPECT_EQ(run_program({"/nowhere/program"}, 10.).exit_status, 127);
}

TEST(RunProgram, StopsAProgramAndItsChildren)
{
  const auto start     = std::chrono::steady_clock::now();
  const ProgramEnd end = run_program({"/bin/sh", "-c", "sleep 100 & echo $!; wait"}, 0.3);
  EXPECT_TRUE(end.timed_out);
  EXPECT_EQ(end.exit_status, -1);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5.);
  // At most a zombie is left of the grandchild, until init collects it.
  const ProgramEnd look =
      run_program({"/bin/sh", "-c",
                   "sleep 0.2; ps -o stat= -p " + std::to_string(std::atoi(end.output.c_str())) + " | grep -v Z; true"},
                  10.);
  EXPECT_EQ(look.output, "");
}

TEST(RunProgram, TakesNoPartInAnMpiJob)
{
  ::setenv("OMPI_COMM_WORLD_RANK", "0", 1);
  ::setenv("PELLICLE_TEST_VARIABLE", "kept", 1);
  const ProgramEnd end = run_program({"/bin/sh", "-c", "echo \"$OMPI_COMM_WORLD_RANK$PELLICLE_TEST_VARIABLE\""}, 10.);
  ::unsetenv("OMPI_COMM_WORLD_RANK");
  ::unsetenv("PELLICLE_TEST_VARIABLE");
  EXPECT_EQ(end.output, "kept\n");
}

TEST(RenderPicture, FindsItsScript)
{
  const auto script = find_render_script("render_section.py");
  ASSERT_TRUE(script);
  EXPECT_EQ(script->filename(), "render_section.py");
}
