#!/usr/bin/env python3
"""How good the estimates of the error of the mesh are: fixed scenes on nested meshes.

  mesh_errors.py [--harmos PROGRAM] [--levels 3] [--check] [SCENE ...]

Every scene is solved on its mesh and on meshes with two and four times as many cells along every edge; the converged
value of a response is extrapolated from the three (Richardson, with the order that they show). Printed are the true
error of the first and of the second mesh, the estimate that the run itself gives, their quotient, and at the end the
share of quotients between 0.5 and 3. Errors below 0.5 % are left out. Exit code 1 when an estimate says "below 0.5 %"
and refining moves the response by more than 2 %; with --check also when less than 85 % of the quotients lie there.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile


def parameter(name, value):
    if isinstance(value, bool):
        return f'<Parameter name="{name}" type="bool" value="{str(value).lower()}"/>'
    if isinstance(value, int):
        return f'<Parameter name="{name}" type="int" value="{value}"/>'
    if isinstance(value, float):
        return f'<Parameter name="{name}" type="double" value="{value!r}"/>'
    if isinstance(value, (list, tuple)):
        return f'<Parameter name="{name}" type="Array(double)" value="{{{", ".join(map(repr, value))}}}"/>'
    return f'<Parameter name="{name}" type="string" value="{value}"/>'


def xml(name, content):
    body = "".join(xml(key, value) if isinstance(value, dict) else parameter(key, value) for key, value in content.items())
    return f'<ParameterList name="{name}">{body}</ParameterList>\n'


def held(**components):
    return {"Type": "Prescribed Displacement", **components}


def boundary(side_set, law):
    return {"Side Set": side_set, "Law": law}


def joint(side1, side2, law):
    return {"Side 1": side1, "Side 2": side2, "Law": law}


def mean(side_set, *direction):
    return {"Type": "Mean Displacement", "Side Set": side_set, "Direction": [float(x) for x in direction]}


def force(interface, *direction):
    return {"Type": "Interface Force", "Interface": interface, "Direction": [float(x) for x in direction]}


class Scene:
    """Boxes with joints; `boxes`: name -> lower corner, upper corner, cells, element."""

    def __init__(self, boxes, boundaries, responses, interfaces=None, loads=None, poisson=0.3, moduli=None,
                 formulation="Full Integration"):
        self.boxes, self.boundaries, self.responses = boxes, boundaries, responses
        self.interfaces, self.loads, self.poisson = interfaces or {}, loads, poisson
        self.moduli, self.formulation = moduli or {}, formulation

    def text(self, factor):
        scene = {
            "Mesh": {"Type": "Boxes", "Boxes": {
                name: {"Lower Corner": [float(x) for x in lower], "Upper Corner": [float(x) for x in upper],
                       "Cells": [float(c * factor) for c in cells], "Element": element}
                for name, (lower, upper, cells, element) in self.boxes.items()}},
            "Materials": {name: {"Type": "Isotropic", "Young's Modulus": float(self.moduli.get(name, 1000)),
                                 "Poisson's Ratio": self.poisson} for name in self.boxes},
            "Parts": {name: {"Material": name, "Formulation": self.formulation} for name in self.boxes},
            "Interfaces": self.interfaces, "Boundaries": self.boundaries,
            "Steps": {f"s{i}": {} for i in range(len(self.loads or [1]))},
            "Solver": {"Accuracy": 1e-5}, "Responses": self.responses}
        if self.loads:
            scene["Histories"] = {"load": {"Type": "Table", "Times": [float(i) for i in range(len(self.loads) + 1)],
                                           "Values": [0.0, *map(float, self.loads)]}}
        return xml("Harmos", {key: value for key, value in scene.items() if value or key == "Steps"})


def beam(element, cells, poisson=0.3, formulation="Full Integration"):
    return Scene({"beam": ((0, 0, 0), (10, 1, 1), (10 * cells, cells, cells), element)},
                 {"held": boundary("beam_xmin", held(X=0.0, Y=0.0, Z=0.0)),
                  "end": boundary("beam_xmax", {"Type": "Prescribed Traction", "Z": -0.01})},
                 {"u": mean("beam_xmax", 0, 0, -1)}, poisson=poisson, formulation=formulation)


def corner(element, cells, poisson=0.3, formulation="Full Integration"):
    """A block, clamped below and pulled sideways above: singular corners."""
    return Scene({"block": ((0, 0), (1, 1), (cells, cells), element)},
                 {"held": boundary("block_ymin", held(X=0.0, Y=0.0)),
                  "top": boundary("block_ymax", {"Type": "Prescribed Traction", "X": 1.0, "Y": -0.5})},
                 {"u": mean("block_ymax", 1, 0)}, poisson=poisson, formulation=formulation)


def slab(element, cells, loads=None, modulus=1000):
    """A block on another one with friction, pressed and pulled sideways: partial slip, an edge that lifts."""
    law = {"Type": "Coulomb Friction", "Friction Coefficient": 0.4}
    traction = {"Type": "Prescribed Traction", "X": 0.28, "Y": -1.0, **({"X History": "load"} if loads else {})}
    return Scene({"lower": ((0, 0), (2, 1), (2 * cells, cells), element),
                  "upper": ((0, 1), (2, 2), (2 * cells, cells), element)},
                 {"held": boundary("lower_ymin", held(X=0.0, Y=0.0)),
                  "top": boundary("upper_ymax", traction)},
                 {"u": mean("upper_ymax", 1, 0), "v": mean("upper_ymax", 0, -1), "w": mean("lower_xmax", 1, 0)},
                 {"joint": joint("lower_ymax", "upper_ymin", law)}, loads, moduli={"upper": modulus})


def tower(element, cells):
    """Three blocks in space, one joint tied, one with friction."""
    friction = {"Type": "Coulomb Friction", "Friction Coefficient": 0.5}
    return Scene({"a": ((0, 0, 0), (1, 1, 1), (cells,) * 3, element), "b": ((0, 0, 1), (1, 1, 2), (cells,) * 3, element),
                  "c": ((0, 0, 2), (1, 1, 3), (cells,) * 3, element)},
                 {"held": boundary("a_zmin", held(X=0.0, Y=0.0, Z=0.0)),
                  "top": boundary("c_zmax", {"Type": "Prescribed Traction", "X": 0.06, "Y": 0.02, "Z": -1.0})},
                 {"u": mean("c_zmax", 1, 0, 0), "w": mean("c_zmax", 0, 0, -1)},
                 {"tied": joint("a_zmax", "b_zmin", {"Type": "Perfect"}),
                  "joint": joint("b_zmax", "c_zmin", friction)}, moduli={"b": 3000})


def frame(element, cells):
    """Two columns under a beam: the force of a column depends on how the beam bends."""
    contact = {"Type": "Unilateral Contact"}
    return Scene({"left": ((0, 0), (1, 3), (cells, 3 * cells), element),
                  "right": ((7, 0), (8, 3), (cells, 3 * cells), element),
                  "beam": ((0, 3), (8, 4), (8 * cells, cells), element)},
                 {"left_foot": boundary("left_ymin", held(X=0.0, Y=0.0)),
                  "right_foot": boundary("right_ymin", held(X=0.0, Y=0.0)),
                  "top": boundary("beam_ymax", {"Type": "Prescribed Traction", "Y": -1.0}),
                  "end": boundary("beam_xmin", held(X=0.0, Y=0.0))},
                 {"v": mean("beam_ymax", 0, -1), "N": force("right_foot", 0, 1), "R": force("end", 0, 1)},
                 {"tied": {"Part 1": "left", "Part 2": "beam", "Law": {"Type": "Perfect"}},
                  "joint": {"Part 1": "right", "Part 2": "beam", "Law": contact}})


def mast(cells):
    """A mast of tetrahedra that locks, on a soft block that does not: their shares of the displacement add up."""
    return Scene({"block": ((-1, -1, 0), (2, 2, 1), (3 * cells, 3 * cells, cells), "Hex8"),
                  "mast": ((0, 0, 1), (1, 1, 9), (cells, cells, 8 * cells), "Tet4")},
                 {"held": boundary("block_zmin", held(X=0.0, Y=0.0, Z=0.0)),
                  "top": boundary("mast_zmax", {"Type": "Prescribed Traction", "X": 0.01})},
                 {"u": mean("mast_zmax", 1, 0, 0)},
                 {"foot": joint("block_zmax", "mast_zmin", {"Type": "Perfect"})}, moduli={"block": 30})


SCENES = {
    "beam of HEX8, one thick": beam("Hex8", 1),
    "beam of HEX8, two thick": beam("Hex8", 2),
    "beam of TET4, one thick": beam("Tet4", 1),
    "beam of TET4": beam("Tet4", 2),
    "beam of TET4, three thick": beam("Tet4", 3),
    "beam of TET4, nu 0.49": beam("Tet4", 2, 0.49),
    "corners, QUAD4": corner("Quad4", 3),
    "corners, TRI3": corner("Tri3", 4),
    "corners, nu 0.49": corner("Quad4", 3, 0.49),
    "corners, nu 0.49, B-Bar": corner("Quad4", 3, 0.49, "B-Bar"),
    "friction, QUAD4": slab("Quad4", 3),
    "friction, TRI3": slab("Tri3", 4),
    "friction, contrast 10": slab("Quad4", 3, modulus=100),
    "friction, there and back": slab("Quad4", 3, [0.5, 1, 0.5, 0.2]),
    "tower of HEX8": tower("Hex8", 2),
    "tower of TET4": tower("Tet4", 2),
    "frame": frame("Quad4", 1),
    "mast of TET4 on a block": mast(1),
}


def run(harmos, folder, scene, factor):
    """Values at the last step, and the estimates of the record."""
    path = folder / f"scene_{factor}.xml"
    path.write_text(scene.text(factor))
    done = subprocess.run([harmos, "run", path, "--output", folder], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{path.name}: {done.stdout}{done.stderr}")
    last = (folder / f"scene_{factor}_history.csv").read_text().splitlines()
    values = dict(zip(last[0].split(",")[2:], map(float, last[-1].split(",")[2:])))
    return values, json.loads((folder / f"scene_{factor}_result.json").read_text())["mesh_error_estimates"]


def limit(values):
    """Richardson with the order that three nested meshes show, and that order."""
    first, second = values[-2] - values[-3], values[-1] - values[-2]
    ratio = first / second if second != 0 else math.inf
    order = min(max(math.log2(ratio), 0.5), 4.0) if ratio > 1 else 0.5
    return values[-1] + second / (2**order - 1), order


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", help="names of scenes, or their beginnings")
    parser.add_argument("--harmos", default="build/drivers/harmos", help="program (default: build/drivers/harmos)")
    parser.add_argument("--levels", type=int, default=3, help="meshes, each twice as fine as the one before")
    parser.add_argument("--check", action="store_true", help="fail where too many estimates miss")
    given = parser.parse_args()
    wanted = [name for name in SCENES if not given.scenes or any(name.startswith(start) for start in given.scenes)]
    quotients, isFalse = [], False
    print(f"{'scene':28}{'response':>9}{'cells':>6}{'true %':>9}{'estimate %':>12}{'quotient':>10}  word")
    for name in wanted:
        with tempfile.TemporaryDirectory() as folder:
            runs = [run(given.harmos, pathlib.Path(folder), SCENES[name], 2**level) for level in range(given.levels)]
        for response in SCENES[name].responses:
            converged, _ = limit([values[response] for values, _ in runs])
            for level, (values, estimates) in enumerate(runs[:-1]):
                if response not in estimates:
                    continue
                estimate = estimates[response]
                true = (converged - values[response]) / converged
                shown = math.copysign(estimate["relative"], estimate["change"] * converged)
                isFalse = isFalse or (estimate["relative"] < 0.005 and abs(true) > 0.02)
                if max(abs(true), abs(shown)) < 0.005:
                    continue
                quotients.append(shown / true)
                print(f"{name:28}{response:>9}{2**level:6}{100 * true:9.2f}{100 * shown:12.2f}{quotients[-1]:10.2f}"
                      f"  {estimate['word']}")
    good = sum(0.5 <= quotient <= 3 for quotient in quotients)
    print(f"\n{good} of {len(quotients)} between 0.5 and 3, median {sorted(quotients)[len(quotients) // 2]:.2f}")
    sys.exit(1 if isFalse or (given.check and good < 0.85 * len(quotients)) else 0)


if __name__ == "__main__":
    main()
