// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/run_result.h>

#include <filesystem>
#include <string>

namespace pellicle
{
/** The word that summary.json has for a status, for example "target_not_met". */
const char *status_name(RunStatus status);

/**
 * The text of summary.json: UTF-8, keys in the documented order, numbers that read back to the same value. JSON has no
 * nan and no infinity: a number that is not finite is left out and named in "warnings". "message", "matrix", "loops",
 * "linear_solver" and "stability" appear when there are any.
 */
std::string summary_text(const RunResult &result);

/** Writes summary_text() to `directory`/summary.json as a whole. Throws UserError if that cannot be done. */
void write_summary(const std::filesystem::path &directory, const RunResult &result);
} // namespace pellicle
