#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the Debian 12 packages that Pellicle needs; only those that are missing, so that it costs nothing when repeated.
# With --long also those that only ./contrib/test.sh --long and ./contrib/fuzz.sh need.
set -euo pipefail

packages=(
  # build
  g++ cmake ninja-build git ccache
  # libraries (those of the first line come with deal.II; our own CMake files look for them too)
  libdeal.ii-dev libmumps-dev libsuitesparse-dev libarpack2-dev libsundials-dev libtbb-dev libtrilinos-sacado-dev libmuparser-dev
  libeigen3-dev nlohmann-json3-dev libcli11-dev libginac-dev
  # factorisations run 3 to 5 times faster than with the reference BLAS
  libopenblas0-pthread
  # parallel runs
  mpi-default-dev mpi-default-bin
  # pictures
  python3 python3-vtk9 xvfb xauth python3-matplotlib
  # tests
  libgtest-dev clang-format-14
)
if [[ ${1:-} == --long ]]; then
  # sanitizers and fuzzers; llvm-14 has the names of functions in their reports
  packages+=(clang-14 libclang-rt-14-dev llvm-14)
fi

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "Packages are installed on Debian only. Elsewhere provide what contrib/setup_packages.sh lists, then build with CMake." >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "All ${#packages[@]} packages are installed."
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "Packages are missing and there is neither root nor sudo. As root: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 --quiet)
echo "Installing: ${missing[*]}"
"${apt[@]}" update
"${apt[@]}" install --yes --no-install-recommends "${missing[@]}"
