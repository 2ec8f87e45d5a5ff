"""Classes of scenes whose parts lie on each other: stacks, beams, floating bodies, inclines, mosaics."""
from __future__ import annotations

import numpy as np

from .builder import Builder
from .draw import Draw
from .lattice import Lattice, cells
from .mesh import Floats
from .scene import Law, Scene


def lift(draw: Draw, dimension: int, up: Floats, along: Floats, axis: int = 1) -> Floats:
    """Histories [step, axis] from one along the axis that points up and one along x."""
    result = np.zeros((draw.steps, dimension))
    result[:, axis] += up
    result[:, 0] += along
    if dimension == 3:
        result[:, 2 if axis == 1 else 1] += 0.3 * draw.between(-1, 1) * along
    return result


def _depth(draw: Draw) -> list[float]:
    return cells([draw.length * draw.between(0.4, 1)], [draw.count(1, 2)])


def _support_below(draw: Draw, builder: Builder, part: str) -> None:
    match draw.count(0, 4):
        case 0 | 1 | 2:
            builder.clamp("ground", part, 1, 0)
        case 3:
            builder.support("ground", part, 1, 0, draw.foundation(-1, 2))
        case _:
            law = Law("Coulomb Friction", {"Friction Coefficient": draw.between(0.3, 1)})
            builder.support("ground", part, 1, 0, law)


def stack(draw: Draw) -> Scene:
    """Blocks on each other, of different widths, pressed and sheared from above."""
    dimension = 2 if draw.chance(0.6) else 3
    most = 3 if dimension == 2 else 2
    length = draw.length
    blocks = draw.count(2, 5 if dimension == 2 else 3)
    widths = [draw.count(1, most) for _ in range(3)]
    heights = [draw.count(1, 2) for _ in range(blocks)]
    lines = [cells([length * draw.between(0.2, 0.6) for _ in widths], widths),
             cells([length * draw.between(0.2, 0.6) for _ in heights], heights)]
    lattice = Lattice(lines + ([_depth(draw)] if dimension == 3 else []))
    edges = np.cumsum([0] + widths)
    row = 0
    for block, height in enumerate(heights):
        left = 0 if block == 0 else draw.count(0, 1)
        right = 3 if block == 0 else draw.count(2, 3)
        lattice.fill(f"block{block}", (int(edges[left]), int(edges[right])), (row, row + height))
        row += height
    builder = Builder(draw, lattice)
    builder.join(lambda _: draw.law(0.35, rough=0.85))
    _support_below(draw, builder, "block0")
    for block in range(1, blocks):
        if draw.chance(0.5):
            builder.support(f"side{block}", f"block{block}", 0, 1, draw.foundation(-4, 0))
    top = f"block{blocks - 1}"
    shear = draw.load * draw.magnitude(-2, -0.3) * draw.changing()
    builder.pull("load", top, 1, 1, lift(draw, dimension, -draw.load * draw.steady(), shear))
    return builder.finish()


def beams(draw: Draw) -> Scene:
    """Layers of a leaf spring, or a chain of segments, held at one end or at both, loaded across."""
    dimension = 2 if draw.chance(0.75) else 3
    length = draw.length
    layers = draw.count(1, 4) if dimension == 2 else draw.count(1, 2)
    segments = draw.count(2, 5) if layers == 1 else 1
    draw.overlaps = layers == 1  # else joints end at the wall
    if layers == 1:
        along = [draw.count(2, 5)] * segments
    else:
        along = [draw.count(6, 14) if dimension == 2 else draw.count(4, 8)]
    lines = [cells([length * 4 / len(along)] * len(along), along),
             cells([length * draw.between(0.1, 0.4) for _ in range(layers)], [draw.count(1, 2) for _ in range(layers)])]
    lattice = Lattice(lines + ([_depth(draw)] if dimension == 3 else []))
    edges = np.cumsum([0] + along)
    heights = np.searchsorted(lines[1], np.unique(np.array(lines[1])))
    rows = [int(i) for i in np.linspace(0, len(heights) - 1, layers + 1).round()]
    for layer in range(layers):
        for segment in range(segments):
            lattice.fill(f"leaf{layer}{segment}", (int(edges[segment]), int(edges[segment + 1])),
                         (rows[layer], rows[layer + 1]))
    builder = Builder(draw, lattice)
    builder.join(lambda _: draw.law(0.9 if layers == 1 else 0.3))
    for layer in range(layers):
        if layer == 0 or draw.chance(0.7):
            builder.clamp(f"wall{layer}", f"leaf{layer}0", 0, 0)
        else:
            builder.support(f"wall{layer}", f"leaf{layer}0", 0, 0, draw.foundation(-2, 1))
    last = f"leaf{layers - 1}{segments - 1}"
    slender = draw.load * draw.magnitude(-2, -0.5)
    end = len(lines[0]) - 1
    loads = lift(draw, dimension, slender * draw.changing(), slender * draw.changing())
    builder.pull("tip", last, 1, 1, loads, (end - 1, end))
    if draw.chance(0.3):
        gap = draw.strain * length * draw.magnitude(-1, 1)
        builder.support("stop", f"leaf0{segments - 1}", 1, 0, Law("Unilateral Contact", {"Gap": gap}), (end - 1, end))
    return builder.finish()


def floating(draw: Draw) -> Scene:
    """Bodies that only contact and weak springs hold: lifted, dragged, pressed."""
    dimension = 2 if draw.chance(0.65) else 3
    length = draw.length
    bodies = draw.count(1, 2)
    counts = [draw.count(2, 4)] + [draw.count(1, 2) for _ in range(bodies)]
    lines = [cells([length * draw.between(0.5, 1.5)], [draw.count(2, 5 if dimension == 2 else 3)]),
             cells([length * draw.between(0.3, 0.8) for _ in counts], counts)]
    lattice = Lattice(lines + ([_depth(draw)] if dimension == 3 else []))
    row = counts[0]
    width = len(lines[0]) - 1
    lattice.fill("base", (0, width), (0, row))
    for body, count in enumerate(counts[1:]):
        lattice.fill(f"body{body}", (0 if draw.chance(0.5) else 1, width), (row, row + count))
        row += count
    builder = Builder(draw, lattice)
    builder.join(lambda _: draw.contact())
    builder.clamp("ground", "base", 1, 0)
    for body in range(bodies):
        if draw.chance(0.8):
            builder.support(f"spring{body}", f"body{body}", 0, 1, draw.foundation(-5, -1))
    size = draw.load * draw.magnitude(-1.5, 0)
    up = size * (draw.changing() if draw.chance(0.5) else -draw.steady())
    drag = size * draw.between(0, 0.7) * draw.changing()
    builder.pull("load", f"body{bodies - 1}", 1, 1, lift(draw, dimension, up, drag))
    if draw.chance(0.3):
        builder.weigh(lift(draw, dimension, -size / length * draw.steady(), np.zeros(draw.steps)))
    return builder.finish()


def inclines(draw: Draw) -> Scene:
    """Blocks on a slope under their weight; friction about what they need, a stop or a push sometimes."""
    dimension = 2 if draw.chance(0.65) else 3
    length = draw.length
    blocks = draw.count(1, 3)
    angle = draw.between(0.05, 0.8)
    counts = [1] + [draw.count(1, 2) for _ in range(blocks)]
    lines = [cells([length], [draw.count(2, 6 if dimension == 2 else 3)]),
             cells([length * draw.between(0.15, 0.5) for _ in counts], counts)]
    lattice = Lattice(lines + ([_depth(draw)] if dimension == 3 else []))
    width = len(lines[0]) - 1
    row = 0
    for block, count in enumerate(counts):
        begin = 0 if block == 0 else draw.count(0, 1)
        lattice.fill(f"block{block}", (begin, width), (row, row + count))
        row += count
    builder = Builder(draw, lattice)

    def law(_: object) -> Law:
        if draw.chance(0.15):
            return draw.bond()
        return Law("Coulomb Friction", {"Friction Coefficient": draw.number(np.tan(angle) * draw.between(0.6, 2.5))})

    builder.join(law)
    builder.clamp("ground", "block0", 1, 0)
    weight = draw.load / length * draw.steady()
    builder.weigh(lift(draw, dimension, -np.cos(angle) * weight, -np.sin(angle) * weight))
    if draw.chance(0.4):
        builder.support("stop", f"block{blocks}", 0, 0, draw.foundation(-4, 0))
    else:
        push = draw.load * draw.magnitude(-2, -0.5) * draw.changing()
        builder.pull("push", f"block{blocks}", 0, 1, lift(draw, dimension, 0 * push, push))
    return builder.finish()


def mosaics(draw: Draw) -> Scene:
    """Bricks in bond with all kinds of joints, pressed and sheared."""
    length = draw.length
    draw.overlaps = False  # joints meet each other and the ground
    columns, rows = draw.count(2, 4), draw.count(2, 4)
    cell = draw.count(1, 2)
    lines = [cells([length * draw.between(0.15, 0.4) for _ in range(2 * columns)], [cell] * 2 * columns),
             cells([length * draw.between(0.2, 0.4) for _ in range(rows)], [draw.count(1, 2)] * rows)]
    lattice = Lattice(lines)
    per_row = (len(lines[1]) - 1) // rows
    for row in range(rows):
        edges = sorted({0, 2 * columns * cell} | {cell * i for i in range(row % 2, 2 * columns, 2)})
        for brick, (begin, end) in enumerate(zip(edges[:-1], edges[1:])):
            lattice.fill(f"brick{row}{brick}", (begin, end), (row * per_row, (row + 1) * per_row))
    builder = Builder(draw, lattice)
    bonded = draw.between(0.1, 0.9)
    builder.join(lambda _: draw.law(bonded))
    for part in lattice.parts:
        if part.startswith("brick0"):
            builder.clamp("ground_" + part, part, 1, 0)
        if part.startswith(f"brick{rows - 1}"):
            shear = draw.load * draw.magnitude(-1.5, -0.2) * draw.changing()
            builder.pull("load_" + part, part, 1, 1, lift(draw, 2, -draw.load * draw.steady(), shear))
    return builder.finish()
