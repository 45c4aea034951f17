// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace pellicle
{
/** One `set Name = value`. */
struct SceneEntry
{
  std::string section; ///< empty at top level; "Outer/Inner" for nested subsections
  std::string name;
  std::string value;
  std::string origin; ///< for messages: `scene.prm:12` or `--set "Mesh/Degree=4"`

  /** "Section/Name", or "Name" at top level. */
  std::string path() const { return section.empty() ? name : section + "/" + name; }
};

/** One `subsection`, also one without entries. */
struct SceneSection
{
  std::string name;
  std::string origin;
};

/** What a scene file and the command line say, before anybody asks whether it makes sense. */
struct SceneEntries
{
  std::vector<SceneEntry> entries;    ///< every path once
  std::vector<SceneSection> sections; ///< in the order of the file
};

/** Splits "Section/Name" at its last slash. Value and origin stay empty. Throws UserError for a path without a name. */
SceneEntry split_path(const std::string &path);

/**
 * Scans text in the syntax of deal.II's ParameterHandler: `set Name = value`, `subsection Name` ... `end` (may be
 * nested),
 * `#` starts a comment, a backslash at the end of a line joins it with the next. `file` stands in the origins.
 * Throws UserError, with file and line, for any other line, unbalanced subsections and entries that are set twice.
 */
SceneEntries scan_scene(const std::string &text, const std::string &file);

/** scan_scene() of a file. Throws UserError when it is missing or cannot be read. */
SceneEntries read_scene_file(const std::string &file);

/**
 * Sets entries from `--set` arguments "Section/Name=value"; a path without slash is a top-level entry. The last of
 * several overrides of one path counts. Throws UserError for an argument of another form and for a value that no scene
 * file can hold.
 */
void apply_overrides(SceneEntries &scene, const std::vector<std::string> &overrides);

/** Sets one entry, replacing an earlier one of the same path. Throws UserError for a value that no scene file can hold.
 */
void set_entry(SceneEntries &scene, const std::string &path, const std::string &value, const std::string &origin);
} // namespace pellicle
