#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the hard cases of cases.json, each judged by its own criteria.

    python3 contrib/hard_cases/run.py --binaries build/release/bin [--case NAME ...] [--label default|long] [--write]

A case is a scene of prm/hard, whose first line names the application. ctest runs each case by its name (tests/hard); with
--write the rows of doc/stability.md are made anew from the results, so that table and tests cannot differ.
Exit status: 0 all cases came out as the list says; 1 some did not (the names of what failed are printed); 2 bad command
line or list.
"""

import argparse
import sys
from pathlib import Path

from checks import failures
from runs import load_cases, run_case
from table import write_table

ROOT = Path(__file__).resolve().parents[2]


def judge(case, run):
    """What is wrong with the outcome, as a list of messages. A case that is known to fail must fail."""
    found = failures(case, run)
    reason = case.get("known_failure")
    if not reason:
        return found
    return [] if found else [f"{case['name']} was listed as failing ({reason}) and passes: take it off the list"]


def main():
    parser = argparse.ArgumentParser(description="Runs the hard cases.")
    parser.add_argument("--binaries", type=Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--case", action="append", help="only this one; may be repeated")
    parser.add_argument("--label", choices=("default", "long"), help="only cases with this label")
    parser.add_argument("--write", action="store_true", help="write the rows of doc/stability.md")
    arguments = parser.parse_args()

    cases = load_cases(ROOT)
    unknown = set(arguments.case or []) - {case["name"] for case in cases}
    if unknown:
        parser.error(f"there is no case {', '.join(sorted(unknown))}; there are {', '.join(case['name'] for case in cases)}")
    chosen = [case for case in cases if (not arguments.case or case["name"] in arguments.case)
              and (not arguments.label or case["label"] == arguments.label)]

    wrong, results = [], []
    for case in chosen:
        run = run_case(case, arguments.binaries, ROOT)
        found = judge(case, run)
        print(f"{case['name']}: {'as expected' if not found else 'NOT as expected'}, {run.cpu_seconds:.1f} s", flush=True)
        for message in found:
            print(f"  {message}", flush=True)
        wrong += found
        results.append((case, run))
    if arguments.write:
        write_table(ROOT / "doc" / "stability.md", [case["name"] for case in cases], results)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
