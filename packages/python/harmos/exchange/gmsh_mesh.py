"""Meshes of Gmsh (.msh 1, 2.2, 4.0, 4.1, ASCII and binary), read and written by Gmsh's library."""
import collections
import contextlib
import pathlib
import re
from collections.abc import Iterator

import gmsh
import numpy

from harmos.arrays import Array
from harmos.exchange.elements import GMSH, TYPES, to_exodus
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Block, Mesh, unused_name, without_loose_nodes, without_twins
from harmos.exchange.sense import oriented
from harmos.exchange.sides import SideFinder, add_node_set, add_side_set


@contextlib.contextmanager
def session() -> Iterator[None]:
    """Starts Gmsh's library, which prints nothing, and ends it."""
    gmsh.initialize(["harmos"], False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("General.NumThreads", 1)
        # Of partitioned meshes of format 2.2 it would look for elements between partitions, and end where there are none.
        gmsh.option.setNumber("Mesh.PartitionCreateTopology", 0)
        yield
    finally:
        gmsh.finalize()


def read_gmsh(path: str, findings: Findings) -> Mesh:
    """Reads a mesh; physical groups become blocks, side sets and node sets.

    Raises:
        Refused: the file is damaged, or has elements that Harmos has not.
    """
    _demand_sections(path)
    with session():
        gmsh.logger.start()
        try:
            gmsh.open(path)
        except Exception as error:  # Gmsh raises nothing more special
            raise Refused(f"{path}: Gmsh cannot read it: {error}. It is damaged or no mesh.") from None
        finally:
            said = gmsh.logger.get()
            gmsh.logger.stop()
        errors = [line for line in said if line.startswith(("Error", "Warning"))]
        serious = [line for line in errors if line.startswith("Error")]
        if serious:
            raise Refused(f"{path}: Gmsh cannot read it: {serious[0].split(':', 1)[1].strip()}. It is damaged.")
        mesh = mesh_of_model(path, findings)
    for line in dict.fromkeys(errors):
        findings.found.append(f"Gmsh says: {line.split(':', 1)[1].strip()}")
    return mesh


def _demand_sections(path: str) -> None:
    """Refuses a file whose sections do not end or that is no mesh of Gmsh; Gmsh itself reads what there is of it."""
    content = pathlib.Path(path).read_bytes()
    if not content.lstrip().startswith(b"$"):
        raise Refused(f"{path}:1: this is no mesh of Gmsh: it does not begin with $MeshFormat.")
    if content.lstrip().startswith(b"$NOD"):  # format 1
        for word in ("ENDNOD", "ELM", "ENDELM"):
            if not re.search(rb"^\$%s\b" % word.encode(), content, re.MULTILINE):
                raise Refused(f"{path}:{content.count(b'%c' % 10) + 1}: there is no ${word}; the file is truncated or damaged.")
        return
    ended = set(re.findall(rb"^\$End(\w+)", content, re.MULTILINE))
    known = (b"MeshFormat", b"PhysicalNames", b"Entities", b"Nodes", b"Elements", b"PartitionedEntities", b"Periodic",
             b"ParametricNodes")
    if b"ParametricNodes" in ended:
        ended.add(b"Nodes")
    for match in re.finditer(rb"^\$(\w+)\s*$", content, re.MULTILINE):
        name = match.group(1)
        if name in known and name not in ended:
            line = content.count(b"\n", 0, match.start()) + 1
            raise Refused(f"{path}:{line}: the section ${name.decode()} does not end; the file is truncated or damaged.")
    for name in (b"MeshFormat", b"Nodes", b"Elements"):
        if name not in ended:
            raise Refused(f"{path}:{content.count(b'%c' % 10) + 1}: there is no section ${name.decode()}; the file is "
                          "truncated or damaged.")


def mesh_of_model(path: str, findings: Findings) -> Mesh:
    """The mesh of Gmsh's current model."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    if not len(tags):
        raise Refused(f"{path}: it holds no nodes.")
    number = numpy.full(int(tags.max()) + 1, -1, dtype=numpy.int64)
    number[tags.astype(numpy.int64)] = numpy.arange(len(tags))
    nodes = numpy.asarray(coordinates).reshape(-1, 3)
    if not numpy.isfinite(nodes).all():
        raise Refused(f"{path}: a coordinate is not a finite number.")
    dimension = max((dim for dim, tag in gmsh.model.getEntities() if len(gmsh.model.mesh.getElements(dim, tag)[0])),
                    default=0)
    findings.found += [f"physical group \"{name}\" of the file holds no elements" for name in _empty_groups(path)]
    if dimension < 2:
        raise Refused(f"{path}: it holds no elements that fill a space or a plane.")
    if dimension == 2 and numpy.ptp(nodes[:, 2]) > 1e-9 * max(numpy.ptp(nodes, axis=0)):
        raise Refused(f"{path}: its elements are a surface in space; Harmos has solids, and plane meshes with z = 0.\n"
                      "  Where surfaces only are in physical groups, Gmsh writes no others: put the volumes in one as well.")
    mesh = Mesh(dimension, nodes, [], node_numbers=tags.astype(numpy.int64))
    _read_blocks(path, mesh, number, findings)
    twice = without_twins(mesh)
    if twice:
        findings.found.append(f"{twice} elements are there twice, as format 2.2 writes those of several groups, and count once")
    _read_sets(path, mesh, number, findings)
    oriented(mesh, findings)
    loose = without_loose_nodes(mesh)
    if loose:
        findings.found.append(f"{loose} nodes belong to no element and have been left out")
    return mesh


def _empty_groups(path: str) -> list[str]:
    """Names of a .msh file that belong to no group that Gmsh has read."""
    section = re.search(rb"^\$PhysicalNames\s*$(.*?)^\$EndPhysicalNames", pathlib.Path(path).read_bytes(), re.MULTILINE | re.DOTALL)
    named = re.findall(rb'^\s*(\d+)\s+(-?\d+)\s+"(.*)"\s*$', section.group(1), re.MULTILINE) if section else []
    there = set(gmsh.model.getPhysicalGroups())
    return [name.decode(errors="replace") for dimension, tag, name in named if (int(dimension), int(tag)) not in there]


def _groups(dimension: int, findings: Findings) -> dict[str, list[int]]:
    """Entities of every physical group of a dimension, with the partitions of each, by its name; a name that is there twice
    gets a number."""
    partitions = collections.defaultdict(list)
    for _, entity in gmsh.model.getEntities(dimension):
        of, parent = gmsh.model.getParent(dimension, entity)
        if of == dimension:
            partitions[parent].append(entity)
    result: dict[str, list[int]] = {}
    for _, tag in gmsh.model.getPhysicalGroups(dimension):
        word = {0: "point", 1: "curve", 2: "surface", 3: "volume"}[dimension]
        name = gmsh.model.getPhysicalName(dimension, tag) or f"{word}_{tag}"
        own = unused_name(name, result)
        if own != name:
            findings.found.append(f"physical group \"{name}\" (number {tag}) is called {own} here")
        entities = [int(each) for each in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)]
        result[own] = list(dict.fromkeys(each for entity in entities for each in (entity, *partitions[entity])))
        if not any(len(gmsh.model.mesh.getElements(dimension, entity)[0]) for entity in result[own]):
            findings.found.append(f"physical group \"{name}\" of the file holds no elements")
    return result


def _elements(path: str, dimension: int, entities: list[int], number: Array) -> dict[int, tuple[Array, Array]]:
    """Rows of nodes, and the tags of the elements, by the type of Gmsh."""
    rows = collections.defaultdict(list)
    tags = collections.defaultdict(list)
    for entity in entities:
        for kind, own, flat in zip(*gmsh.model.mesh.getElements(dimension, entity)):
            count = gmsh.model.mesh.getElementProperties(kind)[3]
            flat = numpy.asarray(flat, dtype=numpy.int64)
            if flat.size and (flat.max() >= len(number) or (number[flat] < 0).any()):
                raise Refused(f"{path}: an element refers to a node that is not there; the file is damaged.")
            rows[int(kind)].append(number[flat].reshape(-1, count))
            tags[int(kind)].append(numpy.asarray(own, dtype=numpy.int64))
    return {kind: (numpy.concatenate(tables), numpy.concatenate(tags[kind])) for kind, tables in rows.items()}


def _read_blocks(path: str, mesh: Mesh, number: Array, findings: Findings) -> None:
    taken: set[int] = set()
    groups = _groups(mesh.dimension, findings)
    for name, entities in groups.items():
        again = sorted(taken & set(entities))
        if again:
            findings.leave_out(path, f"physical group \"{name}\"",
                               f"its entities {again} belong to an earlier group and stay there; a block holds each once")
        groups[name] = [entity for entity in entities if entity not in taken]
        taken |= set(entities)
    for _, entity in gmsh.model.getEntities(mesh.dimension):
        is_copy = gmsh.model.getType(mesh.dimension, entity).startswith("Ghost")  # of elements of another partition
        if entity not in taken and not is_copy and len(gmsh.model.mesh.getElements(mesh.dimension, entity)[0]):
            name = gmsh.model.getEntityName(mesh.dimension, entity).split("/")[-1]
            groups[unused_name(name or f"{'volume' if mesh.dimension == 3 else 'surface'}_{entity}", groups)] = [entity]
    unknown = collections.Counter[str]()
    names: set[str] = set()
    for part, entities in groups.items():
        elements = _elements(path, mesh.dimension, entities, number)
        for kind, (rows, tags) in elements.items():
            if kind not in GMSH:
                unknown[f"\"{gmsh.model.mesh.getElementProperties(kind)[0]}\" in {part}"] += len(rows)
                continue
            name, order = GMSH[kind]
            block = unused_name(part if len(elements) == 1 else f"{part}_{name.lower()}", names)
            names.add(block)
            mesh.blocks.append(Block(block, TYPES[name], to_exodus(name, order, rows), part, tags))
    if unknown:
        listed = ", ".join(f"{count} of type {what}" for what, count in unknown.items())
        raise Refused(f"{path}: Harmos has not these elements: {listed}.\n"
                      f"  It has {', '.join(each.name for each in TYPES.values() if each.dimension == mesh.dimension)}: "
                      "mesh these parts anew.")


def _read_sets(path: str, mesh: Mesh, number: Array, findings: Findings) -> None:
    finder = SideFinder(mesh)
    for name, entities in _groups(mesh.dimension - 1, findings).items():
        rows = []
        for kind, (nodes, _) in _elements(path, mesh.dimension - 1, entities, number).items():
            corners = gmsh.model.mesh.getElementProperties(kind)[5]
            table = numpy.full((len(nodes), 4 if mesh.dimension == 3 else 2), -1, dtype=numpy.int64)
            table[:, :corners] = nodes[:, :corners]
            rows.append(table)
        if not rows:
            continue
        sides, lost = finder.find(numpy.concatenate(rows))
        if lost:
            findings.leave_out(path, f"physical group \"{name}\"", f"{lost} of its faces are sides of no element")
        if len(sides):
            made = add_side_set(mesh, unused_name(name, mesh.side_sets), sides)
            if len(made) > 1:
                findings.found.append(f"\"{name}\" lies between parts: side sets {', '.join(made)}")
    for dimension in range(mesh.dimension - 1):
        for name, entities in _groups(dimension, findings).items():
            held = [table.reshape(-1) for table, _ in _elements(path, dimension, entities, number).values()]
            if held:
                add_node_set(mesh, name, numpy.concatenate(held), findings)
