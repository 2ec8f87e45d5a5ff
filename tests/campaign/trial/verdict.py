"""Holds what Harmos says of a scene against the reference."""
from __future__ import annotations

import dataclasses
import enum
import math

from ..reference.solver import Answer, Outcome
from ..scenes.scene import Scene
from .program import Ending, Run


class Verdict(enum.Enum):
    """One per scene; the words are those of the table."""
    RIGHT = "certified and right"
    WRONG = "certified and WRONG"
    REFUSED = "refused although determined"
    OTHER = "certified, another solution of friction"
    EQUILIBRIUM_RIGHT = "exit 4, right"
    EQUILIBRIUM_WRONG = "exit 4, WRONG"
    EQUILIBRIUM_MISSED = "no equilibrium, missed"
    NOT_DETERMINED_SAID = "not determined in part, said so"
    NOT_DETERMINED_REFUSED = "not determined in part, refused"
    NOT_DETERMINED_UNSAID = "not determined in part, NOT said"
    CRASHED = "crash"
    HUNG = "hang"
    INPUT = "input refused"
    SLIDES = "slides without end, not certified"
    UNKNOWN = "reference does not know"


# Verdicts of which none may occur; of those in MISSED, at most this share of the scenes without equilibrium.
FORBIDDEN = (Verdict.WRONG, Verdict.REFUSED, Verdict.EQUILIBRIUM_WRONG, Verdict.CRASHED, Verdict.HUNG, Verdict.INPUT)
MOST_MISSED = 0.02
# How remarks begin that say that more than the responses they name may be different: parts that are free to move, and
# friction that depends on pressures which are not determined.
WARNINGS = ("nothing holds", "pressures are not determined")


@dataclasses.dataclass(frozen=True)
class Judgement:
    """error: true error of the worst determined response, over its size; estimate: the largest of Harmos for these."""
    verdict: Verdict
    error: float
    estimate: float
    detail: str


def true_errors(run: Run, answer: Answer) -> dict[str, float]:
    """Largest error over the load steps of every response, relative to its size; infinite where rows are missing."""
    errors = {}
    for name, value in answer.values.items():
        found = run.values.get(name)
        if found is None or len(found) != len(value):
            errors[name] = math.inf
        else:
            errors[name] = float(abs(found - value).max()) / answer.sizes[name] if abs(found - value).max() > 0 else 0.0
    return errors


def _are_within(scene: Scene, run: Run, answer: Answer, name: str) -> bool:
    """Whether Harmos says that a response is not determined, and from where to where, with the true values between. All
    ways of the reference may have come to one end of it."""
    if name not in run.ranges or len(answer.determined) == len(answer.values):
        return False
    (lower, upper), room, value = run.ranges[name], scene.accuracy * answer.sizes[name], answer.values[name]
    return len(lower) == len(value) and bool((lower - room <= value).all() and (value <= upper + room).all())


def _of_certified(scene: Scene, run: Run, answer: Answer) -> Judgement:
    errors = {name: error for name, error in true_errors(run, answer).items()
              if name in answer.determined and not _are_within(scene, run, answer, name)}
    worst = max(errors, key=lambda name: errors[name]) if errors else ""
    error = errors.get(worst, 0.0)
    estimate = max((run.estimates.get(name, 0.0) for name in errors), default=0.0)
    detail = f"{worst}: {error:.1e} for {scene.accuracy:g}, estimate {run.estimates.get(worst, 0.0):.1e}"
    beyond = max((errors[name] - answer.quadrature.get(name, 0.0) for name in errors), default=0.0)
    if beyond <= scene.accuracy < error:
        return Judgement(Verdict.UNKNOWN, error, estimate, detail + ", reference too coarse")
    if error > scene.accuracy:
        return Judgement(Verdict.WRONG, error, estimate, detail)
    if len(errors) == len(answer.values):
        return Judgement(Verdict.RIGHT, error, estimate, detail)
    unsaid = [name for name, spread in answer.spread.items() if spread > scene.accuracy and name not in run.ranges]
    if unsaid and not any(remark.startswith(WARNINGS) for remark in run.remarks):
        worst = max(unsaid, key=lambda name: answer.spread[name])
        detail = f"{', '.join(unsaid)}; {worst} by {answer.spread[worst]:.1e}"
        return Judgement(Verdict.NOT_DETERMINED_UNSAID, error, estimate, detail)
    return Judgement(Verdict.NOT_DETERMINED_SAID, error, estimate, detail)


def judge_again(scene: Scene, run: Run, answer: Answer, judgement: Judgement) -> Judgement:
    """A second look at what seems wrong, with an answer that includes the equilibrium next to what Harmos found."""
    errors = true_errors(run, answer)
    worst = max(errors.values(), default=math.inf)
    if len(answer.determined) < len(answer.values) and worst <= scene.accuracy:
        return dataclasses.replace(judgement, verdict=Verdict.OTHER, error=math.nan)
    return judgement


def judge(scene: Scene, run: Run, answer: Answer) -> Judgement:
    """The verdict on one scene."""
    def plain(verdict: Verdict, detail: str = "") -> Judgement:
        return Judgement(verdict, math.nan, math.nan, detail or f"{run.ending.name.lower()}: {run.reason[:200]}")

    match run.ending:
        case Ending.CRASHED | Ending.FAILED:
            return plain(Verdict.CRASHED)
        case Ending.HUNG:
            return plain(Verdict.HUNG)
        case Ending.REFUSED_INPUT:
            return plain(Verdict.INPUT, run.reason[-300:])
    if answer.outcome is Outcome.SLIDES and run.ending is not Ending.CERTIFIED:
        return plain(Verdict.SLIDES)
    if answer.outcome in (Outcome.UNKNOWN, Outcome.SLIDES):
        return plain(Verdict.UNKNOWN)
    if answer.outcome is Outcome.NO_EQUILIBRIUM:
        if run.ending is Ending.NO_EQUILIBRIUM:
            return plain(Verdict.EQUILIBRIUM_RIGHT)
        if run.ending is Ending.CERTIFIED:
            return plain(Verdict.WRONG, f"certified, but nothing balances step {answer.failed_step}")
        return plain(Verdict.EQUILIBRIUM_MISSED)
    if run.ending is Ending.CERTIFIED:
        return _of_certified(scene, run, answer)
    if run.ending is Ending.NO_EQUILIBRIUM:
        return plain(Verdict.EQUILIBRIUM_WRONG)
    return plain(Verdict.REFUSED if len(answer.determined) == len(answer.values) else Verdict.NOT_DETERMINED_REFUSED)
