// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/parameters.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
bool Range::contains(const double value) const
{
  if (std::isnan(value))
    return false;
  if (std::isinf(value))
    return allow_inf && (value > 0. || lower == value);
  const bool above = lower_open ? value > lower : value >= lower;
  const bool below = upper_open ? value < upper : value <= upper;
  return above && below;
}

std::string Range::text() const
{
  const bool bounded_below = std::isfinite(lower), bounded_above = std::isfinite(upper);
  std::string text = "a number";
  if (bounded_below && bounded_above)
    text += std::string(" in ") + (lower_open ? "(" : "[") + exact_text(lower) + ", " + exact_text(upper) +
            (upper_open ? ")" : "]");
  else if (bounded_below)
    text += (lower_open ? " > " : " >= ") + exact_text(lower);
  else if (bounded_above)
    text += (upper_open ? " < " : " <= ") + exact_text(upper);
  return allow_inf ? text + " or inf" : text;
}

namespace
{
void append(std::vector<ParameterSection::Entry> &entries, ParameterSection::Entry entry)
{
  PELLICLE_ASSERT(!entry.name.empty() && entry.name.find_first_of("/=#\\\n") == std::string::npos,
                  "the name of a parameter must be writable in a scene");
  PELLICLE_ASSERT(
      std::none_of(entries.begin(), entries.end(), [&](const auto &other) { return other.name == entry.name; }),
      "a parameter is bound once");
  entries.push_back(std::move(entry));
}
} // namespace

void ParameterSection::number(const std::string &name, double &target, const Range &range, const Dimension dimension,
                              const std::string &text)
{
  append(bound, {name, text, &target, range, dimension, {}});
}

void ParameterSection::integer(const std::string &name, int &target, const int lower, const int upper,
                               const std::string &text)
{
  append(bound, {name, text, &target, Range::between(lower, upper), dimensions::none, {}});
}

void ParameterSection::flag(const std::string &name, bool &target, const std::string &text)
{
  append(bound, {name, text, &target, Range::any(), dimensions::none, {}});
}

void ParameterSection::word(const std::string &name, std::string &target, const std::string &text)
{
  append(bound, {name, text, &target, Range::any(), dimensions::none, {}});
}

void ParameterSection::choice(const std::string &name, std::string &target, std::vector<std::string> choices,
                              const std::string &text)
{
  PELLICLE_ASSERT(std::find(choices.begin(), choices.end(), target) != choices.end(),
                  "the default must be one of the choices");
  append(bound, {name, text, &target, Range::any(), dimensions::none, std::move(choices)});
}

void ParameterSection::numbers(const std::string &name, std::vector<double> &target, const Range &range,
                               const Dimension dimension, const std::string &text)
{
  append(bound, {name, text, &target, range, dimension, {}});
}

void scale_entries(const ParameterSection &section, const Scales &scales)
{
  for (const ParameterSection::Entry &entry : section.entries())
  {
    const double unit = scales.of(entry.dimension);
    if (double *const *number = std::get_if<double *>(&entry.target))
      **number /= unit;
    else if (std::vector<double> *const *numbers = std::get_if<std::vector<double> *>(&entry.target))
      for (double &value : **numbers)
        value /= unit;
  }
}
} // namespace pellicle
