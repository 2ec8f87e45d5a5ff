"""Finds where parts lie on each other, whether or not their meshes match."""
import dataclasses
import itertools

import numpy
from scipy.spatial import cKDTree

from harmos.arrays import Array
from harmos.exchange.mesh import Faces, Mesh, codes, outer_faces

NEIGHBOURS = 12
"""How many faces around the middle of one are looked at."""

GAP = 0.1
"""Distance up to which faces touch, over the length of the shortest edge of either: facets of two meshes of one circle
with 16 elements around it are 0.05 apart."""

OPPOSITE = -0.8
"""Cosine between normals up to which faces face each other."""


@dataclasses.dataclass
class Contact:
    """Two parts that lie on each other.

    Attributes:
        parts: their names.
        rows: their faces there, as side sets.
        areas: of these faces [length^2]; in the plane lengths.
    """
    parts: tuple[str, str]
    rows: tuple[Array, Array]
    areas: tuple[float, float]


@dataclasses.dataclass
class _Surface:
    """Faces of a part with what is measured of them."""
    faces: Faces
    corners: Array  # n x 4 x 3, the last one repeated for triangles
    centre: Array
    normal: Array
    area: Array
    length: Array

    def chosen(self, which: Array) -> "_Surface":
        return _Surface(self.faces.chosen(which), self.corners[which], self.centre[which], self.normal[which],
                        self.area[which], self.length[which])


def face_measures(mesh: Mesh, faces: Faces) -> tuple[Array, Array, Array, Array]:
    """Corners (n x width x 3), middles, unit normals outwards and areas (lengths in the plane) of faces."""
    numbers = faces.corners.copy()
    for column in range(1, numbers.shape[1]):
        missing = numbers[:, column] < 0
        numbers[missing, column] = numbers[missing, column - 1]
    at = mesh.nodes[numbers]
    if mesh.dimension == 2:
        along = at[:, 1] - at[:, 0]
        vector = numpy.column_stack([along[:, 1], -along[:, 0], numpy.zeros(len(along))])
    else:
        vector = 0.5 * numpy.cross(at[:, 2] - at[:, 0], at[:, 3] - at[:, 1])
    area = numpy.linalg.norm(vector, axis=1)
    count = (faces.corners >= 0).sum(axis=1)
    centre = numpy.where(faces.corners[:, :, None] >= 0, at, 0.0).sum(axis=1) / count[:, None]
    return at, centre, vector / numpy.maximum(area, 1e-300)[:, None], area


def _outwards(mesh: Mesh, rows: Array) -> tuple[Array, Array]:
    """Middles of sides, and their normals out of the elements, in whatever sense these are numbered."""
    outer = outer_faces(mesh)
    ours, wanted = codes(outer.rows(), rows)
    chosen = outer.chosen(numpy.isin(ours, wanted))
    _, centre, normal, _ = face_measures(mesh, chosen)
    first, blocks = mesh.first_elements(), mesh.block_of(chosen.element)
    inside = numpy.array([mesh.nodes[mesh.blocks[block].connectivity[element - first[block]]].mean(axis=0)
                          for element, block in zip(chosen.element, blocks)]).reshape(-1, 3)
    sense = numpy.sign(numpy.einsum("ij,ij->i", centre - inside, normal))
    return centre, normal * sense[:, None]


def face_each_other(mesh: Mesh, rows: Array, other_rows: Array) -> bool:
    """Whether the outward normal of some side of one side set is against that of the nearest side of the other."""
    centre, normal = _outwards(mesh, rows)
    other_centre, other_normal = _outwards(mesh, other_rows)
    if not len(centre) or not len(other_centre):
        return True
    nearest = cKDTree(other_centre).query(centre)[1]
    return bool((numpy.einsum("ij,ij->i", normal, other_normal[nearest]) < 0.0).any())


def lie_opposite(mesh: Mesh, rows: Array, other_rows: Array, reach: float) -> bool:
    """Whether the middle of some side of one side set, seen along the normal of a side of the other, lies in that, within
    `reach` times the longest edge of both; or the other way round."""
    outer = outer_faces(mesh)
    sides = [_surface(mesh, outer.chosen(numpy.isin(*codes(outer.rows(), each)))) for each in (rows, other_rows)]
    if not all(len(each.area) for each in sides):
        return False
    longest = max(float(numpy.linalg.norm(each.corners - numpy.roll(each.corners, 1, axis=1), axis=2).max()) for each in sides)
    for point, face in (sides, reversed(sides)):
        count = min(NEIGHBOURS, len(face.centre))
        near = cKDTree(face.centre).query(point.centre, k=count)[1].reshape(len(point.centre), count)
        for column in range(count):
            of = face.chosen(near[:, column])
            gap = numpy.abs(numpy.einsum("ij,ij->i", point.centre - of.centre, of.normal))
            along = numpy.abs(numpy.einsum("ij,ij->i", point.normal, of.normal)) >= -OPPOSITE
            if (_is_above(point, of, mesh.dimension) & along & (gap <= reach * longest)).any():
                return True
    return False


def _surface(mesh: Mesh, faces: Faces) -> _Surface:
    at, centre, normal, area = face_measures(mesh, faces)
    edges = numpy.linalg.norm(at - numpy.roll(at, 1, axis=1), axis=2)
    return _Surface(faces, at, centre, normal, area, numpy.where(edges > 0.0, edges, numpy.inf).min(axis=1))


def contacts(mesh: Mesh) -> list[Contact]:
    """All pairs of parts that lie on each other, in the order of the parts."""
    faces = outer_faces(mesh)
    part = numpy.asarray(mesh.part_of_block())[mesh.block_of(faces.element)]
    names = list(mesh.parts())
    surfaces = [_surface(mesh, faces.chosen(part == number)) for number in range(len(names))]
    result = []
    for one, other in itertools.combinations(range(len(names)), 2):
        near, far = _in_common_box(surfaces[one], surfaces[other])
        if near is None or far is None:
            continue
        met, met_by = _meeting(near, far, mesh.dimension)
        if met.any() and met_by.any():
            result.append(Contact((names[one], names[other]),
                                  (near.faces.chosen(met).rows(), far.faces.chosen(met_by).rows()),
                                  (float(near.area[met].sum()), float(far.area[met_by].sum()))))
    return result


def _in_common_box(one: _Surface, other: _Surface) -> "tuple[_Surface | None, _Surface | None]":
    """What of both lies in the box that both have in common."""
    margin = GAP * max(one.length.max(initial=0.0), other.length.max(initial=0.0))
    low = numpy.maximum(one.corners.min(axis=(0, 1)), other.corners.min(axis=(0, 1))) - margin
    high = numpy.minimum(one.corners.max(axis=(0, 1)), other.corners.max(axis=(0, 1))) + margin
    if (low > high).any():
        return None, None
    inside = [((each.corners.min(axis=1) <= high) & (each.corners.max(axis=1) >= low)).all(axis=1)
              for each in (one, other)]
    if not inside[0].any() or not inside[1].any():
        return None, None
    return one.chosen(inside[0]), other.chosen(inside[1])


def _meeting(one: _Surface, other: _Surface, dimension: int) -> tuple[Array, Array]:
    """Which faces of both lie on the other: the middle of one of them must lie in the other."""
    met, met_by = numpy.zeros(len(one.area), dtype=bool), numpy.zeros(len(other.area), dtype=bool)
    for point, face, of_point, of_face in ((one, other, met, met_by), (other, one, met_by, met)):
        count = min(NEIGHBOURS, len(face.centre))
        near = cKDTree(face.centre).query(point.centre, k=count)[1].reshape(len(point.centre), count)
        for column in range(count):
            candidate = near[:, column]
            lies = _lies_in(point, face.chosen(candidate), dimension)
            of_point |= lies
            of_face[candidate[lies]] = True
    return met, met_by


def _lies_in(point: _Surface, face: _Surface, dimension: int) -> Array:
    """Whether the middle of a face, seen along the normal of another one beside it, lies in that, and near enough."""
    offset = point.centre - face.centre
    gap = numpy.einsum("ij,ij->i", offset, face.normal)
    lies: Array = (numpy.abs(gap) <= GAP * numpy.maximum(point.length, face.length)) & (
        numpy.einsum("ij,ij->i", point.normal, face.normal) <= OPPOSITE)
    return lies & _is_above(point, face, dimension)


def _is_above(point: _Surface, face: _Surface, dimension: int) -> Array:
    """Whether the middle of a face, seen along the normal of another one, lies in that."""
    gap = numpy.einsum("ij,ij->i", point.centre - face.centre, face.normal)
    above: Array = numpy.ones(len(gap), dtype=bool)
    foot = point.centre - gap[:, None] * face.normal
    width = 4 if dimension == 3 else 2
    slack = 1e-6 * face.length
    for i in range(width):
        start, end = face.corners[:, i], face.corners[:, (i + 1) % width]
        along = end - start
        if dimension == 3:
            inwards = numpy.cross(face.normal, along)
            length = numpy.maximum(numpy.linalg.norm(along, axis=1), 1e-300)
        else:
            inwards, length = along, numpy.maximum(numpy.linalg.norm(along, axis=1), 1e-300)
        above &= numpy.einsum("ij,ij->i", foot - start, inwards) >= -slack * length
    return above
