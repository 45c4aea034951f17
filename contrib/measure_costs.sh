#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Renews what the documents say of times on this machine: doc/work_precision.* and the table of costs in doc/effects.md. Nothing else should run meanwhile.
#
#     contrib/measure_costs.sh [folder of the Release programs]
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
programs=${1:-$root/build/release/bin}

"$root/contrib/work_precision/run.py" --bin "$programs" --output "$root/doc" --evolver
"$root/contrib/effects_cost/run.py" --bin "$programs" --document "$root/doc/effects.md"
