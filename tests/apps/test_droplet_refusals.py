# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's mistakes with drops: exit status 2 and one message that says what is wrong, what is allowed and what to do."""

from droplet_program import AXIAL, SCENES, DropletTest, settings

WITH_GRAVITY = "Effects=liquid surface, volume constraint, wetting, gravity"
BALL, FIELD = "Substrate/Shape=sphere", "Substrate/Shape=height field"

# Overrides of sessile.prm, and what the message must hold.
CASES = [
    (["Droplet/Contact angle=0"], ["Contact angle", "'0'", "(0, 180]"]),
    (["Droplet/Contact angle=181"], ["Contact angle", "'181'", "(0, 180]"]),
    (["Droplet/Contact angle=180"], ["180", "contact line", "Droplet/Base = membrane"]),
    (["Droplet/Volume=0"], ["Volume", "a number > 0"]),
    (["Droplet/Surface tension=-1"], ["Surface tension", "a number > 0"]),
    (["Droplet/Contact angel=60"], ["Contact angel", "Did you mean 'Contact angle'"]),
    (["Effects=liquid surface, volume constraint, weting"], ["weting", "Did you mean 'wetting'"]),
    (["Effects=volume constraint, wetting"], ["liquid surface", "nothing holds the liquid"]),
    (["Effects=liquid surface, volume constraint, wetting, helfrich bending"], ["helfrich bending", "'liquid surface'"]),
    (["Droplet/Bond number=1"], ["Bond number", "'gravity'", "Effects"]),
    ([WITH_GRAVITY, AXIAL, "Droplet/Bond number=0.1", "Droplet/Inclination=10"], ["Inclination", "axial", "none"]),
    (["Mesh/Symmetry=axial mirror"], ["axial mirror", "axial or none"]),
    (["Mesh/File=drop.msh"], ["drop.msh", "own mesh"]),
    (["Substrate/Shape=spher"], ["spher", "Did you mean 'sphere'"]),
    ([BALL, "Substrate/Radius=0"], ["Radius", "a number > 0"]),
    ([BALL, "Substrate/Side=inside", "Substrate/Radius=0.5"], ["Volume", "does not fit", "Radius = 0.5", "Less than"]),
    ([FIELD, "Substrate/Height=0.1*abs(x)"], ["Height", "not twice differentiable", "x = ", "y = ", "contact line", "sqrt(x^2 + 0.01^2)"]),
    ([FIELD, AXIAL, "Substrate/Height=abs(sqrt(x^2 + y^2) - 1.276185946465853)"], ["not twice differentiable", "x = 1.27618594646585"]),
    ([FIELD, "Substrate/Height=0.1*u"], ["Substrate/Height", "'u' is not understood", "sin"]),
    ([FIELD, "Substrate/Height=floor(x)"], ["Substrate/Height", "floor", "no derivatives"]),
    ([FIELD, AXIAL, "Substrate/Height=0.1*x"], ["Height", "differs around the z axis", "Symmetry = none"]),
    (["Droplet/Contact angle field=60 + z"], ["Contact angle field", "'z' is not understood"]),
    (["Droplet/Contact angle field=170 + 20*x"], ["Contact angle field", "(0, 180)", "x = "]),
    ([AXIAL, "Droplet/Contact angle field=60 + x"], ["Contact angle field", "differs around the z axis"]),
    (["Load/Parameter=Droplet/Surface tension", "Load/To=2"], ["Surface tension", "cannot change"]),
    (["Load/Parameter=Droplet/Contact angle", "Load/To=190"], ["Load/To", "190", "(0, 180]"]),
    (["Vesicle/Area=1"], ["Vesicle", "no section", "'Droplet'"]),
]


class Refusals(DropletTest):
    def test_values(self):
        self.assert_refusals(SCENES / "sessile.prm", CASES)

    def test_drop_that_cannot_hang(self):
        """No equilibrium: status 1 and a message, not an endless search."""
        directory = self.folder / "falls"
        process = self.call(SCENES / "sessile_gravity.prm", *settings(AXIAL, "Droplet/Bond number=-3", "Output/Picture=false"),
                            "--output-directory", directory)
        self.assertEqual(process.returncode, 1, process.stderr)
        self.assertIn("no equilibrium", process.stderr)
