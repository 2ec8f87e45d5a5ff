"""Axes of their own that a deck gives to nodes (*TRANSFORM), in which their boundaries and forces count."""
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.solids import Solids
from harmos.exchange.findings import Findings, Refused, names_there

SAME = 1e-9
"""Sine of the angle between axes, and distance from an axis over the size of the mesh, that count as none."""

FAR = 1e6
"""Distance of the axis of a cylinder from nodes with rectangular axes, over the size of the mesh: the error of a direction is
its inverse, far below that of any solution, and places keep ten digits."""


@dataclasses.dataclass(frozen=True)
class Axes:
    """Three directions at every point.

    Attributes:
        is_cylindrical: radial, tangential and axial; else the same three everywhere.
        point: on the axis of the cylinder.
        first: direction of the first axis where all are the same.
        third: direction of the third axis, that of the cylinder.
    """
    is_cylindrical: bool
    point: tuple[float, ...]
    first: tuple[float, ...]
    third: tuple[float, ...]

    def at(self, place: Array, size: float) -> Array:
        """Unit vectors, a row each; on the axis of a cylinder of the mesh's size any two across it come first."""
        third = numpy.asarray(self.third)
        first = numpy.asarray(self.first)
        if self.is_cylindrical:
            arm = place - numpy.asarray(self.point)
            across = arm - (arm @ third) * third
            distance = float(numpy.linalg.norm(across))
            if distance > SAME * size:
                first = across / distance
        return numpy.array([first, numpy.cross(third, first), third])

    def at_node(self, place: Array, size: float) -> "Axes":
        """These axes, rectangular where the node lies on the axis of the cylinder."""
        arm = place - numpy.asarray(self.point)
        third = numpy.asarray(self.third)
        if self.is_cylindrical and float(numpy.linalg.norm(arm - (arm @ third) * third)) <= SAME * size:
            return dataclasses.replace(self, is_cylindrical=False)
        return self

    def along_global(self) -> "list[tuple[int, float]] | None":
        """For each direction the global one that it is, from 0, and its sense; nothing where they are turned."""
        if self.is_cylindrical:
            return None
        rows = self.at(numpy.zeros(3), 1.0)
        largest = numpy.abs(rows).argmax(axis=1)
        if numpy.abs(rows).max(axis=1).min() < 1.0 - SAME:
            return None
        return [(int(axis), float(numpy.sign(row[axis]))) for axis, row in zip(largest, rows)]

    def cylinder(self, middle: Array, size: float) -> tuple[list[float], list[float]]:
        """Point and direction of the axis of a cylinder with these directions around a point."""
        if self.is_cylindrical:
            return list(self.point), list(self.third)
        return [float(x) for x in middle - FAR * size * numpy.asarray(self.first)], list(self.third)


class Transforms:
    """All of a deck.

    Attributes:
        of_node: axes by node (index in the mesh).
        left_out: nodes whose axes leave the plane.
        size: of the mesh [length].
    """

    def __init__(self, contents: Contents, solids: Solids, findings: Findings) -> None:
        """Reads them; those that leave the plane of plane elements are listed.

        Raises:
            Refused: a set is not there, or the points make no axes.
        """
        self.of_node: dict[int, Axes] = {}
        self.left_out: set[int] = set()
        self.size = float(numpy.ptp(solids.mesh.nodes, axis=0).max()) if len(solids.mesh.nodes) else 1.0
        for card in contents.model:
            if card.keyword != "TRANSFORM":
                continue
            name = card.get("NSET")
            if name not in contents.node_sets:
                raise Refused(f"{card.place}: *TRANSFORM: there is no set \"{name}\". {names_there(name, contents.node_sets)}")
            axes = _read(card)
            found = contents.node_sets[name]
            nodes = solids.nodes(numpy.unique(numpy.concatenate(found))).tolist() if found else []
            if solids.family != "C3D" and (abs(abs(axes.third[2]) - 1.0) > SAME or (solids.family == "CAX" and axes.along_global() is None)):
                findings.leave_out(card.place, "*TRANSFORM", f"axes that leave the plane: boundaries and forces of the node set {name}")
                self.left_out.update(nodes)
                continue
            for node in nodes:
                self.of_node[node] = axes.at_node(solids.mesh.nodes[node], self.size)


def _read(card: Card) -> Axes:
    kind = card.get("TYPE") or "R"
    numbers = card.table(6, 2)
    if not len(numbers) or kind not in ("R", "C"):
        raise Refused(f"{card.place}: *TRANSFORM takes TYPE=R or TYPE=C and the coordinates of two points.")
    one, other = numbers[0, :3], numbers[0, 3:]
    third = other - one if kind == "C" else numpy.cross(one, other)
    length = float(numpy.linalg.norm(third))
    if length <= SAME * max(float(numpy.abs(numbers[0]).max()), 1e-300):
        raise Refused(f"{card.place_of(0)}: *TRANSFORM: both points lie {'at one place' if kind == 'C' else 'on one line with the origin'}.")
    third = third / length
    first = numpy.eye(3)[int(numpy.abs(third).argmin())] if kind == "C" else one
    first = first - (first @ third) * third
    first = first / float(numpy.linalg.norm(first))
    return Axes(kind == "C", tuple(map(float, one if kind == "C" else numpy.zeros(3))), tuple(map(float, first)),
                tuple(map(float, third)))
