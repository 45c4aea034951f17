// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/archive.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{
using namespace pellicle;

enum class Status
{
  stuck,
  slipping
};

struct Plain
{
  int number   = 0;
  double value = 0.;
};

struct Everything
{
  std::string text;
  Plain plain;
  Status status = Status::stuck;
  std::vector<double> numbers;
  std::vector<std::vector<double>> fields;
  std::vector<std::pair<std::string, double>> named;
  std::map<std::size_t, Plain> by_node;
  std::optional<double> maybe;
  std::optional<std::string> none;

  void exchange(Archive &archive)
  {
    archive.name("everything");
    archive | text | plain | status | numbers | fields | named | by_node | maybe | none;
  }
};

TEST(Archive, GivesBackEveryBit)
{
  const double tiny = 4.9406564584124654e-324, third = 1. / 3.;
  Everything written{"a\0b",
                     {7, third},
                     Status::slipping,
                     {0.1, -0., tiny, std::numeric_limits<double>::infinity(), std::nan("")},
                     {{1.}, {}, {2., 3.}},
                     {{"area", third}, {"", 0.}},
                     {{4, {1, 2.}}, {9, {3, 4.}}},
                     0.25,
                     std::nullopt};
  Archive out;
  out | written;
  Archive in(out.content());
  Everything read;
  read.by_node = {{1, {}}};
  read.none    = "something";
  in | read;
  EXPECT_EQ(read.text, written.text);
  EXPECT_EQ(read.plain.number, 7);
  EXPECT_EQ(read.plain.value, third);
  EXPECT_EQ(read.status, Status::slipping);
  ASSERT_EQ(read.numbers.size(), written.numbers.size());
  EXPECT_EQ(std::memcmp(read.numbers.data(), written.numbers.data(), 5 * sizeof(double)), 0);
  EXPECT_EQ(read.fields, written.fields);
  EXPECT_EQ(read.named, written.named);
  ASSERT_EQ(read.by_node.size(), 2u);
  EXPECT_EQ(read.by_node.at(9).value, 4.);
  EXPECT_EQ(read.maybe, 0.25);
  EXPECT_FALSE(read.none);
}

TEST(Archive, SaysWhereItDoesNotFit)
{
  std::vector<double> numbers{1., 2., 3.};
  Archive out;
  out.name("numbers");
  out | numbers;

  Archive of_others(out.content());
  EXPECT_THROW(of_others.name("state"), ArchiveMismatch);
  const std::string cut = out.content().substr(0, out.content().size() - 1);
  Archive short_one(cut);
  short_one.name("numbers");
  EXPECT_THROW(short_one | numbers, ArchiveMismatch);
  // A length that cannot be is noticed before memory is asked for.
  std::size_t absurd = std::numeric_limits<std::size_t>::max() / 2;
  Archive lengths;
  lengths | absurd;
  Archive in(lengths.content());
  EXPECT_THROW(in | numbers, ArchiveMismatch);
}

// Bytes of a damaged or forged file never become a value that the language does not have.
TEST(Archive, RefusesBytesThatAreNoValue)
{
  unsigned char neither = 2;
  Archive out;
  out | neither;
  bool truth = false;
  Archive in(out.content());
  EXPECT_THROW(in | truth, ArchiveMismatch);
  std::optional<bool> maybe;
  Archive again(out.content());
  EXPECT_THROW(again | maybe, ArchiveMismatch);
}

TEST(Archive, ListsOfKnownLengthHaveItOrNothing)
{
  for (const std::size_t there : {std::size_t(0), std::size_t(2), std::size_t(3)})
  {
    std::vector<double> written(there, 1.), read;
    Archive out;
    out.list(written, there);
    Archive in(out.content());
    if (there == 2)
      EXPECT_THROW(in.list(read, 3), ArchiveMismatch);
    else
      EXPECT_NO_THROW(in.list(read, 3));
  }
}

TEST(Archive, TakesNoPathForTheNameOfAFile)
{
  for (const char *name : {"solution_0001.vtu", "branch"})
    EXPECT_NO_THROW(check_file_name(name)) << name;
  for (const char *path : {"", ".", "../solution_0001.vtu", "/etc/passwd", "a/b"})
    EXPECT_THROW(check_file_name(path), ArchiveMismatch) << path;
  EXPECT_THROW(check_file_name(std::string("a\0b", 3)), ArchiveMismatch);
}
} // namespace
