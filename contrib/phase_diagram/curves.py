# SPDX-License-Identifier: LGPL-2.1-or-later
"""Energies of branches between their states: cubic Hermite pieces, their stability, and where two branches cross."""

import math
from dataclasses import dataclass
from itertools import combinations, groupby

from states import State

STABLE, UNSTABLE, UNKNOWN = "stable", "unstable", "stability not computed"

# Where the energies of two branches meet with equal pressures (relative difference), they are the same shape: one
# branch has split off the other, and no transition between different shapes takes place.
SAME_PRESSURE = 1e-3
ROUND_OFF = 1e-9  # relative, of energies and reduced volumes of states that were computed twice


@dataclass(frozen=True)
class Piece:
    """A branch between consecutive states of different reduced volume; fourth order, since the slopes are known."""

    begin: State
    end: State

    @property
    def low(self):
        return min(self.begin.volume, self.end.volume)

    @property
    def high(self):
        return max(self.begin.volume, self.end.volume)

    def energy(self, volume):
        """Exactly a state's own energy at its reduced volume, so that neighbours agree on signs there."""
        a, b, h = self.begin, self.end, self.end.volume - self.begin.volume
        t = (volume - a.volume) / h
        u = 1 - t
        return u * u * ((1 + 2 * t) * a.energy + t * h * a.slope) + t * t * ((1 + 2 * u) * b.energy - u * h * b.slope)

    def slope(self, volume):
        a, b, h = self.begin, self.end, self.end.volume - self.begin.volume
        t = (volume - a.volume) / h
        u = 1 - t
        return 6 * t * u * (b.energy - a.energy) / h + u * (1 - 3 * t) * a.slope + t * (1 - 3 * u) * b.slope

    @property
    def stability(self):
        """That of the worse end. At a fold an eigenvalue is zero and its sign chance, so the other end decides."""
        counts = [s.unstable_modes for s in (self.begin, self.end) if not s.is_fold] or [None]
        if any(counts):
            return UNSTABLE
        return UNKNOWN if None in counts else STABLE


def pieces(states):
    return [Piece(a, b) for a, b in zip(states, states[1:]) if a.volume != b.volume]


def lines(states):
    """(stability, pieces) of the longest stretches of one stability, along the branch."""
    return [(stability, list(stretch)) for stability, stretch in groupby(pieces(states), lambda p: p.stability)]


def roots(value, slope, low, high):
    """Where the cubic changes its sign in [low, high]; zero counts as positive. Both functions are of x."""
    h = high - low
    d0, d1, m0, m1 = value(low), value(high), h * slope(low), h * slope(high)
    # Extrema: zeros of c[2] t^2 + c[1] t + c[0] in (0, 1), in the form that does not cancel.
    c = (m0, 6 * (d1 - d0) - 4 * m0 - 2 * m1, 6 * (d0 - d1) + 3 * (m0 + m1))
    knots = [low, high]
    discriminant = c[1] ** 2 - 4 * c[2] * c[0]
    if discriminant > 0:
        q = -(c[1] + math.copysign(math.sqrt(discriminant), c[1])) / 2
        candidates = [a / b for a, b in ((q, c[2]), (c[0], q)) if b != 0]
        knots += [low + t * h for t in candidates if 0 < t < 1]
    knots.sort()
    return [bisect(value, a, b) for a, b in zip(knots, knots[1:]) if (value(a) >= 0) != (value(b) >= 0)]


def bisect(value, a, b):
    """Where the sign changes between a and b, to the last digit."""
    positive_at_a = value(a) >= 0
    while True:
        middle = (a + b) / 2
        if middle in (a, b):  # no number is left between them
            return middle
        if (value(middle) >= 0) == positive_at_a:
            a = middle
        else:
            b = middle


@dataclass(frozen=True)
class Crossing:
    branch_a: str
    branch_b: str
    volume: float  # reduced
    energy: float  # over 8 pi kappa


def is_lowest(candidates, volume, energy):
    """Whether no candidate (pieces of one branch) has less energy at this reduced volume."""
    return all(p.energy(volume) >= energy - ROUND_OFF * abs(energy) for p in candidates if p.low <= volume <= p.high)


def crossings_of_two(states_a, states_b):
    """(reduced volume, energy) where the lowest sheets of two branches cross, unstable pieces left out."""
    candidates_a, candidates_b = ([p for p in pieces(s) if p.stability != UNSTABLE] for s in (states_a, states_b))
    found = []
    for a in candidates_a:
        for b in candidates_b:
            low, high = max(a.low, b.low), min(a.high, b.high)
            if low >= high:
                continue
            for v in roots(lambda x: a.energy(x) - b.energy(x), lambda x: a.slope(x) - b.slope(x), low, high):
                energy, slopes = a.energy(v), (a.slope(v), b.slope(v))
                if (abs(slopes[0] - slopes[1]) > SAME_PRESSURE * max(map(abs, slopes))
                        and is_lowest(candidates_a, v, energy) and is_lowest(candidates_b, v, energy)
                        and all(abs(v - other) > ROUND_OFF * v for other, _ in found)):
                    found.append((v, energy))
    return sorted(found)


def crossings(branches):
    """All crossings of all pairs of branches (name -> states)."""
    return [Crossing(a, b, *place) for a, b in combinations(branches, 2)
            for place in crossings_of_two(branches[a], branches[b])]
