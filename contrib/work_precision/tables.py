# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of the document's tables, as lists of texts. `own_of(case)` gives the measurements of a case."""

import pareto

TARGETS = (1e-3, 1e-5, 1e-7, 1e-9)

# Seconds within which a three-dimensional mesh is to reach an error: case, error, seconds.
GOALS = (("prolate", 1e-3, 0.1), ("prolate", 1e-5, 0.3), ("prolate", 1e-9, 10.0), ("sessile60", 1e-9, 0.1), ("sessile120", 1e-9, 0.1))


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
    """A row for each goal of a case that was measured."""
    rows = []
    for name, target, seconds in GOALS:
        own = [m for m in measurements if m.case == name]
        found = pareto.recommended([m for m in own if m.kind == "in space"], target)
        if own:
            verdict = "not reached" if not found else ("met" if found.seconds <= seconds else "missed")
            rows.append([name, f"{target:.0e}", f"{seconds:g} s", recommendation(found), verdict])
    return rows


def fronts(own):
    """The Pareto fronts of a case, by kind of mesh."""
    rows = []
    for group in pareto.by_kind(own).values():
        for m in pareto.front(group):
            name = f"Evolver, {m.setting}" if m.is_evolver else m.setting
            seconds = (m.seconds, m.cpu, m.assembly, m.linear_solve, m.output, m.start_up)
            rows.append([name, str(m.unknowns), f"{m.error:.1e}", *map(brief, seconds), str(m.repeats)])
    return rows
