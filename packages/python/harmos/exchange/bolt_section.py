"""Planes across bolts of a drawing, at which their preload acts."""
import dataclasses
import itertools
from collections.abc import Iterator

import gmsh
import numpy

from harmos.arrays import Array
from harmos.exchange.findings import Refused
from harmos.exchange.mesh import Plane

TOUCH = 0.02
"""How far from the shank, over its radius, other parts count as touching it: holes with clearance are 0.05 wider."""

GRIP = 0.6
"""How far from the shank, over its radius, parts that it clamps are looked for: holes are at most 0.2 wider."""

SAME = 1e-6
"""Length over that of a bolt that counts as none."""


SHANK = 1.6
"""Area over that of the thinnest section up to which one belongs to the shank: heads have more than twice of it, threads less
than 1.5 times the area of their cores."""


@dataclasses.dataclass(frozen=True)
class _Candidate:
    """A section of a bolt, and what is around it.

    Attributes:
        plane: through its middle, across the axis.
        area: of the section [length^2].
        length: along the axis in which nothing changes [length].
        touched: parts that touch the bolt there.
    """
    plane: Plane
    area: float
    length: float
    touched: frozenset[str]


def plane_across(bolt: str, parts: dict[str, int], bonded: set[str]) -> Plane:
    """Where to cut a bolt: across its shank where this runs through other parts without touching them, or else touches only
    such as are not `bonded` to it, in the middle of the longest such piece.

    Raises:
        Refused: there is no such place, or it cannot be told from others.
    """
    candidates = list(_candidates(bolt, parts))
    if not candidates:
        raise Refused(f"--preload {bolt}: no other part is around it, so that it clamps nothing.")
    thinnest = min(each.area for each in candidates)
    shank = [each for each in candidates if each.area < SHANK * thinnest]
    chosen = [each for each in shank if not each.touched]
    if not chosen:
        chosen = [each for each in shank if not bonded & each.touched]
        if not chosen or (not bonded and len({each.touched for each in chosen}) > 1):
            names = sorted({name for each in shank for name in each.touched})
            raise Refused(f"--preload {bolt}: its shank touches {' and '.join(names)}, and where its thread is cannot be seen.\n"
                          "  Name by --perfect the interface that is the thread; some of the shank must be outside of it.")
    return max(chosen, key=lambda each: each.length).plane


def divide(tag: int, section: Plane) -> list[int]:
    """Cuts a solid along a plane; the solids that it becomes share the face there."""
    kernel = gmsh.model.occ
    plane = _disk(tag, numpy.array(section.point), numpy.array(section.normal))
    made, _ = kernel.fragment([(3, tag)], [(2, plane)])
    solids = [each for dimension, each in made if dimension == 3]
    kernel.synchronize()
    within = {face for _, face in gmsh.model.getBoundary([(3, each) for each in solids], combined=False, oriented=False)}
    loose = [(2, each) for dimension, each in made if dimension == 2 and each not in within]
    kernel.remove(loose, recursive=True)
    kernel.synchronize()
    return solids


def _axis(bolt: str, tag: int) -> tuple[Array, Array]:
    """The direction of the cylinders of a solid, and its centre."""
    largest, axis = 0.0, numpy.zeros(3)
    for _, face in gmsh.model.getBoundary([(3, tag)], oriented=False):
        area = gmsh.model.occ.getMass(2, face)
        if gmsh.model.getType(2, face) == "Cylinder" and area > largest:
            low, high = gmsh.model.getParametrizationBounds(2, face)
            middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])]
            # Of (u, v) the second runs along the axis.
            along = numpy.array(gmsh.model.getDerivative(2, face, middle))[3:]
            largest, axis = area, along / numpy.linalg.norm(along)
    if largest == 0.0:
        raise Refused(f"--preload {bolt}: no face of it is a cylinder, so that it has no axis.")
    return axis, numpy.array(gmsh.model.occ.getCenterOfMass(3, tag))


def _boxes_meet(one: int, other: int) -> bool:
    boxes = [numpy.array(gmsh.model.occ.getBoundingBox(3, tag)) for tag in (one, other)]
    return bool((numpy.maximum(boxes[0][:3], boxes[1][:3]) <= numpy.minimum(boxes[0][3:], boxes[1][3:])).all())


def _candidates(bolt: str, parts: dict[str, int]) -> Iterator[_Candidate]:
    """Sections of a bolt that have other parts around them, one for each piece of it along which nothing changes."""
    tag = parts[bolt]
    axis, origin = _axis(bolt, tag)
    others = {name: other for name, other in parts.items() if name != bolt and _boxes_meet(tag, other)}
    for start, end in itertools.pairwise(_changes(origin, axis, tag, list(others.values()))):
        at = origin + 0.5 * (start + end) * axis
        faces = _faces_across(tag, at, axis)
        if faces:
            areas = [gmsh.model.occ.getMass(2, face) for face in faces]
            centre = numpy.average([gmsh.model.occ.getCenterOfMass(2, face) for face in faces], axis=0, weights=areas)
            outside = {name: other for name, other in others.items() if not _holds(_box(faces), _box_across(other, at, axis))}
            around = [_box_across(others[name], at, axis) for name in _parts_around(faces, centre, 1.0 + GRIP, outside)]
            if around and _holds(_joined(numpy.array(around)), _box(faces)):
                yield _Candidate(Plane(tuple(map(float, centre)), tuple(map(float, axis))), sum(areas), end - start,
                                 frozenset(_parts_around(faces, centre, 1.0 + TOUCH, outside)))
        gmsh.model.occ.remove([(2, face) for face in faces], recursive=True)


def _changes(origin: Array, axis: Array, bolt: int, others: list[int]) -> list[float]:
    """Places on the axis at which the section of the bolt, or of what is around it, may change."""
    def along(solids: list[int]) -> Array:
        points = gmsh.model.getBoundary([(3, tag) for tag in solids], combined=False, oriented=False, recursive=True)
        return numpy.array([(numpy.array(gmsh.model.getValue(0, tag, [])) - origin) @ axis for _, tag in points])

    own = along([bolt])
    every = numpy.sort(numpy.concatenate([own, along(others)]) if others else own)
    inside = every[(every >= own.min()) & (every <= own.max())]
    return [float(at) for at in inside[numpy.diff(inside, prepend=-numpy.inf) > SAME * numpy.ptp(own)]]


def _disk(tag: int, point: Array, normal: Array) -> int:
    """A disk across a solid."""
    box = numpy.array(gmsh.model.occ.getBoundingBox(3, tag))
    radius = float(numpy.linalg.norm(box[3:] - box[:3]))
    disk = gmsh.model.occ.addDisk(*point, radius, radius)
    turn = numpy.cross([0.0, 0.0, 1.0], normal)
    if numpy.linalg.norm(turn) > SAME:
        gmsh.model.occ.rotate([(2, disk)], *point, *turn, float(numpy.arctan2(numpy.linalg.norm(turn), normal[2])))
    return int(disk)


def _faces_across(tag: int, point: Array, normal: Array) -> list[int]:
    common, _ = gmsh.model.occ.intersect([(3, tag)], [(2, _disk(tag, point, normal))], removeObject=False, removeTool=True)
    return [face for dimension, face in common if dimension == 2]


def _parts_around(faces: list[int], centre: Array, factor: float, others: dict[str, int]) -> list[str]:
    """Parts that a section would lie in, were it larger by a factor."""
    found = []
    wide = gmsh.model.occ.copy([(2, face) for face in faces])
    gmsh.model.occ.dilate(wide, *centre, factor, factor, factor)
    for name, other in others.items():
        common, _ = gmsh.model.occ.intersect([(3, other)], wide, removeObject=False, removeTool=False)
        if any(dimension == 2 for dimension, _ in common):
            found.append(name)
        gmsh.model.occ.remove(common, recursive=True)
    gmsh.model.occ.remove(wide, recursive=True)
    return found


def _box_across(tag: int, point: Array, normal: Array) -> Array:
    """Of the section of a solid; where it has none, a point that lies in any box around the place."""
    faces = _faces_across(tag, point, normal)
    box = _box(faces) if faces else numpy.concatenate([point, point])
    gmsh.model.occ.remove([(2, face) for face in faces], recursive=True)
    return box


def _box(faces: list[int]) -> Array:
    return _joined(numpy.array([gmsh.model.occ.getBoundingBox(2, face) for face in faces]))


def _joined(boxes: Array) -> Array:
    return numpy.concatenate([boxes[:, :3].min(axis=0), boxes[:, 3:].max(axis=0)])


def _holds(outer: Array, inner: Array) -> bool:
    """Whether one box lies in another one."""
    slack = SAME * float(numpy.linalg.norm(outer[3:] - outer[:3]))
    return bool((outer[:3] <= inner[:3] + slack).all() and (outer[3:] >= inner[3:] - slack).all())
