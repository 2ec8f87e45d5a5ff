"""Joins of meshes that do not match, by brute-force quadrature: no polygon is clipped.

    (B_s)_pj = (1 / h_p) int psi_p N_j dS,    h_p = int psi_p dS

over what both sides have in common, seen along the normals of the cells of the side with the points. psi_p is dual to
the linear functions of the corners there; corners that hardly anything is covered of leave theirs to their neighbours.
"""
from __future__ import annotations

import dataclasses

import numpy as np
from scipy import sparse

from ..scenes.mesh import Floats, Integers
from .cells import ON_BOUNDARY, Cell, cells_of, contains, sort_parts
from .shapes import FACES, Shape, gauss, shape_of

# A corner of which less is covered is no point.
LEAST_COVERED = 0.05
# Cosine of the largest angle between normals of cells that face each other: 40 degrees.
OPPOSITE = -0.766
# Without a search distance, over the longest edge.
TOUCHING = 0.1
GAUSS = 4
# Held: cosine of directions that are one, most of that to the normal, and least weights on held nodes over others.
PARALLEL, HELD_ALONG, HELD_IN_PART = 0.99, 0.5, 0.2
# Weights on other nodes that parts of cells which are not cut on leave where there are none: 2e-5 has been seen.
OF_PARTS = 1e-4
# Unit vectors along which boundaries give the displacement, by node.
Held = dict[int, list[Floats]]
# In the plane, where only one part at every end of a face is cut on.
FINEST_LINE = 2**32


@dataclasses.dataclass(frozen=True)
class Join:
    """Points of a join. own, other: B of the side with the points and of the other one [point, node]. area: h.
    normal: out of the side with the points, not normalised. uncertain: area of the parts that lie on boundaries of
    the other side, as a share of all."""
    own: sparse.csr_matrix
    other: sparse.csr_matrix
    area: Floats
    normal: Floats
    uncertain: float


def _points_in(parts: Floats) -> tuple[Floats, Floats]:
    """Gauss' points [part, point, axis of the plane] and weights [part, point]."""
    grid, weights = gauss(GAUSS, 1)
    x, w = (1 + grid[:, 0]) / 2, weights / 2
    if parts.shape[1] == 2:
        length = parts[:, 1, 0] - parts[:, 0, 0]
        return (parts[:, None, 0] + x[None, :, None] * (parts[:, 1] - parts[:, 0])[:, None],
                np.asarray(abs(length)[:, None] * w))
    u, v = np.repeat(x, GAUSS)[None, :, None], np.tile(x, GAUSS)[None, :, None]
    weight = np.outer(w, w).ravel()
    if parts.shape[1] == 3:  # by a square whose one side shrinks to a point
        a, b, c = (parts[:, None, i] for i in range(3))
        places = a + u * (b - a) + v * (1 - u) * (c - a)
        du = np.asarray((b - a) - v * (c - a), dtype=float)
        dv = np.asarray((1 - u) * (c - a), dtype=float)
    else:
        a, b, c, d = (parts[:, None, i] for i in range(4))
        places = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        du = np.asarray((1 - v) * (b - a) + v * (c - d), dtype=float)
        dv = np.asarray((1 - u) * (d - a) + u * (c - b), dtype=float)
    return np.asarray(places), np.asarray(abs(du[..., 0] * dv[..., 1] - du[..., 1] * dv[..., 0]) * weight)


def _parents(shape: Shape, nodes: Floats, places: Floats) -> Floats:
    """Where the shape has its nodes, on a plane, and takes these places: by Newton's method from the middle."""
    parent = np.tile(shape.nodes[:shape.corners].mean(axis=0), (len(places), 1))
    for _ in range(30):
        missing = places - shape.values(parent) @ nodes
        if abs(missing).max(initial=0.0) <= 1e-14 * np.ptp(nodes, axis=0).max():
            break
        jacobian = np.einsum("pna,ni->pia", shape.slopes(parent), nodes)
        parent = parent + np.linalg.solve(jacobian, missing[:, :, None])[:, :, 0]
    return np.asarray(parent)


class _Side:
    def __init__(self, faces: list[Integers], nodes: Floats) -> None:
        self.faces = faces
        self.nodes = nodes
        self.cells = cells_of(faces, nodes)

    def shape(self, face: int) -> Shape:
        return shape_of(FACES[self.nodes.shape[1], len(self.faces[face])])

    def values(self, face: int, plane: Cell, places: Floats) -> tuple[Floats, Floats]:
        """All shape functions and those of the corners alone at places on a plane [place, node]."""
        shape = self.shape(face)
        corners = shape_of(FACES[self.nodes.shape[1], shape.corners])
        parent = _parents(shape, plane.on_plane(self.nodes[self.faces[face]]), places)
        return shape.values(parent), corners.values(parent)


class _Sums:
    """Integrals over what is covered of one face: mass of the corner functions, with all functions of both sides, with
    the normal; whole: of the corner functions over all of the face."""

    def __init__(self, face: Integers, corners: int, dimension: int, size: int) -> None:
        self.face = face
        self.mass = np.zeros((corners, corners))
        self.own = np.zeros((corners, size))
        self.other = np.zeros((corners, size))
        self.normal = np.zeros((corners, dimension))
        self.whole = np.zeros(corners)
        self.area = 0.0
        self.mixed = 0.0


def _facing(cell: Cell, others: list[Cell], reach: float | None) -> list[Cell]:
    result = []
    for other in others:
        distance = TOUCHING * max(cell.size, other.size) if reach is None else reach
        if cell.normal @ other.normal <= OPPOSITE and abs(cell.height(other.corners.mean(axis=0))) <= distance:
            result.append(other)
    return result


def _add(sums: _Sums, own: _Side, cell: Cell, other: _Side, facing: list[Cell], thickness: float, finest: int) -> None:
    flat = cell.on_plane(cell.corners)
    slack = ON_BOUNDARY * cell.size
    polygons = [cell.on_plane(one.corners) for one in facing]
    found = sort_parts(flat, polygons, slack, finest if flat.shape[1] == 2 else FINEST_LINE)
    places, weights = _points_in(np.concatenate([found.parts, found.mixed]))
    owner = np.repeat(np.concatenate([found.owner, np.full(len(found.mixed), -1)])[:, None], places.shape[1], axis=1)
    for number, polygon in enumerate(polygons):  # point by point
        inside = contains(polygon, places, 0.0)
        owner[(owner < 0) & inside] = number
    places, weights, owner = places.reshape(-1, flat.shape[1]), thickness * weights.ravel(), owner.ravel()
    sums.mixed += float(weights[-found.mixed.shape[0] * GAUSS ** flat.shape[1]:].sum()) if len(found.mixed) else 0.0
    for number, one in enumerate(facing):
        here = owner == number
        if not here.any():
            continue
        functions, corners = own.values(cell.face, cell, places[here])
        opposite, _ = other.values(one.face, cell, places[here])
        weighted = corners * weights[here][:, None]
        sums.mass += weighted.T @ corners
        sums.own[:, own.faces[cell.face]] += weighted.T @ functions
        sums.other[:, other.faces[one.face]] += weighted.T @ opposite
        sums.normal += np.outer(weighted.sum(axis=0), cell.normal)
        sums.area += float(weights[here].sum())
    places, weights = _points_in(flat[None])
    _, corners = own.values(cell.face, cell, places[0])
    sums.whole += thickness * weights[0] @ corners


def _shares(kept: list[bool]) -> Floats:
    """What the functions of kept corners take over: [corner, corner]."""
    count = len(kept)
    shares = np.zeros((count, count))
    for q in range(count):
        heirs = [q] if kept[q] else [p for p in {(q + 1) % count, (q - 1) % count} if kept[p]]
        heirs = heirs or [(q + 2) % count]
        for p in heirs:
            shares[p, q] = 1 / len(heirs)
    return shares


def _build(touched: list[_Sums], points: dict[int, int], nodes: Floats, uncertain: float) -> Join:
    area, normal = np.zeros(len(points)), np.zeros((len(points), nodes.shape[1]))
    rows = [np.zeros((len(points), len(nodes))) for _ in range(2)]
    for one in touched:
        corners = [int(node) for node in one.face[:len(one.mass)]]
        kept = [node in points for node in corners]
        if not any(kept):
            continue
        shares = _shares(kept)[kept]
        mass = shares @ one.mass @ shares.T
        factors = mass.sum(axis=1)[:, None] * np.linalg.solve(mass, shares)
        numbers = [points[node] for node in corners if node in points]
        area[numbers] += mass.sum(axis=1)
        normal[numbers] += shares @ one.normal
        rows[0][numbers] += factors @ one.own
        rows[1][numbers] += factors @ one.other
    return Join(sparse.csr_matrix(rows[0] / area[:, None]), sparse.csr_matrix(rows[1] / area[:, None]), area, normal,
                uncertain)


def _held_twice(built: Join, point: int, node: int, held: Held) -> bool:
    """Whether both sides are held along the surface at a point but for some weights on other nodes."""
    normal = built.normal[point] / np.linalg.norm(built.normal[point])
    for direction in held.get(node, []):
        if abs(direction @ normal) > HELD_ALONG:
            continue
        shares, others = [], []
        for matrix in (built.own, built.other):
            row = matrix.getrow(point)
            is_held = np.array([any(abs(direction @ d) > PARALLEL for d in held.get(int(j), [])) for j in row.indices])
            others.append(abs(row.data[~is_held]).sum())
            shares.append(abs(row.data[is_held]).sum() >= HELD_IN_PART * others[-1])
        if all(shares) and max(others) > OF_PARTS:
            return True
    return False


def _without(touched: list[_Sums], points: dict[int, int], unwanted: set[int]) -> dict[int, int]:
    """Points without the unwanted ones, of which every face keeps that with the largest share if it has no others."""
    stay = {node for node in points if node not in unwanted}
    for one in touched:
        shares = {int(node): float(share) for node, share in zip(one.face, one.mass.sum(axis=1)) if int(node) in points}
        if shares and not stay.intersection(shares):
            stay.add(max(shares, key=lambda node: shares[node]))
    return {node: i for i, node in enumerate(sorted(stay))}


def join(own_faces: list[Integers], other_faces: list[Integers], nodes: Floats, thickness: float,
         reach: float | None, finest: int, held: Held | None = None) -> Join:
    """Joins two sides; own: that with the points. finest: parts along an edge of a cell that are not cut any more. held:
    by boundaries; where these hold both sides along the surface, corners are no points."""
    own, other = _Side(own_faces, nodes), _Side(other_faces, nodes)
    sums: dict[int, _Sums] = {}
    for cell in own.cells:
        corners = own.shape(cell.face).corners
        here = sums.setdefault(cell.face, _Sums(own.faces[cell.face], corners, nodes.shape[1], len(nodes)))
        _add(here, own, cell, other, _facing(cell, other.cells, reach), thickness, finest)
    covered: dict[int, float] = {}
    whole: dict[int, float] = {}
    touched = [one for one in sums.values() if one.area > 0]
    for one in touched:
        for node, mass, all_of_it in zip(one.face, one.mass.sum(axis=1), one.whole):
            covered[int(node)] = covered.get(int(node), 0.0) + float(mass)
            whole[int(node)] = whole.get(int(node), 0.0) + float(all_of_it)
    points = {node: i for i, node in enumerate(sorted(n for n in covered if covered[n] >= LEAST_COVERED * whole[n]))}
    uncertain = sum(one.mixed for one in sums.values()) / sum(one.area for one in touched)
    built = _build(touched, points, nodes, uncertain)
    unwanted = {node for node, point in points.items() if _held_twice(built, point, node, held or {})}
    if not unwanted:
        return built
    return _build(touched, _without(touched, points, unwanted), nodes, uncertain)
