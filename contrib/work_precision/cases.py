# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of the study, as objects in a list: a scene, what is looked at, the reference, and the settings that are run."""

from dataclasses import dataclass, field

import numpy as np

import references as ref


@dataclass(frozen=True)
class Setting:
    """One way of asking for accuracy. Settings of one line belong together in plot and recommendation, coarse to fine."""

    line: str
    name: str
    overrides: tuple
    needs: tuple = ()  # texts that --write-parameters must show, lest the program does not offer it


@dataclass(frozen=True)
class Case:
    """A problem with a known answer. `given`: only the start shape is evaluated (--validate), nothing is solved."""

    name: str
    title: str
    program: str
    quantity: str
    reference: ref.Reference
    settings: tuple
    scene: str = ""  # of prm/; without one `text` is the scene
    text: str = ""
    overrides: tuple = ()
    given: bool = False
    quick: tuple = ()  # names of the settings of a quick study
    evolver: str = ""  # name of the same problem in evolver.py
    notes: str = field(default="", compare=False)


def mesh(symmetry, degree, refinements):
    """Degree and refinements of a mesh in space ('none'), of a symmetric part of it, or of a meridian."""
    where = {"none": "3-D"}.get(symmetry, symmetry)
    needs = () if symmetry in ("none", "axial") else (f"'{symmetry}'",)
    overrides = (f"Mesh/Symmetry={symmetry}", f"Mesh/Degree={degree}", f"Mesh/Refinements={refinements}")
    return Setting(f"{where}, degree {degree}", f"{where} k{degree} r{refinements}", overrides, needs)


def meshes(symmetry, ranges):
    """Settings of a dictionary degree -> refinements."""
    return tuple(mesh(symmetry, degree, r) for degree, refinements in ranges.items() for r in refinements)


def targets(symmetry, wanted):
    """Settings that ask for an accuracy and leave the mesh to the program."""
    where = {"none": "3-D"}.get(symmetry, symmetry)
    needs = ("subsection Accuracy",) + (() if symmetry in ("none", "axial") else (f"'{symmetry}'",))
    return tuple(
        Setting(f"{where}, Accuracy/Target", f"{where} target {t}", (f"Mesh/Symmetry={symmetry}", f"Accuracy/Target={t}"), needs) for t in wanted
    )


def given_shape(name, title, shape, value, settings):
    """Bending energy of a start shape."""
    text = f"set Effects = helfrich bending\nsubsection Vesicle\n{shape}end\n"
    reference = ref.Reference(value / (8 * np.pi), 1e-13, "closed form" if name == "sphere" else "Gauss quadrature of the meridian")
    return Case(name, title, "vesicle", "bending_energy_over_8_pi_kappa", reference, settings, text=text, given=True,
                quick=("axial k3 r1", "axial k3 r3"), evolver=name)


SHAPE_MESHES = meshes("none", {2: (1, 2, 3), 3: (1, 2), 4: (0, 1, 2), 5: (0, 1)}) + meshes("axial", {2: (2, 4), 3: (1, 3), 4: (1, 2)})
VESICLE_MESHES = (
    meshes("none", {2: (1, 2, 3), 3: (0, 1, 2), 4: (0, 1, 2), 5: (0, 1, 2)})
    + meshes("octant", {2: (2, 3), 3: (1, 2, 3), 4: (1, 2), 5: (1, 2)})
    + meshes("axial", {2: (2, 4), 3: (1, 2, 3), 4: (1, 2), 5: (1, 2)})
)
DROP_MESHES = (
    meshes("none", {2: (0, 1, 2), 3: (0, 1), 4: (0, 1), 5: (0, 1)})
    + meshes("quarter", {2: (0, 1, 2), 3: (0, 1), 4: (0, 1), 5: (0, 1)})
    + meshes("axial", {2: (0, 2), 3: (0, 1, 2), 4: (0, 1), 5: (0, 1)})
)
VESICLE_TARGETS = targets("none", (1e-3, 1e-5)) + targets("octant", (1e-5, 1e-7)) + targets("axial", (1e-5, 1e-9))
AXISYMMETRIC = "independent axisymmetric spectral computation, 10 digits"


def equilibrium(name, title, scene, value, **more):
    """A vesicle's energy."""
    return Case(name, title, "vesicle", "bending_energy_over_8_pi_kappa", ref.Reference(value, 5e-11, AXISYMMETRIC), VESICLE_MESHES + VESICLE_TARGETS,
                scene=scene, quick=("3-D k3 r0", "3-D k3 r1", "axial k3 r1", "axial k3 r2"), **more)


def drop(angle):
    """A drop without weight: total energy of a cap."""
    return Case(f"sessile{angle}", f"Drop on a plane, {angle} degrees: energy", "droplet_contact", "total_energy",
                ref.Reference(ref.energy_of_cap(angle, 2 * np.pi / 3), 1e-14, "closed form"),
                DROP_MESHES + targets("none", (1e-5, 1e-9)) + targets("quarter", (1e-9,)) + targets("axial", (1e-9,)), scene="droplet_contact/sessile.prm",
                overrides=(f"Droplet/Contact angle={angle}",), quick=("axial k3 r0", "axial k3 r1"), evolver=f"sessile{angle}")


def ridge_cells(degree, sizes):
    """Settings of a ridge: cell sizes at the line."""
    return tuple(Setting(f"axial, degree {degree}", f"axial k{degree} h{h}", (f"Mesh/Degree={degree}", f"Contact line/Cell size={h}")) for h in sizes)


CASES = (
    given_shape("sphere", "Sphere: bending energy of the start shape", "  set Start shape = ellipsoid\n  set Semi axes = 1, 1, 1\n", 8 * np.pi, SHAPE_MESHES),
    given_shape("ellipsoid", "Spheroid .5 : .5 : 1: bending energy of the start shape", "  set Start shape = ellipsoid\n  set Semi axes = 0.5, 0.5, 1\n",
                ref.bending_energy_of_revolution(ref.spheroid(0.5, 1.0)), SHAPE_MESHES),
    given_shape("biconcave", "Biconcave red cell: bending energy of the start shape", "  set Start shape = biconcave\n",
                ref.bending_energy_of_revolution(ref.biconcave), SHAPE_MESHES),
    equilibrium("prolate", "Prolate vesicle, v = .9: bending energy", "vesicle/prolate.prm", 1.1896440328, evolver="prolate"),
    equilibrium("discocyte", "Discocyte, v = .65: bending energy", "vesicle/discocyte.prm", 1.8262334456, evolver="discocyte"),
    drop(60),
    drop(120),
    Case("ridge", "Ridge under a free contact line: radius of the line", "wetting_ridge", "ridge_radius",
         ref.Reference(1.004357, 5e-7, "independent axisymmetric elements on fan meshes down to 1.5e-6 at the line"),
         ridge_cells(2, (0.04, 0.02, 0.01, 0.005)) + ridge_cells(3, (0.04, 0.02, 0.01, 0.005)) + ridge_cells(4, (0.04, 0.02)),
         scene="wetting_ridge/unpinned.prm", overrides=("Substrate/Lateral faces=sliding", "Mesh/Refinements=1"), quick=("axial k2 h0.04", "axial k2 h0.01"),
         notes="The solution is singular at the line: errors fall with the cell size there, hardly with the degree."),
    Case("torus", "Directors on Clifford's torus, k_t = 100: energy", "director_membrane", "total_energy",
         ref.Reference(ref.energy_of_directors_on_torus(100.0), 1e-13, "trigonometric collocation of the meridian's equation"),
         meshes("none", {2: (1, 2, 3), 3: (0, 1, 2), 4: (0, 1), 5: (0, 1)}) + targets("none", (1e-5,)), scene="director_membrane/torus_tilt_limit.prm",
         quick=("3-D k3 r0", "3-D k3 r1"), notes="A torus has no meridian from pole to pole: in space only."),
)
