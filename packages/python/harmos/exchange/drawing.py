"""Drawings (STEP, BREP), meshed by Gmsh: solids become parts with their names, faces side sets."""
import gmsh
import numpy

from harmos.exchange.findings import Findings, Refused
from harmos.exchange.gmsh_mesh import mesh_of_model, session
from harmos.exchange.mesh import Mesh, clean_name, unused_name
from harmos.exchange.meshing import Meshing

CELLS = 20
"""Elements along the diagonal of the assembly when no size is given."""

AROUND = 16
"""Elements around a circle at least."""


def mesh_drawing(path: str, meshing: Meshing, findings: Findings) -> Mesh:
    """Meshes the solids of a drawing.

    Raises:
        Refused: the file is damaged, holds no solids, or cannot be meshed.
    """
    with session():
        gmsh.option.setNumber("Geometry.OCCImportLabels", 1)
        gmsh.logger.start()
        try:
            shapes = gmsh.model.occ.importShapes(path)
            gmsh.model.occ.synchronize()
        except Exception as error:  # Gmsh raises nothing more special
            raise Refused(f"{path}: Open CASCADE cannot read it: {error}. It is damaged or no drawing.") from None
        solids = [tag for dimension, tag in shapes if dimension == 3]
        if not solids:
            raise Refused(f"{path}: it holds no solids. Surfaces and curves have no volume to mesh.")
        parts = _names(solids)
        unknown = sorted(set(meshing.part_sizes) - set(parts))
        if unknown:
            raise Refused(f"{path}: there is no part \"{unknown[0]}\"; there are: {', '.join(parts)}.")
        pieces = {name: [tag] for name, tag in parts.items()}
        if meshing.conformal and len(solids) > 1:
            pieces = _fragmented(parts)
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
    findings.found.insert(0, f"{len(parts)} solids: {', '.join(parts)}")
    return mesh


def _names(solids: list[int]) -> dict[str, int]:
    """The solids by the last word of their names in the file."""
    result: dict[str, int] = {}
    for tag in solids:
        given = gmsh.model.getEntityName(3, tag).split("/")[-1]
        is_made_up = not given or given.startswith("Open CASCADE STEP translator")
        result[unused_name(f"solid_{tag}" if is_made_up else given, result)] = tag
    return result


def _fragmented(parts: dict[str, int]) -> dict[str, list[int]]:
    tags = [(3, tag) for tag in parts.values()]
    _, made = gmsh.model.occ.fragment(tags[:1], tags[1:])
    gmsh.model.occ.synchronize()
    taken: set[int] = set()
    result = {}
    for name, pieces in zip(parts, made):
        result[name] = [tag for _, tag in pieces if tag not in taken]
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
