# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small runs: energies against independent computations, what a run leaves behind, load steps, failures, start shapes from files."""

import math
import xml.etree.ElementTree

from vesicle_meshes import msh_text, spheroid
from vesicle_program import SCENES, SMALL, VesicleTest

PROLATE = SCENES / "prolate.prm"
FINE_MERIDIAN = ("Mesh/Symmetry=axial", "Mesh/Degree=5", "Mesh/Refinements=4")
QUANTITIES = ["area", "volume", "reduced_volume", "bending_energy", "bending_energy_over_8_pi_kappa", "total_energy", "tension", "pressure",
              "integrated_mean_curvature", "gauss_bonnet", "height", "equatorial_radius", "axis_thickness", "min_cell_quality", "cell_area_ratio"]
FILES = ["convergence.csv", "history.csv", "solution.pvd", "solution_0000.vtu", "summary.json", "used.prm"]


class Energies(VesicleTest):
    """E/(8 pi kappa) of meridians against shooting computations."""

    def energy(self, scene, expected, relative):
        run = self.solve(SCENES / scene, *FINE_MERIDIAN)
        self.assert_within(run.quantities["bending_energy_over_8_pi_kappa"], expected, relative)
        return run.quantities

    def test_prolate(self):
        q = self.energy("prolate.prm", 1.1896440328, 1e-9)
        self.assert_within(q["bending_energy"], q["bending_energy_over_8_pi_kappa"] * 8 * math.pi, 1e-12)
        self.assert_within(q["total_energy"], q["bending_energy"], 1e-12)
        # Scaling a shape gives 2 sigma A = 3 P V (bending has no scale).
        self.assert_within(2 * q["tension"] * q["area"], 3 * q["pressure"] * q["volume"], 1e-6)

    def test_discocyte(self):
        q = self.energy("discocyte.prm", 1.8262334456, 1e-8)
        self.assertLess(q["axis_thickness"], 0.7 * q["height"])

    def test_stomatocyte(self):
        q = self.energy("stomatocyte.prm", 1.97388824, 1e-6)
        self.assertLess(abs(q["integrated_mean_curvature"] / (4 * math.pi) - 0.5314), 2e-4)


class Files(VesicleTest):
    def test_files_and_names(self):
        run = self.solve(PROLATE, *SMALL)
        self.assertEqual(run.files, FILES)
        summary = run.summary
        self.assertEqual(list(summary), ["application", "version", "status", "effects", "analyses", "warnings", "mesh", "unknowns", "matrix", "loops", "newton",
                                         "seconds", "quantities"])
        self.assertEqual(summary["application"], "vesicle")
        self.assertEqual(summary["effects"], ["helfrich bending", "area constraint", "volume constraint"])
        self.assertEqual(summary["warnings"], [])
        self.assertEqual(summary["mesh"], {"cells": 16, "degree": 3})
        self.assertEqual(list(summary["quantities"]), QUANTITIES)
        unknowns = summary["unknowns"]
        self.assertEqual(unknowns["total"], sum(n for block, n in unknowns.items() if block != "total"))
        rows = run.table("history.csv")
        self.assertEqual(list(rows[0]), ["step", *QUANTITIES])
        self.assertEqual({name: float(rows[0][name]) for name in QUANTITIES}, summary["quantities"])
        iterations = run.table("convergence.csv")
        self.assertEqual(list(iterations[0]), ["step", "iteration", "relative_residual", "step_length", "energy", "rejected", "seconds"])
        self.assertEqual(len(iterations), summary["newton"]["iterations"])
        self.assertEqual(float(iterations[-1]["relative_residual"]), summary["newton"]["final_relative_residual"])

    def test_nothing_of_an_effect_that_is_not_listed(self):
        soap = self.write("soap.prm", "set Effects = surface tension, volume constraint\nsubsection Vesicle\n  set Reduced volume = 0.8\nend\n")
        run = self.solve(soap, "Mesh/Symmetry=axial", "Mesh/Degree=4")
        self.assertNotIn("moment", run.summary["unknowns"])
        self.assertEqual([name for name in run.quantities if "bending" in name], [])
        self.assertEqual(run.quantities["tension"], 1.0)  # the prescribed one
        # The sphere, with Laplace's pressure 2 sigma/R.
        radius = 0.8 ** (1 / 3)
        self.assert_within(run.quantities["pressure"], 2 / radius, 1e-6)
        self.assert_within(run.quantities["height"], 2 * radius, 1e-6)
        checked = self.call(soap, "--validate")
        self.assertNotIn("moment", checked.stdout)

    def test_units(self):
        plain = self.solve(PROLATE, *SMALL).quantities
        kappa, length = 1e-19, 1e-9
        metres = self.solve(PROLATE, *SMALL, f"Helfrich bending/Bending rigidity={kappa}", "Vesicle/Area=4*pi*1e-18", name="metres").quantities
        factors = {"area": length**2, "volume": length**3, "bending_energy": kappa, "total_energy": kappa, "tension": kappa / length**2,
                   "pressure": kappa / length**3, "integrated_mean_curvature": length, "height": length, "equatorial_radius": length,
                   "axis_thickness": length}
        for name, value in plain.items():
            # Multipliers are as good as the iteration's tolerance, energies better.
            self.assert_within(metres[name], value * factors.get(name, 1.0), 1e-7 if name in ("tension", "pressure") else 1e-9)


class LoadSteps(VesicleTest):
    REDUCED_VOLUME = "Load/Parameter=Vesicle/Reduced volume"

    def test_steps_on_a_surface(self):
        run = self.solve(PROLATE, "Mesh/Refinements=1", self.REDUCED_VOLUME, "Load/From=0.95", "Load/To=0.85", "Load/Steps=2")
        rows = run.table("history.csv")
        self.assertEqual(list(rows[0]), ["step", "Vesicle/Reduced volume", *QUANTITIES])
        self.assertEqual([row["step"] for row in rows], [str(i) for i in range(len(rows))])
        self.assertEqual((float(rows[0]["Vesicle/Reduced volume"]), float(rows[-1]["Vesicle/Reduced volume"])), (0.95, 0.85))
        for row in rows:
            self.assert_within(float(row["reduced_volume"]), float(row["Vesicle/Reduced volume"]), 1e-8)
        energies = [float(row["bending_energy"]) for row in rows]
        self.assertEqual(energies, sorted(energies))
        entries = xml.etree.ElementTree.parse(run.directory / "solution.pvd").getroot().findall(".//DataSet")
        self.assertEqual([entry.get("file") for entry in entries], [f"solution_{i:04d}.vtu" for i in range(len(rows))])
        self.assert_within(float(entries[-1].get("timestep")), 0.85, 1e-6)
        for entry in entries:
            self.assertTrue((run.directory / entry.get("file")).is_file())
        self.assertEqual(run.summary["newton"]["steps"], len(rows))
        self.assertEqual(run.quantities["bending_energy"], energies[-1])
        # One solve from a spheroid of the last volume ends at the same shape.
        direct = self.solve(PROLATE, "Mesh/Refinements=1", "Vesicle/Reduced volume=0.85", name="direct")
        self.assert_within(run.quantities["bending_energy"], direct.quantities["bending_energy"], 1e-4)

    def test_stopped_on_the_way(self):
        run = self.run_scene(PROLATE, *SMALL, self.REDUCED_VOLUME, "Load/To=0.3", "Load/Steps=1", "Load/Smallest step=0.6")
        self.assertEqual(run.status, 1)
        self.assertIn("Load stepping stopped at Vesicle/Reduced volume = 0.9 on the way to 0.3", run.stderr)
        self.assertEqual(len(run.table("history.csv")), 1)
        self.assertEqual(run.files, FILES)
        self.assertEqual(run.summary["status"], "failed")
        self.assert_within(run.quantities["bending_energy_over_8_pi_kappa"], 1.1896440328, 1e-6)


class DoubtfulStates(VesicleTest):
    LONG = ("Vesicle/Reduced volume=0.65", "Mesh/Refinements=1")

    def test_folded_mesh_is_reported(self):
        # In the normal graph the nodes of a long prolate crowd at its tips, and Newton finds a state with folded cells.
        folded = self.solve(PROLATE, *self.LONG, "Newton/Chart=graph", name="folded")
        self.assertGreater(abs(folded.quantities["gauss_bonnet"] - 2), 0.5)
        self.assertTrue(any("gauss_bonnet" in w and "spurious" in w for w in folded.summary["warnings"]), folded.summary["warnings"])
        sound = self.solve(PROLATE, *self.LONG, name="sound")
        self.assertEqual(sound.summary["warnings"], [])


class Failures(VesicleTest):
    def test_too_few_iterations(self):
        run = self.run_scene(PROLATE, *SMALL, "Newton/Maximum iterations=1")
        self.assertEqual(run.status, 1)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        for words in ("not converged in 1 iterations", "Newton/Maximum iterations", "Try"):
            self.assertIn(words, run.stderr)
        self.assertNotIn("..", run.stderr)
        summary = run.summary
        self.assertEqual(summary["status"], "failed")
        self.assertIn(summary["message"], run.stderr)
        self.assertEqual(len(run.table("convergence.csv")), summary["newton"]["iterations"])
        self.assertEqual(list(summary["quantities"]), QUANTITIES)
        self.assertTrue({"used.prm", "history.csv"} <= set(run.files))
        # A number that is not there is named, a number that is there is finite (Run.summary refuses others).
        if "final_relative_residual" not in summary["newton"]:
            self.assertTrue(any("final_relative_residual" in warning for warning in summary["warnings"]))

    def test_nothing_holds_the_surface_open(self):
        scene = self.write("collapse.prm", "set Effects = surface tension\n")
        run = self.run_scene(scene, *SMALL, "Newton/Maximum iterations=10")
        self.assertEqual((run.status, run.summary["status"]), (1, "failed"))


class StartShapeFromFile(VesicleTest):
    def test_facets_become_a_vesicle(self):
        self.write("facets.msh", msh_text(*spheroid(1.9)))
        scene = self.write("facets.prm", "subsection Mesh\n  set File = facets.msh\n  set Degree = 3\n  set Refinements = 1\nend\n"
                                         "subsection Vesicle\n  set Start shape = file\nend\n")
        run = self.solve(scene)
        self.assertEqual(run.summary["mesh"], {"cells": 96, "degree": 3})
        self.assert_within(run.quantities["area"], 4 * math.pi, 1e-8)
        self.assert_within(run.quantities["bending_energy_over_8_pi_kappa"], 1.1896440328, 1e-4)
        # used.prm names the file so that it is found from anywhere.
        self.assertEqual(self.call(run.directory / "used.prm", "--validate").returncode, 0)
