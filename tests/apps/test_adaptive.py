# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy/Refinement = adaptive: the same answers with fewer unknowns where a solution is local."""

from accuracy_levels import levels
from vesicle_program import SCENES, VesicleTest


class Adaptive(VesicleTest):
    def reach(self, target, refinement, *settings, scene="budding.prm"):
        run = self.solve(SCENES / scene, f"Accuracy/Target={target}", f"Accuracy/Refinement={refinement}", "Output/Solution=false", *settings,
                         name=f"{refinement}{target}")
        self.assertLessEqual(levels(run, "bending_energy")[-1][1], target)
        return run

    def test_neck_of_a_bud(self):
        bud = ("Lipid domain/Spontaneous curvature=7.4", "Accuracy/Maximum levels=40")
        uniform, adaptive = (self.reach(1e-5, kind, *bud) for kind in ("uniform", "adaptive"))
        self.assert_within(adaptive.quantities["bending_energy"], uniform.quantities["bending_energy"], 2e-5)
        self.assertLess(adaptive.summary["unknowns"]["total"], 0.4 * uniform.summary["unknowns"]["total"])
        cells = [int(row["cells"]) for row in adaptive.table("accuracy.csv")]
        self.assertEqual(cells, sorted(cells))

    def test_smooth_shapes_stay_uniform(self):
        prolate = ("Mesh/Symmetry=axial",)
        uniform, adaptive = (self.reach(1e-6, kind, *prolate, scene="prolate.prm") for kind in ("uniform", "adaptive"))
        self.assertLessEqual(adaptive.summary["unknowns"]["total"], 2 * uniform.summary["unknowns"]["total"])
