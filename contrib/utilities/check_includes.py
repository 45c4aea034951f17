#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks who includes whom (doc/architecture.md, "The rooms").

Three rules for include/pellicle/<room> and source/<room>:
1. A file includes only its own room and rooms to the left of it in ROOMS.
2. Own headers are included as <pellicle/room/x.h>, and exist. Quotes are for a private header beside the file, so there is no way
   round rule 1.
3. `base`, `kinematics` and `potentials` reach no deal.II and no MPI header, not even through a header of our own. Files of `base`
   that read scenes are exempt.

Usage: check_includes.py [project's root]. Prints file:line: message for every breach; exit status 1 if there is one.
"""

import re
import sys
from pathlib import Path

ROOMS = ["base", "kinematics", "potentials", "discretization", "assembly", "solvers", "models", "output", "apps"]
POINT_ROOMS = ["base", "kinematics", "potentials"]
SCENE_FILE = re.compile(r"^base/(scene|expression)")
HEAVY_HEADER = re.compile(r"^(deal\.II/|mpi\.h$)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
SUFFIXES = {".h", ".cc"}


def includes_of(path):
    """Pairs (line number, bracket, included name) of a file."""
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, start=1):
            match = INCLUDE.match(line)
            if match:
                yield number, match.group(1), match.group(2)


def room_files(root):
    """Triples (room, path, "room/x.cc") of all files that the rules are about."""
    for top in (root / "include" / "pellicle", root / "source"):
        for room in ROOMS:
            for path in sorted((top / room).rglob("*")):
                if path.suffix in SUFFIXES:
                    yield room, path, path.relative_to(top).as_posix()


def way_to_heavy_header(root, name, seen):
    """Names of the headers from our header `name` to a heavy one, or None."""
    path = root / "include" / name
    if name in seen or not path.is_file():
        return None
    seen.add(name)
    for _, _, included in includes_of(path):
        if HEAVY_HEADER.match(included):
            return [name, included]
        way = way_to_heavy_header(root, included, seen)
        if way:
            return [name] + way
    return None


def breaches_of_include(root, room, path, in_room, bracket, included):
    """Messages about one include of the file `path`, within its room `in_room` ("room/x.cc")."""
    light = room in POINT_ROOMS and not SCENE_FILE.match(in_room)
    if light and HEAVY_HEADER.match(included):
        yield f"'{room}' knows no mesh and no MPI: it must not include <{included}>"
    if bracket == '"' and ("/" in included or not (path.parent / included).is_file()):
        yield f'write <pellicle/room/x.h> instead of "{included}"'
    if not included.startswith("pellicle/"):
        return
    other = included.split("/")[1]
    if other not in ROOMS:
        yield f"<{included}>: there is no room '{other}'; rooms are {', '.join(ROOMS)}"
    elif not (root / "include" / included).is_file():
        yield f"<{included}> does not exist"
    elif ROOMS.index(other) > ROOMS.index(room):
        yield f"'{room}' must not include '{other}', which is to the right of it: {' <- '.join(ROOMS)}"
    elif light:
        way = way_to_heavy_header(root, included, set())
        if way:
            yield f"'{room}' knows no mesh and no MPI, but this leads there: {' -> '.join(way)}"


def breaches(root):
    """All messages, as file:line: text."""
    root = Path(root)
    for room, path, in_room in room_files(root):
        for number, bracket, included in includes_of(path):
            for message in breaches_of_include(root, room, path, in_room, bracket, included):
                yield f"{path.relative_to(root)}:{number}: {message}"


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    n_files = sum(1 for _ in room_files(root))
    if n_files == 0:
        sys.exit(f"{root}: no sources in include/pellicle/<room> and source/<room>")
    found = list(breaches(root))
    for line in found:
        print(line)
    print(f"{n_files} files, {len(found)} forbidden includes")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
