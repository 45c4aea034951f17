# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program `vesicle` the way a user does.

The environment variable PELLICLE_VESICLE names the program, PELLICLE_SCENES the folder of the shipped scenes; ctest sets both.
"""

import os
from pathlib import Path

from pellicle_program import ProgramTest, in_pairs, settings

__all__ = ["SCENES", "SMALL", "VesicleTest", "in_pairs", "settings"]

SCENES = Path(os.environ["PELLICLE_SCENES"])

# A meridian of 16 cells: solved in hundredths of a second.
SMALL = ("Mesh/Symmetry=axial", "Mesh/Refinements=2", "Mesh/Degree=3")


class VesicleTest(ProgramTest):
    application = "vesicle"
    program = os.environ["PELLICLE_VESICLE"]
