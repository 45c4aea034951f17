// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * The checkpoints of a run, `checkpoint/step_NNNNNN.bin` in its output directory: a header with size and checksum
 * (CRC-32), then the content. Each is on the disc as a whole before older ones are removed, so that whenever the run is
 * killed the last one can be used.
 */
class CheckpointFiles
{
public:
  /** `keep` >= 1: how many are kept. Makes the folder. Throws WriteError. */
  CheckpointFiles(const std::filesystem::path &output_directory, int keep);

  /** Writes the checkpoint after a step. Throws WriteError with path and reason; those that stand there remain. */
  void write(int step, const std::string &content) const;

private:
  std::filesystem::path folder;
  std::size_t keep;
};

/** A checkpoint that was read. */
struct FoundCheckpoint
{
  std::filesystem::path path;
  std::string content;
  std::vector<std::string> warnings; ///< why newer ones were not used
};

/**
 * The last checkpoint in an output directory that can be read. Throws UserError: there is no such directory, no
 * checkpoint in it, or none that is whole; the message names each with its fault.
 */
FoundCheckpoint read_last_checkpoint(const std::filesystem::path &output_directory);

/** Removes all checkpoints of an output directory, whole or not. */
void remove_checkpoints(const std::filesystem::path &output_directory);

/** Removes the checkpoints after the given one, which are damaged, and unfinished ones: new ones take their places. */
void remove_later_checkpoints(const std::filesystem::path &last_to_keep);
} // namespace pellicle
