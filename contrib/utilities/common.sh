# SPDX-License-Identifier: LGPL-2.1-or-later
# shellcheck shell=bash
# What demo.sh and test.sh share; they source it. Leaves the shell in the project's root.

set -Eeuo pipefail
script=$0

# Says which line failed: errexit alone would end the script without a word.
report_failure()
{
  local status=$? where=$1 command=$2
  printf '\n%s failed: exit status %s at %s: %s\n' "$script" "$status" "$where" "${command%%$'\n'*}" >&2
  exit "$status"
}
trap 'report_failure "${BASH_SOURCE[0]}:$LINENO" "$BASH_COMMAND"' ERR

step()
{
  printf '== %s\n' "$*"
}

bad_usage()
{
  printf '%s: %s\nTry %s --help.\n' "$script" "$1" "$script" >&2
  exit 2
}

# check_jobs N: the argument of --jobs.
check_jobs()
{
  [[ $1 =~ ^[1-9][0-9]*$ ]] || bad_usage "--jobs $1: a whole number >= 1 is needed"
}

# configure_and_build PRESET JOBS [TARGET ...]: CMake and Ninja redo only what is out of date.
configure_and_build()
{
  local preset=$1 jobs=$2
  shift 2
  step "Configuring (preset $preset)"
  cmake --preset "$preset" --log-level=WARNING >/dev/null
  step "Building ${*:-everything} in build/$preset with $jobs jobs"
  cmake --build --preset "$preset" --parallel "$jobs" ${@+--target "$@"}
}

cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Open MPI refuses to start for root unless told twice.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# For programs built with sanitizers: what libraries beneath MPI keep until the process ends is no leak of ours.
export LSAN_OPTIONS=suppressions=$PWD/contrib/utilities/leaks.supp:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1
