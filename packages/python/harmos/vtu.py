"""Writes a result as .vtu files, one per load step, with .pvd files that list them; `harmos export` calls it.

python3 -m harmos.vtu RESULT.e FOLDER [--step N]

FOLDER/RESULT.pvd holds the parts, FOLDER/RESULT_interfaces.pvd the interfaces. All variables keep their names; the cell
variable `block` counts the parts or interfaces, whose names stand in the field data `block_names`; `units` are those that
the scene declares.
"""
import argparse
import os
import pathlib
import sys
from xml.sax.saxutils import quoteattr

import vtk

from harmos import fields
from harmos.outputs import demand_no_folder, replace_file, writing


def joined(grids: fields.Grids, units: str) -> vtk.vtkUnstructuredGrid:
    """All blocks as one grid, with their numbers and names, and with the units unless they are empty."""
    together = vtk.vtkAppendFilter()
    names = vtk.vtkStringArray()
    names.SetName("block_names")
    for number, (name, grid) in enumerate(grids.items()):
        block = vtk.vtkUnstructuredGrid()
        block.ShallowCopy(grid)
        block.SetFieldData(vtk.vtkFieldData())
        numbers = vtk.vtkIntArray()
        numbers.SetName("block")
        numbers.SetNumberOfTuples(grid.GetNumberOfCells())
        numbers.Fill(number)
        block.GetCellData().AddArray(numbers)
        together.AddInputData(block)
        names.InsertNextValue(name)
    together.Update()
    result = together.GetOutput()
    result.GetFieldData().AddArray(names)
    if units:
        declared = vtk.vtkStringArray()
        declared.SetName("units")
        declared.InsertNextValue(units)
        result.GetFieldData().AddArray(declared)
    return result


def write(grid: vtk.vtkUnstructuredGrid, path: pathlib.Path) -> None:
    """Writes a .vtu file in one step: until it is complete, an older one stays.

    Raises:
        OSError: it cannot be written.
    """
    partial = path.with_name(f"{path.name}.partial.{os.getpid()}")
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(partial))
    writer.SetInputData(grid)
    try:
        if not writer.Write() or writer.GetErrorCode():
            raise OSError(f"cannot write {path}.\n  Make room, or write into another folder (--output).")
        with writing(path):
            os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


def export(path: str, of: fields.Contents, folder: pathlib.Path, steps: list[int]) -> list[pathlib.Path]:
    """Writes both halves of a result at some steps; returns the files that list them.

    Raises:
        OSError: they cannot be written.
    """
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    lists = []
    for half in (path, fields.interfaces_of(path)):
        stem = pathlib.Path(half).stem
        entries = []
        for step in steps:
            name = f"{stem}_{step:04d}.vtu"
            write(joined(fields.read(half, step), of.units), folder / name)
            entries.append(f'    <DataSet timestep="{of.times[step]:.17g}" file={quoteattr(name)}/>\n')
        lists.append(folder / f"{stem}.pvd")
        text = ('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n  <Collection>\n' + "".join(entries) +
                "  </Collection>\n</VTKFile>\n")
        replace_file(lists[-1], text.encode())
    return lists


def main(words: list[str] | None = None) -> int:
    """Does what the command line says; returns the exit code, 2 when the input is wrong."""
    parser = argparse.ArgumentParser(prog="harmos export", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--step", type=int)
    arguments = parser.parse_args(words)
    try:
        of = fields.contents(arguments.result)
        steps = list(range(len(of.times))) if arguments.step is None else [fields.step(arguments.step, of)]
        if arguments.folder.exists() and not arguments.folder.is_dir():
            raise ValueError(f"{arguments.folder} is not a folder")
        for result in fields.files_of(arguments.result)[:2]:
            demand_no_folder(arguments.folder / f"{pathlib.Path(result).stem}.pvd")
    except (OSError, ValueError) as error:
        print(f"harmos export: {error}\nNothing was written.", file=sys.stderr)
        return 2
    try:
        for written in export(arguments.result, of, arguments.folder, steps):
            print(written, flush=True)
    except (OSError, ValueError) as error:
        print(f"harmos export: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
