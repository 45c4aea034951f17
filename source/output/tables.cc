// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/tables.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>

namespace pellicle
{
std::string number_text(const double value)
{
  return std::isnan(value) ? "nan" : exact_text(value); // the sign of nan means nothing
}

std::string csv_field(const std::string &text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_line(const std::vector<std::string> &fields)
{
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    line += (i > 0 ? "," : "") + csv_field(fields[i]);
  return line + '\n';
}

LineFile::LineFile(const std::filesystem::path &file_path)
    : path(file_path)
{
  open(O_TRUNC);
}

LineFile::~LineFile()
{
  if (descriptor >= 0)
    ::close(descriptor);
}

void LineFile::open(const int extra_flags)
{
  if (descriptor >= 0)
    ::close(descriptor);
  descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | extra_flags, 0666);
  if (descriptor < 0)
    throw cannot_write(path, errno);
}

void LineFile::append(const std::string &line)
{
  // One call writes the line, unless there is no room for all of it; the second one then says why.
  for (std::size_t done = 0; done < line.size();)
  {
    const ssize_t n = ::write(descriptor, line.data() + done, line.size() - done);
    if (n < 0 && errno != EINTR)
    {
      const int reason                      = errno;
      [[maybe_unused]] const int taken_back = ::ftruncate(descriptor, static_cast<off_t>(length));
      throw cannot_write(path, reason);
    }
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  length += line.size();
}

void LineFile::replace(const std::string &text)
{
  write_whole_file(path, text);
  open(0);
  length = text.size();
}

std::string LineFile::content() const
{
  std::ifstream in(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (text.size() != length)
    throw WriteError(
        "The table '" + path.string() + "' has " + std::to_string(text.size()) + " bytes, and " +
        std::to_string(length) +
        " were written to it: somebody else writes to it. Give each run an --output-directory of its own.");
  return text;
}

ConvergenceTable::ConvergenceTable(const std::filesystem::path &path)
    : file(path)
{
  file.append("step,iteration,relative_residual,step_length,energy,rejected,seconds\n");
}

void ConvergenceTable::append(const IterationReport &report)
{
  file.append(csv_line({std::to_string(report.step), std::to_string(report.iteration),
                        number_text(report.relative_residual), number_text(report.step_length),
                        number_text(report.energy), std::to_string(report.rejected), number_text(report.seconds)}));
}

void ConvergenceTable::exchange(Archive &archive)
{
  std::string text = archive.is_reading() ? "" : file.content();
  archive | text;
  if (archive.is_reading())
    file.replace(text);
}

GrowingTable::GrowingTable(const std::filesystem::path &path)
    : file(path)
{
}

std::string GrowingTable::line_of(const Row &row) const
{
  std::vector<std::string> fields;
  for (const std::string &column : columns)
  {
    const auto entry = std::find_if(row.begin(), row.end(), [&](const auto &pair) { return pair.first == column; });
    fields.push_back(entry != row.end() ? entry->second : "");
  }
  return csv_line(fields);
}

void GrowingTable::append(Row row)
{
  const std::size_t n_columns_before = columns.size();
  for (const auto &entry : row)
    if (std::find(columns.begin(), columns.end(), entry.first) == columns.end())
      columns.push_back(entry.first);
  rows.push_back(std::move(row));

  if (columns.size() == n_columns_before)
    file.append(line_of(rows.back()));
  else
    rewrite();
}

void GrowingTable::rewrite()
{
  std::string text = columns.empty() ? "" : csv_line(columns);
  for (const Row &row : rows)
    text += line_of(row);
  file.replace(text);
}

void GrowingTable::exchange(Archive &archive)
{
  archive | columns | rows;
  if (archive.is_reading())
    rewrite();
}

GrowingTable::Row history_row(const StepReport &report)
{
  GrowingTable::Row row = {{"step", std::to_string(report.step)}};
  for (const auto &[name, value] : report.stepped)
    row.emplace_back(name, number_text(value));
  for (const auto &[name, value] : report.quantities)
    row.emplace_back(name, number_text(value));
  return row;
}
} // namespace pellicle
