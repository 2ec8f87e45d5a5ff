#!/usr/bin/python3
"""A study of a joint that slides, held by boundaries that are eliminated: far_apart.py HARMOS JOINT_STUDY WORK_DIR

Its configurations are far apart, and yet each costs less than one alone: what a body that is held passes on to its
support must not count as missing. All answers are held against others that are ten thousand times as accurate.
"""
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy

from checks import check, finish

HARMOS, STUDY, WORK = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
COARSE = ("Scene Overrides={Boundaries/loaded/Law/Type=Prescribed Displacement, Boundaries/loaded/Law/X=0.5, "
          "Mesh/Refinement=0.25}")
ACCURACY = 1e-2
GRID = [word for parameter in ("mu", "preload_1", "preload_2") for word in ("--set", f"Parameters/{parameter}/Count=3")]


def solve(name, *words):
    """Configurations of a study: their values, F_max and linear stages."""
    folder = WORK / name
    done = subprocess.run([HARMOS, "study", STUDY, "--output", str(folder), "--quiet", "--set", COARSE, *words],
                          capture_output=True, text=True)
    check(done.returncode == 0, f"{name}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    with h5py.File(folder / (pathlib.Path(STUDY).stem + ".h5")) as file:
        (study,) = file.values()
        values = numpy.column_stack([study["parameters"][one] for one in ("mu", "preload_1", "preload_2")])
        return values, study["responses/F_max"][()], study["configurations/linear_stages"][()]


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
values, largest, stages = solve("together", *GRID)
alone = []
for number, row in enumerate(values[::7]):
    table = WORK / f"{number}.csv"
    table.write_text("mu,preload_1,preload_2\n" + ",".join(map(repr, map(float, row))) + "\n")
    alone.append(solve(f"alone_{number}", "--points", str(table))[2][0])
truth = solve("exact", *GRID, "--set", f"Accuracy={ACCURACY / 1e4}")[1]
error = abs(largest / truth - 1).max()
print(f"{len(stages)} configurations: {stages.mean():.1f} linear stages, {numpy.mean(alone):.1f} alone, "
      f"largest error {error:.1e}")
check(error <= ACCURACY, f"error {error}")
check(stages.mean() <= 0.75 * numpy.mean(alone), "cost")
finish()
