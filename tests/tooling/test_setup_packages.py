# SPDX-License-Identifier: LGPL-2.1-or-later
"""contrib/setup_packages.sh against made-up package tools that write down how they are called."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parents[2] / "contrib" / "setup_packages.sh"

DPKG_QUERY = """#!/bin/sh
for name; do :; done
case " $MISSING " in *" $name "*) echo "dpkg-query: no packages found matching $name" >&2; exit 1 ;; esac
printf installed
"""
APT_GET = """#!/bin/sh
echo "$*" >> "$LOG"
case "$*" in *" $APT_FAILS"*) exit 100 ;; esac
"""
SUDO = """#!/bin/sh
exec "$@"
"""


class SetupPackages(unittest.TestCase):
    def run_script(self, *options, missing="", apt_fails="never"):
        """Exit status, output and the calls of apt-get."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("dpkg-query", DPKG_QUERY), ("apt-get", APT_GET), ("sudo", SUDO)):
                tool = Path(folder) / name
                tool.write_text(text, encoding="utf-8")
                tool.chmod(0o755)
            log = Path(folder) / "log"
            log.touch()
            environment = dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}", LOG=str(log), MISSING=missing, APT_FAILS=apt_fails)
            run = subprocess.run([SCRIPT, *options], env=environment, capture_output=True, text=True, check=False)
            return run.returncode, run.stdout + run.stderr, log.read_text(encoding="utf-8").splitlines()

    def test_nothing_is_done_twice(self):
        status, output, calls = self.run_script()
        self.assertEqual((status, calls), (0, []), output)

    def test_only_missing_packages_after_an_update(self):
        status, output, calls = self.run_script(missing="libcli11-dev xvfb")
        self.assertEqual(status, 0, output)
        self.assertEqual(len(calls), 2)
        self.assertTrue(calls[0].endswith(" update"), calls[0])
        self.assertTrue(calls[1].endswith(" install --yes --no-install-recommends libcli11-dev xvfb"), calls[1])

    def test_compilers_of_fuzzers_only_for_the_long_tests(self):
        self.assertEqual(self.run_script(missing="clang-14")[2], [])
        calls = self.run_script("--long", missing="clang-14")[2]
        self.assertTrue(calls[-1].endswith(" clang-14"), calls)

    def test_failure_is_passed_on(self):
        self.assertNotEqual(self.run_script(missing="xvfb", apt_fails="update")[0], 0)
        self.assertNotEqual(self.run_script(missing="xvfb", apt_fails="install")[0], 0)


if __name__ == "__main__":
    unittest.main()
