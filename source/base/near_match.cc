// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/near_match.h>
#include <pellicle/base/text.h>

#include <algorithm>
#include <utility>

namespace pellicle
{
namespace
{
/** Fewest insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal string alignment). */
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  // Rows i-2, i-1 and i of the table of distances between the first i letters of a and the first j of b.
  std::vector<std::size_t> before_last, last(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], before_last[j - 2] + 1);
    }
    before_last = std::exchange(last, current);
  }
  return last[b.size()];
}

bool contains_a_word(const std::string &text, const std::string &part)
{
  constexpr std::size_t shortest_word = 4; // shorter parts occur in too many names by chance
  return part.size() >= shortest_word && text.find(part) != std::string::npos;
}

} // namespace

std::vector<std::string> near_matches(const std::string &word, const std::vector<std::string> &candidates,
                                      const unsigned int most)
{
  const std::string wanted = lower_case(word);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string &candidate : candidates)
  {
    const std::string name         = lower_case(candidate);
    const auto [shortest, longest] = std::minmax({wanted.size(), name.size()});
    const std::size_t few          = std::max<std::size_t>(1, longest / 3);
    // At least the difference of the lengths: the work is done only where it may be less than that allows.
    const std::size_t distance = longest - shortest > few ? longest : edit_distance(wanted, name);
    const bool few_edits       = distance <= few && distance < wanted.size();
    if (distance == 0 || few_edits || contains_a_word(name, wanted) || contains_a_word(wanted, name))
      near.emplace_back(distance, candidate);
  }
  std::stable_sort(near.begin(), near.end(), [](const auto &a, const auto &b) { return a.first < b.first; });

  std::vector<std::string> names;
  for (std::size_t i = 0; i < near.size() && i < most; ++i)
    names.push_back(near[i].second);
  return names;
}

std::string suggestion(const std::string &word, const std::vector<std::string> &candidates)
{
  const std::vector<std::string> near = near_matches(word, candidates);
  if (!near.empty())
    return " Did you mean " + quoted_list(near, " or ") + "?";
  return candidates.empty() ? "" : " Possible: " + quoted_list(candidates, ", ") + ".";
}
} // namespace pellicle
