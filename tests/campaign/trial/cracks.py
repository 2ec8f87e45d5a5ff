"""Random scenes of glue that fails: what Harmos certifies must be an equilibrium, with the damage that it has found."""
from __future__ import annotations

import dataclasses
import enum
import math
import pathlib
import shutil

import numpy as np

from ..reference.glue import GluedProblem
from ..scenes.glued import glued
from ..scenes.mesh import Floats
from ..scenes.scene import Scene
from ..scenes.scene_file import write_scene
from .fields import read_displacements
from .program import Ending, Run, run_harmos

# Of the accuracy: a solution that is farther away is another one.
_FAR = 30.0
# Of the accuracy: forces that a state may lack to balance if it is beside another solution nearer than that, as where
# nothing holds a body any more.
_NEAR_BALANCE = 1e-2
# Of the scenes: where a joint snaps there may be no state to come to rest at.
MOST_REFUSED = 0.2


class Verdict(enum.Enum):
    """One per scene; the words are those of the table."""
    RIGHT = "certified and right"
    BALANCED = "in equilibrium, from where Newton's method goes elsewhere"
    WRONG = "certified and WRONG"
    REFUSED = "not certified"
    FAILED = "crash, hang or refused input"


@dataclasses.dataclass(frozen=True)
class Judgement:
    """error: largest distance of a displacement from the equilibrium that Newton's method comes to, over the largest
    displacement; lacking: largest force that a state itself lacks to balance, over the largest that acts."""
    verdict: Verdict
    error: float = math.nan
    lacking: float = math.nan
    detail: str = ""


@dataclasses.dataclass(frozen=True)
class CrackTrial:
    """One scene: the seed makes it anew."""
    seed: int
    stages: int
    judgement: Judgement


def judge_states(scene: Scene, states: Floats) -> Judgement:
    """The verdict on states [step, dof], each with the damage that the one before has left."""
    problem = GluedProblem(scene)
    old = np.zeros(len(problem.area))
    size, force = float(abs(states).max()), max(problem.force(state) for state in states)
    near = scene.accuracy * size
    error = lacking = beside = 0.0
    for step, state in enumerate(states):
        lacking = max(lacking, problem.lacking(state, old, near)[0] / force)
        beside = max(beside, float(abs(problem.prescribe(state, step) - state).max()) / size)
        exact = problem.solve(state, old, step, near)
        error = math.nan if exact is None else np.maximum(error, float(abs(state - exact).max()) / size)
        old = problem.glue.damage(problem.jumps(state), old)
    if error <= scene.accuracy:
        return Judgement(Verdict.RIGHT, error, lacking)
    is_elsewhere = math.isnan(error) or error > _FAR * scene.accuracy
    bound = scene.accuracy if is_elsewhere else _NEAR_BALANCE * scene.accuracy
    is_balanced = lacking <= bound and beside <= scene.accuracy
    return Judgement(Verdict.BALANCED if is_balanced else Verdict.WRONG, error, lacking)


def judge_run(scene: Scene, run: Run, results: pathlib.Path) -> Judgement:
    """The verdict on a run."""
    if run.ending is Ending.CERTIFIED:
        states = read_displacements(results, scene.mesh)
        if len(states) != scene.steps:
            return Judgement(Verdict.WRONG, detail=f"{len(states)} of {scene.steps} load steps")
        return judge_states(scene, states)
    if run.ending is Ending.NOT_CONVERGED:
        return Judgement(Verdict.REFUSED, detail=run.reason[:200])
    return Judgement(Verdict.FAILED, detail=f"{run.ending.name.lower()}: {run.reason[:200]}")


def try_crack(seed: int, program: pathlib.Path, folder: pathlib.Path, limit: float) -> CrackTrial:
    """Solves a scene and judges it; the files of what is wrong stay in folder/glued_SEED."""
    scene = glued(seed)
    place = folder / f"glued_{seed}"
    run = run_harmos(program, write_scene(scene, place), limit)
    judgement = judge_run(scene, run, place / "results" / "scene.e")
    judgement = dataclasses.replace(judgement, detail=judgement.detail or f"asked for {scene.accuracy:g}")
    if judgement.verdict not in (Verdict.WRONG, Verdict.FAILED):
        shutil.rmtree(place)
    return CrackTrial(seed, run.stages, judgement)


def crack_report(trials: list[CrackTrial]) -> tuple[str, bool]:
    """How many there are of each verdict, every scene that is not certified and right, and whether the goals are met."""
    verdicts = [trial.judgement.verdict for trial in trials]
    lines = ["| scenes | " + " | ".join(one.value for one in Verdict) + " |", "|---" * (1 + len(Verdict)) + "|",
             f"| {len(trials)} | " + " | ".join(str(verdicts.count(one)) for one in Verdict) + " |", ""]
    stages = [trial.stages for trial in trials if trial.judgement.verdict is Verdict.RIGHT]
    if stages:
        lines += [f"linear stages, certified and right: sum {sum(stages)}, median {np.median(stages):g}, "
                  f"most {max(stages)}", ""]
    lines += [f"glued {trial.seed}: {trial.judgement.verdict.value}; error {trial.judgement.error:.1e}, lacking "
              f"{trial.judgement.lacking:.1e}; {trial.judgement.detail}"
              for trial in trials if trial.judgement.verdict is not Verdict.RIGHT]
    met = not {Verdict.WRONG, Verdict.FAILED} & set(verdicts)
    met = met and verdicts.count(Verdict.REFUSED) <= math.ceil(MOST_REFUSED * len(trials))
    return "\n".join([*lines, "goals: " + ("met" if met else "MISSED")]), met
