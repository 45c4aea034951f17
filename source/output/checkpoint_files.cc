// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/checkpoint_files.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>

namespace pellicle
{
namespace
{
namespace fs = std::filesystem;

/** What a file begins with. */
struct Header
{
  char magic[16]           = {'P', 'e', 'l', 'l', 'i', 'c', 'l', 'e', ' ', 's', 't', 'a', 't', 'e', '\r', '\n'};
  std::uint32_t byte_order = 0x01020304;
  std::uint32_t checksum   = 0;
  std::uint64_t size       = 0;
};

std::uint32_t checksum_of(const char *data, const std::size_t size)
{
  boost::crc_32_type crc;
  crc.process_bytes(data, size);
  return crc.checksum();
}

fs::path folder_of(const fs::path &output_directory)
{
  return output_directory / "checkpoint";
}

/** The number in step_NNNNNN.bin. */
std::optional<int> step_of(const fs::path &path)
{
  int step = 0, end = 0;
  const std::string name = path.filename().string();
  if (std::sscanf(name.c_str(), "step_%d.bin%n", &step, &end) == 1 && end == static_cast<int>(name.size()))
    return step;
  return std::nullopt;
}

/** Checkpoints in a folder, the last one first. */
std::vector<fs::path> checkpoints_in(const fs::path &folder)
{
  std::vector<std::pair<int, fs::path>> found;
  std::error_code ignored;
  for (const auto &entry : fs::directory_iterator(folder, ignored))
    if (const std::optional<int> step = step_of(entry.path()))
      found.emplace_back(*step, entry.path());
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> paths;
  for (const auto &[step, path] : found)
    paths.push_back(path);
  return paths;
}

/** What a killed run had begun to write. */
void remove_unfinished(const fs::path &folder)
{
  std::vector<fs::path> unfinished;
  std::error_code ignored;
  for (const auto &entry : fs::directory_iterator(folder, ignored))
    if (is_unfinished_file(entry.path()) && step_of(entry.path().stem()))
      unfinished.push_back(entry.path());
  for (const fs::path &path : unfinished)
    fs::remove(path, ignored);
}

/** The content, or what is wrong with the file. */
std::string read(const fs::path &path, std::string &fault)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string all = text.str();
  Header header, expected;
  if (!in.is_open() || !fs::is_regular_file(path))
    fault = "it cannot be opened";
  else if (all.size() >= sizeof(Header))
    std::memcpy(&header, all.data(), sizeof(Header));
  if (!fault.empty())
    return {};
  if (all.size() < sizeof(Header))
    fault = "it has " + std::to_string(all.size()) + " bytes, fewer than its header";
  else if (std::memcmp(header.magic, expected.magic, sizeof(header.magic)) != 0)
    fault = "it is not a checkpoint";
  else if (header.byte_order != expected.byte_order)
    fault = "it was written on a machine with another order of bytes";
  else if (header.size != all.size() - sizeof(Header))
    fault = "it has " + std::to_string(all.size()) + " bytes where " + std::to_string(header.size + sizeof(Header)) +
            " should be";
  else if (header.checksum != checksum_of(all.data() + sizeof(Header), header.size))
    fault = "its checksum is wrong";
  return fault.empty() ? all.substr(sizeof(Header)) : "";
}
} // namespace

CheckpointFiles::CheckpointFiles(const fs::path &output_directory, const int keep)
    : folder(folder_of(output_directory))
    , keep(static_cast<std::size_t>(keep))
{
  make_directory(folder);
}

void CheckpointFiles::write(const int step, const std::string &content) const
{
  Header header;
  header.size     = content.size();
  header.checksum = checksum_of(content.data(), content.size());
  std::string text(sizeof(Header), '\0');
  std::memcpy(text.data(), &header, sizeof(Header));
  char name[32];
  std::snprintf(name, sizeof(name), "step_%06d.bin", step);
  write_lasting_file(folder / name, text + content);

  const std::vector<fs::path> all = checkpoints_in(folder);
  std::error_code ignored; // one too many does no harm
  for (std::size_t i = keep; i < all.size(); ++i)
    fs::remove(all[i], ignored);
}

FoundCheckpoint read_last_checkpoint(const fs::path &output_directory)
{
  std::error_code error;
  if (!fs::is_directory(output_directory, error))
    throw UserError("--restart '" + output_directory.string() +
                    "': there is no such directory. Give the output directory of the run that is to go on.");
  const std::vector<fs::path> all = checkpoints_in(folder_of(output_directory));
  if (all.empty())
    throw UserError("--restart '" + output_directory.string() + "': there is no checkpoint in '" +
                    folder_of(output_directory).string() +
                    "'. Give the output directory of a run with Checkpoint/Every > 0, or run the scene from its "
                    "start.");
  FoundCheckpoint found;
  for (const fs::path &path : all)
  {
    std::string fault;
    found.content = read(path, fault);
    if (fault.empty())
    {
      found.path = path;
      return found;
    }
    found.warnings.push_back("The checkpoint '" + path.string() + "' cannot be used: " + fault + ".");
  }
  std::string message = "--restart '" + output_directory.string() + "': no checkpoint can be used.";
  for (const std::string &warning : found.warnings)
    message += ' ' + warning;
  throw UserError(message + " Run the scene from its start.");
}

void remove_checkpoints(const fs::path &output_directory)
{
  std::error_code ignored;
  remove_unfinished(folder_of(output_directory));
  for (const fs::path &path : checkpoints_in(folder_of(output_directory)))
    fs::remove(path, ignored);
  fs::remove(folder_of(output_directory), ignored); // stays if there is anything else in it
}

void remove_later_checkpoints(const fs::path &last_to_keep)
{
  std::error_code ignored;
  remove_unfinished(last_to_keep.parent_path());
  for (const fs::path &path : checkpoints_in(last_to_keep.parent_path()))
    if (step_of(path) > step_of(last_to_keep))
      fs::remove(path, ignored);
}
} // namespace pellicle
