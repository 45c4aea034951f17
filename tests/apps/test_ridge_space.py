# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shipped scenes of ridges in space, on meshes that are coarser than theirs."""

import math
import unittest

from ridge_program import SCENES, RidgeTest

COARSEST = ("Substrate/Azimuthal cells=8", "Contact line/Cell size=0.2")


class Space(RidgeTest):
    def test_a_heavy_drop_on_an_inclined_block_hangs_on_its_line(self):
        """The block is held with the weight of the liquid, .2 * 2, turned by -20 degrees; all by equilibrium alone, whatever the mesh."""
        run = self.solve(SCENES / "pinned_sauer2014.prm", "Mesh/Refinements=1", *COARSEST)
        q = run.quantities
        angle = math.radians(20)
        self.assert_within(q["volume"], 2, 1e-10)
        self.assert_within(q["liquid_weight"], 0.4, 1e-10)
        self.assert_within(q["substrate_reaction_x"], 0.4 * math.sin(angle), 1e-6)
        self.assertAlmostEqual(q["substrate_reaction_y"], 0, delta=1e-12)
        self.assert_within(q["substrate_reaction_z"], 0.4 * math.cos(angle), 1e-6)
        self.assertLess(q["ridge_height_min"], -0.08)  # where the drop leans over
        self.assertGreater(q["ridge_height_max"], 0.03)
        leans_over = q["apparent_contact_angle_degrees_max"] > 180  # through the dry substrate: reported
        self.assertEqual(len(run.summary["warnings"]), 1 if leans_over else 0)
        steps = [int(row["step"]) for row in run.table("convergence.csv")]
        self.assertLessEqual(max(steps.count(step) for step in set(steps)), 12)

    def test_a_free_line_is_round_and_where_it_is_on_a_meridian(self):
        """Within .5 %; around the line it varies with the eight cells only."""
        axial = self.solve(SCENES / "unpinned.prm").quantities
        run = self.solve(SCENES / "unpinned_3d.prm", "Mesh/Refinements=0", *COARSEST)
        self.assertEqual(run.summary["unknowns"]["material position"], 9)
        for name in ("contact_line_material_radius", "ridge_radius", "pressure", "apparent_contact_angle_degrees"):
            self.assert_within(run.quantities[name], axial[name], 5e-3)
        spread = run.quantities["contact_line_material_radius_max"] - run.quantities["contact_line_material_radius_min"]
        self.assertLess(spread, 2e-3)
        self.assertAlmostEqual(run.quantities["substrate_reaction_z"], 0, delta=1e-10)

    def test_a_substrate_that_slides_on_its_bottom_is_free_to_move_along_the_mirror_plane(self):
        sliding = ("Mesh/Refinements=0", "Contact line/Cell size=0.2", "Substrate/Bottom=sliding")
        axial = self.solve(SCENES / "unpinned.prm", "Mesh/Degree=2", *sliding).quantities
        run = self.solve(SCENES / "unpinned_3d.prm", "Substrate/Azimuthal cells=8", *sliding)
        self.assertEqual(run.summary["unknowns"]["rigid motions"], 1)
        for name in ("contact_line_material_radius", "ridge_radius", "pressure", "total_energy"):
            self.assert_within(run.quantities[name], axial[name], 5e-3)


if __name__ == "__main__":
    unittest.main()
