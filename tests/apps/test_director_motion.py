# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directors that move in time: what the files say, both integrators, and a user's mistakes."""

import math

from director_program import SCENES, DirectorTest, settings

SCENE = SCENES / "relaxation.prm"
MINIMISING = "Time/Integrator=minimising"

CASES = [
    (["Director/Tilt modulus=inf"], ["Tilt modulus = inf", "index 2", "minimising"]),
    (["Time/End time=0", "Time/Step=0"], ["director friction", "End time"]),
    (["Time/End time=0"], ["Time/Step = 0.1", "End time"]),
    (["Time/Step=2"], ["Time/Step = 2", "longer"]),
    (["Time/Integrator=euler"], ["euler", "minimising", "ida"]),
    (["Surface/Motion=free"], ["material points", "Hold the surface"]),
    (["Load/Parameter=Director/Tilt modulus", "Load/To=4"], ["Load/Parameter", "Time/End time"]),
    (["Analyses=stability"], ["Analyses", "Time/End time"]),
    (["Director friction/Friction=0"], ["Friction", "a number > 0"]),
    (["Director friction/Frame=body"], ["body", "lab", "objective"]),
]


class Motions(DirectorTest):
    def columns(self, run, *names):
        return [[float(row[name]) for row in run.table("history.csv")] for name in names]

    def check_books(self, run, end=1.0):
        """Energy falls as time goes on to its end, and something is dissipated all the while."""
        times, energies, powers = self.columns(run, "time", "total_energy", "dissipation")
        self.assertEqual(times[0], 0.0)
        self.assertEqual(times[-1], end)
        for before, after in zip(energies, energies[1:]):
            self.assertLess(after, before)
        self.assertGreater(min(powers), 0)
        self.assertEqual(run.quantities["dissipation"], powers[-1])

    def test_shipped_scene(self):
        run = self.solve(SCENE)
        self.check_books(run)
        energies, powers = self.columns(run, "tilt_energy", "dissipation")
        self.assertEqual(len(energies), 11)
        self.assert_within(energies[-1] / energies[0], math.exp(-4), 1e-3)
        # Of the mode, E = (k_t/2) |O_tan|^2 and 2D = eta |O_t|^2 = k_t^2/eta |O_tan|^2.
        for energy, power in list(zip(energies, powers))[2:]:  # what nodes and cells make of the start has gone by then
            self.assert_within(power, 4 * energy, 1e-3)
        self.assertLess(abs(run.quantities["energy_balance_error"]), 1e-3)
        self.assertEqual(run.summary["warnings"], [])
        self.assertEqual(run.summary["newton"]["steps"], 10)
        self.assertIn("solution_0010.vtu", run.files)

    def test_minimising_steps(self):
        errors = []
        for n, every in ((10, 5), (20, 100)):
            run = self.solve(SCENE, MINIMISING, f"Time/Step={1 / n}", f"Time/Output every={every}", name=f"steps{n}")
            self.check_books(run)
            energies, = self.columns(run, "tilt_energy")
            self.assert_within(energies[-1] / energies[0], (1 + 2 / n) ** (-2 * n), 1e-3)
            errors.append(run.quantities["energy_balance_error"])
            self.assertEqual([f for f in run.files if f.startswith("solution_0")],
                             [f"solution_{i:04}.vtu" for i in (range(0, n + 1, every) if every <= n else (0, n))])
        self.assertLess(errors[0], 0)
        self.assert_within(errors[0] / errors[1], 2, 0.15)

    def test_far_start_in_space_with_noise(self):
        run = self.solve(SCENE, MINIMISING, "Mesh/Symmetry=none", "Mesh/Refinements=0", "Director field/Angle=1.5", "Director field/Noise=0.05")
        self.check_books(run)
        both = self.solve(SCENE, "Mesh/Symmetry=none", "Mesh/Refinements=0", "Director field/Angle=1.5", "Director friction/Frame=lab", name="ida")
        self.check_books(both)

    def test_infinite_tilt_modulus(self):
        run = self.solve(SCENE, MINIMISING, "Director/Tilt modulus=inf", "Director field/Angle=0", "Time/Step=0.5")
        self.assert_within(run.quantities["total_energy"], 4 * math.pi, 1e-4)

    def test_two_processes(self):
        for integrator in ("ida", "minimising"):
            one, two = (self.solve(SCENE, f"Time/Integrator={integrator}", "Time/Step=0.5", name=f"{integrator}{n}",
                                   **({} if n == 1 else {"launcher": ("mpirun", "--oversubscribe", "-np", "2")})) for n in (1, 2))
            self.assert_within(two.quantities["tilt_energy"], one.quantities["tilt_energy"], 1e-5)


# A sphere with a skin that keeps its material points together, free to move.
FREE = """
set Effects = director, director friction, skalak skin, volume constraint
subsection Mesh
  set Symmetry    = axial
  set Refinements = 1
end
subsection Vesicle
  set Area           = 4*pi
  set Reduced volume = 1
  set Start shape    = ellipsoid
  set Semi axes      = 1, 1, 1
end
subsection Director field
  set Start = towards z
  set Angle = 0.5
end
subsection Director
  set Tilt modulus = 2
end
subsection Time
  set End time = 0.5
  set Step     = 0.1
end
"""


class FreeMotions(DirectorTest):
    def test_elastic_membrane(self):
        """Against the lab directors drag the skin with them, against the membrane hardly at all."""
        scene, skins = self.write("scene.prm", FREE), {}
        for frame in ("lab", "objective"):
            run = self.solve(scene, f"Director friction/Frame={frame}", name=frame)
            skins[frame] = run.quantities["skalak_skin_energy"]
            rows = run.table("history.csv")
            energies = [float(row["total_energy"]) for row in rows]
            self.assertEqual(energies, sorted(energies, reverse=True))
            self.assertLessEqual(run.summary["newton"]["iterations"], 8 * run.summary["newton"]["steps"])
            self.assertLess(run.quantities["energy_balance_error"], 0)
        self.assertGreater(skins["lab"], 100 * skins["objective"])
        self.assertGreater(skins["objective"], 0)
        ida = self.call(scene, *settings("Time/Integrator=ida"), "--output-directory", self.folder / "ida")
        self.assert_clear_refusal(ida, self.folder / "ida", ["Time/Integrator = ida", "held", "minimising"])


class Refusals(DirectorTest):
    def test_time_without_friction(self):
        scene = self.write("scene.prm", "set Effects = director\nsubsection Time\n  set End time = 1\nend\n")
        directory = self.folder / "run"
        self.assert_clear_refusal(self.call(scene, "--output-directory", directory), directory, ["how fast", "'director friction'"])

    def test_mistakes(self):
        self.assert_refusals(SCENE, CASES)
