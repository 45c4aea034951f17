// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/text.h>

#include <algorithm>
#include <cctype>

namespace pellicle
{
std::string trimmed(const std::string &text)
{
  const char *const white_space = " \t\r\n\v\f";
  const std::size_t first       = text.find_first_not_of(white_space);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

std::string excerpt(const std::string &text)
{
  constexpr std::size_t longest = 200;
  std::string shown             = text.size() > longest ? text.substr(0, longest - 3) + "..." : text;
  std::replace_if(
      shown.begin(), shown.end(), [](const unsigned char c) { return std::iscntrl(c) != 0; }, '?');
  return shown;
}

std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<std::string> comma_separated(const std::string &text)
{
  std::vector<std::string> parts;
  if (trimmed(text).empty())
    return parts;
  std::string part;
  int depth = 0;
  for (const char c : text)
  {
    depth += (c == '(') - (c == ')');
    if (c == ',' && depth == 0)
    {
      parts.push_back(trimmed(part));
      part.clear();
    }
    else
      part += c;
  }
  parts.push_back(trimmed(part));
  return parts;
}

std::string joined(const std::vector<std::string> &parts, const std::string &separator)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : separator) + parts[i];
  return text;
}

std::string quoted_list(const std::vector<std::string> &parts, const std::string &last_separator)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? last_separator : ", ") + ("'" + parts[i] + "'");
  return text;
}
} // namespace pellicle
