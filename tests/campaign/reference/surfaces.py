"""Points of a joint: pairs of nodes with area, normal and frame, by integrals over the faces of its first side."""
from __future__ import annotations

import dataclasses

import numpy as np
from scipy.spatial import cKDTree

from ..scenes.mesh import Floats, Integers, Mesh
from ..scenes.scene import Joint


@dataclasses.dataclass(frozen=True)
class Surface:
    """node1, node2: of the mesh, node2 is -1 on a boundary. area: int N dS. frame: [point, (n, t1, t2), axis]."""
    node1: Integers
    node2: Integers
    area: Floats
    frame: Floats


def face_integrals(corners: Floats, thickness: float) -> tuple[Floats, Floats]:
    """int N_a dS and int N_a n dS of a line (in the plane), triangle or quadrilateral, per corner."""
    count, dimension = corners.shape
    if dimension == 2:
        along = corners[1] - corners[0]
        normal = thickness * np.array([along[1], -along[0]])
        return np.full(2, np.linalg.norm(normal) / 2), np.tile(normal / 2, (2, 1))
    if count == 3:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0]) / 2
        return np.full(3, np.linalg.norm(normal) / 3), np.tile(normal / 3, (3, 1))
    areas, normals = np.zeros(4), np.zeros((4, 3))
    signs = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=float)
    for point in np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) / np.sqrt(3):
        one = (1 + signs * point) / 2
        shape = one[:, 0] * one[:, 1]
        normal = np.cross(signs[:, 0] / 2 * one[:, 1] @ corners, signs[:, 1] / 2 * one[:, 0] @ corners)
        areas += shape * np.linalg.norm(normal)
        normals += np.outer(shape, normal)
    return areas, normals


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


def nodal_areas(mesh: Mesh, side_set: str, thickness: float) -> tuple[Integers, Floats, Floats]:
    """Nodes of a side set, ascending, with int N dS and int N n dS."""
    areas: dict[int, float] = {}
    normals: dict[int, Floats] = {}
    for side in mesh.side_sets[side_set]:
        nodes = mesh.nodes_of_side(side)
        for node, area, normal in zip(nodes, *face_integrals(mesh.nodes[nodes], thickness)):
            areas[int(node)] = areas.get(int(node), 0.0) + float(area)
            normals[int(node)] = normals.get(int(node), np.zeros(mesh.dimension)) + normal
    nodes = np.array(sorted(areas), dtype=np.int64)
    return nodes, np.array([areas[int(n)] for n in nodes]), np.array([normals[int(n)] for n in nodes])


def surface_of(joint: Joint, mesh: Mesh, thickness: float) -> Surface:
    """The points of a joint. Raises when the sides do not conform."""
    node1, area, normal = nodal_areas(mesh, joint.side1, thickness)
    frame = np.array([frame_of(n) for n in normal])
    if joint.side2 is None:
        return Surface(node1, np.full(len(node1), -1, dtype=np.int64), area, frame)
    node2, area2, _ = nodal_areas(mesh, joint.side2, thickness)
    away, partner = cKDTree(mesh.nodes[node2]).query(mesh.nodes[node1])
    if len(node1) != len(node2) or len(set(partner)) != len(node2) or away.max() > 1e-6 * np.sqrt(area.min()):
        raise ValueError(f"the sides of {joint.name} do not conform")
    return Surface(node1, node2[partner], 0.5 * (area + area2[partner]), frame)
