"""Finds the cheapest settings that keep a promise, runs them afresh, and writes those that have kept it as XML."""
import collections
import itertools
import math
import pathlib
import re
from dataclasses import dataclass

from harmos.report.writing import percent
from harmos.trade.budget import seconds_in_words
from harmos.trade.document import Document
from harmos.trade.judging import Judge
from harmos.trade.knobs import Role
from harmos.trade.ladder import GROWTH, RESERVE, Ladder, Rung, Settings
from harmos.trade.running import Runner

TRIALS = 4
"""Settings that are tried for one promise, at most; those that are refused do not count."""
SAFETY = 0.9
"""Share of a target that the expected error of settings may reach."""
WITHIN = "_within_"
"""In the name of settings, between that of the input and the target."""
MADE = "made"
"""Folder in that of the runs: results that are complete."""
REMARK = "settings of harmos trade"
"""Begins the comment at the head of settings."""
ALIKE = 1.15
"""Costs within this factor count as equal: of such settings those win that turn fewer knobs."""


@dataclass
class Promise:
    """Settings for a target.

    Attributes:
        target: largest relative error of any response.
        rung: the fresh run; None: none that was affordable keeps it.
        error: largest error of that run, the uncertainty of the reference included.
        files: its XML, of a study that of its scene as well; empty: none were written.
        reason: why there is none.
    """

    target: float
    rung: Rung | None = None
    error: float = math.inf
    files: tuple[pathlib.Path, ...] = ()
    reason: str = ""


def expected_costs(ladder: Ladder, judge: Judge) -> list[tuple[float, float, Settings]]:
    """Expected CPU time [s] and error of all settings that measured levels can be joined to, cheap and plain ones first."""
    bases = [rung.settings for family in ladder.families() for rung in ladder.meshes(family)]
    sides = ladder.indices(Role.SIDE)
    levels = [[rung.settings[knob] for rung in ladder.side(knob)] for knob in sides]
    choices = ladder.indices(Role.CHOICE)
    options = [[level for level in range(len(ladder.knobs[knob].levels))
                if level == ladder.knobs[knob].given or ladder.choice(knob, level)] for knob in choices]
    result = []
    for base in bases:
        for chosen in itertools.product(*levels, *options):
            settings = base
            for knob, level in zip((*sides, *choices), chosen):
                settings = ladder.turned(settings, knob, level)
            result.append((ladder.predicted(settings, "cpu") or math.inf, judge.expected(settings), settings))
    given = ladder.base()
    return sorted(result, key=lambda one: (round(math.log(max(one[0], 1e-6)) / math.log(ALIKE)),
                                           sum(i != j for i, j in zip(one[2], given)), one[0]))


def candidates(target: float, ladder: Ladder, judge: Judge) -> list[Settings]:
    """Settings that should keep a target, in the order in which they are tried; where none is expected to, those that have."""
    costs = expected_costs(ladder, judge)
    return [settings for _, error, settings in costs if error <= SAFETY * target] or [
        settings for _, _, settings in costs
        if settings in ladder.rungs and judge.promised(ladder.rungs[settings]) <= target]


def keep(target: float, ladder: Ladder, judge: Judge, runner: Runner, document: Document,
         folder: pathlib.Path, work: pathlib.Path) -> Promise:
    """The cheapest settings whose fresh run keeps the target.

    They are tried in `work`; those that keep it are written into MADE in it, to be moved into `folder`.
    """
    promise = Promise(target)
    if judge.doubt() > target:
        promise.reason = _doubtful(ladder, judge)
        return promise
    found = candidates(target, ladder, judge)
    if not found:
        promise.reason = _too_far(ladder, judge)
    trials = 0
    for settings in found:
        if trials == TRIALS:
            break
        if settings in ladder.refused:
            promise.reason = promise.reason or "settings that were expected to keep it are refused"
            continue
        rung = ladder.fresh.get(settings)
        if rung is None and GROWTH * (ladder.predicted(settings, "wall") or 0.0) > ladder.budget.left():
            promise.reason = "the budget does not allow the run that would show it"
            continue
        entries = [entry for knob, i in zip(ladder.knobs, settings) for entry in knob.levels[i].entries]
        name = settings_name(document, target)
        remark = (f"{REMARK} for errors below {100 * target:g} % in every response: {ladder.words(settings)}")
        if rung is None:
            trial = document.write(entries, work / name, remark)[0]
            allowance = ladder.budget.allowance(ladder.predicted(settings, "wall"))
            outcome = runner.run_file(trial, allowance, ladder.budget.memory)
            if outcome.refused:  # such as pieces, which fit the meshes they were measured on but not this one
                ladder.refused.add(settings)
                promise.reason = promise.reason or f"settings that were expected to keep it are {outcome.status}"
                continue
            trials += 1
            rung = Rung(settings, outcome, ladder.predicted(settings, "cpu") or math.nan, f"within {100 * target:g} %")
            ladder.fresh[settings] = rung
            ladder.report(rung)
        error = judge.promised(rung)
        if error <= target:
            files = document.write(entries, work / MADE / name, remark, folder)
            return Promise(target, rung, error, tuple(folder / file.name for file in files))
        promise.reason = "settings that were expected to keep it " + (
            f"came to {percent(error)}" if error < math.inf else f"ended otherwise than before: {rung.outcome.status}")
    return promise


def _too_far(ladder: Ladder, judge: Judge) -> str:
    """Why no settings that were measured keep a target whose reference is known."""
    error, settings = min((error, settings) for _, error, settings in expected_costs(ladder, judge))
    if error == math.inf:
        return f"no settings that were measured come so near{_following(ladder)}"
    return f"no settings that were measured come nearer than {percent(error)}{_help(ladder, judge.cause(settings))}"


def _doubtful(ladder: Ladder, judge: Judge) -> str:
    """Why the reference is not known well enough."""
    if ladder.no_equilibrium:
        return f"no equilibrium: {ladder.no_equilibrium}"
    if judge.doubt() < math.inf:
        name = max(judge.references, key=lambda one: judge.references[one].doubt())
        return f"the reference of {name} itself is known to {percent(judge.doubt())} only{_help(ladder, judge.references[name].cause)}"
    if not judge.references and ladder.rungs:
        statuses = collections.Counter(rung.outcome.status for rung in ladder.rungs.values())
        return f"nothing could be certified, mostly: {statuses.most_common(1)[0][0]}"
    second = ladder.second_mesh()
    if second is not None:
        return f"one mesh alone tells no error, and the next one {_needs(ladder, second)}"
    if len(ladder.knobs[ladder.index("mesh")].levels) == 1:
        return "one mesh alone tells no error, and nothing refines this one"
    failed = [rung for rung in ladder.meshes(ladder.base(), certified=False) if not rung.outcome.certified]
    return f"a finer mesh has no answer: {failed[-1].outcome.status}" if failed else "the budget leaves a reference unknown"


def _help(ladder: Ladder, cause: str) -> str:
    """What makes a reference known better that is uncertain because of a knob."""
    if cause == "mesh":
        return _following(ladder)
    knob = ladder.index(cause)
    finest = ladder.side(knob)[-1].settings[knob]
    levels = ladder.knobs[knob].levels
    if finest < len(levels) - 1:
        finer = ladder.turned(ladder.base(), knob, finest + 1)
        return f", most of it because of {cause}{_following(ladder, None if finer in ladder.rungs else finer)}"
    return f", most of it because of {cause}, of which {levels[finest].name} is the finest level: the input has to have a finer one"


def _following(ladder: Ladder, wanted: Settings | None = None) -> str:
    """What comes next and the budget has no time for, or what is wanted instead of it; empty: nothing."""
    following = ladder.unaffordable and (wanted or ladder.unaffordable)
    if following is None or not ladder.predicted(following, "wall"):
        return ""
    return f"; the next run, {ladder.words(following)}, {_needs(ladder, following)}"


def _needs(ladder: Ladder, settings: Settings) -> str:
    """What a run takes that the budget has no time for."""
    needed = ladder.predicted(settings, "wall") or 0.0
    budget = math.ceil((ladder.budget.spent() + needed) / (1 - RESERVE))  # rounded down it may be the one that has not done
    return f"may take {seconds_in_words(needed)}: that takes a budget of about {budget} s"


def settings_name(document: Document, target: float) -> str:
    """Of the file of settings for a target."""
    return f"{document.path.stem}{WITHIN}{100 * target:g}_percent.xml"


def settings_files(document: Document, folder: pathlib.Path) -> set[pathlib.Path]:
    """Settings in `folder`, if it is there, that this or an earlier trade of an input of this name has written."""
    name = re.compile(rf"{re.escape(document.path.stem)}{WITHIN}[0-9.e+-]+_percent(_scene)?\.xml")
    return {file for file in folder.glob("*") if name.fullmatch(file.name) and file.is_file()
            and file.read_text(errors="replace").startswith(f"<!-- {REMARK} ")}
