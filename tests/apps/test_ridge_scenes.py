# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shipped scenes of ridges on meridians, and variations, against an independent axisymmetric solver (numbers in doc/numerics.md)."""

import unittest

from ridge_program import COARSE, FREE_LINE, SCENES, SLIDING, RidgeTest, effects


class RidgeRuns(RidgeTest):
    def solve_ridge(self, scene, *assignments, rejections=False, **keywords):
        """No warnings, the volume held, forces in balance, each load step quadratic and, unless steps may be rejected, in 12 iterations."""
        run = self.solve(SCENES / f"{scene}.prm", *assignments, **keywords)
        summary, q = run.summary, run.quantities
        self.assertEqual(summary["warnings"], [])
        self.assert_within(q["volume"], 2, 1e-10)
        self.assertLessEqual(abs(q["substrate_reaction_z"] - q["liquid_weight"]), 1e-6 * max(q["liquid_weight"], 0.08))
        energies = ("liquid_surface_energy", "solid_energy", "solid_skins_energy", "gravity_energy")
        self.assert_within(sum(q.get(name, 0) for name in energies), q["total_energy"], 1e-9)
        self.assert_within(q["liquid_surface_energy"], 0.08 * q["liquid_gas_area"], 1e-9)
        self.assert_quadratic(run.table("convergence.csv"), rejections)
        return run

    def assert_quadratic(self, table, rejections):
        residuals = {}
        for row in table:
            residuals.setdefault(int(row["step"]), []).append(float(row["relative_residual"]))
        for step, values in residuals.items():
            with self.subTest(step=step):
                if not rejections:
                    self.assertLessEqual(len(values), 12, values)
                self.assertLess(values[-1], max(1e-9, 0.02 * values[-2]), values)


class Scenes(RidgeRuns):
    def test_pinned(self):
        """Issue of the paper's Section 5 on a cylinder; heights of the apex are measured over the line."""
        run = self.solve_ridge("pinned_axial", "Output/Solution=true")
        q, summary = run.quantities, run.summary
        self.assertAlmostEqual(q["pressure"], 0.1816, delta=0.0002)
        self.assertAlmostEqual(q["apex_height"], 1.0353, delta=0.0005)
        self.assertAlmostEqual(q["ridge_radius"], 0.8675, delta=0.0005)
        self.assertAlmostEqual(q["ridge_height"], 0.0512, delta=0.0003)
        self.assertAlmostEqual(q["apparent_contact_angle_degrees"], 100.09, delta=0.05)
        self.assert_within(q["contact_line_material_radius"], 1, 1e-12)
        # The cap is a sphere whose pressure is 2 gamma/R.
        a, h = q["ridge_radius"], q["apex_height"]
        self.assert_within(q["pressure"], 0.16 / ((a**2 + h**2) / (2 * h)), 2e-5)
        self.assertGreater(q["solid_gas_area"], q["solid_liquid_area"])
        self.assertIn("history.csv", run.files)
        for name in ("summary.json", "used.prm", "convergence.csv", "solution.pvd", "solution_0000.vtu", "substrate_0000.vtu"):
            self.assertIn(name, run.files)
        history = run.table("history.csv")
        self.assertEqual(list(history[0])[:2], ["step", "load"])
        self.assertEqual(float(history[-1]["load"]), 1)
        self.assertEqual(summary["effects"], ["liquid surface", "volume constraint", "solid", "solid skins"])
        self.assertEqual(set(summary["unknowns"]), {"total", "position", "multipliers"})
        self.assertGreater(summary["mesh"]["cells"], 100)  # of the body
        self.assertEqual(summary["newton"]["steps"], len(history))

    def test_unpinned(self):
        """With free sides the skin folds the outer edge in; how far it comes depends on the mesh there, and the total energy with it."""
        run = self.solve_ridge("unpinned")
        q = run.quantities
        self.assertAlmostEqual(q["contact_line_material_radius"], 1.0760, delta=0.0007)
        self.assertAlmostEqual(q["ridge_radius"], 1.0050, delta=0.0003)
        self.assertAlmostEqual(q["ridge_height"], 0.07149, delta=0.0004)
        self.assertAlmostEqual(q["pressure"], 0.15707, delta=0.00005)
        self.assertAlmostEqual(q["apex_elevation"], 0.9236, delta=0.0003)
        self.assertAlmostEqual(q["apparent_contact_angle_degrees"], 80.59, delta=0.05)
        self.assertEqual(run.summary["unknowns"]["material position"], 1)

    def test_quadratic_law(self):
        q = self.solve_ridge("unpinned", "Solid/Volumetric law=quadratic", *COARSE).quantities
        self.assertAlmostEqual(q["contact_line_material_radius"], 1.0776, delta=0.002)
        self.assertAlmostEqual(q["ridge_height"], 0.06853, delta=0.0005)


class FreeLines(RidgeRuns):
    def ridge(self, *assignments, **keywords):
        return self.solve_ridge("unpinned", SLIDING, *COARSE, *assignments, **keywords).quantities

    def test_sliding_sides(self):
        """.08/.06/.06 on E = 1: material radius, radius and height of the line, angle, pressure, height of the apex, energies."""
        q = self.solve_ridge("unpinned", SLIDING).quantities
        self.assert_within(q["contact_line_material_radius"], 1.018518, 5e-5)
        self.assert_within(q["ridge_radius"], 1.004357, 5e-5)
        self.assert_within(q["ridge_height"], 0.06841, 4e-3)
        self.assertAlmostEqual(q["apparent_contact_angle_degrees"], 80.534, delta=0.02)
        self.assert_within(q["pressure"], 0.1571366, 3e-5)
        self.assert_within(q["apex_elevation"], 0.919173, 2e-5)
        self.assert_within(q["solid_energy"], 0.0147549, 3e-4)
        self.assert_within(q["total_energy"], 1.2162650, 1.2e-5)
        self.assertLess(q["total_energy"], 1.2163)
        # Neumann's triangle 131.8/131.8/96.4, which the solid's angle approaches slowly.
        self.assertAlmostEqual(q["neumann_angle_liquid_degrees"], q["neumann_angle_gas_degrees"], delta=0.3)
        self.assertTrue(96.4 < q["neumann_angle_solid_degrees"] < 102)
        self.assertLess(q["line_force_imbalance"], 0.05)

    def test_line_force_vanishes(self):
        """The body's force on the line falls with the cells there, about as the square root of their size."""
        coarse = self.ridge("Contact line/Cell size=0.04", name="coarse")["line_force_imbalance"]
        fine = self.ridge("Contact line/Cell size=0.0025", name="fine")["line_force_imbalance"]
        self.assertLess(fine, 0.3 * coarse)

    def test_stiff_substrates(self):
        """Young's law: 90 degrees, radius (3/pi)^(1/3)."""
        q = self.ridge("Substrate/Young modulus=40", "Contact line/Cell size=0.004")
        self.assert_within(q["ridge_radius"], 0.986533, 5e-5)
        self.assert_within(q["contact_line_material_radius"], 0.986878, 1e-4)
        self.assertAlmostEqual(q["apparent_contact_angle_degrees"], 89.389, delta=0.03)
        q = self.ridge("Substrate/Young modulus=1000", name="rigid")
        self.assert_within(q["ridge_radius"], 0.9847450218, 2e-4)
        self.assertAlmostEqual(q["apparent_contact_angle_degrees"], 90, delta=0.05)

    def test_incompressible_substrate(self):
        q = self.ridge("Substrate/Poisson ratio=0.5", rejections=True)
        self.assert_within(q["contact_line_material_radius"], 0.99677, 2e-4)
        self.assert_within(q["ridge_radius"], 1.00128, 1e-4)
        self.assert_within(q["ridge_height"], 0.06071, 6e-3)
        self.assert_within(q["pressure"], 0.158264, 5e-5)
        self.assert_within(q["total_energy"], 1.219640, 3e-5)

    def test_softness(self):
        """gamma/(E R) from 1e-3 to 1: the softer, the higher the ridge."""
        height = 0
        for modulus in (80, 8, 0.8, 0.08):
            q = self.ridge(f"Substrate/Young modulus={modulus}", name=f"softness{modulus}", rejections=True)
            self.assertGreater(q["ridge_height"], height)
            height = q["ridge_height"]
        self.assert_within(height, 0.1336, 1e-2)

    def test_weight(self):
        q = self.ridge(effects("gravity", "free contact line"), "Droplet/Body force=0.2")
        self.assert_within(q["liquid_weight"], 0.4, 1e-9)
        self.assert_within(q["contact_line_material_radius"], 1.136433, 3e-4)
        self.assert_within(q["ridge_radius"], 1.114051, 3e-4)
        self.assert_within(q["pressure"], 0.222687, 3e-4)
        self.assert_within(q["gravity_energy"], 0.0760248, 6e-4)
        self.assert_within(q["total_energy"], 1.3148784, 1.5e-4)


class Variations(RidgeRuns):
    def test_pinned_or_free(self):
        """Each scene with the other motion. A pinned line has more energy than the free one."""
        pinned = self.solve_ridge("unpinned", "Contact line/Motion=pinned", SLIDING, *COARSE, name="pinned")
        free = self.solve_ridge("unpinned", SLIDING, *COARSE, name="free")
        self.assertNotIn("material position", pinned.summary["unknowns"])
        self.assert_within(pinned.quantities["contact_line_material_radius"], 1, 1e-12)
        self.assertGreater(pinned.quantities["total_energy"], free.quantities["total_energy"] + 1e-5)

    def test_far_from_its_start(self):
        """The tensions of pinned_axial.prm want a line that is much smaller: found from nearby and, all at once, from the scene's radius."""
        near = self.solve_ridge("pinned_axial", FREE_LINE, "Contact line/Radius=0.65", name="near")
        self.assertAlmostEqual(near.quantities["contact_line_material_radius"], 0.640, delta=0.002)
        far = self.solve(SCENES / "pinned_axial.prm", FREE_LINE, "Load/Smallest step=0.05", name="far")
        self.assertEqual(far.summary["newton"]["steps"], 1)
        self.assert_within(far.quantities["contact_line_material_radius"], near.quantities["contact_line_material_radius"], 3e-3)
        self.assert_within(far.quantities["ridge_radius"], near.quantities["ridge_radius"], 2e-3)

    def test_weight_on_pinned_lines(self):
        """Reaction and weight, whatever holds the substrate; pressure and radius with sides that slide."""
        for sides in ("sliding", "clamped", "free"):
            run = self.solve_ridge("pinned_axial", effects("gravity"), "Droplet/Body force=0.2", f"Substrate/Lateral faces={sides}",
                                   "Contact line/Cell size=0.025", name=sides)
            self.assert_within(run.quantities["substrate_reaction_z"], 0.4, 1e-6)
            load = [float(row["load"]) for row in run.table("history.csv")]
            self.assertIn(1, load)  # all of the tensions, then the weight
            self.assertEqual(load[-1], 2)
            if sides == "sliding":
                self.assert_within(run.quantities["pressure"], 0.2852, 1e-3)
                self.assert_within(run.quantities["ridge_radius"], 0.9412, 1.5e-3)
                self.assert_within(run.quantities["total_energy"], 1.2657, 2e-4)

    def test_any_units(self):
        """Millimetres, kilopascals: the same shape."""
        base = ("Substrate/Lateral faces=sliding", *COARSE)
        one = self.solve_ridge("unpinned", *base, name="one").quantities
        length, modulus = 1e-3, 3e3
        gamma = modulus * length
        run = self.solve(SCENES / "unpinned.prm", "Mesh/Degree=2", SLIDING, f"Droplet/Volume={2 * length**3}", f"Contact line/Radius={length}",
                         f"Contact line/Cell size={0.02 * length}", f"Tensions/Liquid gas={0.08 * gamma}", f"Tensions/Solid liquid={0.06 * gamma}",
                         f"Tensions/Solid gas={0.06 * gamma}", f"Substrate/Half width={2 * length}", f"Substrate/Thickness={length}",
                         f"Substrate/Young modulus={modulus}", name="other")
        self.assert_within(run.quantities["ridge_height"], one["ridge_height"] * length, 1e-7)
        self.assert_within(run.quantities["total_energy"], one["total_energy"] * gamma * length**2, 1e-9)

    def test_the_scene_as_run(self):
        """used.prm gives the same result."""
        first = self.solve_ridge("pinned_axial", *COARSE, name="first")
        again = self.solve(first.directory / "used.prm", name="again")
        self.assert_within(again.quantities["total_energy"], first.quantities["total_energy"], 1e-12)


if __name__ == "__main__":
    unittest.main()
