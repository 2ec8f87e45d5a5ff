#!/usr/bin/python3
"""Runs the program with laws in Python: what they see, what they may raise: with_laws.py TESTS FOLDER"""
import os
import pathlib
import shutil
import sys
from typing import Any

import numpy

import harmos

tests, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # the program itself must leave nothing beside files of laws

LAWS = '''
import numpy
from harmos.laws import Law, NoIntersection, Output, number, numbers, text

class Spring(Law):
    """A spring that creeps, and counts."""
    name = "Creeping Spring"
    source = "nobody"
    parameters = (number("Stiffness", "k.", unit="stress/length", above=0.0, varying=True),
                  number("Limit", "Unused.", optional=True),
                  numbers("Factors", "Of the three directions."),
                  text("Fault", "What goes wrong.", default="", choices=("", "made", "solve", "shape", "point", "nan", "exit",
                                                                        "output")))
    history = 3
    outputs = (Output("seen_time", "time", "end of the load step"), Output("seen_x", "length", "place"))

    def __init__(self, p):
        self.stiffness, self.factors, self.fault = p["Stiffness"], p["Factors"], p["Fault"]
        assert "Limit" not in p and self.factors.shape == (3,)
        if self.fault == "made":
            raise ValueError("the factors do not fit the stiffness")

    def traction(self, jump, old, at):
        n = len(jump)
        assert at.position.shape == (n, 3) and at.frame.shape == (n, 3, 3) and at.area.shape == (n,) and at.gap.shape == (n,)
        assert numpy.allclose(at.frame[:, 0], [0.0, 0.0, 1.0]) and (at.area > 0.0).all() and at.duration == 1.0
        assert at.time == at.step + 1.0 and numpy.allclose(at.position[:, 2], 10.0)
        if self.fault == "solve":
            return 1 / 0
        if self.fault == "shape":
            return jump[:, :2]
        if self.fault == "point" and n > 3:
            raise NoIntersection("the law is tired", 3)
        if self.fault == "nan":
            return jump * numpy.nan if at.step == 1 else jump
        if self.fault == "exit":
            raise SystemExit(5)
        return self.stiffness[at.step] * self.factors * (jump - old)

    def update(self, jump, traction, old, at):
        return old + 0.25 * (jump - old)

    def output(self, step):
        if self.fault == "output":
            raise RuntimeError("no output")
        return numpy.column_stack([numpy.full(len(step.jump), step.at.time), step.at.position[:, 0]])
'''
(work / "laws.py").write_text(LAWS)


def scene(name: str, law: dict[str, Any], plugins: list[str]) -> harmos.Scene:
    """Two blocks on a spring, with three load steps."""
    found = harmos.read_scene(tests / "regression/sliding_blocks/sliding_blocks.xml")
    found.name, found.folder = name, work
    found["Plugins"] = plugins
    found["Interfaces/contact/Law"] = law
    found["Boundaries/push/Law"] = {"Type": "Prescribed Traction", "X": 2.0}
    del found["Steps"]
    found["Steps"] = {"all": {"Duration": 3.0, "Increments": 3}}
    found["Solver/Accuracy"] = 1e-8
    return found


spring = {"Type": "Creeping Spring", "Stiffness": 900.0, "Stiffness History": "stiffer", "Factors": [1.0, 0.5, 0.5]}


def creeping(name: str, **other: Any) -> harmos.Scene:
    found = scene(name, {**spring, **other}, ["laws.py"])
    found["Histories"] = {"stiffer": {"Type": "Table", "Times": [1.0, 3.0], "Values": [1.0, 2.0]}}
    return found


# The same law by formulas: history, a number that varies, and places agree.
formula: dict[str, Any] = {"Type": "Formula", "Constants": {"k": 900.0}, "History": {
    f"m_{c}": {"Formula": f"m_{c}_old + 0.25 * (jump_{c} - m_{c}_old)"} for c in ("n", "1", "2")}}
for component, c, share in (("Normal Traction", "n", "1"), ("Tangential Traction 1", "1", "0.5"),
                            ("Tangential Traction 2", "2", "0.5")):
    formula[component] = f"k * (1 + (t - 1) / 2) * {share} * (jump_{c} - m_{c}_old)"
known = harmos.run(scene("known", formula, []), work / "known")
result = harmos.run(creeping("creeping"), work / "one")
size = abs(known.history["u_push"]).max()
for response in ("u_push", "friction_force"):
    size = abs(known.history[response]).max()
    assert abs(result.history[response] - known.history[response]).max() <= 1e-7 * size, response
both = harmos.run(creeping("creeping"), work / "two", ranks=2)
assert abs(both.history["u_push"] - result.history["u_push"]).max() <= 1e-7 * abs(known.history["u_push"]).max()

# Outputs are in the results.
fields = result.fields(interfaces=True)
on = fields.blocks["contact"]
assert (fields.at_nodes("seen_time")[on] == 3.0).all()
assert numpy.allclose(fields.at_nodes("seen_x")[on], fields.nodes[on][..., 0])

# Derivatives are those of the law by formulas.
slope = {}
for name, each, entry in (("known", scene("known", formula, []), "Constants/k"),
                          ("creeping", creeping("creeping"), "Stiffness")):
    each["Output/Derivatives"] = [f"Interfaces/contact/Law/{entry}"]
    slope[name] = harmos.run(each, work / "slopes").derivatives["u_push", f"Interfaces/contact/Law/{entry}"]
assert abs(slope["creeping"] - slope["known"]).max() <= 1e-5 * abs(slope["known"]).max() > 0.0

# Numbers may be fields, and follow studies.
varied = creeping("varied", **{"Stiffness Formula": "1 + x / 40"})
assert harmos.run(varied, work / "varied").is_certified
study = harmos.StudyInput("springs", {
    "Scene": str(work / "one/creeping.xml"), "Accuracy": 1e-6,
    "Parameters": {"k": {"Entry": "Interfaces/contact/Law/Stiffness", "Values": [900.0, 1800.0]}}})
found = harmos.run_study(study, work / "study")
assert found.solved.all()
assert abs(found.curves["u_push"][0] - result.history["u_push"][1:]).max() <= 1e-5 * size

# A law that falls says so, or a remark does.
(work / "falling.py").write_text('''
import numpy
from harmos.laws import Law, number

class Falling(Law):
    """A spring that holds less the farther it is pulled."""
    name = "Falling Spring"
    parameters = (number("Claim", "What it says of its fall.", unit="stress/length", default=0.0),)

    def __init__(self, p):
        self.lowest_slope = -p["Claim"]

    def traction(self, jump, old, at):
        size = abs(jump)
        return numpy.sign(jump) * numpy.where(size < 0.005, 1000.0 * size, 5.0 - 100.0 * (size - 0.005))
''')
for claim in (0.0, 100.0):
    falling = scene("falling", {"Type": "Falling Spring", "Claim": claim}, ["falling.py"])
    falling["Boundaries/top/Law"] = {"Type": "Prescribed Displacement", "X": 0.0, "Y": 0.0, "Z": 0.02}
    pulled = harmos.run(falling, work / "falling")
    remarks = [remark for remark in pulled.record["remarks"] if "says that its traction never falls" in remark]
    assert len(remarks) == (1 if claim == 0.0 else 0), pulled.record["remarks"]
    assert claim > 0.0 or 'law "Falling Spring" of interface "contact"' in remarks[0], remarks


def messages(input_: harmos.Scene, verb: str = "run") -> tuple[int, str]:
    try:
        harmos.check(input_) if verb == "check" else harmos.run(input_, work / "refused")
    except harmos.HarmosError as error:
        return error.exit_code, str(error)
    return 0, ""


# What is wrong is refused at once, with the place in the scene and in the file.
code, text = messages(creeping("wrong", Fault="made", **{"Stiffness": -1.0, "Stifness": 1.0}), "check")
assert code == 2 and "Did you mean \"Stiffness\"" in text and "above 0" in text, text
line = LAWS.splitlines().index("            raise ValueError(\"the factors do not fit the stiffness\")") + 1
code, text = messages(creeping("wrong", Fault="made"), "check")
assert code == 2 and f"contact / Law: ValueError: the factors do not fit the stiffness (laws.py, line {line})" in text, text
for fault, exit_code, words in (
        ("solve", 1, "interface \"contact\", load step 1: law \"Creeping Spring\" raises ZeroDivisionError: division by "
                     "zero (laws.py, line"),
        ("shape", 1, "interface \"contact\", load step 1: law \"Creeping Spring\" raises ValueError: traction() gives an "
                     "array of shape ("),
        ("point", 3, "at point 4, place ("),
        ("point", 3, "the law is tired"),
        ("nan", 3, "interface \"contact\", load step 2"),
        ("exit", 1, "raises SystemExit: 5 (laws.py"),
        ("output", 1, "law \"Creeping Spring\" raises RuntimeError: no output (laws.py")):
    code, text = messages(creeping("wrong", Fault=fault))
    assert code == exit_code and words in text, (fault, code, text)

# Files that are none.
for name, content, words in (
        ("syntax", "class (:\n", "SyntaxError: invalid syntax (syntax.py, line 1)"),
        ("empty", "", "no class in it is derived from harmos.laws.Law"),
        ("taken", LAWS.replace("Creeping Spring", "Linear Elastic"), "\"Linear Elastic\" is registered already"),
        ("missing_module", "import no_such_module\n", "No module named 'no_such_module'"),
        ("no_text", "\udcff = 1\n", "SyntaxError"),
        ("bad_kind", LAWS.replace('"Unused."', "5"), "an attribute of a law is of another type"),
        ("no_doc", LAWS.replace('    """A spring that creeps, and counts."""\n', ""), "it has no docstring")):
    (work / f"{name}.py").write_text(content, errors="surrogateescape")
    code, text = messages(scene("wrong", spring, [f"{name}.py"]), "check")
    assert code == 2 and f"{name}.py\" cannot register its laws: " in text and words in text, text
code, text = messages(scene("wrong", spring, ["nowhere.py"]), "check")
assert code == 2 and "nowhere.py\" does not exist" in text, text
(work / "folder.py").mkdir()
os.mkfifo(work / "pipe.py")
for name in ("folder.py", "pipe.py"):
    code, text = messages(scene("wrong", spring, [str(work.absolute() / name)]), "check")
    assert code == 2 and f"{name}\" cannot be loaded: it is no file" in text, text
assert not (work / "__pycache__").exists()
os.environ["HARMOS_PYTHON_LAWS"] = str(work / "nowhere.so")
code, text = messages(creeping("wrong"), "check")
assert code == 2 and "nowhere.so, which does not exist" in text and "pybind11-dev" in text, text
print("all as promised")
