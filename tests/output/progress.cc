// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/progress.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace pellicle;

namespace
{
StepReport half_way()
{
  StepReport report;
  report.step          = 3;
  report.fraction_done = 0.25;
  report.stepped       = {{"Vesicle/Reduced volume", 0.9}};
  report.iterations    = 5;
  return report;
}

IterationReport an_iteration()
{
  IterationReport report;
  report.step              = 4;
  report.iteration         = 2;
  report.relative_residual = 1.23e-5;
  report.step_length       = 0.5;
  report.energy            = 25.;
  return report;
}

/** What a run of one step, one more iteration and a message prints when 10 s have gone by. */
std::string printed(const Verbosity verbosity, const bool in_terminal)
{
  std::ostringstream out;
  double now = 100.;
  {
    Progress progress(out, verbosity, in_terminal, [&now] { return now; });
    now += 10.;
    progress.on_step(half_way());
    progress.on_iteration(an_iteration());
    progress.on_message("picture.png written");
  }
  return out.str();
}
} // namespace

TEST(Progress, DurationsForPeople)
{
  EXPECT_EQ(duration_text(0.44), "0.4 s");
  EXPECT_EQ(duration_text(9.99), "10 s");
  EXPECT_EQ(duration_text(59.6), "1 min 0 s");
  EXPECT_EQ(duration_text(200.), "3 min 20 s");
  EXPECT_EQ(duration_text(7500.), "2 h 5 min");
  EXPECT_EQ(duration_text(1e300), "long");
}

TEST(Progress, QuietSaysNothing)
{
  EXPECT_EQ(printed(Verbosity::quiet, true), "");
  EXPECT_EQ(printed(Verbosity::quiet, false), "");
}

TEST(Progress, PlainLinesInAFile)
{
  EXPECT_EQ(printed(Verbosity::normal, false),
            "step 3: Vesicle/Reduced volume = 0.9, 5 iterations, 10 s\npicture.png written\n");
}

TEST(Progress, RewrittenLineAndTimeLeftInATerminal)
{
  const std::string work = "step 4, iteration 2, relative residual 1.2e-05, 10 s, about 30 s left";
  EXPECT_EQ(printed(Verbosity::normal, true),
            "step 3: Vesicle/Reduced volume = 0.9, 5 iterations, 10 s, about 30 s left\n\r" + work + "\r" +
                std::string(work.size(), ' ') + "\rpicture.png written\n");
}

TEST(Progress, VerboseHasALineAnIteration)
{
  const std::string text = printed(Verbosity::verbose, false);
  EXPECT_NE(text.find("  iteration   2  relative residual 1.230e-05  step length 5.000e-01  energy 25  rejected 0\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(Progress, LeavesTheCursorOnAFreshLine)
{
  std::ostringstream out;
  {
    Progress progress(out, Verbosity::normal, true);
    progress.on_iteration(an_iteration());
    progress.on_iteration(an_iteration());
  }
  EXPECT_EQ(out.str().back(), '\n');
  EXPECT_EQ(out.str().front(), '\r');
}
