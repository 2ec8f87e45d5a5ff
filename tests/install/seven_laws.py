#!/usr/bin/python3
"""Moves two stiff blocks with each law of the consumer's plugin between them, and holds the forces against closed forms.

    seven_laws.py PLUGIN FOLDER

The faces match, are cut into pieces on two ranks, or are quadratic and do not match.
"""
import pathlib
import shutil
import sys
from typing import Any, Callable

import numpy

import harmos

SCENE = pathlib.Path(__file__).parent / "consumer" / "laws" / "relaxation.xml"
MODULUS = 1e8
SQUEEZED, SHEARED = MODULUS / 2, MODULUS / 4  # stress per displacement of both blocks, nu = 0
Path = list[tuple[float, float]]  # displacements along x and z at every load step, 0.3 long each; or forces


def cohesion(path: Path) -> Path:
    first, last, largest, forces = 0.01, 0.2, 0.0, []
    for shear, opening in path:
        largest = max(largest, numpy.hypot(shear, opening))
        secant = 100.0 if largest <= first else max(0.0, last - largest) / (last - first) / largest
        forces.append((secant * shear, secant * opening))
    return forces


def sliders(strengths: list[float], path: Path) -> Path:
    """Springs of 100 with sliders beside each other; 100 along the normal."""
    slips, forces = numpy.zeros(len(strengths)), []
    for shear, opening in path:
        tractions = numpy.clip(100.0 * (shear - slips), -numpy.array(strengths), strengths)
        slips = shear - tractions / 100.0
        forces.append((tractions.sum(), 100.0 * opening))
    return forces


def maxwell(path: Path) -> Path:
    relaxing, before, forces = numpy.zeros(2), numpy.zeros(2), []
    for jump in map(numpy.array, path):
        relaxing, before = (relaxing + 90.0 * (jump - before)) / 1.3, jump
        forces.append(tuple(10.0 * jump + relaxing))
    return forces


def grooves(path: Path) -> Path:
    slip, forces = 0.0, []
    for shear, opening in path:
        pressure = max(0.0, -SQUEEZED * opening)
        traction = numpy.clip(SHEARED * (shear - slip), -0.3 * pressure, 0.3 * pressure)
        slip = shear - traction / SHEARED
        forces.append((traction, -pressure))
    return forces


PULLS = [(0.0, 0.02), (0.0, 0.1), (0.05, 0.05), (0.1, 0.12), (0.2, 0.3)]
SHEARS = [(0.004, 0.0), (0.008, 0.01), (0.03, 0.0), (0.01, -0.02), (-0.03, 0.0)]
LAWS: dict[str, tuple[dict[str, Any], Path, Callable[[Path], Path]]] = {
    "Outside Cohesion": ({"Stiffness": 100.0, "Strength": 1.0, "Fracture Energy": 0.1}, PULLS, cohesion),
    "Outside Iwan": ({"Stiffness": 100.0, "Strengths": [0.5, 1.0, 2.0]}, SHEARS,
                     lambda path: sliders([0.5, 1.0, 2.0], path)),
    "Outside Maxwell": ({"Stiffness": 10.0, "Relaxing Stiffness": 90.0, "Relaxation Time": 1.0}, SHEARS, maxwell),
    "Outside Bolt": ({"Stiffness": 100.0, "Preload": 2.0}, SHEARS,
                     lambda path: [(0.0, 2.0 + 100.0 * opening) for _, opening in path]),
    "Outside Tresca": ({"Stiffness": 100.0, "Shear Strength": 1.0}, SHEARS, lambda path: sliders([1.0], path)),
    "Outside Orthotropic": ({"Friction Along": 0.3, "Friction Across": 0.6, "Axis": [1.0, 0.0, 0.0]},
                            [(0.0, -1e-6), (0.1, -1e-6), (0.2, -2e-6), (0.1, -2e-6), (0.1, 1e-3)], grooves),
    "Outside Fields": ({"Modulus": 10.0, "Thickness": 0.1}, SHEARS,
                       lambda path: [(100.0 * shear, 100.0 * opening) for shear, opening in path]),
}


def scene(law: str, path: Path) -> harmos.Scene:
    """The blocks of relaxation.xml with another law, moved along x and z."""
    made = harmos.read_scene(SCENE)
    made.folder = folder
    made["Plugins"] = [plugin.name]
    made["Interfaces/glue/Law"] = {"Type": law, **LAWS[law][0]}
    made["Boundaries/pulled/Law"] = {"Type": "Prescribed Displacement", "Y": 0.0, "X": 1.0, "X History": "x", "Z": 1.0,
                                     "Z History": "z"}
    times = [0.3 * step for step in range(len(path) + 1)]
    made["Histories"] = {name: {"Type": "Table", "Times": times, "Values": [0.0, *values]}
                         for name, values in zip("xz", zip(*path))}
    made["Steps"] = {"move": {"Duration": times[-1], "Increments": len(path)}}
    made["Responses"] = {name: {"Type": "Interface Force", "Interface": "pulled", "Direction": direction}
                         for name, direction in (("x", [1.0, 0.0, 0.0]), ("z", [0.0, 0.0, 1.0]))}
    return made


CUT = {"Parts/lower/Pieces": 2, "Parts/upper/Pieces": 3}
QUADRATIC = {"Mesh/Boxes/lower/Element": "Hex20", "Mesh/Boxes/upper/Element": "Hex20",
             "Mesh/Boxes/upper/Cells": [3.0, 3.0, 2.0]}
plugin, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
shutil.copy(plugin, folder)
failures = 0
for law, (_, path, form) in LAWS.items():
    exact = numpy.array(form(path))
    for faces, changes, ranks in (("matching", {}, 1), ("cut", CUT, 2), ("quadratic", QUADRATIC, 1)):
        made = scene(law, path)
        for entry, value in changes.items():
            made[entry] = value
        history = harmos.run(made, folder / "results", ranks=ranks).history
        found = numpy.column_stack([history["x"], history["z"]])[-len(path):]
        error = abs(found - exact).max() / abs(exact).max()
        if not error < 5e-4:
            print(f"{law}, {faces} faces: the forces are {error:.1e} off:\n{found}\n{exact}")
            failures += 1
sys.exit(failures > 0)
