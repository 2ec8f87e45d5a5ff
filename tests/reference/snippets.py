#!/usr/bin/python3
"""Runs every law and every response of the reference as its snippet says it, holds the variables of the result files
against those that the reference names, and laws that join two parts on meshes that do not match against the same on meshes that do.

  snippets.py --harmos build/drivers/harmos [--only NAME]

Exit code 1: a law has no equation, a snippet does not run, a variable is not documented, or a law carries another force on meshes
that do not match.
"""
import argparse
import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import netCDF4

import harmos

LAWS = ("Law", "Harmos / Interfaces / (your name) / Law, Type = ")
RESPONSES = ("your name", "Harmos / Responses / (your name), Type = ")

# Of the force from the same on meshes that match, over the force of the rigid joint: the cells of one block differ.
FORCE_ERROR = 2e-3


def box(low: float, high: float) -> dict[str, list[float]]:
    return {"Lower Corner": [20.0, 0.0, low], "Upper Corner": [30.0, 10.0, high], "Cells": [2.0, 2.0, 2.0]}


def scene(boxes: dict[str, object], interfaces: dict[str, object], boundaries: dict[str, object],
          responses: dict[str, object]) -> harmos.Scene:
    return harmos.Scene("example", {
        "Units": "mm N s",
        "Mesh": {"Type": "Boxes", "Boxes": boxes},
        "Materials": {"steel": {"Type": "Isotropic", "Young's Modulus": 2.1e5, "Poisson's Ratio": 0.3}},
        "Parts": {name: {"Material": "steel"} for name in boxes},
        "Interfaces": interfaces,
        "Boundaries": {"ground": {"Side Set": "lower_zmin", "Law": {
            "Type": "Prescribed Displacement", "X": 0.0, "Y": 0.0, "Z": 0.0}}, **boundaries},
        "Steps": {"load": {"Increments": 2}},
        "Output": {"Nodal Stress": True},
        "Responses": responses,
    })


def with_law(law: harmos.scenes.Lists, is_interface: bool, responses: dict[str, object], cells: float = 2.0) -> harmos.Scene:
    """Two blocks, the upper one of so many cells each way pressed and dragged by its top; or one, with the law on top."""
    if not is_interface:
        return scene({"lower": box(0, 10)}, {}, {"joint": {"Side Set": "lower_zmax", "Law": law}}, responses)
    top = {"Type": "Prescribed Displacement", "X": 0.002, "Y": 0.0, "Z": -0.01}
    return scene({"lower": box(0, 10), "upper": {**box(10, 20), "Cells": [cells, cells, 2.0]}},
                 {"joint": {"Side 1": "lower_zmax", "Side 2": "upper_zmin", "Law": law}},
                 {"top": {"Side Set": "upper_zmax", "Law": top}}, responses)


class Reference:
    """What `harmos doc` prints.

    Attributes:
        sections: by heading.
    """

    def __init__(self, program: str) -> None:
        text = subprocess.run([program, "doc"], capture_output=True, text=True, check=True).stdout
        self.sections = {part.split("\n")[0]: part for part in re.split(r"^## ", text, flags=re.MULTILINE)[1:]}

    def forms(self, start: str) -> dict[str, str]:
        return {heading.removeprefix(start): text for heading, text in self.sections.items()
                if heading.startswith(start)}

    def variables(self) -> set[str]:
        return set(re.findall(r"`(\w+)`", "".join(
            line for line in self.sections["Outputs"].splitlines() if line.startswith("|"))))


def snippet(text: str, name: str) -> harmos.scenes.Lists:
    """The list of this name in a section of the reference."""
    found = re.search(rf'^    <ParameterList name="{name}">.*?^    </ParameterList>', text, re.DOTALL | re.MULTILINE)
    if not found:
        return {}
    values = {each.get("name", ""): harmos.scenes.TYPES[each.get("type", "")](each.get("value", ""))
              for each in ElementTree.fromstring(found[0])}
    return values


def variables_of(path: pathlib.Path) -> set[str]:
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        return {row.tobytes().split(b"\0")[0].decode() for kind in ("nod", "elem")
                if f"name_{kind}_var" in file.variables for row in file[f"name_{kind}_var"][:]}


def run(program: str, example: harmos.Scene, folder: pathlib.Path) -> tuple[int, str]:
    path = folder / "example.xml"
    example.write(path)
    done = subprocess.run([program, "run", str(path), "--quiet", "--output", str(folder)], capture_output=True,
                          text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def difference_apart(program: str, law: harmos.scenes.Lists, folder: pathlib.Path) -> float:
    """Between the forces that a law carries on meshes that do not match and on those that do, over that of the rigid joint."""
    response = {"pressed": {"Type": "Interface Force", "Interface": "ground", "Direction": [0.0, 0.0, 1.0]}}
    forces = []
    for each, cells in (({"Type": "Perfect"}, 2.0), (law, 2.0), (law, 3.0)):
        code, message = run(program, with_law(each, True, response, cells), folder)
        if code != 0:
            raise RuntimeError(f"exit code {code} with {cells:g} cells\n{message}")
        with open(folder / "example_history.csv", encoding="utf-8") as history:
            forces.append(float(list(csv.DictReader(history))[-1]["pressed"]))
    return float(abs(forces[2] - forces[1]) / abs(forces[0]))


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--harmos", required=True)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    reference = Reference(arguments.harmos)
    failures = []
    joining = []
    laws, responses = reference.forms(LAWS[1]), reference.forms(RESPONSES[1])
    runs = [(name, text, {}) for name, text in laws.items()]
    shown = {name: snippet(text, RESPONSES[0]) for name, text in responses.items()}
    runs.append(("all responses", laws["Coulomb Friction"], {name.lower(): each for name, each in shown.items()}))
    known = reference.variables()
    for name, text, wanted in runs:
        if arguments.only not in name:
            continue
        if "\nEquation: `" not in text:
            failures.append(f"{name}: no equation")
        law = snippet(text, LAWS[0])
        with tempfile.TemporaryDirectory() as there:
            folder = pathlib.Path(there)
            code, message = run(arguments.harmos, with_law(law, True, wanted), folder)
            if code == 2 and "an interface joins two" in message:
                code, message = run(arguments.harmos, with_law(law, False, wanted), folder)
            elif not wanted:
                joining.append((name, law))
            if code != 0:
                failures.append(f"{name}: exit code {code}\n{message}")
                continue
            for file in ("example.e", "example_interfaces.e"):
                missing = variables_of(folder / file) - known
                if missing:
                    failures.append(f"{name}: {file} has {', '.join(sorted(missing))}, which harmos doc Outputs has not")
    for name, law in joining:
        try:
            with tempfile.TemporaryDirectory() as there:
                apart = difference_apart(arguments.harmos, law, pathlib.Path(there))
        except RuntimeError as error:
            failures.append(f"{name}: {error}")
            continue
        if not apart <= FORCE_ERROR:
            failures.append(f"{name}: {apart:.1e} off on meshes that do not match")
    print(f"{len(laws)} laws, {len(joining)} of which were held against meshes that match, {len(responses)} responses")
    print("\n".join(failures) or "all run")
    return bool(failures or len(laws) < 20 or len(joining) < 20 or len(responses) < 10)


if __name__ == "__main__":
    sys.exit(main())
