# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's mistakes: exit status 2 and one message that says what is wrong, what is allowed and what to do."""

import os
import unittest

from vesicle_meshes import box, grid_on_a_wrapped_square, msh_text, projective_plane
from vesicle_program import SCENES, VesicleTest, in_pairs, settings

PROLATE = SCENES / "prolate.prm"
V = "Load/Parameter=Vesicle/Reduced volume"

# Overrides of prolate.prm, and what the message must hold. First one of each kind, for the quick suite.
OF_EACH_KIND = [
    (["Vesicle/Reduced volme=0.9"], ["Reduced volme", "Did you mean 'Reduced volume'"]),
    (["Effects=helfrich bendin"], ["helfrich bendin", "Did you mean 'helfrich bending'"]),
    (["Vesicle/Start shape=prolat"], ["prolat", "Did you mean 'prolate'", "'stomatocyte'", "'torus'"]),
    (["Vesicle/Reduced volume=1.1"], ["Reduced volume", "1.1", "(0, 1]"]),
    (["Helfrich bending/Bending rigidity=-1"], ["Bending rigidity", "-1", "a number > 0"]),
    (["Mesh/Degree=9"], ["Degree", "9", "[2, 5]"]),
    (["Mesh/Refinements=40"], ["Refinements", "40", "[0, 8]"]),
    (["Vesicle/Area=nan"], ["Area", "nan", "a number > 0"]),
    (["Mesh/Symmetry=axial", "Vesicle/Start shape=torus"], ["torus", "axial"]),
    (["Vesicle/Reduced volume=1"], ["sphere", "area and volume constraint", "below 1", "drop one"]),
    (["Vesicle/Start shape=ellipsoid", "Vesicle/Semi axes=1, 1, 1"], ["sphere", "off the sphere", "1, 1, 1.02", "drop one"]),
]
OTHERS = [
    (["Vesicl/Area=1"], ["Vesicl", "Did you mean 'Vesicle'"]),
    (["Effects=helfrich bending, helfrich bending"], ["twice"]),
    (["Effects=area constraint"], ["'helfrich bending'", "not in Effects", "list it"]),
    (["Surface tension/Surface tension=1"], ["'surface tension'", "not in Effects", "list it"]),
    (["Analyses=stabilty"], ["stabilty", "Did you mean 'stability'"]),
    (["Vesicle/Reduced volume=0"], ["Reduced volume", "(0, 1]"]),
    (["Vesicle/Start shape=stomatocyte"], ["0.9", "stomatocyte", "between"]),
    (["Vesicle/Semi axes=1, 2"], ["Semi axes", "three"]),
    (["Mesh/Degree=2.5"], ["Degree", "2.5", "integer"]),
    (["Vesicle/Area=inf"], ["Area", "inf", "a number > 0"]),
    (["Vesicle/Area=4*py"], ["Area", "4*py"]),
    (["Vesicle/Area="], ["Area", "empty"]),
    (["Vesicle/Area"], ["Vesicle/Area", "Section/Name=value"]),
    (["Output/Picture=maybe"], ["Picture", "maybe", "true or false"]),
    (["Vesicle/Start shape=file"], ["Mesh/File"]),
    (["Mesh/File=vesicle.msh"], ["vesicle.msh", "prolate", "'file'"]),
    (["Vesicle/Start shape=file", "Mesh/File=nowhere.msh"], ["nowhere.msh", "cannot be opened"]),
    (["Effects=helfrich bending, area constraint, surface tension"], ["tension", "area", "Drop one", "Stiffness"]),
    (["Effects=helfrich bending, volume constraint, pressure"], ["pressure", "volume", "Drop one", "Stiffness"]),
    (["Load/To=0.8"], ["Load", "Parameter"]),
    ([V], ["Load", "'To'"]),
    (["Load/Parameter=Mesh/Degree", "Load/To=3"], ["Mesh/Degree", "cannot change"]),
    (["Load/Parameter=Vesicle/Reduced volum", "Load/To=0.8"], ["Did you mean 'Vesicle/Reduced volume'"]),
    (["Load/Parameter=Vesicle/Start shape", "Load/To=0.8"], ["Load/Parameter", "Start shape", "not a number"]),
    ([V, "Load/To=1.3"], ["Load/To", "Reduced volume", "1.3", "(0, 1]"]),
    ([V, "Load/To=much"], ["Load/To", "much", "not a number"]),
    ([V, "Load/To=0.8", "Load/From=-1"], ["Load/From", "Reduced volume", "-1", "(0, 1]"]),
]

SCENE_TEXTS = [
    ("unclosed.prm", "subsection Vesicle\n  set Area = 1\n", ["unclosed.prm:1", "'Vesicle'", "end"]),
    ("malformed.prm", "\nset Effects helfrich bending\n", ["malformed.prm:2", "set Effects helfrich bending"]),
    ("unknown.prm", "subsection Vesicle\n  set Aria = 1\nend\n", ["unknown.prm:2", "Aria", "Did you mean 'Area'"]),
    ("no_energy.prm", "set Effects = area constraint\n", ["no energy", "helfrich bending"]),
    ("twice.prm", "subsection Mesh\n  set Degree = 3\n  set Degree = 4\nend\n", ["twice.prm:3", "Degree"]),
]

MESHES = [
    ("open", msh_text(*(lambda nodes, cells: (nodes, cells[:-1]))(*box((1, 1, 2)))), ["one cell only", "closed surface is needed"]),
    ("plane", msh_text(*projective_plane()), ["not orientable"]),
    ("klein", msh_text(*grid_on_a_wrapped_square(8, flip=True)), ["not orientable", "Klein bottle"]),
    ("cut_short", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 8 1 8\n", ["cut_short.msh"]),
    ("no_mesh", "solid cube\n", ["no_mesh.msh"]),
]


class Refusals(VesicleTest):
    def refuse(self, name, arguments, words):
        directory = self.folder / name
        process = self.call(*arguments, "--output-directory", directory)
        with self.subTest(arguments=arguments):
            self.assert_clear_refusal(process, directory, words)
            self.assertFalse(directory.exists(), "a refused scene leaves an output directory behind")

    def refuse_overrides(self, cases):
        in_pairs(lambda c: self.refuse(f"run{c[0]}", [PROLATE, *settings(*c[1][0])], c[1][1]), list(enumerate(cases)))

    def refuse_meshes(self, meshes):
        cases = []
        for name, text, words in meshes:
            scene = self.write(f"{name}.prm", f"subsection Mesh\n  set File = {name}.msh\nend\nsubsection Vesicle\n  set Start shape = file\nend\n")
            self.write(f"{name}.msh", text)
            cases.append((name, [scene], [f"{name}.msh", *words]))
        in_pairs(lambda case: self.refuse(f"of_{case[0]}", *case[1:]), cases)


class OfEachKind(Refusals):
    def test_values(self):
        self.refuse_overrides(OF_EACH_KIND)

    def test_meshes(self):
        self.refuse_meshes(MESHES[:2])

    def test_scene_files(self):
        self.refuse("missing", ["nowhere.prm"], ["nowhere.prm", "cannot open"])
        self.refuse("malformed", [self.write("malformed.prm", "\nset Effects helfrich bending\n")], ["malformed.prm:2"])

    def test_output_directory(self):
        file = self.write("file", "")
        self.assert_clear_refusal(self.call(PROLATE, "--output-directory", file), file, [str(file), "--output-directory"])


class Others(Refusals):
    def test_values(self):
        self.refuse_overrides(OTHERS)

    def test_meshes(self):
        self.refuse_meshes(MESHES[2:])

    def test_scene_files(self):
        cases = [(name, [self.write(name, text)], words) for name, text, words in SCENE_TEXTS]
        cases += [("missing", ["nowhere.prm"], ["nowhere.prm", "cannot open"]), ("folder", [self.folder], ["is a directory"])]
        in_pairs(lambda case: self.refuse(f"of_{case[0]}", *case[1:]), cases)

    def test_output_directories(self):
        file = self.write("file", "")
        for directory in (file / "below", "/proc/pellicle"):
            process = self.call(PROLATE, "--output-directory", directory)
            self.assert_clear_refusal(process, directory, [str(directory), "--output-directory"])
        self.assert_clear_refusal(self.call("--write-parameters", file / "scene.prm"), self.folder, ["scene.prm"])

    def test_command_lines(self):
        cases = [(["--sett", "x"], ["--sett", "Did you mean '--set'"]), ([PROLATE], ["unexpected argument", "one scene"]),
                 (["--restart", "nowhere"], ["--restart 'nowhere'", "no such directory"]), (["--quiet", "--verbose"], ["--quiet", "--verbose"])]
        in_pairs(lambda c: self.refuse(f"line{c[0]}", [PROLATE, *c[1][0]], c[1][1]), list(enumerate(cases)))

    def test_two_processes_give_one_message(self):
        directory = self.folder / "run"
        process = self.call(PROLATE, *settings("Mesh/Degree=9"), "--output-directory", directory,
                            launcher=["mpirun", "--oversubscribe", "-np", "2"])
        self.assertEqual(process.returncode, 2, process.stderr)
        self.assertEqual(process.stderr.count("[2, 5]"), 1, process.stderr)
        self.assertNotIn("MPI_ABORT", process.stderr)
        self.assertFalse(os.path.exists(directory))


if __name__ == "__main__":
    unittest.main()
