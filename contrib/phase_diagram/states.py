# SPDX-License-Identifier: LGPL-2.1-or-later
"""The states of a phase diagram as phase_diagram.csv lists them."""

import csv
import math
from dataclasses import dataclass
from typing import Optional

COLUMNS = ("branch", "reduced_volume", "bending_energy_over_8_pi_kappa", "pressure", "area", "bending_rigidity",
           "negative_eigenvalues", "is_fold")


class BadTable(Exception):
    """The message is for the user."""


@dataclass(frozen=True)
class State:
    volume: float  # reduced
    energy: float  # over 8 pi kappa
    slope: float  # of the energy along the branch, by the reduced volume
    unstable_modes: Optional[int] = None  # None: nobody has counted them
    is_fold: bool = False


def energy_slope(pressure, area, rigidity):
    """d(E/(8 pi kappa))/dv along a branch. E + sigma (A - A0) - P (V - V0) is stationary, so dE/dV0 = P at fixed A0."""
    sphere_volume = 4 * math.pi / 3 * (area / (4 * math.pi)) ** 1.5
    return pressure * sphere_volume / (8 * math.pi * rigidity)


def number(row, column, positive=False):
    try:
        value = float(row[column])
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or (positive and value <= 0):
        raise BadTable(f"{column} is '{row[column]}', but must be a {'positive' if positive else 'finite'} number")
    return value


def state(row):
    """The state in a row of the table (column -> text)."""
    if not row["branch"].strip():
        raise BadTable("branch is empty, but must be a name")
    count = row["negative_eigenvalues"].strip()
    if count and not (count.isascii() and count.isdigit()):
        raise BadTable(f"negative_eigenvalues is '{count}', but must be a whole number from 0 on, or empty")
    if row["is_fold"].strip() not in ("0", "1"):
        raise BadTable(f"is_fold is '{row['is_fold']}', but must be 0 or 1")
    slope = energy_slope(number(row, "pressure"), number(row, "area", True), number(row, "bending_rigidity", True))
    return State(number(row, "reduced_volume", True), number(row, "bending_energy_over_8_pi_kappa"), slope,
                 int(count) if count else None, row["is_fold"].strip() == "1")


def read_branches(path):
    """Branch -> its states in the order of the rows; branches in the order of their first rows. Throws BadTable."""
    branches = {}
    try:
        with open(path, encoding="utf-8", newline="") as file:
            reader = csv.DictReader(file, strict=True)
            columns = [name.strip() for name in reader.fieldnames or []]
            missing = [name for name in COLUMNS if name not in columns]
            if missing:
                raise BadTable(f"{path} lacks the columns: {', '.join(missing)}.")
            reader.fieldnames = columns
            for row in reader:
                if None in row or None in row.values():
                    raise BadTable(f"{path}:{reader.line_num}: the row does not have {len(columns)} fields as the first line has.")
                try:
                    branches.setdefault(row["branch"].strip(), []).append(state(row))
                except BadTable as error:
                    raise BadTable(f"{path}:{reader.line_num}: {error}.") from None
    except OSError as error:
        raise BadTable(f"{path} cannot be read: {error.strerror}.") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise BadTable(f"{path} is not a table of comma-separated values: {error}.") from None
    if not branches:
        raise BadTable(f"{path} holds no state.")
    return branches
