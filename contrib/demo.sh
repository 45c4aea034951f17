#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs missing packages, builds, and computes the shape of a red blood cell: the Helfrich minimum at reduced volume 0.65.
# shellcheck source=contrib/utilities/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/utilities/common.sh"

usage()
{
  cat <<END
Usage: ./contrib/demo.sh [--jobs N]
  --jobs N     compile with N processes (default: number of processors)
END
}

jobs=$(nproc)
while (($# > 0)); do
  case $1 in
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

step "Packages"
./contrib/setup_packages.sh
configure_and_build release "$jobs" applications

output=build/demo/discocyte
step "Computing the discocyte (scene prm/vesicle/discocyte.prm, results in $output)"
rm -rf "$output"
build/release/bin/vesicle prm/vesicle/discocyte.prm --output-directory "$output"

step "Result"
python3 - "$output" <<'END'
import json
import os
import sys

directory = sys.argv[1]
with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
    summary = json.load(file)
if summary["status"] != "converged":
    sys.exit(f"The run ended with status '{summary['status']}'.")

# An independent axisymmetric computation of the same branch; a hundredth off it is another shape, not another mesh.
reference = 1.8262334456
energy = summary["quantities"]["bending_energy_over_8_pi_kappa"]
difference = energy / reference - 1
print(f"bending energy / (8 pi kappa)  {energy:.10f}")
print(f"axisymmetric reference         {reference:.10f}")
print(f"relative difference            {difference:.1e}")
print(f"seconds                        {summary['seconds']['total']:.1f}")
if abs(difference) > 1e-2:
    sys.exit("This is not the discocyte: the energy is more than 1 % off the reference.")

picture = os.path.join(directory, "picture.png")
if not os.path.isfile(picture):
    sys.exit(f"The run left no picture: {picture} is missing.")
print(f"picture                        {picture}")
END
