"""A finite element mesh: nodes, one block of elements per part, side sets."""
from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

# Local nodes of the sides, numbered as Exodus II numbers them.
SIDES: dict[str, tuple[tuple[int, ...], ...]] = {
    "TRI3": ((0, 1), (1, 2), (2, 0)),
    "QUAD4": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "TET4": ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)),
    "HEX8": ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)),
}


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
