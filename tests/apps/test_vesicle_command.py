# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of a run that is in order: help, validation, written parameters, overrides, silence."""

import re

from vesicle_program import SCENES, SMALL, VesicleTest, settings

PROLATE = SCENES / "prolate.prm"


class CommandLine(VesicleTest):
    def test_help_and_version(self):
        shown = self.call("--help")
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))
        for option in ("--version", "--write-parameters", "--validate", "--set", "--output-directory", "--restart", "--quiet", "--verbose"):
            self.assertIn(option, shown.stdout)
        version = self.call("--version")
        self.assertEqual((version.returncode, version.stderr), (0, ""))
        self.assertRegex(version.stdout, r"^vesicle \(Pellicle\) \d+\.\d+\.\d+\n$")
        without_scene = self.call()
        self.assertEqual((without_scene.returncode, without_scene.stdout), (2, ""))
        self.assertEqual(without_scene.stderr, shown.stdout)

    def test_validate(self):
        checked = self.call(PROLATE, "--validate", "--output-directory", self.folder / "run")
        self.assertEqual((checked.returncode, checked.stderr), (0, ""))
        for word in ("valid", "helfrich bending", "area constraint", "volume constraint", "96 cells of degree 3", "moment"):
            self.assertIn(word, checked.stdout)
        self.assertIn("surface (96 cells, 1536 points):\n    energy 'helfrich bending' of position moment\n    constraint 'area constraint' of position\n", checked.stdout)
        # Of the start shape: a spheroid of reduced volume 0.9, on a mesh of 96 cells.
        found = re.search(r"^  reduced_volume = (\S+)$", checked.stdout, re.MULTILINE)
        self.assert_within(float(found.group(1)), 0.9, 1e-6)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_written_parameters_are_a_scene(self):
        written = self.call("--write-parameters", "all.prm")
        self.assertEqual((written.returncode, written.stderr), (0, ""))
        text = (self.folder / "all.prm").read_text(encoding="utf-8")
        for line in ("set Reduced volume = 0.9", "# subsection Surface tension", "# subsection Pressure", "  # Allowed: an integer in [2, 5]."):
            self.assertIn(line, text)
        checked = self.call("all.prm", "--validate")
        self.assertEqual((checked.returncode, checked.stderr), (0, ""))
        # With a scene, its effects are the listed ones, and nothing is solved.
        soap = self.write("soap.prm", "set Effects = surface tension, volume constraint\n")
        written = self.call("--write-parameters", "soap_all.prm", soap)
        self.assertEqual((written.returncode, written.stderr), (0, ""))
        text = (self.folder / "soap_all.prm").read_text(encoding="utf-8")
        self.assertIn("set Effects = surface tension, volume constraint\n", text)
        self.assertIn("\nsubsection Surface tension\n", text)
        self.assertIn("\n# subsection Helfrich bending\n", text)
        self.assertEqual(self.call("soap_all.prm", "--validate").returncode, 0)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["all.prm", "soap.prm", "soap_all.prm"])

    def test_a_run_can_be_repeated_from_its_scene(self):
        first = self.solve(PROLATE, *SMALL, "Vesicle/Reduced volume=0.85", "Vesicle/Node noise=0.05")
        self.assert_within(first.quantities["reduced_volume"], 0.85, 1e-9)
        again = self.solve(first.directory / "used.prm", name="again")
        self.assertEqual(again.quantities, first.quantities)
        self.assertEqual((again.directory / "used.prm").read_bytes(), (first.directory / "used.prm").read_bytes())
        self.assertEqual((again.directory / "history.csv").read_bytes(), (first.directory / "history.csv").read_bytes())

    def test_verbosity(self):
        quiet = self.solve(PROLATE, *SMALL, options=["--quiet"])
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))
        verbose = self.solve(PROLATE, *SMALL, name="verbose", options=["--verbose"])
        normal = self.solve(PROLATE, *SMALL, name="normal")
        self.assertGreater(len(verbose.stdout.splitlines()), len(normal.stdout.splitlines()))
        self.assertIn("bending_energy", normal.stdout)
        self.assertNotIn("\033", normal.stdout)

    def test_output_directory_of_its_own(self):
        done = self.call(PROLATE, *settings(*SMALL, "Output/Picture=false"), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "output" / "prolate" / "summary.json").is_file())
