// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole files, tables, the output directory.
#include "expect_user_error.h"
#include "temporary_directory.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/observer_list.h>
#include <pellicle/output/run_files.h>
#include <pellicle/output/tables.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace pellicle;
using pellicle::testing::content_of;
using pellicle::testing::n_files_in;
using pellicle::testing::TemporaryDirectory;

TEST(WholeFile, ReplacesAndLeavesNoTemporary)
{
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.txt";
  write_whole_file(path, "a long first text\n");
  write_whole_file(path, std::string("short\0one", 9));
  EXPECT_EQ(content_of(path), std::string("short\0one", 9));
  EXPECT_EQ(n_files_in(directory.path()), 1u);
}

TEST(WholeFile, SaysPathAndReason)
{
  const TemporaryDirectory directory;
  write_whole_file(directory.path() / "file", "");
  // Below a regular file nothing can be written, not even by root.
  const auto path = directory.path() / "file" / "summary.json";
  EXPECT_USER_ERROR(write_whole_file(path, "x"), path.string(), "Not a directory", "--output-directory");
}

TEST(WholeFile, CleansUpWhenTheNameIsTaken)
{
  const TemporaryDirectory directory;
  make_directory(directory.path() / "taken" / "inside");
  EXPECT_THROW(write_whole_file(directory.path() / "taken", "x"), UserError);
  EXPECT_EQ(n_files_in(directory.path()), 1u);
}

TEST(MakeDirectory, NestedAndRefused)
{
  const TemporaryDirectory directory;
  const auto nested = directory.path() / "a" / "b" / "c";
  make_directory(nested);
  make_directory(nested);
  EXPECT_TRUE(std::filesystem::is_directory(nested));
  write_whole_file(directory.path() / "file", "");
  for (const auto &path : {directory.path() / "file", directory.path() / "file" / "below"})
    EXPECT_USER_ERROR(make_directory(path), "'" + path.string() + "'");
}

TEST(Csv, QuotesOnlyWhereNeeded)
{
  EXPECT_EQ(csv_field("Vesicle/Reduced volume"), "Vesicle/Reduced volume");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"x\""), "\"say \"\"x\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_line({"a", "", "b,c"}), "a,,\"b,c\"\n");
  EXPECT_EQ(csv_line({}), "\n");
}

TEST(Csv, NumbersReadBack)
{
  for (const double value : {0.1, 1. / 3., 1e-300, -12345.678901234567, 4 * pi, 5e-324, 1.7976931348623157e308})
    EXPECT_EQ(std::strtod(number_text(value).c_str(), nullptr), value) << number_text(value);
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-std::nan("")), "nan");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(RunFiles, WriteOneWholeLineAReport)
{
  const TemporaryDirectory directory;
  write_whole_file(directory.path() / "history.csv", "old\n");
  RunFiles files(directory.path());
  EXPECT_EQ(content_of(directory.path() / "history.csv"), "");

  ObserverList list({&files});
  IterationReport iteration;
  iteration.step              = 2;
  iteration.iteration         = 3;
  iteration.relative_residual = 1.5e-11;
  iteration.step_length       = 0.25;
  iteration.energy            = 100.5;
  iteration.rejected          = 1;
  iteration.seconds           = 0.125;
  list.on_iteration(iteration);
  // Read while the table is still open: what was reported is there.
  EXPECT_EQ(content_of(directory.path() / "convergence.csv"),
            "step,iteration,relative_residual,step_length,energy,rejected,seconds\n"
            "2,3,1.5e-11,0.25,100.5,1,0.125\n");

  StepReport step;
  step.step       = 1;
  step.stepped    = {{"load", 2.}, {"Tether/Length, \"total\"", 0.5}};
  step.quantities = {{"area", 12.5}, {"force", std::nan("")}};
  list.on_step(step);
  step.step       = 2;
  step.quantities = {{"force", 3.}, {"area", 13.}};
  list.on_step(step);
  EXPECT_EQ(content_of(directory.path() / "history.csv"), "step,load,\"Tether/Length, \"\"total\"\"\",area,force\n"
                                                          "1,2,0.5,12.5,nan\n"
                                                          "2,2,0.5,13,3\n");
}

TEST(RunFiles, LateQuantityGetsAColumn)
{
  const TemporaryDirectory directory;
  RunFiles files(directory.path());
  StepReport step;
  step.step       = 1;
  step.quantities = {{"area", 1.}};
  files.on_step(step);
  step.step       = 2;
  step.quantities = {{"force", 2.}};
  files.on_step(step);
  step.step       = 3;
  step.quantities = {{"area", 3.}, {"force", 4.}};
  files.on_step(step);
  EXPECT_EQ(content_of(directory.path() / "history.csv"), "step,area,force\n1,1,\n2,,2\n3,3,4\n");
}

TEST(RunFiles, RefusesADirectoryThatCannotBeWritten)
{
  const TemporaryDirectory directory;
  write_whole_file(directory.path() / "file", "");
  EXPECT_USER_ERROR(RunFiles files(directory.path() / "file"), (directory.path() / "file" / "history.csv").string());
}

TEST(OutputDirectory, LosesOldResultsAndNothingElse)
{
  const TemporaryDirectory directory;
  for (const char *name : {"summary.json", "history.csv", "convergence.csv", "accuracy.csv", "solution.pvd",
                           "picture.png", "solution_0000.vtu", "solution_12345.vtu"})
    write_whole_file(directory.path() / name, "old");
  for (const char *name : {"used.prm", "notes.txt", "solution_best.vtu", "solution_.vtu", "my_solution_0001.vtu"})
    write_whole_file(directory.path() / name, "mine");
  prepare_output_directory(directory.path());
  EXPECT_EQ(n_files_in(directory.path()), 5u);
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "solution_best.vtu"));
  prepare_output_directory(directory.path() / "new" / "one");
  EXPECT_EQ(n_files_in(directory.path() / "new" / "one"), 0u);
}
