#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that every public header of some rooms compiles on its own, and twice in a row.

Usage: check_headers.py --compiler g++ --include include [--system-includes DIR:DIR:...] [--jobs N] room ...
"""

import argparse
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FLAGS = ["-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wfatal-errors", "-x", "c++", "-"]
FLAGS_OF_GCC = ["-Wshadow=local"]


def compile_alone(command, name):
    """The compiler's complaints about a header, empty when there are none."""
    text = f"#include <{name}>\n" * 2
    run = subprocess.run(command + FLAGS, input=text, stderr=subprocess.PIPE, text=True, check=False)
    return f"<{name}> does not compile on its own:\n{run.stderr}" if run.returncode else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--include", type=Path, required=True, help="folder that holds pellicle/")
    parser.add_argument("--system-includes", default="", help="folders of other libraries' headers, separated by colons")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("rooms", nargs="+", metavar="room")
    options = parser.parse_args()

    command = [options.compiler, f"-I{options.include}"] + ([] if "clang" in Path(options.compiler).name else FLAGS_OF_GCC)
    for folder in options.system_includes.split(":"):
        if folder and Path(folder) != options.include:
            command += ["-idirafter", folder]  # after the compiler's own: one of them may stand in the list again
    names = []
    for room in options.rooms:
        headers = (options.include / "pellicle" / room).rglob("*.h")
        names += sorted(header.relative_to(options.include).as_posix() for header in headers)

    with ThreadPoolExecutor(options.jobs) as pool:
        complaints = [text for text in pool.map(lambda name: compile_alone(command, name), names) if text]
    for text in complaints:
        print(text)
    print(f"{len(names)} headers, {len(complaints)} do not compile on their own")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
