# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the measurements: as CSV with all of them, and as the document."""

import csv
import os
from dataclasses import asdict, fields
from datetime import date
from pathlib import Path

import pareto
from measure import Measurement

TARGETS = (1e-3, 1e-5, 1e-7, 1e-9)

# Seconds within which a three-dimensional mesh is to reach an error: case, error, seconds.
GOALS = (("prolate", 1e-3, 0.1), ("prolate", 1e-5, 0.3), ("prolate", 1e-9, 10.0), ("sessile60", 1e-9, 0.1), ("sessile120", 1e-9, 0.1))


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
        model = next((line.split(":", 1)[1].strip() for line in cpuinfo.read_text(encoding="utf-8").splitlines() if line.startswith("model name")), model)
    return f"{model}, {os.cpu_count()} cores"


def markdown_table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *("| " + " | ".join(row) + " |" for row in rows), ""]


def brief(seconds):
    return f"{seconds:.3g}" if seconds < 100 else f"{seconds:.0f}"


def recommendation(found):
    return f"{found.setting} ({brief(found.seconds)} s)" if found else "-"


def recommendations(cases, own_of):
    """A row for each case and kind of mesh: what to take for which target."""
    rows = []
    for case in cases:
        own = [m for m in own_of(case) if not m.is_evolver]
        for where in dict.fromkeys(m.line.split(", ")[0] for m in own):
            here = [m for m in own if m.line.split(", ")[0] == where]
            rows.append([case.name, where, *(recommendation(pareto.recommended(here, t)) for t in TARGETS)])
    return rows


def against_evolver(cases, own_of):
    """A row for each case and target: the fastest settings on whole surfaces and on any part of them, and the fastest of Evolver."""
    rows = []
    for case in cases:
        groups = pareto.by_kind(own_of(case))
        for target in TARGETS if "Surface Evolver" in groups else ():
            ours, theirs = (pareto.recommended(groups.get(kind, []), target) for kind in ("in space", "Surface Evolver"))
            whole = pareto.recommended([m for m in groups.get("in space", []) if m.line.startswith("3-D")], target)
            ratios = [brief(theirs.seconds / seconds) for seconds in (ours.seconds, ours.seconds + ours.start_up)] if ours and theirs else ["-", "-"]
            if ours or theirs:
                rows.append([case.name, f"{target:.0e}", recommendation(whole), recommendation(ours), recommendation(theirs), *ratios])
    return rows


def best_of_evolver(cases, own_of):
    """A row for each case: the smallest error that Evolver reached, and what Pellicle takes in space for as small a one."""
    rows = []
    for case in cases:
        groups = pareto.by_kind(own_of(case))
        if "Surface Evolver" not in groups:
            continue
        best = pareto.front(groups["Surface Evolver"])[-1]
        rows.append([case.name, f"{best.error:.1e}", recommendation(best), recommendation(pareto.recommended(groups.get("in space", []), best.error))])
    return rows


def goals(measurements):
    rows = []
    for name, target, seconds in GOALS:
        own = [m for m in measurements if m.case == name]
        found = pareto.recommended([m for m in own if m.kind == "in space"], target)
        if own:
            verdict = "not reached" if not found else ("met" if found.seconds <= seconds else "missed")
            rows.append([name, f"{target:.0e}", f"{seconds:g} s", recommendation(found), verdict])
    return rows


def case_section(case, own):
    """What was compared with what, and the Pareto fronts of the case."""
    text = [f"### {case.title} (`{case.name}`)", ""]
    text += [f"Reference {case.reference.value:.14g}: {case.reference.source}; known to {case.reference.accuracy:.0e}, no error is taken to be smaller. {case.notes}".strip(), ""]
    rows = [
        ["Evolver, " + m.setting if m.is_evolver else m.setting, str(m.unknowns), f"{m.error:.1e}", brief(m.seconds), brief(m.cpu), brief(m.assembly), brief(m.linear_solve), brief(m.output),
         brief(m.start_up), str(m.repeats)]
        for group in pareto.by_kind(own).values()
        for m in pareto.front(group)
    ]
    return text + markdown_table(["setting", "unknowns", "error", "seconds", "CPU", "assembly", "linear solve", "output", "start-up", "repeats"], rows)


def document(cases, measurements, failures, picture, command):
    """The text of work_precision.md."""

    def own_of(case):
        return [m for m in measurements if m.case == case.name]

    cases = [case for case in cases if own_of(case)]
    with_evolver = any(m.is_evolver for m in measurements)
    text = [
        "# What accuracy costs in time",
        "",
        f"Written by `contrib/work_precision/run.py` on {date.today().isoformat()} ({machine()}); write it anew with",
        "",
        f"    {command}",
        "",
        "or together with the costs of effects by `contrib/measure_costs.sh`.",
        "",
        "Release build, one process at a time, one thread, no pictures and no solution files; all measurements are in `work_precision.csv` beside this file. Seconds are medians of",
        "the repeats. For Pellicle they count from entering main (`seconds.total`); loading the program and leaving it is the start-up, given apart: add it for the whole of a run.",
        "CPU seconds are those of the whole process. For Evolver, whose start takes milliseconds, seconds are those of the process, and `unknowns` are its facets. Errors are relative to",
        "the references named below. A setting is, for example, `3-D k3 r2`: degree 3, two refinements, a mesh of the whole surface in space; `octant` and `quarter` are symmetric parts of",
        "it, `axial` is a meridian.",
        "",
        f"![Error against seconds]({picture})",
        "",
        "## Recommended settings",
        "",
        "The fastest setting that meets the target, as all finer ones of its degree do: energy errors of coarse meshes change their sign, and one that is small by accident is no advice.",
        "",
        *markdown_table(["case", "mesh", *(f"{t:.0e}" for t in TARGETS)], recommendations(cases, own_of)),
    ]
    if goal_rows := goals(measurements):
        text += ["## Goals", "", "For meshes in space and symmetric parts of them, with the same rule.", ""]
        text += markdown_table(["case", "error", "goal", "fastest", ""], goal_rows)
    if with_evolver:
        text += ["## Beside Surface Evolver", "",
                 "The same problems in the same session with the inputs in `contrib/work_precision/evolver`, by the same rule, from the same start shapes. Evolver's meshes are of whole surfaces, the",
                 "fastest of Pellicle often of a symmetric part; both are shown. The last columns are Evolver's time over that of Pellicle's fastest, without and with Pellicle's start-up. Vesicles",
                 "have linear facets and the curvature at vertices (the only kind that Evolver has for bending), drops quadratic and Lagrange elements up to degree 8. A vesicle's Newton steps are",
                 "found by line searches at first; without them finer meshes diverge from the spheroid. Evolver is optional: `apt-get install evolver-nox`.", ""]
        text += markdown_table(["case", "error", "Pellicle, whole surface", "fastest in space", "Evolver", "ratio", "with start-up"], against_evolver(cases, own_of))
        text += ["The smallest errors that Evolver reached here, and the fastest settings of Pellicle with errors as small:", ""]
        text += markdown_table(["case", "error", "Evolver", "Pellicle, in space"], best_of_evolver(cases, own_of))
    text += ["## Cases", "", "Of each case the settings on the Pareto fronts of meshes in space, of meridians and of Evolver: none of the same kind is faster and at least as accurate.", ""]
    for case in cases:
        text += case_section(case, own_of(case))
    if failures:
        text += ["## Without a result", "", *(f"- {case}, {setting}: {reason}" for case, setting, reason in failures), ""]
    return "\n".join(text).rstrip() + "\n"
