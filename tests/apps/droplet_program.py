# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program `droplet_contact` the way a user does.

The environment variable PELLICLE_DROPLET_CONTACT names the program, PELLICLE_DROPLET_SCENES the folder of the shipped scenes; ctest sets both.
"""

import os
from pathlib import Path

from pellicle_program import ProgramTest, settings

__all__ = ["SCENES", "AXIAL", "DropletTest", "settings"]

SCENES = Path(os.environ["PELLICLE_DROPLET_SCENES"])

# A meridian of 8 cells: solved in hundredths of a second.
AXIAL = "Mesh/Symmetry=axial"


class DropletTest(ProgramTest):
    application = "droplet_contact"
    program = os.environ["PELLICLE_DROPLET_CONTACT"]
