// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/command_line.h>
#include <pellicle/base/version.h>

#include <gtest/gtest.h>

using namespace pellicle;

namespace
{
std::variant<CommandLine, CommandLineExit> parse(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), "vesicle");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data(), "vesicle", "Shapes of vesicles.");
}

CommandLine accepted(const std::vector<const char *> &arguments)
{
  const auto result = parse(arguments);
  if (const CommandLineExit *const ended = std::get_if<CommandLineExit>(&result))
  {
    ADD_FAILURE() << ended->text;
    return {};
  }
  return std::get<CommandLine>(result);
}

void expect_exit(const std::vector<const char *> &arguments, const int status, const std::vector<std::string> &parts)
{
  const auto result                  = parse(arguments);
  const CommandLineExit *const ended = std::get_if<CommandLineExit>(&result);
  ASSERT_NE(ended, nullptr) << parts.front();
  EXPECT_EQ(ended->status, status);
  EXPECT_EQ(ended->text.back(), '\n');
  for (const std::string &part : parts)
    EXPECT_NE(ended->text.find(part), std::string::npos) << "'" << part << "' is missing in: " << ended->text;
}
} // namespace

TEST(CommandLine, SceneAlone)
{
  const CommandLine options = accepted({"scene.prm"});
  EXPECT_EQ(options.scene_file, "scene.prm");
  EXPECT_FALSE(options.validate);
  EXPECT_TRUE(options.overrides.empty());
  EXPECT_TRUE(options.output_directory.empty());
  EXPECT_TRUE(options.write_parameters_file.empty());
  EXPECT_EQ(options.verbosity, Verbosity::normal);
}

TEST(CommandLine, EveryOption)
{
  const CommandLine options =
      accepted({"--set", "Vesicle/Area=4*pi", "scene.prm", "--set=Mesh/Degree=4", "--validate", "--output-directory",
                "out", "--verbose", "--write-parameters", "p.prm", "--set", "Load/Values=[1, -2]"});
  EXPECT_EQ(options.scene_file, "scene.prm");
  EXPECT_EQ(options.overrides, (std::vector<std::string>{"Vesicle/Area=4*pi", "Mesh/Degree=4", "Load/Values=[1, -2]"}));
  EXPECT_TRUE(options.validate);
  EXPECT_EQ(options.output_directory, "out");
  EXPECT_EQ(options.write_parameters_file, "p.prm");
  EXPECT_EQ(options.verbosity, Verbosity::verbose);
  EXPECT_EQ(accepted({"--quiet", "scene.prm"}).verbosity, Verbosity::quiet);
}

TEST(CommandLine, HelpAndVersionEndWithStatusZero)
{
  expect_exit({"--help"}, 0,
              {"Shapes of vesicles.", "--help", "--version", "--write-parameters FILE", "--validate",
               "--set \"Section/Name=value\"", "--output-directory DIR", "--restart DIR", "--quiet", "--verbose"});
  expect_exit({"--version"}, 0, {"vesicle", version()});
  expect_exit({"--bad-option", "--help"}, 0, {"--write-parameters"});
}

TEST(CommandLine, WithoutSceneHelpAndStatusTwo)
{
  expect_exit({}, 2, {"Shapes of vesicles.", "--write-parameters"});
  expect_exit({"--quiet"}, 2, {"--write-parameters"});
}

TEST(CommandLine, ParametersAreWrittenWithoutAScene)
{
  EXPECT_EQ(accepted({"--write-parameters", "p.prm"}).write_parameters_file, "p.prm");
  expect_exit({"--write-parameters", "p.prm", "--validate"}, 2, {"--validate needs a scene file"});
}

TEST(CommandLine, MistakesEndWithStatusTwo)
{
  expect_exit({"scene.prm", "--valdate"}, 2,
              {"vesicle: unknown option '--valdate'", "Did you mean '--validate'?", "--help"});
  expect_exit({"--output-dir=x", "scene.prm"}, 2, {"unknown option '--output-dir=x'", "'--output-directory'"});
  expect_exit({"a.prm", "b.prm"}, 2, {"'b.prm'", "one scene file"});
  expect_exit({"scene.prm", "--output-directory"}, 2, {"--output-directory"});
  expect_exit({"scene.prm", "--set"}, 2, {"--set"});
  expect_exit({"scene.prm", "--quiet", "--verbose"}, 2, {"--quiet", "--verbose"});
}

TEST(CommandLine, RestartNeedsNoScene)
{
  const CommandLine alone = accepted({"--restart", "out"});
  EXPECT_EQ(alone.restart_directory, "out");
  EXPECT_EQ(alone.scene_file, "");
  EXPECT_EQ(accepted({"scene.prm", "--restart", "out"}).scene_file, "scene.prm");
  expect_exit({"--restart", "out", "--validate"}, 2, {"--restart", "leave out --validate"});
  expect_exit({"--restart", ""}, 2, {"--restart ''", "output directory"});
}
