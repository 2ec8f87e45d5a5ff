"""Drawings (STEP, BREP), meshed by Gmsh: solids become parts with their names, faces side sets."""
import itertools
import pathlib
import re

import gmsh
import numpy

from harmos.exchange.bolt_section import divide, plane_across
from harmos.exchange.coincidence import fitted_pairs
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.gmsh_mesh import mesh_of_model, session
from harmos.exchange.mesh import Mesh, clean_name, unused_name
from harmos.exchange.meshing import Meshing

CELLS = 20
"""Elements along the diagonal of the assembly when no size is given."""

AROUND = 16
"""Elements around a circle at least."""


UNITS = {1e-6: "UM", 1e-3: "MM", 1e-2: "CM", 0.0254: "INCH", 1.0: "M"}
"""Open CASCADE's names of the units to which it converts the lengths of STEP files, by their length [m]."""

OVERLAP = 1e-3
"""Volume that two solids share, over that of the smaller one, from which the import tells of it."""

PAIRS = 100
"""Pairs of solids of which that is looked at: each takes a Boolean operation."""


def mesh_drawing(path: str, meshing: Meshing, findings: Findings) -> Mesh:
    """Meshes the solids of a drawing.

    Raises:
        Refused: the file is damaged, holds no solids, or cannot be meshed.
    """
    _demand_whole_shapes(path)
    with session():
        gmsh.option.setNumber("Geometry.OCCImportLabels", 1)
        gmsh.option.setString("Geometry.OCCTargetUnit", UNITS[meshing.length])
        gmsh.logger.start()
        try:
            shapes = gmsh.model.occ.importShapes(path, highestDimOnly=False)
            gmsh.model.occ.synchronize()
            flat = _remove_loose()
        except Exception as error:  # Gmsh raises nothing more special
            raise Refused(f"{path}: Open CASCADE cannot read it: {error}. It is damaged or no drawing.") from None
        solids = [tag for dimension, tag in shapes if dimension == 3]
        if not solids:
            raise Refused(f"{path}: it holds no solids. Surfaces and curves have no volume to mesh.")
        parts = _names(solids)
        unknown = sorted({*meshing.part_sizes, *meshing.bolts} - set(parts))
        if unknown:
            raise Refused(f"{path}: there is no part \"{unknown[0]}\"; there are: {', '.join(parts)}.")
        if not meshing.conformal:
            findings.undecided += _overlaps(parts)
        fitted = fitted_pairs(parts)
        planes = {bolt: plane_across(bolt, parts, _bonded(bolt, parts, meshing)) for bolt in meshing.bolts}
        pieces = {name: divide(tag, planes[name]) if name in planes else [tag] for name, tag in parts.items()}
        if meshing.conformal and len(solids) > 1:
            pieces = _fragmented(pieces)
        _set_sizes(pieces, meshing)
        _name_groups(pieces)
        try:
            gmsh.model.mesh.generate(3)
            if meshing.order == 2:
                gmsh.model.mesh.setOrder(2)
        except Exception as error:
            said = [line for line in gmsh.logger.get() if line.startswith("Error")]
            raise Refused(f"{path}: Gmsh cannot mesh it: {said[0] if said else error}.\n  Try a smaller size.") from None
        mesh = mesh_of_model(path, findings)
        mesh.planes, mesh.fitted = planes, fitted
        mesh.node_numbers = None  # nobody has seen those of Gmsh
        for block in mesh.blocks:
            block.numbers = None
    findings.found.insert(0, f"{len(parts)} solids: {', '.join(parts)}")
    if meshing.length != 1e-3 and pathlib.Path(path).suffix.lower() in (".step", ".stp"):
        findings.found.insert(1, f"lengths of the drawing are converted to units of {meshing.length:g} m, as was asked for")
    if flat:
        findings.leave_out(path, "surfaces and curves", f"{flat} that belong to no solid")
    return mesh


def _demand_whole_shapes(path: str) -> None:
    """Refuses BREP files in text that end before their last shape: on some of them Open CASCADE never ends."""
    content = pathlib.Path(path).read_bytes()
    begins = re.search(rb"CASCADE Topology V\d", content[:4096])
    if not begins:
        return
    table = re.search(rb"^TShapes (\d+)", content, re.MULTILINE)
    count = content[table.end():].count(b"*") if table else 0
    if table is None or count < int(table[1]):
        told = f"{count} of {int(table[1])} shapes are there" if table else "its shapes are missing"
        raise Refused(f"{path}: the file is truncated: {told}.")


def _remove_loose() -> int:
    """Removes faces and edges that belong to nothing; how many."""
    loose = [(dimension, tag) for dimension, tag in gmsh.model.getEntities()
             if dimension in (1, 2) and not len(gmsh.model.getAdjacencies(dimension, tag)[0])]
    if loose and gmsh.model.getEntities(3):
        gmsh.model.occ.remove(loose, recursive=True)
        gmsh.model.occ.synchronize()
    return len(loose)


def _overlaps(parts: dict[str, int]) -> list[str]:
    """What to tell about solids that lie in each other."""
    boxes = {name: numpy.array(gmsh.model.occ.getBoundingBox(3, tag)) for name, tag in parts.items()}
    volume = {name: gmsh.model.occ.getMass(3, tag) for name, tag in parts.items()}
    pairs = [(one, other) for one, other in itertools.combinations(parts, 2)
             if (numpy.maximum(boxes[one][:3], boxes[other][:3]) < numpy.minimum(boxes[one][3:], boxes[other][3:])).all()]
    told = []
    for one, other in pairs[:PAIRS]:
        try:
            common, _ = gmsh.model.occ.intersect([(3, parts[one])], [(3, parts[other])], removeObject=False, removeTool=False)
        except Exception:  # Open CASCADE gives up on some shapes
            continue
        shared = sum(gmsh.model.occ.getMass(3, tag) for dimension, tag in common if dimension == 3)
        gmsh.model.occ.remove(common, recursive=True)
        if shared > OVERLAP * min(volume[one], volume[other]):
            told.append(f"{one} and {other} overlap by a volume of {shared:.4g}: both are meshed there; --conformal gives it to the "
                        "first")
    if len(pairs) > PAIRS:
        told.append(f"whether solids overlap was looked at for the first {PAIRS} of {len(pairs)} pairs that are near each other")
    gmsh.model.occ.synchronize()
    return told


def _names(solids: list[int]) -> dict[str, int]:
    """The solids by the last word of their names in the file."""
    result: dict[str, int] = {}
    for tag in solids:
        given = gmsh.model.getEntityName(3, tag).split("/")[-1]
        is_made_up = not given or given.startswith("Open CASCADE STEP translator")
        result[unused_name(f"solid_{tag}" if is_made_up else given, result)] = tag
    return result


def _bonded(bolt: str, parts: dict[str, int], meshing: Meshing) -> set[str]:
    """The parts to which a bolt is joined perfectly."""
    return {name for name in parts if {f"{name}_to_{bolt}", f"{bolt}_to_{name}"} & set(meshing.perfect)}


def _fragmented(pieces: dict[str, list[int]]) -> dict[str, list[int]]:
    owners = [name for name, tags in pieces.items() for _ in tags]
    tags = [(3, tag) for tags in pieces.values() for tag in tags]
    _, made = gmsh.model.occ.fragment(tags[:1], tags[1:])
    gmsh.model.occ.synchronize()
    taken: set[int] = set()
    result: dict[str, list[int]] = {name: [] for name in pieces}
    for name, become in zip(owners, made):
        result[name] += [tag for _, tag in become if tag not in taken]
        taken |= set(result[name])
    return result


def _set_sizes(pieces: dict[str, list[int]], meshing: Meshing) -> None:
    box = numpy.array(gmsh.model.getBoundingBox(-1, -1))
    size = meshing.size or float(numpy.linalg.norm(box[3:] - box[:3])) / CELLS
    gmsh.option.setNumber("Mesh.MeshSizeMax", max([size, *meshing.part_sizes.values()]))
    gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", AROUND)
    gmsh.option.setNumber("Mesh.Algorithm3D", 1)
    for name, tags in pieces.items():
        points = gmsh.model.getBoundary([(3, tag) for tag in tags], combined=False, oriented=False, recursive=True)
        gmsh.model.mesh.setSize(points, meshing.part_sizes.get(name, size))


def _name_groups(pieces: dict[str, list[int]]) -> None:
    owners: dict[int, list[str]] = {}
    for name, tags in pieces.items():
        group = gmsh.model.addPhysicalGroup(3, tags)
        gmsh.model.setPhysicalName(3, group, name)
        faces = gmsh.model.getBoundary([(3, tag) for tag in tags], combined=True, oriented=False)
        for _, face in faces:
            owners.setdefault(face, []).append(name)
    count: dict[str, int] = {}
    for face, names in owners.items():
        if len(names) > 1:
            continue
        count[names[0]] = count.get(names[0], 0) + 1
        group = gmsh.model.addPhysicalGroup(2, [face])
        gmsh.model.setPhysicalName(2, group, clean_name(f"{names[0]}_face_{count[names[0]]}"))
