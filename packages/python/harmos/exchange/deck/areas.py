"""Shares of nodes in the area of faces: integrals of their shape functions."""
import numpy

from harmos.arrays import Array
from harmos.exchange.mesh import Faces, Mesh

_GAUSS = (numpy.array([-0.7745966692414834, 0.0, 0.7745966692414834]), numpy.array([5.0, 8.0, 5.0]) / 9.0)
_TRIANGLE = [(a, b, w) for base, w in ((0.445948490915965, 0.223381589678011), (0.091576213509771, 0.109951743655322))
             for a, b in ((base, base), (1 - 2 * base, base), (base, 1 - 2 * base))]


def _line(count: int, x: float) -> tuple[list[float], list[list[float]]]:
    if count == 2:
        return [(1 - x) / 2, (1 + x) / 2], [[-0.5], [0.5]]
    return [x * (x - 1) / 2, x * (x + 1) / 2, 1 - x * x], [[x - 0.5], [x + 0.5], [-2 * x]]


def _triangle(count: int, a: float, b: float) -> tuple[list[float], list[list[float]]]:
    c = 1 - a - b
    if count == 3:
        return [c, a, b], [[-1, -1], [1, 0], [0, 1]]
    return ([c * (2 * c - 1), a * (2 * a - 1), b * (2 * b - 1), 4 * a * c, 4 * a * b, 4 * b * c],
            [[1 - 4 * c, 1 - 4 * c], [4 * a - 1, 0], [0, 4 * b - 1], [4 * (c - a), -4 * a], [4 * b, 4 * a],
             [-4 * b, 4 * (c - b)]])


def _quadrilateral(count: int, x: float, y: float) -> tuple[list[float], list[list[float]]]:
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    if count == 4:
        return ([(1 + i * x) * (1 + j * y) / 4 for i, j in corners],
                [[i * (1 + j * y) / 4, j * (1 + i * x) / 4] for i, j in corners])
    values = [(1 + i * x) * (1 + j * y) * (i * x + j * y - 1) / 4 for i, j in corners]
    slopes = [[i * (1 + j * y) * (2 * i * x + j * y) / 4, j * (1 + i * x) * (i * x + 2 * j * y) / 4] for i, j in corners]
    values += [(1 - x * x) * (1 - y) / 2, (1 + x) * (1 - y * y) / 2, (1 - x * x) * (1 + y) / 2, (1 - x) * (1 - y * y) / 2]
    slopes += [[-x * (1 - y), -(1 - x * x) / 2], [(1 - y * y) / 2, -y * (1 + x)], [-x * (1 + y), (1 - x * x) / 2],
               [-(1 - y * y) / 2, -y * (1 - x)]]
    return values, slopes


def _points(dimension: int, corners: int, count: int) -> list[tuple[list[float], list[list[float]], float]]:
    xs, ws = _GAUSS
    if dimension == 2:
        return [(*_line(count, x), w) for x, w in zip(xs, ws)]
    if corners == 3:
        return [(*_triangle(count, a, b), w / 2) for a, b, w in _TRIANGLE]
    return [(*_quadrilateral(count, x, y), wx * wy) for x, wx in zip(xs, ws) for y, wy in zip(xs, ws)]


def nodal_areas(mesh: Mesh, faces: Faces, thickness: float, is_revolved: bool) -> Array:
    """For every node of the mesh the integral of its shape function over the faces [area]: in the plane times the
    thickness, or the whole circle about the axis y."""
    result = numpy.zeros(len(mesh.nodes))
    first, blocks = mesh.first_elements(), mesh.block_of(faces.element)
    for number, block in enumerate(mesh.blocks):
        for side, corners in enumerate(block.type.sides):
            chosen = (blocks == number) & (faces.side == side)
            if not chosen.any():
                continue
            on_side = [block.type.order.index(frozenset([corner])) for corner in corners]
            for one, other in zip(corners, [*corners[1:], corners[0]][:len(corners) if mesh.dimension == 3 else 1]):
                if frozenset([one, other]) in block.type.order:
                    on_side.append(block.type.order.index(frozenset([one, other])))
            rows = block.connectivity[faces.element[chosen] - first[number]][:, on_side]
            at = mesh.nodes[rows]
            for values, slopes, weight in _points(mesh.dimension, len(corners), len(on_side)):
                tangents = numpy.einsum("enx,nd->edx", at, numpy.array(slopes))
                if mesh.dimension == 3:
                    area = numpy.linalg.norm(numpy.cross(tangents[:, 0], tangents[:, 1]), axis=1)
                else:
                    area = numpy.linalg.norm(tangents[:, 0], axis=1) * thickness
                    if is_revolved:
                        area = area / thickness * 2 * numpy.pi * (at[:, :, 0] @ numpy.array(values))
                for column, value in enumerate(values):
                    numpy.add.at(result, rows[:, column], value * weight * area)
    return result
