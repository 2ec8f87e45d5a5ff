#!/usr/bin/env python3
"""Numbers of laws that follow variables of the mesh file, against the same fields by formulas.

  mesh_fields.py --harmos build/drivers/harmos [--only CASE]

Two blocks on each other; the lower one is held, the upper one loaded. Exit code 1: a run with a variable differs from
the one with the formula, or a field without sense is not refused with its reason.
"""
import pathlib
import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any

import netCDF4
import numpy

import harmos
from cases import run_cases

Place = Callable[[Any, Any, Any, float], Any]
"""Value of a variable at x, y, z and the time."""
ACCURACY = 1e-6
SAME = 20 * ACCURACY  # two runs, both within the accuracy


def box(low: float, high: float, cells: list[float], element: str, size: int) -> dict[str, Any]:
    return {"Lower Corner": [0.0, 0.0, low][:size - 1] + [low], "Upper Corner": [4.0, 2.0, high][:size - 1] + [high],
            "Cells": cells[:size], "Element": element}


def scene(element: str = "Hex8", lower: list[float] | None = None) -> harmos.Scene:
    """Blocks of 4 x 2 x 1, in the plane of 4 x 1."""
    size = 2 if element in ("Quad4", "Quad8", "Tri6") else 3
    zero = {name: 0.0 for name in "XYZ"[:size]}
    up = "ymin", "ymax"
    if size == 3:
        up = "zmin", "zmax"
    return harmos.Scene("blocks", {
        "Mesh": {"Type": "Boxes", "Boxes": {"lower": box(0.0, 1.0, lower or [4.0, 2.0, 1.0], element, size),
                                            "upper": box(1.0, 2.0, [4.0, 2.0, 1.0], element, size)}},
        "Materials": {"m": {"Type": "Isotropic", "Young's Modulus": 1000.0, "Poisson's Ratio": 0.3}},
        "Parts": {"lower": {"Material": "m"}, "upper": {"Material": "m"}},
        "Interfaces": {"joint": {"Side 1": f"lower_{up[1]}", "Side 2": f"upper_{up[0]}", "Law": {
            "Type": "Linear Elastic", "Normal Stiffness": 500.0, "Tangential Stiffness": 300.0}}},
        "Boundaries": {"ground": {"Side Set": f"lower_{up[0]}", "Law": {"Type": "Prescribed Displacement", **zero}},
                       "load": {"Side Set": f"upper_{up[1]}", "Law": {"Type": "Pressure", "Pressure": 1.0}}},
        "Steps": {"load": {"Duration": 2.0, "Increments": 4}},
        "Solver": {"Accuracy": ACCURACY, "Mesh Error": False},
        "Responses": {
            **{f"move_{c}": {"Type": "Mean Displacement", "Side Set": f"upper_{up[1]}",
                             "Direction": [float(c == d) for d in "xyz"[:size]]} for c in "xyz"[:size]},
            "force": {"Type": "Interface Force", "Interface": "load", "Direction": [0.0, 0.0, 1.0][-size:]},
            "peak": {"Type": "Maximum", "Interfaces": ["joint"], "Field": "Normal Traction"}},
    })


def add_variable(path: pathlib.Path, name: str, value: Place, times: tuple[float, ...] = (0.0,),
                 elements: bool = False) -> None:
    """Adds a variable of nodes, or of elements at their centres, to an Exodus file without any."""
    with netCDF4.Dataset(path, "a") as file:
        nodes = numpy.array([file[f"coord{c}"][:] if f"coord{c}" in file.variables
                             else numpy.zeros(len(file.dimensions["num_nodes"])) for c in "xyz"])
        kind = "elem" if elements else "nod"
        for key, size in (("len_name", 256), (f"num_{kind}_var", 1)):
            if key not in file.dimensions:
                file.createDimension(key, size)
        names = file.createVariable(f"name_{kind}_var", "S1", (f"num_{kind}_var", "len_name"))
        names[0] = numpy.array(list(name.ljust(len(file.dimensions["len_name"]), "\0")), dtype="S1")
        if "time_whole" not in file.variables:
            if "time_step" not in file.dimensions:
                file.createDimension("time_step", None)
            file.createVariable("time_whole", "f8", ("time_step",))
        file["time_whole"][:] = times
        blocks = range(1, len(file.dimensions["num_el_blk"]) + 1)
        targets = [(f"vals_elem_var1eb{b}", f"num_el_in_blk{b}", file[f"connect{b}"][:] - 1) for b in blocks]
        for variable, dimension, connectivity in targets if elements else [("vals_nod_var1", "num_nodes", None)]:
            values = file.createVariable(variable, "f8", ("time_step", dimension))
            places = nodes if connectivity is None else nodes[:, connectivity].mean(axis=2)
            for step, time in enumerate(times):
                values[step] = value(*places, time) * numpy.ones(places.shape[1])


class Runner:
    """Runs scenes in a folder of its own.

    Attributes:
        folder: where all files are.
    """

    def __init__(self, program: str, folder: pathlib.Path) -> None:
        self.program, self.folder = program, folder

    def run(self, wanted: harmos.Scene, *launcher: str) -> tuple[int, str]:
        path = self.folder / "blocks.xml"
        wanted.write(path)
        done = subprocess.run([*launcher, self.program, "run", str(path), "--quiet", "--output", str(self.folder)],
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def history(self, wanted: harmos.Scene, *launcher: str) -> dict[str, Any]:
        code, message = self.run(wanted, *launcher)
        if code != 0:
            raise RuntimeError(message)
        header, *rows = (self.folder / "blocks_history.csv").read_text().split()
        columns = numpy.array([[float(number) for number in row.split(",")] for row in rows]).T
        return dict(zip(header.split(","), columns))

    def on_file(self, wanted: harmos.Scene, name: str, value: Place, **options: Any) -> None:
        """Gives a scene its own mesh in a file with a variable."""
        path = self.folder / "blocks.xml"
        wanted.write(path)
        subprocess.run([self.program, "mesh", str(path), "--output", str(self.folder / "blocks_mesh.e"), "--quiet"],
                       check=True)
        add_variable(self.folder / "blocks_mesh.e", name, value, **options)
        wanted["Mesh"] = {"Type": "Exodus", "File": "blocks_mesh.e"}

    def difference(self, followed: harmos.Scene, formula: harmos.Scene, *launcher: str) -> float:
        """The largest difference of the curves of two scenes, relative to the largest value of each."""
        one, other = self.history(followed, *launcher), self.history(formula)
        return max(float(abs(one[name] - curve).max() / max(abs(curve).max(), 1e-12)) if name != "time" else 0.0
                   for name, curve in other.items() if abs(curve).max() > 1e-9)


def with_field(base: harmos.Scene, law: str, number: str, name: str, **entries: Any) -> harmos.Scene:
    base[f"{law}/Law/{number} Field"] = "map"
    base["Fields"] = {"map": {"Type": "Mesh Variable", "Variable": name, **entries}}
    return base


def dragged(**options: Any) -> harmos.Scene:
    """The blocks under a body force along x of the upper one, which follows a history."""
    wanted = scene(**options)
    wanted["Parts/upper/Body Force"] = {"X": 0.4, "X History": "swing", "Y": -0.1}
    wanted["Histories"] = {"swing": {"Type": "Formula", "Formula": "sin(t)"}}
    return wanted


GLUE, NUMBER = "Interfaces/joint", "Normal Stiffness"


def by_formula(formula: str, law: str = GLUE, number: str = NUMBER, **options: Any) -> harmos.Scene:
    wanted = scene(**options)
    wanted[f"{law}/Law/{number} Formula"] = formula
    return wanted


class Cases:
    """Each yields (what, found, largest that is allowed)."""

    def __init__(self, runner: Runner) -> None:
        self.runner = runner

    def _compare(self, formula: str, value: Place, what: str, law: str = GLUE, number: str = NUMBER,
                entries: dict[str, Any] | None = None, launcher: tuple[str, ...] = (),
                change: dict[str, Any] | None = None, file: dict[str, Any] | None = None,
                **options: Any) -> Iterator[tuple[str, float, float]]:
        followed, expected = scene(**options), by_formula(formula, law, number, **options)
        self.runner.on_file(followed, "map", value, **(file or {}))
        with_field(followed, law, number, "map", **(entries or {}))
        for path, entry in (change or {}).items():
            followed[path] = entry
        yield what, self.runner.difference(followed, expected, *launcher), SAME

    def linear(self) -> Iterator[tuple[str, float, float]]:
        yield from self._compare("1 + x + y", lambda x, y, z, t: 1 + x + y, "glue")
        yield from self._compare("1 + x * y", lambda x, y, z, t: 1 + x * y, "pressure", "Boundaries/load", "Pressure")
        yield from self._compare("1 + x", lambda x, y, z, t: 1 + x, "plane", element="Quad4")

    def pieces(self) -> Iterator[tuple[str, float, float]]:
        cut = {"Parts/lower/Pieces": 3, "Parts/upper/Pieces": 2}
        yield from self._compare("1 + x + y", lambda x, y, z, t: 1 + x + y, "cut parts", change=cut)
        yield from self._compare("1 + x + y", lambda x, y, z, t: 1 + x + y, "two ranks", change=cut,
                                launcher=("mpirun", "-np", "2"))

    def quadratic(self) -> Iterator[tuple[str, float, float]]:
        yield from self._compare("1 + x^2", lambda x, y, z, t: 1 + x ** 2, "hexahedra", element="Hex20")
        yield from self._compare("1 + x^2", lambda x, y, z, t: 1 + x ** 2, "tetrahedra", element="Tet10")
        yield from self._compare("1 + x^2", lambda x, y, z, t: 1 + x ** 2, "plane", element="Quad8")

    def not_matching(self) -> Iterator[tuple[str, float, float]]:
        for part in ("lower", "upper"):
            yield from self._compare("1 + x - y / 3", lambda x, y, z, t: 1 + x - y / 3, f"map of {part}",
                                    entries={"Part": part}, lower=[3.0, 3.0, 1.0])
        yield from self._compare("1 + x - y / 3", lambda x, y, z, t: 1 + x - y / 3, "map of both", lower=[3.0, 3.0, 1.0])

    def one_part(self) -> Iterator[tuple[str, float, float]]:
        yield from self._compare("1 + x", lambda x, y, z, t: (1 + x) * (z > 1.5), "top", "Boundaries/load", "Pressure",
                                entries={"Part": "upper"})

    def elements(self) -> Iterator[tuple[str, float, float]]:
        constant: Place = lambda x, y, z, t: numpy.where(z < 1, 2.0, 7.0)
        for part, value in (("lower", 2), ("upper", 7)):
            yield from self._compare(f"{value}", constant, f"those of {part}", entries={"Part": part},
                                    file={"elements": True})
        # Inside of the surface the mean of four linear values is that of the node; at its edges half a cell is missing.
        followed = scene()
        self.runner.on_file(followed, "map", lambda x, y, z, t: 1 + x, elements=True)
        with_field(followed, "Boundaries/load", "Pressure", "map")
        expected = by_formula("x < 0.5 ? 1.5 : x > 3.5 ? 4.5 : 1 + x", "Boundaries/load", "Pressure")
        yield "linear", self.runner.difference(followed, expected), SAME

    def _drag(self, formula: str, value: Place, what: str, entries: dict[str, Any] | None = None,
              file: dict[str, Any] | None = None, change: dict[str, Any] | None = None, launcher: tuple[str, ...] = (),
              **options: Any) -> Iterator[tuple[str, float, float]]:
        followed, expected = dragged(**options), dragged(**options)
        self.runner.on_file(followed, "map", value, **(file or {}))
        followed["Parts/upper/Body Force/X Field"] = "map"
        followed["Fields"] = {"map": {"Type": "Mesh Variable", "Variable": "map", **(entries or {})}}
        expected["Parts/upper/Body Force/X Formula"] = formula
        for path, entry in (change or {}).items():
            followed[path] = entry
        yield what, self.runner.difference(followed, expected, *launcher), SAME

    def inside(self) -> Iterator[tuple[str, float, float]]:
        """Body forces, inside of elements."""
        yield from self._drag("1 + x * y - z", lambda x, y, z, t: 1 + x * y - z, "hexahedra")
        yield from self._drag("1 + x - z", lambda x, y, z, t: 1 + x - z, "pieces on two ranks",
                              change={"Parts/upper/Pieces": 3}, launcher=("mpirun", "-np", "2"))
        yield from self._drag("1 + x^2", lambda x, y, z, t: 1 + x ** 2, "quadratic", element="Tet10")
        yield from self._drag("1 + x", lambda x, y, z, t: 1 + x, "plane", element="Quad4")
        yield from self._drag("x < 1 ? 0.5 : x < 2 ? 1.5 : x < 3 ? 2.5 : 3.5", lambda x, y, z, t: x, "of elements",
                              file={"elements": True})
        yield from self._drag("(1 + x) * (1 + t)", lambda x, y, z, t: (1 + x) * (1 + t), "in time",
                              entries={"Follows Time": True}, file={"times": (0.0, 1.0, 3.0)})

    def time(self) -> Iterator[tuple[str, float, float]]:
        times = (0.0, 1.0, 3.0)
        value: Place = lambda x, y, z, t: (1 + x) * (1 + t)
        yield from self._compare("(1 + x) * (1 + t)", value, "followed", "Boundaries/load", "Pressure",
                                entries={"Follows Time": True}, file={"times": times})
        yield from self._compare("(1 + x) * 2", value, "chosen", entries={"Time Step": 2}, file={"times": times})
        yield from self._compare("(1 + x) * 4", value, "the last", file={"times": times})

    def formulas(self) -> Iterator[tuple[str, float, float]]:
        """The law "Formula" reads the field itself, also where it follows time."""
        value: Place = lambda x, y, z, t: (1 + x) * (1 + t)
        for what, entries, factor in (("at a time", {"Time Step": 2}, "2 * (1 + x)"),
                                      ("in time", {"Follows Time": True}, "(1 + x) * (1 + t)")):
            tangential = {f"Tangential Traction {c}": f"300 * jump_{c}" for c in (1, 2)}
            followed, expected = scene(), scene()
            self.runner.on_file(followed, "map", value, times=(0.0, 1.0, 3.0))
            followed["Interfaces/joint/Law"] = {"Type": "Formula", "Fields": ["map"], "Constants": {"k": 500.0},
                                                "Normal Traction": "k * map * jump_n", **tangential}
            followed["Fields"] = {"map": {"Type": "Mesh Variable", "Variable": "map", **entries}}
            expected["Interfaces/joint/Law"] = {"Type": "Formula", "Normal Traction": f"500 * {factor} * jump_n",
                                                **tangential}
            yield what, self.runner.difference(followed, expected), SAME

    def with_others(self) -> Iterator[tuple[str, float, float]]:
        """Beside a formula and a history, each multiplies."""
        history = {"half": {"Type": "Table", "Times": [0.0, 2.0], "Values": [0.0, 0.5]}}
        followed, expected = scene(), by_formula("(1 + x) * (1 + y)", "Boundaries/load", "Pressure")
        self.runner.on_file(followed, "map", lambda x, y, z, t: 1 + x)
        with_field(followed, "Boundaries/load", "Pressure", "map")
        followed["Boundaries/load/Law/Pressure Formula"] = "1 + y"
        for one in (followed, expected):
            one["Histories"] = history
            one["Boundaries/load/Law/Pressure History"] = "half"
        yield "product", self.runner.difference(followed, expected), SAME

    def plane(self) -> Iterator[tuple[str, float, float]]:
        """On a plane through a part; elements on both sides of it count."""
        def cut(**options: Any) -> harmos.Scene:
            wanted = scene(**options)
            wanted["Interfaces/cut"] = {"Part": "upper", "Point": [2.0, 0.0, 1.5], "Normal": [1.0, 0.0, 0.0],
                                        "Law": {"Type": "Preload Jump", "Jump": 0.01}}
            return wanted

        def elements(x: Any, *_: Any) -> Any:
            return numpy.where(x < 2, 1.0, 3.0)

        for formula, value, is_element in (("1 + y", lambda x, y, z, t: 1 + y, False), ("2", elements, True)):
            followed, expected = cut(), cut()
            self.runner.on_file(followed, "map", value, elements=is_element)
            with_field(followed, "Interfaces/cut", "Jump", "map", Part="upper")
            expected["Interfaces/cut/Law/Jump Formula"] = formula
            yield formula, self.runner.difference(followed, expected), SAME

    def study(self) -> Iterator[tuple[str, float, float]]:
        """A configuration of a study is the run with its number."""
        followed = scene()
        self.runner.on_file(followed, "map", lambda x, y, z, t: 1 + x)
        with_field(followed, GLUE, NUMBER, "map").write(self.runner.folder / "blocks.xml")
        values = [100.0, 400.0]
        study = harmos.StudyInput("vary", {
            "Scene": "blocks.xml",
            "Parameters": {"k": {"Entry": f"{GLUE}/Law/{NUMBER}", "Values": values}},
            "Design": {"Type": "Grid"},
            "Responses": {"move": {"Type": "Final", "Response": "move_z"}}})
        study.write(self.runner.folder / "vary.xml")
        done = subprocess.run([self.runner.program, "study", str(self.runner.folder / "vary.xml"), "--quiet", "--output",
                               str(self.runner.folder)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)
        table = harmos.read_study(self.runner.folder / "vary.h5").table()
        for value in values:
            followed[f"{GLUE}/Law/{NUMBER}"] = value
            alone = self.runner.history(followed)["move_z"][-1]
            found = table["move"][table["k"] == value][0]
            yield f"k = {value:g}", abs(found - alone) / abs(alone), SAME

    def refused(self) -> Iterator[tuple[str, float, float]]:
        def reason(wanted: harmos.Scene, words: str) -> tuple[str, float, float]:
            code, message = self.runner.run(wanted)
            is_right = code == 2 and words in message
            return f"{words!r}" + ("" if is_right else f" is not in {code}: {message}"), float(not is_right), 0.5

        def on_file(value: Place = lambda x, y, z, t: 1 + x, **entries: Any) -> harmos.Scene:
            wanted = scene()
            self.runner.on_file(wanted, "gap_map", value, times=(0.0, 1.0))
            return with_field(wanted, GLUE, NUMBER, entries.pop("Variable", "gap_map"), **entries)

        yield reason(on_file(Variable="gapmap"), 'Did you mean "gap_map"?')
        yield reason(on_file(**{"Time Step": 3}), "has 2 time steps; number 3 is asked for")
        yield reason(on_file(**{"Part": "uper"}), 'Did you mean "upper"?')
        yield reason(on_file(**{"Follows Time": True}), "the load steps end at times from 0.5 to 2, the file has times")
        yield reason(on_file(lambda x, y, z, t: numpy.where(z < 1.5, 1.0 + (z < 1), 1.0) + numpy.arange(len(z)) / 9),
                     "have different values")
        yield reason(on_file(lambda x, y, z, t: x - 1), "the field makes Normal Stiffness = -500 at (0, 0, 1)")
        yield reason(with_field(scene(), GLUE, NUMBER, "map"), "a generated mesh has no variables")
        other = on_file()
        other[f"{GLUE}/Law/{NUMBER} Field"] = "mapp"
        yield reason(other, 'Did you mean "map"?')
        fixed = on_file(**{"Follows Time": True})
        fixed["Steps/load/Duration"] = 1.0
        fixed[f"{GLUE}/Law"] = {"Type": "Jenkins", "Tangential Stiffness": 10.0, "Slip Limit": 1.0,
                                "Slip Limit Field": "map"}
        yield reason(fixed, "does not vary over the load steps")
        lone = on_file()
        lone[f"{GLUE}/Law"] = {"Type": "Compliant Contact", "Normal Stiffness": 10.0, "Shear Limit Field": "map"}
        yield reason(lone, 'there is no "Shear Limit" that it multiplies')


if __name__ == "__main__":
    sys.exit(run_cases(Cases, lambda program, folder: Cases(Runner(program, folder))))
