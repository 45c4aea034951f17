// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>

#include <filesystem>
#include <string>

namespace pellicle
{
/** A file cannot be written. Before a run has begun it is a mistake to ask for it there, exit status 2; later, when
 * the disc is full, exit status 1. The message holds the file and the reason. */
class WriteError : public UserError
{
public:
  using UserError::UserError;
};

/** The error for a file that cannot be written: path, reason (from an errno value) and what to do. */
WriteError cannot_write(const std::filesystem::path &path, int error_number);

/**
 * Writes `text` to a temporary file beside `path` and renames it to `path`: a reader finds the old file or the whole
 * new one, never a part. Throws WriteError with path and reason when that cannot be done; no temporary file stays
 * behind. Symbolic links stay; what is no regular file (a pipe, a terminal) is written to as it
 * stands.
 */
void write_whole_file(const std::filesystem::path &path, const std::string &text);

/** The same, and it is on the disc, not only on its way there, when the function returns. */
void write_lasting_file(const std::filesystem::path &path, const std::string &text);

/** Whether write_whole_file() would have called a file so before it was whole: it is what a killed run left. */
bool is_unfinished_file(const std::filesystem::path &path);

/** Creates a directory with its parents unless it stands already. Throws WriteError with path and reason. */
void make_directory(const std::filesystem::path &directory);
} // namespace pellicle
