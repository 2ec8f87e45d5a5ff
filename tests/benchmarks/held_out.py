#!/usr/bin/python3
"""Solves a study, then some of its accepted configurations again, each by itself and a thousand times more accurately.

held_out.py --harmos build/drivers/harmos STUDY.xml [--count 10] [further arguments of harmos study]

Prints the true error of every response of these configurations, relative to its largest value among them, beside the
accuracy that was asked for. Exit code 1 when one is larger.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
from harmos import read_study


def solve(harmos, study, folder, arguments):
    subprocess.run([harmos, "study", study, "--output", folder, "--quiet", *arguments], check=True)
    return read_study(folder / f"{pathlib.Path(study).stem}.h5")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True)
    parser.add_argument("study")
    parser.add_argument("--count", type=int, default=10)
    options, further = parser.parse_known_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        study = solve(options.harmos, options.study, folder / "study", further)
        accepted = numpy.flatnonzero(study.status == "calibrated")
        chosen = accepted[::max(1, len(accepted) // options.count)][:options.count]
        points = study.points()
        exact = {response: numpy.array([]) for response in study.responses}
        for start in range(0, len(chosen), 9):  # fewer than ten are certified one by one
            table = folder / f"points_{start}.csv"
            rows = [",".join(f"{value:.17g}" for value in points[row]) for row in chosen[start:start + 9]]
            table.write_text("\n".join([",".join(study.free)] + rows))
            part = solve(options.harmos, options.study, folder / f"exact_{start}",
                         [*further, "--points", table, "--set", f"Accuracy={study.accuracy / 1000}"])
            exact = {response: numpy.append(values, part.responses[response]) for response, values in exact.items()}
    errors = numpy.array([abs(study.responses[response][chosen] - values) / abs(values).max()
                          for response, values in exact.items()])
    print("| configuration | estimate | " + " | ".join(f"error of {response}" for response in exact) + " |")
    print("|---" * (2 + len(exact)) + "|")
    for row, of_row in zip(chosen, errors.T):
        print(f"| {study.id[row]} | {study.error_estimate[row]:.1e} | " + " | ".join(f"{e:.1e}" for e in of_row) + " |")
    false = int((errors.max(axis=0) > study.accuracy).sum())
    print(f"{len(study.id)} configurations, {len(accepted)} calibrated; {false} of {len(chosen)} false, "
          f"largest error {errors.max():.1e} for {study.accuracy:g}")
    return 1 if false else 0


if __name__ == "__main__":
    sys.exit(main())
