"""Parts of a drawing whose curved faces lie in each other, such as a bolt in a fitted hole."""
import itertools

import gmsh
import numpy

from harmos.arrays import Array

SAME = 1e-5
"""Distance over the size of a face that counts as none: files have few digits."""

SAMPLES = 5
"""Points of a face in each direction that must lie in the surface of another one."""


def fitted_pairs(parts: dict[str, int]) -> list[tuple[str, str]]:
    """Pairs of parts of which some curved faces lie in one surface and side by side. Facets of their meshes are apart there, or
    overlap, where the parts do neither."""
    curved = {name: [face for _, face in gmsh.model.getBoundary([(3, tag)], oriented=False)
                     if gmsh.model.getType(2, face) != "Plane"] for name, tag in parts.items()}
    boxes = {face: numpy.array(gmsh.model.occ.getBoundingBox(2, face)) for faces in curved.values() for face in faces}
    return [(one, other) for one, other in itertools.combinations(parts, 2)
            if any(_coincide(face, partner, boxes) for face in curved[one] for partner in curved[other])]


def _coincide(face: int, partner: int, boxes: dict[int, Array]) -> bool:
    mine, theirs = boxes[face], boxes[partner]
    if (numpy.maximum(mine[:3], theirs[:3]) > numpy.minimum(mine[3:], theirs[3:])).any():
        return False
    return _lies_in(face, partner, boxes) or _lies_in(partner, face, boxes)


def _lies_in(face: int, partner: int, boxes: dict[int, Array]) -> bool:
    """Whether all points of a face lie in the surface of another one, and some within its bounds."""
    size = float(numpy.linalg.norm(boxes[face][3:] - boxes[face][:3]))
    low, high = gmsh.model.getParametrizationBounds(2, face)
    # None on the edges, which faces that follow each other have in common.
    shares = (numpy.arange(SAMPLES) + 0.5) / SAMPLES
    grid = [(low[0] + s * (high[0] - low[0]), low[1] + t * (high[1] - low[1])) for s in shares for t in shares]
    points = numpy.array(gmsh.model.getValue(2, face, numpy.array(grid).reshape(-1)))
    nearest, _ = gmsh.model.getClosestPoint(2, partner, points)
    if float(numpy.abs(numpy.array(nearest) - points).max()) > SAME * size:
        return False
    return any(_is_within(partner, point) for point in points.reshape(-1, 3))


def _is_within(face: int, point: Array) -> bool:
    """Whether a point in the surface of a face is within the bounds of the face."""
    try:
        place = numpy.array(gmsh.model.getParametrization(2, face, point))
    except Exception:  # Gmsh finds no place far outside
        return False
    first, last = (numpy.array(each) for each in gmsh.model.getParametrizationBounds(2, face))
    margin = SAME * (last - first)
    return bool(((place > first + margin) & (place < last - margin)).all())
