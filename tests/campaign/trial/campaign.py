"""Runs many scenes and counts the verdicts."""
from __future__ import annotations

import dataclasses
import pathlib
import shutil
import statistics
import time
from collections.abc import Iterable

from ..reference.solver import finer, follow, solve
from ..scenes.classes import make_scene, make_twin
from ..scenes.scene_file import write_scene
from .fields import read_displacements
from .program import Ending, run_harmos
from .verdict import FORBIDDEN, MOST_MISSED, Judgement, Verdict, judge, judge_again

# Below, a true error is round-off and its ratio to the estimate says nothing.
LEAST_ERROR = 1e-9
# Of scenes with these verdicts nothing more is said.
EXPECTED = (Verdict.RIGHT, Verdict.EQUILIBRIUM_RIGHT, Verdict.NOT_DETERMINED_SAID)


@dataclasses.dataclass(frozen=True)
class Trial:
    """One scene: class and seed make it anew. matching: linear stages of the same scene with meshes that match, if both
    were certified."""
    name: str
    seed: int
    nodes: int
    stages: int
    harmos_seconds: float
    reference_seconds: float
    judgement: Judgement
    matching: int | None = None


def try_scene(name: str, seed: int, program: pathlib.Path, folder: pathlib.Path, limit: float,
              accuracy: float | None = None) -> Trial:
    """Writes a scene, solves it both ways, judges; the files stay in folder/CLASS_SEED when the verdict is bad."""
    scene = make_scene(name, seed, accuracy)
    place = folder / f"{name}_{seed}"
    run = run_harmos(program, write_scene(scene, place), limit)
    start = time.monotonic()
    answer = solve(scene)
    judgement = judge(scene, run, answer)
    if judgement.verdict is Verdict.WRONG and answer.histories:
        judgement = judge(scene, run, finer(scene, answer))
        if judgement.verdict is Verdict.WRONG:
            near = follow(answer, read_displacements(place / "results" / "scene.e", scene.mesh))
            judgement = judge_again(scene, run, near, judgement)
    seconds = time.monotonic() - start
    matching = _matching_stages(name, seed, program, place / "matching", limit) if run.ending is Ending.CERTIFIED else None
    if judgement.verdict in EXPECTED:
        shutil.rmtree(place)
    return Trial(name, seed, len(scene.mesh.nodes), run.stages, run.seconds, seconds, judgement, matching)


def _matching_stages(name: str, seed: int, program: pathlib.Path, place: pathlib.Path, limit: float) -> int | None:
    twin = make_twin(name, seed)
    if twin is None:
        return None
    run = run_harmos(program, write_scene(twin, place), limit)
    return run.stages if run.ending is Ending.CERTIFIED else None


def _counts(trials: list[Trial]) -> list[int]:
    return [sum(trial.judgement.verdict is verdict for trial in trials) for verdict in Verdict]


def table(trials: list[Trial]) -> str:
    """Verdicts by class and in total."""
    names = list(dict.fromkeys(trial.name for trial in trials))
    lines = ["| class | scenes | " + " | ".join(verdict.value for verdict in Verdict) + " |",
             "|---" * (2 + len(Verdict)) + "|"]
    for name in names + ["total"]:
        some = [trial for trial in trials if name in (trial.name, "total")]
        lines.append(f"| {name} | {len(some)} | " + " | ".join(str(count) for count in _counts(some)) + " |")
    return "\n".join(lines)


def _figures(trials: list[Trial]) -> Iterable[str]:
    ratios = [trial.judgement.estimate / trial.judgement.error for trial in trials
              if trial.judgement.error > LEAST_ERROR and trial.judgement.verdict in EXPECTED]
    if ratios:
        yield (f"estimate / true error where right: least {min(ratios):.2f}, "
               f"median {statistics.median(ratios):.2f} of {len(ratios)}")
    stages = [trial.stages for trial in trials if trial.judgement.verdict is Verdict.RIGHT]
    if stages:
        yield (f"linear stages, certified and right: sum {sum(stages)}, median {statistics.median(stages):g}, "
               f"most {max(stages)}")
    pairs = [(trial.stages, trial.matching) for trial in trials if trial.matching]
    if pairs:
        own, matching = (sum(column) for column in zip(*pairs))
        single = [one / other for one, other in pairs]
        yield (f"linear stages over those of the same scene with matching meshes: sum {own} / {matching} = "
               f"{own / matching:.2f}, median {statistics.median(single):.2f}, most {max(single):.2f} of {len(pairs)}")
    yield (f"time: Harmos {sum(trial.harmos_seconds for trial in trials):.0f} s, "
           f"reference {sum(trial.reference_seconds for trial in trials):.0f} s")


def report(trials: list[Trial]) -> tuple[str, bool]:
    """The table, the figures, every scene that is not as it should be, and whether the goals are met."""
    lines = [table(trials), "", *_figures(trials), ""]
    for trial in sorted(trials, key=lambda t: t.judgement.verdict.value):
        if trial.judgement.verdict not in EXPECTED:
            lines.append(f"{trial.name} {trial.seed}: {trial.judgement.verdict.value}; {trial.judgement.detail}")
    by_verdict = dict(zip(Verdict, _counts(trials)))
    lost = by_verdict[Verdict.EQUILIBRIUM_RIGHT] + by_verdict[Verdict.EQUILIBRIUM_MISSED]
    met = not any(by_verdict[verdict] for verdict in FORBIDDEN)
    met = met and by_verdict[Verdict.EQUILIBRIUM_MISSED] <= MOST_MISSED * lost
    lines.append("goals: " + ("met" if met else "MISSED"))
    return "\n".join(lines), met
