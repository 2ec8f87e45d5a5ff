"""Alternating directions (ADMM) on one load step: slow, but it finds the contact state from anywhere."""
from __future__ import annotations

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from ..scenes.mesh import Floats
from .laws import Kind
from .problem import Problem

RELAXATION = 1.6


class _Cones:
    """Intersects contact and friction with the line force = r (free - jump), point by point."""

    def __init__(self, problem: Problem, step: int, old: Floats, r: Floats) -> None:
        d = problem.dimension
        self.rows = (problem.contact_points * d)[:, None] + np.arange(d)
        self.gap = problem.value[step][self.rows[:, 0]]
        self.friction = problem.friction[step]
        self.old = old[self.rows]
        self.r = r[self.rows[:, :1]]

    def forces(self, free: Floats) -> Floats:
        """force [point, component] for the free jumps [point, component]."""
        force = self.r * (free - self.old)
        force[:, 0] = self.r[:, 0] * np.minimum(0.0, free[:, 0] + self.gap)
        size = np.linalg.norm(force[:, 1:], axis=1)
        bound = -self.friction * force[:, 0]
        force[:, 1:] *= np.where(size > bound, bound / np.maximum(size, 1e-300), 1.0)[:, None]
        return np.asarray(force)


def split(problem: Problem, step: int, old: Floats, u: Floats, force: Floats, factor: float,
          count: int) -> tuple[Floats, Floats]:
    """u and nodal forces after so many iterations; factor: of the penalty."""
    d = problem.dimension
    r = factor * problem.spring
    cones = _Cones(problem, step, old, r)
    contact = cones.rows.ravel()
    linear = np.flatnonzero((problem.kind == Kind.TIED) | (problem.kind == Kind.SPRING))
    tied = problem.kind[linear] == Kind.TIED
    value = problem.value[step][linear]
    softness = np.where(tied, 0.0, 1 / np.maximum(value * problem.area[linear], 1e-12 * problem.spring[linear]))
    W, B = problem.jump[contact], problem.jump[linear]
    held = sparse.diags(1e-9 * problem.stiffness.diagonal())
    loose = sparse.diags(softness + 1e-9 / problem.spring[linear])
    matrix = sparse.bmat([[problem.stiffness + held + W.T @ sparse.diags(r[contact]) @ W, B.T], [-B, loose]],
                         format="csc")
    factors = splu(matrix)
    imposed = -np.where(tied, value, 0.0)
    jump = (W @ u).reshape(-1, d)
    carried = force[contact].reshape(-1, d)
    of_contact = r[contact].reshape(-1, d)
    result = u
    for _ in range(count):
        right = problem.loads[step] + W.T @ (of_contact * jump - carried).ravel()
        solution = factors.solve(np.concatenate([right, imposed]))
        result = solution[:len(u)]
        moved = RELAXATION * (W @ result).reshape(-1, d) + (1 - RELAXATION) * jump
        free = moved + carried / of_contact
        carried = cones.forces(free)
        jump = free - carried / of_contact
    forces = np.zeros_like(force)
    forces[contact] = carried.ravel()
    forces[linear] = solution[len(u):] if count else force[linear]
    return result, forces
