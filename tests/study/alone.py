#!/usr/bin/python3
"""Configurations that those of a study cannot solve with operators in common: alone.py HARMOS WORK_DIR

Two blocks that are seven orders of magnitude stiffer than the glue between them are pulled apart. Their forces are small
differences of large numbers unless displacements are counted from the motion of the blocks, which is another one in every
configuration. A run does so, and so must the study: F = u / (1/k + 2 l/E) per area.
"""
import csv
import pathlib
import shutil
import subprocess
import sys

from checks import check, finish
from lists import entries, entry, law

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
MODULUS, WAY, ACCURACY = 1e8, 0.1, 1e-6
GLUES = (5.0, 8.0, 20.0)


def block(name, bottom):
    return entries(name, entry("Lower Corner", f"{{0, 0, {bottom}}}"), entry("Upper Corner", f"{{1, 1, {bottom + 1}}}"),
                   entry("Cells", "{2, 2, 2}"))


def held(name, side_set, way):
    return entries(name, entry("Side Set", side_set),
                   law("Prescribed Displacement", entry("X", 0.0), entry("Y", 0.0), entry("Z", way)))


def force(name, direction):
    return entries(name, entry("Type", "Interface Force"), entry("Interface", "pulled"), entry("Direction", direction))


SCENE = entries(
    "Harmos", entries("Values", entry("k", GLUES[0])),
    entries("Mesh", entry("Type", "Boxes"), entries("Boxes", block("a", 0), block("b", 1))),
    entries("Materials", entries("m", entry("Type", "Isotropic"), entry("Young's Modulus", MODULUS),
                                 entry("Poisson's Ratio", 0.0))),
    entries("Parts", entries("a", entry("Material", "m")), entries("b", entry("Material", "m"))),
    entries("Interfaces", entries("glue", entry("Part 1", "a"), entry("Part 2", "b"),
                                  law("Linear Elastic", entry("Normal Stiffness", "$k"),
                                      entry("Tangential Stiffness", "$k")))),
    entries("Boundaries", held("ground", "a_zmin", 0.0), held("pulled", "b_zmax", WAY)),
    entries("Steps", entries("pull")), entries("Solver", entry("Accuracy", ACCURACY)),
    entries("Responses", force("F", "{0, 0, 1}"), force("S", "{1, 0, 0}")))
STUDY = entries(
    "Harmos Study", entry("Scene", "blocks.xml"),
    entries("Parameters", entries("k", entry("Entry", "Values/k"),
                                  entry("Values", "{" + ", ".join(map(str, GLUES)) + "}"))),
    entries("Responses", entries("F", entry("Type", "Final"), entry("Response", "F"))))

shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
(WORK / "blocks.xml").write_text(SCENE)
(WORK / "study.xml").write_text(STUDY)
done = subprocess.run([HARMOS, "study", str(WORK / "study.xml"), "--output", str(WORK / "results")], capture_output=True,
                      text=True)
check(done.returncode == 0, f"ends with {done.returncode}\n{done.stdout}{done.stderr}")
with open(WORK / "results" / "study.csv", encoding="utf-8") as file:
    rows = list(csv.DictReader(file))
check(len(rows) == len(GLUES), f"{len(rows)} configurations")
for row, glue in zip(rows, GLUES):
    exact = WAY / (1 / glue + 2 / MODULUS)
    check(row["status"] == "certified", f"k = {glue}: {row['status']}")
    check(abs(float(row["F"]) - exact) <= ACCURACY * exact, f"k = {glue}: F = {row['F']} instead of {exact}")
finish()
