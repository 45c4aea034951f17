// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/** A short decimal text that reads back to the same double; "nan", "inf", "-inf" where needed. */
std::string number_text(double value);

/** A CSV field (RFC 4180): in double quotes, with quotes inside doubled, if it holds a comma, a quote or a line break.
 */
std::string csv_field(const std::string &text);

/** The fields, quoted where needed, with commas between them and a line feed at the end. */
std::string csv_line(const std::vector<std::string> &fields);

/** A file that grows by whole lines: each is one write call on a file opened for appending, so a reader never sees half
 * a line. */
class LineFile
{
public:
  /** Starts an empty file, whatever stood there. Throws UserError with path and reason. */
  explicit LineFile(const std::filesystem::path &path);
  ~LineFile();
  LineFile(const LineFile &)            = delete;
  LineFile &operator=(const LineFile &) = delete;

  /** Appends one line that ends in a line feed. Throws UserError when the file takes no more. */
  void append(const std::string &line);
  /** Replaces the whole content at once; appending goes on behind it. */
  void replace(const std::string &text);

private:
  void open(int extra_flags);

  std::filesystem::path path;
  int descriptor = -1;
};

/** `convergence.csv`: one row per accepted Newton iteration. */
class ConvergenceTable
{
public:
  explicit ConvergenceTable(const std::filesystem::path &path);
  void append(const IterationReport &report);

private:
  LineFile file;
};

/**
 * `history.csv`: one row per step. Columns: step, the stepped parameter under its name (if a parameter is stepped), the
 * quantities. The first row fixes the columns; a quantity that turns up later gets a new last column and the file is
 * rewritten with empty fields above it. A quantity that is missing in a row leaves its field empty.
 */
class HistoryTable
{
public:
  explicit HistoryTable(const std::filesystem::path &path);
  void append(const StepReport &report);

private:
  using Row = std::vector<std::pair<std::string, std::string>>; // column, field

  std::string line_of(const Row &row) const;

  LineFile file;
  std::vector<std::string> columns;
  std::vector<Row> rows;
};
} // namespace pellicle
