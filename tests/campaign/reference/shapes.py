"""Shape functions of elements and faces from the monomials they span and the places of their nodes."""
from __future__ import annotations

import functools
import itertools

import numpy as np

from ..scenes.mesh import LINEAR, Floats, Integers, middles

_CORNERS: dict[str, tuple[tuple[float, ...], ...]] = {
    "LINE2": ((-1,), (1,)),
    "TRI3": ((0, 0), (1, 0), (0, 1)),
    "QUAD4": ((-1, -1), (1, -1), (1, 1), (-1, 1)),
    "TET4": ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "WEDGE6": ((0, 0, -1), (1, 0, -1), (0, 1, -1), (0, 0, 1), (1, 0, 1), (0, 1, 1)),
    "HEX8": ((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)),
}
# By dimension of the mesh and number of nodes.
FACES = {(2, 2): "LINE2", (2, 3): "LINE3", (3, 3): "TRI3", (3, 4): "QUAD4", (3, 6): "TRI6", (3, 8): "QUAD8",
         (3, 9): "QUAD9"}


def _superlinear(exponents: tuple[int, ...]) -> int:
    """Degree without factors that are linear: at most 2 in serendipity elements (Arnold, Awanou 2011)."""
    return sum(e for e in exponents if e > 1)


def _exponents(kind: str) -> list[tuple[int, ...]]:
    def product(dimension: int, degree: int) -> list[tuple[int, ...]]:
        return list(itertools.product(range(degree + 1), repeat=dimension))

    match kind:
        case "LINE2" | "QUAD4" | "HEX8":
            return product(len(_CORNERS[kind][0]), 1)
        case "LINE3":
            return product(1, 2)
        case "QUAD9" | "HEX27":
            return product(2 if kind == "QUAD9" else 3, 2)
        case "QUAD8" | "HEX20":
            return [e for e in product(2 if kind == "QUAD8" else 3, 2) if _superlinear(e) <= 2]
        case "TRI3" | "TET4":
            return [e for e in product(len(_CORNERS[kind][0]), 1) if sum(e) <= 1]
        case "TRI6" | "TET10":
            return [e for e in product(2 if kind == "TRI6" else 3, 2) if sum(e) <= 2]
        case "WEDGE6":
            return [e for e in product(3, 1) if e[0] + e[1] <= 1]
        case "WEDGE15":
            return [e for e in product(3, 2) if e[0] + e[1] + (1 if e[2] == 2 else 0) <= 2]
    raise ValueError(f"unknown element {kind}")


class Shape:
    """N_a, each 1 at its own node and 0 at the others. nodes: places [node, axis] in the parent domain."""

    def __init__(self, kind: str) -> None:
        linear = "LINE2" if kind.startswith("LINE") else LINEAR[kind]
        corners = np.array(_CORNERS[linear], dtype=float)
        between = ((0, 1),) if kind == "LINE3" else () if kind == "LINE2" else middles(kind)
        self.nodes = np.array(list(corners) + [corners[list(of)].mean(axis=0) for of in between])
        self.corners = len(corners)
        self.exponents: Integers = np.array(_exponents(kind), dtype=np.int64)
        self.coefficients = np.linalg.inv(self._monomials(self.nodes))

    def _monomials(self, places: Floats) -> Floats:
        return np.asarray((places[:, None, :] ** self.exponents).prod(axis=2))

    def values(self, places: Floats) -> Floats:
        """N [place, node]."""
        return np.asarray(self._monomials(places) @ self.coefficients)

    def slopes(self, places: Floats) -> Floats:
        """dN [place, node, axis of the parent domain]."""
        result = []
        for axis in range(places.shape[1]):
            lower = self.exponents.copy()
            lower[:, axis] = np.maximum(0, lower[:, axis] - 1)
            factors = (places[:, None, :] ** lower).prod(axis=2) * self.exponents[:, axis]
            result.append(factors @ self.coefficients)
        return np.stack(result, axis=2)


@functools.cache
def shape_of(kind: str) -> Shape:
    """The shape functions of an element or a face by its name in Exodus, or LINE2, LINE3."""
    return Shape(kind)


def gauss(count: int, dimension: int) -> tuple[Floats, Floats]:
    """Gauss' points [point, axis] and weights on [-1, 1]^dimension."""
    places, weights = np.polynomial.legendre.leggauss(count)  # type: ignore[no-untyped-call]
    grid = np.array(list(itertools.product(places, repeat=dimension)))
    return grid, np.array([np.prod(w) for w in itertools.product(weights, repeat=dimension)])


def _triangle(degree: int) -> tuple[Floats, Floats]:
    """Strang and Fix: 3 points of degree 2, 6 of degree 4."""
    orbits = {2: ((1 / 6, 1 / 6),), 4: ((0.445948490915965, 0.223381589678011 / 2),
                                        (0.091576213509771, 0.109951743655322 / 2))}[degree]
    places = [p for a, _ in orbits for p in ((a, a), (1 - 2 * a, a), (a, 1 - 2 * a))]
    return np.array(places), np.repeat([w for _, w in orbits], 3)


def _cone(count: int) -> tuple[Floats, Floats]:
    """On the tetrahedron, of degree 2 count - 3, from Gauss' points on the cube (Duffy)."""
    grid, weights = gauss(count, 3)
    u, v, w = ((1 + grid) / 2).T
    places = np.column_stack([u, v * (1 - u), w * (1 - u) * (1 - v)])
    return places, weights / 8 * (1 - u) ** 2 * (1 - v)


@functools.cache
def rule_of(kind: str) -> tuple[Floats, Floats]:
    """Places and weights of full integration."""
    match kind:
        case "LINE2" | "QUAD4" | "HEX8":
            return gauss(2, len(_CORNERS[kind][0]))
        case "LINE3":
            return gauss(3, 1)
        case "QUAD8" | "QUAD9":
            return gauss(3, 2)
        case "HEX20" | "HEX27":
            return gauss(3, 3)
        case "TRI3":
            return _triangle(2)
        case "TRI6":
            return _triangle(4)
        case "TET4" | "TET10":
            return _cone(4)
    triangle, weights = _triangle(2 if kind == "WEDGE6" else 4)
    line, along = gauss(2 if kind == "WEDGE6" else 3, 1)
    places = [[*p, z] for p in triangle for z in line[:, 0]]
    return np.array(places), np.outer(weights, along).ravel()
