"""Elements that Harmos has, and how other formats order their nodes.

Every node of an element lies amid some of its corners (at one, on an edge, on a face, inside); an order is a list of
these sets of corners, counted from 0, and the way from one order to another follows from them.
"""
import dataclasses
import functools

import numpy

from harmos.arrays import Array

Spot = frozenset[int]
"""Corners that a node lies amid."""

Order = tuple[Spot, ...]
"""Where the nodes of an element lie, in the order of a format."""


def _spots(*edges_or_faces: str) -> list[Spot]:
    return [frozenset(int(digit) for digit in word) for group in edges_or_faces for word in group.split()]


def order(corners: int, *edges_or_faces: str) -> Order:
    """The corners in their own order, then what is amid them: words of digits, such as "01 12 20"."""
    return tuple([frozenset([corner]) for corner in range(corners)] + _spots(*edges_or_faces))


@dataclasses.dataclass(frozen=True)
class ElementType:
    """A type of elements, as Exodus numbers it.

    Attributes:
        name: in Exodus.
        dimension: of the space it fills.
        order: of its nodes in Exodus.
        sides: corners of each side, seen from outside counter-clockwise; the sides of Exodus, counted from 0.
    """
    name: str
    dimension: int
    order: Order
    sides: tuple[tuple[int, ...], ...]

    @property
    def nodes(self) -> int:
        """How many nodes it has."""
        return len(self.order)

    @property
    def corners(self) -> int:
        """How many corners it has."""
        return sum(len(spot) == 1 for spot in self.order)

    def nodes_of_side(self, side: int) -> list[int]:
        """Numbers of all nodes of a side."""
        return [node for node, spot in enumerate(self.order) if spot <= set(self.sides[side])]

    def mirrored(self) -> list[int]:
        """The order of nodes that turns an element inside out, for those that a format numbers in the other sense."""
        swap = {3: [0, 2, 1], 4: [0, 3, 2, 1] if self.dimension == 2 else [0, 2, 1, 3], 5: [0, 3, 2, 1, 4],
                6: [3, 4, 5, 0, 1, 2], 8: [4, 5, 6, 7, 0, 1, 2, 3]}[self.corners]
        at = {spot: node for node, spot in enumerate(self.order)}
        return [at[frozenset(swap[corner] for corner in spot)] for spot in self.order]

    def mirrored_sides(self) -> list[int]:
        """For every side the number that it has in an element that is turned inside out."""
        of = self.mirrored()
        moved = [{of[corner] for corner in side} for side in self.sides]
        return [moved.index(set(side)) for side in self.sides]


_TRI = ((0, 1), (1, 2), (2, 0))
_QUAD = ((0, 1), (1, 2), (2, 3), (3, 0))
_TET = ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1))
_PYRAMID = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 4, 3), (0, 3, 2, 1))
_WEDGE = ((0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5))
_HEX = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7))
_HEX20 = ("01 12 23 30", "04 15 26 37", "45 56 67 74")

TYPES: dict[str, ElementType] = {each.name: each for each in (
    ElementType("TRI3", 2, order(3), _TRI),
    ElementType("TRI6", 2, order(3, "01 12 20"), _TRI),
    ElementType("QUAD4", 2, order(4), _QUAD),
    ElementType("QUAD8", 2, order(4, "01 12 23 30"), _QUAD),
    ElementType("QUAD9", 2, order(4, "01 12 23 30", "0123"), _QUAD),
    ElementType("TET4", 3, order(4), _TET),
    ElementType("TET10", 3, order(4, "01 12 20", "03 13 23"), _TET),
    ElementType("PYRAMID5", 3, order(5), _PYRAMID),
    ElementType("WEDGE6", 3, order(6), _WEDGE),
    ElementType("WEDGE15", 3, order(6, "01 12 20", "03 14 25", "34 45 53"), _WEDGE),
    ElementType("HEX8", 3, order(8), _HEX),
    ElementType("HEX20", 3, order(8, *_HEX20), _HEX),
    ElementType("HEX27", 3, order(8, *_HEX20, "01234567", "0321 4567 0473 1265 0154 2376"), _HEX),
)}
"""All of them by name."""

GMSH: dict[int, tuple[str, Order]] = {
    2: ("TRI3", order(3)), 3: ("QUAD4", order(4)), 4: ("TET4", order(4)), 5: ("HEX8", order(8)),
    6: ("WEDGE6", order(6)), 7: ("PYRAMID5", order(5)), 9: ("TRI6", order(3, "01 12 20")),
    10: ("QUAD9", order(4, "01 12 23 30", "0123")), 11: ("TET10", order(4, "01 12 20 03 23 13")),
    12: ("HEX27", order(8, "01 03 04 12 15 23 26 37 45 47 56 67", "0321 0154 0473 1265 2376 4567", "01234567")),
    16: ("QUAD8", order(4, "01 12 23 30")),
    17: ("HEX20", order(8, "01 03 04 12 15 23 26 37 45 47 56 67")),
    18: ("WEDGE15", order(6, "01 02 03 12 14 25 34 35 45")),
}
"""Types of Gmsh by number."""

_VTK_HEX20 = ("01 12 23 30", "45 56 67 74", "04 15 26 37")

MESHIO: dict[str, tuple[str, Order]] = {
    "triangle": ("TRI3", order(3)), "triangle6": ("TRI6", order(3, "01 12 20")), "quad": ("QUAD4", order(4)),
    "quad8": ("QUAD8", order(4, "01 12 23 30")), "quad9": ("QUAD9", order(4, "01 12 23 30", "0123")),
    "tetra": ("TET4", order(4)), "tetra10": ("TET10", order(4, "01 12 20", "03 13 23")),
    "pyramid": ("PYRAMID5", order(5)), "wedge": ("WEDGE6", order(6)),
    "wedge15": ("WEDGE15", order(6, "01 12 20", "34 45 53", "03 14 25")), "hexahedron": ("HEX8", order(8)),
    "hexahedron20": ("HEX20", order(8, *_VTK_HEX20)),
    "hexahedron27": ("HEX27", order(8, *_VTK_HEX20, "0473 1265 0154 2376 0321 4567", "01234567")),
}
"""Types of meshio, which orders nodes as VTK does."""


@functools.cache
def permutation(name: str, given: Order) -> tuple[int, ...]:
    """For every node of Exodus' order its position in the given one."""
    at = {spot: position for position, spot in enumerate(given)}
    return tuple(at[spot] for spot in TYPES[name].order)


def to_exodus(name: str, given: Order, connectivity: Array) -> Array:
    """Rows of nodes in a given order, in that of Exodus."""
    return numpy.ascontiguousarray(connectivity[:, permutation(name, given)])
