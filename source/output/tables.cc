// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/tables.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

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
  const ssize_t written = ::write(descriptor, line.data(), line.size());
  if (written != static_cast<ssize_t>(line.size()))
    throw cannot_write(path, written < 0 ? errno : ENOSPC);
}

void LineFile::replace(const std::string &text)
{
  write_whole_file(path, text);
  open(0);
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
  {
    std::string text = csv_line(columns);
    for (const Row &earlier : rows)
      text += line_of(earlier);
    file.replace(text);
  }
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
