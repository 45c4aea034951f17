# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts between planes of symmetry have the numbers of the whole surface, for less work."""

import droplet_program
import vesicle_program


def assert_same(test, part, whole, tolerance):
    """All quantities, in the same order."""
    test.assertEqual(list(part), list(whole))
    for name, value in whole.items():
        with test.subTest(quantity=name):
            test.assertLessEqual(abs(part[name] - value), tolerance * max(1, abs(value)), f"{part[name]!r} is not {value!r}")


class Vesicles(vesicle_program.VesicleTest):
    scene = vesicle_program.SCENES / "prolate.prm"

    def test_parts_of_a_prolate(self):
        """Also in the ALE chart, where residuals of equations along the planes would show."""
        sets = ("Mesh/Refinements=1", "Output/Solution=false")
        whole = self.solve(self.scene, *sets, name="whole")
        cells = {"half": 12, "quarter": 6, "octant": 3}
        for symmetry, n_cells in cells.items():
            part = self.solve(self.scene, *sets, f"Mesh/Symmetry={symmetry}", name=symmetry)
            self.assertEqual(part.summary["mesh"]["cells"], n_cells)
            self.assertEqual(part.summary["newton"]["iterations"], whole.summary["newton"]["iterations"])
            self.assertLess(part.summary["unknowns"]["total"], whole.summary["unknowns"]["total"] * n_cells / 24 * 1.5)
            assert_same(self, part.quantities, whole.quantities, 1e-9)

    def test_whole_surface_is_written(self):
        sets = ("Mesh/Refinements=1", "Mesh/Degree=2")
        whole = self.solve(self.scene, *sets, name="whole")
        part = self.solve(self.scene, *sets, "Mesh/Symmetry=octant", name="part")
        cells = 'NumberOfCells="24"'
        for run in (whole, part):
            self.assertIn(cells, (run.directory / "solution_0000.vtu").read_text(encoding="utf-8", errors="replace"))

    def test_stability_is_that_of_symmetric_modes(self):
        run = self.solve(self.scene, "Mesh/Refinements=1", "Mesh/Symmetry=octant", "Analyses=stability", "Output/Solution=false")
        self.assertTrue(any("with the symmetry of the mesh" in w for w in run.summary["warnings"]), run.summary["warnings"])
        self.assertEqual(run.summary["stability"]["negative_eigenvalues"], 0)

    def test_refusals(self):
        octant = "Mesh/Symmetry=octant"
        self.assert_refusals(self.scene, [
            ([octant, "Mesh/Refinements=0"], ["cuts through cells", "Mesh/Refinements to 1"]),
            ([octant, "Vesicle/Start shape=torus"], ["octant", "closed start shapes"]),
            ([octant, "Vesicle/Node noise=0.05"], ["Node noise", "no symmetry"]),
            ([octant, "Vesicle/Start shape=stomatocyte", "Vesicle/Reduced volume=0.6"], ["stomatocyte", "quarter"])])


class Drops(droplet_program.DropletTest):
    def test_quarter_of_a_sessile_drop(self):
        for scene, sets in (("sessile", ("Droplet/Contact angle=120",)), ("sessile_gravity", ())):
            sets = ("Mesh/Refinements=1", "Output/Solution=false", *sets)
            whole = self.solve(droplet_program.SCENES / f"{scene}.prm", *sets, name=f"{scene}_whole")
            part = self.solve(droplet_program.SCENES / f"{scene}.prm", *sets, "Mesh/Symmetry=quarter", name=f"{scene}_part")
            self.assertEqual(4 * part.summary["mesh"]["cells"], whole.summary["mesh"]["cells"])
            assert_same(self, part.quantities, whole.quantities, 1e-8)

    def test_refusals(self):
        self.assert_refusals(droplet_program.SCENES / "sessile.prm", [
            (["Mesh/Symmetry=octant"], ["octant", "quarter"]),
            (["Mesh/Symmetry=quarter", "Droplet/Contact angle field=60 + x"], ["depends on the place"])])


class InclinedDrop(droplet_program.DropletTest):
    def test_half_of_an_inclined_drop(self):
        scene, sets = droplet_program.SCENES / "inclined.prm", ("Mesh/Degree=2", "Mesh/Refinements=1", "Output/Solution=false")
        whole = self.solve(scene, *sets, name="whole")
        part = self.solve(scene, *sets, "Mesh/Symmetry=half", name="part")
        assert_same(self, part.quantities, whole.quantities, 1e-7)
