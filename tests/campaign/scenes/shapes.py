"""Classes of scenes whose parts grip into each other: rings, arches, tenons, hooks, wedges, laps."""
from __future__ import annotations

import numpy as np

from .builder import Builder
from .draw import Draw
from .lattice import Contact, Lattice, cells
from .mesh import Floats
from .piles import lift
from .scene import Law, Scene

# Cells around a ring: where one turns in another, and else at least; neighbouring faces are far from a crease.
FINE, COARSE = 36, 12


def rings(draw: Draw) -> Scene:
    """A ring of segments, or two rings in each other, squeezed across."""
    length = draw.length
    nested = draw.chance(0.4)
    if nested:
        draw.crossing()
    segments = draw.count(2, 6)
    around = FINE if nested else segments * max(draw.count(3, 5), -(-COARSE // segments))
    lines = [cells([1.0], [around]), cells([0.2 * length] * (2 if nested else 1), [1] * (2 if nested else 1))]
    if not nested and draw.chance(0.5):
        lines[1] = cells([0.2 * length], [2])
    lattice = Lattice(lines, periodic=True)
    edges = [int(i) for i in np.linspace(0, around, segments + 1).round()]
    for segment in range(segments):
        lattice.fill(f"segment{segment}", (edges[segment], edges[segment + 1]))
    if nested:
        half = around // 2
        lattice.fill("inner0", (0, half), (0, 1))
        lattice.fill("inner1", (half, around), (0, 1))
    inside = length * draw.between(0.4, 1.0)

    def carry(x: Floats) -> Floats:
        angle, radius = -2 * np.pi * x[:, 0], inside + x[:, 1]
        return np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])

    builder = Builder(draw, lattice, carry)
    builder.join(lambda _: draw.law(0.6))
    rings_inside = ["inner0", "inner1"] if nested else [f"segment{i}" for i in range(segments)]
    for part in rings_inside:
        builder.support("shaft_" + part, part, 1, 0, draw.foundation(-2, 1))
    size = draw.load * draw.magnitude(-1, 0)
    for name, segment in (("load", 0), ("load2", segments // 2)):
        if segment > 0 or name == "load":
            histories = lift(draw, 2, size * draw.changing(), size * draw.changing())
            builder.pull(name, f"segment{segment}", 1, 1, histories)
    return builder.finish()


def arches(draw: Draw) -> Scene:
    """Voussoirs between two abutments under weight and a load on one of them."""
    length = draw.length
    stones = draw.count(3, 8)
    per_stone, across = draw.count(1, 3), draw.count(1, 2)
    thickness = length * draw.between(0.15, 0.4)
    lattice = Lattice([cells([1.0], [stones * per_stone]), cells([thickness], [across])])
    for stone in range(stones):
        lattice.fill(f"stone{stone}", (stone * per_stone, (stone + 1) * per_stone))
    opening = draw.between(0.5, 1.0) * np.pi

    def carry(x: Floats) -> Floats:
        angle, radius = np.pi / 2 + opening * (0.5 - x[:, 0]), length + x[:, 1]
        return np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])

    builder = Builder(draw, lattice, carry)
    bonded = 0.5 if draw.chance(0.3) else 0.05
    rough = draw.between(0.2, 1.0)

    def law(_: Contact) -> Law:
        if draw.chance(bonded):
            return draw.bond()
        return Law("Coulomb Friction", {"Friction Coefficient": rough})

    builder.join(law)
    for name, stone, end in (("left", 0, 0), ("right", stones - 1, 1)):
        if draw.chance(0.7):
            builder.clamp(name, f"stone{stone}", 0, end)
        else:
            builder.support(name, f"stone{stone}", 0, end, Law("Coulomb Friction", {"Friction Coefficient": 0.8}))
    weight = draw.load / length * draw.steady()
    builder.weigh(lift(draw, 2, -weight, np.zeros(draw.steps)))
    size = draw.load * draw.magnitude(-2, -0.3)
    loads = lift(draw, 2, -size * abs(draw.changing()), 0.2 * size * draw.changing())
    builder.pull("load", f"stone{draw.count(0, stones - 1)}", 1, 1, loads)
    return builder.finish()


def tenons(draw: Draw) -> Scene:
    """A tongue in a slot, straight or as a dovetail, pulled, pressed and bent."""
    draw.crossing()
    dimension = 2 if draw.chance(0.7) else 3
    length = draw.length
    fine = 2 if dimension == 2 and draw.chance(0.6) else 1
    counts = [fine, draw.count(1, 2) * fine, fine]
    rows = [1, 2 * fine, 1]
    lines = [cells([length * draw.between(0.2, 0.5) for _ in counts], counts),
             cells([length * f for f in (0.3, draw.between(0.3, 0.8), 0.3)], rows)]
    lattice = Lattice(lines + ([cells([0.5 * length], [1])] if dimension == 3 else []))
    width = sum(counts)
    lattice.fill("slot", (0, width), (0, rows[0] + rows[1]))
    lattice.fill("tongue", (counts[0], counts[0] + counts[1]), (rows[0], sum(rows)))
    if draw.chance(0.4):
        lattice.empty((counts[0], counts[0] + counts[1]), (rows[0], rows[0] + 1))  # air under the tongue
    middle = 0.5 * (lines[0][counts[0]] + lines[0][counts[0] + counts[1]])
    taper = draw.between(-0.1, 0.35) / length if draw.chance(0.6) else 0.0
    top = lines[1][-1]

    def carry(x: Floats) -> Floats:
        result = x.copy()
        result[:, 0] = middle + (x[:, 0] - middle) * (1 + taper * (top - x[:, 1]))
        return result

    builder = Builder(draw, lattice, carry)
    builder.join(lambda _: draw.law(0.1))
    builder.clamp("ground", "slot", 1, 0)
    size = draw.load * draw.magnitude(-1, 0)
    up = size * (draw.changing() if taper > 0.05 / length else -draw.steady())
    builder.pull("load", "tongue", 1, 1, lift(draw, dimension, up, size * draw.between(0, 0.6) * draw.changing()))
    if draw.chance(0.4):
        builder.support("spring", "tongue", 0, 1, draw.foundation(-4, 0), (0, width), (rows[0] + rows[1], sum(rows)))
    return builder.finish()


def hooks(draw: Draw) -> Scene:
    """Two hooks in each other, pulled apart; sometimes guided."""
    draw.crossing()
    dimension = 2 if draw.chance(0.7) else 3
    length = draw.length
    fine = 2 if dimension == 2 and draw.chance(0.6) else 1
    columns = [fine * draw.count(1, 2), fine, fine, fine * draw.count(1, 2)]
    rows = [fine, fine, fine]
    lines = [cells([length * draw.between(0.3, 0.6) for _ in columns], columns),
             cells([length * draw.between(0.2, 0.5) for _ in rows], rows)]
    lattice = Lattice(lines + ([cells([0.5 * length], [1])] if dimension == 3 else []))
    x = np.cumsum([0] + columns)
    y = np.cumsum([0] + rows)

    def fill(part: str, column: int, row: int, end: int) -> None:
        lattice.fill(part, (int(x[column]), int(x[end])), (int(y[row]), int(y[row + 1])))

    fill("low", 0, 0, 3)
    fill("low", 2, 1, 3)
    fill("high", 1, 2, 4)
    fill("high", 1, 1, 2)
    builder = Builder(draw, lattice)
    builder.join(lambda _: draw.law(0.05))
    builder.clamp("wall", "low", 0, 0)
    size = draw.load * draw.magnitude(-1, 0)
    if draw.chance(0.3):
        way = draw.strain * length * draw.magnitude(-0.5, 0.5)
        histories = np.zeros((draw.steps, dimension))
        histories[:, 0] = way * draw.steady()
        builder.move("grip", "high", 0, 1, histories)
    else:
        along = size * draw.steady()
        builder.pull("grip", "high", 0, 1, lift(draw, dimension, 0.2 * size * draw.changing(), along))
        if draw.chance(0.7):
            law = draw.foundation(-3, 0) if draw.chance(0.5) else Law("Symmetry")
            builder.support("guide", "high", 1, 1, law)
        else:
            builder.press("weight", "high", 1, 1, size * draw.between(0.2, 1.5) * draw.steady())
    return builder.finish()


def wedges(draw: Draw) -> Scene:
    """A wedge driven between a base and a guided block."""
    dimension = 2 if draw.chance(0.7) else 3
    length = draw.length
    counts = [1, draw.count(1, 2), 1]
    lines = [cells([length], [draw.count(2, 5 if dimension == 2 else 3)]),
             cells([length * draw.between(0.2, 0.5) for _ in counts], counts)]
    lattice = Lattice(lines + ([cells([0.4 * length], [1])] if dimension == 3 else []))
    y = np.cumsum([0] + counts)
    heights = [lines[1][int(i)] for i in y]
    for index, part in enumerate(("low", "wedge", "top")):
        lattice.fill(part, (0, len(lines[0]) - 1), (int(y[index]), int(y[index + 1])))
    slopes = [0.0, draw.between(-0.1, 0.3), -draw.between(0.0, 0.3), 0.0]

    def carry(x: Floats) -> Floats:
        result = x.copy()
        result[:, 1] += (x[:, 0] - 0.5 * length) * 0.7 * np.interp(x[:, 1], heights, slopes)
        return result

    builder = Builder(draw, lattice, carry)
    rough = draw.between(0.0, 0.5)

    def law(_: Contact) -> Law:
        if draw.chance(0.2):
            return draw.law(0.1)
        return Law("Coulomb Friction", {"Friction Coefficient": rough * draw.between(0.7, 1.3)})

    builder.join(law)
    builder.clamp("ground", "low", 1, 0)
    builder.support("guide", "top", 0, 0, Law("Symmetry") if draw.chance(0.7) else draw.foundation(-1, 1))
    builder.press("roof", "top", 1, 1, draw.load * draw.steady())
    push = draw.load * draw.magnitude(-1.2, 0.3) * draw.changing()
    if draw.chance(0.6):
        builder.pull("push", "wedge", 0, 1, lift(draw, dimension, 0 * push, -push))
    else:
        builder.support("rear", "wedge", 0, 1, draw.foundation(-3, 1))
    return builder.finish()


def _bolted_lap(draw: Draw) -> Scene:
    """Two plates with a hole, and a bolt of two halves that a preload draws together."""
    length = draw.length
    lines = [cells([length, 0.5 * length, length, length], [1, 1, 1, 1]), cells([0.5 * length] * 3, [1, 1, 1]),
             cells([0.3 * length] * 4, [1, 1, 1, 1])]
    lattice = Lattice(lines)
    lattice.fill("plate1", (0, 3), (0, 3), (1, 2))
    lattice.fill("plate2", (0, 4), (0, 3), (2, 3))
    lattice.fill("head", (0, 3), (0, 3), (0, 1))
    lattice.fill("head", (1, 2), (1, 2), (0, 2))
    lattice.fill("nut", (0, 3), (0, 3), (3, 4))
    lattice.fill("nut", (1, 2), (1, 2), (2, 4))
    builder = Builder(draw, lattice)
    preload = draw.strain * length * draw.between(0.3, 1.5)
    clearance = draw.strain * length * draw.between(0.0, 2.0)
    rough = draw.between(0.1, 0.6)

    def law(contact: Contact) -> Law:
        if {contact.part1, contact.part2} == {"head", "nut"}:
            return Law("Preload Jump", {"Jump": draw.number(preload)})
        if contact.axis != 2:
            return Law("Unilateral Contact", {"Gap": clearance})
        return Law("Coulomb Friction", {"Friction Coefficient": rough})

    builder.join(law)
    builder.clamp("wall", "plate1", 0, 0)
    size = draw.load * draw.magnitude(-2, -0.3)
    builder.pull("pull", "plate2", 0, 1, lift(draw, 3, 0.05 * size * draw.changing(), size * draw.changing(), 2))
    return builder.finish()


def laps(draw: Draw) -> Scene:
    """Overlapping plates, glued, rubbing under pressure, or bolted, pulled along."""
    if draw.chance(0.3):
        return _bolted_lap(draw)
    dimension = 2 if draw.chance(0.6) else 3
    length = draw.length
    counts = [draw.count(1, 3), draw.count(2, 5 if dimension == 2 else 3), draw.count(1, 3)]
    rows = [draw.count(1, 2), draw.count(1, 2)]
    lines = [cells([length * draw.between(0.5, 1.5) for _ in counts], counts),
             cells([length * draw.between(0.1, 0.3) for _ in rows], rows)]
    lattice = Lattice(lines + ([cells([0.5 * length], [1])] if dimension == 3 else []))
    lattice.fill("plate1", (0, counts[0] + counts[1]), (0, rows[0]))
    lattice.fill("plate2", (counts[0], sum(counts)), (rows[0], sum(rows)))
    builder = Builder(draw, lattice)
    builder.join(lambda _: draw.law(0.4))
    builder.clamp("wall", "plate1", 0, 0)
    overlap = (counts[0], counts[0] + counts[1])
    clamping = draw.load * draw.steady()
    builder.press("above", "plate2", 1, 1, clamping, overlap)
    if draw.chance(0.5):
        builder.press("below", "plate1", 1, 0, clamping, overlap)
    else:
        builder.support("below", "plate1", 1, 0, Law("Symmetry"), overlap)
    size = draw.load * draw.magnitude(-1.5, 0.2)
    if draw.chance(0.25):
        histories = np.zeros((draw.steps, dimension))
        histories[:, 0] = draw.strain * length * draw.magnitude(-1, 1) * draw.changing()
        builder.move("grip", "plate2", 0, 1, histories)
    else:
        histories = lift(draw, dimension, 0.02 * size * draw.changing(), size * draw.changing())
        builder.pull("pull", "plate2", 0, 1, histories)
    return builder.finish()
