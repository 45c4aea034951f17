# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program `wetting_ridge` the way a user does.

The environment variable PELLICLE_WETTING_RIDGE names the program, PELLICLE_RIDGE_SCENES the folder of the shipped scenes; ctest sets both.
"""

import os
from pathlib import Path

from pellicle_program import ProgramTest

__all__ = ["SCENES", "COARSE", "FREE_LINE", "SLIDING", "RidgeTest", "effects"]

SCENES = Path(os.environ["PELLICLE_RIDGE_SCENES"])

# Cells for numbers that need no fine line: about a second.
COARSE = ("Mesh/Degree=2", "Contact line/Cell size=0.02")
# Sides for which numbers converge fast: a skin that ends at a free edge pulls at it, a further singularity.
SLIDING = "Substrate/Lateral faces=sliding"
FREE_LINE = "Contact line/Motion=free"


def effects(*further):
    """Those of every ridge, and more."""
    return "Effects=" + ", ".join(("liquid surface", "volume constraint", "solid", "solid skins", *further))


class RidgeTest(ProgramTest):
    application = "wetting_ridge"
    program = os.environ["PELLICLE_WETTING_RIDGE"]
