# SPDX-License-Identifier: LGPL-2.1-or-later
"""contrib/phase_diagram on made-up branches whose energies, pressures and crossings are known in closed form."""

import csv
import dataclasses
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
FOLDER = Path(__file__).resolve().parents[2] / "contrib" / "phase_diagram"
sys.path.insert(0, str(FOLDER))
import curves
import plot
from curves import STABLE, UNKNOWN, UNSTABLE
from states import State, energy_slope, read_branches

AREA, RIGIDITY = 5.0, 20.0
SPHERE_VOLUME = AREA**1.5 / (6 * math.sqrt(math.pi))


def branch(energy, slope, volumes, modes=0):
    """The states of a branch E(v), dE/dv."""
    return [State(v, energy(v), slope(v), modes) for v in volumes]


def evenly(low, high, n):
    """n + 1 numbers."""
    return [low + (high - low) * i / n for i in range(n + 1)]


def folded():
    """A branch that turns back at v = 0.7: v = 0.7 - s^2 and dE/dv = -1 + s give E = 1.5 + s^2 - (2/3) s^3, unstable
    with the higher energy for s < 0. At the fold itself the count is round-off: here the wrong one."""
    return [State(0.7 - s * s, 1.5 + s * s - 2 / 3 * s**3, s - 1, 1 if s <= 0 else 0, s == 0) for s in evenly(-0.5, 0.5, 20)]


class Interpolation(unittest.TestCase):
    def test_fourth_order(self):
        errors = []
        for n in (4, 8, 16):
            pieces = curves.pieces(branch(math.exp, math.exp, evenly(0.0, 2.0, n)))
            errors.append(max(abs(p.energy(v) - math.exp(v)) for p in pieces for v in evenly(p.low, p.high, 8)))
        for coarse, fine in zip(errors, errors[1:]):
            self.assertGreater(coarse / fine, 13)
            self.assertLess(coarse / fine, 19)

    def test_cubics_are_exact_in_both_directions(self):
        def energy(v):
            return 1 - 2 * v + 3 * v**3

        def slope(v):
            return -2 + 9 * v**2

        for volumes in ((0.2, 0.9), (0.9, 0.2)):
            (piece,) = curves.pieces(branch(energy, slope, volumes))
            for v in evenly(0.2, 0.9, 7):
                self.assertAlmostEqual(piece.energy(v), energy(v), delta=1e-14)
                self.assertAlmostEqual(piece.slope(v), slope(v), delta=1e-14)
            self.assertEqual([piece.energy(v) for v in volumes], [energy(v) for v in volumes])

    def test_slope_is_the_derivative_at_fixed_area(self):
        # Energy c V^2 has the pressure 2 c V.
        c, v, step = 0.3, 0.7, 1e-5
        scaled = [c * ((v + d) * SPHERE_VOLUME) ** 2 / (8 * math.pi * RIGIDITY) for d in (-step, step)]
        slope = energy_slope(2 * c * v * SPHERE_VOLUME, AREA, RIGIDITY)
        self.assertAlmostEqual(slope, (scaled[1] - scaled[0]) / (2 * step), delta=1e-10)
        self.assertAlmostEqual(energy_slope(8 * math.pi, 4 * math.pi, 1.0), 4 * math.pi / 3, delta=1e-14)

    def test_all_roots_of_a_cubic(self):
        wanted = [0.1, 0.35, 0.8]

        def value(x):
            return (x - 0.1) * (x - 0.35) * (x - 0.8)

        def slope(x):
            return (x - 0.35) * (x - 0.8) + (x - 0.1) * (x - 0.8) + (x - 0.1) * (x - 0.35)

        for root, x in zip(curves.roots(value, slope, 0.0, 1.0), wanted, strict=True):
            self.assertAlmostEqual(root, x, delta=1e-14)
        self.assertEqual(len(curves.roots(value, slope, 0.2, 0.9)), 2)
        self.assertEqual(curves.roots(value, slope, 0.85, 0.9), [])
        self.assertEqual(curves.roots(lambda x: x * x + 1, lambda x: 2 * x, -1.0, 1.0), [])


class Crossings(unittest.TestCase):
    def one(self, a, b):
        (place,) = curves.crossings_of_two(a, b)
        return place

    def test_of_lines_and_parabolas_are_exact(self):
        a = branch(lambda v: 3 - 2 * v, lambda v: -2.0, [0.4, 0.9])
        b = branch(lambda v: 1 + v * v, lambda v: 2 * v, [0.95, 0.6, 0.5])
        v, energy = self.one(a, b)
        self.assertAlmostEqual(v, math.sqrt(3) - 1, delta=1e-14)
        self.assertAlmostEqual(energy, 5 - 2 * math.sqrt(3), delta=1e-14)

    def test_of_transcendental_curves(self):
        v = 0.7  # of cos(3 v) = v/2 - 0.8, by Newton's method
        for _ in range(20):
            v -= (math.cos(3 * v) - v / 2 + 0.8) / (-3 * math.sin(3 * v) - 0.5)
        a = branch(lambda x: math.cos(3 * x), lambda x: -3 * math.sin(3 * x), evenly(0.4, 0.95, 11))
        b = branch(lambda x: x / 2 - 0.8, lambda x: 0.5, evenly(0.5, 1.0, 3))
        place = self.one(a, b)
        self.assertAlmostEqual(place[0], v, delta=1e-6)
        self.assertAlmostEqual(place[1], v / 2 - 0.8, delta=1e-6)

    def test_at_a_state_of_both_branches_is_found_once(self):
        up = branch(lambda v: 1 + v, lambda v: 1.0, [0.5, 0.625, 0.75])
        down = branch(lambda v: 2.25 - v, lambda v: -1.0, [0.5, 0.625, 0.75])
        for a, b in ((up, down), (down, up), (up, down[::-1])):
            v, energy = self.one(a, b)
            self.assertAlmostEqual(v, 0.625, delta=1e-15)
            self.assertAlmostEqual(energy, 1.625, delta=1e-15)

    def test_none_without_common_volumes_or_without_change_of_order(self):
        a = branch(lambda v: 1 + v, lambda v: 1.0, [0.5, 0.6])
        self.assertEqual(curves.crossings_of_two(a, branch(lambda v: 2 - v, lambda v: -1.0, [0.6, 0.7])), [])
        self.assertEqual(curves.crossings_of_two(a, branch(lambda v: 1 + v * v, lambda v: 2 * v, [0.5, 0.6])), [])
        self.assertEqual(curves.crossings_of_two(a, a[:1]), [])

    def test_only_the_stable_sheet_of_a_fold_counts(self):
        # The line with slope -3 through the stable sheet at s = 0.3 meets the unstable one as well.
        v0, e0 = 0.7 - 0.09, 1.5 + 0.09 - 2 / 3 * 0.027
        line = branch(lambda v: e0 - 3 * (v - v0), lambda v: -3.0, evenly(0.45, 0.9, 6))
        states = folded()
        unstable = [State(s.volume, s.energy, s.slope, 0) for s in states if s.slope <= -1]
        self.assertEqual(len(curves.crossings_of_two(unstable, line)), 1)
        v, energy = self.one(states, line)
        self.assertAlmostEqual(v, v0, delta=1e-12)  # a state is there
        self.assertAlmostEqual(energy, e0, delta=1e-12)

    def test_unstable_states_do_not_count(self):
        line = branch(lambda v: 1.25 + v, lambda v: 1.0, [0.4, 0.8])
        for modes, count in ((0, 1), (None, 1), (2, 0)):
            states = branch(lambda v: 3 - 2 * v, lambda v: -2.0, [0.4, 0.8], modes)
            self.assertEqual(len(curves.crossings_of_two(states, line)), count)
            self.assertEqual(len(curves.crossings_of_two(line, states)), count)

    def test_a_state_given_twice_does_no_harm(self):
        states = branch(lambda v: 3 - 2 * v, lambda v: -2.0, [0.4, 0.5, 0.5, 0.8])
        v, _ = self.one(states, branch(lambda v: 1.25 + v, lambda v: 1.0, [0.4, 0.8]))
        self.assertAlmostEqual(v, 7 / 12, delta=1e-14)

    def test_only_the_lowest_sheet_counts(self):
        # Both sheets pass for stable: a line that meets the upper one only has no crossing.
        states = [State(s.volume, s.energy, s.slope, None) for s in folded()]
        upper = 0.7 - 0.04, 1.5 + 0.04 + 2 / 3 * 0.008
        line = branch(lambda v: upper[1] + 2 * (v - upper[0]), lambda v: 2.0, [0.658, 0.662])
        self.assertEqual(len(curves.crossings_of_two([s for s in states if s.slope <= -1], line)), 1)
        self.assertEqual(curves.crossings_of_two(states, line), [])

    def test_a_bifurcation_is_no_crossing(self):
        # The new branch splits off at v = 0.6 with the same pressure, its energy a little off by discretisation.
        old = branch(lambda v: 3 - 2 * v, lambda v: -2.0, evenly(0.4, 0.8, 8))
        for error in (-1e-8, 0.0, 1e-8):
            new = branch(lambda v, e=error: 3 - 2 * v + e - (v - 0.6) ** 2, lambda v: -2 - 2 * (v - 0.6), evenly(0.4, 0.6, 4))
            self.assertEqual(curves.crossings_of_two(old, new), [])

    def test_a_branch_computed_there_and_back(self):
        there = branch(lambda v: 3 - 2 * v, lambda v: -2.0, [0.4, 0.5, 0.6, 0.7])
        back = [State(s.volume, s.energy + 1e-13, s.slope, 0) for s in reversed(there)]
        v, _ = self.one(there + back, branch(lambda v: 1.25 + v, lambda v: 1.0, [0.45, 0.7]))
        self.assertAlmostEqual(v, 7 / 12, delta=1e-12)

    def test_all_pairs(self):
        volumes = evenly(0.4, 0.8, 4)
        branches = {"prolate": branch(lambda v: 3 - 2 * v, lambda v: -2.0, volumes),
                    "oblate": branch(lambda v: 2.8 - 1.6 * v, lambda v: -1.6, volumes),
                    "stomatocyte": branch(lambda v: 2 - 0.1 * v, lambda v: -0.1, volumes)}
        found = [(c.branch_a, c.branch_b) for c in curves.crossings(branches)]
        self.assertEqual(found, [("prolate", "oblate"), ("prolate", "stomatocyte"), ("oblate", "stomatocyte")])
        for c, v in zip(curves.crossings(branches), (0.5, 10 / 19, 8 / 15), strict=True):
            self.assertAlmostEqual(c.volume, v, delta=1e-14)


class Stability(unittest.TestCase):
    def stabilities(self, *modes, fold_at=None):
        states = [State(0.5 + 0.1 * i, 1.0, 0.0, count, i == fold_at) for i, count in enumerate(modes)]
        return [(stability, len(stretch)) for stability, stretch in curves.lines(states)]

    def test_of_the_worse_end(self):
        self.assertEqual(self.stabilities(0, 0, 0, 1, 2), [(STABLE, 2), (UNSTABLE, 2)])
        self.assertEqual(self.stabilities(0, 0, None, 1), [(STABLE, 1), (UNKNOWN, 1), (UNSTABLE, 1)])
        self.assertEqual(self.stabilities(None, None), [(UNKNOWN, 1)])

    def test_beside_a_fold_the_other_end_decides(self):
        for at_fold in (0, 1, None):
            self.assertEqual(self.stabilities(1, 1, at_fold, 0, 0, fold_at=2), [(UNSTABLE, 2), (STABLE, 2)])

    def test_lines_differ(self):
        styles = {stability: plot.STYLES[stability]["linestyle"] for stability in (STABLE, UNSTABLE, UNKNOWN)}
        self.assertEqual(styles, {STABLE: "-", UNSTABLE: "--", UNKNOWN: ":"})

    def test_a_line_turns_back_at_the_fold(self):
        states = folded()
        (_, first), (_, second) = curves.lines(states)
        for stretch in (first, second):
            volumes, energies = plot.curve(stretch)
            self.assertEqual(len(volumes), 10 * plot.POINTS_PER_PIECE + 1)
            self.assertEqual((volumes[0], energies[0]), (stretch[0].begin.volume, stretch[0].begin.energy))
            self.assertEqual((volumes[-1], energies[-1]), (stretch[-1].end.volume, stretch[-1].end.energy))
        self.assertEqual(first[-1].end, second[0].begin)
        self.assertEqual(max(plot.curve(first)[0]), 0.7)


class Program(unittest.TestCase):
    HEADER = ("branch", "reduced_volume", "bending_energy_over_8_pi_kappa", "tension", "pressure", "integrated_mean_curvature",
              "area", "bending_rigidity", "negative_eigenvalues", "is_fold")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def table(self, branches, drop=()):
        """Writes phase_diagram.csv as a run does."""
        with open(self.folder / "phase_diagram.csv", "w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, [c for c in self.HEADER if c not in drop], extrasaction="ignore")
            writer.writeheader()
            for name, states in branches.items():
                for s in states:
                    pressure = s.slope * 8 * math.pi * RIGIDITY / SPHERE_VOLUME
                    count = "" if s.unstable_modes is None else s.unstable_modes
                    values = (name, s.volume, s.energy, 0.5, pressure, 1.2, AREA, RIGIDITY, count, int(s.is_fold))
                    writer.writerow(dict(zip(self.HEADER, values)))

    def run_plot(self, *arguments, python=sys.executable, **environment):
        return subprocess.run([python, "-B", FOLDER / "plot.py", self.folder, *arguments], capture_output=True, text=True,
                              check=False, env=dict(os.environ, **environment))

    def refused(self, text=None):
        """The one line about a table with this text."""
        if text is not None:
            (self.folder / "phase_diagram.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
        run = self.run_plot("--no-picture")
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        self.assertFalse((self.folder / "crossings.csv").exists())
        return run.stderr.strip().removeprefix(str(self.folder / "phase_diagram.csv"))

    BRANCHES = {
        "prolate": branch(lambda v: 3 - 2 * v, lambda v: -2.0, evenly(0.4, 0.9, 5)),
        "oblate": branch(lambda v: 1 + v * v, lambda v: 2 * v, evenly(0.9, 0.5, 4), None),
        "stomatocyte, folded": folded(),
    }

    def test_crossings_are_printed_and_written(self):
        self.table({name: self.BRANCHES[name] for name in ("prolate", "oblate")})
        output = self.folder / "new" / "place"
        run = self.run_plot("--no-picture", "--output", output)
        self.assertEqual((run.returncode, run.stdout), (0, "crossing prolate/oblate v = 0.732051, E = 1.535898\n"), run.stderr)
        self.assertEqual([path.name for path in output.iterdir()], ["crossings.csv"])
        with open(output / "crossings.csv", encoding="utf-8", newline="") as file:
            (row,) = csv.DictReader(file)
        self.assertEqual(list(row), ["branch_a", "branch_b", "reduced_volume", "energy"])
        self.assertEqual((row["branch_a"], row["branch_b"]), ("prolate", "oblate"))
        self.assertAlmostEqual(float(row["reduced_volume"]), math.sqrt(3) - 1, delta=1e-11)
        self.assertAlmostEqual(float(row["energy"]), 5 - 2 * math.sqrt(3), delta=1e-11)

    def test_without_crossings(self):
        self.table({"prolate": self.BRANCHES["prolate"]})
        run = self.run_plot("--no-picture")
        self.assertEqual((run.returncode, run.stdout), (0, "no crossings\n"), run.stderr)
        self.assertEqual((self.folder / "crossings.csv").read_text(encoding="utf-8"), "branch_a,branch_b,reduced_volume,energy\n")

    def test_states_are_read_as_they_were_written(self):
        self.table(self.BRANCHES)
        read = read_branches(self.folder / "phase_diagram.csv")
        self.assertEqual(list(read), list(self.BRANCHES))
        for name, states in self.BRANCHES.items():
            for got, wanted in zip(read[name], states, strict=True):
                self.assertEqual(dataclasses.replace(got, slope=0), dataclasses.replace(wanted, slope=0))
                self.assertAlmostEqual(got.slope, wanted.slope, delta=1e-14)

    def test_unusable_tables(self):
        self.assertEqual(self.refused(), " cannot be read: No such file or directory.")
        lacking = " lacks the columns: "
        self.assertTrue(self.refused("").startswith(lacking))
        self.assertTrue(self.refused(b"\x89PNG\r\n\x1a\n\xff\xfe").startswith(" is not a table of comma-separated values: "))
        self.table(self.BRANCHES, drop=("pressure", "is_fold", "tension"))
        self.assertEqual(self.refused(), lacking + "pressure, is_fold.")
        self.assertEqual(self.refused(",".join(self.HEADER) + "\n"), " holds no state.")

    def test_unusable_rows(self):
        good = dict(zip(self.HEADER, ("prolate", "0.7", "1.5", "1", "-3", "1.2", "5", "20", "0", "0")))
        for column, value, message in (
                ("branch", " ", "branch is empty, but must be a name"),
                ("reduced_volume", "many", "reduced_volume is 'many', but must be a positive number"),
                ("reduced_volume", "-0.7", "reduced_volume is '-0.7', but must be a positive number"),
                ("bending_energy_over_8_pi_kappa", "nan", "bending_energy_over_8_pi_kappa is 'nan', but must be a finite number"),
                ("pressure", "", "pressure is '', but must be a finite number"),
                ("bending_rigidity", "0", "bending_rigidity is '0', but must be a positive number"),
                ("negative_eigenvalues", "-1", "negative_eigenvalues is '-1', but must be a whole number from 0 on, or empty"),
                ("is_fold", "yes", "is_fold is 'yes', but must be 0 or 1")):
            rows = [self.HEADER, good.values(), {**good, column: value}.values()]
            self.assertEqual(self.refused("\n".join(map(",".join, rows))), f":3: {message}.")
        for row in ("prolate,0.7", ",".join(good.values()) + ",8"):
            self.assertEqual(self.refused(",".join(self.HEADER) + "\n" + row), ":2: the row does not have 10 fields as the first line has.")

    def test_results_that_cannot_be_written(self):
        self.table(self.BRANCHES)
        (self.folder / "file").touch()
        run = self.run_plot("--no-picture", "--output", self.folder / "file")
        self.assertEqual(run.returncode, 1)
        self.assertTrue(run.stderr.startswith("The results cannot be written: "), run.stderr)

    def test_without_matplotlib(self):
        self.table(self.BRANCHES)
        (self.folder / "matplotlib.py").write_text("raise ImportError('none here')", encoding="utf-8")
        run = self.run_plot(PYTHONPATH=str(self.folder))
        self.assertEqual(run.returncode, 3)
        self.assertEqual(run.stderr, "No picture: Matplotlib is missing (none here; on Debian: apt-get install python3-matplotlib).\n")
        self.assertTrue((self.folder / "crossings.csv").exists())
        self.assertFalse((self.folder / "phase_diagram.png").exists())

    @unittest.skipUnless(Path("/usr/lib/python3/dist-packages/matplotlib").exists(), "python3-matplotlib is not installed")
    def test_picture(self):
        self.table({**self.BRANCHES, "one state": self.BRANCHES["prolate"][:1]})
        run = self.run_plot(python="/usr/bin/python3", MPLCONFIGDIR=str(self.folder / "cache"))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.splitlines()[-1], f"picture {self.folder / 'phase_diagram.png'}")
        picture = (self.folder / "phase_diagram.png").read_bytes()
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertGreater(len(picture), 20000)


if __name__ == "__main__":
    unittest.main()
