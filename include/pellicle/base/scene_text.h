// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>

#include <string>
#include <vector>

namespace pellicle
{
/** A section of an effect that exists but is not listed. */
struct UnlistedSection
{
  std::string effect;
  ParameterSection section;
};

/** All that can be said about the scenes of an application; the members that the sections bind hold their defaults. */
struct SceneDescription
{
  std::string application;
  std::vector<std::string> effects, analyses; ///< listed
  std::vector<std::string> known_effects, known_analyses;
  std::vector<ParameterSection> sections; ///< of the scene itself and of the listed effects
  std::vector<UnlistedSection> unlisted;
};

/**
 * A scene file with every parameter at its default, with meaning, unit and allowed values as comments. Sections of
 * effects that are not listed are commented out, so that the file can be run as it is.
 */
std::string commented_scene(const SceneDescription &description);

/** The same as a Markdown chapter: a heading and a table for each section. */
std::string parameter_chapter(const SceneDescription &description);
} // namespace pellicle
