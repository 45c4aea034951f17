// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/output/program.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <thread>

namespace pellicle
{
namespace
{
using SteadyClock = std::chrono::steady_clock;

/** Waits for the child until the given moment. True if it ended. */
bool wait_until(const pid_t child, const SteadyClock::time_point deadline, int &status)
{
  auto pause = std::chrono::milliseconds(1);
  while (true)
  {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR))
      return true;
    if (SteadyClock::now() >= deadline)
      return false;
    std::this_thread::sleep_for(pause);
    if (pause < std::chrono::milliseconds(20))
      pause *= 2;
  }
}

/** Ends a process group, first politely, so that a virtual display takes its lock file away. */
void end_group(const pid_t group, int &status)
{
  ::kill(-group, SIGTERM);
  if (!wait_until(group, SteadyClock::now() + std::chrono::seconds(2), status))
  {
    ::kill(-group, SIGKILL);
    ::waitpid(group, &status, 0);
  }
  ::kill(-group, SIGKILL); // children that outlived the leader
}

std::string read_from_start(const int descriptor)
{
  std::string text;
  char buffer[4096];
  ::lseek(descriptor, 0, SEEK_SET);
  for (ssize_t n = ::read(descriptor, buffer, sizeof(buffer)); n > 0; n = ::read(descriptor, buffer, sizeof(buffer)))
    text.append(buffer, static_cast<std::size_t>(n));
  return text;
}

/** The environment without what an MPI launcher put there. */
std::vector<std::string> environment_outside_mpi()
{
  std::vector<std::string> kept;
  for (char **entry = environ; *entry != nullptr; ++entry)
  {
    bool of_launcher = false;
    for (const char *prefix : {"OMPI_", "PMIX_", "PMI_", "PRTE_"})
      of_launcher = of_launcher || std::strncmp(*entry, prefix, std::strlen(prefix)) == 0;
    if (!of_launcher)
      kept.emplace_back(*entry);
  }
  return kept;
}

std::vector<char *> pointers_to(std::vector<std::string> &texts)
{
  std::vector<char *> pointers;
  for (std::string &text : texts)
    pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}
} // namespace

ProgramEnd run_program(const std::vector<std::string> &command, const double timeout_seconds)
{
  ProgramEnd end;
  // A file rather than a pipe: nothing blocks, and a display server that keeps it open does no harm.
  std::FILE *const log = std::tmpfile();
  if (log == nullptr)
    return end;

  // Everything that allocates happens before the fork: afterwards the child may only call what is safe in a signal
  // handler.
  std::vector<std::string> arguments = command, variables = environment_outside_mpi();
  const std::vector<char *> argv = pointers_to(arguments), envp = pointers_to(variables);
  const int log_descriptor = ::fileno(log);

  const pid_t child = ::fork();
  if (child == 0)
  {
    ::setpgid(0, 0);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(log_descriptor, STDOUT_FILENO);
    ::dup2(log_descriptor, STDERR_FILENO);
    ::execve(argv[0], argv.data(), envp.data());
    ::_exit(127);
  }
  if (child > 0)
  {
    ::setpgid(child, child); // also here, as either side may be first
    end.started = true;
    int status  = 0;
    const auto limit =
        std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(timeout_seconds));
    end.timed_out = !wait_until(child, SteadyClock::now() + limit, status);
    if (end.timed_out)
      end_group(child, status);
    else if (WIFEXITED(status))
      end.exit_status = WEXITSTATUS(status);
    end.output = read_from_start(log_descriptor);
  }
  std::fclose(log);
  return end;
}
} // namespace pellicle
