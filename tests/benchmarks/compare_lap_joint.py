#!/usr/bin/python3
"""A bolted joint of tetrahedra, as a deck: imported and solved by Harmos, and solved by CalculiX, on the same mesh.

compare_lap_joint.py --harmos build/drivers/harmos [--deck FILE | --size 1.2 --order 1] [--runs 3]

Whole processes on one thread, in turns; medians are printed. Without --deck the joint is that of lap_joint_deck.py. CalculiX
gets the deck with its bolts cut by equations (halved_bolts.py). The answer is the displacement of all nodes at the end. The
error of each program is its distance from its own answer with tightened tolerances, relative to the largest displacement;
the last line is the distance of both tight answers, which is that of two ways to sum up contact over the same faces. The error
of the mesh is larger than all of these; Harmos states it, which its first row pays for.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "packages" / "python"), str(ROOT / "tests" / "import")]
# pylint: disable=wrong-import-position
from compare_with_calculix import run  # noqa: E402
from deck_table import difference, displacements_of_calculix, displacements_of_harmos  # noqa: E402
from halved_bolts import HalvedBolts  # noqa: E402
from lap_joint_deck import LapJoint  # noqa: E402

TIGHT = "*CONTROLS, PARAMETERS=FIELD\n1e-7, 1e-6, 1e-7, , 1e-6, , , 1e-9\n"
"""Residual and correction of CalculiX, whose defaults are 5e-3 and 1e-2."""


def solve_by_harmos(arguments, folder, scene, settings, environment):
    command = [arguments.harmos, "run", str(scene), "--output", str(folder / "results"), "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    code, cpu, _, memory = run(command, str(folder), str(folder / "log"), environment)
    if code:
        sys.exit(f"Harmos ended with {code}:\n{(folder / 'log').read_text()[-2000:]}")
    record = json.loads((folder / "results" / f"{scene.stem}_result.json").read_text())
    return {"cpu": cpu, "memory": memory, "u": displacements_of_harmos(folder / "results" / f"{scene.stem}.e"), "record": record}


def solve_by_calculix(folder, deck, environment):
    code, cpu, _, memory = run(["ccx", deck], str(folder), str(folder / "log"), environment)
    field = displacements_of_calculix(folder / f"{deck}.frd") if not code else None
    if field is None:
        sys.exit(f"CalculiX failed:\n{(folder / 'log').read_text()[-2000:]}")
    return {"cpu": cpu, "memory": memory, "u": field}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--deck", type=pathlib.Path, help="another deck")
    parser.add_argument("--size", type=float, default=1.2, help="of elements [mm]")
    parser.add_argument("--order", type=int, default=1, choices=(1, 2), help="of tetrahedra")
    parser.add_argument("--penalty", type=float, default=7e5, help="pressure per overclosure [MPa/mm]")
    parser.add_argument("--increments", type=int, default=10, help="of the pull")
    parser.add_argument("--accuracy", type=float, default=1e-3, help="asked of Harmos")
    parser.add_argument("--tight", type=float, default=2e-5, help="asked of Harmos to be as near as CalculiX")
    parser.add_argument("--runs", type=int, default=1, help="of each program")
    parser.add_argument("--goal", type=float, default=0.0, help="exit code 1 when the ratio of CPU time is below")
    arguments = parser.parse_args()
    arguments.harmos = os.path.abspath(arguments.harmos)
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        deck = arguments.deck or folder / "joint.inp"
        if not arguments.deck:
            LapJoint(arguments.size, arguments.order).write(deck, arguments.penalty, arguments.penalty / 10,
                                                            arguments.increments)
        subprocess.run([arguments.harmos, "import", str(deck), "--output", name, "--units", "mm N s"], check=True,
                       stdout=subprocess.DEVNULL)
        scene = folder / f"{deck.stem}.xml"
        halved = HalvedBolts(deck)
        halved.write(folder / "halved.inp")
        halved.write(folder / "tight.inp", TIGHT)
        accuracy = f"Solver/Accuracy={arguments.accuracy}"
        ways = {"Harmos": lambda: solve_by_harmos(arguments, folder, scene, [accuracy], environment),
                "Harmos, without the mesh error": lambda: solve_by_harmos(
                    arguments, folder, scene, [accuracy, "Solver/Mesh Error=false"], environment),
                f"Harmos, accuracy {arguments.tight:g}, without the mesh error": lambda: solve_by_harmos(
                    arguments, folder, scene, [f"Solver/Accuracy={arguments.tight}", "Solver/Mesh Error=false"], environment),
                "CalculiX": lambda: solve_by_calculix(folder, "halved", environment)}
        results = {way: [] for way in ways}
        for _ in range(arguments.runs):
            for way, solve in ways.items():
                results[way].append(solve())
        tight = {"Harmos": solve_by_harmos(arguments, folder, scene, ["Solver/Accuracy=1e-7", "Solver/Mesh Error=false"],
                                           environment)["u"],
                 "CalculiX": solve_by_calculix(folder, "tight", environment)["u"]}
    print(f"{len(tight['CalculiX'][0])} nodes; {halved.held_together} elements would hold the halves of bolts together\n")
    print("| | error | CPU s | ratio | peak memory MB |\n|---|---|---|---|---|")
    least = float("inf")
    for way, runs in results.items():
        error = difference(runs[0]["u"], tight[way.split(",")[0]], 3)
        cpu = statistics.median(one["cpu"] for one in runs)
        ratio = statistics.median(other["cpu"] / one["cpu"] for one, other in zip(runs, results["CalculiX"]))
        least = ratio if way == "Harmos" else least
        print(f"| {way} | {error:.1e} | {cpu:.2f} | {ratio:.1f} | {statistics.median(one['memory'] for one in runs):.0f} |")
    apart = difference(tight["Harmos"], tight["CalculiX"], 3)
    record = results["Harmos"][0]["record"]
    print(f"\nTight answers are {apart:.1e} apart. Harmos: {record['status']}, error estimate {record['error_estimate']:.1e}, "
          f"{record['linear_stages']} linear stages.")
    return 0 if least >= arguments.goal and np.isfinite(apart) else 1


if __name__ == "__main__":
    sys.exit(main())
