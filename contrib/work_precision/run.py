#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work-precision study: what accuracy costs in time, by case, degree and refinement.

    contrib/work_precision/run.py --bin build/release/bin --output doc --evolver

writes work_precision.csv, .svg and .md (the document) into the output folder. Needs the Debian packages python3-numpy and python3-matplotlib; Surface Evolver
(--evolver) is the package evolver-nox. Exit status: 0 done; 1 a run that must succeed failed; 2 bad command line.
"""

import argparse
import sys
import time
from pathlib import Path

import evolver
import plot
import report
from cases import CASES
from measure import Pellicle, RunFailed

ROOT = Path(__file__).resolve().parents[2]


def settings_of(case, quick):
    return [s for s in case.settings if not quick or s.name in case.quick]


def study(cases, pellicle, repeats, quick, with_evolver):
    """All measurements, and what failed: (case, setting, reason)."""
    measurements, failures = [], []

    def attempt(case, name, run):
        try:
            measurements.append(run())
            m = measurements[-1]
            print(f"{case.name:12} {name:24} error {m.error:8.1e}  {m.seconds:7.3f} s  start-up {m.start_up:.2f} s  {m.repeats} runs", flush=True)
        except RunFailed as failure:
            reason = " ".join(str(failure).split())
            failures.append((case.name, name, reason[:200]))
            print(f"{case.name:12} {name:24} failed: {reason}", flush=True)

    for case in cases:
        for setting in settings_of(case, quick):
            if pellicle.offers(case.program, setting):
                attempt(case, setting.name, lambda c=case, s=setting: pellicle.measure(c, s, repeats))
        if with_evolver and case.evolver:
            problem = evolver.PROBLEMS[case.evolver]
            for model, r in problem.quick if quick else problem.levels:
                attempt(case, f"Evolver {model} r{r}", lambda c=case, m=model, n=r: evolver.measure(c, m, n, repeats))
    return measurements, failures


def arguments():
    names = [case.name for case in CASES]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=ROOT / "build/release/bin", type=Path, help="folder of the applications (build/release/bin)")
    parser.add_argument("--output", required=True, type=Path, help="folder for work_precision.csv, .svg and .md")
    parser.add_argument("--cases", nargs="+", choices=names, default=names, metavar="CASE", help="of " + ", ".join(names))
    parser.add_argument("--repeats", type=int, default=3, help="runs of a setting (3); fewer where they take seconds")
    parser.add_argument("--quick", action="store_true", help="a few coarse settings of each case, under a minute")
    parser.add_argument("--evolver", action="store_true", help="Surface Evolver on the same cases")
    parser.add_argument("--from", dest="table", type=Path, metavar="CSV", help="no runs: write document and picture anew from a table")
    return parser.parse_args()


def main():
    options = arguments()
    cases = [case for case in CASES if case.name in options.cases]
    options.output.mkdir(parents=True, exist_ok=True)
    start, failures = time.monotonic(), []
    if options.table:
        measurements = report.read_csv(options.table)
    else:
        with_evolver = options.evolver and evolver.is_installed()
        if options.evolver and not with_evolver:
            print(evolver.MISSING, file=sys.stderr)
        try:
            measurements, failures = study(cases, Pellicle(options.bin, ROOT / "prm"), options.repeats, options.quick, with_evolver)
        except (RunFailed, OSError) as error:
            print(f"The programs in {options.bin} do not run: {error}", file=sys.stderr)
            return 1
        report.write_csv(measurements, options.output / "work_precision.csv")
    if not measurements:
        print("Nothing was measured.", file=sys.stderr)
        return 1
    plot.draw(cases, measurements, options.output / "work_precision.svg")
    command = "contrib/work_precision/run.py --bin build/release/bin --output doc --evolver"
    (options.output / "work_precision.md").write_text(report.document(cases, measurements, failures, "work_precision.svg", command), encoding="utf-8")
    print(f"{len(measurements)} measurements in {time.monotonic() - start:.0f} s; {len(failures)} without result; see {options.output / 'work_precision.md'}")
    return 1 if failures and options.quick else 0


if __name__ == "__main__":
    sys.exit(main())
