"""The answer of a scene by an independent way: solved to round-off, and told what of it is determined."""
from __future__ import annotations

import dataclasses
import enum

import numpy as np

from ..scenes.mesh import Floats
from ..scenes.scene import Scene
from .newton import SHIFT, Choice, State, solve_step
from .problem import Problem, assemble
from .responses import History
from .statics import Verdict, statics

# Two ways to an answer that differ by more, relative to its size, have found two answers.
SAME = 1e-6
# Tried when one of the ways fails.
MORE_WAYS = 2


class Outcome(enum.Enum):
    """What is known of a scene."""
    SOLVED = "solved"
    NO_EQUILIBRIUM = "no equilibrium"
    UNKNOWN = "unknown"


@dataclasses.dataclass
class Answer:
    """What the reference says of a scene.

    histories: the fields by several ways, of which the first one counts. values: per response [step]. sizes: by which
    errors are measured. spread: largest relative difference between the ways, per response. failed_step: the first
    without solution. verdicts: statics per load step.
    """
    outcome: Outcome
    histories: list[History]
    values: dict[str, Floats]
    sizes: dict[str, float]
    spread: dict[str, float]
    failed_step: int | None
    verdicts: list[Verdict]

    @property
    def determined(self) -> list[str]:
        """Responses that all ways agree on."""
        return [name for name, spread in self.spread.items() if spread <= SAME]


def _march(scene: Scene, problem: Problem, seed: int) -> tuple[History | None, int]:
    """All load steps by one way; seed 0: from rest, with an even shift. Returns the step that failed, too."""
    random = np.random.default_rng(seed)
    dofs, rows = problem.stiffness.shape[0], len(problem.kind)
    shift = np.full(dofs + rows, SHIFT)
    penalty = 1.0
    state = State(np.zeros(dofs), np.zeros(rows), np.inf)
    if seed:
        shift *= random.uniform(0.2, 5.0, dofs + rows)
        penalty = float(random.uniform(0.2, 5.0))
    displacements, forces = [], []
    old = np.zeros(rows)
    for step in range(problem.steps):
        start = state
        if seed:  # everything in contact, with uneven pressure
            size = abs(problem.loads[step]).max() + abs(state.force).max(initial=0.0)
            force = state.force.copy()
            normal = problem.contact_points * problem.dimension
            force[normal] -= size * random.uniform(0.5, 1.5, len(normal))
            start = State(state.displacement, force, np.inf)
        state = solve_step(problem, step, old, Choice(shift, penalty, start))
        if not state.converged:
            return None, step
        displacements.append(state.displacement)
        forces.append(state.force)
        old = problem.jump @ state.displacement
    return History(scene, problem, np.array(displacements), np.array(forces)), -1


def solve(scene: Scene, ways: int = 2) -> Answer:
    """Solves a scene by several ways; where none succeeds, statics says whether one could."""
    problem = assemble(scene)
    verdicts = [statics(problem, step) for step in range(problem.steps)]
    if any(verdict.impossible for verdict in verdicts):
        first = next(step for step, verdict in enumerate(verdicts) if verdict.impossible)
        return Answer(Outcome.NO_EQUILIBRIUM, [], {}, {}, {}, first, verdicts)
    histories: list[History] = []
    failed = -1
    for seed in range(ways + MORE_WAYS):
        history, step = _march(scene, problem, seed)
        failed = max(failed, step)
        if history is not None:
            histories.append(history)
        if len(histories) == ways:
            break
    if len(histories) < 2:
        return Answer(Outcome.UNKNOWN, histories, {}, {}, {}, failed, verdicts)
    values, sizes, spread = {}, {}, {}
    for response in scene.responses:
        all_values = [history.response(response) for history in histories]
        values[response.name] = all_values[0]
        sizes[response.name] = histories[0].size(response)
        largest = max(float(abs(other - all_values[0]).max()) for other in all_values)
        spread[response.name] = 0.0 if largest == 0 else largest / sizes[response.name]
    return Answer(Outcome.SOLVED, histories, values, sizes, spread, None, verdicts)
