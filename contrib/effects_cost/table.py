# SPDX-License-Identifier: LGPL-2.1-or-later
"""A row of the table of costs from the summaries of two runs, and the table's place in a document."""

import re
from collections import Counter

BEGIN = "<!-- effects cost: written by contrib/effects_cost/run.py -->"
END = "<!-- effects cost: end -->"
HEAD = ["application", "effect", "fields it adds", "terms it adds, by loop", "unknowns", "matrix entries", "ms per iteration", "ratio"]


def terms_of(summary):
    """Multiset of (loop, kind, name, region)."""
    return Counter((loop["over"], t["kind"], t["name"], t.get("region", "")) for loop in summary["loops"] for t in loop["terms"])


def fields_of(summary):
    return [name for name in summary["unknowns"] if name not in ("total", "multipliers", "rigid motions")]


def points_of(summary, over):
    return next(loop["points"] for loop in summary["loops"] if loop["over"] == over)


def named_after(effect, terms):
    """The terms of an effect by its name; if there are none, those that the name's last word begins ("cosserat shell": "shell strain")."""
    own = Counter({term: n for term, n in terms.items() if term[2] == effect})
    return own or Counter({term: n for term, n in terms.items() if term[2].split()[0] == effect.split()[-1]})


def added_terms(effect, with_it, without_it):
    """For example "surface (384 points): 1 energy"; with nothing to compare, the terms that are named after the effect."""
    more = terms_of(with_it) - terms_of(without_it) if without_it else named_after(effect, terms_of(with_it))
    counts = Counter()
    for (over, kind, _, _), n in more.items():
        counts[over, kind] += n

    def plural(kind, n):
        return kind if n == 1 else "energies" if kind == "energy" else kind + "s"

    return "; ".join(f"{over} ({points_of(with_it, over)} points): {n} {plural(kind, n)}" for (over, kind), n in counts.items()) or "none"


def arrow(before, after):
    """What is without and with an effect."""
    return after if before is None else f"{before} -> {after}"


def row(pair, with_it, without_it):
    """Cells of a table row, texts."""
    known = fields_of(without_it) if without_it else ["position", "moment"]
    fields = [f"{name} ({with_it['unknowns'][name]})" for name in fields_of(with_it) if name not in known]

    def both(number):
        return arrow(number(without_it) if without_it else None, number(with_it))

    seconds = [s["seconds per iteration"] for s in (with_it, without_it) if s]
    comparable = len(seconds) == 2 and not pair.note
    return [
        f"`{pair.application}`", f"`{pair.effect}`", ", ".join(fields) or "none", added_terms(pair.effect, with_it, without_it),
        both(lambda s: str(s["unknowns"]["total"])), both(lambda s: str(s["matrix"]["entries"])), both(lambda s: f"{1e3 * s['seconds per iteration']:.3g}"),
        f"{seconds[0] / seconds[1]:.2f}" if comparable else pair.note or "no scene without it",
    ]


def renewed(document, block):
    """The document with the block in the place of the old one. ValueError if there is none."""
    pattern = re.compile(re.escape(BEGIN) + ".*?" + re.escape(END), re.DOTALL)
    if len(pattern.findall(document)) != 1:
        raise ValueError(f"the document has no table between '{BEGIN}' and '{END}', or several")
    return pattern.sub(lambda _: block, document)


def rows_of(document):
    """Pairs (application, effect) of the table in a document."""
    block = document.split(BEGIN, 1)[1].split(END, 1)[0]
    return re.findall(r"^\| `([^`]+)` \| `([^`]+)` \|", block, re.MULTILINE)
