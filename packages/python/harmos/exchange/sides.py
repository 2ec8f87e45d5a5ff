"""Finds the sides of elements that faces of a file lie on."""
import numpy

from harmos.arrays import Array
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Faces, Mesh, clean_name, codes, faces_of, unused_name


class SideFinder:
    """Sides of the elements of a mesh by the nodes at their corners."""

    def __init__(self, mesh: Mesh) -> None:
        """Copies what it needs of the mesh."""
        self._faces: Faces = faces_of(mesh)
        self._key = self._faces.key()

    def find(self, corners: Array) -> tuple[Array, int]:
        """For faces given by rows of corner nodes, in any order and with -1 behind those of faces with fewer: a side
        set of all sides that have them, two where a face lies between elements; and how many faces are sides of no
        element."""
        wanted = numpy.full((len(corners), self._key.shape[1]), -1, dtype=numpy.int64)
        wanted[:, :corners.shape[1]] = corners
        near = numpy.flatnonzero(numpy.isin(self._key, wanted).all(axis=1))
        ours, theirs = codes(self._key[near], numpy.sort(wanted, axis=1))
        lost = int((~numpy.isin(theirs, ours)).sum())
        return self._faces.chosen(near[numpy.isin(ours, theirs)]).rows(), lost


def split_by_part(mesh: Mesh, rows: Array) -> dict[str, Array]:
    """A side set, part by part."""
    names = list(mesh.parts())
    part = numpy.asarray(mesh.part_of_block())[mesh.block_of(rows[:, 0])]
    return {names[number]: rows[part == number] for number in numpy.unique(part)}


def add_side_set(mesh: Mesh, name: str, rows: Array) -> list[str]:
    """Adds faces to the side sets: as one, or as one per part where they lie between parts. The names that they got."""
    pieces = split_by_part(mesh, rows)
    between = len(pieces) > 1 and _has_twins(mesh, rows)
    named = {f"{name}_{part}": piece for part, piece in pieces.items()} if between else {name: rows}
    for each, piece in named.items():
        mesh.side_sets[each] = piece
    return list(named)


def add_node_set(mesh: Mesh, name: str, nodes: Array, findings: Findings) -> None:
    """Adds nodes, each once, to the node sets; tells of another name where a set has this one already."""
    own = unused_name(name, {**mesh.side_sets, **mesh.node_sets})
    if own != clean_name(name):
        findings.found.append(f"the nodes of group \"{name}\" are the node set {own} here: a set of that name is there already")
    mesh.node_sets[own] = numpy.unique(nodes)


def _has_twins(mesh: Mesh, rows: Array) -> bool:
    """Whether two of the sides have the same corners."""
    keys = []
    first = mesh.first_elements()
    blocks = mesh.block_of(rows[:, 0])
    for element, side, block in zip(rows[:, 0], rows[:, 1], blocks):
        of = mesh.blocks[block]
        keys.append(tuple(sorted(of.connectivity[element - first[block], list(of.type.sides[side])])))
    return len(set(keys)) < len(keys)
