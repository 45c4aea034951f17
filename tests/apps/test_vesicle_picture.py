# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a run; without the renderer's programs the run succeeds and says what is missing."""

import unittest
from pathlib import Path

from vesicle_program import SCENES, SMALL, VesicleTest

RENDERER = [Path("/usr/bin/xvfb-run"), Path("/usr/bin/python3")]


class Picture(VesicleTest):
    @unittest.skipUnless(all(program.exists() for program in RENDERER), "the renderer is not installed")
    def test_picture(self):
        run = self.solve(SCENES / "prolate.prm", *SMALL, "Output/Solution=false", picture=True)
        self.assertEqual(run.summary["warnings"], [])
        picture = run.directory / "picture.png"
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertGreater(picture.stat().st_size, 10000)
        # Without Output/Solution nothing else stays.
        self.assertEqual(run.files, ["convergence.csv", "history.csv", "picture.png", "summary.json", "used.prm"])

    def test_without_renderer(self):
        run = self.solve(SCENES / "prolate.prm", *SMALL, picture=True, PATH="/nowhere")
        self.assertNotIn("picture.png", run.files)
        warnings = run.summary["warnings"]
        self.assertEqual(len(warnings), 1, warnings)
        self.assertTrue(warnings[0].startswith("No picture: "), warnings)
        self.assertIn(warnings[0], run.stdout)
