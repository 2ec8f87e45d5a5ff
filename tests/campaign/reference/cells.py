"""Faces as flat cells, and cells cut into ever smaller ones by brute force."""
from __future__ import annotations

import dataclasses
import itertools

import numpy as np
import numpy.typing as npt

from ..scenes.mesh import Floats, Integers
from .shapes import FACES, shape_of

# Polygons between the nodes, by which a quadratic face is replaced; node 8 is the place in the middle.
_PARTS: dict[str, tuple[tuple[int, ...], ...]] = {
    "LINE2": ((0, 1),), "TRI3": ((0, 1, 2),), "QUAD4": ((0, 1, 2, 3),),
    "LINE3": ((0, 2), (2, 1)),
    "TRI6": ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
    "QUAD8": ((0, 4, 8, 7), (4, 1, 5, 8), (8, 5, 2, 6), (7, 8, 6, 3)),
    "QUAD9": ((0, 4, 8, 7), (4, 1, 5, 8), (8, 5, 2, 6), (7, 8, 6, 3)),
}
# Of lengths, relative to the cell: what is closer lies on the boundary.
ON_BOUNDARY = 1e-9
# Cells per edge, of which the number is taken that leaves fewest on boundaries of the other side.
MOST_DIVISIONS = 12


@dataclasses.dataclass(frozen=True)
class Cell:
    """A flat polygon. face: number. corners [corner, axis]. axes: of its plane [axis of the plane, axis]. normal: of
    length 1, as of the face. size: its longest edge."""
    face: int
    corners: Floats
    axes: Floats
    normal: Floats
    size: float

    def on_plane(self, places: Floats) -> Floats:
        """Coordinates [place, axis of the plane] of what is seen along the normal."""
        return np.asarray((places - self.corners[0]) @ self.axes.T)

    def height(self, place: Floats) -> float:
        """Along the normal."""
        return float((place - self.corners[0]) @ self.normal)


def _cell(face: int, corners: Floats) -> Cell:
    edges = np.roll(corners, -1, axis=0) - corners
    size = float(np.linalg.norm(edges, axis=1).max())
    along = edges[0] / np.linalg.norm(edges[0])
    if corners.shape[1] == 2:
        return Cell(face, corners, along[None], np.array([along[1], -along[0]]), size)
    middle = corners.mean(axis=0)
    normal = sum(np.cross(a - middle, b - middle) for a, b in zip(corners, np.roll(corners, -1, axis=0)))
    normal = normal / np.linalg.norm(normal)
    along = along - (along @ normal) * normal
    along /= np.linalg.norm(along)
    return Cell(face, corners, np.array([along, np.cross(normal, along)]), np.asarray(normal), size)


def cells_of(faces: list[Integers], nodes: Floats) -> list[Cell]:
    """The cells of faces."""
    result = []
    for number, face in enumerate(faces):
        kind = FACES[nodes.shape[1], len(face)]
        places = nodes[face]
        if len(places) == 8:
            places = np.vstack([places, shape_of(kind).values(np.zeros((1, 2))) @ places])
        result += [_cell(number, places[list(part)]) for part in _PARTS[kind]]
    return result


def divide(corners: Floats, count: int) -> Floats:
    """Equal parts [part, corner, axis] of a line, a triangle or a quadrilateral, count of them along each edge."""
    step = np.arange(count + 1) / count
    if len(corners) == 2:
        points = corners[0] + step[:, None] * (corners[1] - corners[0])
        return np.stack([points[:-1], points[1:]], axis=1)
    parts = []
    for i, j in itertools.product(range(count), repeat=2):
        if len(corners) == 4:
            parts.append([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)])
        elif i + j < count:
            parts.append([(i, j), (i + 1, j), (i, j + 1)])
            if i + j < count - 1:
                parts.append([(i + 1, j), (i + 1, j + 1), (i, j + 1)])
    grid = np.array(parts) / count
    u, v = grid[..., :1], grid[..., 1:]
    if len(corners) == 3:
        return np.asarray(corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]))
    return np.asarray((1 - u) * (1 - v) * corners[0] + u * (1 - v) * corners[1] + u * v * corners[2]
                      + (1 - u) * v * corners[3])


def contains(polygon: Floats, places: Floats, slack: float) -> npt.NDArray[np.bool_]:
    """Whether places [..., axis of the plane] lie in a convex polygon or on its boundary."""
    if len(polygon) == 2:
        along = places[..., 0]
        return np.asarray((along >= polygon[:, 0].min() - slack) & (along <= polygon[:, 0].max() + slack))
    edges = np.roll(polygon, -1, axis=0) - polygon
    inwards = np.column_stack([-edges[:, 1], edges[:, 0]])
    turn = edges[0, 0] * inwards[-1, 0] + edges[0, 1] * inwards[-1, 1]
    inwards *= np.sign(turn) / np.linalg.norm(inwards, axis=1)[:, None]
    heights = np.einsum("...ci,ci->...c", places[..., None, :] - polygon, inwards)
    return np.asarray((heights >= -slack).all(axis=-1))


@dataclasses.dataclass
class Sorted:
    """Parts of a cell by the polygon they lie in: parts [part, corner, axis of the plane], owner: number of the polygon.
    mixed: parts that lie on boundaries of polygons and were not divided any more."""
    parts: Floats
    owner: Integers
    mixed: Floats


def _sort(parts: Floats, polygons: list[Floats], slack: float) -> tuple[Integers, npt.NDArray[np.bool_]]:
    """The polygon of every part, or -1; and whether it is known, also as the part of none."""
    owner = np.full(len(parts), -1, dtype=np.int64)
    apart = np.ones(len(parts), dtype=bool)
    lower, upper = parts.min(axis=1), parts.max(axis=1)
    for number, polygon in enumerate(polygons):
        near = ((upper > polygon.min(axis=0) + slack) & (lower < polygon.max(axis=0) - slack)).all(axis=1)
        apart &= ~near
        candidates = np.flatnonzero(near & (owner < 0))
        owner[candidates[contains(polygon, parts[candidates], slack).all(axis=1)]] = number
    return owner, (owner >= 0) | apart


def sort_parts(cell: Floats, polygons: list[Floats], slack: float, finest: int) -> Sorted:
    """Cuts a cell until every part lies in one polygon or in none, or `finest` parts lie along an edge."""
    counts = range(1, 2 if len(cell) == 2 else MOST_DIVISIONS + 1)
    unknown = [(~_sort(divide(cell, count), polygons, slack)[1]).mean() for count in counts]
    count = counts[int(np.argmin(unknown))]
    parts = divide(cell, count)
    kept, owners = [], []
    while True:
        owner, known = _sort(parts, polygons, slack)
        kept.append(parts[owner >= 0])
        owners.append(owner[owner >= 0])
        parts = parts[~known]
        if len(parts) == 0 or 2 * count > finest:
            return Sorted(np.concatenate(kept), np.concatenate(owners), parts)
        parts = np.concatenate([divide(part, 2) for part in parts])
        count *= 2
