# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that go on from a checkpoint, and what they must have in common with runs that were never interrupted."""

import csv
import json
import os
import shutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from pellicle_program import ProgramTest, Run, settings

__all__ = ["KEEP_ALL", "RestartTest", "SCENES", "checkpoints", "check_all_files_are_whole", "what_counts"]

SCENES = {name: Path(os.environ[variable]) for name, variable in
          (("vesicle", "PELLICLE_SCENES"), ("droplet_contact", "PELLICLE_DROPLET_SCENES"),
           ("wetting_ridge", "PELLICLE_RIDGE_SCENES"), ("director_membrane", "PELLICLE_DIRECTOR_SCENES"))}
PROGRAMS = {name: os.environ["PELLICLE_" + name.upper()] for name in SCENES}

KEEP_ALL = ("Checkpoint/Every=1", "Checkpoint/Keep=1000")


def checkpoints(directory):
    """Files of the checkpoints, the first one first."""
    return sorted((Path(directory) / "checkpoint").glob("step_*.bin"))


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def what_counts(directory):
    """All that a run leaves and that does not tell the time: summary, tables, index, solutions."""
    content = {}
    for path in sorted(Path(directory).iterdir()):
        if path.name == "summary.json":
            summary = json.loads(path.read_text(encoding="utf-8"))
            summary.pop("seconds")
            content[path.name] = summary
        elif path.name == "convergence.csv":
            content[path.name] = [{name: value for name, value in row.items() if name != "seconds"} for row in rows(path)]
        elif path.suffix in (".csv", ".pvd", ".vtu"):
            content[path.name] = path.read_bytes()
    return content


def check_all_files_are_whole(test, directory):
    """Every file parses to its end, with lines of equal length in tables; nothing unfinished lies in the way of a reader."""
    for path in sorted(p for p in Path(directory).rglob("*") if p.is_file() and p.suffix != ".tmp"):
        text = path.read_bytes()
        with test.subTest(file=path.name):
            if path.suffix == ".json":
                json.loads(text)
            elif path.suffix in (".vtu", ".pvd"):
                ElementTree.fromstring(text)
            elif path.suffix == ".prm":
                test.assertEqual(text.count(b"subsection "), text.count(b"\nend\n"))
                test.assertIn(b"subsection Checkpoint", text)
            elif path.suffix == ".csv" and text:
                test.assertTrue(text.endswith(b"\n"))
                lengths = {len(row) for row in csv.reader(text.decode("utf-8").splitlines())}
                test.assertEqual(len(lengths), 1)


class RestartTest(ProgramTest):
    """A test of any application: its scenes are (application, file name)."""

    application = "restart"

    def start(self, scene, *assignments, name="run", options=(), **keywords):
        """A run of a scene into the folder `name`, whatever its end."""
        self.application, file = scene
        self.program = PROGRAMS[self.application]
        return self.run_scene(SCENES[self.application] / file, *assignments, name=name, options=options, **keywords)

    def restart(self, directory, *assignments, options=(), **keywords):
        """Goes on with the run in a folder."""
        return Run(self.call("--restart", directory, *settings(*assignments), *options, **keywords), Path(directory))

    def copy_at(self, run, step):
        """A copy of a run as it is when it is killed some time after its checkpoint `step` and before the next one."""
        copy = self.folder / f"{run.directory.name}_{step}"
        shutil.copytree(run.directory, copy)
        for path in checkpoints(copy):
            if int(path.stem.split("_")[1]) > step:
                path.unlink()
        (copy / "summary.json").unlink()
        return copy

    def check_goes_on(self, scene, *assignments, steps=None):
        """A run without checkpoints, one with, and those that go on from these checkpoints (the first, one in the middle, the last):
        all give the same, to the last bit."""
        plain = self.start(scene, *assignments, name="plain")
        self.assertEqual(plain.status, 0, plain.stderr)
        run = self.start(scene, *assignments, *KEEP_ALL, name="kept")
        expected = what_counts(plain.directory)
        self.assert_same(what_counts(run.directory), expected)
        numbers = [int(path.stem.split("_")[1]) for path in checkpoints(run.directory)]
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        self.assertGreater(len(numbers), 1)
        for step in steps or sorted({numbers[0], numbers[len(numbers) // 2], numbers[-1]}):
            with self.subTest(step=step):
                later = self.restart(self.copy_at(run, step))
                self.assertEqual(later.status, 0, later.stderr)
                self.assert_same(what_counts(later.directory), expected)
                self.assertEqual(len(checkpoints(later.directory)), len(numbers))
        return run

    def assert_same(self, content, expected):
        self.assertEqual(sorted(content), sorted(expected))
        for name, value in expected.items():
            if name.endswith(".vtu"):
                self.assertTrue(content[name] == value, name)
            else:
                self.assertEqual(content[name], value, name)
