"""Draws a result to a PNG file: the deformed parts, coloured by a field; `harmos picture` calls it.

python3 -m harmos.render RESULT.e PICTURE.png [--field von_mises] [--step N] [--scale S] [--width 1600]
                         [--interfaces a,b]

Fields of interfaces are drawn on the contacts, with the parts transparent around them. RESULT_interfaces.e is looked for
beside RESULT.e. Needs no display: an X server without a screen is started for the time of drawing.
"""
import argparse
import contextlib
import ctypes
import os
import random
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from harmos import fields
from harmos.outputs import demand_distinct, replace_file

DISPLAYS = range(100, 50000)
"""Numbers of X servers, of which one is taken at random."""
PALETTE = [(0.62, 0.68, 0.75), (0.75, 0.69, 0.60), (0.62, 0.72, 0.62), (0.74, 0.62, 0.62), (0.66, 0.62, 0.74)]
"""Colours of the parts, in turn."""


def end_with_parent() -> None:
    """Lets the kernel end this process when its parent ends, however that happens (Linux)."""
    signal.pthread_sigmask(signal.SIG_SETMASK, [])  # the program that starts the verb blocks signals, and they inherit it
    option_death_signal = 1  # PR_SET_PDEATHSIG
    ctypes.CDLL(None).prctl(option_death_signal, signal.SIGTERM)


@contextlib.contextmanager
def display() -> Iterator[None]:
    """An X server without a screen, for VTK of Debian draws with no other.

    Raises:
        OSError: there is neither Xvfb nor a display.
    """
    server = shutil.which("Xvfb")
    if server is None:
        if "DISPLAY" not in os.environ:
            raise OSError("there is no display, and no Xvfb: install the package xvfb")
        yield
        return
    # Of its own: a server that ends takes the socket of the next one of the same number with it.
    for number in random.SystemRandom().sample(DISPLAYS, 3):
        receiver, sender = os.pipe()
        process = subprocess.Popen([server, f":{number}", "-displayfd", str(sender), "-screen", "0", "640x480x24",
                                    "-nolisten", "tcp"],
                                   pass_fds=[sender], stderr=subprocess.DEVNULL, preexec_fn=end_with_parent)
        os.close(sender)
        with os.fdopen(receiver) as pipe:
            if pipe.readline().strip():
                break
        process.wait()
    else:
        raise OSError("Xvfb does not start")
    try:
        os.environ["DISPLAY"] = f":{number}"
        yield
    finally:
        process.terminate()
        process.wait()


def deformed(grid: vtk.vtkUnstructuredGrid, scale: float) -> vtk.vtkPolyData:
    """The surface of a block, with its displacements times `scale`."""
    surface = fields.surface_of(grid)
    surface.GetPointData().SetActiveVectors("disp_")
    warp = vtk.vtkWarpVector()
    warp.SetInputData(surface)
    warp.SetScaleFactor(scale)
    warp.Update()
    return warp.GetOutput()


def actor(mapper: vtk.vtkMapper) -> vtk.vtkActor:
    """What shows the output of a mapper."""
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    return result


def add_part(renderer: vtk.vtkRenderer, surface: vtk.vtkPolyData, colour: tuple[float, float, float]) -> None:
    """Shows the surface of a part, transparent."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    body = actor(mapper)
    body.GetProperty().SetColor(colour)
    body.GetProperty().SetOpacity(0.10)
    renderer.AddActor(body)


def add_edges(renderer: vtk.vtkRenderer, surface: vtk.vtkPolyData) -> None:
    """Shows the edges of a part."""
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.SetFeatureAngle(40)
    edges.ColoringOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    outline = actor(mapper)
    outline.GetProperty().SetColor(0.25, 0.28, 0.32)
    outline.GetProperty().SetLineWidth(2)
    renderer.AddActor(outline)


def table_of(field: fields.Field, limits: tuple[float, float]) -> vtk.vtkColorTransferFunction:
    """Colours of the values of a field between its limits."""
    table = vtk.vtkColorTransferFunction()
    for fraction, rgb in field.colours():
        table.AddRGBPoint(limits[0] + fraction * (limits[1] - limits[0]), *rgb)
    return table


def add_field(renderer: vtk.vtkRenderer, surface: vtk.vtkPolyData, field: fields.Field,
              table: vtk.vtkColorTransferFunction) -> None:
    """Shows a field on a surface."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    if field.where == "elements":
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SetInterpolateScalarsBeforeMapping(field.name != "contact_status")
    mapper.SelectColorArray(field.name)
    if field.name.endswith("_"):
        table.SetVectorModeToMagnitude()
    if field.where == "interfaces":
        # Faces of two parts lie in the same place: the field wins.
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-4, -4)
    shown = actor(mapper)
    shown.GetProperty().SetLineWidth(6)  # of interfaces in the plane
    shown.GetProperty().SetAmbient(0.8 if field.where == "interfaces" else 0.35)
    shown.GetProperty().SetDiffuse(0.2 if field.where == "interfaces" else 0.65)
    renderer.AddActor(shown)


def text_style(text: vtk.vtkTextProperty, size: int) -> None:
    """Dark and plain."""
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(size)
    text.SetItalic(False)
    text.SetShadow(False)
    text.SetBold(False)


def add_bar(renderer: vtk.vtkRenderer, table: vtk.vtkColorTransferFunction, title: str, width: int) -> None:
    """Shows what the colours mean; `width` is that of the picture in pixels."""
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(title)
    bar.SetNumberOfLabels(5)
    bar.SetUnconstrainedFontSize(True)
    text_style(bar.GetTitleTextProperty(), 26 * width // 1600)
    text_style(bar.GetLabelTextProperty(), 22 * width // 1600)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.87, 0.15)
    bar.SetWidth(0.06)
    bar.SetHeight(0.7)
    renderer.AddActor(bar)


def add_note(renderer: vtk.vtkRenderer, note: str, width: int) -> None:
    """Writes a line into the lower left corner."""
    text = vtk.vtkTextActor()
    text.SetInput(note)
    text_style(text.GetTextProperty(), 22 * width // 1600)
    text.SetPosition(width // 80, width // 100)
    renderer.AddActor(text)


def fit(camera: vtk.vtkCamera, bounds: tuple[float, ...], aspect: float) -> None:
    """Lets a parallel camera see all of a box, with a margin and room for the bar."""
    frame = camera.GetViewTransformMatrix()
    corners = [frame.MultiplyPoint((x, y, z, 1.0)) for x in bounds[:2] for y in bounds[2:4] for z in bounds[4:]]
    width, height = (max(c[i] for c in corners) - min(c[i] for c in corners) for i in (0, 1))
    camera.SetParallelScale(0.5 * max(height / 0.82, width / aspect / 0.76))


def image_of(renderer: vtk.vtkRenderer, width: int, is_plane: bool) -> bytes:
    """A PNG file `width` pixels wide: what the renderer has, from the front, left and above, a plane from before it."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*((0, 0, 1) if is_plane else (-0.55, -1, 0.85)))
    camera.SetViewUp(*((0, 1, 0) if is_plane else (0, 0, 1)))
    camera.ParallelProjectionOn()
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(30)
    renderer.SetOcclusionRatio(0.0)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetAlphaBitPlanes(1)
    window.SetMultiSamples(0)
    window.SetSize(width, width * 9 // 16)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    fit(camera, renderer.ComputeVisiblePropBounds(), 16 / 9)
    camera.SetWindowCenter(0.10, 0.0)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.WriteToMemoryOn()
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    png = vtk_to_numpy(writer.GetResult()).tobytes()
    window.Finalize()
    return bytes(png)


def picture(path: str, of: fields.Contents, field: fields.Field, step: int, scale: float | None, width: int,
            names: list[str]) -> bytes:
    """A PNG file of a result; `scale`: of displacements, None: a visible one; `names`: of interfaces, none: contacts.

    Raises:
        OSError, ValueError: it cannot be drawn.
    """
    parts, interfaces = fields.read(path, step), fields.read(fields.interfaces_of(path), step)
    coloured = fields.contacts(interfaces, names) if field.where == "interfaces" or names else parts
    if field.where != "interfaces":
        coloured = parts
    largest = max(fields.values_of(grid, fields.Field("disp_", "nodes")).max() for grid in parts.values())
    factor = fields.visible_scale(fields.size_of(parts), largest) if scale is None else scale
    values = numpy.concatenate([fields.values_of(grid, field) for grid in coloured.values()] or [numpy.zeros(1)])
    # Peaks at the edges of a contact would leave one colour for all the rest, of what is pressed.
    pressed = values[values > 0.0]
    top = numpy.percentile(pressed, 90) if field.name == "contact_pressure" and len(pressed) else values.max()
    table = table_of(field, field.limits(float(values.min()), float(top)))
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for i, grid in enumerate(parts.values()):
        surface = deformed(grid, factor)
        add_edges(renderer, surface)
        if field.where == "interfaces":
            add_part(renderer, surface, PALETTE[i % len(PALETTE)])
        else:
            add_field(renderer, surface, field, table)
    if field.where == "interfaces":
        for grid in coloured.values():
            add_field(renderer, deformed(grid, factor), field, table)
    bounds = [grid.GetBounds() for grid in parts.values()]
    is_plane = all(bound[4] == bound[5] for bound in bounds)
    add_bar(renderer, table, field.name.removesuffix("_").replace("_", "\n"), width)
    legend = f", {fields.STATUS}" if field.name == "contact_status" else f", largest {values.max():.4g}"
    if field.name.startswith("safety_"):
        legend = f", least {values.min():.4g}"
    add_note(renderer, f"step {step} of {len(of.times) - 1}, time {of.times[step]:.4g}{legend}, "
             f"displacements x {factor:g}" + (f", units {of.units}" if of.units else "") + doubts(path), width)
    return image_of(renderer, width, is_plane)


def doubts(path: str) -> str:
    """What a picture of a result that is not certified says of it, as its record beside it does."""
    record = fields.record_of(path)
    return f", {fields.verdict(record)}" if record and record.get("status") != "certified" else ""


def main(words: list[str] | None = None) -> int:
    """Does what the command line says; returns the exit code, 2 when the input is wrong."""
    parser = argparse.ArgumentParser(prog="harmos picture", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result")
    parser.add_argument("picture")
    parser.add_argument("--field", default="von_mises")
    parser.add_argument("--scale", type=float)
    parser.add_argument("--step", type=int)
    parser.add_argument("--width", type=int, default=1600)
    parser.add_argument("--interfaces", default="")
    arguments = parser.parse_args(words)
    try:
        if not 100 <= arguments.width <= 10000:
            raise ValueError(f"--width {arguments.width}: give 100 to 10000 pixels")
        for read in fields.files_of(arguments.result):
            demand_distinct(read, arguments.picture)
        of = fields.contents(arguments.result)
        field = fields.field(arguments.field, of)
        step = fields.step(arguments.step, of)
        names = arguments.interfaces.split(",") if arguments.interfaces else []
        fields.contacts(fields.read(fields.interfaces_of(arguments.result), step), names)
    except (OSError, ValueError) as error:
        print(f"harmos picture: {error}\nNothing was written.", file=sys.stderr)
        return 2
    try:
        with display():
            png = picture(arguments.result, of, field, step, arguments.scale, arguments.width, names)
        replace_file(arguments.picture, png)
        print(arguments.picture, flush=True)
    except (OSError, ValueError) as error:
        print(f"harmos picture: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
