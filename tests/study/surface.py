#!/usr/bin/python3
"""Compares the response surfaces of the program with those of the Python module: surface.py HARMOS STUDY.h5"""
import csv
import io
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
from harmos import read_study

harmos, path = sys.argv[1:]
study = read_study(path)
points = numpy.random.default_rng(1).uniform(study.points().min(axis=0), study.points().max(axis=0) * 1.05,
                                             (50, len(study.free)))
with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
    numpy.savetxt(table, points, delimiter=",", header=",".join(study.free), comments="", fmt="%.17g")
    table.flush()
    printed = subprocess.run([harmos, "predict", path, "--points", table.name], check=True, capture_output=True,
                             text=True).stdout
rows = list(csv.DictReader(io.StringIO(printed)))
for name in study.responses:
    surface = study.surrogate(name)
    values, deviations = surface(points)
    scale = numpy.abs(values).max()
    for row, value, deviation, inside in zip(rows, values, deviations, surface.is_inside(points)):
        assert abs(float(row[name]) - value) < 1e-6 * scale, (name, row, value)
        assert abs(float(row[name + "_deviation"]) - deviation) < 1e-5 * scale, (name, row, deviation)
        assert row["extrapolated"] == ("0" if inside else "1")
print("same")
