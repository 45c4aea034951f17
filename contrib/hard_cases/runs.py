# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the list of hard cases and runs one."""

import csv
import json
import os
import re
import resource
import subprocess
import tempfile
from pathlib import Path

APPLICATION = re.compile(r"^# application: (\w+)$", re.MULTILINE)


def load_cases(root):
    """All cases, each a dictionary as README.md describes it."""
    return json.loads((root / "contrib" / "hard_cases" / "cases.json").read_text(encoding="utf-8"))["cases"]


class Outcome:
    """A run that has ended: exit status (None: stopped at its budget), what it printed, its summary and tables."""

    def __init__(self, status, stderr, directory, cpu_seconds):
        self.status, self.stderr, self.cpu_seconds = status, stderr, cpu_seconds
        summary = directory / "summary.json"
        self.summary = json.loads(summary.read_text(encoding="utf-8")) if summary.is_file() else {}
        self.tables = {name: rows(directory / name) for name in ("history.csv", "branch.csv")}

    @property
    def iterations(self):
        return self.summary.get("newton", {}).get("iterations")


def rows(path):
    if not path.is_file():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run_case(case, binaries, root):
    """Runs the case's scene in a folder of its own, for as long as its budget allows."""
    scene = root / "prm" / "hard" / f"{case['name']}.prm"
    application = APPLICATION.search(scene.read_text(encoding="utf-8")).group(1)
    settings = ["Output/Picture=false", "Output/Solution=false", "Newton/Condition estimate=true"]
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OPENBLAS_NUM_THREADS": "1"}
    with tempfile.TemporaryDirectory(prefix="pellicle_hard_") as folder:
        command = [str(Path(binaries) / application), *(argument for s in settings for argument in ("--set", s)),
                   "--quiet", "--output-directory", folder, str(scene)]
        before = children_seconds()
        try:
            process = subprocess.run(command, capture_output=True, text=True, timeout=case["budget"], check=False, env=environment)
            status, stderr = process.returncode, process.stderr
        except subprocess.TimeoutExpired:
            status, stderr = None, ""
        return Outcome(status, stderr, Path(folder), children_seconds() - before)
