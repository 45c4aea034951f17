# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error against seconds, a panel for each case and a line for each degree; the Pareto fronts of each kind of mesh are marked."""

import os

os.environ.setdefault("MPLCONFIGDIR", os.path.join(os.environ.get("TMPDIR", "/tmp"), "matplotlib"))

import pareto

# Okabe and Ito's colours, which people who see few colours tell apart as well; without yellow, too pale for lines.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")
STYLES = {"3-D": ("-", "o"), "axial": ("--", "s")}
OTHER_STYLE = ("-.", "^")  # symmetric parts
COLUMNS = 3


def look(line, evolver_lines):
    """Colour, stroke and marker of a line: colours tell degrees apart, strokes kinds of meshes; Evolver is grey."""
    if line in evolver_lines:
        shade = 0.25 + 0.5 * evolver_lines.index(line) / max(1, len(evolver_lines))
        return str(shade), ":", "x"
    where, _, how = line.partition(", ")
    stroke, marker = STYLES.get(where, OTHER_STYLE)
    colour = COLOURS[int(how[-1]) % len(COLOURS)] if how.startswith("degree") else "black"
    return colour, stroke, marker


def draw(cases, measurements, path):
    """Writes the figure; the ending of `path` says in which format. ImportError without Matplotlib."""
    import matplotlib
    from matplotlib.figure import Figure  # needs no display

    matplotlib.rcParams["svg.hashsalt"] = "pellicle"
    shown = [case for case in cases if any(m.case == case.name for m in measurements)]
    rows = -(-len(shown) // COLUMNS)
    columns = min(COLUMNS, len(shown))
    height, legend_height = 3.6 * rows + 1.5, 1.5
    figure = Figure(figsize=(4.6 * columns, height), layout="constrained")
    figure.get_layout_engine().set(rect=(0.0, legend_height / height, 1.0, 1.0 - legend_height / height))
    evolver_lines = list(dict.fromkeys(m.line for m in measurements if m.is_evolver))
    handles = {}
    for i, case in enumerate(shown):
        axes = figure.add_subplot(rows, columns, i + 1, xscale="log", yscale="log", xlabel="seconds", ylabel="relative error")
        axes.set_title(case.title, fontsize=9)
        axes.grid(alpha=0.25)
        own = [m for m in measurements if m.case == case.name]
        for line in dict.fromkeys(m.line for m in own):
            colour, stroke, marker = look(line, evolver_lines)
            points = [m for m in own if m.line == line]
            (handles[line],) = axes.plot([m.seconds for m in points], [m.error for m in points], color=colour, linestyle=stroke, marker=marker, markersize=4,
                                         linewidth=1.2, label=line)
        axes.tick_params(which="minor", labelsize=6)
        best = [m for group in pareto.by_kind(own).values() for m in pareto.front(group)]
        (handles["Pareto front"],) = axes.plot([m.seconds for m in best], [m.error for m in best], linestyle="", marker="o", markersize=10,
                                               markerfacecolor="none", markeredgecolor="0.2", label="Pareto front")
    figure.legend(handles=list(handles.values()), loc="lower center", ncols=4 if columns > 1 else 2, fontsize=8, frameon=False)
    figure.savefig(path, metadata={"Date": None} if str(path).endswith(".svg") else None)
