"""The classes of random scenes by name."""
from __future__ import annotations

import zlib
from collections.abc import Callable

from .draw import Draw
from .piles import beams, floating, inclines, mosaics, stack
from .scene import Scene
from .shapes import arches, hooks, laps, rings, tenons, wedges

CLASSES: dict[str, Callable[[Draw], Scene]] = {
    "stacks": stack, "beams": beams, "floating": floating, "rings": rings, "arches": arches, "tenons": tenons,
    "hooks": hooks, "wedges": wedges, "inclines": inclines, "laps": laps, "mosaics": mosaics}


def make_scene(name: str, seed: int) -> Scene:
    """The scene of a class and a seed: always the same."""
    return CLASSES[name](Draw((zlib.crc32(name.encode()), seed)))
