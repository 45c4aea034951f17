# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are killed (SIGKILL) at moments drawn at random: what they leave is whole, and they go on from it as if nothing had been."""

import random
import signal
import subprocess
import time

from pellicle_program import settings
from restart_runs import PROGRAMS, SCENES, RestartTest, check_all_files_are_whole, checkpoints, what_counts

SCENE = ("vesicle", "prolate.prm")
STEPS = ("Mesh/Symmetry=axial", "Mesh/Refinements=3", "Load/Parameter=Vesicle/Reduced volume", "Load/To=0.75", "Load/Steps=60",
         "Checkpoint/Every=1", "Output/Picture=false")


class KilledRuns(RestartTest):
    def kill_at_random(self, n_moments, seed):
        start = time.monotonic()
        straight = self.start(SCENE, *STEPS, name="straight")
        seconds = time.monotonic() - start
        self.assertEqual(straight.status, 0, straight.stderr)
        expected = what_counts(straight.directory)
        moments = random.Random(seed)
        n_resumed = 0
        for number in range(n_moments):
            directory = self.folder / f"killed{number}"
            self.kill_after(moments.uniform(0.2, 1.1) * seconds, directory)
            with self.subTest(moment=number):
                n_resumed += self.go_on(directory, expected)
        return n_resumed

    def kill_after(self, seconds, directory):
        command = [PROGRAMS["vesicle"], SCENES["vesicle"] / SCENE[1], *settings(*STEPS), "--quiet", "--output-directory", directory]
        with subprocess.Popen(command, cwd=self.folder) as process:
            try:
                process.wait(timeout=seconds)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)

    def go_on(self, directory, expected):
        """Whether there was a checkpoint to go on from; without one the scene is run anew."""
        there_is_one = bool(checkpoints(directory))
        check_all_files_are_whole(self, directory)
        run = self.restart(directory) if there_is_one else self.start(SCENE, *STEPS, name=directory.name)
        self.assertEqual(run.status, 0, run.stderr)
        self.assertEqual(run.summary["warnings"], [])
        self.assert_same(what_counts(directory), expected)
        self.assertEqual([p.name for p in directory.rglob("*.tmp")], [])
        self.assertLessEqual(len(checkpoints(directory)), 2)
        return there_is_one


class FewMoments(KilledRuns):
    def test_four_moments(self):
        self.kill_at_random(4, seed=1)


class ManyMoments(KilledRuns):
    def test_fifty_moments(self):
        self.assertGreater(self.kill_at_random(50, seed=2), 15)
