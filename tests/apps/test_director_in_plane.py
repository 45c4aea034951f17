# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directors that lie in the surface: their energy, the defects that are reported, the fields in the files."""

import subprocess
from pathlib import Path

from director_program import SCENES, DirectorTest

SCENE = SCENES / "in_plane_sphere.prm"
# Of axisymmetric directors on the unit sphere with K = 1 and k_n = 100, by a spectral method: near the constant e_z, with the lowest eigenvalue of their
# second variation that is axisymmetric; and round the axis.
ENERGY, NORMAL_PART, TWIST = 25.18397580323, 4.92903604263, 0.266134
ENERGY_ROUND_AXIS = 27.96210498847


class InPlane(DirectorTest):
    def defects(self, run):
        """(z, charge), from below."""
        rows = run.table("defects.csv")
        for row in rows:
            self.assertLess(abs(float(row["x"])) + abs(float(row["y"])), 0.05)
        return sorted((float(row["z"]), int(row["charge"])) for row in rows)

    def check_two_poles(self, run):
        self.assertEqual(run.quantities["defects"], 2)
        self.assertEqual(run.quantities["defect_charge"], 2)
        (below, first), (above, second) = self.defects(run)
        self.assertEqual((first, second), (1, 1))
        self.assertLess(abs(below + 1), 0.01)
        self.assertLess(abs(above - 1), 0.01)

    def test_shipped_scene(self):
        run = self.solve(SCENE)
        self.check_two_poles(run)
        self.assert_within(run.quantities["total_energy"], ENERGY, 1e-4)
        self.assert_within(run.quantities["normal_director_energy"], NORMAL_PART, 5e-3)
        self.assertNotIn("tilt_energy", run.quantities)
        self.assertEqual(run.summary["warnings"], [])
        self.assertEqual(run.summary["stability"]["negative_eigenvalues"], 0)
        self.assertLess(min(abs(value / TWIST - 1) for value in run.summary["stability"]["lowest"]), 5e-3)

        check = Path(__file__).with_name("check_director_fields.py")
        fields = subprocess.run(["/usr/bin/python3", check, run.directory / "solution_0000.vtu"],
                                capture_output=True, text=True, check=False)
        if fields.returncode != 77:
            self.assertEqual(fields.returncode, 0, fields.stderr)
            self.assertGreater(float(fields.stdout), 0.99)

    def test_axial(self):
        run = self.solve(SCENE, "Mesh/Symmetry=axial", "Mesh/Refinements=4", "Director field/Noise=0")
        self.check_two_poles(run)
        self.assert_within(run.quantities["total_energy"], ENERGY, 1e-6)
        self.assert_within(run.quantities["normal_director_energy"], NORMAL_PART, 1e-5)

    def test_round_the_axis(self):
        run = self.solve(SCENE, "Director field/Start=azimuthal")
        self.check_two_poles(run)
        self.assert_within(run.quantities["total_energy"], ENERGY_ROUND_AXIS, 1e-3)
        self.assertEqual(run.summary["stability"]["negative_eigenvalues"], 0)

    def test_normals_have_none(self):
        run = self.solve(SCENES / "tilted_sphere.prm", "Mesh/Refinements=1")
        self.assertNotIn("defects", run.quantities)
        self.assertNotIn("defects.csv", run.files)
