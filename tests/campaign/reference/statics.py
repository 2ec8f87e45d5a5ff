"""Rigid-body statics by linear programming: can the joints carry the loads at all?

Nodal forces of all points, each within what its law allows, balance every part. In space friction cones are polyhedra,
around the cones to refute, inside to confirm. That forces exist does not say that a path leads to them.
"""
from __future__ import annotations

import dataclasses

import numpy as np
from scipy import sparse
from scipy.optimize import linprog

from ..scenes.mesh import Floats
from .laws import Kind
from .problem import Problem

FACETS = 24
# Unbalanced share of the loads: above, no forces exist; below the other, they do; between, who knows.
IMPOSSIBLE = 1e-6
POSSIBLE = 1e-8


@dataclasses.dataclass(frozen=True)
class Balance:
    """Least share of the loads that finds no reaction, with cones that are too large (outer) and too small (inner)."""
    outer: float
    inner: float

    @property
    def impossible(self) -> bool:
        """No forces within the laws balance the loads."""
        return self.outer > IMPOSSIBLE

    @property
    def possible(self) -> bool:
        """Some do."""
        return self.inner < POSSIBLE


def _generators(problem: Problem, step: int, outer: bool) -> tuple[sparse.csr_matrix, list[tuple[float | None, None]]]:
    """Nodal forces in local components as combinations of columns, and the bounds of their factors."""
    d = problem.dimension
    rows: list[int] = []
    columns: list[int] = []
    entries: list[float] = []
    bounds: list[tuple[float | None, None]] = []

    def add(row: int, values: Floats, least: float | None) -> None:
        rows.extend(range(row, row + len(values)))
        columns.extend([len(bounds)] * len(values))
        entries.extend(values.tolist())
        bounds.append((least, None))

    value = problem.value[step]
    for row, kind in enumerate(problem.kind):
        if kind == Kind.TIED or (kind == Kind.SPRING and value[row] > 0):
            add(row, np.ones(1), None)
        if kind != Kind.CONTACT:
            continue
        friction = value[row + 1] if problem.kind[row + 1] == Kind.FRICTION else 0.0
        if friction == 0:
            add(row, np.array([-1.0]), 0.0)
            continue
        count = 2 if d == 2 else FACETS
        reach = friction / np.cos(np.pi / count) if outer and d == 3 else friction
        for angle in 2 * np.pi * np.arange(count) / count:
            ray = [-1.0, reach * np.cos(angle)] + ([reach * np.sin(angle)] if d == 3 else [])
            add(row, np.array(ray), 0.0)
    matrix = sparse.csr_matrix((entries, (rows, columns)), (len(problem.kind), len(bounds)))
    return matrix, bounds


def _rigid_modes(problem: Problem) -> Floats:
    """Translations and rotations of every part about its centre [mode, dof], rotations times the size of the part."""
    d, modes = problem.dimension, []
    for nodes in problem.parts:
        x = problem.nodes[nodes] - problem.nodes[nodes].mean(axis=0)
        extent = float(abs(x).max())
        for axis in range(d):
            mode = np.zeros_like(problem.nodes)
            mode[nodes, axis] = 1
            modes.append(mode.ravel())
        for i, j in [(0, 1)] if d == 2 else [(0, 1), (1, 2), (2, 0)]:
            mode = np.zeros_like(problem.nodes)
            mode[nodes, i], mode[nodes, j] = -x[:, j] / extent, x[:, i] / extent
            modes.append(mode.ravel())
    return np.array(modes)


def _unbalanced(problem: Problem, step: int, outer: bool) -> float:
    modes = _rigid_modes(problem)
    load = modes @ problem.loads[step]
    size = max(abs(modes) @ abs(problem.loads[step]))
    if size == 0:
        return 0.0
    generators, bounds = _generators(problem, step, outer)
    balance = sparse.csr_matrix(modes) @ problem.jump.T @ generators
    count = len(load)
    matrix = sparse.hstack([balance, sparse.identity(count), -sparse.identity(count)])
    cost = np.concatenate([np.zeros(balance.shape[1]), np.ones(2 * count)])
    answer = linprog(cost, A_eq=matrix, b_eq=load / size, bounds=bounds + [(0, None)] * (2 * count), method="highs")
    return float(answer.fun) if answer.status == 0 else float("nan")


def statics(problem: Problem, step: int) -> Balance:
    """Of one load step."""
    outer = _unbalanced(problem, step, True)
    has_cones = problem.dimension == 3 and bool((problem.friction[step] > 0).any())
    return Balance(outer, _unbalanced(problem, step, False) if has_cones else outer)
