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

void Archive::visit(bool &value)
{
  unsigned char byte = value;
  raw(&byte, 1);
  if (byte > 1)
    throw ArchiveMismatch("it has " + std::to_string(byte) + " where a truth value should be");
  value = byte == 1;
}

void check_file_name(const std::string &text)
{
  if (text.empty() || text[0] == '.' || text.find_first_of(std::string("/\0", 2)) != std::string::npos)
    throw ArchiveMismatch("it has '" + text + "' where the name of a file should be");
}

void Archive::name(const std::string &text)
{
  std::string there = text;
  visit(there);
  if (there != text)
    throw ArchiveMismatch("it has no '" + text + "' where one should be");
}
} // namespace pellicle
