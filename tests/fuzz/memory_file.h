// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace pellicle::fuzz
{
/** A file in memory, for readers that take the name of a file. It goes away with the object. */
class MemoryFile
{
public:
  explicit MemoryFile(const std::string &content)
      : descriptor(memfd_create("input", 0))
  {
    if (descriptor < 0 || write(descriptor, content.data(), content.size()) != static_cast<ssize_t>(content.size()))
      throw std::runtime_error("no file in memory");
  }
  ~MemoryFile() { close(descriptor); }
  MemoryFile(const MemoryFile &)            = delete;
  MemoryFile &operator=(const MemoryFile &) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor); }

private:
  int descriptor;
};
} // namespace pellicle::fuzz
