# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs an application the way a user does, each time in a folder of its own."""

import csv
import json
import os
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def settings(*assignments):
    """Arguments that override parameters."""
    return [argument for assignment in assignments for argument in ("--set", assignment)]


class Run:
    """A finished run: exit status, what it printed, and its files."""

    def __init__(self, process, directory):
        self.status, self.stdout, self.stderr = process.returncode, process.stdout, process.stderr
        self.directory = directory

    @property
    def files(self):
        return sorted(p.name for p in self.directory.iterdir()) if self.directory.is_dir() else []

    @property
    def summary(self):
        def refuse(name):
            raise ValueError(f"summary.json holds {name}, which is no JSON number")

        return json.loads((self.directory / "summary.json").read_text(encoding="utf-8"), parse_constant=refuse)

    @property
    def quantities(self):
        return self.summary["quantities"]

    def table(self, name):
        with open(self.directory / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


class ProgramTest(unittest.TestCase):
    """A test with a temporary folder, in which its runs take place. Subclasses name the application and its file."""

    application = program = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix=f"pellicle_{self.application}_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def call(self, *arguments, launcher=(), timeout=300, preexec_fn=None, **environment):
        """The program with exactly these arguments."""
        return subprocess.run([*launcher, self.program, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, check=False,
                              cwd=self.folder, env={**os.environ, **environment}, preexec_fn=preexec_fn)

    def run_scene(self, scene, *assignments, name="run", picture=False, options=(), **keywords):
        """Runs a scene with overrides into the folder `name`. Without a picture unless wanted."""
        overrides = settings(*assignments, *(() if picture else ("Output/Picture=false",)))
        directory = self.folder / name
        return Run(self.call(scene, *overrides, "--output-directory", directory, *options, **keywords), directory)

    def solve(self, scene, *assignments, **keywords):
        """As run_scene, and it must succeed."""
        run = self.run_scene(scene, *assignments, **keywords)
        self.assertEqual(run.status, 0, run.stderr)
        self.assertEqual(run.summary["status"], "converged")
        return run

    def assert_within(self, value, expected, relative):
        self.assertLessEqual(abs(value - expected), relative * abs(expected), f"{value!r} is not {expected!r} within {relative} of it")

    def assert_clear_refusal(self, process, directory, words):
        """Exit status 2 and one message on stderr that holds all the words; no summary, nothing of what the program is made of."""
        text = process.stderr
        self.assertEqual(process.returncode, 2, text)
        self.assertTrue(text.startswith(f"{self.application}: "), text)
        self.assertLessEqual(len(text.splitlines()), 3, text)
        for word in words:
            self.assertIn(word, text)
        for word in ("terminate", "dealii", "deal.II", "std::", "Assert", "backtrace", "MPI_ABORT", "should not happen"):
            self.assertNotIn(word, text)
        self.assertFalse((Path(directory) / "summary.json").exists(), text)

    def assert_refusals(self, scene, cases):
        """Of a scene with overrides: cases (overrides, words), each refused with one message that holds the words."""

        def attempt(case):
            number, (overrides, words) = case
            directory = self.folder / f"run{number}"
            return overrides, words, directory, self.call(scene, *settings(*overrides), "--output-directory", directory)

        for overrides, words, directory, process in in_pairs(attempt, list(enumerate(cases))):
            with self.subTest(overrides=overrides):
                self.assert_clear_refusal(process, directory, words)

    def assert_valid(self, scenes):
        """All of them pass --validate."""
        for scene, process in zip(scenes, in_pairs(lambda scene: self.call("--validate", scene), scenes)):
            with self.subTest(scene=scene.name):
                self.assertEqual(process.returncode, 0, process.stderr)


def in_pairs(function, cases):
    """Calls function for all cases, two at a time: most of the time of a refusal is the start of the program."""
    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(function, cases))
