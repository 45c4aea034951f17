# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same problems for Surface Evolver (Brakke; Debian package `evolver`), with the inputs in evolver/.

Every run is refined on the sphere, mapped to the start shape and solved by Newton's method with Evolver's Hessian, which needs one step of gradient descent of
length zero first, for the multipliers. Far from equilibrium steps are found by a line search (hessian_seek).
"""

import re
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from measure import Measurement, RunFailed, repeated, timed

INPUTS = Path(__file__).resolve().parent / "evolver"
MISSING = "Surface Evolver is not installed: its part of the study is left out. On Debian: apt-get install evolver-nox"


def is_installed():
    return shutil.which("evolver") is not None


@dataclass(frozen=True)
class Problem:
    """A datafile, the commands between refinement and solution, those of the solution (with `result;` before the last step, so that convergence is
    seen), and what is run."""

    datafile: str
    shape: str
    solve: str
    levels: tuple  # (model, refinements)
    quick: tuple = ()


def spheroid_of(reduced_volume, prolate):
    """Semi axes (equatorial, polar) of the spheroid of area 4 pi."""

    def area(c):
        if c > 1:
            e = np.sqrt(1 - 1 / c**2)
            return 2 * np.pi * (1 + c / e * np.arcsin(e))
        e = np.sqrt(1 - c**2)
        return 2 * np.pi * (1 + (1 - e**2) / e * np.arctanh(e))

    low, high = (1.0 + 1e-6, 50.0) if prolate else (1.0 - 1e-6, 1e-3)
    for _ in range(200):  # bisection: the reduced volume falls away from the sphere
        c = 0.5 * (low + high)
        low, high = (c, high) if c / (area(c) / (4 * np.pi)) ** 1.5 > reduced_volume else (low, c)
    scale = np.sqrt(4 * np.pi / area(c))
    return scale, c * scale


def vesicle(reduced_volume, prolate, towards_poles, seeks, finest):
    equatorial, polar = spheroid_of(reduced_volume, prolate)
    shape = (
        f"reduced_volume := {reduced_volume}; body[1].target := {reduced_volume}*4*pi/3; "
        f"equatorial := {equatorial:.16g}; polar := {polar:.16g}; towards_poles := {towards_poles}; spheroid;"
    )
    solve = "m 0; g; " + "hessian_seek; " * seeks + "hessian; result; hessian;"
    return Problem("vesicle.fe", shape, solve, tuple(("linear", r) for r in range(2, finest + 1)), (("linear", 2),))


def shape(command):
    return Problem("vesicle.fe", command, "", tuple(("linear", r) for r in range(2, 7)), (("linear", 2),))


def drop(angle):
    levels = (("quadratic", 0), ("quadratic", 1), ("quadratic", 2), ("quadratic", 3), ("quadratic", 4), ("lagrange 4", 0), ("lagrange 4", 1), ("lagrange 4", 2),
              ("lagrange 6", 0), ("lagrange 6", 1), ("lagrange 6", 2), ("lagrange 8", 0), ("lagrange 8", 1))
    return Problem("drop.fe", f"angle := {angle}; cap;", "m 0; g; hessian; hessian; result; hessian;", levels, (("lagrange 4", 0), ("lagrange 4", 1)))


PROBLEMS = {
    "sphere": shape(""),
    "ellipsoid": shape("equatorial := 0.5; polar := 1; spheroid;"),
    "biconcave": shape("biconcave;"),
    # On 81920 facets (6 refinements) four line searches are far from enough, and each takes 11 s.
    "prolate": vesicle(0.9, True, towards_poles=0.2, seeks=5, finest=5),
    "discocyte": vesicle(0.65, False, towards_poles=0, seeks=14, finest=4),
    "sessile60": drop(60),
    "sessile120": drop(120),
}


def commands(problem, model, refinements):
    """What is piped into Evolver."""
    lines = ["r; sphere;"] * refinements
    if model == "quadratic":
        lines += ["convert_to_quantities;", "M 2; sphere;", "integral_order_2d := 6; integral_order_1d := 8;"]
    elif model.startswith("lagrange"):
        order = int(model.split()[1])
        lines += ["convert_to_quantities;", f"{model}; sphere;", f"integral_order_2d := {2 * order + 2}; integral_order_1d := {4 * order};"]
    return "\n".join([*lines, problem.shape, problem.solve, "result;", "q", "q", ""])


def measure(case, model, refinements, repeats):
    """A Measurement of Evolver; RunFailed where it finds no equilibrium."""
    problem = PROBLEMS[case.evolver]
    with tempfile.TemporaryDirectory(prefix="work_precision_") as name:
        folder = Path(name)
        (folder / "script").write_text(commands(problem, model, refinements), encoding="utf-8")

        def run_once():
            status, output, wall, cpu = timed(["evolver", "-x", "-f", "script", INPUTS / problem.datafile], folder)
            found = re.findall(r"^result ([-+.\deE]+) facets (\d+)", output, re.MULTILINE)
            if status != 0 or not found:
                raise RunFailed(output.strip()[-400:])
            before, value = float(found[0][0]), float(found[-1][0])
            return {"wall": wall, "cpu": cpu, "value": value, "before": before, "facets": int(found[-1][1])}

        medians, count = repeated(run_once, repeats)
    error = case.reference.error(medians["value"])
    last_change = abs(medians["value"] - medians["before"]) / abs(case.reference.value)
    if not (error < 0.5 and last_change < max(0.1 * error, 1e-12)):
        raise RunFailed(f"Newton's method has not converged: {medians['before']:.10g}, then {medians['value']:.10g}")
    return Measurement(case.name, f"Surface Evolver, {model}", f"{model} r{refinements}", int(medians["facets"]), medians["value"], error, medians["wall"],
                       medians["cpu"], 0.0, repeats=count)
