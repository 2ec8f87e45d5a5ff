#!/usr/bin/python3
"""Ends with 1 unless .vtu files hold what the result holds: exported.py RESULT.e FOLDER"""
import pathlib
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def read_exodus(path, step):
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.SetApplyDisplacements(0)
    reader.SetTimeStep(step)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    return [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]


def read_vtu(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def main():
    result, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    for half in (result, result.removesuffix(".e") + "_interfaces.e"):
        files = sorted(folder.glob(pathlib.Path(half).stem + "_[0-9]*.vtu"))
        listed = (folder / f"{pathlib.Path(half).stem}.pvd").read_text(encoding="utf-8").count("<DataSet")
        if len(files) != listed or not files:
            sys.exit(f"FAILED: {len(files)} files, {listed} in the list")
        for step in (0, len(files) - 1):
            blocks, grid = read_exodus(half, step), read_vtu(files[step])
            expected = numpy.concatenate([vtk_to_numpy(block.GetPointData().GetArray("disp_")) for block in blocks])
            found = vtk_to_numpy(grid.GetPointData().GetArray("disp_"))
            if found.shape != expected.shape or not numpy.array_equal(found, expected):
                sys.exit(f"FAILED: {files[step]} has other displacements")
            if grid.GetFieldData().GetAbstractArray("block_names").GetNumberOfValues() != len(blocks):
                sys.exit(f"FAILED: {files[step]} does not name its blocks")
            if grid.GetFieldData().GetAbstractArray("units").GetValue(0) != "mm N s":
                sys.exit(f"FAILED: {files[step]} does not say its units")


if __name__ == "__main__":
    main()
