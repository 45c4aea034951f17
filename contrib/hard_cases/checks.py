# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges the outcome of a hard case by the criteria of cases.json (README.md describes them)."""

import math


def final_value(check, run):
    return run.summary.get("quantities", {}).get(check["quantity"])


def column(check, run):
    return [float(row[check["quantity"]]) for row in run.tables["history.csv"] if row.get(check["quantity"])]


def largest_value(check, run):
    return max(column(check, run), default=None)


def smallest_value(check, run):
    return min(column(check, run), default=None)


def first_fold(check, run):
    """Of the parameter of a branch."""
    return next((float(row[check["quantity"]]) for row in run.tables["branch.csv"] if row["is_fold"] == "1"), None)


# Where a criterion takes its number from.
SOURCES = {"end": final_value, "largest": largest_value, "smallest": smallest_value, "fold": first_fold}


def is_near(value, check):
    allowed = check["absolute"] if "absolute" in check else check["relative"] * abs(check["expected"])
    return abs(value - check["expected"]) <= allowed


def is_right(value, check):
    if value is None or not math.isfinite(value):
        return False
    return (("expected" not in check or is_near(value, check)) and value >= check.get("at_least", -math.inf)
            and value <= check.get("at_most", math.inf))


def words(check):
    """Those of which one must be said."""
    wanted = check.get("warning") or check.get("message") or check["says"]
    return wanted if isinstance(wanted, list) else [wanted]


def text_failures(check, run):
    """Of a criterion on words: in the warnings, in the message on stderr, or (says) in either of them."""
    warnings = " ".join(run.summary.get("warnings", []))
    where, text = (("a warning", warnings) if "warning" in check else ("the message", run.stderr) if "message" in check
                   else ("warnings and message", warnings + run.stderr))
    if any(wanted in text for wanted in words(check)):
        return []
    return [f"{check['failure']}: '{words(check)[0]}' is not in {where}"]


def number_failures(check, run):
    source = check.get("at", "end")
    value = SOURCES[source](check, run)
    if is_right(value, check):
        return []
    bounds = ", ".join(f"{key} {check[key]}" for key in ("expected", "relative", "absolute", "at_least", "at_most") if key in check)
    return [f"{check['failure']}: {check['quantity']} ({source}) is {value}, {bounds}"]


def failures(case, run):
    """What the criteria say against the run, as named messages; empty: it passes."""
    name = case["name"]
    if run.status is None:
        return [f"{name}: over its budget of {case['budget']} s"]
    wanted = case.get("exit_status", 0)
    if run.status not in (wanted if isinstance(wanted, list) else [wanted]):
        return [f"{name}: exit status {run.status} and not {wanted}: {run.stderr.strip()}"]
    found = []
    for check in case["checks"]:
        found += number_failures(check, run) if "quantity" in check else text_failures(check, run)
    return [f"{name}: {message}" for message in found]
