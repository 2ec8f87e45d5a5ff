"""Contacts of fitted parts that turn an edge, as under the head of a bolt: without the curved faces at that edge.

A node at the edge has a point of contact on each face. Friction on the flat one and pressure on the curved one would hold the same
motion there, along the flat face, and of their forces nothing tells how they share it where meshes do not match.
"""
import numpy

from harmos.arrays import Array
from harmos.exchange.contact import face_measures
from harmos.exchange.mesh import Mesh, Plane, codes, faces_of

FLAT = 1e-6
"""Sine between normals up to which faces of a set are flat."""

ON_PLANE = 1e-9
"""Distance of nodes from a plane, over the size of the mesh, up to which they lie on it."""


def without_curved_edges(mesh: Mesh, rows: Array, cut: "Plane | None") -> Array:
    """Of sides of a part those that are flat, or share no node with flat ones and have none on the plane that cuts the part; faces of
    one side set, flat or not, count together. All of them where nothing curved would be left."""
    faces = faces_of(mesh)
    faces = faces.chosen(numpy.isin(*codes(faces.rows(), rows)))
    _, _, normal, area = face_measures(mesh, faces)
    is_curved = numpy.zeros(len(area), dtype=bool)
    for entries in mesh.side_sets.values():
        inside = numpy.isin(*codes(faces.rows(), entries))
        if not inside.any():
            continue
        mean = (normal[inside] * area[inside, None]).sum(axis=0)
        mean = mean / max(float(numpy.linalg.norm(mean)), 1e-300)
        if numpy.linalg.norm(numpy.cross(normal[inside], mean), axis=1).max() > FLAT:
            is_curved |= inside
    edge = faces.corners[~is_curved]
    held = [edge[edge >= 0]]
    if cut is not None:
        distance = (mesh.nodes - numpy.array(cut.point)) @ numpy.array(cut.normal)
        held.append(numpy.flatnonzero(numpy.abs(distance) <= ON_PLANE * float(numpy.ptp(mesh.nodes, axis=0).max())))
    keeps = ~is_curved | ~numpy.isin(faces.corners, numpy.concatenate(held)).any(axis=1)
    if not (keeps & is_curved).any():
        keeps[:] = True
    return faces.chosen(keeps).rows()
