# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cosserat shells as programs: the shipped scene, loads in steps and along a branch, and a user's mistakes."""

from director_program import SCENES, DirectorTest

SCENE = SCENES / "pinched_hemisphere.prm"
COARSE = "Mesh/Refinements=1"

# Overrides of pinched_hemisphere.prm, and what the message must hold.
CASES = [
    (["Shell/Shape=dome"], ["Shape", "'dome'", "hemisphere"]),
    (["Shell/Angle=90"], ["Shell", "Angle", "(0, 90)"]),
    (["Shell/Radius=0"], ["Radius", "a number > 0"]),
    (["Shell/Load shape=x"], ["Load shape", "no effect", "dead load"]),
    (["Cosserat shell/Poisson ratio=0.5"], ["Poisson ratio", "(-1, 0.5)"]),
    (["Cosserat shell/Thickness=0"], ["Thickness", "a number > 0"]),
    (["Cosserat shell/Shear correction=2/3"], ["Shear correction", "'2/3'", "5/6"]),
    (["Effects=cosserat shell, point loads, dead load", "Dead load/Force=1, 2"], ["Dead load", "2 numbers", "three"]),
    (["Effects=cosserat shell, point loads, pressure"], ["pressure", "hemisphere", "sphere"]),
    (["Effects=cosserat shell, point loads, helfrich bending"], ["helfrich bending", "'dead load'"]),
    (["Mesh/Symmetry=axial"], ["Mesh/Symmetry = axial", "none"]),
    (["Load/Parameter=Shell/Angle", "Load/To=20"], ["Shell/Angle", "cannot change"]),
]


class Shells(DirectorTest):
    def test_shipped_scene(self):
        run = self.solve(SCENE)
        q = run.quantities
        self.assertEqual(run.summary["warnings"], [])
        self.assertLessEqual(run.summary["newton"]["iterations"], 8)
        self.assert_within(q["load_point_displacement"], 0.0940, 0.005)
        self.assertEqual(q["load_point_displacement"], q["displacement_at_load_point_b"])
        # Linear theory: 0.09372 at all points.
        self.assert_within(0.5 * (q["displacement_at_load_point_a"] + q["displacement_at_load_point_b"]), 0.09372, 0.003)
        # Bending nearly alone, and nearly half of the work of the four forces of 2.
        self.assertLess(q["shell_strain_energy"], 0.01 * q["shell_bending_energy"])
        self.assert_within(q["total_energy"], -2 * (q["displacement_at_load_point_a"] + q["displacement_at_load_point_b"]), 1e-3)
        self.assertIn("solution_0000.vtu", run.files)
        vtu = (run.directory / "solution_0000.vtu").read_text(encoding="utf-8", errors="replace")
        for field in ("director", "displacement"):
            self.assertIn(f'Name="{field}"', vtu)

    def test_load_steps(self):
        run = self.solve(SCENE, COARSE, "Load/Parameter=Point loads/Force", "Load/From=20", "Load/To=100", "Load/Steps=4")
        forces = [float(row["Point loads/Force"]) for row in run.table("history.csv")]
        self.assertEqual((forces[0], forces[-1]), (20, 100))
        self.assertGreater(run.quantities["load_point_displacement"], 3.5)

    def test_balloon(self):
        """P = E h (l^2 - 1)/((1 - nu) l R) at l = 1.1, in other units of length and energy."""
        thin = 2e5 * 0.05 * 0.21 / (0.7 * 1.1 * 5)
        run = self.solve(SCENE, "Mesh/Refinements=0", "Effects=cosserat shell, point loads, pressure", "Shell/Shape=sphere", "Shell/Radius=5", "Point loads/Force=0",
                         "Cosserat shell/Young modulus=2e5", "Cosserat shell/Thickness=0.05", f"Pressure/Pressure={thin!r}")
        self.assert_within(run.quantities["displacement_at_load_point_a"], 0.5, 2e-3)

    def test_refusals(self):
        self.assert_refusals(SCENE, CASES)
