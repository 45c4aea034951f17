# SPDX-License-Identifier: LGPL-2.1-or-later
"""contrib/work_precision: references against numbers from elsewhere, Pareto fronts and recommendations on made-up measurements, and a small study (class Study; the
environment variable PELLICLE_BINARIES names the folder of the applications)."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
FOLDER = Path(__file__).resolve().parents[2] / "contrib" / "work_precision"
sys.path.insert(0, str(FOLDER))
import evolver
import numpy as np
import pareto
import references
import report
from cases import CASES
from measure import Measurement


def measured(line, seconds, error, name="m"):
    return Measurement("prolate", line, name, 100, 1.0, error, seconds, seconds, 0.4)


class References(unittest.TestCase):
    def test_bending_energies(self):
        """Of a sphere in closed form; of the spheroid and of the red cell from another quadrature, all digits."""
        for meridian, exact in ((references.spheroid(1.0, 1.0), 8 * np.pi), (references.spheroid(0.5, 1.0), 30.903213288654), (references.biconcave, 47.489731324552)):
            self.assertAlmostEqual(references.bending_energy_of_revolution(meridian) / exact, 1.0, delta=1e-13)

    def test_directors_on_a_torus(self):
        """Against an independent solution of the differential equation, 11 digits, and the limit of normal directors."""
        for modulus, exact in ((10.0, 37.846363804), (100.0, 39.285313837), (1600.0, 39.466097908)):
            self.assertAlmostEqual(references.energy_of_directors_on_torus(modulus), exact, delta=5.1e-10)
        self.assertAlmostEqual(references.energy_of_directors_on_torus(1e9), 4 * np.pi**2, delta=1e-6)

    def test_caps(self):
        """A half ball has the energy of its surface; the energy's derivative with respect to the volume is the pressure 2/R."""
        volume, step = 2 * np.pi / 3, 1e-4
        self.assertAlmostEqual(references.energy_of_cap(90.0, volume), 2 * np.pi, delta=1e-14)
        slope = (references.energy_of_cap(60.0, volume + step) - references.energy_of_cap(60.0, volume - step)) / (2 * step)
        self.assertAlmostEqual(slope, 2 * np.sin(np.pi / 3) / 1.276185946465853, delta=1e-8)

    def test_an_error_is_never_smaller_than_the_reference_is_known(self):
        reference = references.Reference(2.0, 1e-6, "made up")
        self.assertEqual(reference.error(2.0), 1e-6)
        self.assertAlmostEqual(reference.error(2.2), 0.1)

    def test_spheroids(self):
        """Area 4 pi and the reduced volume that was asked for."""
        for volume, prolate in ((0.9, True), (0.65, False)):
            a, c = evolver.spheroid_of(volume, prolate)
            self.assertAlmostEqual(a * a * c, volume, delta=1e-12)
            self.assertEqual(c > a, prolate)


class Pareto(unittest.TestCase):
    points = (measured("3-D, degree 2", 1.0, 1e-2), measured("3-D, degree 2", 4.0, 1e-3), measured("3-D, degree 3", 2.0, 1e-4), measured("3-D, degree 3", 3.0, 2e-4),
              measured("3-D, degree 3", 8.0, 1e-8), measured("3-D, degree 4", 8.0, 1e-7))

    def test_front(self):
        self.assertEqual([m.seconds for m in pareto.front(self.points)], [1.0, 2.0, 8.0])
        self.assertEqual(pareto.front(self.points)[-1].error, 1e-8)
        self.assertEqual(pareto.front([]), [])

    def test_recommendation(self):
        self.assertEqual(pareto.recommended(self.points, 1e-2).seconds, 1.0)
        self.assertEqual(pareto.recommended(self.points, 5e-4).seconds, 2.0)
        self.assertIsNone(pareto.recommended(self.points, 1e-9))

    def test_an_accidental_zero_is_not_recommended(self):
        line = "3-D, degree 3"
        points = (measured(line, 1.0, 1e-9, "by accident"), measured(line, 2.0, 1e-5), measured(line, 4.0, 1e-7), measured(line, 8.0, 1e-10))
        self.assertEqual(pareto.recommended(points, 1e-6).seconds, 4.0)
        self.assertEqual(pareto.recommended(points, 1e-8).seconds, 8.0)
        self.assertEqual(pareto.recommended(points, 1e-4).seconds, 1.0)

    def test_kinds(self):
        points = (*self.points, measured("axial, degree 3", 0.1, 1e-9), measured("octant, degree 3", 0.5, 1e-4), measured("Surface Evolver, linear", 9.0, 1e-3))
        self.assertEqual({kind: len(group) for kind, group in pareto.by_kind(points).items()}, {"in space": 7, "meridian": 1, "Surface Evolver": 1})


class Report(unittest.TestCase):
    def test_table_reads_back(self):
        with tempfile.TemporaryDirectory() as folder:
            report.write_csv(Pareto.points, Path(folder) / "table.csv")
            self.assertEqual(tuple(report.read_csv(Path(folder) / "table.csv")), Pareto.points)

    def test_document(self):
        points = [measured("3-D, degree 3", 0.2, 1e-6, "3-D k3 r1"), measured("Surface Evolver, linear", 30.0, 5e-6, "linear r6"), measured("axial, degree 3", 0.05, 1e-7, "axial k3 r2")]
        text = report.document(CASES, points, [("prolate", "3-D k5 r9", "no memory")], "picture.svg", "the command")
        for words in ("| prolate | 3-D | 3-D k3 r1 (0.2 s) | 3-D k3 r1 (0.2 s) | - | - |", "| prolate | axial | axial k3 r2 (0.05 s) |", "| prolate | 1e-05 | 0.3 s | 3-D k3 r1 (0.2 s) | met |",
                      "| prolate | 1e-03 | 0.1 s | 3-D k3 r1 (0.2 s) | missed |", "| prolate | 1e-05 | 3-D k3 r1 (0.2 s) | 3-D k3 r1 (0.2 s) | linear r6 (30 s) | 150 | 50 |", "| prolate | 5.0e-06 | linear r6 (30 s) | 3-D k3 r1 (0.2 s) |", "no memory", "the command", "picture.svg"):
            self.assertIn(words, text)
        self.assertNotIn("sessile60", text)  # nothing was measured there

    def test_names_of_cases_and_settings_differ(self):
        names = [case.name for case in CASES]
        self.assertEqual(len(set(names)), len(names))
        for case in CASES:
            settings = [s.name for s in case.settings]
            self.assertEqual(len(set(settings)), len(settings), case.name)
            self.assertLessEqual(set(case.quick), set(settings), case.name)
            self.assertTrue(not case.evolver or case.evolver in evolver.PROBLEMS)

    def test_goals_are_of_cases(self):
        self.assertLessEqual({name for name, _, _ in report.GOALS}, {case.name for case in CASES})


class Study(unittest.TestCase):
    """run.py itself, on a few coarse settings."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.output = Path(folder.name) / "study"

    def study(self, *arguments, **environment):
        return subprocess.run([FOLDER / "run.py", "--output", self.output, "--repeats", "1", "--quick", *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False,
                              env={**os.environ, **environment})

    def test_small_study(self):
        with_evolver = ("--evolver",) if evolver.is_installed() else ()
        run = self.study("--bin", os.environ["PELLICLE_BINARIES"], "--cases", "biconcave", "prolate", "sessile60", *with_evolver)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertEqual(sorted(p.name for p in self.output.iterdir()), ["work_precision.csv", "work_precision.md", "work_precision.svg"])
        measurements = report.read_csv(self.output / "work_precision.csv")
        for case in ("biconcave", "prolate", "sessile60"):
            for line in ("3-D, degree 3", "axial, degree 3", "Surface Evolver, lagrange 4"):
                errors = [m.error for m in measurements if (m.case, m.line) == (case, line)]
                for coarse, fine in zip(errors, errors[1:]):
                    self.assertLess(fine, coarse / 10, (case, line))
        errors = {(m.case, m.setting): m.error for m in measurements}
        self.assertLess(errors["prolate", "axial k3 r2"], 1e-7)
        self.assertLess(errors["biconcave", "axial k3 r3"], 1e-6)
        self.assertLess(errors["sessile60", "axial k3 r1"], 1e-8)
        if with_evolver:
            self.assertLess(errors["prolate", "linear r2"], 3e-3)
            self.assertLess(errors["sessile60", "lagrange 4 r1"], 1e-6)
        for m in measurements:
            self.assertGreater(m.seconds, 0.0)
            self.assertGreater(m.unknowns, 0)
            self.assertLessEqual(m.assembly + m.linear_solve + m.output, m.seconds)

        before = (self.output / "work_precision.md").read_text(encoding="utf-8")
        again = self.study("--from", self.output / "work_precision.csv")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.output / "work_precision.md").read_text(encoding="utf-8"), before)

    def test_refusals(self):
        nowhere = self.study("--bin", self.output / "nowhere", "--cases", "prolate")
        self.assertEqual((nowhere.returncode, nowhere.stdout), (1, ""))
        self.assertIn("nowhere", nowhere.stderr)
        self.assertNotIn("Traceback", nowhere.stderr)
        unknown = self.study("--cases", "cube")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("'cube'", unknown.stderr)
        # Without Evolver on the path its part is left out with a message.
        without = self.study("--bin", self.output / "nowhere", "--cases", "prolate", "--evolver", PATH=str(self.output))
        self.assertIn(evolver.MISSING, without.stderr)


if __name__ == "__main__":
    unittest.main()
