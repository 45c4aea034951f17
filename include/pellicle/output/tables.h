// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
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

  /** Appends one line that ends in a line feed. Throws WriteError when the file takes no more; it then ends with the
   * line before. */
  void append(const std::string &line);
  /** Replaces the whole content at once; appending goes on behind it. */
  void replace(const std::string &text);
  /** All lines so far. Throws WriteError if the file is not what was written to it. */
  std::string content() const;

private:
  void open(int extra_flags);

  std::filesystem::path path;
  int descriptor     = -1;
  std::size_t length = 0;
};

/** `convergence.csv`: one row per accepted Newton iteration. */
class ConvergenceTable
{
public:
  explicit ConvergenceTable(const std::filesystem::path &path);
  void append(const IterationReport &report);
  /** The rows; those that are read take the place of what is in the file. */
  void exchange(Archive &archive);

private:
  LineFile file;
};

/**
 * A table that grows by rows of named fields. The first row fixes the columns; a column that turns up later becomes the
 * last one and the file is rewritten with empty fields above it. A column that is missing in a row leaves its field
 * empty.
 */
class GrowingTable
{
public:
  using Row = std::vector<std::pair<std::string, std::string>>; ///< column, field

  explicit GrowingTable(const std::filesystem::path &path);
  void append(Row row);
  /** The rows; those that are read take the place of what is in the file. */
  void exchange(Archive &archive);

private:
  std::string line_of(const Row &row) const;
  void rewrite();

  LineFile file;
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/** Row of `history.csv`: step, what load stepping has changed, each under its name, the quantities. */
GrowingTable::Row history_row(const StepReport &report);
} // namespace pellicle
