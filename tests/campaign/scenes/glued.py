"""Random scenes of blocks in a row, in a stack or two by two, glued by cohesive zones and pulled apart, sheared and let
go."""
from __future__ import annotations

import zlib

import numpy as np

from .builder import Builder
from .draw import Draw
from .lattice import Lattice, cells
from .mesh import Floats
from .scene import Law, Scene, at_step

# Of the displacement that is pulled: 0 at the start, then these, reached one after the other.
_WAYS = ((1.0,), (1.0, 0.2, 1.3), (0.6, -0.2, 1.0, 0.0, 1.2), (1.0, -0.3, 1.5), (0.5, 0.1, 0.8, 0.3, 1.1))
_ACCURACIES = (1e-3, 1e-4, 1e-5)


def _glue(draw: Draw) -> Law:
    """Stiff or soft beside the blocks, brittle or tough: from a tenth over the energy at the onset to thirty times."""
    stiffness = draw.stiffness(0, 3)
    normal = draw.load * draw.magnitude(-1, 0.5)
    shear = normal * draw.between(0.5, 2)
    opening = normal**2 / (2 * stiffness) * (1 + draw.magnitude(-1, 1.5))
    sliding = max(1.05 * shear**2 / (2 * stiffness), opening * draw.between(1, 4))
    return Law("Cohesive Zone",
               {"Stiffness": stiffness, "Normal Strength": normal, "Shear Strength": shear,
                "Mode I Fracture Energy": opening, "Mode II Fracture Energy": sliding,
                "Mixed Mode Exponent": float(draw.count(1, 2))},
               {"Softening": draw.one("Bilinear", "Bilinear", "Exponential")})


def _history(draw: Draw) -> Floats:
    """Factors per load step."""
    way = _WAYS[draw.count(0, len(_WAYS) - 1)]
    each = int(draw.random.choice([2, 4, 8]))
    draw.steps = each * len(way)
    places = np.arange(1, draw.steps + 1) / each
    return np.asarray(np.interp(places, range(len(way) + 1), (0.0, *way)))


def _lattice(draw: Draw) -> tuple[Lattice, list[str], list[str], int]:
    """The blocks, those at the near and at the far end, and the axis from one to the other."""
    dimension = 2 if draw.chance(0.85) else 3
    counts = ((2, 1), (3, 1), (4, 1), (1, 2), (1, 3), (2, 2))[draw.count(0, 5)]
    axis = 0 if counts[1] == 1 else 1
    along = [draw.count(1, 3), draw.count(1, 3)]
    along[1 - axis] = draw.count(2, 8 if dimension == 2 else 4)
    sizes = [draw.length * draw.between(0.4, 2) for _ in range(2)]
    lines = [cells([size] * count, [number] * count) for size, count, number in zip(sizes, counts, along)]
    if dimension == 3:
        lines.append(cells([draw.length], [draw.count(1, 2)]))
    lattice = Lattice(lines)
    ends: tuple[list[str], list[str]] = ([], [])
    for i in range(counts[0]):
        for j in range(counts[1]):
            name = f"block{i}{j}"
            lattice.fill(name, (i * along[0], (i + 1) * along[0]), (j * along[1], (j + 1) * along[1]))
            place = (i, j)[axis]
            if place in (0, counts[axis] - 1):
                ends[0 if place == 0 else 1].append(name)
    return lattice, ends[0], ends[1], axis


def _full_way(draw: Draw, builder: Builder, length: float) -> float:
    """A displacement about as large as breaks the toughest joint [length]."""
    softest = min(part.young for part in builder.parts.values())
    needed = 0.0
    for joint in builder.joints:
        strength, energy = (at_step(joint.law.parameters[name], 0)
                            for name in ("Normal Strength", "Mode I Fracture Energy"))
        needed = max(needed, 2 * energy / strength + length * strength / softest)
    return needed * float(draw.random.choice([0.3, 0.7, 1.0, 1.5]))


def glued(seed: int) -> Scene:
    """The scene of a seed: always the same."""
    draw = Draw((zlib.crc32(b"glued"), seed))
    history = _history(draw)
    lattice, near, far, axis = _lattice(draw)
    builder = Builder(draw, lattice)
    builder.join(lambda _: _glue(draw))
    way = _full_way(draw, builder, float(np.ptp(lattice.lines[axis])))
    angle = float(draw.random.choice([0.0, 0.0, np.pi / 6, np.pi / 3, np.pi / 2]))
    motion = np.zeros((draw.steps, lattice.dimension))
    motion[:, axis] = way * np.cos(angle) * history
    motion[:, 1 - axis] = way * np.sin(angle) * history
    for name in near:
        builder.clamp("hold_" + name, name, axis, 0)
    for name in far:
        builder.move("pull_" + name, name, axis, 1, motion)
    scene = builder.finish()
    scene.accuracy = float(draw.random.choice(_ACCURACIES))
    scene.pieces = {}
    return scene
