#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What effects cost: unknowns, loops, matrix entries and seconds of scenes with and without them.

    contrib/effects_cost/run.py --bin build/release/bin --document doc/effects.md

runs every pair of pairs.py, the two scenes in turn, and renews the table between the marks in the document. Exit status: 0 done; 1 a scene was refused; 2 bad
command line.
"""

import argparse
import csv
import json
import statistics
import sys
import tempfile
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "contrib" / "work_precision"))
from measure import RunFailed, timed
from pairs import PAIRS
from report import machine, markdown_table
from table import BEGIN, END, HEAD, renewed, row


class Scenes:
    """The applications in one folder; what a scene's run tells."""

    def __init__(self, binaries):
        self.binaries = binaries.resolve()

    def run(self, application, effects, assignments):
        """Summary of a run, with "seconds per iteration" added. An equilibrium need not be found, iterations need be made."""
        with tempfile.TemporaryDirectory(prefix="effects_cost_") as name:
            folder = Path(name)
            (folder / "scene.prm").write_text(f"set Effects = {', '.join(effects)}\n", encoding="utf-8")
            overrides = ("Output/Picture=false", "Output/Solution=false", *assignments)
            command = [self.binaries / application, folder / "scene.prm", "--quiet", "--output-directory", folder / "run"]
            status, output, _, _ = timed([*command, *(word for o in overrides for word in ("--set", o))], folder)
            if status not in (0, 1):
                raise RunFailed(" ".join(output.split())[-400:])
            summary = json.loads((folder / "run" / "summary.json").read_text(encoding="utf-8"))
            with open(folder / "run" / "convergence.csv", newline="", encoding="utf-8") as file:
                seconds = [float(line["seconds"]) for line in csv.DictReader(file)]
            if not seconds:
                raise RunFailed("no iteration was made: " + summary.get("message", ""))
            return {**summary, "seconds per iteration": statistics.median(seconds)}


def measure(scenes, pair, repeats):
    """Summaries of the scene with the effect and without it (None: there is no such scene), with medians of the seconds; runs take turns."""
    with_it, without_it = [], []
    for _ in range(repeats):
        if pair.alone:
            without_it.append(scenes.run(pair.application_without or pair.application, pair.without_it, pair.common))
        with_it.append(scenes.run(pair.application, pair.with_it, (*pair.common, *pair.own)))

    def median(runs):
        return {**runs[0], "seconds per iteration": statistics.median(r["seconds per iteration"] for r in runs)}

    return median(with_it), median(without_it) if without_it else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=ROOT / "build/release/bin", type=Path, help="folder of the applications (build/release/bin)")
    parser.add_argument("--document", type=Path, help="document whose table is renewed; without it the table is printed")
    parser.add_argument("--effects", nargs="+", metavar="EFFECT", help="these alone; for looking, not for the document")
    parser.add_argument("--repeats", type=int, default=2, help="runs of each scene (2)")
    options = parser.parse_args()
    scenes, rows, failures = Scenes(options.bin), [], 0
    for pair in PAIRS:
        if options.effects and pair.effect not in options.effects:
            continue
        try:
            rows.append(row(pair, *measure(scenes, pair, options.repeats)))
            print(" | ".join(rows[-1]), file=sys.stderr, flush=True)
        except (RunFailed, OSError) as failure:
            failures += 1
            print(f"{pair.application}, {pair.effect}: {failure}", file=sys.stderr, flush=True)
    table = [f"Measured on {date.today().isoformat()} ({machine()}), medians of {options.repeats} runs of each scene, in turn.", "", *markdown_table(HEAD, rows)]
    text = "\n".join([BEGIN, *table]).rstrip() + "\n" + END
    if options.document and not failures and not options.effects:
        options.document.write_text(renewed(options.document.read_text(encoding="utf-8"), text), encoding="utf-8")
    else:
        print(text)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
