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
} // namespace

std::optional<std::filesystem::path> find_render_script()
{
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed =
      program.parent_path().parent_path() / "share/pellicle/render/render_surface.py";
  for (const std::filesystem::path &script : {installed, std::filesystem::path(PELLICLE_RENDER_SCRIPT)})
    if (std::filesystem::is_regular_file(script, error))
      return script;
  return {};
}

std::optional<std::string> render_picture(const std::filesystem::path &vtu, const std::filesystem::path &beside,
                                          const std::filesystem::path &png, const std::string &title)
{
  const auto script = find_render_script();
  if (!script)
    return "No picture: render_surface.py is not installed.";
  if (!is_executable(virtual_display))
    return "No picture: " + std::string(virtual_display) + " is missing (on Debian: apt-get install xvfb xauth).";
  if (!is_executable(interpreter))
    return "No picture: " + std::string(interpreter) + " is missing (on Debian: apt-get install python3-vtk9).";

  std::vector<std::string> command{virtual_display, "-a",         interpreter,       script->string(),
                                   vtu.string(),    png.string(), "--title=" + title};
  if (!beside.empty())
    command.push_back("--beside=" + beside.string());
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
} // namespace pellicle
