"""Classes of scenes whose parts are meshed one by one, with linear and quadratic elements: strips, slabs, sleeves,
bricks, clamps.

With `matching`, the same scene, from the same random numbers, on linear meshes whose faces match node by node.
"""
from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np

from .builder import Builder
from .draw import Draw
from .lattice import Contact, Map, cells
from .mesh import LINEAR, Floats
from .piles import lift
from .scene import Joint, Law, Part, Scene
from .separate import Separate

PLANE = ("QUAD4", "TRI3", "QUAD8", "QUAD9", "TRI6")
SPACE = ("HEX8", "TET4", "WEDGE6", "HEX20", "HEX27", "TET10", "WEDGE15")
# Quadrature on curved tetrahedra of second degree is not the same everywhere.
CURVED = tuple(kind for kind in SPACE if kind != "TET10")


@dataclasses.dataclass(frozen=True)
class Box:
    """A part to be: its ends per axis, cells per axis, and element type."""
    name: str
    ends: tuple[tuple[float, float], ...]
    counts: tuple[int, ...]
    type: str

    def size(self, axis: int) -> float:
        """Of a cell."""
        return (self.ends[axis][1] - self.ends[axis][0]) / self.counts[axis]


def _common_lines(boxes: list[Box], axis: int) -> list[float]:
    """Grid lines on which all boxes begin and end, of a mean size of cells."""
    ends = sorted({round(end, 9) for box in boxes for end in box.ends[axis]})
    sizes = [box.size(axis) for box in boxes]
    mean = float(np.sqrt(min(sizes) * max(sizes)))
    lines = [ends[0]]
    for begin, end in zip(ends[:-1], ends[1:]):
        count = max(1, round((end - begin) / mean))
        lines += [begin + (end - begin) * (i + 1) / count for i in range(count)]
    return lines


def _separate(boxes: list[Box], scale: float, matching: bool, uneven: Floats) -> tuple[Separate, dict[str, str]]:
    """The grids and element types of boxes whose ends are over `scale`."""
    made = Separate(matching)
    common = [_common_lines(boxes, axis) for axis in range(len(boxes[0].ends))] if matching else []
    for box, tilt in zip(boxes, uneven):
        lines = []
        for axis, (ends, count) in enumerate(zip(box.ends, box.counts)):
            if matching:
                inside = [line for line in common[axis] if ends[0] - 1e-9 < line < ends[1] + 1e-9]
            else:
                share = np.arange(count + 1) / count
                inside = list(ends[0] + (ends[1] - ends[0]) * (share + tilt * share * (1 - share)))
            lines.append([scale * line for line in inside])
        made.box(box.name, lines)
    plain = "QUAD4" if len(boxes[0].ends) == 2 else "HEX8"
    return made, {box.name: plain if matching else box.type for box in boxes}


class _Apart(Builder):
    """Builds a scene of boxes that touch."""

    def __init__(self, draw: Draw, boxes: list[Box], touching: list[tuple[str, str, int]], scale: float, matching: bool,
                 carry: Map = lambda x: x, reach: float | None = None) -> None:
        uneven = draw.random.uniform(-0.4, 0.4, len(boxes)) if draw.chance(0.3) else np.zeros(len(boxes))
        grids, self.kinds = _separate(boxes, scale, matching, uneven)
        for pair in touching:
            grids.touch(*pair)
        super().__init__(draw, grids, carry)
        self.matching = matching
        self.reach = reach

    def _types(self) -> dict[str, str]:
        return self.kinds

    def is_quadratic(self, part: str) -> bool:
        """Whether it has nodes between corners."""
        return self.kinds[part] != LINEAR[self.kinds[part]]

    def join(self, law_of: Callable[[Contact], Law]) -> None:
        """Joins all boxes that touch, on the points of either side."""
        super().join(law_of)
        for number, joint in enumerate(self.joints):
            side = self.draw.count(1, 2)
            if not self.matching:
                self.joints[number] = dataclasses.replace(joint, points_on=side, reach=self.reach)

    def hold(self, name: str, part: str, axis: int, end: int, chance: float) -> None:
        """Weak springs, sometimes; not on quadratic elements, on whose faces there are none."""
        law = self.draw.foundation(-4, 0)
        if self.draw.chance(chance) and (self.matching or not self.is_quadratic(part)):
            self.support(name, part, axis, end, law)

    def finish(self) -> Scene:
        """The scene; of parts with linear elements, those may be cut that have all the points of their joints."""
        scene = super().finish()
        scene.pieces = {}
        name = self.draw.one(*self.kinds)
        sides: list[tuple[Joint, int]] = [(joint, side) for joint in scene.joints
                                          for side, own in ((1, joint.side1), (2, joint.side2))
                                          if joint.points_on is not None and own is not None and self._owns(name, own)]
        block = next(block for block in scene.mesh.blocks if block.name == name)
        divisible = not self.is_quadratic(name) and len(block.nodes) >= 12
        if self.draw.chance(0.2) and divisible and all(j.points_on == side for j, side in sides):
            scene.pieces[name] = 2
        return scene

    def _owns(self, part: str, side_set: str) -> bool:
        nodes = next(block for block in self.mesh.blocks if block.name == part).nodes
        return int(self.mesh.nodes_of_side(self.mesh.side_sets[side_set][0])[0]) in nodes


def _counts(draw: Draw, fine: int, dimension: int, high: int) -> tuple[int, ...]:
    """Cells along x, y, and z: up to `fine` in the plane of the joints, few across."""
    along = max(1, int(round(draw.magnitude(0, np.log10(fine)))))
    deep = max(1, int(round(draw.magnitude(0, np.log10(fine)))))
    return (along, draw.count(1, high)) + ((deep,) if dimension == 3 else ())


def _pile(draw: Draw, dimension: int, matching: bool) -> Scene:
    """Boxes on each other that cover each other in part, pressed and sheared from above."""
    count = draw.count(2, 4 if dimension == 2 else 3)
    kinds = PLANE if dimension == 2 else SPACE
    boxes: list[Box] = []
    top = 0.0
    for number in range(count):
        wide = number == 0 or draw.chance(0.4)
        aligned = draw.chance(0.6)
        low, high = draw.between(0, 0.35), draw.between(0.65, 1)
        if aligned:
            low, high = round(6 * low) / 6, round(6 * high) / 6
        height = draw.between(0.2, 0.6)
        ends = [(0.0, 1.0) if wide else (low, high), (top, top + height)]
        if dimension == 3:
            ends.append((0.0, 0.5) if draw.chance(0.6) else (0.0, 0.25))
        counts = _counts(draw, 20 if dimension == 2 else 4, dimension, 2 if dimension == 2 else 1)
        boxes.append(Box(f"block{number}", tuple(ends), counts, draw.one(*kinds)))
        top += height
    touching = [(low.name, high.name, 1) for low, high in zip(boxes[:-1], boxes[1:])]
    builder = _Apart(draw, boxes, touching, draw.length, matching)
    halved = dimension == 3 and draw.chance(0.4)
    draw.perfect = draw.perfect and not halved
    builder.join(lambda _: draw.law(0.35, rough=0.95))
    builder.clamp("ground", "block0", 1, 0)
    for number in range(1, count):
        if halved:
            builder.support(f"middle{number}", f"block{number}", 2, 0, Law("Symmetry"))
        builder.hold(f"side{number}", f"block{number}", 0, 1, 0.8)
    shear = draw.load * draw.magnitude(-2, -0.3) * draw.changing()
    builder.pull("load", f"block{count - 1}", 1, 1, lift(draw, dimension, -draw.load * draw.steady(), shear))
    return builder.finish()


def strips(draw: Draw, matching: bool = False) -> Scene:
    """Plates on edge on each other, in the plane."""
    return _pile(draw, 2, matching)


def slabs(draw: Draw, matching: bool = False) -> Scene:
    """Blocks on each other, in space."""
    return _pile(draw, 3, matching)


def sleeves(draw: Draw, matching: bool = False) -> Scene:
    """A shell around a shaft, both of facets or of curved elements that do not meet: gaps and overlaps count."""
    dimension = 2 if draw.chance(0.7) else 3
    kinds = PLANE if dimension == 2 else CURVED
    radius, thick = draw.between(0.8, 1.5), (draw.between(0.2, 0.5), draw.between(0.15, 0.4))
    opening = draw.between(0.5, 1.6)
    fine = (18, 18) if dimension == 2 else (8, 8)
    boxes = []
    for number, name in enumerate(("shaft", "shell")):
        around = draw.count(max(3, int(4 * opening)), fine[number])
        low = radius - thick[0] if number == 0 else radius
        covered = (0.0, 1.0) if number == 0 or draw.chance(0.5) else (draw.between(0, 0.3), draw.between(0.7, 1))
        ends = [covered, (low, low + thick[number])] + ([(0.0, 0.5)] if dimension == 3 else [])
        counts = (around, draw.count(1, 2)) + ((draw.count(1, 2),) if dimension == 3 else ())
        boxes.append(Box(name, tuple(ends), counts, draw.one(*kinds)))
    scale = draw.length

    def carry(x: Floats) -> Floats:
        angle = 0.5 * np.pi + opening * (0.5 - x[:, 0] / scale)
        return np.column_stack([x[:, 1] * np.cos(angle), x[:, 1] * np.sin(angle), *x.T[2:]])

    builder = _Apart(draw, boxes, [("shaft", "shell", 1)], scale, matching, carry, 0.15 * scale)
    builder.join(lambda _: draw.law(0.3, rough=0.95))
    builder.clamp("ground", "shaft", 1, 0)
    builder.hold("side", "shell", 0, 1, 0.8)
    # What the facets gape by is closed by pressing; loads are of that size.
    shear = draw.magnitude(-2, -0.5) * draw.changing()
    size = draw.base * draw.magnitude(-3.5, -1.5)
    builder.pull("load", "shell", 1, 1, size * lift(draw, dimension, -draw.steady(), shear))
    return builder.finish()


def bricks(draw: Draw, matching: bool = False) -> Scene:
    """Stones side by side on a plate, joined to it and to each other, pressed from above."""
    draw.crossing()
    stones = draw.count(2, 4)
    plate = Box("plate", ((0.0, 1.0), (0.0, draw.between(0.15, 0.3))), _counts(draw, 16, 2, 2), draw.one(*PLANE))
    low = plate.ends[1][1]
    edges = np.linspace(0, 1, stones + 1)
    edges[1:-1] += draw.random.uniform(-0.3, 0.3, stones - 1) / stones
    boxes, touching = [plate], []
    for number in range(stones):
        ends = ((float(edges[number]), float(edges[number + 1])), (low, low + draw.between(0.3, 0.5)))
        counts = (draw.count(1, 5), draw.count(1, 5))
        boxes.append(Box(f"stone{number}", ends, counts, draw.one(*PLANE)))
        touching.append(("plate", f"stone{number}", 1))
        if number > 0:
            touching.append((f"stone{number - 1}", f"stone{number}", 0))
    builder = _Apart(draw, boxes, touching, draw.length, matching)
    builder.join(lambda _: draw.law(0.4, rough=0.95))
    builder.clamp("ground", "plate", 1, 0)
    for number in range(stones):
        builder.hold(f"side{number}", f"stone{number}", 1, 1, 0.3)
        shear = draw.load * draw.magnitude(-2, -0.5) * draw.changing()
        builder.pull(f"load{number}", f"stone{number}", 1, 1, lift(draw, 2, -draw.load * draw.steady(), shear))
    return builder.finish()


def clamps(draw: Draw, matching: bool = False) -> Scene:
    """Two plates between the jaws of a clamp, which a preload in its rod draws together; one plate is pulled along."""
    dimension = 2 if draw.chance(0.6) else 3
    kinds = PLANE if dimension == 2 else SPACE
    fine = 12 if dimension == 2 else 3
    thick, plates = draw.between(0.2, 0.4), (draw.between(0.15, 0.3), draw.between(0.15, 0.3))
    heights = np.cumsum([0.0, thick, *plates, thick])
    middle = float(draw.between(0.35, 0.65) * (heights[3] - heights[1]) + heights[1])

    def box(name: str, x: tuple[float, float], low: float, high: float) -> Box:
        ends = (x, (float(low), float(high))) + (((0.0, 0.5),) if dimension == 3 else ())
        return Box(name, ends, _counts(draw, fine, dimension, 2 if dimension == 2 else 1), draw.one(*kinds))

    boxes = [box("nut", (0.0, 1.0), heights[0], heights[1]), box("plate1", (-0.5, 0.6), heights[1], heights[2]),
             box("plate2", (0.0, 0.6), heights[2], heights[3]), box("rod1", (0.75, 1.0), heights[1], middle),
             box("rod2", (0.75, 1.0), middle, heights[3]), box("head", (0.0, 1.0), heights[3], heights[4])]
    touching = [("nut", "plate1", 1), ("plate1", "plate2", 1), ("plate2", "head", 1), ("nut", "rod1", 1),
                ("rod1", "rod2", 1), ("rod2", "head", 1)]
    builder = _Apart(draw, boxes, touching, draw.length, matching)
    preload = draw.strain * draw.length * draw.between(0.5, 2)
    rough = draw.between(0.1, 0.6)

    def law(contact: Contact) -> Law:
        if "rod2" == contact.part2:
            return Law("Preload Jump", {"Jump": draw.number(preload)})
        if "rod" in contact.part1 + contact.part2:
            return draw.bond()
        return Law("Coulomb Friction", {"Friction Coefficient": rough})

    builder.join(law)
    builder.clamp("wall", "plate1", 0, 0)
    size = draw.load * draw.magnitude(-2, -0.3)
    builder.pull("pull", "plate2", 0, 0, lift(draw, dimension, 0.05 * size * draw.changing(), size * draw.changing()))
    return builder.finish()
