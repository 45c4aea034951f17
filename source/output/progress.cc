// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/progress.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace pellicle
{
namespace
{
/** A line that is rewritten must not wrap, or the carriage return would go to its last part only. */
constexpr std::size_t terminal_width = 79;

double steady_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <typename... Values>
std::string formatted(const char *const format, const Values... values)
{
  char buffer[160];
  std::snprintf(buffer, sizeof(buffer), format, values...);
  return buffer;
}
} // namespace

bool standard_output_is_terminal()
{
  return ::isatty(STDOUT_FILENO) == 1;
}

std::string duration_text(const double seconds)
{
  if (!(seconds < 1e8)) // nan and nonsense included
    return "long";
  if (seconds < 9.95)
    return formatted("%.1f s", std::max(seconds, 0.));
  const long whole = std::lround(seconds);
  if (whole < 60)
    return formatted("%ld s", whole);
  if (whole < 3600)
    return formatted("%ld min %ld s", whole / 60, whole % 60);
  return formatted("%ld h %ld min", whole / 3600, whole % 3600 / 60);
}

Progress::Progress(std::ostream &stream, const Verbosity how_much, const bool terminal, Clock seconds)
    : out(stream)
    , verbosity(how_much)
    , in_terminal(terminal)
    , clock(seconds ? std::move(seconds) : Clock(&steady_seconds))
    , start(clock())
{
}

Progress::~Progress()
{
  if (n_shown > 0)
    out << '\n' << std::flush;
}

double Progress::elapsed() const
{
  return clock() - start;
}

std::string Progress::time_text() const
{
  std::string text = duration_text(elapsed());
  // Steps differ; below a percent the estimate says nothing.
  if (in_terminal && fraction_done > 0.01 && fraction_done < 1.)
    text += ", about " + duration_text(elapsed() * (1. - fraction_done) / fraction_done) + " left";
  return text;
}

void Progress::rewrite(const std::string &line)
{
  const std::string shown = line.substr(0, terminal_width);
  const std::size_t blank = n_shown > shown.size() ? n_shown - shown.size() : 0;
  out << '\r' << shown << std::string(blank, ' ') << std::flush;
  n_shown = shown.size();
}

void Progress::write(const std::string &line)
{
  if (n_shown > 0)
    out << '\r' << std::string(n_shown, ' ') << '\r';
  n_shown = 0;
  out << line << '\n' << std::flush;
}

void Progress::on_iteration(const IterationReport &report)
{
  if (verbosity == Verbosity::verbose)
    write(formatted("  iteration %3d  relative residual %9.3e  step length %9.3e  energy %.12g  rejected %d",
                    report.iteration, report.relative_residual, report.step_length, report.energy, report.rejected));
  else if (verbosity == Verbosity::normal && in_terminal)
    rewrite(formatted("step %d, iteration %d, relative residual %.1e, ", report.step, report.iteration,
                      report.relative_residual) +
            time_text());
}

void Progress::on_step(const StepReport &report)
{
  fraction_done = report.fraction_done;
  if (verbosity == Verbosity::quiet)
    return;
  std::string line = formatted("step %d: ", report.step);
  for (const auto &[name, value] : report.stepped)
    line += name + formatted(" = %.6g, ", value);
  line += formatted("%d %s, ", report.iterations, report.iterations == 1 ? "iteration" : "iterations");
  write(line + time_text());
}

void Progress::on_message(const std::string &text)
{
  if (verbosity != Verbosity::quiet)
    write(text);
}
} // namespace pellicle
