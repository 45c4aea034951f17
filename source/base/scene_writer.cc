// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/base/scene_writer.h>
#include <pellicle/base/text.h>

#include <sstream>

namespace pellicle
{
void SceneWriter::line(const std::string &content)
{
  written += trimmed(content).empty() ? "" : prefix + std::string(2 * depth, ' ') + content;
  written += '\n';
}

void SceneWriter::comment(const std::string &text)
{
  constexpr std::size_t width = 110;
  std::istringstream words(text);
  std::string word, comment_line = "#";
  while (words >> word)
  {
    if (comment_line.size() > 1 && prefix.size() + 2 * depth + comment_line.size() + 1 + word.size() > width)
    {
      line(comment_line);
      comment_line = "#";
    }
    comment_line += " " + word;
  }
  line(comment_line);
}

void SceneWriter::entry(const std::string &name, const std::string &value)
{
  PELLICLE_ASSERT(value.find_first_of("#\n") == std::string::npos, "a scene file cannot hold this value");
  line("set " + name + " =" + (value.empty() ? "" : " " + value));
}

void SceneWriter::open(const std::string &section)
{
  PELLICLE_ASSERT(depth == 0, "close() one section before the next open()");
  std::istringstream parts(section);
  for (std::string part; std::getline(parts, part, '/'); ++depth)
    line("subsection " + part);
}

void SceneWriter::close()
{
  while (depth > 0)
  {
    --depth;
    line("end");
  }
}

void SceneWriter::blank()
{
  written += '\n';
}
} // namespace pellicle
