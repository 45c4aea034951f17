# SPDX-License-Identifier: LGPL-2.1-or-later
"""Section Accuracy: runs that reach an accuracy, against known answers; and runs that cannot."""

import math

import director_program
import droplet_program
import ridge_program
import vesicle_program
from accuracy_levels import check_reached, levels

# E/(8 pi kappa) of axisymmetric equilibria: an independent spectral solver, ten digits.
PROLATES = {0.95: 1.0955648795, 0.9: 1.1896440328, 0.8: 1.3874404324, 0.65: 1.8279298731}
OBLATES = {0.95: 1.1061146407, 0.8: 1.4525386286, 0.65: 1.8262334456}


class Vesicles(vesicle_program.VesicleTest):
    scene = vesicle_program.SCENES / "prolate.prm"

    def reach(self, target, shape, volume, reference, *further, name="run"):
        run = self.solve(self.scene, f"Accuracy/Target={target}", f"Vesicle/Start shape={shape}", f"Vesicle/Reduced volume={volume}",
                         "Output/Solution=false", *further, name=name)
        check_reached(self, run, "bending_energy", 8 * math.pi * reference, target)
        return run

    def test_on_meridians(self):
        for shape, energies in (("prolate", PROLATES), ("oblate", OBLATES)):
            for volume, energy in energies.items():
                with self.subTest(shape=shape, volume=volume):
                    self.reach(1e-8, shape, volume, energy, "Mesh/Symmetry=axial", name=f"{shape}{volume}")

    def test_files_are_those_of_the_last_level(self):
        run = self.solve(self.scene, "Accuracy/Target=1e-6", "Mesh/Symmetry=axial mirror")
        table = run.table("accuracy.csv")
        self.assertEqual(list(table[0]), ["level", "degree", "cells", "unknowns", "seconds", "bending_energy", "estimated_relative_error"])
        self.assertEqual([int(row["level"]) for row in table], list(range(len(table))))
        self.assertTrue(all(float(a["seconds"]) < float(b["seconds"]) for a, b in zip(table, table[1:])))
        last, summary = table[-1], run.summary
        self.assertEqual(int(last["degree"]), summary["mesh"]["degree"])
        self.assertEqual(int(last["cells"]), summary["mesh"]["cells"])
        self.assertEqual(int(last["unknowns"]), summary["unknowns"]["total"])
        self.assertEqual(len(run.table("history.csv")), 1)
        self.assertEqual(run.table("history.csv")[0]["bending_energy"], last["bending_energy"])
        self.assertEqual(len(run.table("convergence.csv")), summary["newton"]["iterations"])
        self.assertIn("solution_0000.vtu", run.files)
        for row in table:
            self.assertIn(f"{float(row['estimated_relative_error']):.1e}", run.stdout)

    def test_load_paths_are_walked_once(self):
        """From v = .9 to .65 on the coarsest mesh; later ones start there."""
        run = self.solve(self.scene, "Accuracy/Target=1e-7", "Mesh/Symmetry=axial", "Load/Parameter=Vesicle/Reduced volume", "Load/To=0.65", "Load/Steps=3")
        check_reached(self, run, "bending_energy", 8 * math.pi * PROLATES[0.65], 1e-7)
        self.assertEqual(len(run.table("history.csv")), 1)

    def test_bud(self):
        """Uniform meshes up to a neck; their matrices postpone so many pivots that factors grow a hundredfold. Reference: four times as many cells."""
        run = self.solve(vesicle_program.SCENES / "budding.prm", "Accuracy/Target=1e-6", "Lipid domain/Spontaneous curvature=7.4", "Output/Solution=false")
        check_reached(self, run, "bending_energy", 24.5763228272, 1e-6)

    def test_nothing_happens_without_a_target(self):
        run = self.solve(self.scene, *vesicle_program.SMALL)
        self.assertNotIn("accuracy.csv", run.files)
        self.assertNotIn("estimated_relative_error", run.quantities)


class NotMet(vesicle_program.VesicleTest):
    scene = vesicle_program.SCENES / "prolate.prm"

    def best(self, *overrides, words):
        """The levels of a run that misses its target, and says so with these words."""
        run = self.run_scene(self.scene, "Output/Solution=false", *overrides)
        self.assertEqual(run.status, 1, run.stderr)
        self.assertEqual(run.summary["status"], "target_not_met")
        for word in ("Accuracy/Target", *words):
            self.assertIn(word, run.summary["message"])
            self.assertIn(word, run.stderr)
        return levels(run, "bending_energy")

    def test_round_off(self):
        table = self.best("Accuracy/Target=1e-15", "Mesh/Symmetry=axial mirror", words=("round-off", "larger Target"))
        self.assertLess(abs(table[-1][0] / (8 * math.pi * PROLATES[0.9]) - 1), 1e-10)

    def test_unknowns(self):
        table = self.best("Accuracy/Target=1e-9", "Mesh/Symmetry=axial", "Accuracy/Maximum unknowns=140", words=("Maximum unknowns = 140",))
        self.assertEqual(len(table), 2)
        self.assertLess(abs(table[-1][0] / (8 * math.pi * PROLATES[0.9]) - 1), 5 * table[-1][1])

    def test_no_estimate(self):
        table = self.best("Accuracy/Target=1e-3", "Mesh/Symmetry=axial", "Accuracy/Maximum unknowns=100", words=("could not be estimated",))
        self.assertEqual(len(table), 1)
        self.assertTrue(math.isinf(table[0][1]))

    def test_levels(self):
        table = self.best("Accuracy/Target=1e-9", "Mesh/Symmetry=axial", "Accuracy/Maximum levels=2", words=("Maximum levels = 2",))
        self.assertEqual(len(table), 2)

    def test_mistakes(self):
        self.assert_refusals(self.scene, [
            (["Accuracy/Target=-1e-3"], ["Target", "-0.001"]),
            (["Accuracy/Target=1"], ["Target", "1"]),
            (["Accuracy/Target=1e-3", "Continuation/Parameter=Vesicle/Reduced volume"], ["Accuracy/Target = 0.001", "Continuation", "one equilibrium"]),
            (["Accuracy/Target=1e-3", "Analyses=phase diagram"], ["Accuracy/Target = 0.001", "phase diagram", "one equilibrium"]),
            (["Accuracy/Maximum levels=1"], ["Maximum levels", "1"]),
        ])


class Drops(droplet_program.DropletTest):
    """Caps in closed form; with gravity (rho g = 1, V = 2 pi/3) an independent shooting solution of twelve digits."""

    # By contact angle: E - cos(theta) A_SL without weight, and with it.
    ENERGIES = {60: (4.263797221534637, 4.775949806280), 90: (6.283185307179586, 7.016507814302), 120: (7.480451224746008, 8.466900035761)}
    BOND = "Droplet/Bond number=0.6299605249474366"

    def test_sessile(self):
        for angle, (light, heavy) in self.ENERGIES.items():
            for scene, energy, further in (("sessile", light, ()), ("sessile_gravity", heavy, (self.BOND,))):
                with self.subTest(angle=angle, scene=scene):
                    run = self.solve(droplet_program.SCENES / f"{scene}.prm", "Accuracy/Target=1e-9", f"Droplet/Contact angle={angle}", "Droplet/Volume=2*pi/3",
                                     "Mesh/Symmetry=axial", "Output/Solution=false", *further, name=f"{scene}{angle}")
                    check_reached(self, run, "total_energy", energy, 1e-9)


class InSpace(vesicle_program.VesicleTest):
    def test_prolate(self):
        run = self.solve(vesicle_program.SCENES / "prolate.prm", "Accuracy/Target=1e-4", "Output/Solution=false")
        check_reached(self, run, "bending_energy", 8 * math.pi * PROLATES[0.9], 1e-4)


class Torus(director_program.DirectorTest):
    def test_normal_directors(self):
        """4 pi^2 K, the energy of Clifford's torus."""
        run = self.solve(director_program.SCENES / "torus_tilt_limit.prm", "Accuracy/Target=1e-3", "Director/Tilt modulus=inf", "Output/Solution=false")
        check_reached(self, run, "total_energy", 4 * math.pi**2, 1e-3)


class Ridge(ridge_program.RidgeTest):
    def test_radius(self):
        """Of pinned_axial.prm; its value is that of cells five times as small at the line."""
        run = self.solve(ridge_program.SCENES / "pinned_axial.prm", "Accuracy/Target=2e-3", "Contact line/Cell size=0.04", "Output/Solution=false")
        check_reached(self, run, "ridge_radius", 0.8664, 2e-3, digits=3e-4)
