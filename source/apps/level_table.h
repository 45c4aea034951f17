// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/apps/surface_run.h>
#include <pellicle/models/accuracy.h>

#include <string>
#include <vector>

namespace pellicle
{
/** The levels of a run to an accuracy: rows of `accuracy.csv` and lines for the user, as they come. */
class LevelTable
{
public:
  /** No relative error is estimated to be smaller: differences between levels are round-off of many cells' energies,
   * and of equilibria, there. */
  static constexpr double round_off = 2e-12;

  /** `unit`: values below it count as this large, a flat membrane has no bending energy. */
  LevelTable(const RunContext &context, std::string quantity, double unit);

  void add(const LevelRecord &level) { records.push_back(level); }
  /** Of the last level: absolute. Reports the level. */
  void set_error(double error);

  const std::vector<LevelRecord> &levels() const { return records; }
  /** Estimated errors of the levels so far, absolute. */
  std::vector<double> errors() const;
  std::vector<double> values() const;
  /** To the last level's value; round_off at least. */
  double relative(double error) const;
  /** What absolute errors are compared with: the last level's value. */
  double unit_of_errors() const;
  /** Of the last level, relative; infinite while there is no estimate. */
  double relative_error() const;

private:
  const RunContext &context;
  const std::string quantity;
  const double unit;
  std::vector<LevelRecord> records;
};
} // namespace pellicle
