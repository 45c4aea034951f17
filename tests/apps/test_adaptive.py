# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy/Refinement = adaptive: the same answers with fewer unknowns where a solution is local."""

import droplet_program
from accuracy_levels import check_reached, levels
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


class ContactRing(droplet_program.DropletTest):
    # Uniform meshes of 128 cells and adapted ones of 18, degree 5, agree to 1e-9.
    ENERGY = 9.24935363

    def test_drop_that_touches_the_plane_without_wetting_it(self):
        """The surface lies on the plane up to a ring, where its curvature jumps."""
        unknowns = {}
        for kind in ("uniform", "adaptive"):
            run = self.solve(droplet_program.SCENES / "sessile_gravity.prm", "Effects=liquid surface, volume constraint, contact, gravity",
                             "Droplet/Base=membrane", "Droplet/Contact angle=180", droplet_program.AXIAL, "Accuracy/Target=1e-8",
                             f"Accuracy/Refinement={kind}", "Output/Solution=false", name=kind)
            check_reached(self, run, "total_energy", self.ENERGY, 1e-8, digits=2e-9)
            unknowns[kind] = run.summary["unknowns"]["total"]
        self.assertLess(unknowns["adaptive"], 0.25 * unknowns["uniform"])
