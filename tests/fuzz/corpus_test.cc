// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads the kept inputs of all fuzzers again, with whatever compiler the tests are built: what was found stays mended.
#include "targets.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
using pellicle::fuzz::Target;

class Corpus : public testing::TestWithParam<Target>
{
};

TEST_P(Corpus, IsReadOrRefused)
{
  unsigned int n_inputs = 0;
  for (const auto &entry :
       std::filesystem::directory_iterator(PELLICLE_SOURCE_DIR "/tests/fuzz/corpus/" + GetParam().name))
  {
    SCOPED_TRACE(entry.path().string());
    std::ostringstream input;
    input << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    EXPECT_NO_THROW(pellicle::fuzz::run(GetParam().read, input.str()));
    ++n_inputs;
  }
  EXPECT_GT(n_inputs, 0u);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(pellicle::fuzz::targets()),
                         [](const auto &named) { return named.param.name; });
} // namespace
