#!/usr/bin/python3
"""Two laws in Python, glue and friction, beside those of Harmos: laws_in_python.py RESULTS

The scenes name this very file as their plugin. Cells begin with `# %%`.
"""
import numpy

from harmos.laws import Law, Status, number


class Glue(Law):
    """Linear glue: t_n = k_n delta_n, t_t = k_t delta_t."""

    name = "Python Glue"
    parameters = (number("Normal Stiffness", "k_n.", unit="stress/length", at_least=0.0, varying=True),
                  number("Tangential Stiffness", "k_t.", unit="stress/length", at_least=0.0))

    def __init__(self, p):
        self.normal, self.tangential = p["Normal Stiffness"], p["Tangential Stiffness"]

    def traction(self, jump, old, at):
        return jump * [self.normal[at.step], self.tangential, self.tangential]

    def stored_energy(self, step):
        return 0.5 * (step.traction * step.jump).sum(axis=1)


class Friction(Law):
    """Contact with Coulomb friction, implicit in the load step. History: the tangential jump of the load step before."""

    name = "Python Friction"
    parameters = (number("Friction Coefficient", "mu.", at_least=0.0),)
    history = 2
    sides = "any"
    dissipates = True

    def __init__(self, p):
        self.mu = p["Friction Coefficient"]

    def solve(self, free_jump, compliance, old, at):
        pressure = numpy.maximum(0.0, -(free_jump[:, 0] + at.gap)) / compliance[:, 0]
        shear = (free_jump[:, 1:] - old) / compliance  # if it sticks
        trial = numpy.hypot(shear[:, 0], shear[:, 1])
        scale = numpy.minimum(1.0, self.mu * pressure / numpy.where(trial > 0.0, trial, 1.0))
        return numpy.column_stack([-pressure, shear * scale[:, None]])

    def update(self, jump, traction, old, at):
        return jump[:, 1:]

    def status(self, jump, traction, old, at):
        slips = numpy.hypot(traction[:, 1], traction[:, 2]) >= -self.mu * traction[:, 0] * (1.0 - 2e-6)
        return numpy.where(traction[:, 0] == 0.0, Status.OPEN, numpy.where(slips, Status.SLIP, Status.STICK))

    def admissible(self, step):
        return [-numpy.inf, 0.0, 0.0], [0.0, 0.0, 0.0], self.mu

    def kept_work(self, step):
        return step.traction[:, 0] * (step.jump[:, 0] - step.old_jump[:, 0])


def blocks(name, law):
    """A block on a block with a law between them, pressed and pushed."""
    import harmos
    box = {"Cells": [3, 2, 2]}
    return harmos.Scene(name, {
        "Plugins": [__file__],
        "Mesh": {"Type": "Boxes", "Boxes": {
            "lower": {"Lower Corner": [0.0, 0.0, 0.0], "Upper Corner": [3.0, 2.0, 1.0], **box},
            "upper": {"Lower Corner": [0.0, 0.0, 1.0], "Upper Corner": [3.0, 2.0, 2.0], **box}}},
        "Materials": {"soft": {"Type": "Isotropic", "Young's Modulus": 1000.0, "Poisson's Ratio": 0.3}},
        "Parts": {"lower": {"Material": "soft"}, "upper": {"Material": "soft"}},
        "Interfaces": {"joint": {"Part 1": "lower", "Part 2": "upper", "Law": law}},
        "Boundaries": {
            "fixed": {"Side Set": "lower_zmin", "Law": {"Type": "Prescribed Displacement", "X": 0.0, "Y": 0.0, "Z": 0.0}},
            "press": {"Side Set": "upper_zmax", "Law": {"Type": "Pressure", "Pressure": 10.0}},
            "push": {"Side Set": "upper_xmin", "Law": {"Type": "Prescribed Traction", "X": 11.0, "X History": "there and back"}}},
        "Histories": {"there and back": {"Type": "Table", "Times": [0.0, 2.0, 4.0], "Values": [0.0, 1.0, 0.0]}},
        "Steps": {"all": {"Duration": 4.0, "Increments": 4}},
        "Solver": {"Accuracy": 1e-8},
        "Responses": {
            "u": {"Type": "Point Displacement", "Point": [3.0, 0.0, 2.0], "Direction": [1.0, 0.0, 0.0]},
            "shear": {"Type": "Interface Force", "Interface": "joint", "Direction": [1.0, 0.0, 0.0]},
            "lost": {"Type": "Dissipation", "Interfaces": ["joint"]}}})


# %% Only where this file is run, and not where the program loads its laws
if __name__ == "__main__":
    import pathlib
    import sys

    import harmos

    results = pathlib.Path(sys.argv[1])

    # %% Every law must meet its graph on any line; points must not see each other, and more.
    harmos.laws.conform(Glue, {"Normal Stiffness": 500.0, "Tangential Stiffness": 200.0})
    harmos.laws.conform(Friction, {"Friction Coefficient": 0.4})

    # %% The same as the laws of Harmos that they repeat: every response at every load step.
    glue, friction = {"Normal Stiffness": 500.0, "Tangential Stiffness": 200.0}, {"Friction Coefficient": 0.4}
    for mine, known, numbers in (("Python Glue", "Linear Elastic", glue),
                                 ("Python Friction", "Coulomb Friction", friction)):
        name = mine.lower().replace(" ", "_")
        found = harmos.run(blocks(name, {"Type": mine, **numbers}), results)
        expected = harmos.run(blocks(f"{name}_known", {"Type": known, **numbers}), results)
        for column in ("u", "shear", "lost"):
            difference = abs(found.history[column] - expected.history[column]).max() / abs(expected.history["u"]).max()
            print(f"{mine}: {column} {found.history[column][-1]:.6g}, {difference:.1e} from {known}")
            if not difference <= 1e-10:
                sys.exit(f"{mine} is not {known}")

    # %% What goes wrong in a law is said with its place, in the scene and in this file.
    try:
        harmos.check(blocks("wrong", {"Type": "Python Friction", "Friction Coefficient": -0.4}))
    except harmos.InputError as error:
        print(error)
    else:
        sys.exit("a negative friction coefficient was not refused")
