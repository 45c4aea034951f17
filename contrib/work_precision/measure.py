# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs one program at a time and measures it: seconds of the wall clock and of the processor, medians of repeats."""

import json
import os
import re
import statistics
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

ENOUGH_SECONDS = 1.2  # a setting is repeated until all its runs together took that long
LONGEST_RUN = 150.0


@dataclass(frozen=True)
class Measurement:
    """What a setting of a case yielded; seconds are medians. `seconds` are those within main, `start_up` is the rest."""

    case: str
    line: str
    setting: str
    unknowns: int
    value: float
    error: float
    seconds: float
    cpu: float
    start_up: float
    assembly: float = 0.0
    linear_solve: float = 0.0
    output: float = 0.0
    repeats: int = 1

    @property
    def is_evolver(self):
        return self.line.startswith("Surface Evolver")

    @property
    def kind(self):
        """Of the mesh: a surface in space or a symmetric part of it, a meridian; or the other program."""
        return "Surface Evolver" if self.is_evolver else "meridian" if self.line.startswith("axial") else "in space"


class RunFailed(Exception):
    """A run ended without a result; the text says why."""


def timed(command, folder):
    """Runs a command: exit status, what it printed, seconds of the wall clock and of the processor. RunFailed if it takes too long."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    with open(folder / "out", "w+", encoding="utf-8") as out:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT, cwd=folder, env=environment)
        alarm = threading.Timer(LONGEST_RUN, process.kill)
        alarm.start()
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        alarm.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        if wall > LONGEST_RUN:
            raise RunFailed(f"stopped after {LONGEST_RUN:.0f} s")
        out.seek(0)
        return process.returncode, out.read(), wall, usage.ru_utime + usage.ru_stime


def repeated(run_once, repeats):
    """Results of run_once(), which returns a dictionary of numbers: their medians, and how many runs there were."""
    runs = [run_once()]
    while len(runs) < repeats and sum(r["wall"] for r in runs) < ENOUGH_SECONDS:
        runs.append(run_once())
    return {key: statistics.median(r[key] for r in runs) for key in runs[0]}, len(runs)


class Pellicle:
    """The applications in one folder."""

    def __init__(self, binaries, scenes):
        self.binaries, self.scenes = Path(binaries).resolve(), Path(scenes).resolve()
        self.offered = {}

    def offers(self, program, setting):
        """Whether the program knows what the setting asks for."""
        if program not in self.offered:
            with tempfile.TemporaryDirectory() as folder:
                text = Path(folder) / "all.prm"
                status, output, _, _ = timed([self.binaries / program, "--write-parameters", text], Path(folder))
                if status != 0:
                    raise RunFailed(f"{program} does not run: {output.strip()[:300]}")
                self.offered[program] = text.read_text(encoding="utf-8")
        return all(text in self.offered[program] for text in setting.needs)

    def measure(self, case, setting, repeats):
        """A Measurement; RunFailed if the program reports no result."""
        with tempfile.TemporaryDirectory(prefix="work_precision_") as name:
            folder = Path(name)
            once = self._evaluate if case.given else self._solve
            medians, count = repeated(lambda: once(case, setting, folder), repeats)
        return Measurement(
            case.name, setting.line, setting.name, int(medians["unknowns"]), medians["value"], case.reference.error(medians["value"]),
            medians["total"], medians["cpu"], medians["wall"] - medians["total"], medians["assembly"], medians["linear_solve"], medians["output"], count,
        )

    def _command(self, case, setting, folder, *more):
        scene = self.scenes / case.scene if case.scene else folder / "scene.prm"
        if not case.scene:
            scene.write_text(case.text, encoding="utf-8")
        overrides = ("Output/Picture=false", "Output/Solution=false", *case.overrides, *setting.overrides)
        return [self.binaries / case.program, scene, *(word for o in overrides for word in ("--set", o)), *more]

    def _solve(self, case, setting, folder):
        status, output, wall, cpu = timed(self._command(case, setting, folder, "--quiet", "--output-directory", folder / "run"), folder)
        if status != 0:
            raise RunFailed(output.strip()[-400:])
        summary = json.loads((folder / "run" / "summary.json").read_text(encoding="utf-8"))
        seconds = summary["seconds"]
        return {"wall": wall, "cpu": cpu, "unknowns": summary["unknowns"]["total"], "value": summary["quantities"][case.quantity],
                **{key: seconds[key] for key in ("total", "assembly", "linear_solve", "output")}}

    def _evaluate(self, case, setting, folder):
        status, output, wall, cpu = timed(self._command(case, setting, folder, "--validate"), folder)
        if status != 0:
            raise RunFailed(output.strip()[-400:])

        def number(pattern):
            return float(re.search(pattern + r" ([-+.\deE]+)$", output, re.MULTILINE).group(1))

        # The moment at each node is what is solved for.
        unknowns = 3 * int(re.search(r"(\d+) nodes$", output, re.MULTILINE).group(1))
        return {"wall": wall, "cpu": cpu, "unknowns": unknowns, "value": number(rf"{case.quantity} ="), "total": number("^Seconds:"),
                "assembly": 0.0, "linear_solve": 0.0, "output": 0.0}
