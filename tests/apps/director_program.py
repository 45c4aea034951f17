# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program `director_membrane` the way a user does.

The environment variable PELLICLE_DIRECTOR_MEMBRANE names the program, PELLICLE_DIRECTOR_SCENES the folder of the shipped scenes; ctest sets both.
"""

import os
from pathlib import Path

from pellicle_program import ProgramTest, settings

__all__ = ["SCENES", "DirectorTest", "settings"]

SCENES = Path(os.environ["PELLICLE_DIRECTOR_SCENES"])


class DirectorTest(ProgramTest):
    application = "director_membrane"
    program = os.environ["PELLICLE_DIRECTOR_MEMBRANE"]
