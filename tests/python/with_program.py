#!/usr/bin/python3
"""Runs the program from Python and compares what is read with what is written: with_program.py TESTS FOLDER"""
import pathlib
import shutil
import sys
from collections.abc import Callable
from typing import Any

import numpy

import harmos

tests, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
scene = harmos.read_scene(tests / "regression/sliding_blocks/sliding_blocks.xml")
scene["Solver/Accuracy"] = 1e-4
assert "substructures" in harmos.check(scene)

result = harmos.run(scene, work, {"Interfaces/contact/Law/Friction Coefficient": 0.4})
assert result.is_certified and result.record["accuracy"] == 1e-4
again = harmos.read_scene(work / "sliding_blocks_effective.xml")
assert again["Interfaces/contact/Law/Friction Coefficient"] == 0.4

frame = result.frame()
assert list(frame["u_push"]) == list(result.history["u_push"]) and frame.index.name == "step"

fields = result.fields()
assert len(fields.times) == len(result.history) and fields.times[0] == 0.0
every = fields.at_nodes("disp_x", None)
assert every.shape == (len(fields.times), len(fields.nodes)) and (every[0] == 0).all()
assert (fields.at_nodes("disp_x") == every[-1]).all() and (fields.at_nodes("disp_x", 3) == every[3]).all()
assert (fields.vectors("disp_")[:, 0] == every[-1]).all()
assert every[-1].min() <= result.history["u_push"][-1] <= every[-1].max()
dataset = fields.dataset()
assert (dataset["disp_x"].values == every).all() and (dataset["x"].values == fields.nodes[:, 0]).all()
stress = fields.at_elements("von_mises", "lower")
assert stress.shape == (len(fields.blocks["lower"]),) and stress.max() > 0


def refused(error: type[Exception], call: Callable[[], object]) -> bool:
    try:
        call()
    except error:
        return True
    return False


assert refused(KeyError, lambda: fields.at_nodes("dips_x"))
assert refused(IndexError, lambda: fields.at_nodes("disp_x", 99))
assert refused(KeyError, lambda: fields.at_elements("von_mises", "nowhere"))

# Derivatives, with the history of all load steps, against differences of runs.
friction, step = "Interfaces/contact/Law/Friction Coefficient", 1e-3
entries = [friction, "Boundaries/push/Law/X"]
scene["Solver/Accuracy"] = 1e-9
scene["Output/Derivatives"] = entries
derivatives = harmos.run(scene, work / "derivatives").derivatives
assert len(derivatives) == 2 * len(harmos.read_scene(tests / "regression/sliding_blocks/sliding_blocks.xml")["Responses"])
del scene["Output/Derivatives"]
for entry in entries:
    value = float(scene[entry])
    above, below = (harmos.run(scene, work / "difference", {entry: value + sign * step * value, "Solver/Mesh Error": False})
                    .history[1:] for sign in (1, -1))
    for response in ("u_push", "friction_force", "dissipation_contact"):
        difference = (above[response] - below[response]) / (2 * step * value)
        size = max(abs(difference).max(), 0.1 * abs(above[response]).max() / abs(value))
        assert abs(derivatives[response, entry] - difference).max() <= 2e-5 * size, (response, entry)
scene["Solver/Accuracy"] = 1e-4

# Those of several numbers together are those of each, also where they need all directions that so small a scene has.
clamped = harmos.read_scene(tests / "verification/pretension/clamped_plates.xml")
clamped["Boundaries/pull/Law/X"] = 2.5  # the plates slide
numbers = ["Interfaces/seat/Law/Friction Coefficient", "Interfaces/bolt/Law/Force", "Boundaries/pull/Law/X"]
clamped["Output/Derivatives"] = numbers
together = harmos.run(clamped, work / "together").derivatives
for number in numbers:
    clamped["Output/Derivatives"] = [number]
    alone = harmos.run(clamped, work / "alone")
    for response in ("bolt", "seat", "u"):
        size = abs(alone.history[response]).max() / abs(float(clamped[number]))
        difference = together[response, number] - alone.derivatives[response, number]
        assert abs(difference).max() <= 1e-6 * size, (response, number)

# At the edge of slip, to all digits, there is no derivative, and nothing that looks like one.
def fixed(side: str, **along: float) -> dict[str, Any]:
    law: dict[str, Any] = {"Type": "Prescribed Displacement", **along}
    return {"Side Set": side, "Law": law}


OF_EDGE = "Interfaces/joint/Law/Friction Coefficient"
edge = harmos.Scene("edge", {
    "Model": {"Kinematics": "Plane Stress", "Thickness": 1.0},
    "Mesh": {"Type": "Boxes", "Boxes": {name: {"Lower Corner": [0.0, 4.0 * i], "Upper Corner": [10.0, 4.0 * i + 4.0], "Cells": [2, 1]}
                                        for i, name in enumerate(("lower", "upper"))}},
    "Materials": {"steel": {"Type": "Isotropic", "Young's Modulus": 1e5, "Poisson's Ratio": 0.0}},
    "Parts": {"lower": {"Material": "steel"}, "upper": {"Material": "steel"}},
    "Interfaces": {"joint": {"Part 1": "lower", "Part 2": "upper",
                             "Law": {"Type": "Coulomb Friction", "Friction Coefficient": 0.3}}},
    "Boundaries": {"foot": fixed("lower_ymin", X=0.0, Y=0.0), "push": fixed("upper_ymax", X=1e-3, Y=-0.08)},
    "Steps": {"push": {}}, "Solver": {"Accuracy": 1e-8, "Mesh Error": False},
    "Responses": {name: {"Type": "Interface Force", "Interface": "joint", "Direction": direction}
                  for name, direction in (("T", [1.0, 0.0]), ("N", [0.0, 1.0]))},
    "Output": {"Derivatives": [OF_EDGE]}})
stuck = harmos.run(edge, work / "stuck")
assert stuck.derivatives["T", OF_EDGE][-1] == 0.0
edge[OF_EDGE] = float(abs(stuck.history["T"][-1] / stuck.history["N"][-1]))
slipping = harmos.run(edge, work / "slipping")
assert slipping.is_certified
assert numpy.isnan(slipping.derivatives["T", OF_EDGE]).all(), slipping.derivatives
assert any(OF_EDGE in remark and "load step 1" in remark and '"joint"' in remark for remark in slipping.record["remarks"])

# Without friction, at the least value that there is: towards more of it. A prescribed strain that others must follow has none.
edge[OF_EDGE] = 0.0
little = harmos.run(edge, work / "little", {OF_EDGE: 1e-3})
slope = little.history["T"][-1] / 1e-3
assert abs(harmos.run(edge, work / "smooth").derivatives["T", OF_EDGE][-1] - slope) <= 1e-3 * abs(slope)
laminate = harmos.read_scene(tests / "verification/periodic/laminate.xml")
laminate["Output/Derivatives"] = ["Interfaces/x_low/Law/Strain XX"]
assert any("nothing balances" in remark for remark in harmos.run(laminate, work / "laminate").record["remarks"])

# The tool touches at the start, deeper it may not lie: from one side. As contacts close the responses bend, but are at no kink.
roller = harmos.read_scene(tests.parent / "xml/rigid_roller.xml")
RADIUS = "Boundaries/roller/Law/Radius"
roller["Output/Derivatives"] = [RADIUS]
of_roller = harmos.run(roller, work / "roller").derivatives
assert all(numpy.isfinite(of_roller[response, RADIUS]).all() for response in ("force", "lost"))

# More directions than are kept, as many load steps need.
joint = harmos.read_scene(tests.parent / "xml/bolted_joint.xml")
joint["Output/Derivatives"] = ["Values/mu"]
joint["Solver/Mesh Error"] = False
of_joint = harmos.run(joint, work / "joint")
assert all(numpy.isfinite(values).all() for values in of_joint.derivatives.values()), of_joint.record["remarks"]

# Too few iterations: an exception, and what was found so far.
try:
    harmos.run(scene, work / "few", {"Solver/Maximum Iterations": 2})
except harmos.NotConverged as error:
    assert error.exit_code == 3 and error.result.status == "not converged"
else:
    sys.exit("two iterations were enough")

# A study, and its tables.
study = harmos.read_study_input(tests / "study/sliding_blocks_study.xml")
study["Parameters/mu/Count"] = 2
found = harmos.run_study(study, work)
assert found.solved.all()
table = found.frame()
assert list(table.index) == list(found.id) and list(table["u_max"]) == list(found.responses["u_max"])
data = found.dataset()
assert data["u_push"].dims == ("id", "time") and (data["u_push"].values == found.curves["u_push"]).all()
print("what Python reads is what Harmos has written")
