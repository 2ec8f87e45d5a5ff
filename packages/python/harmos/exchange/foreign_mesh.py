"""Meshes that meshio reads, unstructured grids of VTK (.vtu, .vtk), and others in its terms."""
import collections
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.elements import MESHIO, TYPES, to_exodus
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Block, Mesh, clean_name, unused_name, without_loose_nodes, without_twins
from harmos.exchange.sense import oriented
from harmos.exchange.sides import SideFinder, add_node_set, add_side_set

_FLAT = {"vertex": 0, "line": 1, "line3": 1, "triangle": 2, "triangle6": 2, "quad": 2, "quad8": 2, "quad9": 2}


@dataclasses.dataclass
class Cells:
    """Elements of one type.

    Attributes:
        type: in the words of meshio.
        data: nodes, a row per element, in its order.
        numbers: by which the file knows the elements; None: by none.
    """
    type: str
    data: Array
    numbers: "Array | None" = None


@dataclasses.dataclass
class Source:
    """A mesh as meshio has it.

    Attributes:
        points: a row per node.
        cells: tables of elements.
        cell_data: arrays by name, one per table.
        point_data: arrays by name.
        field_data: number and dimension of physical groups, by name.
        cell_tags: names of groups of each family of elements.
        point_tags: the same of nodes.
        point_numbers: by which the file knows the nodes; None: by none.
    """
    points: Array
    cells: list[Cells]
    cell_data: dict[str, list[Array]]
    point_data: dict[str, Array]
    field_data: dict[str, Array] = dataclasses.field(default_factory=dict)
    cell_tags: dict[int, list[str]] = dataclasses.field(default_factory=dict)
    point_tags: dict[int, list[str]] = dataclasses.field(default_factory=dict)
    point_numbers: "Array | None" = None


def read_meshio(path: str, findings: Findings) -> Mesh:
    """Reads a mesh; cells become one block per type, or per value of the cells' whole numbers "part", "material" or "gmsh:physical".

    Raises:
        Refused: the file is damaged, or has elements that Harmos has not.
    """
    import meshio  # which what has been read otherwise does not need
    try:
        source = meshio.read(path)
    except (Exception, SystemExit) as error:  # meshio raises anything on damaged files, and ends the process on some
        raise Refused(f"{path}: meshio cannot read it: {type(error).__name__}: {error}. It is damaged, no mesh, or of a kind that "
                      "meshio has not.\n  Write it as text, as .vtu or as .msh.") from None
    cells = [Cells(each.type, each.data) for each in source.cells]
    return mesh_of(path, Source(source.points, cells, source.cell_data, source.point_data, source.field_data,
                                getattr(source, "cell_tags", {}), getattr(source, "point_tags", {})), findings)


def mesh_of(path: str, source: Source, findings: Findings) -> Mesh:
    """What meshio has read as a mesh of Harmos.

    Raises:
        Refused: as above.
    """
    nodes = numpy.zeros((len(source.points), 3))
    nodes[:, :source.points.shape[1]] = source.points
    if not len(nodes) or not numpy.isfinite(nodes).all():
        raise Refused(f"{path}: it holds no nodes, or one that is not at finite coordinates.")
    solid = any(cells.type in MESHIO and TYPES[MESHIO[cells.type][0]].dimension == 3 for cells in source.cells)
    mesh = Mesh(3 if solid else 2, nodes, [], node_numbers=source.point_numbers)
    if not solid and numpy.ptp(nodes[:, 2]) > 1e-9 * max(numpy.ptp(nodes, axis=0)):
        raise Refused(f"{path}: its elements are a surface in space; Harmos has solids, and plane meshes with z = 0.")
    _read_cells(path, source, mesh, findings)
    if not mesh.blocks:
        raise Refused(f"{path}: it holds no elements that fill a space or a plane.")
    oriented(mesh, findings)
    loose = without_loose_nodes(mesh)
    if loose:
        findings.found.append(f"{loose} nodes belong to no element and have been left out")
    return mesh


def _group_names(source: Source, index: int, name: str) -> list[tuple[str, Array]]:
    """Names of the groups of the cells of a table, and which cells are in each."""
    families = source.cell_tags
    data = source.cell_data
    if "cell_tags" in data:
        values = numpy.asarray(data["cell_tags"][index])
        result = collections.defaultdict(list)
        for family in sorted(set(values.tolist()), reverse=True):
            for group in families.get(int(family), []):
                result[group].append(values == family)
        return [(group, numpy.logical_or.reduce(masks)) for group, masks in result.items()]
    for key in ("part", "material", "gmsh:physical"):
        if key in data:
            values = numpy.asarray(data[key][index]).reshape(-1)
            called = {int(field[0]): text for text, field in source.field_data.items()}
            return [(called.get(value, f"{name}_{value}"), values == value) for value in sorted(set(map(int, values)))]
    return []


def _read_cells(path: str, source: Source, mesh: Mesh, findings: Findings) -> None:
    parts: dict[str, dict[str, list[tuple[Array, Array]]]] = {}  # rows of nodes, and numbers, 0 where the file has none
    surfaces: dict[str, list[Array]] = {}
    held: dict[str, list[Array]] = collections.defaultdict(list)
    unknown = collections.Counter[str]()
    for index, cells in enumerate(source.cells):
        table = numpy.asarray(cells.data, dtype=numpy.int64)
        if table.size and (table.max() >= len(mesh.nodes) or table.min() < 0):
            raise Refused(f"{path}: an element refers to a node that is not there; the file is damaged.")
        fills = cells.type in MESHIO and TYPES[MESHIO[cells.type][0]].dimension == mesh.dimension
        if not fills and cells.type not in _FLAT:
            unknown[cells.type] += len(table)
            continue
        numbers = numpy.zeros(len(table), dtype=numpy.int64) if cells.numbers is None else cells.numbers
        left = numpy.ones(len(table), dtype=bool)
        grouped = numpy.zeros(len(table), dtype=bool)
        for group, inside in _group_names(source, index, "part"):
            if fills:
                if (inside & ~left).any():
                    findings.leave_out(path, f"group \"{group}\"", "elements of an earlier group stay there")
                inside = inside & left
                left &= ~inside
                parts.setdefault(group, {}).setdefault(cells.type, []).append((table[inside], numbers[inside]))
            elif _FLAT[cells.type] == mesh.dimension - 1:
                grouped |= inside
                rows = numpy.full((int(inside.sum()), 4 if mesh.dimension == 3 else 2), -1, dtype=numpy.int64)
                corners = {"triangle": 3, "quad": 4, "line": 2}[cells.type.rstrip("0123456789")]
                rows[:, :corners] = table[inside][:, :corners]
                surfaces.setdefault(group, []).append(rows)
            else:
                held[group].append(table[inside].reshape(-1))
        if not fills and _FLAT[cells.type] == mesh.dimension - 1 and not grouped.all():
            findings.found.append(f"{int((~grouped).sum())} cells {cells.type} are in no group, and no side set")
        if fills and left.any():
            parts.setdefault("part", {}).setdefault(cells.type, []).append((table[left], numbers[left]))
    if unknown:
        listed = ", ".join(f"{count} {kind}" for kind, count in unknown.items())
        raise Refused(f"{path}: Harmos has not these elements: {listed}.\n"
                      f"  It has {', '.join(each.name for each in TYPES.values() if each.dimension == mesh.dimension)}: "
                      "mesh these parts anew.")
    names: set[str] = set()
    for part, tables in parts.items():
        for kind, of_kind in tables.items():
            if not sum(len(rows) for rows, _ in of_kind):
                continue
            name, order = MESHIO[kind]
            block = unused_name(part if len(tables) == 1 else f"{part}_{name.lower()}", names)
            names.add(block)
            numbers = numpy.concatenate([numbers for _, numbers in of_kind])
            mesh.blocks.append(Block(block, TYPES[name], to_exodus(name, order, numpy.concatenate([rows for rows, _ in of_kind])),
                                     clean_name(part), numbers if numbers.all() else None))
    twice = without_twins(mesh)
    if twice:
        findings.found.append(f"{twice} elements are there twice, and count once")
    if mesh.blocks:
        _read_sets(path, source, mesh, surfaces, held, findings)


def _read_sets(path: str, source: Source, mesh: Mesh, surfaces: dict[str, list[Array]], held: dict[str, list[Array]],
               findings: Findings) -> None:
    finder = SideFinder(mesh)
    for name, rows in surfaces.items():
        sides, lost = finder.find(numpy.concatenate(rows))
        if lost:
            findings.leave_out(path, f"group \"{name}\"", f"{lost} of its faces are sides of no element")
        if len(sides):
            add_side_set(mesh, unused_name(name, mesh.side_sets), sides)
    if "point_tags" in source.point_data:
        family_of = numpy.asarray(source.point_data["point_tags"])
        for family, names in source.point_tags.items():
            for name in names:
                held[name].append(numpy.flatnonzero(family_of == family))
    for name, nodes in held.items():
        add_node_set(mesh, name, numpy.concatenate(nodes), findings)
