// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/command_line.h>
#include <pellicle/base/near_match.h>
#include <pellicle/base/version.h>

#include <CLI/CLI.hpp>

namespace pellicle
{
namespace
{
CommandLineExit refusal(const std::string &application, const std::string &reason)
{
  return {2, application + ": " + reason + "\nRun '" + application + " --help' for the options.\n"};
}

/** Message for the first argument that belongs to no option. */
std::string leftover_message(const CLI::App &app, const std::string &argument)
{
  if (argument[0] != '-')
    return "unexpected argument '" + argument + "': one scene file is read at a time";
  std::vector<std::string> options;
  for (const CLI::Option *option : app.get_options())
    if (!option->get_lnames().empty())
      options.push_back("--" + option->get_lnames().front());
  return "unknown option '" + argument + "'." + suggestion(argument.substr(0, argument.find('=')), options);
}
} // namespace

std::variant<CommandLine, CommandLineExit> parse_command_line(const int argc, const char *const *argv,
                                                              const std::string &application,
                                                              const std::string &description)
{
  CommandLine options;
  bool quiet = false, verbose = false;

  CLI::App app(description, application);
  app.allow_extras();
  app.set_help_flag("-h,--help", "Print this text and exit");
  app.set_version_flag("--version", application + " (Pellicle) " + version());
  app.add_option("scene", options.scene_file, "Scene file (.prm)");
  app.add_option(
         "--write-parameters", options.write_parameters_file,
         "Write a commented scene with every parameter and its default to FILE and exit; the effects listed are those "
         "of the scene, if one is given")
      ->type_name("FILE");
  app.add_flag("--validate", options.validate,
               "Read the scene, build the mesh and the list of effects, report, do not solve");
  app.add_option("--set", options.overrides, "Override one parameter; may be repeated")
      ->type_name("\"Section/Name=value\"")
      ->allow_extra_args(false);
  app.add_option("--output-directory", options.output_directory, "Where the run writes; created if missing")
      ->type_name("DIR");
  CLI::Option *const restart =
      app.add_option("--restart", options.restart_directory,
                     "Continue from the last checkpoint in DIR, the output directory of a run with Checkpoint/Every > "
                     "0; its scene need not be given again")
          ->type_name("DIR");
  CLI::Option *const quiet_flag = app.add_flag("--quiet", quiet, "Print nothing but errors");
  app.add_flag("--verbose", verbose, "Print every iteration")->excludes(quiet_flag);

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp &)
  {
    return CommandLineExit{0, app.help()};
  }
  catch (const CLI::CallForVersion &call)
  {
    return CommandLineExit{0, std::string(call.what()) + "\n"};
  }
  catch (const CLI::ParseError &error)
  {
    return refusal(application, error.what());
  }

  if (!app.remaining().empty())
    return refusal(application, leftover_message(app, app.remaining().front()));
  if (*restart && (options.validate || !options.write_parameters_file.empty()))
    return refusal(application, "--restart goes on with a run; leave out --validate and --write-parameters");
  if (*restart && options.restart_directory.empty())
    return refusal(application, "--restart '': give the output directory of the run that is to go on");
  if (options.scene_file.empty() && options.write_parameters_file.empty() && !*restart)
    return CommandLineExit{2, app.help()};
  if (options.scene_file.empty() && options.validate)
    return refusal(application, "--validate needs a scene file");
  options.verbosity = quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  return options;
}
} // namespace pellicle
