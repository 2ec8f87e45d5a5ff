"""The classes of random scenes by name."""
from __future__ import annotations

import dataclasses
import zlib
from collections.abc import Callable

from .apart import bricks, clamps, slabs, sleeves, strips
from .draw import Draw
from .piles import beams, floating, inclines, mosaics, stack
from .scene import Scene
from .shapes import arches, hooks, laps, rings, tenons, wedges

# Of parts on one grid, with linear elements.
MATCHING: dict[str, Callable[[Draw], Scene]] = {
    "stacks": stack, "beams": beams, "floating": floating, "rings": rings, "arches": arches, "tenons": tenons,
    "hooks": hooks, "wedges": wedges, "inclines": inclines, "laps": laps, "mosaics": mosaics}
# Of parts that are meshed one by one.
APART: dict[str, Callable[[Draw, bool], Scene]] = {
    "strips": strips, "slabs": slabs, "sleeves": sleeves, "bricks": bricks, "clamps": clamps}
CLASSES = (*MATCHING, *APART)


def _draw(name: str, seed: int) -> Draw:
    return Draw((zlib.crc32(name.encode()), seed))


def make_scene(name: str, seed: int, accuracy: float | None = None) -> Scene:
    """The scene of a class and a seed: always the same; asked for another accuracy, if there is one."""
    scene = APART[name](_draw(name, seed), False) if name in APART else MATCHING[name](_draw(name, seed))
    return scene if accuracy is None else dataclasses.replace(scene, accuracy=accuracy)


def make_twin(name: str, seed: int) -> Scene | None:
    """The same scene with linear meshes that match, if the parts of make_scene() are meshed one by one."""
    return APART[name](_draw(name, seed), True) if name in APART else None
