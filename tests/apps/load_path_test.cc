// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with a load path of their own: here a drop that gets its weight first, then a tension of its contact line.
#include "../mpi_environment.h"
#include "../output/temporary_directory.h"

#include <pellicle/apps/surface_run.h>
#include <pellicle/models/droplet_scene.h>
#include <pellicle/output/atomic_file.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;

class StagedDrop : public DropletScene
{
public:
  std::vector<LoadStage> load_stages() const override
  {
    return {{"gravity", "Droplet/Bond number"}, {"line", "Line tension/Line tension"}};
  }
};

class Record : public Observer
{
public:
  void on_step(const StepReport &report) override { steps.push_back(report); }
  void on_row(const TableRow & /*row*/) override { ++n_rows; }
  std::vector<StepReport> steps;
  int n_rows = 0;
};

struct Outcome
{
  RunResult result;
  std::vector<StepReport> steps;
  std::vector<double> times;
  int n_rows = 0;

  double quantity(const std::string &name) const
  {
    for (const auto &[quantity, value] : result.quantities)
      if (quantity == name)
        return value;
    return std::nan("");
  }
};

Outcome run(const bool staged, const std::vector<std::string> &overrides)
{
  const pellicle::testing::TemporaryDirectory directory;
  CommandLine command_line;
  command_line.scene_file = (directory.path() / "drop.prm").string();
  command_line.overrides  = overrides;
  write_whole_file(command_line.scene_file, "subsection Mesh\n  set Symmetry = axial\nend\n"
                                            "subsection Droplet\n  set Bond number = 0.5\nend\n"
                                            "subsection Line tension\n  set Line tension = 0.1\nend\n");
  const SurfaceApplication application{
      "drop",
      "",
      droplet_effects(),
      {"liquid surface", "volume constraint", "wetting", "gravity", "line tension"},
      [staged](const std::vector<std::string> & /*effects*/) -> std::unique_ptr<SurfaceScene>
      {
        if (staged)
          return std::make_unique<StagedDrop>();
        return std::make_unique<DropletScene>();
      }};

  SurfaceSceneFile file(application, command_line);
  std::unique_ptr<SurfaceScene> scene = file.read();
  if (!scene->load.parameter.empty())
    scene = scene_at_start_of_load(file, scene->load);
  const Communicator communicator;
  Timing timing;
  SurfaceModel model(*scene, communicator, timing);
  Record record;
  RunMemory nothing;
  Outcome outcome;
  outcome.result = solve_scene(
      file, *scene, model, record, [&](const SurfaceModel &, int, const double time) { outcome.times.push_back(time); },
      nothing);
  outcome.steps  = record.steps;
  outcome.n_rows = record.n_rows;
  return outcome;
}

using Stepped = std::vector<std::pair<std::string, double>>;

TEST(LoadPath, StagesInTurnAndAllTheWayAtOnce)
{
  const Outcome staged = run(true, {"Load/Steps=1"}), direct = run(false, {});
  ASSERT_EQ(staged.result.status, RunStatus::converged) << staged.result.message;
  ASSERT_EQ(staged.steps.size(), 2u);
  EXPECT_EQ(staged.steps[0].stepped, (Stepped{{"load", 1.}}));
  EXPECT_EQ(staged.steps[1].stepped, (Stepped{{"load", 2.}}));
  EXPECT_EQ(staged.times, (std::vector<double>{1., 2.}));
  EXPECT_EQ(staged.steps[0].fraction_done, 0.5);
  EXPECT_EQ(staged.result.newton.steps, 2);
  for (const char *name : {"total_energy", "pressure", "height"})
    EXPECT_NEAR(staged.quantity(name) / direct.quantity(name), 1., 1e-6) << name;
  EXPECT_TRUE(direct.steps.at(0).stepped.empty());
}

TEST(LoadPath, StepsAndStagesWithoutLoad)
{
  const Outcome outcome = run(true, {"Load/Steps=2", "Line tension/Line tension=0"});
  ASSERT_EQ(outcome.steps.size(), 2u);
  EXPECT_EQ(outcome.times, (std::vector<double>{0.5, 1.}));
  // The state at half of the way is that of half the load.
  const Outcome half = run(false, {"Line tension/Line tension=0", "Droplet/Bond number=0.25"});
  for (const auto &[name, value] : outcome.steps[0].quantities)
    if (name == "height")
    {
      EXPECT_NEAR(value / half.quantity("height"), 1., 1e-6);
    }
  // Nothing to load: one solve.
  const Outcome none = run(true, {"Line tension/Line tension=0", "Droplet/Bond number=0"});
  EXPECT_EQ(none.result.status, RunStatus::converged);
  EXPECT_EQ(none.steps.size(), 1u);
}

TEST(LoadPath, ThenAParameterFromItsStart)
{
  const Outcome outcome =
      run(true, {"Load/Steps=2", "Load/Parameter=Droplet/Contact angle", "Load/From=80", "Load/To=100"});
  ASSERT_EQ(outcome.result.status, RunStatus::converged) << outcome.result.message;
  ASSERT_EQ(outcome.steps.size(), 6u);
  const std::string angle = "Droplet/Contact angle";
  EXPECT_EQ(outcome.steps[0].stepped, (Stepped{{"load", 0.5}, {angle, 80.}}));
  EXPECT_EQ(outcome.steps[3].stepped, (Stepped{{"load", 2.}, {angle, 80.}}));
  EXPECT_EQ(outcome.steps[4].stepped, (Stepped{{"load", 2.}, {angle, 90.}}));
  EXPECT_EQ(outcome.steps[5].stepped, (Stepped{{"load", 2.}, {angle, 100.}}));
  const Outcome direct = run(false, {"Droplet/Contact angle=100"});
  EXPECT_NEAR(outcome.quantity("total_energy") / direct.quantity("total_energy"), 1., 1e-6);
}

// A drop of this volume hangs up to some weight: there the branch turns back.
TEST(LoadPath, FoldStopsItAndIsNamed)
{
  const Outcome outcome = run(true, {"Load/Steps=1", "Load/Smallest step=0.01", "Droplet/Bond number=-3"});
  EXPECT_EQ(outcome.result.status, RunStatus::failed);
  ASSERT_FALSE(outcome.steps.empty());
  const double reached       = outcome.steps.back().stepped.at(0).second;
  const std::string &message = outcome.result.message;
  for (const char *part : {"Load stepping stopped at gravity = 0.", "(Droplet/Bond number = -", "on the way to -3",
                           "The load path folds at Droplet/Bond number = -",
                           "Continuation/Parameter = Droplet/Bond number with Direction = decreasing"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
  const double fold = std::stod(message.substr(message.find("folds at Droplet/Bond number = ") + 31));
  EXPECT_LT(fold, -3. * reached);
  EXPECT_NEAR(fold, -3. * reached, 0.06);
}

TEST(LoadPath, ContinuationTakesOverAtAFold)
{
  const Outcome outcome = run(true, {"Load/Steps=1", "Load/Smallest step=0.01", "Droplet/Bond number=-3",
                                     "Continuation/Parameter=Droplet/Bond number", "Continuation/Direction=decreasing",
                                     "Continuation/Maximum points=6"});
  EXPECT_EQ(outcome.result.status, RunStatus::converged) << outcome.result.message;
  EXPECT_EQ(outcome.n_rows, 6);
  ASSERT_EQ(outcome.result.warnings.size(), 1u);
  EXPECT_NE(outcome.result.warnings[0].find("followed from there by arc length"), std::string::npos);
}

TEST(LoadPath, FailureWithoutAnEquilibrium)
{
  const Outcome outcome =
      run(true, {"Load/Steps=1", "Load/Smallest step=0.6", "Newton/Maximum iterations=1", "Droplet/Bond number=1"});
  EXPECT_EQ(outcome.result.status, RunStatus::failed);
  EXPECT_NE(
      outcome.result.message.find("Load stepping stopped at gravity = 0 (Droplet/Bond number = 0 on the way to 1)"),
      std::string::npos)
      << outcome.result.message;
  EXPECT_EQ(outcome.times.size(), 1u); // where the iteration ended
}
} // namespace
