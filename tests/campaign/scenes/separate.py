"""Parts that are boxes in one space of coordinates, each with a grid of its own, carried into place by one map."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .lattice import Contact, Lattice, Map
from .mesh import Mesh, Side


class Separate:
    """What Lattice is for one grid: makes the mesh of all boxes and names their faces.

    common: boxes that touch have common grid lines, and side sets of what they have in common.
    """

    def __init__(self, common: bool) -> None:
        self._common = common
        self._grids: dict[str, Lattice] = {}
        self._first: dict[str, int] = {}
        self._touching: list[tuple[str, str, int]] = []
        self.mesh = Mesh(np.zeros((0, 0)), [])

    def box(self, part: str, lines: Sequence[Sequence[float]]) -> None:
        """A part with these grid lines per axis."""
        self._grids[part] = Lattice(lines)
        self._grids[part].fill(part)

    def touch(self, low: str, high: str, axis: int) -> None:
        """The upper end of one box along an axis lies on the lower end of another one, or next to it."""
        self._touching.append((low, high, axis))

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return next(iter(self._grids.values())).dimension

    @property
    def parts(self) -> list[str]:
        """Names in the order in which they were made."""
        return list(self._grids)

    def build(self, types: dict[str, str], carry: Map) -> Mesh:
        """Makes the mesh; types: element type per part."""
        nodes, blocks, elements, count = [], [], 0, 0
        for part, grid in self._grids.items():
            built = grid.build(types, carry)
            self._first[part] = elements
            for block in built.blocks:
                blocks.append(type(block)(block.name, block.type, block.nodes + count))
                elements += len(block.nodes)
            nodes.append(built.nodes)
            count += len(built.nodes)
        self.mesh = Mesh(np.concatenate(nodes), blocks)
        return self.mesh

    def contacts(self) -> list[Contact]:
        """All pairs of boxes that touch; adds their side sets to the mesh: whole ends of boxes, or what they have in
        common."""
        result = []
        for number, (low, high, axis) in enumerate(self._touching):
            ranges = [self._range(one, other) if self._common else () for one, other in ((low, high), (high, low))]
            sides = self.outer(f"j{number}_1", low, axis, 1, *ranges[0]), self.outer(f"j{number}_2", high, axis, 0,
                                                                                     *ranges[1])
            result.append(Contact(low, high, axis, *sides))
        return result

    def _range(self, part: str, other: str) -> tuple[tuple[int, int], ...]:
        """The cells of a box, per axis, next to another one that has the same grid lines; all where there are none."""
        result = []
        for mine, theirs in zip(self._grids[part].lines, self._grids[other].lines):
            middles = 0.5 * (mine[:-1] + mine[1:])
            inside = np.flatnonzero((middles > theirs[0]) & (middles < theirs[-1]))
            result.append((int(inside[0]), int(inside[-1]) + 1) if len(inside) else (0, len(middles)))
        return tuple(result)

    def outer(self, name: str, part: str, axis: int, end: int, *ranges: tuple[int, int]) -> str:
        """As of Lattice, of one box."""
        grid = self._grids[part]
        grid.outer(name, part, axis, end, *ranges)
        self.mesh.side_sets[name] = [Side(side.element + self._first[part], side.side)
                                     for side in grid.mesh.side_sets[name]]
        return name
