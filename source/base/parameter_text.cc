// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/expression.h>
#include <pellicle/base/near_match.h>
#include <pellicle/base/parameter_text.h>
#include <pellicle/base/text.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
namespace
{
using Entry = ParameterSection::Entry;

std::string to_text(const double value)
{
  return exact_text(value);
}

std::string to_text(const int value)
{
  return std::to_string(value);
}

std::string to_text(const bool value)
{
  return value ? "true" : "false";
}

std::string to_text(const std::string &value)
{
  return value;
}

std::string to_text(const std::vector<double> &values)
{
  std::vector<std::string> parts;
  std::transform(values.begin(), values.end(), std::back_inserter(parts), exact_text);
  return joined(parts, ", ");
}

std::string integer_range_text(const Range &range)
{
  constexpr double smallest = std::numeric_limits<int>::min(), largest = std::numeric_limits<int>::max();
  Range shown = range;
  if (range.lower <= smallest)
    shown.lower = Range::any().lower;
  if (range.upper >= largest)
    shown.upper = Range::any().upper;
  return "an integer" + shown.text().substr(std::string("a number").size());
}

/** A number inside the range of the entry. */
double allowed_number(const Entry &entry, const std::string &text)
{
  const double value = evaluate_number(text);
  if (!entry.range.contains(value))
  {
    const std::string short_text = exact_text(value);
    throw UserError("'" + excerpt(text) + "'" + (short_text == text ? "" : " (= " + short_text + ")") +
                    " is out of range");
  }
  return value;
}

void assign(const Entry &entry, const std::string &text, double &target)
{
  target = allowed_number(entry, text);
}

void assign(const Entry &entry, const std::string &text, int &target)
{
  const double value = evaluate_number(text);
  if (value != std::floor(value) || std::isinf(value))
    throw UserError("'" + excerpt(text) + "' is not an integer");
  target = static_cast<int>(allowed_number(entry, text));
}

void assign(const Entry & /*entry*/, const std::string &text, bool &target)
{
  const std::string word = lower_case(text);
  if (word != "true" && word != "yes" && word != "false" && word != "no")
    throw UserError("'" + excerpt(text) + "' is neither true nor false");
  target = word == "true" || word == "yes";
}

void assign(const Entry &entry, const std::string &text, std::string &target)
{
  if (!entry.choices.empty() && std::find(entry.choices.begin(), entry.choices.end(), text) == entry.choices.end())
    throw UserError("'" + excerpt(text) + "' is not one of the choices" +
                    (near_matches(text, entry.choices).empty() ? "" : "." + suggestion(text, entry.choices)));
  target = text;
}

void assign(const Entry &entry, const std::string &text, std::vector<double> &target)
{
  std::vector<double> values;
  for (const std::string &part : comma_separated(text))
    values.push_back(allowed_number(entry, part));
  target = std::move(values);
}
} // namespace

std::string value_text(const ParameterSection::Entry &entry)
{
  return std::visit([](const auto *target) { return to_text(*target); }, entry.target);
}

std::string allowed_text(const ParameterSection::Entry &entry)
{
  if (std::holds_alternative<double *>(entry.target))
    return entry.range.text();
  if (std::holds_alternative<int *>(entry.target))
    return integer_range_text(entry.range);
  if (std::holds_alternative<bool *>(entry.target))
    return "true or false";
  if (std::holds_alternative<std::vector<double> *>(entry.target))
    return "a comma-separated list, each " + entry.range.text();
  return entry.choices.empty() ? "any text" : quoted_list(entry.choices, " or ");
}

void assign_text(const ParameterSection::Entry &entry, const std::string &text)
{
  try
  {
    std::visit([&](auto *target) { assign(entry, text, *target); }, entry.target);
  }
  catch (const UserError &error)
  {
    const std::string reason = error.what();
    throw UserError(reason + (reason.back() == '?' ? "" : ".") + " Allowed: " + allowed_text(entry) + ".");
  }
}
} // namespace pellicle
