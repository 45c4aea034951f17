#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the phase diagram that a run has left in phase_diagram.csv and computes where its branches cross.

    /usr/bin/python3 contrib/phase_diagram/plot.py DIRECTORY [--output DIRECTORY] [--no-picture]

README.md beside this file describes the table, the picture and the crossings. The picture needs the Debian package
python3-matplotlib, the rest nothing. Exit status: 0 done; 1 results cannot be written; 2 bad command line or table;
3 the crossings are written, but there is no picture for want of Matplotlib.
"""

import argparse
import csv
import io
import os
import sys
from pathlib import Path

from curves import STABLE, UNKNOWN, UNSTABLE, crossings, lines
from states import BadTable, read_branches

# Okabe and Ito's colours, which people who see few colours tell apart as well; without yellow, too pale for lines.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")
STYLES = {STABLE: {"linestyle": "-"}, UNSTABLE: {"linestyle": "--"}, UNKNOWN: {"linestyle": ":", "alpha": 0.6}}
POINTS_PER_PIECE = 16


def curve(pieces):
    """Reduced volumes and energies of a line through consecutive pieces of a branch."""
    volumes, energies = [pieces[0].begin.volume], [pieces[0].begin.energy]
    for piece in pieces:
        for i in range(1, POINTS_PER_PIECE + 1):
            t = i / POINTS_PER_PIECE
            volumes.append((1 - t) * piece.begin.volume + t * piece.end.volume)
            energies.append(piece.energy(volumes[-1]))
    return volumes, energies


def draw(branches, found):
    """The figure as the bytes of a PNG file. ImportError without Matplotlib."""
    from matplotlib.figure import Figure  # needs no display
    from matplotlib.lines import Line2D

    figure = Figure(figsize=(8, 6), dpi=150, layout="constrained")
    axes = figure.add_subplot(xlabel="reduced volume $v$", ylabel=r"bending energy $E\,/\,(8\pi\kappa)$")
    axes.grid(alpha=0.25)
    legend, used = [], set()
    for i, (name, states) in enumerate(branches.items()):
        colour = COLOURS[i % len(COLOURS)]
        legend.append(Line2D([], [], color=colour, label=name))
        for stability, stretch in lines(states):
            used.add(stability)
            axes.plot(*curve(stretch), color=colour, linewidth=1.6, **STYLES[stability])
        axes.plot([s.volume for s in states], [s.energy for s in states], ".", color=colour, markersize=3)
        folds = [s for s in states if s.is_fold]
        axes.plot([s.volume for s in folds], [s.energy for s in folds], "D", color=colour, markerfacecolor="white", zorder=3)
    legend += [Line2D([], [], color="0.3", label=stability, **style) for stability, style in STYLES.items() if stability in used]
    if any(s.is_fold for states in branches.values() for s in states):
        legend.append(Line2D([], [], color="0.3", marker="D", markerfacecolor="white", linestyle="", label="fold"))
    for crossing in found:
        axes.plot(crossing.volume, crossing.energy, "o", color="black", markersize=6, zorder=4)
        axes.annotate(f"{crossing.volume:.4f}", (crossing.volume, crossing.energy), (7, 5), textcoords="offset points")
    if found:
        legend.append(Line2D([], [], color="black", marker="o", linestyle="", label="crossing"))
    axes.legend(handles=legend, frameon=False)
    png = io.BytesIO()
    figure.savefig(png, format="png")
    return png.getvalue()


def as_table(found):
    """The text of crossings.csv."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["branch_a", "branch_b", "reduced_volume", "energy"])
    table.writerows([c.branch_a, c.branch_b, f"{c.volume:.12g}", f"{c.energy:.12g}"] for c in found)
    return text.getvalue()


def write(path, content):
    """Whole or not at all: to a temporary name, then renamed."""
    temporary = path.with_name(path.name + ".tmp")
    temporary.write_bytes(content)
    os.replace(temporary, path)


def run(directory, output, with_picture):
    """The exit status; BadTable and OSError are for the caller."""
    branches = read_branches(directory / "phase_diagram.csv")
    found = crossings(branches)
    for crossing in found:
        print(f"crossing {crossing.branch_a}/{crossing.branch_b} v = {crossing.volume:.6f}, E = {crossing.energy:.6f}")
    if not found:
        print("no crossings")
    output.mkdir(parents=True, exist_ok=True)
    write(output / "crossings.csv", as_table(found).encode())
    if not with_picture:
        return 0
    try:
        picture = draw(branches, found)
    except ImportError as error:
        print(f"No picture: Matplotlib is missing ({error}; on Debian: apt-get install python3-matplotlib).", file=sys.stderr)
        return 3
    write(output / "phase_diagram.png", picture)
    print(f"picture {output / 'phase_diagram.png'}")
    return 0


def main():
    parser = argparse.ArgumentParser(description="Draws the phase diagram in phase_diagram.csv and computes where branches cross.")
    parser.add_argument("directory", type=Path, help="output directory of the run, with phase_diagram.csv in it")
    parser.add_argument("--output", type=Path, metavar="DIRECTORY",
                        help="where phase_diagram.png and crossings.csv are written (default: where the table is)")
    parser.add_argument("--no-picture", action="store_true", help="only crossings")
    arguments = parser.parse_args()
    try:
        return run(arguments.directory, arguments.output or arguments.directory, not arguments.no_picture)
    except BadTable as error:
        print(error, file=sys.stderr)
        return 2
    except OSError as error:
        print(f"The results cannot be written: {error}.", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
