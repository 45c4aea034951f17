#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs missing packages, builds and runs the tests.
# shellcheck source=contrib/utilities/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/utilities/common.sh"

usage()
{
  cat <<END
Usage: ./contrib/test.sh [--quick | --long] [--jobs N]
  (no option)  tests labelled quick and default
  --quick      tests labelled quick: under 2 minutes once built
  --long       all tests, then the quick ones again with address and undefined-behaviour sanitizers, then a minute of each fuzzer
  --jobs N     compile and test with N processes (default: number of processors)
END
}

suite=default
jobs=$(nproc)
while (($# > 0)); do
  case $1 in
    --quick) suite=quick ;;
    --long) suite=long ;;
    --jobs)
      (($# > 1)) || bad_usage "--jobs needs a number"
      jobs=$2
      shift
      ;;
    --jobs=*) jobs=${1#--jobs=} ;;
    -h | --help)
      usage
      exit 0
      ;;
    *) bad_usage "unknown option $1" ;;
  esac
  shift
done
check_jobs "$jobs"

# run_tests PRESET [CTEST OPTIONS]: no tests at all is a failure, too. ctest's own summary stays the last thing on the screen.
run_tests()
{
  local preset=$1
  shift
  ctest --test-dir "build/$preset" --parallel "$jobs" --output-on-failure --no-tests=error "$@"
}

step "Packages"
packages_for=()
[[ $suite == long ]] && packages_for=(--long)
./contrib/setup_packages.sh "${packages_for[@]}"
targets=()
[[ $suite == quick ]] && targets=(quick_tests)
configure_and_build release "$jobs" "${targets[@]}"

case $suite in
  quick)
    step "Tests: label quick"
    run_tests release --label-regex '^quick$'
    ;;
  default)
    step "Tests: labels quick and default"
    run_tests release --label-regex '^(quick|default)$'
    ;;
  long)
    step "Tests: all"
    run_tests release
    configure_and_build sanitize "$jobs" quick_tests fuzzers
    step "Tests: label quick, with sanitizers"
    run_tests sanitize --label-regex '^quick$'
    step "Fuzzing"
    run_tests sanitize --label-regex '^long$' --tests-regex '^fuzzer_'
    ;;
esac
