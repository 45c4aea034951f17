// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/base/scene_file.h>
#include <pellicle/base/text.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

namespace pellicle
{
namespace
{
/** Reads logical lines (continuations joined) and keeps track of the subsections that are open. */
class Scanner
{
public:
  explicit Scanner(std::string file)
      : file_name(std::move(file))
  {
  }

  SceneEntries scan(const std::string &text)
  {
    if (text.find('\0') != std::string::npos)
      fail(file_name, "this is no scene: a scene is text, and this file holds zero bytes");
    std::istringstream lines(text);
    std::string physical, logical;
    for (int number = 1; std::getline(lines, physical); ++number)
    {
      if (logical.empty())
        line_number = number;
      logical += trimmed(physical);
      if (!logical.empty() && logical.back() == '\\')
        logical.pop_back();
      else
        scan_line(std::exchange(logical, ""));
    }
    scan_line(logical);
    if (!open.empty())
      fail(open.back().origin, "subsection '" + open.back().name + "' is never closed: an 'end' is missing");
    return std::move(scene);
  }

private:
  [[noreturn]] static void fail(const std::string &origin, const std::string &what)
  {
    throw UserError(origin + ": " + what);
  }

  std::string here() const { return file_name + ":" + std::to_string(line_number); }

  void scan_line(const std::string &raw)
  {
    const std::string line = trimmed(raw.substr(0, raw.find('#')));
    if (line.empty())
      return;
    const std::size_t word_end = std::min(line.find_first_of(" \t"), line.size());
    const std::string keyword = lower_case(line.substr(0, word_end)), rest = trimmed(line.substr(word_end));
    if (keyword == "set")
      scan_entry(line, rest);
    else if (keyword == "subsection" && !rest.empty() && rest.find('/') == std::string::npos)
    {
      check_name(rest);
      if (open.size() == deepest)
        fail(here(), "subsections are nested more than " + std::to_string(deepest) +
                         " deep: an 'end' is missing above, or this is no scene");
      open.push_back({open.empty() ? rest : open.back().name + "/" + rest, here()});
      scene.sections.push_back(open.back());
    }
    else if (keyword == "end" && rest.empty())
    {
      if (open.empty())
        fail(here(), "'end' without an open subsection");
      open.pop_back();
    }
    else
      malformed(line);
  }

  void scan_entry(const std::string &line, const std::string &assignment)
  {
    const std::size_t equals = assignment.find('=');
    const std::string name   = trimmed(assignment.substr(0, equals));
    if (equals == std::string::npos || name.empty() || name.find('/') != std::string::npos)
      malformed(line);
    check_name(name);
    SceneEntry entry{open.empty() ? "" : open.back().name, name, trimmed(assignment.substr(equals + 1)), here()};
    const auto [other, is_new] = origins.emplace(entry.path(), entry.origin);
    if (!is_new)
      fail(here(), "'" + entry.path() + "' is set twice: before at " + other->second + ". Remove one of the two lines");
    scene.entries.push_back(std::move(entry));
  }

  void check_name(const std::string &name) const
  {
    if (name.size() > longest_name)
      fail(here(), "'" + excerpt(name) + "' is no name: no section and no parameter has a name of more than " +
                       std::to_string(longest_name) + " characters");
  }

  [[noreturn]] void malformed(const std::string &line) const
  {
    fail(here(),
         "cannot understand '" + excerpt(line) +
             "': a line is 'set Name = value', 'subsection Name', 'end', a comment after '#' or empty; names hold "
             "no '/'");
  }

  static constexpr std::size_t deepest = 8, longest_name = 200;

  std::string file_name;
  int line_number = 1;                        // where the logical line begins
  std::vector<SceneSection> open;             // innermost last, with its full name
  std::map<std::string, std::string> origins; // of the entries by path
  SceneEntries scene;
};
} // namespace

SceneEntry split_path(const std::string &path)
{
  const std::size_t slash = path.rfind('/');
  SceneEntry entry;
  if (slash != std::string::npos)
    entry.section = trimmed(path.substr(0, slash));
  entry.name = trimmed(slash == std::string::npos ? path : path.substr(slash + 1));
  if (entry.name.empty() || (slash != std::string::npos && entry.section.empty()))
    throw UserError("'" + path + "' names no parameter: expected 'Section/Name', or 'Name' at top level");
  return entry;
}

SceneEntries scan_scene(const std::string &text, const std::string &file)
{
  return Scanner(file).scan(text);
}

SceneEntries read_scene_file(const std::string &file)
{
  std::error_code no_directory;
  if (std::filesystem::is_directory(file, no_directory))
    throw UserError("'" + file + "' is a directory: expected a scene file");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open())
    throw UserError("cannot open the scene file '" + file + "': " + std::strerror(errno));
  constexpr std::size_t longest = 4000000; // devices and pipes may have no end
  std::string text(longest + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad())
    throw UserError("cannot read the scene file '" + file + "'");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > longest)
    throw UserError("'" + file + "' is no scene file: it has more than " + std::to_string(longest) + " characters");
  return scan_scene(text, file);
}

void set_entry(SceneEntries &scene, const std::string &path, const std::string &value, const std::string &origin)
{
  SceneEntry entry = split_path(path);
  entry.value      = trimmed(value);
  entry.origin     = origin;
  if (entry.value.find_first_of("#\n\r") != std::string::npos || (!entry.value.empty() && entry.value.back() == '\\'))
    throw UserError(origin +
                    ": a value cannot hold '#' or a line break nor end with a backslash, because no scene file "
                    "could hold it");

  const auto same_path = [&](const SceneEntry &other) { return other.path() == entry.path(); };
  const auto earlier   = std::find_if(scene.entries.begin(), scene.entries.end(), same_path);
  if (earlier == scene.entries.end())
    scene.entries.push_back(std::move(entry));
  else
    *earlier = std::move(entry);
}

void apply_overrides(SceneEntries &scene, const std::vector<std::string> &overrides)
{
  for (const std::string &argument : overrides)
  {
    const std::string origin = "--set \"" + argument + "\"";
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos || trimmed(argument.substr(0, equals)).empty())
      throw UserError(origin + ": expected --set \"Section/Name=value\", or \"Name=value\" for a top-level parameter");
    set_entry(scene, trimmed(argument.substr(0, equals)), argument.substr(equals + 1), origin);
  }
}
} // namespace pellicle
