"""Moves the nodes of one surface onto another, without strain, as ADJUST of a contact pair asks."""
import numpy
from scipy.spatial import cKDTree

from harmos.arrays import Array
from harmos.exchange.mesh import Mesh

NEIGHBOURS = 16
"""How many facets around a node are looked at."""

ALONG_EDGE = 1e-6
"""How far beyond the edge of a facet, over its size, a node still lies above it."""

# Straight pieces of a side: positions among its corners and, behind them, the middles of its edges.
_FACETS: dict[tuple[int, bool], list[tuple[int, ...]]] = {(3, False): [(0, 1, 2)], (4, False): [(0, 1, 2), (0, 2, 3)], (2, False): [(0, 1)], (2, True): [(0, 2), (2, 1)],
           (3, True): [(0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)],
           (4, True): [(0, 4, 7), (4, 1, 5), (5, 2, 6), (6, 3, 7), (4, 5, 6), (4, 6, 7)]}


def move_onto(mesh: Mesh, slave: Array, master: Array, reach: float, chosen: "Array | None") -> Array:
    """Moves nodes of the sides `slave` along the normal of the nearest facet of `master` onto it: those with a gap of at
    most `reach` [length], overlapping ones as well, or those in `chosen`, whatever their gap. How far each of those was moved that were [length]."""
    nodes = _nodes(mesh, slave)
    if chosen is not None:
        nodes = nodes[numpy.isin(nodes, chosen)]
    best, shift = _gaps(mesh, nodes, master, None if chosen is not None else reach)
    moved = numpy.isfinite(best) & (best > 1e-12 * float(numpy.ptp(mesh.nodes, axis=0).max()))
    mesh.nodes[nodes[moved]] += shift[moved]
    result: Array = best[moved]
    return result


def gaps_of_faces(mesh: Mesh, slave: Array, master: Array) -> Array:
    """How far the farthest node of each of the sides `slave` that lies above a facet of `master` is from it [length]; infinite where none
    does."""
    nodes = _nodes(mesh, slave)
    best, _ = _gaps(mesh, nodes, master, None)
    gap = numpy.full(len(mesh.nodes), numpy.inf)
    gap[nodes] = best
    farthest: Array = numpy.full(len(slave), numpy.inf)
    first, blocks = mesh.first_elements(), mesh.block_of(slave[:, 0])
    for block in numpy.unique(blocks).tolist():
        for side in numpy.unique(slave[blocks == block, 1]).tolist():
            which = numpy.flatnonzero((blocks == block) & (slave[:, 1] == side))
            own = gap[mesh.blocks[block].connectivity[slave[which, 0] - first[block]][:, _columns(mesh, block, side)[0]]]
            is_above = numpy.isfinite(own)
            farthest[which] = numpy.where(is_above.any(axis=1), numpy.where(is_above, own, 0.0).max(axis=1), numpy.inf)
    return farthest


def longest_edge(mesh: Mesh, rows: Array) -> float:
    """Of sides [length]."""
    result = 0.0
    for nodes, _, corners, _ in tables_of_sides(mesh, rows):
        at = mesh.nodes[nodes[:, :corners]]
        result = max(result, float(numpy.linalg.norm(at - numpy.roll(at, 1, axis=1), axis=2).max(initial=0.0)))
    return result


def _gaps(mesh: Mesh, nodes: Array, master: Array, reach: "float | None") -> tuple[Array, Array]:
    """Distances of nodes from the nearest facets of `master` that they lie above, infinite where there is none, and the ways
    there. `reach`: of gaps, overlaps of any size count as well; None: distances up to the size of a facet."""
    corners, normals = _facets(mesh, master)
    if not len(nodes) or not len(corners):
        return numpy.full(len(nodes), numpy.inf), numpy.zeros((len(nodes), 3))
    at = mesh.nodes[nodes]
    size = numpy.linalg.norm(corners - numpy.roll(corners, 1, axis=1), axis=2).max(axis=1)
    count = min(NEIGHBOURS, len(corners))
    near = cKDTree(corners.mean(axis=1)).query(at, k=count)[1].reshape(len(at), count)
    best = numpy.full(len(at), numpy.inf)
    shift = numpy.zeros_like(at)
    for column in range(count):
        of = near[:, column]
        gap = numpy.einsum("ij,ij->i", at - corners[of][:, 0], normals[of])
        is_near = (gap <= reach) & (gap >= -size[of]) if reach is not None else numpy.abs(gap) <= size[of]
        better = is_near & _is_above(at, corners[of], normals[of], size[of]) & (numpy.abs(gap) < best)
        best[better] = numpy.abs(gap[better])
        shift[better] = -gap[better, None] * normals[of][better]
    return best, shift


def _is_above(at: Array, corners: Array, normal: Array, size: Array) -> Array:
    """Whether points, seen along the normals of facets, lie in these."""
    above: Array = numpy.ones(len(at), dtype=bool)
    width = corners.shape[1]
    for i in range(width):
        start, along = corners[:, i], corners[:, (i + 1) % width] - corners[:, i]
        inwards = numpy.cross(normal, along) if width == 3 else along
        length = numpy.maximum(numpy.linalg.norm(inwards, axis=1), 1e-300)
        above &= numpy.einsum("ij,ij->i", at - start, inwards) / length >= -ALONG_EDGE * size
    return above


def _columns(mesh: Mesh, block: int, side: int) -> tuple[list[int], bool]:
    """Positions in an element of the corners of a side, and of the middles of its edges in their order if it has them."""
    kind = mesh.blocks[block].type
    corners = list(kind.sides[side])
    edges = [frozenset((corner, corners[(i + 1) % len(corners)])) for i, corner in enumerate(corners)]
    if len(corners) == 2:
        edges = edges[:1]
    middles = [kind.order.index(edge) for edge in edges if edge in kind.order]
    return corners + middles, len(middles) == len(edges)


def tables_of_sides(mesh: Mesh, rows: Array) -> list[tuple[Array, Array, int, bool]]:
    """Nodes of sides, those of their elements, the number of corners and whether they are quadratic, kind by kind."""
    first, blocks = mesh.first_elements(), mesh.block_of(rows[:, 0])
    result = []
    for block in numpy.unique(blocks).tolist():
        for side in numpy.unique(rows[blocks == block, 1]).tolist():
            of = rows[(blocks == block) & (rows[:, 1] == side), 0] - first[block]
            columns, is_quadratic = _columns(mesh, block, side)
            elements = mesh.blocks[block].connectivity[of]
            result.append((elements[:, columns], elements, len(mesh.blocks[block].type.sides[side]), is_quadratic))
    return result


def _nodes(mesh: Mesh, rows: Array) -> Array:
    result: Array = numpy.unique(numpy.concatenate([nodes.reshape(-1) for nodes, _, _, _ in tables_of_sides(mesh, rows)]))
    return result


def _facets(mesh: Mesh, rows: Array) -> tuple[Array, Array]:
    """Corners of flat pieces of sides, in a sense that turns about their unit normals out of the elements, and these."""
    corners, normals = [], []
    for nodes, elements, count, is_quadratic in tables_of_sides(mesh, rows):
        inside: Array = mesh.nodes[elements].mean(axis=1)
        for piece in _FACETS[count, is_quadratic]:
            at: Array = mesh.nodes[nodes[:, list(piece)]]
            along = at[:, 1] - at[:, 0]
            vector = (numpy.cross(along, at[:, 2] - at[:, 0]) if len(piece) == 3
                      else numpy.column_stack([along[:, 1], -along[:, 0], numpy.zeros(len(along))]))
            inwards = numpy.einsum("ij,ij->i", vector, at.mean(axis=1) - inside) < 0.0
            vector[inwards] *= -1.0
            at[inwards] = at[inwards][:, ::-1]
            corners.append(at)
            normals.append(vector / numpy.maximum(numpy.linalg.norm(vector, axis=1), 1e-300)[:, None])
    return numpy.concatenate(corners), numpy.concatenate(normals)
