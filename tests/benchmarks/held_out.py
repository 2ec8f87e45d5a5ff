#!/usr/bin/python3
"""Solves a study, then some of its accepted configurations again, each by itself and a thousand times more accurately.

held_out.py --harmos build/drivers/harmos STUDY.xml [--count 10] [further arguments of harmos study]

Prints the true error of every response of these configurations, relative to its largest value among them, beside the
accuracy that was asked for. Exit code 1 when one is larger.
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "drivers"))
import harmos_results


def solve(harmos, study, folder, arguments):
    subprocess.run([harmos, "study", study, "--output", folder, "--quiet", *arguments], check=True)
    with open(folder / f"{pathlib.Path(study).stem}.csv", newline="") as stream:
        return list(csv.DictReader(stream))


def names(study, kind, derived=True):
    lists = xml.parse(study).getroot().find(f"ParameterList[@name='{kind}']")
    found = lists.findall("ParameterList") if lists is not None else []
    return [each.get("name") for each in found if derived or each.find("Parameter[@name='Formula']") is None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True)
    parser.add_argument("study")
    parser.add_argument("--count", type=int, default=10)
    options, further = parser.parse_known_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        rows = solve(options.harmos, options.study, folder / "study", further)
        stem = pathlib.Path(options.study).stem
        accuracy = harmos_results.read_study(folder / "study" / f"{stem}.h5").accuracy
        accepted = [row for row in rows if row["status"] == "calibrated"]
        step = max(1, len(accepted) // options.count)
        chosen = accepted[::step][:options.count]
        parameters = names(options.study, "Parameters", derived=False)
        points = folder / "points.csv"
        points.write_text("\n".join([",".join(parameters)] + [",".join(row[p] for p in parameters) for row in chosen]))
        exact = []
        for start in range(0, len(chosen), 9):  # fewer than ten are certified one by one
            part = folder / f"points_{start}.csv"
            lines = points.read_text().splitlines()
            part.write_text("\n".join(lines[:1] + lines[1 + start:10 + start]))
            exact += solve(options.harmos, options.study, folder / f"exact_{start}",
                           [*further, "--points", part, "--set", f"Accuracy={accuracy / 1000}"])
    responses = names(options.study, "Responses")
    sizes = {r: max(abs(float(row[r])) for row in exact) for r in responses}
    print("| configuration | estimate | " + " | ".join(f"error of {r}" for r in responses) + " |")
    print("|---" * (2 + len(responses)) + "|")
    worst, false = 0.0, 0
    for row, truth in zip(chosen, exact):
        errors = [abs(float(row[r]) - float(truth[r])) / sizes[r] for r in responses]
        worst = max(worst, *errors)
        false += max(errors) > accuracy
        print(f"| {row['id']} | {float(row['error_estimate']):.1e} | " + " | ".join(f"{e:.1e}" for e in errors) + " |")
    print(f"{len(rows)} configurations, {len(accepted)} calibrated; {false} of {len(chosen)} false, "
          f"largest error {worst:.1e} for {accuracy:g}")
    return 1 if false else 0


if __name__ == "__main__":
    sys.exit(main())
