// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expect_user_error.h"
#include "temporary_directory.h"

#include <pellicle/output/atomic_file.h>
#include <pellicle/output/checkpoint_files.h>
#include <pellicle/output/run_files.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <set>
#include <string>

using namespace pellicle;
using pellicle::testing::content_of;
using pellicle::testing::TemporaryDirectory;

namespace
{
std::set<std::string> names_in(const std::filesystem::path &folder)
{
  std::set<std::string> names;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}
} // namespace

TEST(CheckpointFiles, KeepsTheLastOnes)
{
  const TemporaryDirectory directory;
  const CheckpointFiles files(directory.path(), 2);
  const std::string content("with\0zeros and\nlines\r\n", 22);
  for (const int step : {8, 9, 10, 1000000})
    files.write(step, content + std::to_string(step));
  EXPECT_EQ(names_in(directory.path() / "checkpoint"), (std::set<std::string>{"step_000010.bin", "step_1000000.bin"}));
  const FoundCheckpoint found = read_last_checkpoint(directory.path());
  EXPECT_EQ(found.content, content + "1000000");
  EXPECT_EQ(found.path.filename(), "step_1000000.bin");
  EXPECT_TRUE(found.warnings.empty());
}

TEST(CheckpointFiles, EveryDamageIsNoticed)
{
  const TemporaryDirectory directory;
  const CheckpointFiles files(directory.path(), 2);
  files.write(1, "good");
  files.write(2, "better");
  const auto newest       = directory.path() / "checkpoint" / "step_000002.bin";
  const std::string whole = content_of(newest);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    std::string damaged = whole;
    damaged[i]          = static_cast<char>(damaged[i] ^ 16);
    write_whole_file(newest, damaged);
    const FoundCheckpoint found = read_last_checkpoint(directory.path());
    EXPECT_EQ(found.content, "good") << i;
    EXPECT_EQ(found.warnings.size(), 1u);
    write_whole_file(newest, whole.substr(0, i));
    EXPECT_EQ(read_last_checkpoint(directory.path()).content, "good") << i;
  }
  write_whole_file(directory.path() / "checkpoint" / "step_000001.bin", "");
  write_whole_file(newest, "");
  EXPECT_USER_ERROR(read_last_checkpoint(directory.path()), "step_000001.bin", "step_000002.bin", "no checkpoint can");
}

TEST(CheckpointFiles, OthersAreNotTouched)
{
  const TemporaryDirectory directory;
  const auto folder = directory.path() / "checkpoint";
  const CheckpointFiles files(directory.path(), 5);
  for (const int step : {1, 2, 3})
    files.write(step, "x");
  for (const char *name : {"notes.txt", "step_1.bin.old", "step_x.bin", "other.tmp"})
    write_whole_file(folder / name, "");
  write_whole_file(folder / "step_000004.bin.tmp", ""); // of a killed run
  remove_later_checkpoints(folder / "step_000002.bin");
  EXPECT_EQ(names_in(folder), (std::set<std::string>{"step_000001.bin", "step_000002.bin", "notes.txt",
                                                     "step_1.bin.old", "step_x.bin", "other.tmp"}));
  remove_checkpoints(directory.path());
  EXPECT_EQ(names_in(folder), (std::set<std::string>{"notes.txt", "step_1.bin.old", "step_x.bin", "other.tmp"}));
}

TEST(CheckpointFiles, AContinuedRunKeepsSolutionsAndCheckpoints)
{
  const TemporaryDirectory directory;
  CheckpointFiles(directory.path(), 1).write(1, "x");
  for (const char *name :
       {"summary.json", "history.csv", "history.csv.tmp", "solution_0001.vtu", "solution_0002.vtu.tmp", "mine.tmp"})
    write_whole_file(directory.path() / name, "");
  prepare_continued_directory(directory.path());
  EXPECT_EQ(names_in(directory.path()), (std::set<std::string>{"checkpoint", "mine.tmp", "solution_0001.vtu"}));
  prepare_output_directory(directory.path());
  EXPECT_EQ(names_in(directory.path()), (std::set<std::string>{"mine.tmp"}));
}

TEST(WholeFile, WritesIntoAPipeAndDoesNotReplaceIt)
{
  const TemporaryDirectory directory;
  const auto path = directory.path() / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  write_whole_file(path, "text");
  char text[8] = {};
  EXPECT_EQ(::read(reader, text, sizeof(text)), 4);
  EXPECT_EQ(std::string(text), "text");
  ::close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(path));
}

TEST(WholeFile, FollowsLinks)
{
  const TemporaryDirectory directory;
  write_whole_file(directory.path() / "file", "old");
  std::filesystem::create_symlink("file", directory.path() / "link");
  write_whole_file(directory.path() / "link", "new");
  EXPECT_EQ(content_of(directory.path() / "file"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(directory.path() / "link"));
}
