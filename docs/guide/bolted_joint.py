#!/usr/bin/python3
"""The bolted joint from Python: change a scene, solve it, look at fields, study it, and predict between its points.

    python3 docs/guide/bolted_joint.py xml/bolted_joint.xml results

The mesh is coarse, so that all of it takes some seconds; docs/guide/python.md explains what is used here.
"""
import pathlib
import sys

import harmos

scene_file, output = sys.argv[1:]

# %% A scene from a file, changed: a coarse mesh, and the end displaced beyond global sliding.
scene = harmos.read_scene(scene_file)
scene.name = "coarse_joint"
scene["Mesh/Refinement"] = 0.4
scene["Boundaries/loaded/Law"] = {"Type": "Prescribed Displacement", "X": 0.5, "X History": "pull"}
print("".join(line for line in harmos.check(scene).splitlines(keepends=True) if "nodes" in line))

# %% What is wrong is said as the program says it, with the repair, before anything is computed.
wrong = harmos.Scene("wrong", {name: scene[name] for name in scene})
wrong["Values/mu"] = "much"
try:
    harmos.run(wrong, output)
except harmos.InputError as error:
    print(f"exit code {error.exit_code}: {error.messages[0]}")
else:
    sys.exit("a friction coefficient in words was not refused")

# %% One solution: its curve, its error, and the pressure under the plates.
result = harmos.run(scene, output)
force, error = result.history["reaction"], result.errors["reaction"]
print(f"{result.status}: the joint slides at {force.max():.0f} N, known to {error:.1e} of that")
contact = result.fields(interfaces=True)
pressure = contact.at_nodes("contact_pressure")[contact.blocks["plates_bottom"]]
print(f"pressure under the lower cover: {pressure.max():.1f} MPa at most")

# %% Nine solutions that share one factorisation, as a table, and a surface through them.
study = harmos.StudyInput("slip_force", {
    "Scene": str(pathlib.Path(output) / f"{scene.name}.xml"),
    "Accuracy": 1e-2,
    "Parameters": {"mu": {"Entry": "Values/mu", "From": 0.1, "To": 0.5, "Count": 3},
                   "preload": {"Entry": "Values/preload_1", "From": 0.025, "To": 0.1, "Count": 3}},
    "Responses": {"F_max": {"Type": "Maximum", "Response": "reaction"}}})
found = harmos.run_study(study, output)
print(found.table()[["mu", "preload", "F_max", "status"]])
surface = found.surrogate("F_max")
value, deviation = surface([0.3, 0.05])
print(f"at mu = 0.3 and a preload of 0.05 mm: {value[0]:.0f} N, give or take {deviation[0]:.0f} N")

# The surface and the solution at the same point must tell the same.
there = float(force.max())
if not found.solved.all() or abs(value[0] - there) > max(3 * deviation[0], 0.1 * there):
    sys.exit(f"the surface says {value[0]} N, the solution {there} N")
