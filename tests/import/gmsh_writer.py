"""Writes meshes as Gmsh does, to see whether they come back."""
import os
from collections.abc import Iterator

import gmsh
import numpy

from harmos.exchange.elements import GMSH, permutation
from harmos.exchange.gmsh_mesh import session
from harmos.exchange.mesh import Mesh


def write_gmsh(path: str | os.PathLike[str], mesh: Mesh, version: float = 4.1, binary: bool = False) -> None:
    """Writes a mesh of which no two side sets and no two node sets share a face or node: groups of Gmsh hold entities.

    Raises:
        ValueError: two sets do.
    """
    tags = numpy.arange(1, len(mesh.nodes) + 1) if mesh.node_numbers is None else mesh.node_numbers
    of_exodus = {name: (kind, order) for kind, (name, order) in GMSH.items()}
    with session():
        gmsh.model.add("harmos")
        volume = gmsh.model.addDiscreteEntity(mesh.dimension)
        gmsh.model.mesh.addNodes(mesh.dimension, volume, tags, mesh.nodes.reshape(-1))
        next_tag = 1 if mesh.element_numbers() is None else int(mesh.element_numbers().max()) + 1
        for number, block in enumerate(mesh.blocks):
            entity = volume if number == 0 else gmsh.model.addDiscreteEntity(mesh.dimension)
            kind, order = of_exodus[block.type.name]
            rows = tags[block.connectivity[:, numpy.argsort(permutation(block.type.name, order))]]
            own = range(next_tag, next_tag + len(rows)) if block.numbers is None else block.numbers
            gmsh.model.mesh.addElementsByType(entity, kind, own, rows.reshape(-1))
            next_tag += len(rows) if block.numbers is None else 0
            _name_group(mesh.dimension, entity, block.name)
        used: set[tuple[int, ...]] = set()
        for name, entries in mesh.side_sets.items():
            entity = gmsh.model.addDiscreteEntity(mesh.dimension - 1)
            for face in _side_nodes(mesh, entries):
                key = tuple(sorted(face))
                if key in used:
                    raise ValueError(f"side set \"{name}\" shares a face with another one")
                used.add(key)
                gmsh.model.mesh.addElementsByType(entity, {2: 1, 3: 2, 4: 3}[len(face)], [next_tag],
                                                  [tags[node] for node in face])
                next_tag += 1
            _name_group(mesh.dimension - 1, entity, name)
        for name, nodes in mesh.node_sets.items():
            entity = gmsh.model.addDiscreteEntity(0)
            gmsh.model.mesh.addElementsByType(entity, 15, range(next_tag, next_tag + len(nodes)), tags[nodes])
            next_tag += len(nodes)
            _name_group(0, entity, name)
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", int(binary))
        gmsh.write(os.fspath(path))


def _name_group(dimension: int, entity: int, name: str) -> None:
    group = gmsh.model.addPhysicalGroup(dimension, [entity])
    gmsh.model.setPhysicalName(dimension, group, name)


def _side_nodes(mesh: Mesh, entries: numpy.ndarray) -> Iterator[list[int]]:
    first, blocks = mesh.first_elements(), mesh.block_of(entries[:, 0])
    for (element, side), number in zip(entries, blocks):
        block = mesh.blocks[number]
        yield block.connectivity[element - first[number], list(block.type.sides[side])].tolist()
