# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the table of the hard cases into doc/stability.md, between two comments that mark its place."""

from checks import SOURCES, failures, words

BEGIN, END = "<!-- table: contrib/hard_cases/run.py --write -->", "<!-- end of the table -->"
HEAD = ("| case | what makes it hard | result | iterations | CPU s | condition | smallest pivot |\n"
        "|---|---|---|---|---|---|---|\n")


def number(value):
    return "" if value is None else f"{value:.7g}"


def finding(check, run):
    """One criterion and what was found, in a few words."""
    if "quantity" not in check:
        return f"says '{words(check)[0]}'"
    source = check.get("at", "end")
    name = {"end": "", "largest": "largest ", "smallest": "smallest ", "fold": "fold at "}[source] + f"`{check['quantity']}`"
    text = f"{name} {number(SOURCES[source](check, run))}"
    if "expected" in check:
        text += f" ({number(check['expected'])}: {check['source']})"
    return text


def result(case, run):
    wrong = failures(case, run)
    if case.get("known_failure"):
        return f"**fails**: {case['known_failure']}"
    return "; ".join(finding(check, run) for check in case["checks"]) if not wrong else f"**fails**: {'; '.join(wrong)}"


def row(case, run):
    solver = run.summary.get("linear_solver", {})
    condition, pivot = (f"{solver[key]:.1e}" if key in solver else "" for key in ("condition_estimate", "smallest_pivot"))
    iterations = "" if run.iterations is None else run.iterations
    return (f"| `{case['name']}` | {case['hard']} | {result(case, run)} | {iterations} | {run.cpu_seconds:.1f} | {condition} "
            f"| {pivot} |\n")


def write_table(document, names, results):
    """Replaces what stands between the two comments: rows of the cases that were run, in the order of the names; others stay."""
    text = document.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    table, after = rest.split(END)
    rows = {line.split("`")[1]: line + "\n" for line in table.splitlines() if line.startswith("| `")}
    rows.update({case["name"]: row(case, run) for case, run in results})
    body = "".join(rows[name] for name in names if name in rows)
    document.write_text(f"{before}{BEGIN}\n{HEAD}{body}{END}{after}", encoding="utf-8")
