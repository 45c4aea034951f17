# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shipped scenes of directors on held surfaces, and variations. Reference values: closed forms, and independent spectral solutions of the
axisymmetric problems (to 1e-12) and of two inclusions for small tilt."""

import math
import unittest

from director_program import SCENES, DirectorTest

FREE_OF_TILT = 4 * math.pi  # sphere with normal directors, K = 1


class DirectorRuns(DirectorTest):
    def solve_directors(self, scene, *assignments, iterations=8, **keywords):
        """No warnings, energies that add up, at most 8 Newton steps and a quadratic end."""
        run = self.solve(SCENES / f"{scene}.prm", *assignments, **keywords)
        summary, q = run.summary, run.quantities
        self.assertEqual(summary["warnings"], [])
        self.assert_within(q["tilt_energy"] + q["director_gradient_energy"], q["total_energy"], 1e-12)
        self.assertEqual(summary["unknowns"]["position"], 0)
        self.assertLessEqual(summary["newton"]["iterations"], iterations)
        residuals = [float(row["relative_residual"]) for row in run.table("convergence.csv")]
        for before, now in zip(residuals, residuals[1:]):
            if before < 1e-2:
                self.assertLess(now, max(1e-12, 100 * before**2), residuals)
        return run

    def energy(self, *arguments, **keywords):
        return self.solve_directors(*arguments, **keywords).quantities["total_energy"]


class Scenes(DirectorRuns):
    def test_tilted_sphere(self):
        """Turned directors with noise come back to the normals."""
        run = self.solve_directors("tilted_sphere", "Output/Solution=true")
        q = run.quantities
        self.assert_within(q["total_energy"], FREE_OF_TILT, 3e-7)
        self.assertLess(q["tilt_energy"], 1e-6)
        self.assert_within(q["null_lagrangian_energy"], FREE_OF_TILT, 2e-8)
        for name in ("summary.json", "used.prm", "convergence.csv", "solution.pvd", "solution_0000.vtu"):
            self.assertIn(name, run.files)
        self.assertIn('Name="director"', (run.directory / "solution_0000.vtu").read_text(encoding="utf-8", errors="replace"))

    def test_no_tilt_from_a_tilted_start(self):
        """With k_t = inf the start is normal but for the noise, and a few iterations lead back."""
        run = self.solve_directors("tilted_sphere", "Director/Tilt modulus=inf")
        self.assert_within(run.quantities["total_energy"], FREE_OF_TILT, 3e-7)

    def test_moduli_and_size_of_the_sphere(self):
        """4 pi K and 4 pi (K + kappa_G) for any radius, in any units."""
        q = self.solve_directors("tilted_sphere", "Vesicle/Area=36*pi", "Director/Bending modulus=2", "Director/Tilt modulus=7",
                                 "Director/Gaussian modulus=-0.5").quantities
        self.assert_within(q["total_energy"], 8 * math.pi, 1e-6)
        self.assert_within(q["null_lagrangian_energy"], 6 * math.pi, 1e-7)

    def test_torus(self):
        """The limit of a large tilt modulus, with the mixed form the same accuracy for all."""
        for modulus, energy in ((10, 37.846363804208), (100, 39.285313836854), (1600, 39.466097907625), (1e6, 39.478397865193),
                                ("inf", 4 * math.pi**2)):
            q = self.solve_directors("torus_tilt_limit", f"Director/Tilt modulus={modulus}", name=f"torus{modulus}").quantities
            self.assert_within(q["total_energy"], energy, 3e-7)
            self.assertLess(abs(q["null_lagrangian_energy"]), 2e-6)

    def test_inclusion(self):
        """Radius a, outer radius b, tilt, k_t, K, energy."""
        rows = [(1, 20, 0.5, 1, 1, 1.3141297247384), (2, 15, 0.3, 4, 1, 1.2854866271368), (1, 20, 1.2, 100, 1, 42.5896426854383),
                (1, 20, 0.5, 0.25, 2, 1.8079992487518), (1, 20, 1.2, 1, 1, 7.0376296593017), (1, 10, 0.5, 1, 1, 1.3141297403648)]
        for a, b, tilt, k_t, bending, energy in rows:
            row = (f"Inclusion/Radius={a}", f"Inclusion/Outer radius={b}", f"Inclusion/Edge tilt={tilt}", f"Director/Tilt modulus={k_t}",
                   f"Director/Bending modulus={bending}")
            with self.subTest(row=row):
                self.assert_within(self.energy("inclusion", *row), energy, 1e-9)
                self.assert_within(self.energy("inclusion", "Mesh/Symmetry=none", "Mesh/Refinements=1", *row, name="space"), energy, 3e-7)

    def test_two_inclusions(self):
        """Repulsion, and attraction of opposite ones, over the distance; for small tilt."""
        one = self.energy("inclusion", "Inclusion/Edge tilt=0.05", name="one")
        self.assert_within(one, 0.0133456296746, 1e-9)
        for distance, second, linear, quartic in ((3, "alike", 2.12241e-3, 2.12250242e-3), (4, "alike", 5.28849e-4, 5.28951671e-4),
                                                  (6, "alike", 5.43857e-5, 5.44017980e-5), (4, "opposite", -4.44188e-4, None)):
            with self.subTest(distance=distance, second=second):
                both = self.energy("two_inclusions", f"Inclusion/Distance={distance}", f"Inclusion/Second={second}", name="both")
                self.assert_within(both - 2 * one, quartic or linear, 2e-4 if quartic else 2e-3)

    def test_inclusion_on_vesicle(self):
        """Sphere of radius 5: edge tilt, k_t, energy. The sign of the tilt matters."""
        for tilt, k_t, energy in ((0.3, 1, 12.524504229908), (-0.3, 1, 13.283022195940), (0.3, 100, 15.000967376145), (1, 1, 15.873941543721)):
            row = (f"Inclusion/Edge tilt={tilt}", f"Director/Tilt modulus={k_t}")
            with self.subTest(row=row):
                self.assert_within(self.energy("inclusion_on_vesicle", *row), energy, 2e-8 * max(1, k_t))
        q = self.solve_directors("inclusion_on_vesicle", "Mesh/Symmetry=none", "Mesh/Refinements=2", name="space").quantities
        self.assert_within(q["total_energy"], 12.524504229908, 5e-7)


class FreeSurfaces(DirectorRuns):
    """Membranes whose rims at inclusions are held, the rest is free."""

    PRESSED = ("Surface/Motion=free", "Effects=director, area constraint, pressure", "Pressure/Pressure=0.1")
    TENSE = ("Surface/Motion=free", "Effects=director, surface tension", "Surface tension/Surface tension=0.1")

    def solve_free(self, scene, *assignments, **keywords):
        run = self.solve(SCENES / f"{scene}.prm", *assignments, **keywords)
        self.assertEqual(run.summary["warnings"], [])
        self.assertLessEqual(run.summary["newton"]["iterations"], 8)
        return run.quantities

    def test_inclusion_on_vesicle(self):
        """Without tilt a sphere with P = 2 sigma/R. With it the vesicle gives way: less energy than held."""
        q = self.solve_free("inclusion_on_vesicle", *self.PRESSED, "Inclusion/Edge tilt=0")
        self.assert_within(q["tension"], 0.25, 1e-7)
        self.assert_within(q["height"], 5 * (1 + math.cos(0.2)), 1e-5)
        self.assert_within(q["area"], 50 * math.pi * (1 + math.cos(0.2)), 1e-9)
        self.assert_within(q["total_energy"] - q["pressure_energy"], 2 * math.pi * (1 + math.cos(0.2)), 1e-6)
        sphere = q["pressure_energy"]
        for tilt, held in ((0.3, 12.524504229908), (-0.3, 13.283022195940)):
            axial = self.solve_free("inclusion_on_vesicle", *self.PRESSED, f"Inclusion/Edge tilt={tilt}", name="axial")["total_energy"]
            self.assertLess(axial, held + sphere)
            space = self.solve_free("inclusion_on_vesicle", *self.PRESSED, f"Inclusion/Edge tilt={tilt}", "Mesh/Symmetry=none",
                                    "Mesh/Refinements=1", name="space")["total_energy"]
            self.assert_within(space, axial, 5e-5)

    def test_flat_membrane_under_tension(self):
        """The membrane bends towards the directors, which are held where they stand."""
        axial = self.solve_free("inclusion", *self.TENSE)["total_energy"]
        self.assertLess(axial, 39.9 * math.pi + 1.3141297247384)
        space = self.solve_free("inclusion", *self.TENSE, "Mesh/Symmetry=none", "Mesh/Refinements=1", name="space")["total_energy"]
        self.assert_within(space, axial, 1e-7)

    def test_vesicles_with_tilt(self):
        """Prolate of reduced volume .9, oblate of .65: an independent axisymmetric solution (1e-12)."""
        scene = self.write("vesicle.prm", """set Effects = director, area constraint, volume constraint
subsection Mesh
  set Symmetry    = axial
  set Refinements = 3
end
""")
        rows = [("prolate", 0.9, 10, 16.488156498235, -10.1245823114), ("prolate", 0.9, 1000, 17.323171072674, -11.3346993918),
                ("prolate", 0.9, "inf", 17.332645017521, -11.3452614194), ("oblate", 0.65, 100, 32.075226684926, -14.4034207106)]
        for shape, volume, modulus, energy, pressure in rows:
            with self.subTest(shape=shape, modulus=modulus):
                run = self.solve(scene, f"Vesicle/Start shape={shape}", f"Vesicle/Reduced volume={volume}", f"Director/Tilt modulus={modulus}")
                self.assert_within(run.quantities["total_energy"], energy, 1e-7)
                self.assert_within(run.quantities["pressure"], pressure, 1e-6)
                self.assertLessEqual(run.summary["newton"]["iterations"], 8)
        run = self.solve(scene, "Vesicle/Start shape=oblate", "Vesicle/Reduced volume=0.65", "Director/Tilt modulus=100",
                         "Load/Parameter=Director/Tilt modulus", "Load/To=10", "Load/Steps=3", name="load")
        self.assert_within(run.quantities["total_energy"], 25.097939656235, 1e-7)


class Variations(DirectorRuns):
    def test_noise(self):
        """From 5 % noise to the same energy."""
        noise = ("Director field/Noise=0.05", "Director field/Random seed=7")
        self.assert_within(self.energy("torus_tilt_limit", *noise), 39.285313836854, 3e-7)
        self.assert_within(self.energy("inclusion", *noise), 1.3141297247384, 1e-9)
        self.assert_within(self.energy("inclusion", "Mesh/Symmetry=none", "Mesh/Refinements=1", *noise), 1.3141297247384, 3e-7)

    def test_any_units(self):
        """Nanometres and k_B T: the same tilt."""
        length, energy = 2.5, 4.0
        q = self.solve_directors("inclusion", f"Inclusion/Radius={length}", f"Inclusion/Outer radius={20 * length}",
                                 f"Director/Bending modulus={energy}", f"Director/Tilt modulus={energy / length**2}").quantities
        self.assert_within(q["total_energy"], energy * 1.3141297247384, 1e-9)

    def test_load_on_the_tilt_modulus(self):
        """Tilt moduli in steps end where the last one alone does."""
        run = self.solve(SCENES / "torus_tilt_limit.prm", "Load/Parameter=Director/Tilt modulus", "Load/To=1600", "Load/Steps=3")
        self.assert_within(run.quantities["total_energy"], 39.466097907625, 3e-7)
        self.assertEqual(float(run.table("history.csv")[-1]["Director/Tilt modulus"]), 1600)

    def test_the_scene_as_run(self):
        """used.prm gives the same result."""
        first = self.solve_directors("inclusion", name="first")
        again = self.solve(first.directory / "used.prm", name="again")
        self.assert_within(again.quantities["total_energy"], first.quantities["total_energy"], 1e-13)


if __name__ == "__main__":
    unittest.main()
