# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shipped scenes of the complete Helfrich model. Reference values without another source are independent axisymmetric solutions (shape
equations, spectral elements)."""

import math
import subprocess
import sys
from pathlib import Path

from vesicle_program import SCENES, VesicleTest

PLOT = Path(__file__).parents[2] / "contrib" / "phase_diagram" / "plot.py"


class Curvature(VesicleTest):
    def test_spontaneous_curvature(self):
        run = self.solve(SCENES / "spontaneous_curvature.prm")
        q = run.quantities
        self.assert_within(q["bending_energy_over_8_pi_kappa"], 0.289174163999, 1e-5)
        self.assert_within(q["tension"], -2.542365041, 1e-3)
        self.assert_within(q["pressure"], -6.850758680, 1e-3)
        self.assertEqual(run.summary["stability"]["negative_eigenvalues"], 0)
        self.assertEqual(len(run.summary["stability"]["lowest"]), 6)

    def test_bilayer_coupling_finds_the_pear(self):
        """The symmetric prolate has 1.313226 at this M and is unstable."""
        run = self.solve(SCENES / "bilayer_coupling.prm", "Mesh/Symmetry=axial", "Mesh/Degree=5", "Mesh/Refinements=3")
        q = run.quantities
        self.assert_within(q["bending_energy_over_8_pi_kappa"], 1.253739211965, 1e-7)
        self.assert_within(q["bilayer_coupling_multiplier"], -12.81987566, 1e-5)
        self.assert_within(q["integrated_mean_curvature"], 1.06 * 4 * math.pi, 1e-9)
        self.assertEqual(run.summary["stability"]["negative_eigenvalues"], 0)

    def test_bilayer_coupling_in_space(self):
        run = self.solve(SCENES / "bilayer_coupling.prm")
        self.assert_within(run.quantities["bending_energy_over_8_pi_kappa"], 1.253739211965, 1e-4)
        self.assertEqual(run.summary["stability"]["negative_eigenvalues"], 0)

    def test_budding(self):
        run = self.solve(SCENES / "budding.prm")
        rows = run.table("history.csv")
        lengths = [float(row["domain_boundary_length"]) for row in rows]
        self.assertEqual(lengths, sorted(lengths, reverse=True))  # the neck closes as C0 grows
        # The same on meshes of 64 and 128 cells of degree 5: 0.24569, 0.24565; energy 25.459945.
        self.assert_within(run.quantities["neck_radius"], 0.24565, 1e-3)
        self.assert_within(run.quantities["total_energy"], 25.4599447, 1e-6)
        self.assert_within(run.quantities["domain_area"], 0.1 * 4 * math.pi, 1e-9)

    def test_domain_at_given_volume(self):
        run = self.solve(SCENES / "budding.prm", "Line tension/Line tension=0", "Vesicle/Start shape=prolate",
                         "Vesicle/Reduced volume=0.9", "Lipid domain/Area fraction=0.15", "Lipid domain/Spontaneous curvature=4",
                         "Effects=helfrich bending, lipid domain, line tension, area constraint, volume constraint")
        self.assert_within(run.quantities["bending_energy_over_8_pi_kappa"], 0.770498890941, 1e-7)
        self.assert_within(run.quantities["neck_radius"], 0.5493404517, 1e-5)


class RedCell(VesicleTest):
    def test_meridian_and_space_agree(self):
        axial = self.solve(SCENES / "red_cell.prm", "Mesh/Symmetry=axial", "Mesh/Refinements=3", name="axial").quantities
        space = self.solve(SCENES / "red_cell.prm", name="space").quantities
        self.assert_within(space["total_energy"], axial["total_energy"], 3e-3)
        self.assert_within(space["axis_thickness"], axial["axis_thickness"], 3e-3)
        self.assertLess(axial["axis_thickness"], 0.5 * axial["height"])  # biconcave
        self.assertGreater(axial["skalak_skin_energy"], 0.0)


class Tether(VesicleTest):
    plateau = 2 * math.pi

    def test_pull(self):
        run = self.solve(SCENES / "tether.prm")
        rows = run.table("history.csv")
        self.assertEqual(float(rows[0]["length"]), 0.0)
        for row in rows:
            if float(row["length"]) >= 15.0:
                self.assert_within(float(row["force"]), self.plateau, 1e-3)
        self.assert_within(run.quantities["force"], 6.2831898405, 2e-6)
        self.assert_within(run.quantities["mid_height_radius"], 1.003053478, 1e-6)
        self.assert_within(run.quantities["length"], 25.0, 1e-9)

    def test_length_is_the_last_of_a_pull(self):
        run = self.solve(SCENES / "tether.prm", "Tether/Length=5")
        self.assert_within(run.quantities["force"], 5.8486187585, 1e-6)
        self.assert_within(run.quantities["bending_energy"], 3.5463702586, 1e-6)

    def test_in_space(self):
        run = self.solve(SCENES / "tether.prm", "Tether/Length=2", "Mesh/Symmetry=none", "Mesh/Degree=3", "Mesh/Refinements=0",
                         "Load/Steps=4")
        self.assert_within(run.quantities["force"], 2.5841947140, 0.02)

    def test_force_control_passes_the_fold_by_arc_length(self):
        run = self.solve(SCENES / "tether.prm", "Tether/Control=force", "Tether/Force=1", "Load/Parameter=", "Load/From=",
                         "Continuation/Parameter=Tether/Force", "Continuation/Lower=0", "Continuation/Upper=9",
                         "Continuation/Scale=1", "Continuation/Maximum points=30")
        folds = [row for row in run.table("branch.csv") if row["is_fold"] == "1"]
        self.assert_within(float(folds[0]["Tether/Force"]), 1.15327360573 * self.plateau, 1e-6)
        self.assert_within(float(folds[0]["length"]), 7.73709968, 1e-3)

    def test_force_control_in_steps_stops_at_the_fold(self):
        run = self.run_scene(SCENES / "tether.prm", "Tether/Control=force", "Tether/Force=8", "Load/Parameter=Tether/Force",
                               "Newton/Maximum iterations=60", "Newton/Chart=ale")
        self.assertEqual(run.status, 1)
        self.assertIn("fold", run.stderr)


class PhaseDiagram(VesicleTest):
    def test_crossings_and_fold(self):
        run = self.solve(SCENES / "phase_diagram.prm")
        rows = run.table("phase_diagram.csv")
        folds = [row for row in rows if row["is_fold"] == "1"]
        self.assertEqual([row["branch"] for row in folds], ["stomatocyte"])
        self.assert_within(float(folds[0]["reduced_volume"]), 0.6608503265, 1e-4)
        subprocess.run([sys.executable, str(PLOT), "--no-picture", str(run.directory)], check=True, stdout=subprocess.PIPE)
        crossings = {(row["branch_a"], row["branch_b"]): float(row["reduced_volume"]) for row in run.table("crossings.csv")}
        self.assert_within(crossings["prolate", "oblate"], 0.651076484, 1e-4)
        self.assert_within(crossings["oblate", "stomatocyte"], 0.591189071, 1e-4)

    def test_in_space(self):
        run = self.solve(SCENES / "phase_diagram.prm", "Mesh/Symmetry=none", "Mesh/Degree=3", "Mesh/Refinements=2",
                         "Phase diagram/Branches=prolate, oblate", "Phase diagram/Reduced volumes=.64, .66, .9")
        subprocess.run([sys.executable, str(PLOT), "--no-picture", str(run.directory)], check=True, stdout=subprocess.PIPE)
        crossing = float(run.table("crossings.csv")[0]["reduced_volume"])
        self.assert_within(crossing, 0.651076484, 1e-3)


class Refusals(VesicleTest):
    """Messages name what is wrong and what would do."""

    cases = [
        (("Continuation/Parameter=Mesh/Degree",), "prolate", "Possible are: Helfrich bending/Spontaneous curvature, Vesicle/Reduced volume"),
        (("Stability/Follow unstable mode=true",), "prolate", "Analyses = stability"),
        (("Vesicle/Start shape=disc",), "prolate", "volume constraint"),
        (("Tether/Tip radius=30",), "tether", "smaller than Tether/Ring radius"),
        (("Phase diagram/Branches=prolate, oblat",), "phase_diagram", "oblate"),
    ]

    def test_each(self):
        for i, (assignments, scene, expected) in enumerate(self.cases):
            with self.subTest(expected):
                run = self.run_scene(SCENES / f"{scene}.prm", *assignments, name=f"case{i}")
                self.assertEqual(run.status, 2, run.stderr)
                self.assertIn(expected, run.stderr)
