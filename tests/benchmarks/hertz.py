#!/usr/bin/env python3
"""Contact of Hertz with meshes that do not match: pressures against the closed form, and how fast they converge.

A body with the radius R lies on a flat one of the same material, as a cylinder (plane strain) or as a sphere
(axisymmetric), without friction. Both are graded towards the contact, with cells in the ratio 4:5, linear and quadratic;
points lie on either side. Printed are the errors of the largest pressure and of the distribution (mean square over the
contact), and the order from one mesh to the next with cells of half the size.

  hertz.py --harmos build/drivers/harmos [--levels 3] [--check]

With --check, exit code 1 when a run is not certified, the largest pressure of the finest mesh is off by more than 2 %, or
the mean order of the distribution over all levels is below 0.5.
"""
import argparse
import math
import pathlib
import sys
import tempfile

import numpy as np
from scipy.io import netcdf_file

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from campaign.scenes.scene import Joint, Law, Part, Response, Scene  # noqa: E402
from campaign.scenes.scene_file import write_scene  # noqa: E402
from campaign.scenes.separate import Separate  # noqa: E402
from campaign.trial.program import Ending, run_harmos  # noqa: E402

RADIUS, SIZE, YOUNG, POISSON = 50.0, 15.0, 210000.0, 0.3
HALF_WIDTH = 0.5
MODULUS = YOUNG / (1 - POISSON**2) / 2  # E* of two equal bodies
GRADING = 4.0


def peak(kind):
    """p0 = E* a / 2 R of a cylinder, 2 E* a / pi R of a sphere (Johnson 1985, eqs 4.43, 3.39)."""
    return MODULUS * HALF_WIDTH / (2 * RADIUS) if kind == "line" else 2 * MODULUS * HALF_WIDTH / (math.pi * RADIUS)


def load(kind):
    """Mean pressure on the upper body: P / 2 = pi a p0 / 4 over SIZE, or P = 2 pi a^2 p0 / 3 over pi SIZE^2."""
    if kind == "line":
        return math.pi * HALF_WIDTH * peak(kind) / 4 / SIZE
    return 2 * HALF_WIDTH**2 * peak(kind) / 3 / SIZE**2


def place(x):
    """Of the flat body in -1 <= y <= 0, of the round one in 1 <= y <= 2; both 0 <= x <= 1."""
    is_round = x[:, 1] > 0.5
    height = np.where(is_round, x[:, 1] - 1, x[:, 1])
    graded = SIZE * np.sinh(GRADING * np.column_stack([x[:, 0], height])) / math.sinh(GRADING)
    across = graded[:, 0]
    arc = across**2 / (RADIUS + np.sqrt(RADIUS**2 - across**2))
    graded[:, 1] += np.where(is_round, arc * (1 - graded[:, 1] / SIZE), 0.0)
    return graded


def make(kind, element, points_on, cells):
    """The scene with so many cells along the side of the flat body."""
    bodies = Separate(False)
    for name, low, count in (("flat", -1.0, cells), ("round", 1.0, 5 * cells // 4)):
        bodies.box(name, [np.linspace(0, 1, count + 1), np.linspace(low, low + 1, cells // 2 + 1)])
    mesh = bodies.build({"flat": element, "round": element}, place)
    side1, side2 = bodies.outer("low", "flat", 1, 1), bodies.outer("high", "round", 1, 0)
    joints = [Joint("contact", side1, side2, Law("Unilateral Contact"), points_on, 1.0)]
    if kind == "line":
        for name in ("flat", "round"):
            joints.append(Joint("axis_" + name, bodies.outer("axis_" + name, name, 0, 0), None, Law("Symmetry")))
    joints.append(Joint("ground", bodies.outer("ground", "flat", 1, 0), None, Law("Symmetry")))
    joints.append(Joint("load", bodies.outer("load", "round", 1, 1), None, Law("Pressure", {"Pressure": load(kind)})))
    responses = [Response("p0", "Maximum", "contact", {}, "Contact Pressure")]
    parts = [Part(name, YOUNG, POISSON) for name in ("flat", "round")]
    kinematics = "Plane Strain" if kind == "line" else "Axisymmetric"
    return Scene(mesh, kinematics, 1.0, parts, joints, 1, 1e-5, responses)


def pressures(path):
    """Places and pressures of the points, ascending."""
    with netcdf_file(str(path), "r", mmap=False) as file:
        data = file.variables
        def words(name):
            return [row.tobytes().split(b"\0")[0].decode() for row in data[name].data]
        nodes = np.unique(data[f"connect{words('eb_names').index('contact') + 1}"].data) - 1
        field = data[f"vals_nod_var{words('name_nod_var').index('contact_pressure') + 1}"].data[-1]
        order = np.argsort(data["coordx"].data[nodes])
        return data["coordx"].data[nodes][order], field[nodes][order]


def spread(kind, x, pressure):
    """Mean square of the difference from the closed form over that of the latter; trapezoidal rule."""
    exact = peak(kind) * np.sqrt(np.maximum(0, 1 - (x / HALF_WIDTH) ** 2))
    weight = np.ones_like(x) if kind == "line" else x
    return math.sqrt(np.trapz(weight * (pressure - exact) ** 2, x) / np.trapz(weight * exact**2, x))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("--levels", type=int, default=3)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    harmos = arguments.harmos.resolve()

    is_good = True
    print("| body | element | points on | cells over the half width | error of p0 | of the distribution | order | stages |")
    print("|---|---|---|---|---|---|---|---|")
    for kind in ("line", "sphere"):
        for element in ("QUAD4", "QUAD8"):
            for points_on, side in ((1, "flat"), (2, "round")):
                errors = []
                for level in range(arguments.levels):
                    cells = (24 if element == "QUAD4" else 12) * 2**level
                    with tempfile.TemporaryDirectory() as folder:
                        scene = write_scene(make(kind, element, points_on, cells), pathlib.Path(folder))
                        run = run_harmos(harmos, scene, 300.0, "--set", "Solver/Mesh Error=false")
                        if run.ending is not Ending.CERTIFIED:
                            sys.exit(f"{kind}, {element}, {side}, {cells} cells: {run.reason}")
                        x, pressure = pressures(scene.parent / "results" / "scene_interfaces.e")
                    errors.append(spread(kind, x, pressure))
                    order = f"{math.log2(errors[-2] / errors[-1]):.2f}" if level else ""
                    at_peak = run.values["p0"][-1] / peak(kind) - 1
                    # Places of the corners of the flat body's cells.
                    along = SIZE * np.sinh(GRADING * np.arange(cells + 1) / cells) / math.sinh(GRADING)
                    print(f"| {kind} | {element} | {side} | {np.interp(HALF_WIDTH, along, np.arange(cells + 1)):.1f} | "
                          f"{100 * at_peak:+.2f} % | {100 * errors[-1]:.2f} % | {order} | {run.stages} |", flush=True)
                is_good = is_good and abs(at_peak) <= 0.02
                if arguments.levels > 1:
                    is_good = is_good and math.log2(errors[0] / errors[-1]) / (arguments.levels - 1) >= 0.5
    return 0 if is_good or not arguments.check else 1


if __name__ == "__main__":
    sys.exit(main())
