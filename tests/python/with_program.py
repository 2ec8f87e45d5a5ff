#!/usr/bin/python3
"""Runs the program from Python and compares what is read with what is written: with_program.py TESTS FOLDER"""
import pathlib
import shutil
import sys
from collections.abc import Callable

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
