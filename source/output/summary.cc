// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/base/version.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/summary.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace pellicle
{
namespace
{
using Json = nlohmann::ordered_json;

/** Puts numbers into JSON objects and remembers which ones could not be put. */
class FiniteNumbers
{
public:
  explicit FiniteNumbers(std::vector<std::string> &warning_list)
      : warnings(warning_list)
  {
  }

  /** `name` is how a warning calls the number; object[key] = value if it is finite. */
  void put(Json &object, const std::string &key, const double value, const std::string &name)
  {
    if (accept(value, name))
      object[key] = value;
  }

  /** True for finite values; otherwise a warning is noted. */
  bool accept(const double value, const std::string &name)
  {
    if (std::isfinite(value))
      return true;
    warnings.push_back("'" + name + "' is not finite (" + (std::isnan(value) ? "nan" : (value > 0. ? "inf" : "-inf")) +
                       ") and was left out");
    return false;
  }

private:
  std::vector<std::string> &warnings;
};

Json newton_object(const NewtonCounts &newton, const bool has_run, FiniteNumbers &numbers)
{
  Json object = {{"steps", newton.steps}, {"iterations", newton.iterations}, {"rejected", newton.rejected}};
  // Before the first iteration there is no residual, which is nothing to warn of.
  if (has_run)
    numbers.put(object, "final_relative_residual", newton.final_relative_residual, "newton/final_relative_residual");
  return object;
}

Json seconds_object(const RunSeconds &seconds, FiniteNumbers &numbers)
{
  Json object = Json::object();
  numbers.put(object, "total", seconds.total, "seconds/total");
  numbers.put(object, "assembly", seconds.assembly, "seconds/assembly");
  numbers.put(object, "linear_solve", seconds.linear_solve, "seconds/linear_solve");
  numbers.put(object, "output", seconds.output, "seconds/output");
  return object;
}

Json loops_array(const std::vector<CellLoop> &loops)
{
  Json array = Json::array();
  for (const CellLoop &loop : loops)
  {
    Json terms = Json::array();
    for (const LoopTerm &term : loop.terms)
    {
      terms.push_back({{"name", term.name}, {"kind", kind_name(term.kind)}, {"fields", term.fields}});
      if (!term.region.empty())
        terms.back()["region"] = term.region;
    }
    array.push_back({{"over", loop.over}, {"cells", loop.n_cells}, {"points", loop.n_points}, {"terms", terms}});
  }
  return array;
}

Json linear_solver_object(const LinearSolverReport &report, FiniteNumbers &numbers)
{
  Json object = {{"name", report.name}};
  numbers.put(object, "condition_estimate", report.conditioning.condition_estimate, "linear_solver/condition_estimate");
  numbers.put(object, "smallest_pivot", report.conditioning.smallest_pivot, "linear_solver/smallest_pivot");
  numbers.put(object, "largest_pivot", report.conditioning.largest_pivot, "linear_solver/largest_pivot");
  if (report.negative_pivots)
    object["negative_pivots"] = *report.negative_pivots;
  return object;
}

Json stability_object(const StabilityCounts &stability, FiniteNumbers &numbers)
{
  Json lowest = Json::array();
  for (const double eigenvalue : stability.lowest)
    if (numbers.accept(eigenvalue, "stability/lowest"))
      lowest.push_back(eigenvalue);
  return {{"negative_eigenvalues", stability.negative_eigenvalues}, {"lowest", lowest}};
}
} // namespace

const char *status_name(const RunStatus status)
{
  switch (status)
  {
  case RunStatus::converged:
    return "converged";
  case RunStatus::failed:
    return "failed";
  case RunStatus::refused:
    return "refused";
  case RunStatus::target_not_met:
    return "target_not_met";
  }
  PELLICLE_ASSERT(false, "a status without a name");
  return "failed";
}

std::string summary_text(const RunResult &result)
{
  std::vector<std::string> warnings = result.warnings;
  FiniteNumbers numbers(warnings);

  Json summary;
  summary["application"] = result.application;
  summary["version"]     = version();
  summary["status"]      = status_name(result.status);
  if (!result.message.empty())
    summary["message"] = result.message;
  summary["effects"]  = result.effects;
  summary["analyses"] = result.analyses;
  summary["warnings"] = Json::array(); // keeps its place; filled last, when all numbers have been looked at

  summary["mesh"] = {{"cells", result.n_cells}, {"degree", result.degree}};

  Json &unknowns = summary["unknowns"] = {{"total", result.unknowns.total}};
  for (const auto &[name, count] : result.unknowns.blocks)
    unknowns[name] = count;
  if (result.unknowns.matrix_entries > 0)
    summary["matrix"] = {{"entries", result.unknowns.matrix_entries}};
  if (!result.loops.empty())
    summary["loops"] = loops_array(result.loops);

  const bool has_run = result.newton.iterations > 0;
  summary["newton"]  = newton_object(result.newton, has_run, numbers);
  summary["seconds"] = seconds_object(result.seconds, numbers);
  if (result.linear_solver)
    summary["linear_solver"] = linear_solver_object(*result.linear_solver, numbers);
  if (result.stability)
    summary["stability"] = stability_object(*result.stability, numbers);

  Json quantities = Json::object();
  for (const auto &[name, value] : result.quantities)
    numbers.put(quantities, name, value, name);
  summary["quantities"] = quantities;
  summary["warnings"]   = warnings;

  // Bytes that are not UTF-8 (file names can hold any) are replaced rather than refused: the summary must be written.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path &directory, const RunResult &result)
{
  write_whole_file(directory / "summary.json", summary_text(result));
}
} // namespace pellicle
