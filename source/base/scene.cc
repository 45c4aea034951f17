// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/near_match.h>
#include <pellicle/base/parameter_text.h>
#include <pellicle/base/scene.h>
#include <pellicle/base/scene_writer.h>
#include <pellicle/base/text.h>
#include <pellicle/base/version.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace pellicle
{
namespace
{
const char *const effects_entry  = "Effects";
const char *const analyses_entry = "Analyses";

using Sections = std::vector<ParameterSection>;

bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** The section of an effect is its name with a capital first letter. */
std::string effect_of_section(std::string section)
{
  section[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(section[0])));
  return section;
}

bool is_list(const SceneEntry &entry)
{
  return entry.section.empty() && (entry.name == effects_entry || entry.name == analyses_entry);
}

/** Throws UserError unless the name is bound, or is the outer part of a nested name that is bound. */
void check_section(const SceneSection &section, const std::string &application, const Sections &sections,
                   const std::vector<std::string> &unlisted)
{
  std::vector<std::string> names;
  for (const ParameterSection &known : sections)
  {
    if (known.name() == section.name || known.name().rfind(section.name + "/", 0) == 0)
      return;
    if (!known.name().empty())
      names.push_back(known.name());
  }
  if (contains(unlisted, section.name))
    throw UserError(section.origin + ": section '" + section.name + "' belongs to the effect '" +
                    effect_of_section(section.name) + "', which is not in Effects: list it or remove the section");
  names.insert(names.end(), unlisted.begin(), unlisted.end());
  throw UserError(section.origin + ": the application '" + application + "' has no section '" + section.name + "'." +
                  suggestion(section.name, names));
}

[[noreturn]] void unknown_parameter(const SceneEntry &entry, const Sections &sections)
{
  std::vector<std::string> names, elsewhere;
  if (entry.section.empty())
    names = {effects_entry, analyses_entry};
  for (const ParameterSection &section : sections)
    for (const ParameterSection::Entry &bound : section.entries())
    {
      if (section.name() == entry.section)
        names.push_back(bound.name);
      else if (bound.name == entry.name)
        elsewhere.push_back(section.name());
    }
  std::string message =
      entry.origin + ": " +
      (entry.section.empty() ? "there is no top-level parameter '" + entry.name + "'."
                             : "section '" + entry.section + "' has no parameter '" + entry.name + "'.");
  // A section that has exactly this parameter is a better hint than the list of all names of this one.
  if (elsewhere.empty() || !near_matches(entry.name, names).empty())
    message += suggestion(entry.name, names);
  if (!elsewhere.empty())
    message += " '" + entry.name + "' is a parameter of the section " + quoted_list(elsewhere, " and ") + ".";
  throw UserError(message);
}

const ParameterSection::Entry &bound_entry(const SceneEntry &entry, const Sections &sections)
{
  for (const ParameterSection &section : sections)
    if (section.name() == entry.section)
      for (const ParameterSection::Entry &bound : section.entries())
        if (bound.name == entry.name)
          return bound;
  unknown_parameter(entry, sections);
}
} // namespace

Scene::Scene(std::string application, SceneEntries entries)
    : application_name(std::move(application))
    , scene(std::move(entries))
{
}

std::vector<std::string> Scene::effects(const std::vector<std::string> &defaults,
                                        const std::vector<std::string> &known) const
{
  return list(effects_entry, defaults, known);
}

std::vector<std::string> Scene::analyses(const std::vector<std::string> &defaults,
                                         const std::vector<std::string> &known) const
{
  return list(analyses_entry, defaults, known);
}

std::vector<std::string> Scene::list(const std::string &name, const std::vector<std::string> &defaults,
                                     const std::vector<std::string> &known) const
{
  const SceneEntry *const entry = find(name);
  if (entry == nullptr)
    return defaults;
  std::vector<std::string> listed;
  for (const std::string &item : comma_separated(entry->value))
  {
    const std::string where = entry->origin + ": the list " + name + " ";
    if (item.empty())
      throw UserError(where + "'" + entry->value + "' has nothing between two commas or at an end: write 'a, b, c'");
    if (contains(listed, item))
      throw UserError(where + "has '" + item + "' twice: name it once");
    if (!contains(known, item))
      throw UserError(where + "has '" + item + "', which the application '" + application_name + "' does not know." +
                      suggestion(item, known));
    listed.push_back(item);
  }
  return listed;
}

void Scene::read(const std::vector<ParameterSection> &sections, const std::vector<std::string> &unlisted_sections)
{
  default_texts.clear();
  for (const ParameterSection &section : sections)
    for (const ParameterSection::Entry &bound : section.entries())
      default_texts[SceneEntry{section.name(), bound.name, "", ""}.path()] = value_text(bound);

  for (const SceneSection &section : scene.sections)
    check_section(section, application_name, sections, unlisted_sections);
  for (const SceneEntry &entry : scene.entries)
  {
    if (is_list(entry))
      continue;
    if (!entry.section.empty())
      check_section({entry.section, entry.origin}, application_name, sections, unlisted_sections);
    const ParameterSection::Entry &bound = bound_entry(entry, sections);
    try
    {
      assign_text(bound, entry.value);
    }
    catch (const UserError &error)
    {
      throw UserError(entry.origin + ": " + (entry.section.empty() ? "" : "section '" + entry.section + "', ") +
                      "parameter '" + entry.name + "': " + error.what());
    }
  }
}

void Scene::set(const std::string &path, const std::string &value, const std::string &origin)
{
  set_entry(scene, path, value, origin);
}

const SceneEntry *Scene::find(const std::string &path) const
{
  for (const SceneEntry &entry : scene.entries)
    if (entry.path() == path)
      return &entry;
  return nullptr;
}

std::string Scene::value(const std::string &path) const
{
  if (const SceneEntry *const entry = find(path))
    return entry->value;
  const auto by_default = default_texts.find(path);
  if (by_default != default_texts.end())
    return by_default->second;
  std::vector<std::string> paths;
  for (const auto &known : default_texts)
    paths.push_back(known.first);
  throw UserError("the application '" + application_name + "' has no parameter '" + path +
                  "' with the effects that are listed." + suggestion(path, paths));
}

std::string Scene::origin(const std::string &path) const
{
  const SceneEntry *const entry = find(path);
  return entry == nullptr ? "default" : entry->origin;
}

std::string Scene::used_text(const std::vector<ParameterSection> &sections, const std::vector<std::string> &effects,
                             const std::vector<std::string> &analyses) const
{
  SceneWriter writer;
  writer.comment("The complete scene as " + application_name + " " + version() + " ran it.");
  writer.entry(effects_entry, joined(effects, ", "));
  writer.entry(analyses_entry, joined(analyses, ", "));
  for (const ParameterSection &section : sections)
  {
    if (section.entries().empty())
      continue;
    writer.blank();
    writer.open(section.name());
    for (const ParameterSection::Entry &bound : section.entries())
    {
      const SceneEntry *const given = find(SceneEntry{section.name(), bound.name, "", ""}.path());
      writer.entry(bound.name, given == nullptr ? value_text(bound) : given->value);
    }
    writer.close();
  }
  return writer.text();
}
} // namespace pellicle
