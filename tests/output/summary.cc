// SPDX-License-Identifier: LGPL-2.1-or-later
#include "temporary_directory.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/version.h>
#include <pellicle/output/summary.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

using namespace pellicle;
using Json = nlohmann::ordered_json;

namespace
{
RunResult example()
{
  RunResult result;
  result.application     = "vesicle";
  result.status          = RunStatus::converged;
  result.effects         = {"helfrich bending", "area constraint"};
  result.analyses        = {"stability"};
  result.n_cells         = 384;
  result.degree          = 3;
  result.unknowns.total  = 10375;
  result.unknowns.blocks = {{"position", 3458}, {"moment", 10374 - 3458}, {"tension", 1}};
  result.newton          = {4, 17, 2, 1e-12};
  result.seconds         = {3.25, 1., 1.75, 0.25};
  result.stability       = StabilityCounts{1, {-0.5, 0.1}};
  result.quantities      = {{"area", 4 * pi}, {"volume", 0.1}};
  return result;
}
} // namespace

TEST(Summary, HoldsWhatTheContractSays)
{
  const Json summary  = Json::parse(summary_text(example()));
  const Json expected = {
      {"application", "vesicle"},
      {"version", version()},
      {"status", "converged"},
      {"effects", {"helfrich bending", "area constraint"}},
      {"analyses", Json::array({"stability"})},
      {"warnings", Json::array()},
      {"mesh", {{"cells", 384}, {"degree", 3}}},
      {"unknowns", {{"total", 10375}, {"position", 3458}, {"moment", 6916}, {"tension", 1}}},
      {"newton", {{"steps", 4}, {"iterations", 17}, {"rejected", 2}, {"final_relative_residual", 1e-12}}},
      {"seconds", {{"total", 3.25}, {"assembly", 1.}, {"linear_solve", 1.75}, {"output", 0.25}}},
      {"stability", {{"negative_eigenvalues", 1}, {"lowest", {-0.5, 0.1}}}},
      {"quantities", {{"area", 4 * pi}, {"volume", 0.1}}}};
  // Compared as text: order counts, and numbers read back to the last bit.
  EXPECT_EQ(summary.dump(2), expected.dump(2));
}

TEST(Summary, ListsLoopsAndMatrix)
{
  RunResult result               = example();
  result.unknowns.matrix_entries = 4711;
  result.loops                   = {{"surface",
                                     384,
                                     6144,
                                     {{LoopTerm::Kind::energy, "helfrich bending", "domain", {"position", "moment"}},
                                      {LoopTerm::Kind::constraint, "area constraint", "", {"position"}}}},
                                    {"edge rim", 32, 128, {{LoopTerm::Kind::dissipation, "friction", "", {"position"}}}}};
  const Json summary             = Json::parse(summary_text(result));
  EXPECT_EQ(summary["matrix"]["entries"], 4711);
  const Json expected = Json::parse(R"([
    {"over": "surface", "cells": 384, "points": 6144, "terms": [
      {"name": "helfrich bending", "kind": "energy", "fields": ["position", "moment"], "region": "domain"},
      {"name": "area constraint", "kind": "constraint", "fields": ["position"]}]},
    {"over": "edge rim", "cells": 32, "points": 128, "terms": [
      {"name": "friction", "kind": "dissipation", "fields": ["position"]}]}])");
  EXPECT_EQ(summary["loops"].dump(2), expected.dump(2));
}

TEST(Summary, HoldsTheConditioningThatWasAskedFor)
{
  RunResult result     = example();
  result.linear_solver = LinearSolverReport{"mumps", {1e6, 0.25, 4.}, 3};
  const Json summary   = Json::parse(summary_text(result));
  const Json expected  = {{"name", "mumps"},
                          {"condition_estimate", 1e6},
                          {"smallest_pivot", 0.25},
                          {"largest_pivot", 4.},
                          {"negative_pivots", 3}};
  EXPECT_EQ(summary["linear_solver"].dump(), expected.dump());
}

TEST(Summary, NamesStatusAndMessage)
{
  RunResult result = example();
  result.message   = "The tension of \"\xce\xb3\" ...";
  for (const auto &[status, name] : {std::pair{RunStatus::failed, "failed"}, std::pair{RunStatus::refused, "refused"},
                                     std::pair{RunStatus::target_not_met, "target_not_met"}})
  {
    result.status      = status;
    const Json summary = Json::parse(summary_text(result));
    EXPECT_EQ(summary["status"], name);
    EXPECT_EQ(summary["message"], result.message);
  }
}

TEST(Summary, LeavesOutAndNamesWhatIsNotFinite)
{
  RunResult result                      = example();
  result.warnings                       = {"the mesh is coarse"};
  result.newton.final_relative_residual = std::nan("");
  result.stability->lowest              = {-std::numeric_limits<double>::infinity(), 2.};
  result.quantities = {{"area", 1.}, {"pressure", std::numeric_limits<double>::infinity()}, {"force", std::nan("")}};

  const std::string text = summary_text(result);
  const Json summary     = Json::parse(text); // nan or inf would not parse
  EXPECT_EQ(text.find("null"), std::string::npos) << text;
  EXPECT_EQ(summary["quantities"].dump(), "{\"area\":1.0}");
  EXPECT_EQ(summary["stability"]["lowest"].dump(), "[2.0]");
  EXPECT_FALSE(summary["newton"].contains("final_relative_residual"));

  const auto warnings = summary["warnings"].get<std::vector<std::string>>();
  ASSERT_EQ(warnings.size(), 5u);
  EXPECT_EQ(warnings[0], "the mesh is coarse");
  EXPECT_EQ(warnings[1], "'newton/final_relative_residual' is not finite (nan) and was left out");
  EXPECT_EQ(warnings[2], "'stability/lowest' is not finite (-inf) and was left out");
  EXPECT_EQ(warnings[3], "'pressure' is not finite (inf) and was left out");
  EXPECT_EQ(warnings[4], "'force' is not finite (nan) and was left out");
}

TEST(Summary, OfARunThatNeverStarted)
{
  RunResult result;
  result.application = "vesicle";
  const Json summary = Json::parse(summary_text(result));
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["warnings"].size(), 0u) << summary.dump();
  EXPECT_FALSE(summary.contains("stability"));
  EXPECT_TRUE(summary["quantities"].is_object());
  EXPECT_TRUE(summary["effects"].is_array());
}

TEST(Summary, IsUtf8WhateverTheNames)
{
  RunResult result   = example();
  result.message     = "file \xff\xfe.msh cannot be read";
  const Json summary = Json::parse(summary_text(result));
  EXPECT_NE(summary["message"].get<std::string>().find("\xef\xbf\xbd"), std::string::npos);
}

TEST(Summary, IsWrittenWhole)
{
  const pellicle::testing::TemporaryDirectory directory;
  write_summary(directory.path(), example());
  EXPECT_EQ(pellicle::testing::content_of(directory.path() / "summary.json"), summary_text(example()));
  EXPECT_EQ(pellicle::testing::n_files_in(directory.path()), 1u);
}
