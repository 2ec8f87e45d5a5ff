"""The answer of a scene by an independent way: solved to round-off, and told what of it is determined."""
from __future__ import annotations

import dataclasses
import enum
from collections.abc import Iterator

import numpy as np

from ..scenes.mesh import Floats
from ..scenes.scene import Scene
from .newton import SHIFT, Choice, State, forces_for, solve_step
from .problem import FINEST, Problem, assemble
from .responses import History
from .statics import Balance, statics

# Two ways to an answer that differ by more, relative to its size, have found two answers.
SAME = 1e-6
# Slip and openings below this share of the largest jump are none.
AT_REST = 1e-9
# Of the area of a join: what quadrature does not resolve is round-off.
RESOLVED = 1e-7
# Times as fine, where the usual quadrature may be what is wrong.
FINER = 8
# By which equilibria are looked for next to a field.
PENALTIES = (1.0, 0.01, 100.0)
# Tried when one of the ways fails.
MORE_WAYS = 2


class Outcome(enum.Enum):
    """What is known of a scene."""
    SOLVED = "solved"
    NO_EQUILIBRIUM = "no equilibrium"
    SLIDES = "slides without end"
    UNKNOWN = "unknown"


@dataclasses.dataclass
class Answer:
    """What the reference says of a scene.

    histories: the fields by several ways, of which the first one counts. values: per response [step]. sizes: by which
    errors are measured. spread: largest relative difference between the ways, per response. quadrature: what the
    integrals over joins leave open of a response, over its size, twice what it changes by when these are coarser.
    failed_step: the first without solution.
    balances: statics per load step.
    """
    outcome: Outcome
    histories: list[History]
    values: dict[str, Floats]
    sizes: dict[str, float]
    spread: dict[str, float]
    failed_step: int | None
    balances: list[Balance]
    quadrature: dict[str, float] = dataclasses.field(default_factory=dict)

    @property
    def determined(self) -> list[str]:
        """Responses that all ways agree on."""
        return [name for name, spread in self.spread.items() if spread <= SAME]


def _equilibrium_near(scene: Scene, problem: Problem, displacement: Floats, penalty: float) -> History | None:
    shift = np.full(problem.stiffness.shape[0] + len(problem.kind), SHIFT)
    old = np.zeros(len(problem.kind))
    displacements, forces = [], []
    for step, u in enumerate(displacement):
        start = State(u, forces_for(problem, step, u), np.inf)
        state = solve_step(problem, step, old, Choice(shift, penalty, start)).state
        if not state.converged:
            return None
        displacements.append(state.displacement)
        forces.append(state.force)
        old = problem.jump @ state.displacement
    return History(scene, problem, np.array(displacements), np.array(forces))


def equilibria_near(scene: Scene, problem: Problem, displacement: Floats) -> Iterator[History]:
    """Equilibria next to given displacements [step, dof], by several scales of the penalty (see Choice): where friction
    may jam or let go, these decide which of the two is found. None where there are none."""
    for penalty in PENALTIES:
        found = _equilibrium_near(scene, problem, displacement, penalty)
        if found is not None:
            yield found


def follow(answer: Answer, displacement: Floats) -> Answer:
    """The answer with one more way: that of the equilibrium nearest to given displacements [step, dof], if there is
    one."""
    first = answer.histories[0]
    if displacement.shape != first.displacement.shape:
        return answer
    found = list(equilibria_near(first.scene, first.problem, displacement))
    if not found:
        return answer
    nearest = min(found, key=lambda one: float(abs(one.displacement - displacement).max()))
    return dataclasses.replace(_compare(first.scene, [nearest, *answer.histories], answer.balances),
                               quadrature=answer.quadrature)


class _March:
    """All load steps by one way; seed 0: from rest, with an even shift; others: uneven, from sticking everywhere."""

    def __init__(self, scene: Scene, problem: Problem, seed: int) -> None:
        self.scene = scene
        self.problem = problem
        self.random = np.random.default_rng(seed)
        self.seed = seed
        self.uneven = seed > 0
        size = problem.stiffness.shape[0] + len(problem.kind)
        self.shift = SHIFT * (self.random.uniform(0.2, 5.0, size) if self.uneven else np.ones(size))
        self.penalty = float(self.random.uniform(0.2, 5.0)) if self.uneven else 1.0
        self.failed_step: int | None = None
        self.slides = False

    def _starts(self, step: int, state: State) -> list[State]:
        if not self.uneven:
            return [state]
        p = self.problem
        size = abs(p.loads[step]).max() + abs(state.force).max(initial=0.0)
        normal = p.contact_points * p.dimension
        force = state.force.copy()
        force[normal] -= size * self.random.uniform(0.5, 1.5, len(normal))
        for axis in range(1, p.dimension):  # sticking with friction that is not needed, where it costs nothing
            force[normal + axis] = 0.7 * p.friction[step] * force[normal] * self.random.uniform(-1, 1, len(normal))
        return [State(state.displacement, force, np.inf), state]

    def _stirred(self, step: int, old: Floats, state: State) -> State:
        """The state with other pressure where contacts just touch, or other friction where they do not slip, solved
        again: the same where it is determined. Not both, lest one undoes the other."""
        p, d = self.problem, self.problem.dimension
        jump = p.jump @ state.displacement
        rows = p.contact_points * d
        slip = np.linalg.norm((jump - old).reshape(-1, d)[p.contact_points, 1:], axis=1)
        rests = slip <= AT_REST * abs(jump).max(initial=0.0)
        touches = abs(jump[rows] + p.value[step][rows]) <= AT_REST * abs(jump).max(initial=0.0)
        force = state.force.copy()
        if self.seed % 2:
            more = 0.1 * abs(force).max(initial=0.0) * self.random.uniform(0, 1, len(rows))
            force[rows] -= np.where(touches, more, 0.0)
        else:
            for axis in range(1, d):
                free = 0.7 * p.friction[step] * abs(force[rows]) * self.random.uniform(-1, 1, len(rows))
                force[rows + axis] = np.where(rests, free, force[rows + axis])
        start = State(state.displacement, force, np.inf)
        found = solve_step(p, step, old, Choice(self.shift, self.penalty, start))
        return found.state if found.state.converged else state

    def run(self) -> History | None:
        """The fields; none when a step fails."""
        rows = len(self.problem.kind)
        state = State(np.zeros(self.problem.stiffness.shape[0]), np.zeros(rows), np.inf)
        old = np.zeros(rows)
        displacements, forces = [], []
        for step in range(self.problem.steps):
            for start in self._starts(step, state):
                found = solve_step(self.problem, step, old, Choice(self.shift, self.penalty, start))
                self.slides = found.slides
                if found.state.converged or found.slides:
                    break
            if not found.state.converged:
                self.failed_step = step
                return None
            state = self._stirred(step, old, found.state) if self.uneven else found.state
            displacements.append(state.displacement)
            forces.append(state.force)
            old = self.problem.jump @ state.displacement
        return History(self.scene, self.problem, np.array(displacements), np.array(forces))


def _compare(scene: Scene, histories: list[History], balances: list[Balance]) -> Answer:
    values, sizes, spread = {}, {}, {}
    for response in scene.responses:
        all_values = [history.response(response) for history in histories]
        values[response.name] = all_values[0]
        sizes[response.name] = histories[0].size(response)
        largest = max(float(abs(other - all_values[0]).max()) for other in all_values)
        spread[response.name] = 0.0 if largest == 0 else largest / sizes[response.name]
    return Answer(Outcome.SOLVED, histories, values, sizes, spread, None, balances)


def _quadrature(scene: Scene, problem: Problem, answer: Answer, finest: int = FINEST) -> dict[str, float]:
    if problem.uncertain < RESOLVED:
        return dict.fromkeys(answer.values, 0.0)
    # What is left falls as the parts do, but by fits: two steps tell more than one, and not the last digit of it.
    largest = dict.fromkeys(answer.values, 0.0)
    for parts, left in ((finest // 2, 1.0), (finest // 4, 0.5)):
        coarser = _March(scene, assemble(scene, parts), 0).run()
        for response in scene.responses:
            change = float("inf") if coarser is None else \
                float(abs(coarser.response(response) - answer.values[response.name]).max())
            largest[response.name] = max(largest[response.name], 2 * left * change / answer.sizes[response.name])
    return largest


def finer(scene: Scene, answer: Answer) -> Answer:
    """The answer with integrals over joins so much finer, by the way from rest; the one that is given where joins are
    resolved, or where that way fails. Its histories and spread stay: all ways have found out what is determined."""
    if answer.histories[0].problem.uncertain < RESOLVED:
        return answer
    problem = assemble(scene, FINER * FINEST)
    history = _March(scene, problem, 0).run()
    if history is None:
        return answer
    again = _compare(scene, [history], answer.balances)
    quadrature = _quadrature(scene, problem, again, FINER * FINEST)
    if not np.isfinite(list(quadrature.values())).all():
        return answer
    return dataclasses.replace(again, histories=answer.histories, spread=answer.spread, quadrature=quadrature)


def solve(scene: Scene, ways: int = 3) -> Answer:
    """Solves a scene by several ways; where none succeeds, statics says whether one could."""
    problem = assemble(scene)
    balances = [statics(problem, step) for step in range(problem.steps)]
    for step, balance in enumerate(balances):
        if balance.impossible:
            return Answer(Outcome.NO_EQUILIBRIUM, [], {}, {}, {}, step, balances)
    histories: list[History] = []
    failed = None
    for seed in range(ways + MORE_WAYS):
        march = _March(scene, problem, seed)
        history = march.run()
        if history is not None:
            histories.append(history)
        elif march.slides:
            return Answer(Outcome.SLIDES, [], {}, {}, {}, march.failed_step, balances)
        else:
            failed = march.failed_step
        if seed > 0 and not histories:
            break
        if len(histories) == ways:
            answer = _compare(scene, histories, balances)
            answer.quadrature = _quadrature(scene, problem, answer)
            return answer
    return Answer(Outcome.UNKNOWN, histories, {}, {}, {}, failed, balances)
