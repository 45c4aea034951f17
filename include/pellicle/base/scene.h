// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>
#include <pellicle/base/scene_file.h>

#include <map>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * The values that a scene gives to parameters. It is read in two passes: first the lists of effects and analyses, from
 * which the application knows which parameter structs there are, then the sections that these structs bind.
 *
 *     Scene scene("vesicle", read_scene_file("prolate.prm"));
 *     const auto effects = scene.effects({"helfrich bending"}, all_effects);
 *     ...                                                 // default-construct the structs and bind them to sections
 *     scene.read(sections, sections_of_unlisted_effects); // the structs hold the scene's values now
 *
 * Mistakes of the user are UserErrors that name origin (file and line, or the --set), section, parameter, value, and
 * what is allowed. A load step changes one parameter by set() and reads again into structs that are freshly constructed
 * and bound.
 */
class Scene
{
public:
  /** `application` stands in messages and in the written scene. */
  Scene(std::string application, SceneEntries entries);

  /**
   * The comma-separated top-level list `Effects`, or the defaults when the scene has none. Throws UserError when a name
   * is empty, stands twice, or is not among the known ones.
   */
  std::vector<std::string> effects(const std::vector<std::string> &defaults,
                                   const std::vector<std::string> &known) const;
  /** The same for `Analyses`. */
  std::vector<std::string> analyses(const std::vector<std::string> &defaults,
                                    const std::vector<std::string> &known) const;

  /**
   * Gives the bound members the values that the scene has for them; the others stay as they are, at their defaults.
   * Throws UserError when the scene has a section or parameter that is not bound, or a value that is not allowed.
   * `unlisted_sections`: sections of effects that exist but are not listed, for the message when the scene has one of
   * them.
   */
  void read(const std::vector<ParameterSection> &sections, const std::vector<std::string> &unlisted_sections);

  /** Sets the text of a parameter "Section/Name"; whether it exists and may have this value is checked by the next
   * read(). */
  void set(const std::string &path, const std::string &value, const std::string &origin);

  /** The text of a parameter: the scene's, else that of its default at the last read(). Throws UserError with near
   * matches. */
  std::string value(const std::string &path) const;

  /** Where the value of a parameter comes from, to begin a message with: `scene.prm:12`; "default" when the scene has
   * none. */
  std::string origin(const std::string &path) const;

  /**
   * The complete scene as run: every parameter of the sections, which were read by read(), with the user's text or its
   * default. Reading this text again gives exactly the same values.
   */
  std::string used_text(const std::vector<ParameterSection> &sections, const std::vector<std::string> &effects,
                        const std::vector<std::string> &analyses) const;

private:
  std::vector<std::string> list(const std::string &name, const std::vector<std::string> &defaults,
                                const std::vector<std::string> &known) const;
  const SceneEntry *find(const std::string &path) const;

  std::string application_name;
  SceneEntries scene;
  std::map<std::string, std::string> default_texts; // by path, from the last read()
};
} // namespace pellicle
