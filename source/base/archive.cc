// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/archive.h>

#include <cstring>

namespace pellicle
{
Archive::Archive(std::string content)
    : bytes(std::move(content))
    , reading(true)
{
}

void Archive::raw(void *data, const std::size_t size)
{
  if (!reading)
  {
    bytes.append(static_cast<const char *>(data), size);
    return;
  }
  if (size > bytes.size() - position)
    throw ArchiveMismatch("it ends too early");
  std::memcpy(data, bytes.data() + position, size);
  position += size;
}

std::size_t Archive::count(const std::size_t of_object)
{
  std::size_t n = of_object;
  *this | n;
  if (reading && n > bytes.size() - position)
    throw ArchiveMismatch("it holds no list of " + std::to_string(n) + " entries");
  return n;
}

void Archive::visit(std::string &text)
{
  const std::size_t n = count(text.size());
  if (reading)
    text.resize(n);
  raw(text.data(), n);
}

void Archive::name(const std::string &text)
{
  std::string there = text;
  visit(there);
  if (there != text)
    throw ArchiveMismatch("it has no '" + text + "' where one should be");
}
} // namespace pellicle
