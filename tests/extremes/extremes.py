#!/usr/bin/env python3
"""Scenes at the edge of what numbers can say: each is right, or refused with a reason; never wrong, without number or endless.

  extremes.py --harmos PROGRAM [--write docs/method/extremes.md] [WORD ...]

Prints a row for each case: what is extreme, how the run has ended, its largest error relative to the closed form, and the
reason where it is not certified. Exit code 1 when a certified response errs by more than MARGIN times the accuracy that was
asked for, when a case that must be right is refused or the other way round, when a result has no number, or when a run
takes longer than its seconds. With words only cases that have one of them in their group.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy

from bars import bars, pressed_blocks
from column import FRICTION, column, xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
import harmos as harmos_results
from harmos.exchange.elements import TYPES
from harmos.exchange.exodus import write_exodus
from harmos.exchange.mesh import Block, Mesh

MARGIN = 2.0
"""True error of a certified response over the accuracy that was asked for, at most."""
LEAST_SPREAD = 1e-3
"""A standard deviation below this share of the mean counts as that share, see docs/method/stochastic.md."""
MARKER = "<!-- written by tests/extremes/extremes.py -->\n"


@dataclass
class Case:
    """A scene, and what must come of it: right, refused or either."""

    group: str
    what: str
    scene: dict
    truth: dict = field(default_factory=dict)  # final values of responses
    must: str = "right"
    ranks: int = 1
    seconds: float = 120.0
    reason: str = ""  # a piece of it, when it is refused
    mesh: Callable | None = None  # makes the mesh in a folder
    study: dict | None = None  # of the scene; then the truth is of means and standard deviations


def contact(mu=0.3, gap=0.0):
    return {"Type": "Coulomb Friction", "Friction Coefficient": float(mu), "Gap": float(gap)}


def springs(normal):
    return {"Type": "Linear Elastic", "Normal Stiffness": float(normal), "Tangential Stiffness": float(normal)}


def pressed(modulus=1000.0, pressure=1.0, height=1.0, width=1.0, extra=0.0, blocks=2):
    """Closed form of a column on rollers."""
    return {"top": -blocks * pressure * height / modulus - extra, "force": -pressure * width * width}


def shear_held(mu, share):
    """A flat block, its top drawn along x by a share of what friction carries; only friction holds it."""
    scene = column(contact(mu), width=1.0, height=0.05, shear=share * mu, cells=[[4, 4, 1]] * 2)
    del scene["Boundaries"]["b1_x"]
    scene["Boundaries"]["b0_zmin_x"] = scene["Boundaries"].pop("b0_x")
    return scene


def chain(blocks):
    """A bar of blocks under its weight along z, Poisson's ratio 0: nodes of linear elements are exact."""
    scene = column({"Type": "Perfect"}, moduli=[1000.0] * blocks, pressure=0.0, poisson=0.0, cells=[[1, 1, 1]] * blocks)
    for part in scene["Parts"].values():
        part["Body Force"] = {"Z": -1.0}
    return scene


def cases():
    for mu in (0.0, 1e-12, 1.0, 5.0, 100.0):
        yield Case("friction", f"mu {mu:g}, pressed", column(contact(mu)), pressed())
    for mu in (1e-6, 0.3, 1.0, 5.0):
        yield Case("friction", f"mu {mu:g}, drawn at 90 % of slip", shear_held(mu, 0.9), {"drag": 0.9 * mu}, "either")
        yield Case("friction", f"mu {mu:g}, drawn at slip", shear_held(mu, 1.0), {"drag": mu}, "either")
        yield Case("friction", f"mu {mu:g}, drawn at 1.001 of slip", shear_held(mu, 1.001), must="refused")
    yield Case("friction", "mu 0, drawn", column(contact(0.0), shear=1e-6, cells=[[1, 1, 1]] * 2, sides=False), must="refused")
    for gap in (0.0, 1e-15, 1e-6, 1.0, 1e4, 1e6):
        yield Case("gap", f"closed by the load, gap {gap:g}", column(contact(gap=gap)), pressed(extra=gap))
    yield Case("gap", "closed by the load, gap 1e+08", column(contact(gap=1e8)), must="refused", reason="no digits")
    yield Case("gap", "larger than any motion", column(contact(gap=1.0), displaced=-0.1), {"top": -0.1, "force": 0.0})
    for gap in (-1e-12, -1e-3, -0.1):
        yield Case("gap", f"interference {-gap:g} between held ends", column(contact(gap=gap), displaced=0.0),
                   {"force": 1000.0 * gap / 2})
    for ratio in (1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e11, 1e12, 1e13):
        yield Case("stiffness", f"upper block {ratio:g} times as stiff", column(contact(0.0), moduli=(1000.0, 1000.0 * ratio)),
                   {"top": -(1 + 1 / ratio) / 1000, "force": -1.0}, "either" if ratio > 1e9 else "right")
    for ratio in (1e-12, 1e-9, 1e-6, 1e6, 1e9, 1e12):
        yield Case("stiffness", f"springs {ratio:g} times as stiff as the blocks", column(springs(1000.0 * ratio)),
                   pressed(extra=1 / (1000 * ratio)), "either" if ratio < 1e-6 else "right")
    yield from _soft_joints()
    for nu in (0.0, 0.49, 0.499, 0.4999, 0.49999):
        yield Case("material", f"Poisson's ratio {nu:g}", column(poisson=nu), pressed())
    for ratio in (100.0, 1000.0):
        yield Case("shape", f"plates {ratio:g} times as wide as thick", column(width=ratio, cells=[[4, 4, 1]] * 2),
                   pressed(width=ratio))
        yield Case("shape", f"bars {ratio:g} times as long as wide", column(width=1 / ratio), pressed(width=1 / ratio),
                   "either" if ratio > 100 else "right")
    yield Case("shape", "one element per block", column(cells=[[1, 1, 1]] * 2), pressed())
    for length in (1e-9, 1e-6, 1e-3, 1e3, 1e6):
        yield Case("units", f"lengths times {length:g}", column(height=length, width=length),
                   pressed(height=length, width=length))
    yield Case("units", "one block in mm, pressed by one in m: modulus and load times 1e6",
               column(contact(0.0), moduli=(1e3, 1e9), pressure=1e6), {"top": -1e6 * (1e-3 + 1e-9), "force": -1e6})
    for pressure in (1e-12, 1e-6, 1e6, 1e12):
        yield Case("loads", f"pressure {pressure:g}", column(pressure=pressure), pressed(pressure=pressure))
    yield Case("loads", "none", column(pressure=0.0), {"top": 0.0, "force": 0.0})
    for shear in (1e-6, 1e-9):
        scene = column(contact(0.3), displaced=0.0, poisson=0.0)
        scene["Interfaces"]["j0"]["Law"]["Gap"] = -0.1
        scene["Boundaries"]["pull"] = {"Side Set": "b1_xmax", "Law": {"Type": "Prescribed Traction", "X": 50 * shear}}
        scene["Boundaries"]["pull_0"] = {"Side Set": "b0_xmax", "Law": {"Type": "Prescribed Traction", "X": 50 * shear}}
        yield Case("loads", f"a response {shear:g} times that of the preload", scene,
                   {"slide": 50 * shear / 1000 / 2, "force": -50.0})
    yield Case("loads", "pressed, then let go: contact without force", _with_history(column(contact(0.3)), "Z", [0, 1, 0]),
               {"force": 0.0})
    yield Case("loads", "pressed by 1e6, then by 1", _with_history(column(contact(0.3)), "Z", [0, 1e6, 1]), pressed())
    yield from _damage()
    yield from _wedge()
    yield Case("steps", "100 of them", column(steps={"load": {"Increments": 100}}), pressed())
    yield Case("steps", "10000 of them", column(steps={"load": {"Increments": 10000}}, cells=[[1, 1, 1]] * 2),
               pressed(), seconds=600)
    yield Case("steps", "lengths from 1e-3 to 1e3",
               column(steps={"a": {"Duration": 1e-3}, "b": {"Duration": 1e3, "Increments": 2}}), pressed())
    creeping = {"Type": "Maxwell Glue", "Normal Stiffness": 1000.0, "Tangential Stiffness": 1000.0,
                "Normal Viscosity": 1e6, "Tangential Viscosity": 1e6}
    yield Case("steps", "lengths from 1e-3 to 1e3, glue that creeps",
               column(creeping, steps={"a": {"Duration": 1e-3}, "b": {"Duration": 1e3, "Increments": 2}, "c": {"Duration": 1e-3}}),
               pressed(extra=1 / 1000 + 2 * 500.001 / 1e6))
    for scale in (1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9):
        yield Case("search direction", f"times {scale:g}", column(solver={"Search Direction": {"Scale": scale}}),
                   pressed(), "either")
    for scale in (1e-12, 1e12):
        yield Case("search direction", f"times {scale:g}", column(solver={"Search Direction": {"Scale": scale}}),
                   must="refused", reason="Scale")
    scene = column(held=False, sides=False)
    scene["Boundaries"]["bottom"] = {"Side Set": "b0_zmin", "Law": {"Type": "Prescribed Traction", "Z": 1.0}}
    yield Case("support", "none at all, loads in balance", scene, {"force": -1.0}, "either")
    scene = column(held=False, sides=False)
    yield Case("support", "none at all, loads not in balance", scene, must="refused")
    yield Case("support", "the upper block on contact alone", column(contact(0.3), pressure=1.0), pressed())
    yield Case("support", "the upper block pulled off", column(contact(0.3), pressure=-1.0), must="refused")
    yield Case("parts", "one", _one(), {"top": -1e-3})
    for blocks in (2, 50, 1000):
        yield Case("parts", f"{blocks} in a chain", chain(blocks), {"top": -blocks * blocks / 2000.0}, seconds=600)
    yield Case("parts", "two on four ranks", column(), pressed(), ranks=4)
    yield Case("parts", "one on two ranks", _one(), {"top": -1e-3}, ranks=2)
    for where in ("edge", "node"):
        yield Case("parts", f"that touch at one {where}", _touching(where), {"force": -1.0})
    for n in (10, 100):
        scene = column(width=1.0, cells=[[2, 1, 1], [2 * n, 1, 1]])
        scene["Interfaces"] = {"j0": {"Part 1": "b0", "Part 2": "b1", "Law": dict(FRICTION)}}
        yield Case("meshes", f"1 face against {n}", scene, pressed())
    for side in ("Side 1", "Side 2"):
        scene = column(width=1.0, cells=[[1, 1, 1], [10, 10, 1]])
        scene["Interfaces"]["j0"]["Points On"] = side
        yield Case("meshes", f"1 face against 10 x 10, points on {side[-1]}", scene, pressed())
    for variation in (1e-9, 0.1, 0.57):
        for order in (3, 12):
            yield _random_springs(variation, order)


def _with_history(scene, axis, values):
    """The load on the top times these values, one per unit of time."""
    scene["Boundaries"]["top"]["Law"][f"{axis} History"] = "way"
    scene["Histories"] = {"way": {"Type": "Table", "Times": list(range(len(values))), "Values": values}}
    scene["Steps"] = {f"s{i}": {} for i in range(1, len(values))}
    return scene


def _soft_joints():
    """Bars on joints so soft that round-off in their forces may move them across."""
    hard, soft = 1e7, 1e5
    for accuracy in (1e-2, 1e-3, 1e-4, 1e-6):
        scene = bars([60, 2], 1.0, [(soft, 0.45), (hard, 0.45), (soft, 0.45), (hard, 0.3), (soft, 0.45)],
                     [(1e5, 1e2), (1e-1, 1e-4), (1e5, 1e2), (1e8, 1e8)], -7e4, [4, 4, 1, 1, 2], accuracy)
        yield Case("soft joints", f"to 1e11 times as soft as plane bars, accuracy {accuracy:g}", scene,
                   {"across": 0.0, "force": 1.4e5}, "either" if accuracy < 1e-3 else "right")
    for accuracy in (1e-3, 1e-7):
        scene = bars([24, 3, 3], 1.0, [(1.0, 0.49), (100.0, 0.49), (1.0, 0.49), (100.0, 0.3), (1.0, 0.3)],
                     [(1.0, 0.4), (1e-3, 4e-4), (1e-6, 1e-6), (1e-3, 1e-6)], 1e-6, [1, 1, 1, 1, 4], accuracy)
        yield Case("soft joints", f"to 1e8 times as soft as bars in space, accuracy {accuracy:g}", scene,
                   {"across": 0.0, "force": -9e-6})
    for accuracy in (3e-2, 1e-5):
        scene = pressed_blocks([], {}, 1e-13, accuracy, hold={"Type": "Elastic Foundation", "Normal Stiffness": 0.01,
                                                              "Tangential Stiffness": 1e-10})
        yield Case("soft joints", f"springs to 1e10 times as soft hold a block, accuracy {accuracy:g}", scene,
                   {"held": 2e-3, "across": -2e-13}, "right" if accuracy > 1e-3 else "refused", reason="round-off")
    for accuracy in (1e-4, 1e-7):
        scene = pressed_blocks([{"Type": "Unilateral Contact"}], {1: 1e-6}, 0.0, accuracy)
        yield Case("soft joints", f"springs 1e6 times as soft below a pressed block, accuracy {accuracy:g}", scene,
                   {"below1": 0.0, "across": 0.0}, "right" if accuracy > 1e-6 else "refused", reason="round-off")
    glue = {"Type": "Cohesive Zone", "Stiffness": 1.0, "Normal Strength": 1.0, "Shear Strength": 1.0,
            "Mode I Fracture Energy": 2.0, "Mode II Fracture Energy": 2.0}
    for accuracy in (1e-3, 1e-5):
        scene = pressed_blocks([glue, {"Type": "Unilateral Contact"}], {2: 1e-6}, 0.0, accuracy)
        yield Case("soft joints", f"the same beside glue that can soften, accuracy {accuracy:g}", scene,
                   {"below2": 0.0, "across": 0.0})


def _damage():
    """Glue between two blocks that are springs of 500 together, pulled apart: up to STRENGTH it is elastic, then it softens to
    nothing at the opening `end`."""
    strength, stiffness = 1.0, 1e4
    begin = strength / stiffness

    def glue(end):
        energy = strength * end / 2
        return {"Type": "Cohesive Zone", "Stiffness": stiffness, "Normal Strength": strength, "Shear Strength": strength,
                "Mode I Fracture Energy": energy, "Mode II Fracture Energy": energy}

    def pulled(end, ways):
        scene = _with_history(column(glue(end), displaced=1.0), "Z", [0.0, *ways])
        return scene

    end, opening = 0.02, 0.01
    force = strength * (end - opening) / (end - begin)
    damaged = opening + force / 500
    yield Case("damage", "by half", pulled(end, [damaged]), {"force": force})
    secant = 1 / (opening / force + 1 / 500)
    yield Case("damage", "by half, unloaded by half", pulled(end, [damaged, damaged / 2]), {"force": secant * damaged / 2})
    yield Case("damage", "by half, unloaded, pressed", pulled(end, [damaged, -0.01]), {"force": -5.0})
    for way in (0.03, 1.0, 1e3, 1e6):
        yield Case("damage", f"to failure, {way / end:g} times beyond it", pulled(end, [way]), {"force": 0.0, "top": way})
    yield Case("damage", "to failure, pressed, pulled anew", pulled(end, [0.05, -0.01, 0.05]), {"force": 0.0, "top": 0.05})
    yield Case("damage", "to failure, pressed", pulled(end, [1.0, -0.01]), {"force": -5.0, "top": -0.01})
    yield Case("damage", "of glue that snaps, pulled beyond failure", pulled(2e-4, [0.01]), {"force": 0.0, "top": 0.01}, "either")
    yield Case("damage", "of glue that hardly softens", pulled(1e3, [0.1]), {"force": (1e3 - 0.1 + 1 / 500) / (1e3 - begin)}, "either")
    yield Case("damage", "none, at 0.999 of the strength", column(glue(end), pressure=-0.999), {"force": 0.999})
    yield Case("damage", "by a force of 1.001 of the strength", column(glue(end), pressure=-1.001), must="refused")


def _wedge():
    """A wedge on a smooth floor below a block between guides that carries WEIGHT, driven in by a force or a way."""
    weight, slope = 400.0, 0.1

    def scene(mu, ways, law="Prescribed Displacement"):
        smooth = {"Type": "Symmetry"}
        return {
            "Mesh": {"Type": "Exodus", "File": "wedge.e"},
            "Materials": {"steel": {"Type": "Isotropic", "Young's Modulus": 210000.0, "Poisson's Ratio": 0.3}},
            "Parts": {"wedge": {"Material": "steel"}, "block": {"Material": "steel"}},
            "Interfaces": {"contact": {"Side 1": "wedge_top", "Side 2": "block_bottom", "Law": contact(mu)}},
            "Boundaries": {"floor": {"Side Set": "wedge_bottom", "Law": smooth}, "guide": {"Side Set": "block_left", "Law": smooth},
                           "load": {"Side Set": "block_top", "Law": {"Type": "Pressure", "Pressure": weight / 40}},
                           "drive": {"Side Set": "wedge_right", "Law": {"Type": law, "X": 1.0, "X History": "way"}}},
            "Histories": {"way": {"Type": "Table", "Times": list(range(len(ways) + 1)), "Values": [ways[0], *ways]}},
            "Steps": {f"s{i}": {} for i in range(len(ways))},
            "Solver": {"Accuracy": 1e-6},
            "Responses": {name: {"Type": "Interface Force", "Interface": interface, "Direction": direction} for name, interface, direction in
                          (("push", "drive", [1, 0]), ("across", "contact", [1, 0]), ("down", "contact", [0, 1]))}}

    for mu in (0.0, 0.2, 1.0, 5.0):
        push = weight * (mu + slope) / (1 - mu * slope)
        yield Case("wedge", f"mu {mu:g}, driven in", scene(mu, [-0.5]), {"push": -push}, mesh=_wedge_mesh)
    for mu in (0.0, 0.2, 1.0):
        pull = weight * (mu - slope) / (1 + mu * slope)
        yield Case("wedge", f"mu {mu:g}, driven in and drawn back", scene(mu, [-0.5, 0.5]), {"push": pull}, mesh=_wedge_mesh)
    traction = "Prescribed Traction"
    height = 14.0
    push = weight * (0.2 + slope) / (1 - 0.2 * slope)
    yield Case("wedge", "mu 0.2, pushed by 0.9 of what drives it, let go: it jams", scene(0.2, [-0.9 * push / height, 0.0], traction),
               {"across": 0.0, "down": -weight}, mesh=_wedge_mesh)
    yield Case("wedge", "mu 0.05, let go: it is thrown out", scene(0.05, [0.0], traction), must="refused", mesh=_wedge_mesh)
    yield Case("wedge", "mu 10: no force drives it", scene(10.0, [-100 * push / height], traction),
               {"across": 100 * push, "down": -weight}, "either", mesh=_wedge_mesh)


def _wedge_mesh(folder):
    """wedge.e: 16 x 4 and 16 x 8 cells, 40 mm long, that meet along a slope of 0.1."""
    width, rows, nodes, blocks, sides, first = 16, {"wedge": 4, "block": 8}, [], [], {}, 0
    for name, count in rows.items():
        low, high = (0.0, 10.0) if name == "wedge" else (10.0, 30.0)
        begin = len(nodes)
        for row in range(count + 1):
            for column_ in range(width + 1):
                x, share = 40.0 * column_ / width, row / count
                bottom, top = low + (0.1 * x if low else 0.0), high + (0.0 if low else 0.1 * x)
                nodes.append((x, bottom + share * (top - bottom), 0.0))
        corners = [[begin + row * (width + 1) + c for c in (i, i + 1, i + 1 + width + 1, i + width + 1)]
                   for row in range(count) for i in range(width)]
        blocks.append(Block(name, TYPES["QUAD4"], numpy.array(corners)))
        number = first + numpy.arange(count * width).reshape(count, width)
        for where, elements, side in (("bottom", number[0], 0), ("right", number[:, -1], 1), ("top", number[-1], 2), ("left", number[:, 0], 3)):
            sides[f"{name}_{where}"] = numpy.column_stack([elements, numpy.full(len(elements), side)])
        first += count * width
    write_exodus(pathlib.Path(folder) / "wedge.e", Mesh(2, numpy.array(nodes), blocks, sides))


def _random_springs(variation, order):
    """Springs of lognormal stiffness: their compliance is lognormal with the same coefficient of variation."""
    scale = (1 + variation ** 2) / 1000
    scene = column(springs(1000.0))
    study = {
        "Scene": "case.xml", "Accuracy": 1e-4,
        "Parameters": {"k": {"Unit": "-", "Distribution": {"Type": "Lognormal", "Mean": 1000.0,
                                                           "Coefficient of Variation": float(variation)}},
                       "k_n": {"Entry": "Interfaces/j0/Law/Normal Stiffness", "Formula": "k"}},
        "Design": {"Type": "Chaos", "Order": order, "Tolerance": 1e-3},
        "Responses": {"end": {"Type": "Final", "Response": "top"}}}
    truth = {"mean": -2e-3 - scale, "standard_deviation": variation * scale}
    return Case("chaos", f"c.v. {variation:g}, order {order} at most", scene, truth,
                "either" if order < 12 else "right", study=study)


def _one():
    scene = column(moduli=[1000.0])
    del scene["Responses"]["force"], scene["Responses"]["drag"], scene["Interfaces"]
    return scene


def _touching(where):
    scene = column()
    box = scene["Mesh"]["Boxes"]["b1"]
    shift = {"edge": (1, 0, 0), "node": (1, 1, 0)}[where]
    for corner in ("Lower Corner", "Upper Corner"):
        box[corner] = [a + b for a, b in zip(box[corner], shift)]
    scene["Interfaces"] = {"j0": {"Part 1": "b0", "Part 2": "b1", "Law": dict(FRICTION)}}
    return scene


def outcome(harmos, case, folder):
    """Verdict, largest relative error, stages, seconds and words of a case."""
    path = pathlib.Path(folder) / "case.xml"
    path.write_text(xml("Harmos", {key: value for key, value in case.scene.items() if value != {}}))
    if case.mesh is not None:
        case.mesh(folder)
    command = [harmos, "run", str(path), "--quiet", "--output", folder]
    if case.study is not None:
        path = pathlib.Path(folder) / "study.xml"
        path.write_text(xml("Harmos Study", case.study))
        command = [harmos, "study", str(path), "--quiet", "--output", folder]
    if case.ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(case.ranks), *command]
    begin = time.monotonic()
    try:
        end = subprocess.run(command, capture_output=True, text=True, check=False, timeout=case.seconds)
    except subprocess.TimeoutExpired:
        return "ENDLESS", math.nan, 0, case.seconds, f"more than {case.seconds:g} s"
    seconds = time.monotonic() - begin
    if end.returncode == 2:
        words = [line for line in end.stderr.splitlines() if line.strip()]
        return "refused", math.nan, 0, seconds, words[0].removeprefix(f"{path}:") if words else ""
    if end.returncode == 1 and "nothing holds part(s)" in end.stderr:
        return "refused", math.nan, 0, seconds, end.stderr.strip().removeprefix("harmos: ")
    if end.returncode not in (0, 3, 4):
        return "CRASHED", math.nan, 0, seconds, f"exit code {end.returncode}: {end.stderr.strip()[-200:]}"
    if case.study is not None:
        return study_outcome(case, pathlib.Path(folder) / "study.h5", end, seconds)
    record = json.loads((pathlib.Path(folder) / "case_result.json").read_text())
    if end.returncode != 0:
        return "refused", math.nan, record["linear_stages"], seconds, f"{record['status']}: {record['reason']}"
    with open(pathlib.Path(folder) / "case_history.csv", newline="") as file:
        last = list(csv.DictReader(file))[-1]
    error = 0.0
    for name, value in case.truth.items():
        size = record["response_sizes"][name]  # what the accuracy is relative to
        distance = abs(float(last[name]) - value)
        error = max(error, distance / size if size > 0 else distance)
    is_right = error <= MARGIN * record["accuracy"]  # never of what is no number
    return "right" if is_right else "WRONG", error, record["linear_stages"], seconds, ", ".join(
        f"{name} {last[name]} for {value:g}" for name, value in case.truth.items()) if not is_right else ""


def study_outcome(case, path, end, seconds):
    """As outcome(), of a study: errors relative to the standard deviation, held to its accuracy and its tolerance."""
    study = harmos_results.read_study(path)
    response = study.statistics.responses["end"]
    distances = {name: abs(getattr(response, name) - value) for name, value in case.truth.items()}
    error = max(distances.values()) / max(case.truth["standard_deviation"], LEAST_SPREAD * abs(case.truth["mean"]))
    if end.returncode != 0:
        words = [part for note in study.notes.values() for part in note.split("; ") if "tolerance" in part]
        return "refused", math.nan, 0, seconds, "; ".join(words or end.stderr.strip().splitlines())
    is_right = error <= MARGIN * (case.study["Accuracy"] + case.study["Design"]["Tolerance"]) and (
        distances["standard_deviation"] <= MARGIN * response.standard_deviation_error)
    return "right" if is_right else "WRONG", error, 0, seconds, "" if is_right else (
        f"mean {response.mean:.9g}, standard deviation {response.standard_deviation:.9g} +- {response.standard_deviation_error:.2g}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True)
    parser.add_argument("--write", type=pathlib.Path)
    parser.add_argument("words", nargs="*")
    arguments = parser.parse_args()
    harmos = os.path.abspath(arguments.harmos)
    lines = ["| | what | outcome | error | linear stages | reason |", "|---|---|---|---|---|---|"]
    print("\n".join(lines))
    faults, counts = [], {}
    for case in cases():
        if arguments.words and case.group not in arguments.words:
            continue
        with tempfile.TemporaryDirectory() as folder:
            verdict, error, stages, _, words = outcome(harmos, case, folder)
        counts[verdict] = counts.get(verdict, 0) + 1
        if verdict not in ("right", "refused") or case.must not in (verdict, "either") or (
                verdict == "refused" and (not words or case.reason not in words)):
            faults.append(f"{case.group}, {case.what}: {verdict}, must be {case.must}; {words}")
        lines.append(f"| {case.group} | {case.what} | {verdict} | {'' if math.isnan(error) else f'{error:.0e}'} | {stages or ''} | "
                     f"{words.replace('|', ' ')} |")
        print(lines[-1], flush=True)
    summary = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    print(f"\n{summary}")
    print("\n".join(faults))
    if arguments.write:
        head, marker, _ = arguments.write.read_text().partition(MARKER)
        arguments.write.write_text(head + marker + "\n" + "\n".join(lines) + f"\n\n{summary}.\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
