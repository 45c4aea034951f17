// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/near_match.h>

#include <gtest/gtest.h>

using namespace pellicle;

namespace
{
const std::vector<std::string> effects = {"helfrich bending", "area constraint", "volume constraint", "surface tension",
                                          "pressure"};
using Names                            = std::vector<std::string>;
} // namespace

TEST(NearMatch, FindsMisspellingsWhateverTheCase)
{
  EXPECT_EQ(near_matches("helfrich bendig", effects), Names{"helfrich bending"});
  EXPECT_EQ(near_matches("Presure", effects), Names{"pressure"});
  EXPECT_EQ(near_matches("PRESSURE", effects), Names{"pressure"});
}

TEST(NearMatch, SwappedLettersAreOneEdit)
{
  EXPECT_EQ(near_matches("Aera", {"Area", "Axis", "Aria"}), Names{"Area"}); // Aria is two edits away
}

TEST(NearMatch, PartsOfNamesCount)
{
  EXPECT_EQ(near_matches("bending", effects), Names{"helfrich bending"});
  EXPECT_EQ(near_matches("helfrich bending energy", effects), Names{"helfrich bending"});
  EXPECT_EQ(near_matches("in", effects), Names{}); // too short to mean anything
}

TEST(NearMatch, BestFirstAndNotTooMany)
{
  const Names candidates = {"abcdxx", "abcdex", "abcdef", "abcdeg", "abcd"};
  EXPECT_EQ(near_matches("abcdef", candidates, 2), (Names{"abcdef", "abcdex"}));
  EXPECT_EQ(near_matches("abcdef", candidates).size(), 3u);
}

TEST(NearMatch, NothingResembles)
{
  EXPECT_TRUE(near_matches("zzzzzz", effects).empty());
  EXPECT_TRUE(near_matches("", effects).empty());
  EXPECT_TRUE(near_matches("pressure", {}).empty());
}

TEST(NearMatch, SuggestionIsASentence)
{
  EXPECT_EQ(suggestion("constraint", effects), " Did you mean 'area constraint' or 'volume constraint'?");
  EXPECT_EQ(suggestion("zzz", {"a1", "b1", "c1"}), " Possible: 'a1', 'b1', 'c1'.");
  EXPECT_EQ(suggestion("zzz", {}), "");
}

// A word of the length of a file: the table of distances would have 1e10 entries.
TEST(NearMatch, WordsOfOtherLengthsAreNotCompared)
{
  EXPECT_EQ(near_matches(std::string(100000, 'x'), {"pressure", std::string(50000, 'x')}).size(), 1u);
  EXPECT_TRUE(near_matches(std::string(100000, 'x'), {"pressure", std::string(50000, 'y')}).empty());
}
