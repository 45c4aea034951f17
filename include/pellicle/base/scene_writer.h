// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>

namespace pellicle
{
/** Writes the text of a scene: indented subsections, entries, wrapped comments. */
class SceneWriter
{
public:
  /** `line_prefix` stands at the beginning of every line; "# " comments a whole section out. */
  explicit SceneWriter(std::string line_prefix = "")
      : prefix(std::move(line_prefix))
  {
  }

  void comment(const std::string &text);
  void entry(const std::string &name, const std::string &value);
  /** Opens a section; a name "Outer/Inner" opens one inside the other. */
  void open(const std::string &section);
  /** Closes what the last open() opened. Sections are not opened inside each other otherwise. */
  void close();
  /** An empty line, without prefix. */
  void blank();

  const std::string &text() const { return written; }

private:
  void line(const std::string &content);

  std::string prefix;
  std::string written;
  int depth = 0; // of subsections that are open
};
} // namespace pellicle
