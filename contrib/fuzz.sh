#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Searches for inputs that make Pellicle crash, hang or fill the memory (libFuzzer, tests/fuzz).
# shellcheck source=contrib/utilities/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/utilities/common.sh"

targets=(checkpoint command_line expression mesh model scene)

usage()
{
  cat <<END
Usage: ./contrib/fuzz.sh [--seconds N] [--build DIRECTORY] [TARGET ...]
  TARGET             ${targets[*]} (default: all)
  --seconds N        time for each target (default 360)
  --build DIRECTORY  where the fuzzers are, no building (default: build/sanitize, built if need be)
Starts from tests/fuzz/corpus/TARGET and adds to DIRECTORY/fuzz/TARGET. An input that breaks a target is written to
DIRECTORY/fuzz/findings: mend what it shows, then add it to the corpus of the target.
END
}

seconds=360
build=
chosen=()
while (($# > 0)); do
  case $1 in
    --seconds | --build)
      (($# > 1)) || bad_usage "$1 needs a value"
      if [[ $1 == --seconds ]]; then seconds=$2; else build=$2; fi
      shift
      ;;
    -h | --help)
      usage
      exit 0
      ;;
    -*) bad_usage "unknown option $1" ;;
    *)
      [[ " ${targets[*]} " == *" $1 "* ]] || bad_usage "no target $1: there are ${targets[*]}"
      chosen+=("$1")
      ;;
  esac
  shift
done
[[ $seconds =~ ^[1-9][0-9]*$ ]] || bad_usage "--seconds $seconds: a whole number >= 1 is needed"
((${#chosen[@]} > 0)) || chosen=("${targets[@]}")

if [[ -z $build ]]; then
  build=build/sanitize
  configure_and_build sanitize "$(nproc)" fuzzers
fi

mkdir -p "$build/fuzz/findings"
for target in "${chosen[@]}"; do
  step "Fuzzing: $target for $seconds s"
  mkdir -p "$build/fuzz/$target"
  case $target in
    checkpoint) words=() ;;
    model) words=(-dict=tests/fuzz/scene.dict) ;;
    *) words=(-dict="tests/fuzz/$target.dict") ;;
  esac
  "$build/tests/fuzz_$target" -max_total_time="$seconds" -max_len=4096 -timeout=60 -rss_limit_mb=2048 -verbosity=1 \
    -print_final_stats=1 "${words[@]}" -artifact_prefix="$build/fuzz/findings/$target-" \
    "$build/fuzz/$target" "tests/fuzz/corpus/$target"
done
