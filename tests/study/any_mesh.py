#!/usr/bin/python3
"""Studies and chaos where meshes do not match, and on quadratic elements: any_mesh.py HARMOS WORK_DIR

A block is pressed on another one by a displacement and pulled along it, with friction between: a study over both
friction and pressing costs no more linear stages than its configurations one by one, also where some slide away, gives
the same responses, and says what its mesh is worth; where it is about to slide, it says that instead. Two bars that random glue joins have the end displacement
F (l1 + l2) / E + F / k, of which mean and deviation are known for a lognormal k.
"""
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys

from checks import check, finish
from lists import entries, entry, law

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
FORCE, MODULUS, STIFFNESS, SPREAD = 100.0, 1e4, 1000.0, 0.2
LEVELS = {"mu": (0.2, 0.3, 0.4, 0.5), "press": (0.01, 0.02, 0.03)}


def box(name, lower, upper, cells, element):
    numbers = ("{" + ", ".join(map(str, each)) + "}" for each in (lower, upper, cells))
    return entries(name, *[entry(*each) for each in zip(("Lower Corner", "Upper Corner", "Cells"), numbers)],
                   entry("Element", element))


def scene(boxes, interface, boundaries, steps, responses, values, poisson):
    names = [re.search('name="(.*?)"', each)[1] for each in boxes]
    return entries(
        "Harmos", entries("Values", *[entry(*each) for each in values.items()]),
        entries("Mesh", entry("Type", "Boxes"), entries("Boxes", *boxes)),
        entries("Materials", entries("m", entry("Type", "Isotropic"), entry("Young's Modulus", MODULUS),
                                     entry("Poisson's Ratio", poisson))),
        entries("Parts", *[entries(name, entry("Material", "m")) for name in names]),
        entries("Interfaces", interface), entries("Boundaries", *boundaries), steps, entries("Responses", *responses))


def mean(name, side_set):
    return entries(name, entry("Type", "Mean Displacement"), entry("Side Set", side_set),
                   entry("Direction", "{1, 0}"))


def harmos(verb, path, *words):
    folder = WORK / "results"
    done = subprocess.run([HARMOS, verb, str(path), "--output", str(folder), *words], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr, folder


def pressed_block(element):
    """Pressed by 0.01 or more, and pulled: the force that presses is not known before it is solved."""
    return scene(
        [box("lower", (0, 0), (4, 1), (9, 2), element), box("upper", (1, 1), (3, 2), (7, 3), element)],
        entries("seat", entry("Side 1", "lower_ymax"), entry("Side 2", "upper_ymin"),
                law("Coulomb Friction", entry("Friction Coefficient", "$mu"))),
        [entries("ground", entry("Side Set", "lower_ymin"), law("Prescribed Displacement", entry("X", 0.0), entry("Y", 0.0))),
         entries("press", entry("Side Set", "upper_ymax"),
                 law("Prescribed Displacement", entry("Y", "$press"), entry("Y History", "down"))),
         entries("pull", entry("Side Set", "upper_xmax"), law("Prescribed Traction", entry("X", 50.0),
                                                             entry("X History", "later")))],
        entries("Histories",
                entries("down", entry("Type", "Table"), entry("Times", "{0, 1}"), entry("Values", "{0, -1}")),
                entries("later", entry("Type", "Ramp"), entry("Start", 1.0), entry("End", 2.0)))
        + entries("Steps", entries("press"), entries("pull", entry("Increments", 5))),
        [mean("u", "upper_xmax"), entries("force", entry("Type", "Interface Force"), entry("Interface", "seat"),
                                          entry("Direction", "{0, 1}"))],
        {"mu": 0.3, "press": 0.02}, 0.3)


def stages_one_by_one(path):
    """Linear stages in all, and the displacement by configuration; None where there is no equilibrium."""
    total, found = 0, {}
    for mu in LEVELS["mu"]:
        for press in LEVELS["press"]:
            code, text, folder = harmos("run", path, "--set", f"Values/mu={mu}", "--set", f"Values/press={press}",
                                        "--set", "Solver/Mesh Error=false")
            check(code in (0, 4), f"{path.stem} {mu} {press} ends with {code}\n{text}")
            total += json.loads((folder / f"{path.stem}_result.json").read_text())["linear_stages"]
            last = list(csv.DictReader((folder / f"{path.stem}_history.csv").open()))[-1]
            found[mu, press] = float(last["u"]) if code == 0 else None
    return total, found


def study_of_friction(name, element):
    path = WORK / f"{name}.xml"
    path.write_text(pressed_block(element))
    study = WORK / f"{name}_study.xml"
    study.write_text(entries(
        "Harmos Study", entry("Scene", path.name),
        entries("Parameters", *[entries(each, entry("Entry", f"Values/{each}"),
                                        entry("Values", "{" + ", ".join(map(str, levels)) + "}"))
                                for each, levels in LEVELS.items()]),
        entries("Responses", entries("u_end", entry("Type", "Final"), entry("Response", "u")))))
    code, text, folder = harmos("study", study)
    check(code == 4, f"{name}: the study ends with {code}\n{text}")
    words = re.search(r"error of the mesh: at (\d) of 12 configurations: u about (\d+)", text)
    check(words and 1 <= int(words[1]) <= 3, f"{name}: nothing is said of the mesh\n{text}")
    per_configuration = re.search(r"([0-9.]+) linear stages", text)
    total, alone = stages_one_by_one(path)
    count = len(alone)
    check(float(per_configuration[1]) * count <= total,
          f"{name}: {per_configuration[1]} stages a configuration, {total / count} one by one")
    slid = 0
    for row in csv.DictReader((folder / f"{study.stem}.csv").open()):
        reference = alone[float(row["mu"]), float(row["press"])]
        slid += reference is None
        if reference is None:
            check(row["status"] == "no equilibrium", f"{name}: {row}")
        else:
            check(row["u_end"] and abs(float(row["u_end"]) - reference) < 3e-3 * reference, f"{name}: {row}, {reference}")
    check(0 < slid < count, f"{name}: {slid} slide away")
    print(f"{name}: {per_configuration[1]} linear stages a configuration, {total / count:.1f} one by one, {slid} slide")


def near_sliding():
    """A displacement has a number for its mesh far from sliding, and next to it a warning instead; a force has both times."""
    path = WORK / "pressed.xml"

    def errors(mu):
        code, text, folder = harmos("run", path, "--set", f"Values/mu={mu}")
        check(code == 0, f"mu = {mu} ends with {code}\n{text}")
        return json.loads((folder / "pressed_result.json").read_text())["mesh_error_estimates"]

    far, near = errors(1.0), errors(0.206)  # it slides away from 0.204 on
    check(far["u"]["word"] in ("estimated", "uncertain"), f"far from sliding: {far}")
    check(near["u"]["word"] == "near sliding", f"next to sliding: {near}")
    check(near["force"]["word"] in ("estimated", "uncertain"), f"next to sliding: {near}")
    reason = near["u"].get("reason", "")
    check(re.fullmatch('interface "seat" has [0-9.]+ % left to sliding, its clamping is [0-9.]+ % uncertain', reason),
          f"next to sliding: {near}")
    print("next to sliding:", reason)


def uniform_pressure(pieces):
    """Two glued blocks under pressure, one of them cut: the mesh makes no error, wherever the cut meets glue and load."""
    path = WORK / f"patch_{pieces}.xml"
    glue = entries("glue", entry("Side 1", "lower_ymax"), entry("Side 2", "upper_ymin"), law("Perfect"))
    held = [entries(name, entry("Side Set", name), law("Symmetry"))
            for name in ("lower_ymin", "lower_xmin", "upper_xmin")]
    load = entries("load", entry("Side Set", "upper_ymax"), law("Pressure", entry("Pressure", 10.0)))
    boxes = [box("lower", (0, 0), (4, 1), (8, 2), "Quad8"), box("upper", (0, 1), (4, 2), (8, 2), "Quad8")]
    path.write_text(scene(boxes, glue, [*held, load], entries("Steps", entries("only")), [mean("u", "upper_xmax")], {},
                          0.3))
    code, text, folder = harmos("run", path, "--set", f"Parts/lower/Pieces={pieces}", "--set",
                                f"Parts/upper/Pieces={pieces}")
    check(code == 0, f"{pieces} pieces: {code}\n{text}")
    errors = json.loads((folder / f"{path.stem}_result.json").read_text())["mesh_error_estimates"]
    check(errors["u"]["relative"] < 1e-6, f"{pieces} pieces: {errors}")


def random_glue(name, cells, element):
    """Two bars, guided between the planes y = 0 and 1 by their Poisson's ratio of 0."""
    path = WORK / f"{name}.xml"
    path.write_text(scene(
        [box("left", (0, 0), (2, 1), cells[0], element), box("right", (2, 0), (4, 1), cells[1], element)],
        entries("glue", entry("Side 1", "left_xmax"), entry("Side 2", "right_xmin"),
                law("Linear Elastic", entry("Normal Stiffness", "$k"), entry("Tangential Stiffness", STIFFNESS))),
        [entries("ground", entry("Side Set", "left_xmin"), law("Prescribed Displacement", entry("X", 0.0), entry("Y", 0.0))),
         entries("end", entry("Side Set", "right_xmax"), law("Prescribed Traction", entry("X", FORCE)))],
        entries("Steps", entries("only")), [mean("u", "right_xmax")], {"k": STIFFNESS}, 0.0))
    study = WORK / f"{name}_study.xml"
    study.write_text(entries(
        "Harmos Study", entry("Scene", path.name), entry("Accuracy", 1e-6),
        entries("Parameters", entries("k", entry("Entry", "Values/k"), entries(
            "Distribution", entry("Type", "Lognormal"), entry("Mean", STIFFNESS),
            entry("Coefficient of Variation", SPREAD)))),
        entries("Design", entry("Type", "Chaos"), entry("Order", 4), entry("Hold-Out Count", 4)),
        entries("Responses", entries("u_end", entry("Type", "Final"), entry("Response", "u")))))
    inverse = (1.0 + SPREAD**2) / STIFFNESS
    expected = FORCE * (4.0 / MODULUS + inverse), FORCE * SPREAD * inverse
    for stage in "Galerkin", "Pseudo-Spectral":
        code, text, _ = harmos("study", study, "--restart", "--set", f"Design/Local Stage={stage}")
        check(code == 0, f"{name}, {stage}: {code}\n{text}")
        row = re.search(r"^  u_end +([-+.0-9e]+) +([-+.0-9e]+)", text, re.MULTILINE)
        for number, exact, tolerance in zip(row.groups() if row else (), expected, (1e-5, 1e-3)):
            check(abs(float(number) - exact) < tolerance * exact, f"{name}, {stage}: {number}, exact {exact}\n{text}")
        check(row, f"{name}, {stage}: no moments\n{text}")
        print(f"{name}, {stage}: {row.groups() if row else None}, exact {expected}")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
study_of_friction("pressed", "Quad4")
near_sliding()
for pieces in 1, 3:
    uniform_pressure(pieces)
study_of_friction("pressed_quadratic", "Quad8")
random_glue("glued", ((5, 2), (3, 3)), "Quad4")
random_glue("glued_quadratic", ((3, 2), (3, 3)), "Quad8")
finish()
