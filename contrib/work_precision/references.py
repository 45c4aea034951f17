# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the runs are compared with: closed forms, quadrature, and numbers of independent computations."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Reference:
    """A value, how well it is known (relative) and where it is from."""

    value: float
    accuracy: float
    source: str

    def error(self, value):
        """Relative error of a value; never smaller than what the reference itself may be off."""
        return max(abs(value / self.value - 1.0), self.accuracy)


ROUND_OFF = 1e-14


def bending_energy_of_revolution(meridian, points=200):
    """Integral of (2H)^2/2 over a surface of revolution, kappa = 1, by Gauss quadrature in p from pole to pole.

    `meridian(p)` gives r, z and their first and second derivatives with respect to p in [0, pi].
    """
    nodes, weights = np.polynomial.legendre.leggauss(points)
    p, dp = 0.5 * np.pi * (nodes + 1.0), 0.5 * np.pi * weights
    r, dr, ddr, dz, ddz = meridian(p)
    speed = np.hypot(dr, dz)
    twice_mean = (dr * ddz - dz * ddr) / speed**3 + dz / (r * speed)
    return float(np.sum(dp * np.pi * twice_mean**2 * r * speed))


def spheroid(equatorial, polar):
    """Meridian of a spheroid."""

    def meridian(p):
        s, c = np.sin(p), np.cos(p)
        return equatorial * s, equatorial * c, -equatorial * s, -polar * s, -polar * c

    return meridian


def biconcave(p):
    """Meridian (sin p, h(sin^2 p) cos p), h(t) = (.2484 + 1.6024 t - .8984 t^2)/2: the resting red cell of Evans and Fung, radius 1."""
    s, c = np.sin(p), np.cos(p)
    t, dt, ddt = s**2, 2 * s * c, 2 * (c**2 - s**2)
    h, h1, h2 = 0.1242 + 0.8012 * t - 0.4492 * t**2, 0.8012 - 0.8984 * t, -0.8984
    dh, ddh = h1 * dt, h2 * dt**2 + h1 * ddt
    return s, c, -s, dh * c - h * s, ddh * c - 2 * dh * s - h * c


def energy_of_cap(angle, volume):
    """Energy gamma (A_lg - cos(theta) A_sl), gamma = 1, of a drop without weight on a plane; angle in degrees."""
    c = np.cos(np.radians(angle))
    radius = np.cbrt(3 * volume / (np.pi * (1 - c) ** 2 * (2 + c)))
    return float(np.pi * radius**2 * (2 * (1 - c) - c * (1 - c**2)))


def energy_of_directors_on_torus(tilt_modulus, modes=64):
    """Least energy of directors without azimuthal part on Clifford's torus r = 1, R = sqrt(2), K = 1.

    O makes the angle u + a(u) with the radial direction, u that of the normal, so that

        E = 2 pi int [ ((1 + a')^2 + cos^2(u + a)/rho^2)/2 + (k_t/2) sin^2 a ] rho du,   rho = sqrt(2) + cos u.

    The trapezoidal rule at `modes` points and trigonometric differentiation converge exponentially; Newton's method finds a.
    """
    n = modes
    u = 2 * np.pi * np.arange(n) / n
    rho = np.sqrt(2.0) + np.cos(u)
    difference = np.arange(n)[:, None] - np.arange(n)[None, :]
    with np.errstate(divide="ignore"):
        D = np.where(difference == 0, 0.0, 0.5 * (-1.0) ** difference / np.tan(np.pi * difference / n + (difference == 0)))
    a = np.zeros(n)
    for _ in range(30):
        stretch, b = 1 + D @ a, u + a
        gradient = D.T @ (rho * stretch) - np.sin(2 * b) / (2 * rho) + 0.5 * tilt_modulus * rho * np.sin(2 * a)
        hessian = D.T @ (rho[:, None] * D) + np.diag(-np.cos(2 * b) / rho + tilt_modulus * rho * np.cos(2 * a))
        step = np.linalg.solve(hessian, -gradient)
        a = a + step
        if np.max(np.abs(step)) < 1e-14:
            break
    density = 0.5 * (rho * (1 + D @ a) ** 2 + np.cos(u + a) ** 2 / rho) + 0.5 * tilt_modulus * rho * np.sin(a) ** 2
    return float(2 * np.pi * (2 * np.pi / n) * np.sum(density))
