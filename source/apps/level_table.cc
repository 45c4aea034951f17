// SPDX-License-Identifier: LGPL-2.1-or-later
#include "level_table.h"

#include <pellicle/base/exact_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace pellicle
{
LevelTable::LevelTable(const RunContext &context, std::string quantity, const double unit)
    : context(context)
    , quantity(std::move(quantity))
    , unit(unit)
{
}

std::vector<double> LevelTable::errors() const
{
  std::vector<double> list;
  for (const LevelRecord &record : records)
    if (record.error)
      list.push_back(*record.error);
  return list;
}

std::vector<double> LevelTable::values() const
{
  std::vector<double> list;
  for (const LevelRecord &record : records)
    list.push_back(record.value);
  return list;
}

double LevelTable::relative_error() const
{
  if (records.empty() || !records.back().error)
    return std::numeric_limits<double>::infinity();
  return relative(*records.back().error);
}

double LevelTable::relative(const double error) const
{
  return std::max(round_off, error / unit_of_errors());
}

double LevelTable::unit_of_errors() const
{
  return std::max(std::abs(records.back().value), unit);
}

void LevelTable::set_error(const double error)
{
  LevelRecord &level   = records.back();
  level.error          = error;
  const double seconds = context.timing.total();
  const int number     = static_cast<int>(records.size()) - 1;
  context.observer.on_row({"accuracy",
                           {{"level", std::to_string(number)},
                            {"degree", std::to_string(level.mesh.degree)},
                            {"cells", std::to_string(level.n_cells)},
                            {"unknowns", std::to_string(level.n_unknowns)},
                            {"seconds", exact_text(seconds)},
                            {quantity, exact_text(level.value)},
                            {"estimated_relative_error", exact_text(relative_error())}}});
  char line[200];
  if (number == 0)
  {
    std::snprintf(line, sizeof(line), "level degree   cells unknowns  seconds  %-22s estimated error",
                  quantity.c_str());
    context.observer.on_message(line);
  }
  std::snprintf(line, sizeof(line), "%5d %6u %7zu %8zu %8.2f  %-22.14g %.1e", number, level.mesh.degree, level.n_cells,
                level.n_unknowns, seconds, level.value, relative_error());
  context.observer.on_message(line);
}
} // namespace pellicle
