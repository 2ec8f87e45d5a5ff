"""Semi-smooth Newton on the assembled problem of one load step, with the nodal forces of all points as unknowns.

Contact and friction are the roots of Alart and Curnier's functions (1991). Where bodies are not held or conditions are
redundant, the matrix is singular: it is shifted by a small share of its own diagonal, which changes the way to a
solution but not the equations, and picks one of many solutions by the shift that is given.
"""
from __future__ import annotations

import dataclasses

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from ..scenes.mesh import Floats
from .laws import Kind
from .problem import Problem
from .splitting import split

SHIFT = 1e-9
# Of residuals: relative to the forces that act, and to the jumps and gaps.
TOLERANCE = 1e-11
MOST_STEPS = 40


@dataclasses.dataclass
class State:
    """displacement: u. force: nodal forces a t on side 1, per row. residual: relative, 0 when solved exactly."""
    displacement: Floats
    force: Floats
    residual: float

    @property
    def converged(self) -> bool:
        """Whether the equations hold to round-off."""
        return self.residual <= 100 * TOLERANCE


@dataclasses.dataclass(frozen=True)
class Choice:
    """What may be chosen freely and must not matter: the shift [row of the matrix], the scale of the penalty, a start."""
    shift: Floats
    penalty: float
    start: State


class StepEquations:
    """Residual and tangent of one load step. old: jump at the end of the previous one, per row."""

    def __init__(self, problem: Problem, step: int, old: Floats, penalty: float) -> None:
        self.problem = problem
        self.load = problem.loads[step]
        self.value = problem.value[step]
        self.old = old
        self.r = penalty * problem.spring
        d = problem.dimension
        self.normal = problem.contact_points * d
        self.rough = self.normal[problem.kind[self.normal + 1] == Kind.FRICTION]
        self.simple = {kind: np.flatnonzero(problem.kind == kind) for kind in (Kind.FREE, Kind.TIED, Kind.SPRING)}

    def _contact(self, rows: Floats, jump: Floats, force: Floats) -> tuple[Floats, Floats]:
        opening = jump[rows] + self.value[rows]
        return opening, np.maximum(0.0, -force[rows] - self.r[rows] * opening)

    def evaluate(self, u: Floats, force: Floats) -> tuple[Floats, Floats, sparse.csr_matrix, sparse.csr_matrix]:
        """Residuals of equilibrium [force] and of the conditions [length]; derivatives of the latter by delta, a t."""
        p, d = self.problem, self.problem.dimension
        balance = p.stiffness @ u + p.jump.T @ force - self.load
        jump = p.jump @ u
        size = len(force)
        law = np.zeros(size)
        by_jump, by_force = np.zeros((size // d, d, d)), np.zeros((size // d, d, d))

        def put(target: Floats, rows: Floats, numbers: Floats) -> None:
            target[rows // d, rows % d, rows % d] = numbers

        free, tied, spring = (self.simple[kind] for kind in (Kind.FREE, Kind.TIED, Kind.SPRING))
        law[free] = force[free] / self.r[free]
        put(by_force, free, 1 / self.r[free])
        law[tied] = self.value[tied] - jump[tied]
        put(by_jump, tied, np.full(len(tied), -1.0))
        stiffness = self.value[spring] * p.area[spring]
        law[spring] = (force[spring] - stiffness * jump[spring]) / (self.r[spring] + stiffness)
        put(by_force, spring, 1 / (self.r[spring] + stiffness))
        put(by_jump, spring, -stiffness / (self.r[spring] + stiffness))

        opening, pressure = self._contact(self.normal, jump, force)
        closed = pressure > 0
        law[self.normal] = np.where(closed, -opening, force[self.normal] / self.r[self.normal])
        put(by_jump, self.normal, np.where(closed, -1.0, 0.0))
        put(by_force, self.normal, np.where(closed, 0.0, 1 / self.r[self.normal]))

        _, pressure = self._contact(self.rough, jump, force)
        for row, q in zip(self.rough, pressure):
            self._slide(int(row), float(q), jump, force, law, by_jump, by_force)
        return balance, law, _blocks(by_jump), _blocks(by_force)

    def _slide(self, row: int, pressure: float, jump: Floats, force: Floats, law: Floats, by_jump: Floats,
               by_force: Floats) -> None:
        d, r = self.problem.dimension, self.r[row]
        tangents = slice(row + 1, row + d)
        point, inner = row // d, slice(1, d)
        slip = jump[tangents] - self.old[tangents]
        trial = force[tangents] + r * slip
        size = float(np.linalg.norm(trial))
        bound = self.value[row + 1] * pressure
        if size <= bound and bound > 0:
            law[tangents] = -slip
            by_jump[point, inner, inner] = -np.eye(d - 1)
            return
        direction = trial / size if size > 0 else np.zeros(d - 1)
        law[tangents] = (force[tangents] - bound * direction) / r
        turn = (np.eye(d - 1) - np.outer(direction, direction)) * (bound / size if size > 0 else 0.0)
        by_force[point, inner, inner] = (np.eye(d - 1) - turn) / r
        by_jump[point, inner, inner] = -turn
        if pressure > 0:  # the bound falls with the traction and with the opening
            by_force[point, inner, 0] = self.value[row + 1] * direction / r
            by_jump[point, inner, 0] = self.value[row + 1] * direction

    def size(self, u: Floats, force: Floats) -> tuple[float, float]:
        """What forces and lengths are measured by."""
        jump = self.problem.jump @ u
        work = abs(self.problem.stiffness) @ abs(u)
        forces = max(abs(self.load).max(), abs(force).max(initial=0.0), 1e-4 * work.max(), 1e-300)
        contact = self.normal
        gaps = abs(self.value[contact]).max(initial=0.0)
        lengths = max(abs(jump).max(initial=0.0), abs(u).max(), gaps, abs(self.old).max(initial=0.0), 1e-300)
        return float(forces), float(lengths)


def _blocks(blocks: Floats) -> sparse.csr_matrix:
    """Block diagonal matrix."""
    count, d, _ = blocks.shape
    row = np.arange(count * d).reshape(count, d, 1) + np.zeros((1, 1, d), dtype=np.int64)
    column = np.arange(count * d).reshape(count, 1, d) + np.zeros((1, d, 1), dtype=np.int64)
    return sparse.csr_matrix((blocks.ravel(), (row.ravel(), column.ravel())), (count * d, count * d))


class _Iteration:
    def __init__(self, equations: StepEquations, shift: Floats) -> None:
        self.equations = equations
        self.shift = shift

    def residual(self, u: Floats, force: Floats) -> float:
        balance, law, _, _ = self.equations.evaluate(u, force)
        forces, lengths = self.equations.size(u, force)
        return float(max(abs(balance).max() / forces, abs(law).max(initial=0.0) / lengths))

    def direction(self, u: Floats, force: Floats) -> tuple[Floats, Floats]:
        p = self.equations.problem
        balance, law, by_jump, by_force = self.equations.evaluate(u, force)
        size = len(u)
        held = sparse.diags(p.stiffness.diagonal() * self.shift[:size])
        loose = sparse.diags(self.shift[size:] / self.equations.r)
        matrix = sparse.bmat([[p.stiffness + held, p.jump.T], [by_jump @ p.jump, by_force + loose]], format="csc")
        step = splu(matrix).solve(-np.concatenate([balance, law]))
        if not np.isfinite(step).all():
            raise RuntimeError("singular")
        return step[:size], step[size:]

    def run(self, start: State, damped: bool) -> State:
        """Full steps, or steps that must not raise the residual much; the best state on the way."""
        u, force = start.displacement.copy(), start.force.copy()
        best = State(u.copy(), force.copy(), self.residual(u, force))
        idle = 0
        for _ in range(MOST_STEPS):
            try:
                du, df = self.direction(u, force)
            except RuntimeError:
                return best
            length, here = 1.0, self.residual(u, force)
            while damped and length > 1e-3 and self.residual(u + length * du, force + length * df) > 1.02 * here:
                length *= 0.5
            u, force = u + length * du, force + length * df
            now = self.residual(u, force)
            idle = idle + 1 if now > 0.5 * best.residual else 0
            if now < best.residual:
                best = State(u.copy(), force.copy(), now)
            if best.residual <= TOLERANCE or (idle >= 3 and best.converged) or idle >= 15:
                break
        return best


def _search(iteration: _Iteration, problem: Problem, step: int, old: Floats, start: State,
            counts: tuple[int, ...]) -> State:
    best = iteration.run(start, damped=False)
    for count in counts:
        for factor in (0.3, 3.0):
            if best.converged:
                return best
            u, force = split(problem, step, old, start.displacement, start.force, factor, count)
            for damped in (False, True):
                best = min(best, iteration.run(State(u, force, np.inf), damped), key=lambda s: s.residual)
                if best.converged:
                    return best
    return best


def solve_step(problem: Problem, step: int, old: Floats, choice: Choice) -> State:
    """One load step from a start: Newton, damped Newton, and Newton from where a splitting of the problem arrives."""
    iteration = _Iteration(StepEquations(problem, step, old, choice.penalty), choice.shift)
    return _search(iteration, problem, step, old, choice.start, (100, 1000))


def slides(problem: Problem, step: int, old: Floats, start: State) -> bool:
    """Whether parts move on without end where no solution was found.

    With weak springs to the ground at every node there is an equilibrium; if it moves away in proportion as the springs
    get weaker, and they carry the same share of the loads, the joints do not.
    """
    shares, ways = [], []
    for weakness in (1e-4, 1e-6):
        springs = weakness * problem.stiffness.diagonal()
        held = dataclasses.replace(problem, stiffness=(problem.stiffness + sparse.diags(springs)).tocsr())
        equations = StepEquations(held, step, old, 1.0)
        size = len(start.displacement) + len(start.force)
        state = _search(_Iteration(equations, np.full(size, SHIFT)), held, step, old, start, (100,))
        if not state.converged:
            return False
        shares.append(abs(springs * state.displacement).max() / equations.size(state.displacement, state.force)[0])
        ways.append(abs(state.displacement).max())
    return bool(ways[1] > 30 * ways[0] and shares[1] > 0.3 * shares[0])
