// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/atomic_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace pellicle
{
namespace
{
constexpr const char *unfinished = ".tmp";

WriteError cannot(const std::string &what, const std::filesystem::path &path, const std::string &reason)
{
  return WriteError("Cannot " + what + " '" + path.string() + "': " + reason +
                    ". Choose a directory that can be written, on a disc with room, with --output-directory.");
}

/** A file that is closed in any case. */
class Descriptor
{
public:
  Descriptor(const std::filesystem::path &path, const int flags)
      : number(::open(path.c_str(), flags | O_CLOEXEC, 0666))
  {
  }
  ~Descriptor()
  {
    if (number >= 0)
      ::close(number);
  }
  Descriptor(const Descriptor &)            = delete;
  Descriptor &operator=(const Descriptor &) = delete;

  bool is_open() const { return number >= 0; }
  /** False: errno says why. */
  bool write(const std::string &text) const
  {
    for (std::size_t done = 0; done < text.size();)
    {
      const ssize_t n = ::write(number, text.data() + done, text.size() - done);
      if (n < 0 && errno == EINTR)
        continue;
      if (n < 0)
        return false;
      done += static_cast<std::size_t>(n);
    }
    return true;
  }
  bool flush() const { return ::fsync(number) == 0; }
  /** Some file systems find out only now that there is no room. */
  bool close()
  {
    const int closed = ::close(number);
    number           = -1;
    return closed == 0;
  }

private:
  int number;
};

enum class Lasting
{
  no,
  yes
};

/** Writes everything or returns the errno of what went wrong. */
int write_plain(const std::filesystem::path &path, const std::string &text, const int flags, const Lasting lasting)
{
  Descriptor file(path, O_WRONLY | flags);
  const bool done = file.is_open() && file.write(text) && (lasting == Lasting::no || file.flush()) && file.close();
  return done ? 0 : errno;
}

/** Where a symbolic link leads: it is to stay one. */
std::filesystem::path target_of(const std::filesystem::path &path)
{
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error))
    return path;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

void write_and_rename(const std::filesystem::path &name, const std::string &text, const Lasting lasting)
{
  const std::filesystem::path path = target_of(name);
  std::error_code error;
  if (std::filesystem::is_other(path, error))
  {
    if (const int reason = write_plain(path, text, 0, Lasting::no))
      throw cannot_write(path, reason);
    return;
  }
  std::filesystem::path temporary = path;
  temporary += unfinished;
  error.assign(write_plain(temporary, text, O_CREAT | O_TRUNC, lasting), std::generic_category());
  if (!error)
    std::filesystem::rename(temporary, path, error);
  if (error)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw cannot("write", path, error.message());
  }
  // The new name is an entry of the directory, which has to reach the disc as well. Not all file systems can say so.
  if (lasting == Lasting::yes)
    if (const Descriptor directory(path.parent_path(), O_RDONLY); directory.is_open())
      directory.flush();
}
} // namespace

WriteError cannot_write(const std::filesystem::path &path, const int error_number)
{
  return cannot("write", path, std::generic_category().message(error_number));
}

void write_whole_file(const std::filesystem::path &path, const std::string &text)
{
  write_and_rename(path, text, Lasting::no);
}

void write_lasting_file(const std::filesystem::path &path, const std::string &text)
{
  write_and_rename(path, text, Lasting::yes);
}

bool is_unfinished_file(const std::filesystem::path &path)
{
  return path.extension() == unfinished;
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
