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

from ..scenes.mesh import Floats, Integers
from .laws import Kind
from .problem import Problem
from .splitting import split

SHIFT = 1e-12
# Of residuals: relative to the forces that act, and to the jumps and gaps.
TOLERANCE = 1e-11
MOST_STEPS = 40
# Where bodies have moved far, K u is a difference of large numbers: so many times these count as forces, which makes
# the tolerance their round-off; but what is missing to equilibrium is never more than TOLERANCE over LEAST_SHARE.
LOST_DIGITS = 1e-5
LEAST_SHARE = 1e-3
# With springs ten times weaker, parts that nothing stops move ten times as far; those that weak joints hold do not.
SLIDING = 8.0


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
    """What may be chosen freely and must not matter: shift [row of the matrix], scale of the penalty, start."""
    shift: Floats
    penalty: float
    start: State


@dataclasses.dataclass(frozen=True)
class Residual:
    """balance: of equilibrium [force]. law: of the conditions [length]; by_jump, by_force: its derivatives by delta and
    a t, [point, component, component]. size: the larger one, relative to what acts."""
    balance: Floats
    law: Floats
    by_jump: Floats
    by_force: Floats
    size: float


class StepEquations:
    """Residual and tangent of one load step. old: jump at the end of the previous one, per row."""

    def __init__(self, problem: Problem, step: int, old: Floats, penalty: float) -> None:
        self.problem = problem
        self.step = step
        self.load = problem.loads[step]
        self.value = problem.value[step]
        self.old = old
        self.absolute = abs(problem.stiffness)
        self.r = penalty * problem.spring
        d = problem.dimension
        self.normal = problem.contact_points * d
        self.rough = self.normal[problem.kind[self.normal + 1] == Kind.FRICTION]
        given = np.isin(problem.kind, (Kind.TIED, Kind.CONTACT))  # prescribed jumps and gaps [length], as forces
        self.imposed = float(abs(self.r * self.value)[given].max(initial=0.0))
        self.simple = {kind: np.flatnonzero(problem.kind == kind) for kind in (Kind.FREE, Kind.TIED, Kind.SPRING)}

    def _contact(self, rows: Integers, jump: Floats, force: Floats) -> tuple[Floats, Floats]:
        opening = jump[rows] + self.value[rows]
        return opening, np.maximum(0.0, -force[rows] - self.r[rows] * opening)

    def evaluate(self, u: Floats, force: Floats) -> Residual:
        """At nodal displacements and nodal forces."""
        p, d = self.problem, self.problem.dimension
        balance = p.stiffness @ u + p.jump.T @ force - self.load
        jump = p.jump @ u
        count = len(force)
        law = np.zeros(count)
        by_jump, by_force = np.zeros((count // d, d, d)), np.zeros((count // d, d, d))

        def put(target: Floats, rows: Integers, numbers: Floats) -> None:
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
        if len(self.rough):
            self._slide(jump, force, law, by_jump, by_force)
        return Residual(balance, law, by_jump, by_force, self._size(u, force, jump, balance, law))

    def _slide(self, jump: Floats, force: Floats, law: Floats, by_jump: Floats, by_force: Floats) -> None:
        """Friction at all points that have it: sticking where the trial force is inside the cone."""
        d = self.problem.dimension
        rows = self.rough[:, None] + np.arange(1, d)
        point = self.rough // d
        r = self.r[self.rough][:, None]
        _, pressure = self._contact(self.rough, jump, force)
        friction = self.value[self.rough + 1][:, None]
        bound = friction * pressure[:, None]
        slip = jump[rows] - self.old[rows]
        trial = force[rows] + r * slip
        size = np.linalg.norm(trial, axis=1)[:, None]
        sticks = (size <= bound) & (bound > 0)
        direction = trial / np.where(size > 0, size, 1.0)
        law[rows] = np.where(sticks, -slip, (force[rows] - bound * direction) / r)
        unit = np.eye(d - 1)
        turn = ((unit - direction[:, :, None] * direction[:, None, :])
                * (bound / np.where(size > 0, size, 1.0))[:, :, None])
        stuck = sticks[:, :, None]
        by_force[point, 1:, 1:] = np.where(stuck, 0.0, (unit - turn) / r[:, :, None])
        by_jump[point, 1:, 1:] = np.where(stuck, -unit, -turn)
        # The bound falls with the traction and with the opening.
        falls = np.where(~sticks & (pressure[:, None] > 0), friction * direction, 0.0)
        by_force[point, 1:, 0] = falls / r
        by_jump[point, 1:, 0] = falls

    def _size(self, u: Floats, force: Floats, jump: Floats, balance: Floats, law: Floats) -> float:
        p = self.problem
        work = self.absolute @ abs(u)
        acting = max(abs(self.load).max(), abs(force).max(initial=0.0), 1e-6 * self.imposed, 1e-300)
        forces = max(acting, LOST_DIGITS * work.max())
        missing = abs(balance).max()
        gaps = abs(self.value[self.normal]).max(initial=0.0)
        lengths = max(abs(jump).max(initial=0.0), abs(u).max(), gaps, abs(self.old).max(initial=0.0), 1e-300)
        return float(max(missing / forces, LEAST_SHARE * missing / acting, abs(law).max(initial=0.0) / lengths))


def _blocks(blocks: Floats) -> sparse.bsr_matrix:
    """Block diagonal matrix."""
    count, d, _ = blocks.shape
    return sparse.bsr_matrix((blocks, np.arange(count), np.arange(count + 1)), (count * d, count * d))


class _Iteration:
    def __init__(self, equations: StepEquations, shift: Floats) -> None:
        self.equations = equations
        self.shift = shift

    def _direction(self, at: Residual) -> tuple[Floats, Floats]:
        p = self.equations.problem
        size = p.stiffness.shape[0]
        held = sparse.diags(p.stiffness.diagonal() * self.shift[:size])
        loose = sparse.diags(self.shift[size:] / self.equations.r)
        matrix = sparse.bmat([[p.stiffness + held, p.jump.T],
                              [_blocks(at.by_jump) @ p.jump, _blocks(at.by_force) + loose]], format="csc")
        step = splu(matrix).solve(-np.concatenate([at.balance, at.law]))
        if not np.isfinite(step).all():
            raise RuntimeError("singular")
        return step[:size], step[size:]

    def run(self, start: State, damped: bool) -> State:
        """Full steps, or steps that must not raise the residual much; the best state on the way."""
        u, force = start.displacement.copy(), start.force.copy()
        here = self.equations.evaluate(u, force)
        best = State(u, force, here.size)
        idle = 0
        for _ in range(MOST_STEPS):
            if best.residual <= TOLERANCE or (idle >= 3 and best.converged) or idle >= 15:
                break
            try:
                du, df = self._direction(here)
            except RuntimeError:
                break
            length = 1.0
            there = self.equations.evaluate(u + du, force + df)
            while damped and length > 1e-3 and there.size > 1.02 * here.size:
                length *= 0.5
                there = self.equations.evaluate(u + length * du, force + length * df)
            u, force, here = u + length * du, force + length * df, there
            idle = idle + 1 if here.size > 0.5 * best.residual else 0
            if here.size < best.residual:
                best = State(u, force, here.size)
        return best


def forces_for(problem: Problem, step: int, displacement: Floats) -> Floats:
    """The smallest nodal forces that balance the parts as well as any at given displacements."""
    missing = problem.loads[step] - problem.stiffness @ displacement
    square = problem.jump @ problem.jump.T
    matrix = (square + sparse.diags(np.full(square.shape[0], 1e-9))).tocsc()
    return np.asarray(splu(matrix).solve(problem.jump @ missing))


def _search(equations: StepEquations, shift: Floats, start: State, count: int) -> State:
    """Newton from the start, then from where so many iterations of a splitting arrive."""
    iteration = _Iteration(equations, shift)
    best = iteration.run(start, damped=False)
    for factor in (0.3, 3.0):
        if best.converged:
            break
        u, force = split(equations.problem, equations.step, equations.old, start.displacement, start.force, factor,
                         count)
        for damped in (False, True):
            if not best.converged:
                best = min(best, iteration.run(State(u, force, np.inf), damped), key=lambda s: s.residual)
    return best


@dataclasses.dataclass(frozen=True)
class Found:
    """slides: no state was found, and with springs to the ground parts move as far as these are weak."""
    state: State
    slides: bool


def solve_step(problem: Problem, step: int, old: Floats, choice: Choice) -> Found:
    """One load step from a start: Newton, a splitting, springs to the ground that fade away, a longer splitting."""
    equations = StepEquations(problem, step, old, choice.penalty)
    state = _search(equations, choice.shift, choice.start, 100)
    if state.converged:
        return Found(state, False)
    ways = []
    from_springs = choice.start
    for weakness in 10.0 ** np.arange(-2, -11, -1):
        springs = sparse.diags(weakness * problem.stiffness.diagonal())
        held = dataclasses.replace(problem, stiffness=(problem.stiffness + springs).tocsr())
        now = _search(StepEquations(held, step, old, choice.penalty), choice.shift, from_springs, 100)
        if now.converged:
            from_springs = now
            ways.append(abs(now.displacement).max())
    state = min(state, _Iteration(equations, choice.shift).run(from_springs, False), key=lambda s: s.residual)
    if state.converged:
        return Found(state, False)
    if len(ways) >= 4 and ways[-1] > SLIDING * ways[-2] > SLIDING**2 * ways[-3]:
        return Found(state, True)
    return Found(_search(equations, choice.shift, from_springs, 1000), False)
