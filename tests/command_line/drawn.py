#!/usr/bin/python3
"""Ends with 1 unless a picture shows something in colour: drawn.py FILE.png [LEAST_SHARE]"""
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def pixels(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)[:, :3]


def coloured_share(path):
    """Share of the pixels that are neither white, black nor grey."""
    rgb = pixels(path)
    return float(numpy.mean(rgb.max(axis=1) - rgb.min(axis=1) > 20))


if __name__ == "__main__":
    least = float(sys.argv[2]) if len(sys.argv) > 2 else 0.01
    share = coloured_share(sys.argv[1])
    if share < least:
        sys.exit(f"FAILED: of {sys.argv[1]} only {100 * share:.2g} % are in colour")
