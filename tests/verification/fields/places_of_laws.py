#!/usr/bin/env python3
"""Numbers that vary over the surface of laws with axes of their own, of forces on nodes, of rigid tools, and lists.

  places_of_laws.py --harmos build/drivers/harmos [--only CASE]

Against closed forms, and against twins: the same scene with many interfaces, each of which has its own numbers.
Exit code 1: one differs, or what has no sense is not refused with its reason.
"""
import copy
import pathlib
import sys
from collections.abc import Iterator
from typing import Any

import harmos
from cases import run_cases
from mesh_fields import ACCURACY, SAME, Runner, with_field

Checks = Iterator[tuple[str, float, float]]
COLUMNS, SPACING = 4, 1.25


def block(cells: list[float], element: str = "Hex8", poisson: float = 0.0) -> harmos.Scene:
    """A block of 4 x 2 x 1 beside the axis z, held at x = 1, with what moves at x = 5."""
    return harmos.Scene("blocks", {
        "Mesh": {"Type": "Boxes", "Boxes": {"block": {"Lower Corner": [1.0, 0.0, 0.0], "Upper Corner": [5.0, 2.0, 1.0],
                                                      "Cells": cells, "Element": element}}},
        "Materials": {"m": {"Type": "Isotropic", "Young's Modulus": 1000.0, "Poisson's Ratio": poisson}},
        "Parts": {"block": {"Material": "m"}},
        "Boundaries": {"ground": {"Side Set": "block_xmin", "Law": {
            "Type": "Prescribed Displacement", "X": 0.0, "Y": 0.0, "Z": 0.0}}},
        "Steps": {"load": {"Duration": 2.0, "Increments": 2}},
        "Solver": {"Accuracy": ACCURACY, "Mesh Error": False},
        "Responses": {
            **{f"force_{c}": {"Type": "Interface Force", "Interface": "ground", "Direction": [float(c == d) for d in "xyz"]}
               for c in "xyz"},
            **{f"inside_{c}": {"Type": "Point Displacement", "Point": [3.0, 1.0, 0.0],
                               "Direction": [float(c == d) for d in "xyz"]} for c in "xyz"}}})


def drawn(**options: Any) -> harmos.Scene:
    """Drawn along x by 0.01 t everywhere at x = 5, in components about the axis z."""
    wanted = block(**options)
    wanted["Boundaries/drawn"] = {"Side Set": "block_xmax", "Law": {
        "Type": "Cylindrical Displacement", "Radial": 0.01, "Radial Formula": "t * x / sqrt(x^2 + y^2)",
        "Tangential": -0.01, "Tangential Formula": "t * y / sqrt(x^2 + y^2)", "Axial": 0.0}}
    return wanted


def columns(law: dict[str, Any], elements: str = "Hex8", cells: float = 4.0) -> harmos.Scene:
    """Columns of 1 x 2 x 1, apart from each other on one base, pressed and pushed. They match the base with 4 cells."""
    names = [f"column_{i}" for i in range(COLUMNS)]
    boxes = {name: {"Lower Corner": [SPACING * i, 0.0, 1.0], "Upper Corner": [SPACING * i + 1.0, 2.0, 2.0],
                    "Cells": [cells, 2.0, 1.0], "Element": elements} for i, name in enumerate(names)}
    boxes["base"] = {"Lower Corner": [0.0, 0.0, 0.0], "Upper Corner": [SPACING * COLUMNS - 0.25, 2.0, 1.0],
                     "Cells": [5.0 * COLUMNS - 1.0, 2.0, 1.0], "Element": elements}
    return harmos.Scene("blocks", {
        "Mesh": {"Type": "Boxes", "Boxes": boxes},
        "Materials": {"m": {"Type": "Isotropic", "Young's Modulus": 1000.0, "Poisson's Ratio": 0.3}},
        "Parts": {name: {"Material": "m"} for name in boxes},
        "Interfaces": {f"under_{name}": {"Part 1": "base", "Part 2": name, "Law": dict(law)} for name in names},
        "Boundaries": {
            "ground": {"Side Set": "base_zmin", "Law": {"Type": "Prescribed Displacement", "X": 0.0, "Y": 0.0, "Z": 0.0}},
            **{f"over_{name}": {"Side Set": f"{name}_zmax", "Law": {
                "Type": "Prescribed Traction", "X": 0.25, "X History": "push", "Z": -1.0}} for name in names}},
        "Histories": {"push": {"Type": "Table", "Times": [0.0, 1.0, 2.0], "Values": [0.0, 1.0, 0.3]}},
        "Steps": {"load": {"Duration": 2.0, "Increments": 4}},
        "Solver": {"Accuracy": ACCURACY, "Mesh Error": False},
        "Responses": {f"{what}_{i}": {"Type": "Mean Displacement", "Side Set": f"{name}_zmax", "Direction": direction}
                      for i, name in enumerate(names) for what, direction in (("x", [1.0, 0.0, 0.0]), ("z", [0.0, 0.0, 1.0]))}})


def by_column(values: list[float]) -> str:
    """A formula with one value over each column."""
    text = str(values[-1])
    for i in reversed(range(COLUMNS - 1)):
        text = f"x < {SPACING * (i + 1) - 0.1} ? {values[i]} : {text}"
    return text


class Cases:
    """Each yields (what, found, largest that is allowed)."""

    def __init__(self, runner: Runner) -> None:
        self.runner = runner

    def cylindrical_displacement(self) -> Checks:
        """A block is drawn along x: sigma = E 0.01 t / 4 over 2 x 1, nothing across."""
        for what, options in (("hexahedra", {"cells": [4.0, 2.0, 1.0]}),
                              ("cut", {"cells": [4.0, 2.0, 1.0], "pieces": 3}),
                              ("quadratic", {"cells": [3.0, 2.0, 1.0], "element": "Hex20"}),
                              ("tetrahedra", {"cells": [3.0, 2.0, 1.0], "element": "Tet10"})):
            pieces = options.pop("pieces", None)
            wanted = drawn(**options)
            if pieces:
                wanted["Parts/block/Pieces"] = pieces
            for launcher in ((), ("mpirun", "-np", "2")) if pieces else ((),):
                found = self.runner.history(wanted, *launcher)
                for name, scale in (("force", 10.0), ("inside", 0.01)):
                    along = {"force": -5.0, "inside": 0.005}[name]
                    worst = max(abs(found[f"{name}_{c}"][t] - along * t * (c == "x")) for c in "xyz" for t in (1, 2))
                    yield f"{what}, {name}", worst / scale, SAME

    def quadratic_faces(self) -> Checks:
        """Prescribed displacements hold nodes, whether they follow a formula or not."""
        for element in ("Hex20", "Tet10"):
            one, other = block([3.0, 2.0, 1.0], element, 0.3), block([3.0, 2.0, 1.0], element, 0.3)
            for scene in (one, other):
                scene["Boundaries/moved"] = {"Side Set": "block_xmax", "Law": {
                    "Type": "Prescribed Displacement", "X": 0.01, "X History": "t", "Y": 0.002, "Y History": "t"}}
                scene["Histories"] = {"t": {"Type": "Table", "Times": [0.0, 2.0], "Values": [0.0, 2.0]}}
            one["Boundaries/moved/Law/X Formula"] = "1"
            yield element, self.runner.difference(one, other), SAME

    def patch(self) -> Checks:
        """Blocks that do not match, strained alike all over by what holds their outer faces about the axis z: u = (2 x + y,
        x - y, z) / 1000. Nodes of edges are held by two or three boundaries, those of the joint by the tie besides."""
        radial, tangential = "2 * x + y", "x - y"
        law = {"Type": "Cylindrical Displacement", "Radial": 1e-3, "Tangential": 1e-3, "Axial": 1e-3,
               "Radial Formula": f"(({radial}) * x + ({tangential}) * y) / sqrt(x^2 + y^2)",
               "Tangential Formula": f"(({tangential}) * x - ({radial}) * y) / sqrt(x^2 + y^2)", "Axial Formula": "z"}
        for element in ("Hex8", "Tet10"):
            wanted = block([4.0, 2.0, 2.0], element, 0.3)
            wanted["Mesh/Boxes/over"] = {"Lower Corner": [1.0, 0.0, 1.0], "Upper Corner": [5.0, 2.0, 2.0],
                                         "Cells": [3.0, 3.0, 2.0], "Element": element}
            wanted["Parts/over"] = {"Material": "m"}
            wanted["Interfaces"] = {"tie": {"Part 1": "block", "Part 2": "over", "Law": {"Type": "Perfect"}}}
            faces = [f"{part}_{face}" for part in ("block", "over") for face in ("xmin", "xmax", "ymin", "ymax")]
            wanted["Boundaries"] = {face: {"Side Set": face, "Law": law} for face in [*faces, "block_zmin", "over_zmax"]}
            inside = {"block": (3.0, 1.0, 0.5), "over": (1.0 + 4.0 / 3.0, 2.0 / 3.0, 1.5)}
            wanted["Responses"] = {
                **{f"{part}_{c}": {"Type": "Point Displacement", "Point": list(place),
                                   "Direction": [float(c == d) for d in "xyz"]}
                   for part, place in inside.items() for c in "xyz"},
                "peak": {"Type": "Maximum", "Interfaces": ["tie"], "Field": "Normal Traction"}}
            found = self.runner.history(wanted)
            for part, (x, y, z) in inside.items():
                worst = max(abs(found[f"{part}_{c}"][-1] - 1e-3 * value)
                            for c, value in zip("xyz", (2 * x + y, x - y, z)))
                yield f"{element}, inside of {part}", worst / 1e-2, SAME
            stress = 1e-3 * (1000.0 / 1.3 + 2.0 * 0.3 * 1000.0 / (1.3 * 0.4))  # 2 G e_zz + lambda tr e
            yield f"{element}, stress", abs(abs(found["peak"][-1]) / stress - 1), SAME

    def contradictions(self) -> Checks:
        """Nodes that two boundaries hold at different displacements at a place."""
        for law in ({"Type": "Prescribed Displacement", "X": 0.01, "X Formula": "y"},
                    {"Type": "Cylindrical Displacement", "Radial": 0.01, "Radial Formula": "y"}):
            wanted = block([4.0, 2.0, 1.0])
            wanted["Boundaries/side"] = {"Side Set": "block_zmin", "Law": law}
            code, message = self.runner.run(wanted)
            is_right = code == 2 and "holds 2 nodes, the first at (1, 1, 0)" in message
            yield law["Type"] + ("" if is_right else f": {code}: {message}"), float(not is_right), 0.5

    def cylindrical_field(self) -> Checks:
        """By a variable of the mesh file, whatever the direction."""
        for component in ("Radial", "Tangential", "Axial"):
            followed, expected = block([4.0, 2.0, 1.0], poisson=0.3), block([4.0, 2.0, 1.0], poisson=0.3)
            self.runner.on_file(followed, "map", lambda x, y, z, t: 1 + y - z / 2)
            for one in (followed, expected):
                one["Boundaries/drawn"] = {"Side Set": "block_xmax", "Law": {"Type": "Cylindrical Displacement", component: 0.01}}
            with_field(followed, "Boundaries/drawn", component, "map")
            expected[f"Boundaries/drawn/Law/{component} Formula"] = "1 + y - z / 2"
            yield component, self.runner.difference(followed, expected), SAME

    def nodal_force(self) -> Checks:
        """Nodes of the far face take 0.5 t (1 + y), wherever they are: the ground bears their sum."""
        for element, count, mean in (("Hex8", 6, 2.0), ("Hex20", 13, 2.0), ("Tet10", 15, 2.0)):
            for pieces, launcher in ((1, ()), (3, ("mpirun", "-np", "2"))):
                wanted = block([4.0, 2.0, 1.0], element)
                if pieces > 1:
                    wanted["Parts/block/Pieces"] = pieces
                wanted["Boundaries/load"] = {"Side Set": "block_xmax", "Law": {
                    "Type": "Nodal Force", "Z": 0.5, "Z Formula": "t * (1 + y)"}}
                found = self.runner.history(wanted, *launcher)["force_z"]
                yield (f"{element}, {pieces} pieces", max(abs(found[t] / t + 0.5 * count * mean) for t in (1, 2)) / 10, SAME)
        followed = block([4.0, 2.0, 1.0])
        self.runner.on_file(followed, "map", lambda x, y, z, t: 1 + y)
        followed["Boundaries/load"] = {"Side Set": "block_xmax", "Law": {"Type": "Nodal Force", "Z": 0.5}}
        with_field(followed, "Boundaries/load", "Z", "map")
        yield "of the mesh file", abs(self.runner.history(followed)["force_z"][2] + 0.5 * 6 * 2) / 10, SAME

    def tools(self) -> Checks:
        """A tool with another friction under each of two blocks, against one that has them everywhere."""
        friction = [0.1, 0.3]
        shapes = {"Rigid Plane": {"Point": [0.0, 0.0, 1.0], "Normal": [0.0, 0.0, 1.0]},
                  "Rigid Cylinder": {"Point": [2.4, 0.0, -39.0], "Axis": [0.0, 1.0, 0.0], "Radius": 40.0},
                  "Rigid Sphere": {"Centre": [2.4, 1.0, -39.0], "Radius": 40.0}}
        for name, shape in shapes.items():
            for element in ("Hex8", "Hex20"):
                wanted = columns({"Type": "Perfect"}, element)
                for path in ("Interfaces", "Mesh/Boxes/base", "Mesh/Boxes/column_0", "Mesh/Boxes/column_3", "Parts/base",
                             "Parts/column_0", "Parts/column_3"):
                    del wanted[path]
                for i in (0, 3):
                    del wanted[f"Boundaries/over_column_{i}"]
                    del wanted[f"Responses/x_{i}"], wanted[f"Responses/z_{i}"]
                del wanted["Boundaries/ground"]
                twin = copy.deepcopy(wanted)
                for i, own in ((1, friction[0]), (2, friction[1])):
                    move = {"Type": "Prescribed Displacement", "X": 0.01, "X History": "push", "Y": 0.0, "Z": -0.02}
                    tool = {"Type": name, **shape}
                    for one, law in ((wanted, {"Friction Coefficient": 0.1, "Friction Coefficient Formula": "x < 2.4 ? 1 : 3"}),
                                     (twin, {"Friction Coefficient": own})):
                        one[f"Boundaries/over_column_{i}/Law"] = dict(move)
                        one[f"Boundaries/tool_{i}"] = {"Side Set": f"column_{i}_zmin", "Law": {**tool, **law}}
                        for c, d in (("x", [1.0, 0.0, 0.0]), ("z", [0.0, 0.0, 1.0])):
                            one[f"Responses/force_{c}_{i}"] = {"Type": "Interface Force", "Interface": f"tool_{i}",
                                                               "Direction": d}
                yield f"{name}, {element}", self.runner.difference(wanted, twin), SAME
                forces = self.runner.history(twin)
                yield f"{name}, {element}: they differ", 0.02 / abs(forces["force_x_1"][2] - forces["force_x_2"][2]), 1.0

    def lists(self) -> Checks:
        """Tables and Jenkins elements, on meshes that match and that do not."""
        laws = {"Tabulated Contact": {"Overclosures": [0.0, 0.002, 0.004], "Pressures": [0.0, 1.0, 8.0],
                                      "Friction Coefficient": 0.3, "Tangential Stiffness": 300.0},
                "Parallel Iwan": {"Stiffnesses": [200.0, 100.0], "Slip Limits": [0.1, 0.15], "Residual Stiffness": 50.0,
                                  "Normal Stiffness": 400.0}}
        factors = [0.7, 1.0, 1.6, 0.9]
        for kind, entries in laws.items():
            for name in [key for key, value in entries.items() if isinstance(value, list)]:
                for cells in (4.0, 3.0):
                    law = {"Type": kind, **entries}
                    formula = columns({**law, f"{name} Formula": by_column(factors)}, cells=cells)
                    twin = columns(law, cells=cells)
                    for i, factor in enumerate(factors):
                        twin[f"Interfaces/under_column_{i}/Law/{name}"] = [factor * v for v in entries[name]]
                    yield f"{name}, {cells:g} cells", self.runner.difference(formula, twin), SAME
                    if cells == 3.0:
                        yield f"{name}: it matters", 0.01 / self.runner.difference(twin, columns(law, cells=cells)), 1.0

    def refused(self) -> Checks:
        def reason(wanted: harmos.Scene, words: str) -> tuple[str, float, float]:
            code, message = self.runner.run(wanted)
            is_right = code == 2 and words in message
            return f"{words!r}" + ("" if is_right else f" is not in {code}: {message}"), float(not is_right), 0.5

        def with_law(law: dict[str, Any]) -> harmos.Scene:
            wanted = block([4.0, 2.0, 1.0])
            wanted["Boundaries/load"] = {"Side Set": "block_xmax", "Law": law}
            return wanted

        plane = {"Type": "Rigid Plane", "Point": [5.0, 0.0, 0.0], "Normal": [-1.0, 0.0, 0.0], "Friction Coefficient": 0.2}
        cylindrical = {"Type": "Cylindrical Displacement", "Radial": 0.1}
        iwan = {"Type": "Parallel Iwan", "Stiffnesses": [2.0, 1.0], "Slip Limits": [1.0, 1.0]}
        yield reason(with_law({"Type": "Nodal Force", "X": 1.0, "X Formula": "1 + r"}), 'uses "r", which is no place or time')
        yield reason(with_law({"Type": "Nodal Force", "X": 1.0, "X Formula": "log(y)"}), "has no finite value")
        yield reason(with_law({**cylindrical, "Tangential Formula": "x"}), 'there is no "Tangential" that it multiplies')
        yield reason(with_law({**cylindrical, "Radial Field": "map"}), '"map" is not in the list Fields')
        yield reason(with_law({**plane, "Friction Coefficient Formula": "y - 1"}),
                     "the formula makes Friction Coefficient = -0.2 at (5, 0, 0)")
        yield reason(with_law({**plane, "X": 1.0, "X Formula": "y"}), "X Formula")
        yield reason(with_law({**iwan, "Slip Limits Formula": "1 - y"}), "number 1 of Slip Limits")
        yield reason(with_law({**iwan, "Slip Limits Formula": "1 + t"}), "does not vary over the load steps")


if __name__ == "__main__":
    sys.exit(run_cases(Cases, lambda program, folder: Cases(Runner(program, folder))))
