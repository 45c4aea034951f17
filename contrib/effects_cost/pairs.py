# SPDX-License-Identifier: LGPL-2.1-or-later
"""For every effect of every application a scene with it and, where there can be one, the same scene without it."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Pair:
    """Effects of the two scenes (`without` empty: there is no scene without it), parameters of both, and those of the scene with the effect alone."""

    application: str
    effect: str
    beside: tuple
    common: tuple = ()
    own: tuple = ()
    instead: tuple = ()  # listed in the scene without the effect only
    application_without: str = ""  # if the scene without it is another application's
    alone: bool = True  # whether there is a scene without it
    note: str = ""

    @property
    def with_it(self):
        return (*self.beside, self.effect)

    @property
    def without_it(self):
        return (*self.beside, *self.instead)


BENDING, AREA, VOLUME = "helfrich bending", "area constraint", "volume constraint"
SPACE = ("Mesh/Degree=3", "Mesh/Refinements=1")
CAP = (*SPACE, "Vesicle/Start shape=cap", "Vesicle/Rim=hinged")
OTHER_MESH = "a mesh of its own"


def vesicle(effect, beside, common=SPACE, **more):
    return Pair("vesicle", effect, beside, common, **more)


def droplet(effect, beside, common=(*SPACE, "Droplet/Contact angle=60"), **more):
    return Pair("droplet_contact", effect, beside, common, **more)


def ridge(effect, beside, **more):
    return Pair("wetting_ridge", effect, beside, ("Mesh/Degree=2", "Mesh/Refinements=1", "Contact line/Cell size=0.04", "Substrate/Lateral faces=sliding"), **more)


def director(effect, beside, common=SPACE, **more):
    return Pair("director_membrane", effect, beside, common, **more)


VESICLE_PAIRS = (
    vesicle(BENDING, ("surface tension", VOLUME)),
    vesicle(AREA, (BENDING, VOLUME)),
    vesicle(VOLUME, (BENDING, AREA)),
    vesicle("bilayer coupling", (BENDING, AREA, VOLUME), own=("Bilayer coupling/Integrated mean curvature=13.25",)),
    vesicle("area difference elasticity", (BENDING, AREA, VOLUME), own=("Area difference elasticity/Integrated mean curvature=13.25",)),
    vesicle("gaussian curvature", (BENDING, AREA), CAP),
    vesicle("line tension", (BENDING, "lipid domain", AREA, VOLUME), ("Mesh/Symmetry=axial", "Mesh/Degree=3", "Mesh/Refinements=3", "Vesicle/Start shape=ellipsoid", "Vesicle/Semi axes=1, 1, 1.3")),
    vesicle("lipid domain", (BENDING, AREA, VOLUME), ("Mesh/Symmetry=axial", "Mesh/Degree=3", "Mesh/Refinements=3"), note=OTHER_MESH),
    vesicle("tether", (BENDING,), ("Mesh/Symmetry=axial", "Mesh/Degree=3", "Mesh/Refinements=3"), own=("Tether/Length=2",), note=OTHER_MESH),
    vesicle("surface tension", (BENDING, VOLUME)),
    vesicle("pressure", (BENDING, AREA)),
    *(vesicle(skin, (BENDING, VOLUME)) for skin in ("neo-hookean skin", "incompressible rubber skin", "skalak skin", "tu-ou-yang skin")),
)

DROP, MEMBRANE = ("liquid surface", VOLUME, "wetting"), (*SPACE, "Droplet/Base=membrane", "Droplet/Contact angle=180")
# A drop under a prescribed pressure is a saddle, which the other charts do not look for.
SADDLE = (*SPACE, "Droplet/Contact angle=60", "Newton/Chart=ale")
DROPLET_PAIRS = (
    droplet("liquid surface", ("neo-hookean skin", VOLUME, "contact"), (*MEMBRANE, "Substrate/Plate distance=1.5")),
    droplet(VOLUME, ("liquid surface", "wetting"), SADDLE, instead=("pressure",)),
    droplet("wetting", ("liquid surface", VOLUME), alone=False),
    droplet("gravity", DROP, own=("Droplet/Bond number=0.5",)),
    droplet("contact", ("liquid surface", VOLUME), MEMBRANE, alone=False),
    droplet("line pinning", DROP),
    droplet("line tension", DROP, own=("Line tension/Line tension=0.05",)),
    droplet("pressure", ("liquid surface", "wetting"), SADDLE, instead=(VOLUME,)),
    *(droplet(skin, ("liquid surface", VOLUME, "contact"), (*MEMBRANE, "Substrate/Plate distance=1.5")) for skin in ("neo-hookean skin", "incompressible rubber skin")),
)

RIDGE = ("liquid surface", VOLUME, "solid", "solid skins")


def rest(all_of_them, effect):
    return tuple(e for e in all_of_them if e != effect)


RIDGE_PAIRS = (
    *(ridge(effect, rest(RIDGE, effect), alone=False) for effect in RIDGE),
    ridge("free contact line", RIDGE, own=("Contact line/Motion=free", "Free contact line/Advancing threshold=0.001", "Free contact line/Receding threshold=0.001")),
    ridge("gravity", RIDGE, own=("Droplet/Body force=0.1",)),
    ridge("line tension", RIDGE, own=("Line tension/Line tension=0.001",)),
)

SHELL = (*SPACE, "Shell/Shape=hemisphere", "Newton/Maximum iterations=6")
DIRECTOR_PAIRS = (
    director("director", (BENDING, AREA, VOLUME), application_without="vesicle"),
    director("spontaneous director curvature", ("director", BENDING, AREA, VOLUME)),
    director("in-plane directors", ("director", BENDING, AREA, VOLUME)),
    director("director friction", ("director",), (*SPACE, "Surface/Motion=held"), own=("Time/End time=0.1", "Time/Step=0.03")),
    director("cosserat shell", ("point loads",), SHELL, alone=False),
    director("dead load", ("cosserat shell", "point loads"), SHELL, own=("Dead load/Force=0, 0, -1e-4",)),
    director("point loads", ("cosserat shell", "dead load"), SHELL),
)

PAIRS = (*VESICLE_PAIRS, *DROPLET_PAIRS, *RIDGE_PAIRS, *DIRECTOR_PAIRS)


# Whose effects an application offers beside its own.
SHARED = {"director_membrane": "vesicle"}


def covers(rows, application, effect):
    """Whether (application, effect) is among the rows, or is an effect that the application shares with another one's row."""
    return (application, effect) in rows or (SHARED.get(application), effect) in rows
