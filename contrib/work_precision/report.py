# SPDX-License-Identifier: LGPL-2.1-or-later
"""All measurements as CSV, and the document."""

import csv
import os
from dataclasses import asdict, fields
from datetime import date
from pathlib import Path

import tables
from measure import Measurement
from tables import markdown_table

INTRODUCTION = """\
# What accuracy costs in time

Written by `contrib/work_precision/run.py` on {date} ({machine}); write it anew with

    {command}

or together with the costs of effects by `contrib/measure_costs.sh`.

Release build, one process at a time, one thread, no pictures and no solution files; all measurements are in `work_precision.csv` beside this file.
Seconds are medians of the repeats. For Pellicle they count from entering main (`seconds.total`); loading the program and leaving it is the
start-up, given apart: add it for the whole of a run. CPU seconds are those of the whole process. For Evolver, whose start takes milliseconds,
seconds are those of the process, and `unknowns` are its facets. Errors are relative to the references named below. A setting is, for example,
`3-D k3 r2`: degree 3, two refinements, a mesh of the whole surface in space; `octant` and `quarter` are symmetric parts of it, `axial` is a
meridian.

![Error against seconds]({picture})

## Recommended settings

The fastest setting that meets the target, as all finer ones of its degree do: energy errors of coarse meshes change their sign, and one that is
small by accident is no advice.
"""

GOALS = """\
## Goals

For meshes in space and symmetric parts of them, with the same rule.
"""

EVOLVER = """\
## Beside Surface Evolver

The same problems in the same run with the inputs in `contrib/work_precision/evolver`, by the same rule, from the same start shapes. Evolver's
meshes are of whole surfaces, the fastest of Pellicle often of a symmetric part; both are shown. The last columns are Evolver's time over that of
Pellicle's fastest, without and with Pellicle's start-up. Vesicles have linear facets and the curvature at vertices (the only kind that Evolver has
for bending), drops quadratic and Lagrange elements up to degree 8. A vesicle's Newton steps are found by line searches at first; without them finer
meshes diverge from the spheroid. Evolver is optional: `apt-get install evolver-nox`.
"""

BEST_OF_EVOLVER = """\
The smallest errors that Evolver reached here, and the fastest settings of Pellicle with errors as small:
"""

CASES = """\
## Cases

Of each case the settings on the Pareto fronts of meshes in space, of meridians and of Evolver: none of the same kind is faster and at least as
accurate.
"""


def write_csv(measurements, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, [f.name for f in fields(Measurement)], lineterminator="\n")
        table.writeheader()
        table.writerows(asdict(m) for m in measurements)


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [Measurement(**{f.name: f.type(row[f.name]) for f in fields(Measurement)}) for row in csv.DictReader(file)]


def machine():
    """Processor and number of cores, as the system tells."""
    model = "unknown processor"
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        lines = cpuinfo.read_text(encoding="utf-8").splitlines()
        model = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), model)
    return f"{model}, {os.cpu_count()} cores"


def case_section(case, own):
    """What was compared with what, and the Pareto fronts of the case."""
    reference = case.reference
    known = f"Reference {reference.value:.14g}: {reference.source}; known to {reference.accuracy:.0e}, no error is taken to be smaller."
    head = ["setting", "unknowns", "error", "seconds", "CPU", "assembly", "linear solve", "output", "start-up", "repeats"]
    return [f"### {case.title} (`{case.name}`)", "", f"{known} {case.notes}".strip(), "", *markdown_table(head, tables.fronts(own))]


def evolver_section(cases, own_of):
    head = ["case", "error", "Pellicle, whole surface", "fastest in space", "Evolver", "ratio", "with start-up"]
    best_head = ["case", "error", "Evolver", "Pellicle, in space"]
    return [
        EVOLVER,
        *markdown_table(head, tables.against_evolver(cases, own_of)),
        BEST_OF_EVOLVER,
        *markdown_table(best_head, tables.best_of_evolver(cases, own_of)),
    ]


def document(cases, measurements, failures, picture, command):
    """The text of work_precision.md. failures: (case, setting, reason)."""

    def own_of(case):
        return [m for m in measurements if m.case == case.name]

    cases = [case for case in cases if own_of(case)]
    text = [INTRODUCTION.format(date=date.today().isoformat(), machine=machine(), command=command, picture=picture)]
    text += markdown_table(["case", "mesh", *(f"{t:.0e}" for t in tables.TARGETS)], tables.recommendations(cases, own_of))
    if goals := tables.goals(measurements):
        text += [GOALS, *markdown_table(["case", "error", "goal", "fastest", ""], goals)]
    if any(m.is_evolver for m in measurements):
        text += evolver_section(cases, own_of)
    text.append(CASES)
    for case in cases:
        text += case_section(case, own_of(case))
    if failures:
        text += ["## Without a result", "", *(f"- {case}, {setting}: {reason}" for case, setting, reason in failures), ""]
    return "\n".join(text).rstrip() + "\n"
