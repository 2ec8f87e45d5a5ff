"""Points of a joint with area, normal and frame, by integrals over its faces."""
from __future__ import annotations

import dataclasses

import numpy as np
from scipy import sparse
from scipy.spatial import cKDTree

from ..scenes.mesh import Floats, Integers, Mesh
from ..scenes.scene import Joint
from .mortar import Held, join
from .shapes import FACES, rule_of, shape_of


@dataclasses.dataclass(frozen=True)
class Surface:
    """trace1, trace2: B of both sides [point, node]; no trace2 on a boundary. area: per point. frame: [point, (n, t1,
    t2), axis], n out of side 1. place: where forces act on side 1 [point, axis]. gap: of the geometry. uncertain:
    see Join."""
    trace1: sparse.csr_matrix
    trace2: sparse.csr_matrix | None
    area: Floats
    frame: Floats
    place: Floats
    gap: Floats
    uncertain: float = 0.0


@dataclasses.dataclass(frozen=True)
class NodalAreas:
    """Of the nodes of a side set, ascending. share: int N dS. flux: int N n dS. area, normal: the same on linear faces;
    on quadratic ones by N^2, scaled, so that areas are positive (Hinton, Rock, Zienkiewicz 1976)."""
    nodes: Integers
    share: Floats
    flux: Floats
    area: Floats
    normal: Floats


def face_integrals(places: Floats, thickness: float) -> tuple[Floats, Floats, Floats, Floats]:
    """Share, flux, area and normal of every node of a face, see NodalAreas."""
    count, dimension = places.shape
    kind = FACES[dimension, count]
    points, weights = rule_of(kind)
    shares, squares = np.zeros(count), np.zeros(count)
    fluxes, normals = np.zeros((count, dimension)), np.zeros((count, dimension))
    for values, slopes, weight in zip(shape_of(kind).values(points), shape_of(kind).slopes(points), weights):
        along = slopes.T @ places
        normal = weight * (np.cross(along[0], along[1]) if dimension == 3
                           else thickness * np.array([along[0, 1], -along[0, 0]]))
        shares += values * np.linalg.norm(normal)
        fluxes += np.outer(values, normal)
        squares += values**2 * np.linalg.norm(normal)
        normals += np.outer(values**2, normal)
    if count == shape_of(kind).corners:
        return shares, fluxes, shares, fluxes
    factor = shares.sum() / squares.sum()
    return shares, fluxes, factor * squares, factor * normals


def frame_of(normal: Floats) -> Floats:
    """Right-handed frame with the normal as first row; in space the tangents are any two."""
    n = normal / np.linalg.norm(normal)
    if len(n) == 2:
        return np.array([n, [-n[1], n[0]]])
    axis = np.zeros(3)
    axis[int(np.argmin(np.abs(n)))] = 1
    t1 = axis - (axis @ n) * n
    t1 /= np.linalg.norm(t1)
    return np.array([n, t1, np.cross(n, t1)])


def nodal_areas(mesh: Mesh, side_set: str, thickness: float) -> NodalAreas:
    """What the nodes of a side set have of its faces."""
    share, area = np.zeros(len(mesh.nodes)), np.zeros(len(mesh.nodes))
    flux, normal = np.zeros(mesh.nodes.shape), np.zeros(mesh.nodes.shape)
    touched: set[int] = set()
    for side in mesh.side_sets[side_set]:
        nodes = mesh.nodes_of_side(side)
        touched.update(int(n) for n in nodes)
        for target, part in zip((share, flux, area, normal), face_integrals(mesh.nodes[nodes], thickness)):
            target[nodes] += part
    nodes = np.array(sorted(touched), dtype=np.int64)
    return NodalAreas(nodes, share[nodes], flux[nodes], area[nodes], normal[nodes])


def _selection(nodes: Integers, count: int) -> sparse.csr_matrix:
    return sparse.csr_matrix((np.ones(len(nodes)), (np.arange(len(nodes)), nodes)), (len(nodes), count))


def _joined(joint: Joint, mesh: Mesh, thickness: float, finest: int, held: Held) -> Surface:
    assert joint.side2 is not None
    faces = [[mesh.nodes_of_side(side) for side in mesh.side_sets[name]] for name in (joint.side1, joint.side2)]
    if joint.points_on == 2:
        faces.reverse()
    found = join(faces[0], faces[1], mesh.nodes, thickness, joint.reach, finest, held)
    first, second = (found.own, found.other) if joint.points_on == 1 else (found.other, found.own)
    outwards = found.normal if joint.points_on == 1 else -found.normal
    frame = np.array([frame_of(n) for n in outwards])
    gap = np.einsum("pi,pi->p", frame[:, 0], (second - first) @ mesh.nodes)
    return Surface(first, second, found.area, frame, first @ mesh.nodes, gap, found.uncertain)


def surface_of(joint: Joint, mesh: Mesh, thickness: float, finest: int, held: Held) -> Surface:
    """The points of a joint; finest, held: see join(). Raises when the sides do not conform although they should."""
    if joint.points_on is not None:
        return _joined(joint, mesh, thickness, finest, held)
    one = nodal_areas(mesh, joint.side1, thickness)
    frame = np.array([frame_of(n) for n in one.normal])
    count, places = len(mesh.nodes), mesh.nodes[one.nodes]
    none = np.zeros(len(places))
    if joint.side2 is None:
        return Surface(_selection(one.nodes, count), None, one.area, frame, places, none)
    two = nodal_areas(mesh, joint.side2, thickness)
    away, partner = cKDTree(mesh.nodes[two.nodes]).query(places)
    if len(one.nodes) != len(two.nodes) or len(set(partner)) != len(two.nodes) or (
            away.max() > 1e-6 * np.sqrt(one.area.min())):
        raise ValueError(f"the sides of {joint.name} do not conform")
    return Surface(_selection(one.nodes, count), _selection(two.nodes[partner], count),
                   0.5 * (one.area + two.area[partner]), frame, places, none)

