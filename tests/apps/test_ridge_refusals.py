# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's mistakes with ridges: exit status 2 and one message that says what is wrong, what is allowed and what to do. A load that no
state carries: exit status 1, how far it went, and everything up to there on disk."""

from ridge_program import COARSE, SCENES, RidgeTest, effects

IN_SPACE = "Mesh/Symmetry=none"

# Overrides of pinned_axial.prm, and what the message must hold.
CASES = [
    # The block that Sauer (2014) prints, 2 x 2 x 1, has the drop's own diameter.
    ([IN_SPACE, "Substrate/Shape=block", "Substrate/Half width=1"], ["ring of radius 1 touches the lateral faces", "half width 1", "wider"]),
    (["Substrate/Half width=0.9"], ["ring of radius 1 reaches beyond the lateral faces", "half width 0.9"]),
    (["Substrate/Shape=block"], ["Substrate/Shape = block", "not axisymmetric", "Symmetry to none", "cylinder"]),
    (["Substrate/Shape=ball"], ["'Shape'", "'ball'", "'cylinder' or 'block'"]),
    (["Substrate/Lateral faces=fixed"], ["Lateral faces", "'fixed'", "'free', 'sliding' or 'clamped'"]),
    (["Substrate/Poisson ratio=0.6"], ["Substrate", "Poisson ratio", "0.6", "(-1, 0.5]"]),
    (["Substrate/Poisson ratio=-1"], ["Poisson ratio", "(-1, 0.5]"]),
    (["Substrate/Young modulus=0"], ["Young modulus", "a number > 0"]),
    (["Substrate/Thickness=-1"], ["Thickness", "a number > 0"]),
    ([IN_SPACE, "Substrate/Azimuthal cells=12", "Contact line/Cell size=0.1"], ["contact line = 12", "multiple of 8"]),
    ([IN_SPACE, "Substrate/Bottom=sliding", effects("gravity"), "Droplet/Inclination=20"], ["Inclination = 20", "on the slope", "Clamp"]),
    (["Contact line/Cell size=0"], ["Contact line", "Cell size", "a number > 0"]),
    (["Contact line/Cell size=0.4"], ["Cell size = 0.4", "between", "0.25"]),
    (["Contact line/Motion=fre"], ["Motion", "Did you mean 'free'", "'pinned' or 'free'"]),
    (["Tensions/Liquid gas=0"], ["Tensions", "Liquid gas", "a number > 0"]),
    (["Tensions/Solid liquid=-0.1"], ["Tensions", "Solid liquid", "a number >= 0"]),
    (["Tensions/Solid gsa=0.1"], ["Solid gsa", "Did you mean 'Solid gas'"]),
    (["Droplet/Volume=0"], ["Droplet", "Volume", "a number > 0"]),
    (["Droplet/Body force=0.2"], ["Droplet/Body force = 0.2", "no effect", "'gravity'"]),
    (["Droplet/Inclination=20"], ["Droplet/Inclination = 20", "no effect", "'gravity'"]),
    ([effects("gravity"), "Droplet/Body force=0.2", "Droplet/Inclination=20"], ["Inclination = 20", "axial", "Symmetry to none"]),
    (["Effects=volume constraint, solid, solid skins"], ["no 'liquid surface'"]),
    (["Effects=liquid surface, volume constraint, solid skins"], ["no 'solid'"]),
    (["Effects=liquid surface, solid, solid skins"], ["no 'volume constraint'", "shrinking"]),
    (["Effects=liquid surface, volume constraint, solid"], ["Tensions/Solid liquid = 0.1", "'solid skins'", "0"]),
    ([effects("wetting")], ["'wetting'", "wetting_ridge", "'free contact line'"]),
    (["Mesh/Symmetry=axial mirror"], ["axial mirror", "axial or none"]),
    (["Mesh/File=soft.msh"], ["soft.msh", "own mesh"]),
    (["Load/Parameter=Contact line/Radius", "Load/To=1.1"], ["Contact line/Radius", "cannot change"]),
    (["Load/Parameter=Substrate/Poisson ratio", "Load/To=0.5"], ["Poisson ratio", "cannot change"]),
    ([effects("free contact line"), "Contact line/Motion=free", "Free contact line/Advancing threshold=0.01",
      "Continuation/Parameter=Tensions/Scale"], ["Continuation/Parameter = Tensions/Scale", "dissipated", "Load"]),
    (["Vesicle/Area=1"], ["Vesicle", "no section", "'Droplet'"]),
]


class Refusals(RidgeTest):
    def test_values(self):
        self.assert_refusals(SCENES / "pinned_axial.prm", CASES)

    def test_written_parameters_are_valid(self):
        """Every parameter with its default, and sections of effects that are not listed in comments."""
        scene = self.folder / "all.prm"
        self.assertEqual(self.call("--write-parameters", scene).returncode, 0)
        text = scene.read_text(encoding="utf-8")
        for name in ("Motion", "Young modulus", "Solid liquid", "Volumetric law", "Receding threshold"):
            self.assertIn(name, text)
        process = self.call("--validate", scene)
        self.assertEqual(process.returncode, 0, process.stderr)

    def test_shipped_scenes_are_valid(self):
        scenes = sorted(SCENES.glob("*.prm"))
        self.assertGreaterEqual(len(scenes), 2)
        self.assert_valid(scenes)

    def test_load_that_no_state_carries(self):
        """A liquid that pulls fifty times as hard as the solid's skins can hold: how far it went, and everything until then."""
        run = self.run_scene(SCENES / "pinned_axial.prm", *COARSE, "Tensions/Liquid gas=5", "Load/Steps=50", "Load/Smallest step=0.02",
                             "Newton/Maximum iterations=20")
        self.assertEqual(run.status, 1, run.stderr)
        history = run.table("history.csv")
        self.assertGreaterEqual(len(history), 1)
        reached = float(history[-1]["load"])
        self.assertLess(reached, 0.5)
        self.assertIn(f"Load stepping stopped at tensions = {reached:g}", run.stderr)
        self.assertIn("Tensions/Scale", run.stderr)
        for name in ("convergence.csv", "solution.pvd", "solution_0000.vtu", "substrate_0000.vtu", "used.prm"):
            self.assertIn(name, run.files)
        self.assertEqual(run.summary["status"], "failed")
        for name, value in history[-1].items():
            if name in run.quantities:
                self.assert_within(run.quantities[name], float(value), 1e-12)
