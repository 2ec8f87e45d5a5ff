#!/usr/bin/python3
"""Harmos beside CalculiX at equal total error, the error of the mesh and of the solver together, on a joint of tetrahedra.

The joint is that of lap_joint_deck.py, on meshes of several sizes, linear (C3D4, TET4) and quadratic (C3D10, TET10); every
one is solved once by each program from the same deck, whole processes, one thread. The answer is the mean displacement of
the pulled face along x; its error is the distance from that of Harmos on a mesh that is much finer. CalculiX has
surface-to-surface contact by penalty, and its bolt cut by equations (halved_bolts.py). For each run of CalculiX the ratio is
that of its CPU time to that of the cheapest run of Harmos whose error is not larger.

  total_error_lap_joint.py --harmos build/drivers/harmos
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from scipy.spatial import cKDTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "packages" / "python"), str(ROOT / "tests" / "import")]
# pylint: disable=wrong-import-position
from compare_lap_joint import solve_by_calculix, solve_by_harmos  # noqa: E402
from halved_bolts import HalvedBolts  # noqa: E402
from lap_joint_deck import FACES, LapJoint  # noqa: E402

PULLED = 30.0  # x of the pulled face [mm]
# Node in the middle of each edge of the faces S1 to S4 of a C3D10: their mean is the mean over the face.
MIDDLES = ((4, 5, 6), (4, 7, 8), (5, 8, 9), (6, 7, 9))
NAMES = {1: ("TET4", "C3D4"), 2: ("TET10", "C3D10")}


def pull_of(joint, field):
    """Mean displacement of the pulled face along x [mm], exact for the shape functions of straight faces."""
    at, by = field
    nearest = cKDTree(at).query(joint.nodes)[1]
    first, cells = joint.first("upper"), joint.elements["upper"]
    area = moved = 0.0
    for element, face in joint.plane("upper", 0, PULLED):
        nodes = cells[element - first]
        a, b, c = joint.nodes[nodes[list(FACES[face])]]
        size = 0.5 * np.linalg.norm(np.cross(b - a, c - a))
        carrying = nodes[list(FACES[face] if joint.order == 1 else MIDDLES[face])]
        area += size
        moved += size * by[nearest[carrying], 0].mean()
    return moved / area


def mesh_of(text):
    """Order and size, such as 2:2.4."""
    order, size = text.split(":")
    return int(order), float(size)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--penalty", type=float, default=7e5, help="pressure per overclosure [MPa/mm]")
    parser.add_argument("--increments", type=int, default=10, help="of the pull")
    parser.add_argument("--accuracy", type=float, default=1e-3, help="of the solver of Harmos")
    parser.add_argument("--fine", type=mesh_of, default=mesh_of("2:1.2"), help="mesh of the reference: order and size")
    parser.add_argument("--meshes", type=mesh_of, nargs="+",
                        default=[mesh_of(text) for text in ("1:2.4", "1:1.2", "1:0.8", "2:3", "2:2.4", "2:2")])
    parser.add_argument("--rivals", type=mesh_of, nargs="+",
                        default=[mesh_of(text) for text in ("1:2.4", "1:1.2", "2:3")], help="for CalculiX")
    arguments = parser.parse_args()
    arguments.harmos = os.path.abspath(arguments.harmos)
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")

    def solve(mesh, by_harmos):
        joint = LapJoint(mesh[1], mesh[0])
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            deck = folder / "joint.inp"
            joint.write(deck, arguments.penalty, arguments.penalty / 10, arguments.increments)
            if by_harmos:
                subprocess.run([arguments.harmos, "import", str(deck), "--output", name, "--units", "mm N s"], check=True,
                               stdout=subprocess.DEVNULL)
                result = solve_by_harmos(arguments, folder, folder / "joint.xml",
                                         [f"Solver/Accuracy={arguments.accuracy}"], environment)
            else:
                HalvedBolts(deck).write(folder / "halved.inp")
                result = solve_by_calculix(folder, "halved", environment)
        result["pull"] = pull_of(joint, result["u"])
        result["nodes"] = len(joint.nodes)
        return result

    fine = solve(arguments.fine, True)
    print(f"Reference: {fine['pull']:.6g} mm, {fine['nodes']} nodes\n")
    print("| program | mesh | nodes | total error of u | CPU s | peak memory MB | ratio |\n|---|---|---|---|---|---|---|")
    runs = []
    for by_harmos, meshes in ((True, arguments.meshes), (False, arguments.rivals)):
        for mesh in meshes:
            result = solve(mesh, by_harmos)
            error = abs(result["pull"] / fine["pull"] - 1)
            ratio = ""
            if by_harmos:
                runs.append((error, result["cpu"]))
            else:
                enough = [cpu for harmos_error, cpu in runs if harmos_error <= error]
                ratio = f"{result['cpu'] / min(enough):.0f}" if enough else "none"
            program, element = ("Harmos", NAMES[mesh[0]][0]) if by_harmos else ("CalculiX", NAMES[mesh[0]][1])
            print(f"| {program} | {mesh[1]:g} mm, {element} | {result['nodes']} | {100 * error:.2f} % | {result['cpu']:.1f} | "
                  f"{result['memory']:.0f} | {ratio} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
