# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's mistakes with directors: exit status 2 and one message that says what is wrong, what is allowed and what to do."""

from director_program import SCENES, DirectorTest

TWO = "Surface/Shape=two inclusions"

# Overrides of inclusion.prm, and what the message must hold.
CASES = [
    (["Director/Tilt modulus=-1"], ["Tilt modulus", "a number >= 0 or inf"]),
    (["Director/Tilt modulus=inf"], ["Tilt modulus = inf", "cannot be tilted", "finite"]),
    (["Surface/Shape=vesicle", "Director/Tilt modulus=inf", "Director/Shear=direct"], ["Tilt modulus = inf", "Shear = mixed"]),
    (["Director/Bending modulus=0"], ["Bending modulus", "a number > 0"]),
    (["Director/Bending modulus=inf"], ["Bending modulus", "a number > 0"]),
    (["Director/Shear=mixt"], ["mixt", "'mixed' or 'direct'"]),
    (["Director/Tilt modulos=1"], ["Tilt modulos", "Did you mean 'Tilt modulus'"]),
    (["Inclusion/Radius=0"], ["Radius", "a number > 0"]),
    (["Inclusion/Outer radius=1"], ["Outer radius = 1", "larger than Inclusion/Radius = 1"]),
    (["Inclusion/Edge tilt=1.6"], ["Edge tilt", "1.6", "[-1.5, 1.5]"]),
    ([TWO], ["two inclusions", "not axisymmetric", "Mesh/Symmetry to none"]),
    ([TWO, "Mesh/Symmetry=none", "Inclusion/Distance=2"], ["distance 2", "larger than 2"]),
    ([TWO, "Mesh/Symmetry=none", "Inclusion/Distance=38"], ["distance 38", "larger than 20"]),
    ([TWO, "Mesh/Symmetry=none", "Inclusion/Second=other"], ["Second", "'other'", "'alike' or 'opposite'"]),
    (["Surface/Shape=inclusion on vesicle", "Inclusion/Polar angle=2"], ["Polar angle", "2", "[0.001, 1.5]"]),
    (["Mesh/Symmetry=axial mirror"], ["no mirror plane", "axial or none"]),
    (["Mesh/Degree=1"], ["Degree", "2"]),
    (["Surface/Shape=incluson"], ["incluson", "Did you mean 'inclusion'"]),
    (["Surface/Motion=fixed"], ["Motion", "'fixed'", "'free' or 'held'"]),
    (["Director field/Start=turned", "Director field/Angle=0.1"], ["turned", "meridian", "Mesh/Symmetry = none"]),
    (["Director field/Noise=0.6"], ["Noise", "0.6", "[0, 0.5]"]),
    (["Effects=directors"], ["directors", "Did you mean 'director'"]),
    (["Load/Parameter=Inclusion/Edge tilt", "Load/To=1"], ["Edge tilt", "cannot change"]),
    (["Droplet/Volume=1"], ["Droplet", "no section"]),
]


class Refusals(DirectorTest):
    def test_values(self):
        self.assert_refusals(SCENES / "inclusion.prm", CASES)

    def test_without_directors(self):
        scene = self.write("none.prm", "set Effects = surface tension\n")
        process = self.call(scene, "--output-directory", self.folder / "none")
        self.assert_clear_refusal(process, self.folder / "none", ["no 'director'", "vesicle"])

    def test_shipped_scenes_are_valid(self):
        scenes = sorted(SCENES.glob("*.prm"))
        self.assertGreaterEqual(len(scenes), 5)
        self.assert_valid(scenes)
