// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/checkpoint_files.h>
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

bool is_solution_file(const std::string &name)
{
  return is_file_of_a_step(name, "solution_") || is_file_of_a_step(name, "substrate_");
}

bool is_result_file(const std::string &name)
{
  for (const char *result :
       {"summary.json", "history.csv", "convergence.csv", "accuracy.csv", "branch.csv", "phase_diagram.csv",
        "defects.csv", "solution.pvd", "picture.png", "picture.vtu", "picture_body.vtu"})
    if (name == result)
      return true;
  return false;
}

/** Of a result file that is not whole yet. */
bool is_unfinished_result(const std::string &name)
{
  const std::filesystem::path path(name);
  const std::string whole = path.stem().string();
  return is_unfinished_file(path) && (is_result_file(whole) || is_solution_file(whole) || whole == "used.prm");
}

template <typename IsOutdated>
void remove_files(const std::filesystem::path &directory, const IsOutdated &is_outdated)
{
  std::vector<std::filesystem::path> outdated;
  std::error_code ignored; // what cannot be listed or removed shows when the run writes its own files
  for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
    if (is_outdated(entry.path().filename().string()))
      outdated.push_back(entry.path());
  for (const auto &path : outdated)
    std::filesystem::remove(path, ignored);
}
} // namespace

void prepare_output_directory(const std::filesystem::path &directory)
{
  prepare_continued_directory(directory);
  remove_solutions(directory, {});
  remove_checkpoints(directory);
}

void prepare_continued_directory(const std::filesystem::path &directory)
{
  make_directory(directory);
  remove_files(directory, [](const std::string &name) { return is_result_file(name) || is_unfinished_result(name); });
}

void remove_solutions(const std::filesystem::path &directory, const std::set<std::string> &keep)
{
  remove_files(directory,
               [&](const std::string &name) { return is_solution_file(name) && keep.find(name) == keep.end(); });
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

void RunFiles::exchange(Archive &archive)
{
  archive.name("tables");
  archive | history | convergence;
  std::vector<std::string> names;
  for (const auto &[name, table] : tables)
    names.push_back(name);
  archive | names;
  for (const std::string &name : names)
  {
    check_file_name(name);
    archive | tables.try_emplace(name, directory / (name + ".csv")).first->second;
  }
}
} // namespace pellicle
