"""Meshes of parts that are unions of cells of one grid, carried into place by a map."""
from __future__ import annotations

import collections
import dataclasses
import itertools
from collections.abc import Callable, Sequence

import numpy as np

from .mesh import LINEAR, SIDES, Block, Floats, Mesh, Side, middles

Map = Callable[[Floats], Floats]
Cell = tuple[int, ...]

_CORNERS = {
    2: ((0, 0), (1, 0), (1, 1), (0, 1)),
    3: ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
}


@dataclasses.dataclass(frozen=True)
class Contact:
    """Where two parts meet in one plane of the grid: the side sets of both, the axis that the plane is normal to."""
    part1: str
    part2: str
    axis: int
    side1: str
    side2: str


def _simplices(dimension: int) -> list[tuple[tuple[int, ...], ...]]:
    """Corners of the simplices of Kuhn that fill a cell; all cells cut alike, so that the faces of neighbours agree."""
    result = []
    for order in itertools.permutations(range(dimension)):
        corner = [0] * dimension
        corners = [tuple(corner)]
        for axis in order:
            corner[axis] = 1
            corners.append(tuple(corner))
        edges = np.array(corners[1:]) - np.array(corners[0])
        if np.linalg.det(edges) < 0:
            corners[-1], corners[-2] = corners[-2], corners[-1]
        result.append(tuple(corners))
    return result


# Of two wedges that fill a cell, upright along axis 1.
_WEDGES = (((0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 1, 1), (1, 1, 0)),
           ((1, 0, 1), (1, 0, 0), (0, 0, 1), (1, 1, 1), (1, 1, 0), (0, 1, 1)))


def _pattern(kind: str, dimension: int) -> Sequence[tuple[tuple[int, ...], ...]]:
    """Corners of the elements of a type that fill a cell."""
    match LINEAR[kind]:
        case "TRI3" | "TET4":
            return _simplices(dimension)
        case "WEDGE6":
            return _WEDGES
    return [_CORNERS[dimension]]


class Lattice:
    """A grid whose cells are given to parts; every part has nodes of its own.

    lines: coordinates of the grid per axis. periodic: the last cell of axis 0 touches the first one, as in a ring.
    """

    def __init__(self, lines: Sequence[Sequence[float]], periodic: bool = False) -> None:
        self.lines = [np.asarray(line, dtype=float) for line in lines]
        self.shape = tuple(len(line) - 1 for line in self.lines)
        self.periodic = periodic
        self._owner: dict[Cell, str] = {}
        self._sides: dict[tuple[Cell, int, int], list[Side]] = {}
        self.mesh = Mesh(np.zeros((0, len(lines))), [])

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return len(self.lines)

    @property
    def parts(self) -> list[str]:
        """Names in the order in which cells were first given to them."""
        return list(dict.fromkeys(self._owner.values()))

    def fill(self, part: str, *ranges: tuple[int, int]) -> None:
        """Gives the cells begin <= i < end of every axis to a part, whoever had them; axes not named: all cells."""
        whole = list(ranges) + [(0, n) for n in self.shape[len(ranges):]]
        for cell in itertools.product(*(range(begin, end) for begin, end in whole)):
            self._owner[cell] = part

    def empty(self, *ranges: tuple[int, int]) -> None:
        """Takes cells away."""
        whole = list(ranges) + [(0, n) for n in self.shape[len(ranges):]]
        for cell in itertools.product(*(range(begin, end) for begin, end in whole)):
            self._owner.pop(cell, None)

    def build(self, types: dict[str, str], carry: Map) -> Mesh:
        """Makes the mesh; types: element type per part; carry: from the coordinates of the grid into place, also of
        the nodes between corners."""
        nodes: list[Floats] = []
        blocks: list[Block] = []
        elements = 0
        for part in self.parts:
            number: dict[Cell, int] = {}  # by twice the place in the grid
            rows: list[list[int]] = []
            for cell in sorted(c for c, owner in self._owner.items() if owner == part):
                for corners in _pattern(types[part], self.dimension):
                    offsets = [tuple(2 * o for o in corner) for corner in corners]
                    for of in middles(types[part]):
                        sums = np.sum([offsets[i] for i in of], axis=0)
                        offsets.append(tuple(int(s) // len(of) for s in sums))
                    row = []
                    for offset in offsets:
                        point = tuple(2 * c + o for c, o in zip(cell, offset))
                        if self.periodic and point[0] == 2 * self.shape[0]:
                            point = (0,) + point[1:]
                        row.append(number.setdefault(point, len(nodes) + len(number)))
                    for side, local in enumerate(SIDES[LINEAR[types[part]]]):
                        self._note(cell, [corners[i] for i in local], Side(elements + len(rows), side))
                    rows.append(row)
            for point in number:
                places = [0.5 * (line[i // 2] + line[(i + 1) // 2]) for line, i in zip(self.lines, point)]
                nodes.append(np.array(places))
            blocks.append(Block(part, types[part], np.array(rows, dtype=np.int64)))
            elements += len(rows)
        self.mesh = Mesh(carry(np.array(nodes)), blocks)
        return self.mesh

    def _note(self, cell: Cell, corners: list[tuple[int, ...]], side: Side) -> None:
        for axis in range(self.dimension):
            for end in (0, 1):
                if all(corner[axis] == end for corner in corners):
                    self._sides.setdefault((cell, axis, end), []).append(side)

    def _neighbour(self, cell: Cell, axis: int, end: int) -> Cell:
        moved = list(cell)
        moved[axis] += 1 if end else -1
        if self.periodic and axis == 0:
            moved[0] %= self.shape[0]
        return tuple(moved)

    def contacts(self) -> list[Contact]:
        """All planes in which parts meet; adds their side sets to the mesh. Part 1 lies below along the axis."""
        planes: dict[tuple[str, str, int, int], list[Cell]] = collections.defaultdict(list)
        for cell, owner in sorted(self._owner.items()):
            for axis in range(self.dimension):
                other = self._owner.get(self._neighbour(cell, axis, 1))
                if other is not None and other != owner:
                    planes[owner, other, axis, cell[axis]].append(cell)
        result: list[Contact] = []
        for (part1, part2, axis, index), cells in planes.items():
            name = f"j{len(result)}"
            self.mesh.side_sets[name + "_1"] = [s for c in cells for s in self._sides[c, axis, 1]]
            self.mesh.side_sets[name + "_2"] = [s for c in cells
                                                for s in self._sides[self._neighbour(c, axis, 1), axis, 0]]
            result.append(Contact(part1, part2, axis, name + "_1", name + "_2"))
        return result

    def outer(self, name: str, part: str, axis: int, end: int, *ranges: tuple[int, int]) -> str:
        """Adds a side set of the outer faces of a part that look along an axis (end 1) or against it (end 0).

        ranges: of cells, per axis; those not named: all. Returns its name; raises when there are no such faces.
        """
        whole = list(ranges) + [(0, n) for n in self.shape[len(ranges):]]
        sides = []
        for cell, owner in sorted(self._owner.items()):
            inside = all(begin <= c < end_ for c, (begin, end_) in zip(cell, whole))
            if owner == part and inside and self._neighbour(cell, axis, end) not in self._owner:
                sides += self._sides[cell, axis, end]
        if not sides:
            raise ValueError(f"{name}: part {part} has no outer faces there")
        self.mesh.side_sets[name] = sides
        return name




def cells(lengths: Sequence[float], counts: Sequence[int]) -> list[float]:
    """Coordinates of grid lines: segments of these lengths, divided equally into so many cells each."""
    lines = [0.0]
    for length, count in zip(lengths, counts):
        lines += [lines[-1] + length * (i + 1) / count for i in range(count)]
    return lines
