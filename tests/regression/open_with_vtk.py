#!/usr/bin/python3
"""Opens an Exodus result file as ParaView does and checks what VTK makes of it.

open_with_vtk.py FILE.e [--blocks a,b] [--nodal n,...] [--element n,...] [--global n,...] [--steps N]

VTK joins disp_x, disp_y, disp_z to the vector "disp_". Every value must be finite, everything at time 0 must be zero.
"""
import argparse
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def open_file(path):
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    for kind in (reader.NODAL, reader.ELEM_BLOCK, reader.GLOBAL):
        reader.SetAllArrayStatus(kind, 1)
    for block in range(reader.GetNumberOfElementBlockArrays()):
        reader.SetElementBlockArrayStatus(reader.GetElementBlockArrayName(block), 1)
    return reader


def names(reader, kind):
    return {reader.GetObjectArrayName(kind, i) for i in range(reader.GetNumberOfObjectArrays(kind))}


def blocks_at(reader, step):
    reader.SetTimeStep(step)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    for i in range(blocks.GetNumberOfBlocks()):
        yield blocks.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()), blocks.GetBlock(i)


def split(text):
    return set(text.split(",")) if text else set()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    for option in ("--blocks", "--nodal", "--element", "--global"):
        parser.add_argument(option, default="", dest=option.strip("-") + "_")
    parser.add_argument("--steps", type=int)
    arguments = parser.parse_args()
    errors = []

    reader = open_file(arguments.file)
    for kind, label, wanted in ((reader.NODAL, "nodal", arguments.nodal_), (reader.ELEM_BLOCK, "element", arguments.element_),
                                (reader.GLOBAL, "global", arguments.global_)):
        missing = split(wanted) - names(reader, kind)
        if missing:
            errors.append(f"no {label} variable {sorted(missing)}; there are {sorted(names(reader, kind))}")

    steps = reader.GetNumberOfTimeSteps()
    if steps < 2:
        errors.append(f"{steps} time steps")
    if arguments.steps and steps != arguments.steps:
        errors.append(f"{steps} time steps instead of {arguments.steps}")

    found = set()
    for step in range(steps):
        for name, block in blocks_at(reader, step):
            found.add(name)
            if block.GetNumberOfCells() == 0:
                errors.append(f"block {name} is empty")
            for data in (block.GetPointData(), block.GetCellData()):
                for i in range(data.GetNumberOfArrays()):
                    label, array = data.GetArrayName(i), data.GetArray(i)
                    if array is None or label in ("ObjectId", "GlobalElementId", "GlobalNodeId"):
                        continue
                    values = vtk_to_numpy(array)
                    if not numpy.isfinite(values).all():
                        errors.append(f"{label} in {name} is not finite at step {step}")
                    if step == 0 and numpy.any(values):
                        errors.append(f"{label} in {name} is not zero at time 0")
    missing = split(arguments.blocks_) - found
    if missing:
        errors.append(f"no block {sorted(missing)}; there are {sorted(found)}")

    for error in errors:
        print(f"{arguments.file}: {error}")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
