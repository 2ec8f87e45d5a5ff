"""Draws the deformed parts, transparent, with the contact pressure on their interfaces to a PNG file.

python3 -m harmos.render RESULT.e PICTURE.png [--scale 100] [--step -1] [--width 1600] [--interfaces a,b]

RESULT_interfaces.e is looked for beside RESULT.e. Without a display, run it under xvfb-run -a.
"""
import argparse
from collections.abc import Collection

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

PALETTE = [(0.62, 0.68, 0.75), (0.75, 0.69, 0.60), (0.62, 0.72, 0.62), (0.74, 0.62, 0.62), (0.66, 0.62, 0.74)]
"""Colours of the parts, in turn."""


def read(path: str, step: int) -> dict[str, vtk.vtkUnstructuredGrid]:
    """The element blocks of an Exodus file by name, at a time step from 0; negative ones count from the last."""
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    for i in range(reader.GetNumberOfElementBlockArrays()):
        reader.SetElementBlockArrayStatus(reader.GetElementBlockArrayName(i), 1)
    reader.SetApplyDisplacements(0)
    reader.SetTimeStep(step % reader.GetNumberOfTimeSteps())
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    result = {}
    for i in range(blocks.GetNumberOfBlocks()):
        if blocks.GetBlock(i):
            result[blocks.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME())] = blocks.GetBlock(i)
    return result


def deformed(grid: vtk.vtkUnstructuredGrid, scale: float) -> vtk.vtkPolyData:
    """The surface of a block, with its displacements times `scale`."""
    grid.GetPointData().SetActiveVectors("disp_")
    warp = vtk.vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetScaleFactor(scale)
    surface = vtk.vtkGeometryFilter()
    surface.SetInputConnection(warp.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def actor(mapper: vtk.vtkMapper) -> vtk.vtkActor:
    """What shows the output of a mapper."""
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    return result


def add_part(renderer: vtk.vtkRenderer, surface: vtk.vtkPolyData, colour: tuple[float, float, float]) -> None:
    """Shows the surface of a part, transparent, with its edges."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    body = actor(mapper)
    body.GetProperty().SetColor(colour)
    body.GetProperty().SetOpacity(0.10)
    renderer.AddActor(body)
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


def colours(largest: float) -> vtk.vtkColorTransferFunction:
    """Colours of pressures from 0 to the largest."""
    table = vtk.vtkColorTransferFunction()
    for fraction, rgb in ((0, (0.93, 0.95, 0.97)), (0.15, (0.99, 0.87, 0.55)), (0.45, (0.96, 0.52, 0.24)),
                          (0.75, (0.80, 0.16, 0.22)), (1, (0.35, 0.02, 0.20))):
        table.AddRGBPoint(fraction * largest, *rgb)
    return table


def contacts(surfaces: dict[str, vtk.vtkUnstructuredGrid],
             names: Collection[str]) -> dict[str, vtk.vtkUnstructuredGrid]:
    """The interfaces of these names; without names, all that are contacts."""
    if names:
        return {name: surfaces[name] for name in names}
    # 0 open, 1 stick, 2 slip: a contact.
    return {name: grid for name, grid in surfaces.items()
            if grid.GetPointData().GetArray("contact_status").GetRange()[1] <= 2}


def add_contact(renderer: vtk.vtkRenderer, surface: vtk.vtkPolyData, table: vtk.vtkColorTransferFunction,
                largest: float) -> None:
    """Shows the pressure on the surface of an interface, coloured from 0 to the largest."""
    surface.GetPointData().SetActiveScalars("contact_pressure")
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(0, largest)
    mapper.SetInterpolateScalarsBeforeMapping(1)
    # Faces of two parts lie in the same place: the pressure wins.
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-4, -4)
    shown = actor(mapper)
    shown.GetProperty().SetAmbient(0.8)
    shown.GetProperty().SetDiffuse(0.2)
    renderer.AddActor(shown)


def add_bar(renderer: vtk.vtkRenderer, table: vtk.vtkColorTransferFunction, width: int) -> None:
    """Shows what the colours mean; `width` is that of the picture in pixels."""
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("contact\npressure")
    bar.SetNumberOfLabels(5)
    bar.SetUnconstrainedFontSize(True)
    for text, size in ((bar.GetTitleTextProperty(), 26), (bar.GetLabelTextProperty(), 22)):
        text.SetColor(0.1, 0.1, 0.1)
        text.SetFontSize(size * width // 1600)
        text.SetItalic(False)
        text.SetShadow(False)
        text.SetBold(False)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.87, 0.15)
    bar.SetWidth(0.06)
    bar.SetHeight(0.7)
    renderer.AddActor(bar)


def write(renderer: vtk.vtkRenderer, path: str, width: int) -> None:
    """Looks at what the renderer has from the front, left and above, and writes a PNG file `width` pixels wide."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(-0.55, -1, 0.85)
    camera.SetViewUp(0, 0, 1)
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
    camera.Zoom(1.4)
    camera.SetWindowCenter(0.10, 0.0)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main() -> None:
    """Does what the command line says."""
    parser = argparse.ArgumentParser(prog="python3 -m harmos.render", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result")
    parser.add_argument("picture")
    parser.add_argument("--scale", type=float, default=100.0)
    parser.add_argument("--step", type=int, default=-1)
    parser.add_argument("--width", type=int, default=1600)
    parser.add_argument("--interfaces", default="")
    arguments = parser.parse_args()

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for i, grid in enumerate(read(arguments.result, arguments.step).values()):
        add_part(renderer, deformed(grid, arguments.scale), PALETTE[i % len(PALETTE)])
    interfaces = read(arguments.result.removesuffix(".e") + "_interfaces.e", arguments.step)
    shown = contacts(interfaces, arguments.interfaces.split(",") if arguments.interfaces else ()).values()
    pressures = [vtk_to_numpy(grid.GetPointData().GetArray("contact_pressure")) for grid in shown]
    # Peaks at the edges of a contact would leave one colour for all the rest.
    largest = (numpy.percentile(numpy.concatenate(pressures), 90) if pressures else 0.0) or 1.0
    table = colours(largest)
    for grid in shown:
        add_contact(renderer, deformed(grid, arguments.scale), table, largest)
    add_bar(renderer, table, arguments.width)
    write(renderer, arguments.picture, arguments.width)


if __name__ == "__main__":
    main()
