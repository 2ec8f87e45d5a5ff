#!/usr/bin/env python3
"""The lap joint of lap_joint.xml: parts meshed one by one against meshes that match, linear and quadratic tetrahedra.

  lap_joint.py --harmos build/drivers/harmos [--separate SCENE.xml --matching SCENE.xml]

Exit code 1: a run is not certified, responses differ by more than the mesh errors that both runs give together, or meshes
that do not match take more than 1.5 times as many linear stages. Other scenes are compared in the same way.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

OWN = pathlib.Path(__file__).resolve().parent / "lap_joint.xml"
CELLS = {"lower": "{25, 5, 2}", "upper": "{25, 5, 2}", "washer_below": "{6, 3, 1}", "washer_above": "{6, 3, 2}"}
LARGEST_RATIO = 1.5
BELOW = 0.005  # what "mesh below 0.5 %" says


def run(harmos, scene, order, settings, folder):
    """The record and the last value of every response."""
    command = [harmos, "run", str(scene), "--quiet", "--output", folder, "--set", f"Mesh/Order={order}", *settings]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    record = json.loads((pathlib.Path(folder) / f"{scene.stem}_result.json").read_text())
    header, *rows = (pathlib.Path(folder) / f"{scene.stem}_history.csv").read_text().split()
    return record, dict(zip(header.split(","), map(float, rows[-1].split(","))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--separate", type=pathlib.Path, default=OWN)
    parser.add_argument("--matching", type=pathlib.Path, help="default: lap_joint.xml with other cells")
    arguments = parser.parse_args()
    cells = [word for box, number in CELLS.items() for word in ("--set", f"Mesh/Boxes/{box}/Cells={number}")]
    matching = (arguments.matching, []) if arguments.matching else (OWN, cells)

    is_good = True
    print("| order | response | separate | matching | difference | mesh errors | stages |")
    print("|---|---|---|---|---|---|---|")
    for order in (1, 2):
        records, values = [], []
        for scene, settings in ((arguments.separate, []), matching):
            with tempfile.TemporaryDirectory() as folder:
                record, value = run(arguments.harmos, scene, order, settings, folder)
            records.append(record)
            values.append(value)
        stages = [record["linear_stages"] for record in records]
        is_good = is_good and stages[0] <= LARGEST_RATIO * stages[1]
        for name, estimate in records[0]["mesh_error_estimates"].items():
            other = records[1]["mesh_error_estimates"].get(name)
            if other is None or "estimated" not in (estimate["word"], other["word"]):
                continue
            size = max(abs(value[name]) for value in values)
            difference = abs(values[0][name] - values[1][name]) / size
            bounds = [max(BELOW, one["relative"]) for one in (estimate, other)]
            is_good = is_good and difference <= sum(bounds)
            print(f"| {order} | {name} | {values[0][name]:.6g} | {values[1][name]:.6g} | {100 * difference:.2f} % | "
                  f"{100 * bounds[0]:.1f} %, {100 * bounds[1]:.1f} % | {stages[0]}, {stages[1]} |", flush=True)
    print("within the mesh errors" if is_good else "NOT within the mesh errors or stages")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
