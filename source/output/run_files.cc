// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/run_files.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>
#include <vector>

namespace pellicle
{
namespace
{
/** solution_0012.vtu and the like. */
bool is_file_of_a_step(const std::string &name, const std::string &prefix)
{
  const std::string suffix = ".vtu";
  if (name.size() <= prefix.size() + suffix.size() || name.compare(0, prefix.size(), prefix) != 0 ||
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
    return false;
  return std::all_of(name.begin() + prefix.size(), name.end() - suffix.size(),
                     [](const unsigned char c) { return std::isdigit(c) != 0; });
}

bool is_result_file(const std::string &name)
{
  for (const char *result : {"summary.json", "history.csv", "convergence.csv", "accuracy.csv", "branch.csv",
                             "phase_diagram.csv", "defects.csv", "solution.pvd", "picture.png"})
    if (name == result)
      return true;
  return is_file_of_a_step(name, "solution_") || is_file_of_a_step(name, "substrate_");
}
} // namespace

void prepare_output_directory(const std::filesystem::path &directory)
{
  make_directory(directory);
  std::vector<std::filesystem::path> outdated;
  std::error_code ignored; // what cannot be listed or removed shows when the run writes its own files
  for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
    if (is_result_file(entry.path().filename().string()))
      outdated.push_back(entry.path());
  for (const auto &path : outdated)
    std::filesystem::remove(path, ignored);
}

RunFiles::RunFiles(const std::filesystem::path &directory)
    : directory(directory)
    , history(directory / "history.csv")
    , convergence(directory / "convergence.csv")
{
}

void RunFiles::on_iteration(const IterationReport &report)
{
  convergence.append(report);
}

void RunFiles::on_row(const TableRow &row)
{
  const auto table = tables.try_emplace(row.table, directory / (row.table + ".csv")).first;
  table->second.append(row.fields);
}

void RunFiles::on_step(const StepReport &report)
{
  history.append(history_row(report));
}
} // namespace pellicle
