"""A mesh with blocks, side sets and node sets, as Harmos reads it."""
import dataclasses
import re
import unicodedata
from collections.abc import Callable, Container

import numpy

from harmos.arrays import Array
from harmos.exchange.elements import ElementType
from harmos.exchange.findings import Refused

FORBIDDEN = re.compile(r"[^A-Za-z0-9_.+-]+")
"""What no name of a block or set may hold: overrides and files are addressed by them."""

LONGEST_NAME = 64
"""Letters of a name at most, in a scene and so in meshes."""


LARGEST_COORDINATE = 1e100
"""Products of three lengths are numbers."""


def clean_name(name: str) -> str:
    """A name that may stand in a scene and in every format; letters lose their accents."""
    parted = unicodedata.normalize("NFKD", name.strip().replace("\u00df", "ss"))
    cleaned = FORBIDDEN.sub("_", "".join(letter for letter in parted if not unicodedata.combining(letter))).strip("_")
    return cleaned[:LONGEST_NAME] or "unnamed"


def ended_name(name: str, end: str) -> str:
    """A name with something at its end, cut in between where it would be too long."""
    return name[:LONGEST_NAME - len(end)] + end


def unused_name(wanted: str, taken: Container[str]) -> str:
    """The wanted name, made fit, with a number at its end if it is taken."""
    name = clean_name(wanted)
    number = 2
    result = name
    while result in taken:
        end = f"_{number}"
        result = ended_name(name, end)
        number += 1
    return result


@dataclasses.dataclass
class Block:
    """Elements of one type.

    Attributes:
        name: of the block.
        type: of its elements.
        connectivity: nodes, counted from 0, in the order of Exodus; a row per element.
        part: that it belongs to; empty: one of its own name.
        numbers: by which the file knows the elements; None: by none.
    """
    name: str
    type: ElementType
    connectivity: Array
    part: str = ""
    numbers: "Array | None" = None


@dataclasses.dataclass(frozen=True)
class Plane:
    """A plane.

    Attributes:
        point: on it [length].
        normal: of length 1.
    """
    point: tuple[float, ...]
    normal: tuple[float, ...]


@dataclasses.dataclass
class Mesh:
    """A mesh; elements are counted from 0 through all blocks.

    Attributes:
        dimension: 2 or 3.
        nodes: coordinates, n x 3 [length]; z is 0 in the plane.
        blocks: in the order of the file.
        side_sets: by name, rows of element and side.
        node_sets: by name, nodes.
        planes: across parts, by their names, along which their elements have faces.
        node_numbers: by which the file knows the nodes; None: by none.
        fitted: parts whose curved faces lie in each other, where the facets of their meshes need not.
    """
    dimension: int
    nodes: Array
    blocks: list[Block]
    side_sets: dict[str, Array] = dataclasses.field(default_factory=dict)
    node_sets: dict[str, Array] = dataclasses.field(default_factory=dict)
    planes: dict[str, Plane] = dataclasses.field(default_factory=dict)
    node_numbers: "Array | None" = None
    fitted: list[tuple[str, str]] = dataclasses.field(default_factory=list)

    def first_elements(self) -> Array:
        """Number of the first element of every block, and at the end the number of all."""
        return numpy.cumsum([0] + [len(block.connectivity) for block in self.blocks])

    def block_of(self, elements: Array) -> Array:
        """Number of the block of each of the elements."""
        return numpy.searchsorted(self.first_elements(), elements, side="right") - 1

    def parts(self) -> dict[str, list[int]]:
        """Numbers of the blocks of every part, by its name."""
        result: dict[str, list[int]] = {}
        for number, block in enumerate(self.blocks):
            result.setdefault(block.part or block.name, []).append(number)
        return result

    def part_of_block(self) -> list[int]:
        """Number of the part of every block."""
        names = list(self.parts())
        return [names.index(block.part or block.name) for block in self.blocks]

    def element_numbers(self) -> "Array | None":
        """By which the file knows the elements; None where blocks have none."""
        numbers = [block.numbers for block in self.blocks if block.numbers is not None]
        return numpy.concatenate(numbers) if numbers and len(numbers) == len(self.blocks) else None

    def text(self) -> str:
        """Its sizes in words."""
        return (f"{len(self.nodes)} nodes, {self.first_elements()[-1]} elements in {len(self.blocks)} blocks, "
                f"{len(self.side_sets)} side sets, {len(self.node_sets)} node sets")


@dataclasses.dataclass
class Faces:
    """Sides of elements.

    Attributes:
        corners: nodes at the corners, a row per face, -1 behind those of faces with fewer.
        element: of each face.
        side: of the element.
    """
    corners: Array
    element: Array
    side: Array

    def key(self) -> Array:
        """A row per face that is the same for faces with the same corners."""
        return numpy.sort(self.corners, axis=1)

    def chosen(self, which: Array) -> "Faces":
        """Some of them, by number or mask."""
        return Faces(self.corners[which], self.element[which], self.side[which])

    def rows(self) -> Array:
        """As a side set."""
        return numpy.column_stack([self.element, self.side])


def faces_of(mesh: Mesh) -> Faces:
    """All sides of all elements."""
    corners, element, side = [], [], []
    first = mesh.first_elements()
    width = 4 if mesh.dimension == 3 else 2
    for start, block in zip(first, mesh.blocks):
        for number, nodes in enumerate(block.type.sides):
            rows = numpy.full((len(block.connectivity), width), -1, dtype=numpy.int64)
            rows[:, :len(nodes)] = block.connectivity[:, nodes]
            corners.append(rows)
            element.append(numpy.arange(start, start + len(rows)))
            side.append(numpy.full(len(rows), number))
    return Faces(numpy.concatenate(corners), numpy.concatenate(element), numpy.concatenate(side))


def codes(rows: Array, more: Array) -> tuple[Array, Array]:
    """Numbers that tell rows of two tables apart: equal rows have equal numbers."""
    both = numpy.concatenate([rows, more])
    if not len(both):
        return numpy.zeros(0, dtype=numpy.int64), numpy.zeros(0, dtype=numpy.int64)
    number = numpy.unique(both, axis=0, return_inverse=True)[1].reshape(-1)
    return number[:len(rows)], number[len(rows):]


def outer_faces(mesh: Mesh) -> Faces:
    """Faces that lie on the surface of a part."""
    faces = faces_of(mesh)
    parts = numpy.asarray(mesh.part_of_block())
    keyed = numpy.column_stack([parts[mesh.block_of(faces.element)], faces.key()])
    _, inverse, count = numpy.unique(keyed, axis=0, return_inverse=True, return_counts=True)
    return faces.chosen(count[inverse.reshape(-1)] == 1)


def _twins(mesh: Mesh) -> Array:
    """Whether an element has the nodes of an earlier one, a flag per element."""
    width = max((block.connectivity.shape[1] for block in mesh.blocks), default=1)
    rows = numpy.full((int(mesh.first_elements()[-1]), width), -1, dtype=numpy.int64)
    for first, block in zip(mesh.first_elements(), mesh.blocks):
        rows[first:first + len(block.connectivity), :block.connectivity.shape[1]] = numpy.sort(block.connectivity, axis=1)
    # Sums of products with odd numbers, modulo 2^64, tell rows apart; those that are equal are compared.
    odd = numpy.random.default_rng(1).integers(1, 2**62, width) * 2 + 1
    code = (rows * odd).sum(axis=1)
    order = numpy.argsort(code, kind="stable")
    same = (code[order][1:] == code[order][:-1]) & (rows[order][1:] == rows[order][:-1]).all(axis=1)
    result = numpy.zeros(len(rows), dtype=bool)
    result[order[1:][same]] = True
    return result


def without_twins(mesh: Mesh) -> int:
    """Removes elements with the nodes of an earlier one from a mesh without sets; the number of those that were."""
    twin = _twins(mesh)
    if twin.any():
        first = mesh.first_elements()
        for number, block in enumerate(mesh.blocks):
            kept = ~twin[first[number]:first[number + 1]]
            block.connectivity = block.connectivity[kept]
            block.numbers = None if block.numbers is None else block.numbers[kept]
        mesh.blocks = [block for block in mesh.blocks if len(block.connectivity)]
    return int(twin.sum())


def without_loose_nodes(mesh: Mesh) -> int:
    """Removes nodes that no element has, from node sets as well; the number of those that were."""
    used = numpy.zeros(len(mesh.nodes), dtype=bool)
    for block in mesh.blocks:
        used[block.connectivity] = True
    if used.all():
        return 0
    number = numpy.cumsum(used) - 1
    mesh.nodes = mesh.nodes[used]
    mesh.node_numbers = None if mesh.node_numbers is None else mesh.node_numbers[used]
    for block in mesh.blocks:
        block.connectivity = number[block.connectivity]
    mesh.node_sets = {name: number[nodes[used[nodes]]] for name, nodes in mesh.node_sets.items()}
    return int((~used).sum())


def demand_sound(path: str, mesh: Mesh, name_of: "Callable[[int], str] | None" = None) -> None:
    """Refuses numbers that refer to nothing, which damaged files have. `name_of`: what the file calls an element, given its number
    from 0 in the mesh.

    Raises:
        Refused: some do.
    """
    usable = (numpy.abs(mesh.nodes) <= LARGEST_COORDINATE).all(axis=1)
    if not usable.all():
        number = int(numpy.flatnonzero(~usable)[0])
        named = number + 1 if mesh.node_numbers is None else mesh.node_numbers[number]
        raise Refused(f"{path}: node {named} is at no finite coordinates, or beyond {LARGEST_COORDINATE:g}; the file is damaged.")
    for first, block in zip(mesh.first_elements(), mesh.blocks):
        rows = block.connectivity
        if rows.size and (rows.min() < 0 or rows.max() >= len(mesh.nodes)):
            raise Refused(f"{path}: block \"{block.name}\" refers to a node that is not there; the file is damaged.")
        ordered = numpy.sort(rows, axis=1)
        twice = numpy.flatnonzero((ordered[:, 1:] == ordered[:, :-1]).any(axis=1))
        if len(twice):
            named = name_of(int(first + twice[0])) if name_of else (
                f"its element {twice[0] + 1}" if block.numbers is None else f"element {block.numbers[twice[0]]}")
            raise Refused(f"{path}: {len(twice)} elements of block \"{block.name}\" have a node twice, the first of them "
                          f"is {named}.\n  Mesh the part anew; collapsed elements are not supported.")
    twin = numpy.flatnonzero(_twins(mesh))
    if len(twin):
        block = mesh.blocks[int(mesh.block_of(twin[:1])[0])]
        named = f"{name_of(int(twin[0]))}, " if name_of else ""
        raise Refused(f"{path}: {len(twin)} elements have the nodes of another one, the first of them {named}in block \"{block.name}\".\n"
                      "  Remove those that are there twice.")
    count = mesh.first_elements()[-1]
    sides = numpy.array([len(block.type.sides) for block in mesh.blocks])
    for name, entries in mesh.side_sets.items():
        if len(entries) and (entries[:, 0].min() < 0 or entries[:, 0].max() >= count):
            raise Refused(f"{path}: side set \"{name}\" refers to an element that is not there; the file is damaged.")
        if ((entries[:, 1] < 0) | (entries[:, 1] >= sides[mesh.block_of(entries[:, 0])])).any():
            raise Refused(f"{path}: side set \"{name}\" refers to a side that is not there; the file is damaged.")
    for name, entries in mesh.node_sets.items():
        if len(entries) and (entries.min() < 0 or entries.max() >= len(mesh.nodes)):
            raise Refused(f"{path}: node set \"{name}\" refers to a node that is not there; the file is damaged.")
