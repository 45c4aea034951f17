# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which measurements are worth their time."""


def front(measurements):
    """Those that are more accurate than all that were as fast or faster, by ascending seconds."""
    best, chosen = float("inf"), []
    for m in sorted(measurements, key=lambda m: (m.seconds, m.error)):
        if m.error < best:
            best = m.error
            chosen.append(m)
    return chosen


def by_kind(measurements):
    """The measurements of each kind of mesh: a meridian is no rival of a surface in space, which can do more."""
    return {kind: [m for m in measurements if m.kind == kind] for kind in dict.fromkeys(m.kind for m in measurements)}


def reliable(measurements, target):
    """Those that meet a target, as do all finer ones of their line.

    Errors of coarse meshes change their sign and may vanish by accident; such a mesh is no recommendation. Lines are given from coarse to fine.
    """
    chosen = []
    for line in dict.fromkeys(m.line for m in measurements):
        for m in reversed([m for m in measurements if m.line == line]):
            if m.error > target:
                break
            chosen.append(m)
    return chosen


def recommended(measurements, target):
    """The fastest of the reliable ones; None if nothing meets the target."""
    return min(reliable(measurements, target), key=lambda m: m.seconds, default=None)
