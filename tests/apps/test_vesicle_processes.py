# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two processes compute what one computes, and write one set of files."""

from vesicle_program import SCENES, VesicleTest


class Processes(VesicleTest):
    def test_two_processes(self):
        scene = SCENES / "prolate.prm"
        one = self.solve(scene, name="one")
        two = self.solve(scene, name="two", launcher=["mpirun", "--oversubscribe", "-np", "2"])
        self.assertEqual(two.files, one.files)
        self.assertEqual(two.stdout.count("bending_energy_over_8_pi_kappa"), 1)
        self.assertEqual(len(two.table("history.csv")), 1)
        self.assertEqual(len(two.table("convergence.csv")), two.summary["newton"]["iterations"])
        for key in ("effects", "mesh", "unknowns", "warnings"):
            self.assertEqual(two.summary[key], one.summary[key])
        self.assertEqual(list(two.quantities), list(one.quantities))
        for name, value in one.quantities.items():
            # Energies are stationary: they forgive what the iteration's tolerance leaves to shapes and multipliers.
            self.assert_within(two.quantities[name], value, 1e-9 if "energy" in name else 1e-7)
