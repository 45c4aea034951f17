// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pellicle
{
/** An archive does not hold what is asked of it: it is of another scene, or of another version of the program. */
class ArchiveMismatch : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Throws ArchiveMismatch unless a text from an archive is the name of a file in a folder that the reader chooses: a
 * damaged or forged one could lead elsewhere. */
void check_file_name(const std::string &text);

/**
 * Values of a run, to the last bit, as they go into a checkpoint and come out of it. One function of an object names
 * its values for both directions, so that they cannot get out of step:
 *
 *     void exchange(Archive &archive) { archive | time | positions | statuses; }
 *
 * Possible are numbers, enumerations and plain structs of them, texts, vectors, maps, optional values, and types with
 * such a function. Archives are read by the program, and on the kind of machine, that wrote them.
 */
class Archive
{
public:
  /** An empty one, to be written. */
  Archive() = default;
  /** One to be read, from the content() of a written one. */
  explicit Archive(std::string content);

  bool is_reading() const { return reading; }
  const std::string &content() const { return bytes; }

  /** Writes a name, or reads it and throws ArchiveMismatch if another one stands there: what follows is what it says.
   */
  void name(const std::string &text);

  template <typename T>
  Archive &operator|(T &value);

  /** A list of which the reader knows the length: throws ArchiveMismatch for one with other than n entries or none. */
  template <typename T>
  void list(std::vector<T> &values, std::size_t n);

private:
  /** Whether any bytes make a value: not so with those that have their own visit(). */
  template <typename T>
  struct IsRaw : std::bool_constant<std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>>
  {
  };
  template <typename T>
  struct IsRaw<std::optional<T>> : std::false_type
  {
  };

  void raw(void *data, std::size_t size);
  /** Number of entries to come; throws ArchiveMismatch if there cannot be so many. */
  std::size_t count(std::size_t of_object);

  template <typename T>
  void visit(std::vector<T> &values);
  template <typename K, typename V>
  void visit(std::map<K, V> &values);
  template <typename A, typename B>
  void visit(std::pair<A, B> &value);
  template <typename T>
  void visit(std::optional<T> &value);
  void visit(std::string &text);
  /** Any byte can stand in a file, and only two of them are truth values. */
  void visit(bool &value);
  template <typename T>
  auto visit(T &value) -> decltype(value.exchange(*this))
  {
    value.exchange(*this);
  }

  std::string bytes;
  std::size_t position = 0; ///< of the next byte to be read
  bool reading         = false;
};

template <typename T>
Archive &Archive::operator|(T &value)
{
  static_assert(!std::is_pointer_v<T>, "a place in memory means nothing to the next run");
  if constexpr (IsRaw<T>::value)
    raw(&value, sizeof(T));
  else
    visit(value);
  return *this;
}

template <typename T>
void Archive::list(std::vector<T> &values, const std::size_t n)
{
  *this | values;
  if (reading && !values.empty() && values.size() != n)
    throw ArchiveMismatch("it has a list of " + std::to_string(values.size()) + " entries where " + std::to_string(n) +
                          " should be");
}

template <typename T>
void Archive::visit(std::vector<T> &values)
{
  const std::size_t n = count(values.size());
  if (reading)
    values.assign(n, T());
  for (T &value : values)
    *this | value;
}

template <typename K, typename V>
void Archive::visit(std::map<K, V> &values)
{
  const std::size_t n = count(values.size());
  if (!reading)
  {
    for (auto &[key, value] : values)
    {
      K copy = key;
      *this | copy | value;
    }
    return;
  }
  values.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    K key{};
    V value{};
    *this | key | value;
    values.emplace(std::move(key), std::move(value));
  }
}

template <typename A, typename B>
void Archive::visit(std::pair<A, B> &value)
{
  *this | value.first | value.second;
}

template <typename T>
void Archive::visit(std::optional<T> &value)
{
  bool there = value.has_value();
  *this | there;
  if (reading)
    value = there ? std::optional<T>(T()) : std::nullopt;
  if (there)
    *this | *value;
}
} // namespace pellicle
