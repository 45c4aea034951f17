// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace pellicle
{
/**
 * Where a render script is: ../share/pellicle/render/ seen from the running program (installed), else in the source
 * tree that this library was built from; nothing if in neither.
 */
std::optional<std::filesystem::path> find_render_script(const std::string &name);

/**
 * Draws the surface in a VTU file, coloured by mean curvature, with a section beside it, into a PNG file; in grey what
 * is in the file `beside` (an empty path: nothing). Returns nothing on success, else a sentence that says why there is
 * no picture (renderer not installed, out of time, ...): a run says so and goes on. Never throws; never takes longer
 * than a minute.
 */
std::optional<std::string> render_picture(const std::filesystem::path &vtu, const std::filesystem::path &beside,
                                          const std::filesystem::path &png, const std::string &title);

/** Draws a drop on a deformable body in section, from the VTU files of the surface and of the body, as render_picture()
 * does. */
std::optional<std::string> render_section(const std::filesystem::path &vtu, const std::filesystem::path &body,
                                          const std::filesystem::path &png, const std::string &title);
} // namespace pellicle
