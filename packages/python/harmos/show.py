"""Writes a result as one HTML page in which the assembly can be turned; `harmos show` calls it.

python3 -m harmos.show RESULT.e PAGE.html [--vtk-js vtk.js] [--steps 12] [--scale S]

The page needs nothing but a browser with WebGL: fields, load steps, colours and vtk.js (BSD-3-Clause) are in it.
"""
import argparse
import base64
import html
import json
import pathlib
import re
import sys
import zlib
from typing import Any

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from harmos import fields
from harmos.outputs import demand_distinct, replace_file
from harmos.render import PALETTE

LABELS = {"disp_": "displacement", "nodal_von_mises": "von Mises stress (nodes)",
          "von_mises": "von Mises stress (elements)", "principal_1": "largest principal stress",
          "principal_3": "least principal stress", "contact_pressure": "contact pressure",
          "slip_magnitude": "slip", "opening": "opening", "contact_status": "contact status",
          "safety_slip": "safety against slip", "safety_gaping": "safety against gaping"}
"""The fields of the page, as far as a result has them."""
FOLDER = pathlib.Path(__file__).parent / "viewer"
"""Where the page and its script lie."""


class Words:
    """Numbers of 32 bits one after the other, and where they are."""

    def __init__(self) -> None:
        """Nothing yet."""
        self._arrays: list[bytes] = []
        self._count = 0

    def add(self, values: Any, kind: str) -> list[int]:
        """Keeps values as numpy's `kind`, and returns their first word and their number."""
        array = numpy.ascontiguousarray(values, dtype=kind).ravel()
        self._arrays.append(array.tobytes())
        self._count += len(array)
        return [self._count - len(array), len(array)]

    def text(self) -> str:
        """All of them, deflated, as base64."""
        return base64.b64encode(zlib.compress(b"".join(self._arrays), 9)).decode()


def edges_of(surface: vtk.vtkPolyData) -> Any:
    """The sharp edges of a surface: 2, point, point and so on."""
    numbered = vtk.vtkIdFilter()
    numbered.SetInputData(surface)
    numbered.SetPointIdsArrayName("point")
    numbered.CellIdsOff()
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(numbered.GetOutputPort())
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.SetFeatureAngle(40)
    edges.ColoringOff()
    edges.Update()
    found = edges.GetOutput()
    if found.GetNumberOfLines() == 0:
        return numpy.zeros(0)
    points = vtk_to_numpy(found.GetPointData().GetArray("point"))
    lines = vtk_to_numpy(found.GetLines().GetData()).reshape(-1, 3).copy()
    lines[:, 1:] = points[lines[:, 1:]]
    return lines


def block_of(name: str, surface: vtk.vtkPolyData, colour: tuple[float, float, float], is_interface: bool,
             words: Words) -> dict[str, Any]:
    """What does not change with the steps."""
    polygons = vtk_to_numpy(surface.GetPolys().GetData()) if surface.GetNumberOfPolys() else numpy.zeros(0)
    return {"name": name, "colour": colour, "isInterface": is_interface,
            "points": words.add(vtk_to_numpy(surface.GetPoints().GetData()), "<f4"),
            "polys": words.add(polygons, "<u4"),
            "lines": words.add(numpy.zeros(0) if is_interface else edges_of(surface), "<u4"),
            "displacements": [], "fields": {}}


def shown_fields(of: fields.Contents) -> list[fields.Field]:
    """The fields of the page."""
    result = []
    for name in LABELS:
        for where, names in (("nodes", of.nodal), ("elements", of.element), ("interfaces", of.surface)):
            if name in names:
                result.append(fields.Field(name, where))
                break
    return result


def chosen_steps(of: fields.Contents, most: int) -> list[int]:
    """The unloaded start, the last step, and others evenly between, `most` in all."""
    count = len(of.times)
    return sorted({int(round(i)) for i in numpy.linspace(0, count - 1, min(count, most))})


def model_of(path: str, of: fields.Contents, most: int, scale: float | None, words: Words) -> dict[str, Any]:
    """What the page shows; its numbers go to `words`."""
    drawn = shown_fields(of)
    steps = chosen_steps(of, most)
    blocks: dict[str, dict[str, Any]] = {}
    extremes = {field.name: [numpy.inf, -numpy.inf] for field in drawn}
    largest, size, is_plane = 0.0, 0.0, False
    contacts = list(fields.contacts(fields.read(fields.interfaces_of(path), steps[-1])))
    for step in steps:
        parts = fields.read(path, step)
        grids = [(name, grid, False) for name, grid in parts.items()]
        surfaces = fields.read(fields.interfaces_of(path), step)
        grids += [(name, surfaces[name], True) for name in contacts]
        size = fields.size_of(parts)
        is_plane = all(grid.GetBounds()[4] == grid.GetBounds()[5] for grid in parts.values())
        for i, (name, grid, is_interface) in enumerate(grids):
            surface = fields.surface_of(grid)
            if surface.GetNumberOfPolys() == 0:
                continue
            if name not in blocks:
                blocks[name] = block_of(name, surface, PALETTE[i % len(PALETTE)], is_interface, words)
            block = blocks[name]
            displacement = vtk_to_numpy(surface.GetPointData().GetArray("disp_"))
            largest = max(largest, float(numpy.abs(displacement).max(initial=0.0)))
            block["displacements"].append(words.add(displacement, "<f4"))
            for field in drawn:
                if (field.where == "interfaces") != is_interface:
                    continue
                values = fields.values_of(surface, field)
                block["fields"].setdefault(field.name, []).append(words.add(values, "<f4"))
                low, high = extremes[field.name]
                extremes[field.name] = [min(low, float(values.min())), max(high, float(values.max()))]
    described = []
    for field in drawn:
        low, high = extremes[field.name]
        if low > high:
            continue
        described.append({"name": field.name, "label": LABELS[field.name], "isOfElements": field.where == "elements",
                          "isOfInterfaces": field.where == "interfaces", "colours": field.colours(),
                          "limits": field.limits(low, high),
                          "names": [each[2:] for each in fields.STATUS.split(", ")]
                          if field.name == "contact_status" else None})
    first = fields.field("von_mises", of).name
    return {"steps": steps, "times": [of.times[step] for step in steps], "fields": described, "field": first,
            "scale": fields.visible_scale(size, largest) if scale is None else scale, "isPlane": is_plane,
            "blocks": list(blocks.values())}


def summary_of(path: str, of: fields.Contents) -> str:
    """The units, where they are declared, and the three numbers that decide, where the record lies beside the result."""
    units = [f"Units: {of.units}"] if of.units else []
    return "".join(f"<div>{html.escape(line)}</div>" for line in [*decisive_lines(path), *units])


def decisive_lines(path: str) -> list[str]:
    """What the record beside the result says of its accuracy, and the three numbers that decide; nothing without one."""
    record = fields.record_of(path)
    lines = [fields.verdict(record)] if record else []
    try:
        last = record["last_step"]
        if last["largest_von_mises"]:
            lines.append("largest von Mises stress {value:.4g} in {part}".format(**last["largest_von_mises"]))
        for against in ("slip", "gaping"):
            if safety := last[f"least_safety_against_{against}"]:
                lines.append(f"least safety against {against} {safety['whole']:.4g} of {safety['interface']}, "
                             f"{safety['worst_point']['value']:.4g} at its worst point")
    except (ValueError, LookupError, TypeError):
        pass
    return lines


def page(path: str, of: fields.Contents, most: int, scale: float | None, library: str) -> bytes:
    """The page; `library` is the text of vtk.js."""
    words = Words()
    model = json.dumps(model_of(path, of, most, scale, words)).replace("</", "<\\/")
    title = html.escape(of.title or pathlib.Path(path).stem)
    text = (FOLDER / "page.html").read_text(encoding="utf-8")
    contents = {"TITLE": title, "SUMMARY": summary_of(path, of), "MODEL": model, "DATA": words.text(),
                "VIEWER": (FOLDER / "viewer.js").read_text(encoding="utf-8"),
                "VTK": library.replace("</script", "<\\/script")}
    return re.sub("@([A-Z]+)@", lambda found: contents[found[1]], text).encode()


def main(words: list[str] | None = None) -> int:
    """Does what the command line says; returns the exit code, 2 when the input is wrong."""
    parser = argparse.ArgumentParser(prog="harmos show", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result")
    parser.add_argument("page")
    parser.add_argument("--vtk-js", type=pathlib.Path, default=FOLDER.parents[2] / "vtk.js")
    parser.add_argument("--steps", type=int, default=12)
    parser.add_argument("--scale", type=float)
    arguments = parser.parse_args(words)
    try:
        if arguments.steps < 2:
            raise ValueError(f"--steps {arguments.steps}: give 2 or more, the unloaded start is one of them")
        for read in fields.files_of(arguments.result):
            demand_distinct(read, arguments.page)
        of = fields.contents(arguments.result)
    except (OSError, ValueError) as error:
        print(f"harmos show: {error}\nNothing was written.", file=sys.stderr)
        return 2
    try:
        if not arguments.vtk_js.exists():
            raise OSError(f"vtk.js is not at {arguments.vtk_js}.\n  The build fetches it from the registry of npm: build "
                          "again with a connection to it.")
        library = arguments.vtk_js.read_text(encoding="utf-8")
        replace_file(arguments.page, page(arguments.result, of, arguments.steps, arguments.scale, library))
        print(arguments.page, flush=True)
    except (OSError, ValueError) as error:
        print(f"harmos show: {error}\nNothing was written.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
