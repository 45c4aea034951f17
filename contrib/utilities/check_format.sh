#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Fails, naming file and line, where a C++ source is not formatted as contrib/utilities/indent would.
set -euo pipefail
exec "$(dirname "$0")/indent" --dry-run --Werror
