#!/usr/bin/python3
"""Studies of a joint that slides, whose configurations are far apart: far_apart.py HARMOS JOINT_STUDY WORK_DIR

Neighbours as far as that are worth less than nothing as starts: a study of few configurations takes hardly more linear
stages than its configurations one by one. All answers are held against others that are ten thousand times as accurate.
"""
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy

HARMOS, STUDY, WORK = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
COARSE = ("Scene Overrides={Boundaries/loaded/Law/Type=Prescribed Displacement, Boundaries/loaded/Law/X=0.5, "
          "Mesh/Refinement=0.25}")
ACCURACY = 1e-2
GRID = [word for name in ("mu", "preload_1", "preload_2") for word in ("--set", f"Parameters/{name}/Count=3")]
failures = 0


def check(holds, what):
    global failures
    if not holds:
        print("FAILED:", what)
        failures += 1


def solve(name, *words):
    """Configurations of a study: their values, F_max, linear stages and status."""
    folder = WORK / name
    done = subprocess.run([HARMOS, "study", STUDY, "--output", str(folder), "--quiet", "--set", COARSE, *words],
                          capture_output=True, text=True)
    check(done.returncode == 0, f"{name}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    with h5py.File(folder / (pathlib.Path(STUDY).stem + ".h5")) as file:
        (study,) = file.values()
        values = numpy.column_stack([study["parameters"][one] for one in ("mu", "preload_1", "preload_2")])
        one = study["configurations"]
        return values, study["responses/F_max"][()], one["linear_stages"][()], one["status"][()]


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
_, largest, stages, status = solve("few", *GRID)
values, truth, _, _ = solve("exact", *GRID, "--set", f"Accuracy={ACCURACY / 1e4}")
alone = []
for number, row in enumerate(values[::7]):
    table = WORK / f"{number}.csv"
    table.write_text("mu,preload_1,preload_2\n" + ",".join(map(repr, map(float, row))) + "\n")
    alone.append(solve(f"alone_{number}", "--points", str(table))[2][0])
error = abs(largest / truth - 1).max()
print(f"{len(stages)} configurations, {stages.mean():.1f} linear stages, {numpy.mean(alone):.1f} alone, "
      f"largest error {error:.1e}")
check(error <= ACCURACY, f"error {error}")
check(set(status) == {b"certified"}, "all certified")
check(stages.mean() <= 1.25 * numpy.mean(alone), "cost")
sys.exit(1 if failures else 0)
