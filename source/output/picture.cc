// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/picture.h>
#include <pellicle/output/program.h>

#include <unistd.h>

#include <system_error>
#include <vector>

namespace pellicle
{
namespace
{
constexpr const char *virtual_display = "/usr/bin/xvfb-run";
constexpr const char *interpreter     = "/usr/bin/python3";
constexpr double render_timeout       = 60.; // seconds; a picture takes one or two

bool is_executable(const char *program)
{
  return ::access(program, X_OK) == 0;
}

std::string last_line(const std::string &text)
{
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos)
    return "";
  const std::size_t start = text.find_last_of('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? 0 : start + 1) + 1);
}

/** The script, with the paths and options that follow; why there is no picture, if there is none. */
std::optional<std::string> run_renderer(const std::string &script_name, const std::filesystem::path &png,
                                        const std::vector<std::string> &arguments)
{
  const auto script = find_render_script(script_name);
  if (!script)
    return "No picture: " + script_name + " is not installed.";
  if (!is_executable(virtual_display))
    return "No picture: " + std::string(virtual_display) + " is missing (on Debian: apt-get install xvfb xauth).";
  if (!is_executable(interpreter))
    return "No picture: " + std::string(interpreter) + " is missing (on Debian: apt-get install python3-vtk9).";

  // -B: the folder of the scripts is not written to.
  std::vector<std::string> command{virtual_display, "-a", interpreter, "-B", script->string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const ProgramEnd end = run_program(command, render_timeout);
  if (!end.started)
    return "No picture: the renderer could not be started.";
  if (end.timed_out)
    return "No picture: the renderer needed more than " + std::to_string(int(render_timeout)) + " s and was stopped.";
  if (end.exit_status != 0)
    return "No picture: " + (last_line(end.output).empty() ? "the renderer failed." : last_line(end.output));
  std::error_code error;
  if (!std::filesystem::is_regular_file(png, error))
    return "No picture: the renderer wrote none.";
  return {};
}
} // namespace

std::optional<std::filesystem::path> find_render_script(const std::string &name)
{
  std::error_code error;
  const std::filesystem::path program   = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed = program.parent_path().parent_path() / "share/pellicle/render";
  for (const std::filesystem::path &folder : {installed, std::filesystem::path(PELLICLE_RENDER_FOLDER)})
    if (std::filesystem::is_regular_file(folder / name, error))
      return folder / name;
  return {};
}

std::optional<std::string> render_picture(const std::filesystem::path &vtu, const std::filesystem::path &beside,
                                          const std::filesystem::path &png, const std::string &title)
{
  std::vector<std::string> arguments{vtu.string(), png.string(), "--title=" + title};
  if (!beside.empty())
    arguments.push_back("--beside=" + beside.string());
  return run_renderer("render_surface.py", png, arguments);
}

std::optional<std::string> render_section(const std::filesystem::path &vtu, const std::filesystem::path &body,
                                          const std::filesystem::path &png, const std::string &title)
{
  return run_renderer("render_section.py", png, {vtu.string(), body.string(), png.string(), "--title=" + title});
}
} // namespace pellicle
