# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shipped scenes of drops by their cap alone, as they are, against closed forms and independent computations."""

import math
import unittest

from droplet_program import AXIAL, SCENES, DropletTest

VOLUME = 2 * math.pi / 3


class Scenes(DropletTest):
    def solve_scene(self, scene, *assignments, **keywords):
        """Few iterations, a quadratic tail, no warnings, the volume held."""
        run = self.solve(SCENES / f"{scene}.prm", *assignments, **keywords)
        self.assertEqual(run.summary["warnings"], [])
        self.assertLessEqual(run.summary["newton"]["iterations"], 8)
        residuals = [float(row["relative_residual"]) for row in run.table("convergence.csv")]
        for before, now in zip(residuals, residuals[1:]):
            if before < 1e-2:
                self.assertLess(now, max(1e3 * before**2, 0.05 * before), residuals)
        self.assert_within(run.quantities["volume"], VOLUME, 1e-9)
        return run.quantities

    def assert_balance(self, q, angle):
        pull = 2 * math.pi * q["contact_radius"] * math.sin(math.radians(angle))
        self.assert_within(q["base_pressure_force"], pull + q["liquid_weight"], 1e-8)

    def test_sessile(self):
        q = self.solve_scene("sessile")
        self.assert_within(q["contact_radius"], 1.276185946465853, 1e-8)
        self.assert_within(q["apex_height"], 0.7368062997280773, 1e-7)
        self.assert_within(q["total_energy"], 4.263797221534637, 2e-9)
        self.assert_within(q["pressure"], 1.357208808297453, 1e-8)
        self.assert_within(q["liquid_gas_area"], 6.82207555445542, 1e-8)
        self.assert_within(q["solid_liquid_area"], 5.116556665841565, 1e-8)
        self.assert_within(q["contact_angle_degrees"], 60, 1e-7)
        self.assertEqual(q["liquid_weight"], 0)
        self.assert_balance(q, 60)

    def test_sessile_gravity(self):
        q = self.solve_scene("sessile_gravity")
        self.assert_within(q["contact_radius"], 1.069538931973, 1e-7)
        self.assert_within(q["apex_height"], 0.880630769504, 1e-6)
        self.assert_within(q["pressure"], 2.452759290254, 1e-7)
        self.assert_within(q["gravity_energy"], 0.689062752985, 1e-7)
        self.assert_within(q["total_energy"], 7.016507814302, 1e-8)
        self.assert_within(q["liquid_weight"], VOLUME, 1e-9)
        self.assert_balance(q, 90)

    def test_on_sphere(self):
        q = self.solve_scene("on_sphere")
        self.assert_within(q["contact_radius"], 0.82593620252088, 1e-7)
        self.assert_within(q["total_energy"], 6.8857914910843, 1e-7)
        self.assert_within(q["pressure"], 2.2637953493073, 1e-7)
        self.assert_within(q["apex_height"], 1.0699127844908, 1e-5)
        cavity = self.solve_scene("on_sphere", "Substrate/Side=inside", name="cavity")
        self.assert_within(cavity["contact_radius"], 1.1974877174977, 1e-7)

    def test_rough(self):
        q = self.solve_scene("rough")
        self.assert_within(q["contact_radius"], 1.1095136016, 1e-7)
        self.assert_within(q["total_energy"], 5.1003329173, 1e-8)
        self.assert_within(q["pressure"], 1.7539324750, 1e-7)
        self.assertLess(q["contact_angle_degrees_max"] - q["contact_angle_degrees_min"], 0.01)


class Variations(DropletTest):
    def test_two_symmetries_agree(self):
        scene = (SCENES / "sessile_gravity.prm", "Droplet/Contact angle=60")
        axial, space = self.solve(*scene, AXIAL, name="axial"), self.solve(*scene, name="space")
        for name in ("contact_radius", "pressure", "total_energy", "gravity_energy", "apex_height"):
            self.assert_within(space.quantities[name], axial.quantities[name], 3e-6)

    def test_any_units(self):
        """A drop of water of 1 mm^3 in SI: the same shape."""
        gamma, volume = 0.072, 1e-9
        run = self.solve(SCENES / "sessile.prm", AXIAL, f"Droplet/Volume={volume}", f"Droplet/Surface tension={gamma}")
        length = (volume / VOLUME) ** (1 / 3)
        self.assert_within(run.quantities["contact_radius"], 1.276185946465853 * length, 1e-8)
        self.assert_within(run.quantities["total_energy"], 4.263797221534637 * gamma * length**2, 1e-9)
        self.assert_within(run.quantities["pressure"], 1.357208808297453 * gamma / length, 1e-8)

    def test_load_steps(self):
        """To a heavier drop, a larger one, another angle: every step is the drop that a run of its own finds."""
        for parameter, to, exact in (("Bond number", "0.6299605249474366", 1.332567052010), ("Volume", "4*pi/3", None),
                                     ("Contact angle", "120", 0.7274157573144809)):
            effects = "Effects=liquid surface, volume constraint, wetting" + (", gravity" if parameter == "Bond number" else "")
            run = self.solve(SCENES / "sessile.prm", AXIAL, effects, f"Load/Parameter=Droplet/{parameter}", f"Load/To={to}", "Load/Steps=4",
                             name=parameter.replace(" ", "_"))
            self.assertGreaterEqual(run.summary["newton"]["steps"], 4)
            self.assert_within(run.quantities["contact_radius"], exact or 1.276185946465853 * 2 ** (1 / 3), 1e-5)

    def test_continuation(self):
        """Along the branch by its arc length: the pressure falls as the volume grows."""
        run = self.solve(SCENES / "sessile.prm", AXIAL, "Continuation/Parameter=Droplet/Volume", "Continuation/Upper=4*pi/3")
        self.assert_within(run.quantities["contact_radius"], 1.276185946465853 * 2 ** (1 / 3), 1e-6)
        self.assert_within(run.quantities["pressure"], 1.357208808297453 / 2 ** (1 / 3), 1e-6)

    def test_stability(self):
        """Free on a plane; off the top of a mountain two ways."""
        stability = ("Analyses=stability", "Mesh/Refinements=1")
        plane = self.solve(SCENES / "sessile.prm", *stability, name="plane")
        self.assertEqual(plane.summary["stability"]["negative_eigenvalues"], 0)
        mountain = self.solve(SCENES / "rough.prm", *stability, "Substrate/Height=-0.15*(x^2 + y^2)", name="mountain")
        self.assertEqual(mountain.summary["stability"]["negative_eigenvalues"], 2)


if __name__ == "__main__":
    unittest.main()
