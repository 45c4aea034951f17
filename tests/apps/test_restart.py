# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of all kinds that go on from each of their checkpoints: to the last bit what they would have been without a break."""

from restart_runs import KEEP_ALL, RestartTest, check_all_files_are_whole, what_counts

AXIAL = ("Mesh/Symmetry=axial", "Mesh/Refinements=2")


class LoadPaths(RestartTest):
    def test_vesicle(self):
        """Down to a shape that is found in steps of different lengths, with the count of unstable modes."""
        run = self.check_goes_on(("vesicle", "prolate.prm"), *AXIAL, "Analyses=stability", "Load/Parameter=Vesicle/Reduced volume",
                                 "Load/To=0.7", "Load/Steps=6")
        self.assertEqual([row["step"] for row in run.table("history.csv")], ["0", "1", "2", "3", "4"])
        check_all_files_are_whole(self, run.directory)

    def test_vesicle_in_space(self):
        """Nodes moved at random at the start, reactions of rigid motions."""
        self.check_goes_on(("vesicle", "prolate.prm"), "Mesh/Refinements=1", "Mesh/Degree=2", "Vesicle/Node noise=0.05",
                           "Load/Parameter=Vesicle/Reduced volume", "Load/To=0.86", "Load/Steps=3", steps=(1, 2))

    def test_hysteresis(self):
        """A line that advances with a growing drop, sticks, and recedes with a shrinking one remembers where it was."""
        run = self.check_goes_on(("droplet_contact", "sessile.prm"), *AXIAL, "Effects=liquid surface, volume constraint, wetting, line pinning",
                                 "Droplet/Contact angle=90", "Line pinning/Advancing angle=100", "Line pinning/Receding angle=80",
                                 "Load/Parameter=Droplet/Volume", "Load/From=2", "Load/To=3", "Load/Steps=6")
        radii = [float(row["contact_radius"]) for row in run.table("history.csv")]
        self.assertEqual(radii[0], radii[1])
        self.assertGreater(radii[-1], radii[0])

    def test_inclined_drop(self):
        """Parts of the line advance and stick."""
        self.check_goes_on(("droplet_contact", "inclined.prm"), "Mesh/Refinements=1", "Mesh/Degree=2", "Droplet/Inclination=40",
                           "Load/Steps=4", steps=(2, 3))

    def test_squeezed_drop(self):
        """Nodes come into contact with two plates, one after the other."""
        run = self.check_goes_on(("droplet_contact", "squeezed.prm"), *AXIAL, "Effects=liquid surface, volume constraint, contact",
                                 "Droplet/Base=membrane", "Droplet/Contact angle=180", "Load/Parameter=Substrate/Plate distance",
                                 "Load/To=0.6", "Load/Steps=3", steps=(1, 2))
        areas = [float(row["solid_liquid_area"]) for row in run.table("history.csv")]
        self.assertGreater(areas[-1], 1.2 * areas[0])

    def test_ridge(self):
        """Stages of a load path, and a line that slips over the material."""
        self.check_goes_on(("wetting_ridge", "unpinned.prm"), "Mesh/Degree=2", "Mesh/Refinements=1", "Contact line/Cell size=0.03",
                           "Load/Steps=3", "Free contact line/Advancing threshold=0.002", "Free contact line/Receding threshold=0.002")

    def test_volume_after_the_stages(self):
        self.check_goes_on(("wetting_ridge", "pinned_axial.prm"), "Mesh/Degree=2", "Mesh/Refinements=1", "Contact line/Cell size=0.03",
                           "Load/Steps=2", "Load/Parameter=Droplet/Volume", "Load/To=2.1")


class Motions(RestartTest):
    SCENE = ("director_membrane", "relaxation.prm")

    def test_minimising_steps(self):
        self.check_goes_on(self.SCENE, "Time/Integrator=minimising", "Time/Step=0.2", "Time/Output every=2")

    def test_integrator(self):
        """It begins anew, with other steps: within its tolerances, here 1e-6 of each component."""
        run = self.start(self.SCENE, "Time/Step=0.25", "Checkpoint/Every=2", name="straight")
        later = self.restart(self.copy_at(run, 2))
        self.assertEqual(later.status, 0, later.stderr)
        straight, again = run.table("history.csv"), later.table("history.csv")
        self.assertEqual([row["time"] for row in again], [row["time"] for row in straight])
        self.assertEqual(again[:3], straight[:3])
        for before, after in zip(straight[3:], again[3:]):
            self.assertNotEqual(before, after)
            for name in ("tilt_energy", "director_gradient_energy", "total_energy", "dissipation"):
                self.assert_within(float(after[name]), float(before[name]), 1e-4)
        self.assertLess(abs(later.quantities["energy_balance_error"]), 1e-4)


class Branches(RestartTest):
    def test_through_a_fold(self):
        """Points before, at and behind it."""
        run = self.check_goes_on(("vesicle", "tether.prm"), "Tether/Control=force", "Tether/Force=6.5", "Load/Parameter=", "Load/From=",
                                 "Continuation/Parameter=Tether/Force", "Continuation/Lower=0", "Continuation/Upper=9",
                                 "Continuation/Scale=1", "Continuation/Maximum points=9", "Continuation/First step=0.3", steps=(2, 7, 8))
        self.assertEqual([row["is_fold"] for row in run.table("branch.csv")], 7 * ["0"] + ["1", "0"])

    def test_onto_a_crossing_branch(self):
        """Before and after the switch at a bifurcation: oblates are left for shapes without their mirror plane."""
        run = self.check_goes_on(("vesicle", "discocyte.prm"), *AXIAL, "Analyses=stability", "Continuation/Parameter=Vesicle/Reduced volume",
                                 "Continuation/Direction=decreasing", "Continuation/Lower=0.4", "Continuation/Maximum points=5",
                                 "Continuation/At bifurcation=switch", steps=(2, 4, 6))
        self.assertEqual([row["point"] for row in run.table("branch.csv") if row["arc_length"] == "0"], ["0", "4"])


class SameTwice(RestartTest):
    def test_threads(self):
        """A number of threads that is fixed fixes all digits."""
        for threads in (1, 2):
            runs = [self.start(("vesicle", "prolate.prm"), f"Newton/Threads={threads}", name=f"threads{threads}_{n}") for n in (1, 2)]
            self.assertEqual(runs[0].status, 0, runs[0].stderr)
            self.assert_same(*(what_counts(run.directory) for run in runs))


class Processes(RestartTest):
    def test_two_processes(self):
        """To round-off: with two, and when one goes on for two."""
        two = {"launcher": ["mpirun", "--oversubscribe", "-np", "2"]}
        arguments = ("Mesh/Refinements=1", "Mesh/Degree=2", "Droplet/Inclination=40", "Load/Steps=4", "Output/Solution=false")
        run = self.start(("droplet_contact", "inclined.prm"), *arguments, *KEEP_ALL, name="two", **two)
        self.assertEqual(run.status, 0, run.stderr)
        for step, how in ((2, two), (3, {})):
            later = self.restart(self.copy_at(run, step), **how)
            self.assertEqual(later.status, 0, later.stderr)
            self.assertEqual(later.summary["warnings"], run.summary["warnings"])
            for name, value in run.quantities.items():
                self.assertAlmostEqual(later.quantities[name], value, delta=1e-8 * (1 + abs(value)), msg=name)
