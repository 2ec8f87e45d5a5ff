"""A finite element mesh: nodes, one block of elements per part, side sets."""
from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

# Local corners of the sides, numbered as Exodus II numbers them.
_CORNER_SIDES: dict[str, tuple[tuple[int, ...], ...]] = {
    "TRI3": ((0, 1), (1, 2), (2, 0)),
    "QUAD4": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "TET4": ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)),
    "WEDGE6": ((0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5)),
    "HEX8": ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)),
}

# The linear element with the same corners.
LINEAR = {"TRI6": "TRI3", "QUAD8": "QUAD4", "QUAD9": "QUAD4", "TET10": "TET4", "WEDGE15": "WEDGE6", "HEX20": "HEX8",
          "HEX27": "HEX8"} | {name: name for name in _CORNER_SIDES}

_EDGES: dict[str, tuple[tuple[int, ...], ...]] = {
    "TRI3": ((0, 1), (1, 2), (2, 0)),
    "QUAD4": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "TET4": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    "WEDGE6": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 4), (2, 5), (3, 4), (4, 5), (5, 3)),
    "HEX8": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)),
}


def middles(kind: str) -> tuple[tuple[int, ...], ...]:
    """Of the nodes after the corners, the corners that each is in the middle of."""
    linear = LINEAR[kind]
    if kind == linear:
        return ()
    if kind == "QUAD9":
        return _EDGES[linear] + ((0, 1, 2, 3),)
    if kind == "HEX27":
        sides = _CORNER_SIDES[linear]
        return _EDGES[linear] + (tuple(range(8)),) + tuple(sides[i] for i in (4, 5, 3, 1, 0, 2))
    return _EDGES[linear]


def _side(kind: str, corners: tuple[int, ...]) -> tuple[int, ...]:
    """Corners, then the nodes between neighbours, then the one in the middle of the side."""
    count = 1 + max(max(side) for side in _CORNER_SIDES[LINEAR[kind]])
    number = {frozenset(of): count + i for i, of in enumerate(middles(kind))}
    between = [frozenset((corners[i - 1], corners[i])) for i in range(len(corners))]
    between = between[1:] + between[:1] if len(corners) > 2 else between[:1]
    centre = [frozenset(corners)] if len(corners) > 2 else []
    return corners + tuple(number[key] for key in between + centre if key in number)


# Local nodes of the sides: corners, then middles.
SIDES = {kind: tuple(_side(kind, corners) for corners in _CORNER_SIDES[linear]) for kind, linear in LINEAR.items()}


@dataclasses.dataclass(frozen=True)
class Block:
    """Elements of one type. nodes: elements x nodes per element, from 0."""
    name: str
    type: str
    nodes: Integers


@dataclasses.dataclass(frozen=True)
class Side:
    """One side of one element, both numbered from 0; elements are counted over all blocks."""
    element: int
    side: int


@dataclasses.dataclass
class Mesh:
    """nodes: count x dimension [length]. Parts share no nodes."""
    nodes: Floats
    blocks: list[Block]
    side_sets: dict[str, list[Side]] = dataclasses.field(default_factory=dict)

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return int(self.nodes.shape[1])

    def nodes_of_side(self, side: Side) -> Integers:
        """Nodes of a side in such an order that its normal points out of the element."""
        first = 0
        for block in self.blocks:
            if side.element < first + len(block.nodes):
                return np.asarray(block.nodes[side.element - first][list(SIDES[block.type][side.side])])
            first += len(block.nodes)
        raise IndexError(f"there is no element {side.element}")
