// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/parameter_text.h>
#include <pellicle/base/scene_text.h>
#include <pellicle/base/scene_writer.h>
#include <pellicle/base/text.h>

namespace pellicle
{
namespace
{
using Entry = ParameterSection::Entry;

/** "length^2"; empty for what is no number or has no dimension. */
std::string unit(const Entry &entry)
{
  const bool is_real =
      std::holds_alternative<double *>(entry.target) || std::holds_alternative<std::vector<double> *>(entry.target);
  const std::string dimension = entry.dimension.text();
  return !is_real || dimension == "1" ? "" : dimension;
}

void write_section(SceneWriter &writer, const ParameterSection &section)
{
  writer.open(section.name());
  for (const Entry &entry : section.entries())
  {
    if (&entry != &section.entries().front())
      writer.blank();
    const std::string entry_unit = unit(entry);
    writer.comment(entry.text);
    writer.comment("Allowed: " + allowed_text(entry) + "." + (entry_unit.empty() ? "" : " Unit: " + entry_unit + "."));
    writer.entry(entry.name, value_text(entry));
  }
  writer.close();
}

void write_list(SceneWriter &writer, const std::string &name, const std::vector<std::string> &listed,
                const std::vector<std::string> &known)
{
  writer.comment(known.empty() ? "There are none." : "Known: " + joined(known, ", ") + ".");
  writer.entry(name, joined(listed, ", "));
}

/** Text inside a cell of a Markdown table. */
std::string cell(const std::string &text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string section_chapter(const ParameterSection &section, const std::string &remark)
{
  std::string text = "\n## " + section.name() + "\n\n" + remark;
  text += "| parameter | default | allowed | unit | meaning |\n|---|---|---|---|---|\n";
  for (const Entry &entry : section.entries())
  {
    const std::string value = value_text(entry);
    text += "| `" + entry.name + "` | " + (value.empty() ? "(empty)" : "`" + cell(value) + "`") + " | " +
            cell(allowed_text(entry)) + " | " + unit(entry) + " | " + cell(entry.text) + " |\n";
  }
  return text;
}
} // namespace

std::string commented_scene(const SceneDescription &description)
{
  SceneWriter writer;
  writer.comment("Scene of the application " + description.application + ": every parameter, with its default.");
  writer.comment("");
  writer.comment(
      "Any consistent units will do. Numbers may be expressions (4*pi, 2*pi/3, sqrt(2)), or inf where that is "
      "allowed. A backslash at the end of a line continues it.");
  writer.comment(
      "Only effects and analyses that are listed are built. The sections of all other effects are commented out "
      "below: to use one, list the effect and remove the first '# ' of every line of its section.");
  writer.blank();
  write_list(writer, "Effects", description.effects, description.known_effects);
  writer.blank();
  write_list(writer, "Analyses", description.analyses, description.known_analyses);
  for (const ParameterSection &section : description.sections)
    if (!section.entries().empty())
    {
      writer.blank();
      write_section(writer, section);
    }
  std::string text = writer.text();
  for (const UnlistedSection &unlisted : description.unlisted)
    if (!unlisted.section.entries().empty())
    {
      SceneWriter commented_out("# ");
      write_section(commented_out, unlisted.section);
      text += "\n# The effect '" + unlisted.effect + "' is not listed.\n" + commented_out.text();
    }
  return text;
}

std::string parameter_chapter(const SceneDescription &description)
{
  std::string text = "# Parameters of `" + description.application + "`\n";
  for (const ParameterSection &section : description.sections)
    if (!section.entries().empty())
      text += section_chapter(section, "");
  for (const UnlistedSection &unlisted : description.unlisted)
    if (!unlisted.section.entries().empty())
      text += section_chapter(unlisted.section, "Only when the effect `" + unlisted.effect +
                                                    "` is listed, which it is not by default.\n\n");
  return text;
}
} // namespace pellicle
