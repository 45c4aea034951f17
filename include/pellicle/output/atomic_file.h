// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>

#include <filesystem>
#include <string>

namespace pellicle
{
/** The error for a file that cannot be written: path, reason (from an errno value) and what to do. */
UserError cannot_write(const std::filesystem::path &path, int error_number);

/**
 * Writes `text` to a temporary file beside `path` and renames it to `path`: a reader finds the old file or the whole
 * new one, never a part. Throws UserError with path and reason when that cannot be done; no temporary file stays
 * behind.
 */
void write_whole_file(const std::filesystem::path &path, const std::string &text);

/** Creates a directory with its parents unless it stands already. Throws UserError with path and reason. */
void make_directory(const std::filesystem::path &directory);
} // namespace pellicle
