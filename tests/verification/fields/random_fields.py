#!/usr/bin/env python3
"""Random fields over interfaces in studies, against closed forms and against each other.

  random_fields.py --harmos build/drivers/harmos [--only CASE]

A block in the plane, 4 x 1, on a face that follows a random field. Exit code 1: a moment differs from its reference, or a
field without sense is not refused with its reason.
"""
import csv
import math
import pathlib
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import harmos
from cases import run_cases

LENGTH, VARIATION, ACCURACY = 4.0, 0.3, 1e-7
Checks = Iterator[tuple[str, float, float]]


def field(terms: int, **entries: Any) -> dict[str, Any]:
    return {"Type": "Random", "Covariance": "Exponential", "Correlation Length": 2.0,
            "Coefficient of Variation": VARIATION, "Coefficients": {f"xi_{k + 1}": 0.0 for k in range(terms)}, **entries}


def block(rough: dict[str, Any], law: str = "top/Law/Pressure", cells: int = 80) -> harmos.Scene:
    scene = harmos.Scene("block", {
        "Mesh": {"Type": "Boxes", "Boxes": {"block": {
            "Lower Corner": [0.0, 0.0], "Upper Corner": [LENGTH, 1.0], "Cells": [float(cells), 2.0]}}},
        "Materials": {"m": {"Type": "Isotropic", "Young's Modulus": 1000.0, "Poisson's Ratio": 0.3}},
        "Parts": {"block": {"Material": "m"}},
        "Boundaries": {
            "ground": {"Side Set": "block_ymin", "Law": {
                "Type": "Elastic Foundation", "Normal Stiffness": 50.0, "Tangential Stiffness": 20.0}},
            "top": {"Side Set": "block_ymax", "Law": {"Type": "Pressure", "Pressure": 2.0}}},
        "Steps": {"load": {"Increments": 1}},
        "Fields": {"rough": rough},
        "Solver": {"Accuracy": ACCURACY, "Mesh Error": False},
        "Responses": {"force": {"Type": "Interface Force", "Interface": "top", "Direction": [0.0, 1.0]},
                      "move": {"Type": "Mean Displacement", "Side Set": "block_ymax", "Direction": [0.0, 1.0]},
                      "end": {"Type": "Point Displacement", "Point": [LENGTH, 1.0], "Direction": [0.0, 1.0]}}})
    scene[f"Boundaries/{law} Field"] = "rough"
    return scene


def study(terms: int, design: dict[str, Any]) -> harmos.StudyInput:
    normal = {"Type": "Normal", "Mean": 0.0, "Standard Deviation": 1.0}
    return harmos.StudyInput("vary", {
        "Scene": "block.xml",
        "Parameters": {f"xi_{k + 1}": {"Entry": f"Fields/rough/Coefficients/xi_{k + 1}", "Distribution": normal}
                       for k in range(terms)},
        "Design": design,
        "Responses": {name: {"Type": "Final", "Response": name} for name in ("force", "move", "end")}})


class Cases:
    """Each yields (what, found, largest that is allowed)."""

    def __init__(self, program: str, folder: pathlib.Path) -> None:
        self.program, self.folder = program, folder

    def _call(self, verb: str, name: str, *launcher: str) -> tuple[int, str]:
        done = subprocess.run([*launcher, self.program, verb, str(self.folder / name), "--quiet", "--output",
                               str(self.folder)], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def _moments(self, scene: harmos.Scene, terms: int, *launcher: str, **design: Any) -> dict[str, tuple[float, float]]:
        for old in self.folder.glob("vary*"):
            old.unlink()
        scene.write(self.folder / "block.xml")
        study(terms, design).write(self.folder / "vary.xml")
        code, message = self._call("study", "vary.xml", *launcher)
        if code != 0:
            raise RuntimeError(f"exit code {code}: {message}")
        with open(self.folder / "vary_moments.csv", newline="") as file:
            return {row["response"]: (float(row["mean"]), float(row["std"])) for row in csv.DictReader(file)}

    def force(self) -> Checks:
        """The mean of a field with exp(-d/l) has the variance 2 (l/L)^2 (L/l - 1 + exp(-L/l))."""
        ratio = 2.0 / LENGTH
        share = 2 * ratio ** 2 * (1 / ratio - 1 + math.exp(-1 / ratio))
        expected = 2.0 * LENGTH * VARIATION * math.sqrt(share)
        scene = block(field(9, **{"Distribution": "Normal", "Energy Share": 0.95}))
        for design in ({"Type": "Chaos", "Order": 1}, {"Type": "Collocation", "Points In": "Sparse", "Order": 1}):
            mean, deviation = self._moments(scene, 9, **design)["force"]
            yield f"{design['Type']}: mean", abs(abs(mean) / (2.0 * LENGTH) - 1), 1e-5
            yield f"{design['Type']}: standard deviation", abs(deviation / expected - 1), 5e-3

    def stiffness(self) -> Checks:
        """Expanded fields and collocation find the same moments."""
        rough = field(2, **{"Covariance": "Gaussian", "Correlation Length": 4.0})
        scene = block(rough, "ground/Law/Normal Stiffness", 8)
        one = self._moments(scene, 2, Type="Chaos", Order=6)
        other = self._moments(scene, 2, Type="Collocation", **{"Points In": "Tensor", "Order": 6})
        ranks = self._moments(scene, 2, "mpirun", "-np", "2", Type="Chaos", Order=6)
        for name in ("move", "end"):
            for which, words in enumerate(("mean", "standard deviation")):
                scale = one[name][1]
                yield f"{words} of {name}", abs(one[name][which] - other[name][which]) / scale, 1e-3
                yield f"{words} of {name}, two ranks", abs(one[name][which] - ranks[name][which]) / scale, 1e-4
        yield "it varies", 1e-3 / (one["end"][1] / abs(one["end"][0])), 0.1

    def draws(self) -> Checks:
        """A configuration is the scene with its coefficients, whatever the pieces."""
        rough = field(3, **{"Covariance": "Gaussian", "Correlation Length": 3.0})
        whole, cut = block(rough), block(rough)
        cut["Parts/block/Pieces"] = 3
        ends = []
        for scene in (whole, cut):
            for k, xi in enumerate((0.7, -1.1, 0.4)):
                scene[f"Fields/rough/Coefficients/xi_{k + 1}"] = xi
            scene.write(self.folder / "block.xml")
            code, message = self._call("run", "block.xml")
            if code != 0:
                raise RuntimeError(message)
            ends.append(float((self.folder / "block_history.csv").read_text().split()[-1].split(",")[4]))
        yield "cut parts", abs(ends[1] / ends[0] - 1), 1e-5

    def twins(self) -> Checks:
        """Laws with axes of their own, forces on nodes, tools and lists, against others that follow the same field."""
        def other(law: dict[str, Any], place: str = "top") -> harmos.Scene:
            scene = block(field(2, **{"Covariance": "Gaussian", "Correlation Length": 4.0}), cells=8)
            del scene["Boundaries/top/Law/Pressure Field"]
            scene[f"Boundaries/{place}/Law"] = law
            return scene

        along = {"Type": "Prescribed Displacement", "X": 0.0, "Y": -0.01, "Y Field": "rough"}
        about = {"Type": "Cylindrical Displacement", "Point": [-3.0, -1.0], "Radial": -0.01, "Tangential": -0.01,
                 "Radial Formula": "2 / sqrt((x + 3)^2 + 4)", "Tangential Formula": "(x + 3) / sqrt((x + 3)^2 + 4)",
                 "Radial Field": "rough", "Tangential Field": "rough"}
        per_area = {"Type": "Prescribed Traction", "Y": -2.0, "Y Field": "rough"}
        on_nodes = {"Type": "Nodal Force", "Y": -1.0, "Y Formula": "x < 0.1 || x > 3.9 ? 0.5 : 1", "Y Field": "rough"}
        friction = {"Friction Coefficient": 0.2, "Friction Coefficient Field": "rough"}
        contact = {"Type": "Coulomb Friction", **friction}
        tool = {"Type": "Rigid Plane", "Point": [0.0, 0.0], "Normal": [0.0, 1.0], **friction}
        spring = {"Type": "Elastic Foundation", "Normal Stiffness": 50.0, "Tangential Stiffness": 20.0,
                  "Tangential Stiffness Field": "rough"}
        iwan = {"Type": "Parallel Iwan", "Normal Stiffness": 50.0, "Stiffnesses": [15.0, 5.0], "Stiffnesses Field": "rough",
                "Slip Limits": [1e9, 1e9]}
        formula = {"Type": "Formula", "Fields": ["rough"], "Constants": {"k": 20.0}, "Normal Traction": "50 * jump_n",
                   "Tangential Traction 1": "k * rough * jump_1"}
        drag = {"Type": "Prescribed Traction", "X": 0.1, "Y": -2.0}
        chaos, collocation = {"Type": "Chaos", "Order": 2}, {"Type": "Collocation", "Points In": "Tensor", "Order": 3}
        for what, one, two, place, design in (
                ("about an axis", along, about, "top", chaos), ("about an axis", along, about, "top", collocation),
                ("forces on nodes", per_area, on_nodes, "top", chaos), ("a tool", contact, tool, "ground", collocation),
                ("a list", spring, iwan, "ground", collocation), ("a formula", spring, formula, "ground", collocation),
                ("a formula", spring, formula, "ground", chaos)):
            scenes = [other(law, place) for law in (one, two)]
            for scene in scenes:
                if place == "ground":
                    scene["Boundaries/top/Law"] = drag
                    scene["Responses/end/Direction"] = [1.0, 0.0]
            expected, found = (self._moments(scene, 2, **design) for scene in scenes)
            for name in ("force", "end"):
                scale = max(abs(expected[name][0]), expected[name][1])
                worst = max(abs(a - b) for a, b in zip(expected[name], found[name]))
                yield f"{what}, {design['Type']}: {name}", worst / scale, 20 * ACCURACY
            yield f"{what}: it varies", 1e-3 / (expected["end"][1] / abs(expected["end"][0])), 1.0

    def lengths(self) -> Checks:
        """Points further apart than the correlation length are named, with both lengths; others are not."""
        sentence = 'Correlation Length: it is 0.3, but points of "top" lie up to 0.5 apart'
        for cells, isCoarse in ((8, True), (80, False)):
            block(field(2, **{"Correlation Length": 0.3, "Energy Share": 0.0}), cells=cells).write(self.folder / "block.xml")
            done = subprocess.run([self.program, "check", str(self.folder / "block.xml")], capture_output=True, text=True,
                                  check=False)
            said = done.stdout + done.stderr
            isWrong = (sentence in said) != isCoarse
            yield f"{cells} cells{': ' + said if isWrong else ''}", float(isWrong), 0.5

    def studies(self) -> Checks:
        """A configuration of a study is the run with its draw, and all share their operators."""
        for law, effect in (("ground/Law/Normal Stiffness", "local stage only, all operators stay"),
                            ("top/Law/Pressure", "loads, all operators stay")):
            scene = block(field(2, **{"Covariance": "Gaussian", "Correlation Length": 4.0}), law, 8)
            scene.write(self.folder / "block.xml")
            varied = harmos.StudyInput("vary", {
                "Scene": "block.xml",
                "Parameters": {"xi": {"Entry": "Fields/rough/Coefficients/xi_2", "Values": [-1.0, 0.5]}},
                "Responses": {"end": {"Type": "Final", "Response": "end"}}})
            varied.write(self.folder / "vary.xml")
            said = subprocess.run([self.program, "check", str(self.folder / "vary.xml")], capture_output=True, text=True,
                                  check=False).stdout
            yield f"{effect}: {said if effect not in said else ''}", float(effect not in said), 0.5
            code, message = self._call("study", "vary.xml")
            if code != 0:
                raise RuntimeError(message)
            table = harmos.read_study(self.folder / "vary.h5").table()
            for xi in (-1.0, 0.5):
                scene["Fields/rough/Coefficients/xi_2"] = xi
                scene.write(self.folder / "block.xml")
                code, message = self._call("run", "block.xml")
                if code != 0:
                    raise RuntimeError(message)
                alone = float((self.folder / "block_history.csv").read_text().split()[-1].split(",")[4])
                yield f"{law}, draw {xi:g}", abs(table["end"][table["xi"] == xi][0] / alone - 1), 1e-5
            for old in self.folder.glob("vary*"):
                old.unlink()

    def derivatives(self) -> Checks:
        """With respect to coefficients, beside differences of runs."""
        entry = "Fields/rough/Coefficients/xi_2"

        def end(scene: harmos.Scene, xi: float) -> float:
            scene[entry] = xi
            scene.write(self.folder / "block.xml")
            code, message = self._call("run", "block.xml")
            if code != 0:
                raise RuntimeError(message)
            return float((self.folder / "block_history.csv").read_text().split()[-1].split(",")[4])

        for law in ("ground/Law/Normal Stiffness", "top/Law/Pressure"):
            scene = block(field(2, **{"Covariance": "Gaussian", "Correlation Length": 4.0}), law, 8)
            scene["Solver/Accuracy"] = 1e-9
            difference = (end(scene, 0.301) - end(scene, 0.299)) / 0.002
            scene["Output"] = {"Derivatives": [entry]}
            end(scene, 0.3)
            with open(self.folder / "block_derivatives.csv", newline="") as file:
                found = next(float(row["derivative"]) for row in csv.DictReader(file) if row["response"] == "end")
            yield law, abs(found / difference - 1), 1e-5

    def refused(self) -> Checks:
        def reason(scene: harmos.Scene, words: str) -> tuple[str, float, float]:
            scene.write(self.folder / "block.xml")
            code, message = self._call("run", "block.xml")
            is_right = code == 2 and words in message
            return f"{words!r}" + ("" if is_right else f" is not in {code}: {message}"), float(not is_right), 0.5

        yield reason(block(field(1, **{"Energy Share": 0.95})), "1 terms hold")
        yield reason(block(field(9, **{"Covariance": "Gaussian", "Correlation Length": 100.0}), cells=2), "the field has")
        yield reason(block(field(2, **{"Correlation Length": 0.0})), "above 0")
        other = block(field(9))
        other["Boundaries/top/Law/Pressure Field"] = "ruogh"
        yield reason(other, 'Did you mean "rough"?')


if __name__ == "__main__":
    sys.exit(run_cases(Cases, Cases))
