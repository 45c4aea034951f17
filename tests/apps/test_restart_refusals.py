# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checkpoints that cannot be used, scenes that do not fit, and discs that are full: what is said, and what stays."""

import resource
import shutil
import struct
import subprocess
import zlib

from pellicle_program import settings
from restart_runs import KEEP_ALL, SCENES, RestartTest, check_all_files_are_whole, checkpoints, what_counts

SCENE = ("vesicle", "prolate.prm")
SHORT = ("Mesh/Symmetry=axial", "Mesh/Refinements=1", "Load/Parameter=Vesicle/Reduced volume", "Load/To=0.8", "Load/Steps=4")
HEADER = 32  # bytes


def with_content(text):
    """A whole checkpoint file with another content."""
    return b"Pellicle state\r\n" + struct.pack("=IIQ", 0x01020304, zlib.crc32(text), len(text)) + text


class Damaged(RestartTest):
    def setUp(self):
        super().setUp()
        self.run_ = self.start(SCENE, *SHORT, *KEEP_ALL, name="kept")
        self.assertEqual(self.run_.status, 0, self.run_.stderr)

    def refused(self, directory, words, *assignments, options=()):
        process = self.call("--restart", directory, *settings(*assignments), *options)
        self.assertEqual(process.returncode, 2, process.stderr)
        self.assertTrue(process.stderr.startswith(f"{self.application}: "), process.stderr)
        for word in words:
            self.assertIn(word, process.stderr)
        for word in ("std::", "should not happen", "terminate"):
            self.assertNotIn(word, process.stderr)

    def test_falls_back_to_the_last_whole_one(self):
        whole = checkpoints(self.run_.directory)[-1].read_bytes()
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 1
        for fault, content in (("bytes where", whole[:-1]), ("fewer than its header", whole[:HEADER - 1]), ("fewer than its header", b""),
                               ("checksum", bytes(flipped)), ("not a checkpoint", b"x" * len(whole)), ("bytes where", whole + b"x")):
            with self.subTest(fault=fault):
                copy = self.copy_at(self.run_, 2)
                damaged = checkpoints(copy)[-1]
                damaged.write_bytes(content)
                later = self.restart(copy)
                self.assertEqual(later.status, 0, later.stderr)
                warning, = later.summary["warnings"]
                self.assertIn(damaged.name, warning)
                self.assertIn(fault, warning)
                self.assertEqual(what_counts(copy)["history.csv"], what_counts(self.run_.directory)["history.csv"])
                self.assertEqual(damaged.read_bytes()[:16], whole[:16])  # its place was taken
                shutil.rmtree(copy)

    def test_none_is_whole(self):
        copy = self.copy_at(self.run_, 2)
        for path in checkpoints(copy):
            path.write_bytes(b"")
        self.refused(copy, ["step_000001.bin", "step_000002.bin", "fewer than its header", "from its start"])

    def test_there_is_none(self):
        self.refused(self.folder / "nowhere", ["no such directory", str(self.folder / "nowhere")])
        empty = self.folder / "empty"
        empty.mkdir()
        self.refused(empty, ["no checkpoint in", "Checkpoint/Every"])
        self.refused(self.run_.directory / "used.prm", ["no such directory"])

    def test_other_programs(self):
        copy = self.copy_at(self.run_, 1)
        path, = checkpoints(copy)
        content = path.read_bytes()[HEADER:]
        version = self.call("--version").stdout.split()[-1].encode()
        path.write_bytes(with_content(content.replace(version, b"9" * len(version), 1)))
        self.refused(copy, ["version 99", version.decode()])
        path.write_bytes(with_content(b"something else"))
        self.refused(copy, ["another version"])
        path.write_bytes(with_content(content[:-1]))
        self.refused(copy, ["does not fit", "ends too early"])
        path.write_bytes(with_content(content))
        process = subprocess.run([self.program.replace("vesicle", "droplet_contact"), "--restart", copy], capture_output=True, text=True,
                                 check=False, cwd=self.folder)
        self.assertEqual(process.returncode, 2)
        self.assertIn("written by the application 'vesicle'", process.stderr)

    def test_what_may_change(self):
        copy = self.copy_at(self.run_, 2)
        for override, words in (("Mesh/Degree=4", ["Mesh/Degree = 4", "has 3"]), ("Vesicle/Area=1", ["Vesicle/Area = 1", "has 4*pi"]),
                                ("Load/Parameter=Pressure/Pressure", ["Load/Parameter"]), ("Effects=helfrich bending", ["Effects"]),
                                ("Load/To=0.95", ["Load/To = 0.95", "lies ahead"])):
            with self.subTest(override=override):
                self.refused(copy, words, override)
        self.refused(copy, ["Vesicle/Start shape = oblate", "has prolate", str(copy)], *SHORT, options=[self.oblate()])
        same = self.restart(self.copy_at(self.run_, 3), options=[SCENES["vesicle"] / SCENE[1], *settings(*SHORT)])
        self.assertEqual(same.status, 0, same.stderr)
        self.assertEqual(what_counts(same.directory)["history.csv"], what_counts(self.run_.directory)["history.csv"])
        farther = self.restart(copy, "Load/To=0.78", "Output/Solution=false", "Newton/Maximum iterations=70")
        self.assertEqual(farther.status, 0, farther.stderr)
        self.assert_within(farther.quantities["reduced_volume"], 0.78, 1e-9)
        self.assertEqual([row["step"] for row in farther.table("history.csv")],
                         [str(n) for n in range(len(farther.table("history.csv")))])

    def oblate(self):
        text = (SCENES["vesicle"] / SCENE[1]).read_text(encoding="utf-8")
        return self.write("oblate.prm", text.replace("= prolate", "= oblate"))

    def test_elsewhere(self):
        copy = self.copy_at(self.run_, 2)
        elsewhere = self.folder / "elsewhere"
        before = {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}
        process = self.call("--restart", copy, "--output-directory", elsewhere, *settings("Output/Picture=false"))
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assert_same(what_counts(elsewhere), what_counts(self.run_.directory))
        self.assertEqual({path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}, before)

    def test_a_new_run_leaves_no_old_checkpoints(self):
        again = self.start(SCENE, *SHORT, name="kept")
        self.assertEqual(again.status, 0, again.stderr)
        self.assertFalse((again.directory / "checkpoint").exists())


class WithoutCheckpoints(RestartTest):
    def test_runs_that_write_none(self):
        for scene, override, word in ((SCENE, "Accuracy/Target=1e-3", "Accuracy/Target"),
                                      (("vesicle", "phase_diagram.prm"), "Output/Solution=false", "phase diagram")):
            run = self.start(scene, override, "Checkpoint/Every=1")
            self.assertEqual(run.status, 2, run.stderr)
            for text in ("Checkpoint/Every = 1", word, "0"):
                self.assertIn(text, run.stderr)
            self.assertEqual(run.files, [])


class FullDisc(RestartTest):
    def limited(self, size, *assignments):
        """A run whose files may have so many bytes."""
        return self.start(SCENE, *SHORT, *assignments, "Output/Solution=false", name="limited",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))

    def assert_ended(self, run, name, reason):
        self.assertEqual(run.status, 1, run.stderr)
        for word in (name, reason, "--output-directory"):
            self.assertIn(word, run.stderr)
        self.assertEqual([p for p in run.directory.rglob("*.tmp")], [])
        self.assertNotIn("summary.json", run.files)
        check_all_files_are_whole(self, run.directory)

    def test_checkpoint_that_is_too_large(self):
        whole = self.start(SCENE, *SHORT, *KEEP_ALL, "Output/Solution=false", name="whole")
        sizes = [path.stat().st_size for path in checkpoints(whole.directory)]
        self.assertEqual(sizes, sorted(sizes))
        run = self.limited((sizes[1] + sizes[2]) // 2, *KEEP_ALL)
        self.assert_ended(run, "step_000003.bin", "File too large")
        self.assertEqual(len(checkpoints(run.directory)), 2)
        later = self.restart(run.directory)
        self.assertEqual(later.status, 0, later.stderr)
        self.assert_same(what_counts(later.directory), what_counts(whole.directory))

    def test_table_that_is_too_long(self):
        """The line for which there is no room is not there in part."""
        many = "Load/Steps=16"
        whole = self.start(SCENE, *SHORT, many, "Output/Solution=false", name="whole")
        sizes = {path.name: path.stat().st_size for path in whole.directory.iterdir()}
        longest = max(("history.csv", "convergence.csv"), key=sizes.get)
        limit = sizes[longest] - 300
        self.assertGreater(limit, max(size for name, size in sizes.items() if name != longest))
        run = self.limited(limit, many)
        self.assert_ended(run, longest, "File too large")
        self.assertGreater((run.directory / longest).stat().st_size, limit - 300)

    def test_disc_without_room(self):
        """A real file system that is full, where one may be mounted."""
        disc = self.folder / "disc"
        disc.mkdir()
        mount = shutil.which("mount") or "false"
        if subprocess.run([mount, "-t", "tmpfs", "-o", "size=96k", "tmpfs", disc], capture_output=True, check=False).returncode != 0:
            self.skipTest("no file system may be mounted here")
        try:
            run = self.start(SCENE, *SHORT, *KEEP_ALL, name="disc/run")
            self.assert_ended(run, "disc/run", "No space left on device")
        finally:
            subprocess.run(["umount", disc], check=True)
