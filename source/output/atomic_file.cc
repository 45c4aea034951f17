// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/atomic_file.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace pellicle
{
namespace
{
UserError cannot(const std::string &what, const std::filesystem::path &path, const std::string &reason)
{
  return UserError("Cannot " + what + " '" + path.string() + "': " + reason +
                   ". Choose a directory that can be written with --output-directory.");
}

/** Writes everything or returns the errno of what went wrong. */
int write_plain(const std::filesystem::path &path, const std::string &text)
{
  std::FILE *file = std::fopen(path.c_str(), "wb");
  if (file == nullptr)
    return errno;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int reason   = written ? 0 : errno;
  // A full disk may show only when the buffer is flushed.
  const bool closed = std::fclose(file) == 0;
  return !written ? reason : (closed ? 0 : errno);
}
} // namespace

UserError cannot_write(const std::filesystem::path &path, const int error_number)
{
  return cannot("write", path, std::generic_category().message(error_number));
}

void write_whole_file(const std::filesystem::path &path, const std::string &text)
{
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  const int reason = write_plain(temporary, text);

  std::error_code error(reason, std::generic_category());
  if (reason == 0)
    std::filesystem::rename(temporary, path, error);
  if (error)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw cannot("write", path, error.message());
  }
}

void make_directory(const std::filesystem::path &directory)
{
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw cannot("create the directory", directory, error.message());
  if (!std::filesystem::is_directory(directory, error))
    throw cannot("create the directory", directory, "a file of that name is in the way");
}
} // namespace pellicle
