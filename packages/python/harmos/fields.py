"""What the pictures of a result show: its files, read through VTK, and its fields by the names that people use.

A result is RESULT.e with the parts and RESULT_interfaces.e beside it. Steps are counted from 0, the unloaded start.
"""
import dataclasses
import difflib
import json
import pathlib
import re
from collections.abc import Collection
from typing import Any

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from harmos.arrays import Floats
from harmos.classic import demand_complete
from harmos.foreign import read_foreign

Grids = dict[str, vtk.vtkUnstructuredGrid]
"""The element blocks of a file by name."""

ALIASES = {"deformed": ("disp_",), "displacement": ("disp_",), "von_mises": ("nodal_von_mises", "von_mises"),
           "pressure": ("contact_pressure",), "slip": ("slip_magnitude",), "status": ("contact_status",),
           "safety": ("safety_slip",), "gaping": ("safety_gaping",)}
"""Short names of fields, and the variables that they stand for: the first that a file has."""

SEQUENCE = ((0, (0.93, 0.95, 0.97)), (0.15, (0.99, 0.87, 0.55)), (0.45, (0.96, 0.52, 0.24)), (0.75, (0.80, 0.16, 0.22)),
            (1, (0.35, 0.02, 0.20)))
"""Colours from the least to the largest value: fraction, then red, green and blue."""
WARNING = ((0, (0.70, 0.05, 0.10)), (0.125, (0.96, 0.52, 0.24)), (0.25, (0.99, 0.87, 0.55)), (0.5, (0.66, 0.80, 0.69)),
           (1, (0.90, 0.94, 0.92)))
"""Colours of safeties from 1 to SAFE."""
STATES = ((0, (0.93, 0.95, 0.97)), (0.25, (0.45, 0.62, 0.78)), (0.5, (0.96, 0.52, 0.24)), (0.75, (0.62, 0.72, 0.62)),
          (1, (0.35, 0.02, 0.20)))
"""Colours of contact states, as STATUS names them."""
STATUS = "0 open, 1 stick, 2 slip, 3 bonded, 4 broken"
"""What the numbers of contact_status mean."""
UNITS = re.compile(r' *<Parameter name="Units" type="string" value="(.*)"/>')
"""The line of the effective input, as result files keep it, that declares the units."""
SAFE = 5.0
"""Safeties from here on look alike."""

Colours = tuple[tuple[float, tuple[float, float, float]], ...]
"""As SEQUENCE."""


@dataclasses.dataclass
class Contents:
    """What a result has; names of joined vectors end with an underscore.

    Attributes:
        times: the end of each step; the first is the unloaded start.
        nodal: variables of the nodes of parts.
        element: variables of the elements of parts.
        surface: variables of interfaces.
        title: of the result.
        units: length, force and time of all numbers, as the scene declares them; empty: it does not.
    """

    times: list[float]
    nodal: list[str]
    element: list[str]
    surface: list[str]
    title: str
    units: str


@dataclasses.dataclass
class Field:
    """One field of a result, as it is drawn.

    Attributes:
        name: of the variable; a vector is drawn by its length.
        where: nodes, elements or interfaces.
    """

    name: str
    where: str

    def colours(self) -> Colours:
        """Of its least to its largest value."""
        if self.name.startswith("safety_"):
            return WARNING
        return STATES if self.name == "contact_status" else SEQUENCE

    def limits(self, least: float, largest: float) -> tuple[float, float]:
        """The values of the first and the last colour, for a field that lies between two values."""
        if self.name.startswith("safety_"):
            return 1.0, SAFE
        if self.name == "contact_status":
            return 0.0, 4.0
        low = min(least, 0.0)
        return low, largest if largest > low else low + 1.0


def interfaces_of(path: str) -> str:
    """The file with the interfaces of the result whose parts are at `path`."""
    return path.removesuffix(".e") + "_interfaces.e"


def _reader(path: str) -> vtk.vtkExodusIIReader:
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetApplyDisplacements(0)
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.SetAllArrayStatus(reader.ELEM_BLOCK, 1)
    for i in range(reader.GetNumberOfElementBlockArrays()):
        reader.SetElementBlockArrayStatus(reader.GetElementBlockArrayName(i), 1)
    return reader


def files_of(path: str) -> tuple[str, str, str]:
    """What is read of a result: the parts, the interfaces, the record."""
    return path, interfaces_of(path), path.removesuffix(".e") + "_result.json"


def record_of(path: str) -> dict[str, Any]:
    """The record beside a result; empty without one."""
    try:
        record = json.loads(pathlib.Path(files_of(path)[2]).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return record if isinstance(record, dict) else {}


def verdict(record: dict[str, Any]) -> str:
    """What a record says of the accuracy: whether the run is certified, and how large its error is."""
    error = record.get("error_estimate")
    told = f"error estimate {error:.2g}" if isinstance(error, float) else "error not estimated"
    return f"{record.get('status', 'of unknown accuracy')}, {told}"


def _records(block: vtk.vtkDataSet, name: str) -> list[str]:
    """The texts that a file keeps under a name, which VTK gives letter by letter; none where there are not any."""
    records = block.GetFieldData().GetAbstractArray(name)
    if records is None:
        return []
    letters, width = [records.GetValue(k) for k in range(records.GetNumberOfValues())], records.GetNumberOfComponents()
    return ["".join(letters[start:start + width]).rstrip() for start in range(0, len(letters), width)]


def _contents(path: str) -> tuple[list[float], list[str], list[str], str, str, str]:
    """Times, nodal and element variables, title, the program that wrote an Exodus file, and the units it declares."""
    reader = _reader(path)
    times = reader.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()
    names = [[reader.GetObjectArrayName(kind, i) for i in range(reader.GetNumberOfObjectArrays(kind))]
             for kind in (reader.NODAL, reader.ELEM_BLOCK)]
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    program = units = ""
    for i in range(blocks.GetNumberOfBlocks()):
        if blocks.GetBlock(i) is None:
            continue
        program = next(iter(_records(blocks.GetBlock(i), "QA_Records")), program)
        for line in _records(blocks.GetBlock(i), "Info_Records"):
            declared = UNITS.fullmatch(line)
            units = declared[1] if declared else units
    return list(times), names[0], names[1], reader.GetTitle() or "", program, units


def contents(path: str) -> Contents:
    """What the result at `path` has.

    Raises:
        OSError: one of its files cannot be read.
        ValueError: one of its files is damaged, or no result of Harmos.
    """
    both = []
    for part in (path, interfaces_of(path)):
        with open(part, "rb") as file:
            start = file.read(4)
        if not start.startswith((b"CDF", b"\x89HDF")):
            raise ValueError(f"{part} is not an Exodus file")
        demand_complete(part)
        both.append(read_foreign(part, lambda: _contents(part)))
        if both[-1][4] != "Harmos" or "disp_" not in both[-1][1]:
            raise ValueError(f"{part} is not a result of Harmos")
    (times, nodal, element, title, _, units), (_, surface, *_) = both
    return Contents(times, nodal, element, surface, title, units)


def field(name: str, of: Contents) -> Field:
    """The field that is meant by a name.

    Raises:
        ValueError: the result has none of this name.
    """
    for variable in ALIASES.get(name, (name,)):
        for where, names in (("nodes", of.nodal), ("elements", of.element), ("interfaces", of.surface)):
            if variable in names:
                return Field(variable, where)
    known = [*ALIASES, *dict.fromkeys(of.nodal + of.element + of.surface)]
    near = difflib.get_close_matches(name, known, 1)
    raise ValueError(f"the result has no field \"{name}\"." + (f" Did you mean \"{near[0]}\"?" if near else "") +
                     f" Fields: {', '.join(known)}.")


def step(number: int | None, of: Contents) -> int:
    """The step that is meant: the last one without a number; negative numbers count from there.

    Raises:
        ValueError: there is no such step.
    """
    last = len(of.times) - 1
    if number is None:
        return last
    if not -last - 1 <= number <= last:
        raise ValueError(f"there is no step {number}; the result has 0 (unloaded) to {last}")
    return number % (last + 1)


def read(path: str, number: int) -> Grids:
    """The element blocks of an Exodus file at a step from 0."""
    reader = _reader(path)
    reader.SetTimeStep(number)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    return {blocks.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()): blocks.GetBlock(i)
            for i in range(blocks.GetNumberOfBlocks()) if blocks.GetBlock(i)}


def surface_of(grid: vtk.vtkUnstructuredGrid) -> vtk.vtkPolyData:
    """The skin of a block, with all its fields; faces of quadratic elements by their corners."""
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetNonlinearSubdivisionLevel(0)
    skin.SetInputData(grid)
    skin.Update()
    return skin.GetOutput()


def values_of(data: vtk.vtkDataSet, field: Field) -> Floats:
    """The values of a field on a block or its surface; of vectors their lengths."""
    arrays = data.GetCellData() if field.where == "elements" else data.GetPointData()
    values: Floats = vtk_to_numpy(arrays.GetArray(field.name)).astype(float)
    if values.ndim > 1:
        lengths: Floats = numpy.linalg.norm(values, axis=1)
        return lengths
    return values


def contacts(surfaces: Grids, names: Collection[str] = ()) -> Grids:
    """The interfaces of these names; without names, all that are contacts, or all where none is.

    Raises:
        ValueError: there is no interface of one of the names.
    """
    for name in names:
        if name not in surfaces:
            raise ValueError(f"there is no interface \"{name}\"; there are {', '.join(surfaces)}")
    if names:
        return {name: surfaces[name] for name in names}
    return {name: grid for name, grid in surfaces.items()
            if grid.GetPointData().GetArray("contact_status").GetRange()[1] <= 2} or surfaces


def size_of(grids: Grids) -> float:
    """Diagonal of the box around all blocks."""
    box = vtk.vtkBoundingBox()
    for grid in grids.values():
        box.AddBounds(grid.GetBounds())
    return float(box.GetDiagonalLength())


def visible_scale(size: float, displacement: float) -> float:
    """A round factor that makes the largest displacement about a twentieth of the size."""
    if displacement <= 0.0:
        return 1.0
    wanted = 0.05 * size / displacement
    power = 10.0 ** len(str(int(wanted))) / 10 if wanted >= 1 else 1.0
    return max((power * digit for digit in (1, 2, 5) if power * digit <= wanted), default=1.0)

