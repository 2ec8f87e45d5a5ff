"""Measures a scene on one rung after the other, the cheapest first, until the budget is spent."""
import itertools
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy

from harmos.trade.budget import Budget
from harmos.trade.costs import predicted_cost, predicted_memory
from harmos.trade.knobs import Knob, Role
from harmos.trade.running import Outcome, Runner

RESERVE = 0.3
"""Share of the budget that is kept for running the settings that are recommended."""
KEPT = RESERVE / 2
"""Share of the budget that no run of the ladder gets, however long it takes.

Not all of the reserve: the last run, which fits by its prediction, is the most accurate one, and mostly takes longer.
"""
GROWTH = 1.3
"""What a choice or a recommended run may cost over its prediction while it is still expected to fit."""
CHEAP = 0.02
"""Share of the budget up to which the second mesh, not the first, is the one that side knobs are measured on."""
NOTHING = 1e-2
"""Share of the least target that two answers may differ by and count as the same."""
NOISE = 0.2
"""Share of the least target that the iteration's error may have where meshes are compared: it counts three times in a reference."""
STOPPED = 2
"""Meshes in a row that have no answer in time, after which finer ones are not tried."""
STILL = {"time steps": 2}
"""Finer levels in a row that have to change nothing, if not 1: two counts of increments may miss the same peak of a load."""
CHOICES = 0.15
"""Share of the time left for the ladder that measuring one choice may take."""

Settings = tuple[int, ...]
"""A level of every knob, in the order of the knobs."""


@dataclass
class Rung:
    """One run.

    Attributes:
        settings: of it.
        outcome: what came of it.
        predicted: CPU time that was expected [s]; NaN: nothing was.
        purpose: why it was run, in a word.
    """

    settings: Settings
    outcome: Outcome
    predicted: float
    purpose: str


class Ladder:
    """Rungs measured so far, and those that come next.

    Attributes:
        knobs: what can be turned.
        rungs: by their settings, in the order of their runs.
        refused: settings beside them that Harmos does not take.
        fresh: runs of settings as they are recommended, for any target.
        budget: what may be used.
        accuracy: level of that knob at which meshes are compared.
        cheap: level of the mesh that side knobs are measured on.
        dimension: of the scene, 2 or 3.
        unaffordable: the next settings, for which the budget has no time; None: there are none.
        no_equilibrium: why there is none, as the run of the mesh as given says it; empty: it does not.
        report: called after every run.
    """

    def __init__(self, knobs: list[Knob], dimension: int, runner: Runner, budget: Budget,
                 report: Callable[[Rung], None]) -> None:
        """Runs nothing."""
        self.knobs, self.dimension, self.budget = knobs, dimension, budget
        self._least_target = 0.0
        self.rungs: dict[Settings, Rung] = {}
        self.refused: set[Settings] = set()
        self.fresh: dict[Settings, Rung] = {}
        self.unaffordable: Settings | None = None
        self.no_equilibrium = ""
        self.report = report
        self._runner = runner
        self._mesh = self.index("mesh")
        self.accuracy, self.cheap = knobs[self.index("accuracy")].given, 0

    def index(self, name: str) -> int:
        """Of a knob."""
        return next(i for i, knob in enumerate(self.knobs) if knob.name == name)

    def indices(self, *roles: Role) -> list[int]:
        """Of the knobs with these roles."""
        return [i for i, knob in enumerate(self.knobs) if knob.role in roles]

    def base(self, **levels: int) -> Settings:
        """The settings as given, at the accuracy at which meshes are compared and on the cheap mesh, but for `levels`."""
        settings = [knob.given for knob in self.knobs]
        settings[self._mesh], settings[self.index("accuracy")] = self.cheap, self.accuracy
        for name, level in levels.items():
            settings[self.index(name.replace("_", " "))] = level
        return tuple(settings)

    def turned(self, settings: Settings, knob: int, level: int) -> Settings:
        """The settings with one knob at another level."""
        return settings[:knob] + (level,) + settings[knob + 1:]

    def size(self, settings: Settings) -> float:
        """Distance of the nodes, over that of the input as given."""
        return math.prod(self.knobs[knob].levels[settings[knob]].size for knob in self.indices(Role.MESH, Role.FAMILY))

    def words(self, settings: Settings) -> str:
        """The settings for people."""
        return "; ".join(f"{knob.name} {knob.levels[i].name}" for knob, i in zip(self.knobs, settings)
                         if len(knob.levels) > 1)

    def explore(self, least_target: float, is_enough: Callable[[], bool],
                is_beaten: Callable[[Settings], bool]) -> None:
        """Measures until the budget is spent but for its reserve, or it is enough.

        Args:
            least_target: the smallest error that settings are wanted for.
            is_enough: asked before every rung.
            is_beaten: whether a family of meshes is not worth going on with.
        """
        self._choose_accuracy(least_target)
        self._least_target = least_target
        if not self.rungs[self.base()].outcome.certified:
            return  # no reference comes of anything else
        while not is_enough() or any(self._next_sides()):
            allowed = self.budget.left() - RESERVE * self.budget.seconds
            second = self.second_mesh()
            following = [second] if second else self._next(is_beaten)
            candidates = sorted((self.predicted(settings, "wall") or 0.0, settings) for settings in following)
            if not candidates:
                break
            if candidates[0][0] > allowed:
                self.unaffordable = candidates[0][1]
                break
            if predicted_memory(self, candidates[0][1]) > self.budget.memory:
                self.rungs[candidates[0][1]] = Rung(candidates[0][1], Outcome("left out: needs too much memory"),
                                                    math.nan, "mesh")
                continue
            self.measure(candidates[0][1], "ladder")
        if not self.second_mesh():
            self._measure_choices()

    def measure(self, settings: Settings, purpose: str) -> Rung:
        """Runs these settings, unless they have been run."""
        if settings in self.rungs:
            return self.rungs[settings]
        predicted = self.predicted(settings, "cpu")
        entries = [entry for knob, i in zip(self.knobs, settings) for entry in knob.levels[i].entries]
        allowance = self.budget.allowance(self.predicted(settings, "wall"), KEPT * self.budget.seconds)
        outcome = self._runner.run(entries, allowance, self.budget.memory)
        rung = Rung(settings, outcome, math.nan if predicted is None else predicted, purpose)
        self.rungs[settings] = rung
        self.report(rung)
        return rung

    def families(self) -> list[Settings]:
        """Settings on the cheap mesh of all families that are compared: as given, and one knob turned."""
        result = [self.base()]
        for knob in self.indices(Role.FAMILY):
            result += [self.turned(result[0], knob, level) for level in range(len(self.knobs[knob].levels))
                       if level != result[0][knob]]
        return result

    def meshes(self, family: Settings, certified: bool = True) -> list[Rung]:
        """The rungs of a family, coarse ones first."""
        rungs = [self.rungs.get(self.turned(family, self._mesh, level))
                 for level in range(len(self.knobs[self._mesh].levels))]
        return [rung for rung in rungs if rung is not None and (rung.outcome.certified or not certified)]

    def second_mesh(self) -> Settings | None:
        """The mesh without which nothing tells any error, where only one has been run; None: none is missing, or there is none."""
        measured = self.meshes(self.base(), certified=False)
        is_first = not any(rung.settings[self._mesh] > self.cheap for rung in measured)
        is_missing = is_first and len(self.meshes(self.base())) == 1
        return self.base(mesh=self.cheap + 1) if is_missing and self.cheap + 1 < len(self.knobs[self._mesh].levels) else None

    def side(self, knob: int) -> list[Rung]:
        """The certified rungs of a side knob on the cheap mesh, coarse ones first."""
        rungs = [self.rungs.get(self.turned(self.base(), knob, level)) for level in range(len(self.knobs[knob].levels))]
        return [rung for rung in rungs if rung is not None and rung.outcome.certified]

    def choice(self, knob: int, level: int) -> tuple[Rung, Rung] | None:
        """A choice and the same settings as given, where both are certified."""
        for settings, rung in self.rungs.items():
            given = self.rungs.get(self.turned(settings, knob, self.knobs[knob].given))
            if settings[knob] == level and rung.purpose == "choice" and given and (
                    rung.outcome.certified and given.outcome.certified):
                return rung, given
        return None

    def predicted(self, settings: Settings, what: str) -> float | None:
        """CPU or wall time of settings [s], from what has been measured; None: nothing to go by."""
        return predicted_cost(self, settings, what)

    def _choose_accuracy(self, least_target: float) -> None:
        """The loosest accuracy that is as tight as the least target and certified; then the cheap mesh."""
        knob = self.index("accuracy")
        levels = self.knobs[knob].levels
        self.accuracy = next((i for i, level in enumerate(levels) if level.size <= 1.001 * least_target), len(levels) - 1)
        stopped = 0
        given = self.knobs[self._mesh].given
        for mesh in range(len(self.knobs[self._mesh].levels)):
            if self.no_equilibrium and mesh < given:
                continue  # a coarse mesh has said so: the next one to ask is that as given
            self.cheap = mesh
            while not (outcome := self.measure(self.base(), "ladder").outcome).certified and self.accuracy > 0 and (
                    outcome.values or outcome.stopped) and not outcome.no_equilibrium and self._has_time():
                self.accuracy -= 1
            self.no_equilibrium = outcome.no_equilibrium
            if self.no_equilibrium and mesh >= given:
                return  # whatever the mesh and the accuracy
            stopped = stopped + 1 if outcome.stopped else 0
            if outcome.certified or stopped == STOPPED or not self._has_time():
                break
        self._tighten(least_target)
        following = self.base(mesh=self.cheap + 1) if self.cheap + 1 < len(self.knobs[self._mesh].levels) else None
        cost = self.predicted(following, "wall") if following else None
        if following and cost is not None and cost < CHEAP * self.budget.seconds and (
                self.measure(following, "ladder").outcome.certified):
            self.cheap += 1

    def _tighten(self, least_target: float) -> None:
        """A tighter accuracy where the run itself states too large an error, as expansions do of small deviations, or states none."""
        tightest = len(self.knobs[self.index("accuracy")].levels) - 1
        while (outcome := self.rungs[self.base()].outcome).certified and self.accuracy < tightest and self._has_time() and any(
                self._noise(outcome, name) > NOISE * least_target for name in outcome.values):
            self.accuracy += 1
            if not self.measure(self.base(), "ladder").outcome.certified:
                self.accuracy -= 1
                break

    def _noise(self, outcome: Outcome, name: str) -> float:
        """Error of the iteration in a response, relative: as the run states it, else what was asked for."""
        asked = self.knobs[self.index("accuracy")].levels[self.accuracy].size
        stated = outcome.estimates.get(name, math.nan) / max(outcome.sizes[name], 1e-300)
        return asked if math.isnan(stated) else stated

    def _has_time(self) -> bool:
        """Whether runs of the ladder may take any more."""
        return self.budget.left() > KEPT * self.budget.seconds

    def _next(self, is_beaten: Callable[[Settings], bool]) -> Iterator[Settings]:
        for family in self.families():
            measured = self.meshes(family, certified=False)
            failed = [not rung.outcome.certified for rung in measured[-2:]]
            if (failed and failed[-1] and not measured[-1].outcome.status.startswith("no")) or failed == [True, True]:
                continue
            if is_beaten(family) or self._is_copy(family):
                continue
            top = max((rung.settings[self._mesh] for rung in measured), default=-1)
            if top + 1 < len(self.knobs[self._mesh].levels):
                yield self.turned(family, self._mesh, top + 1)
        yield from self._next_sides()

    def _next_sides(self) -> Iterator[Settings]:
        """Of each side knob the next level: finer ones until STILL of them change nothing, then coarser ones."""
        for knob in self.indices(Role.SIDE):
            start = self.base()[knob]
            levels, still = [], 0
            for level in range(start + 1, len(self.knobs[knob].levels)):
                levels.append(level)
                rung = self.rungs.get(self.turned(self.base(), knob, level))
                before = self.rungs.get(self.turned(self.base(), knob, level - 1))
                is_still = rung is not None and (before is None or not self._differ(before, rung))
                still = still + 1 if is_still else 0
                if still == STILL.get(self.knobs[knob].name, 1):
                    break
            levels += range(start - 1, -1, -1)
            yield from itertools.islice((settings for settings in (
                self.turned(self.base(), knob, level) for level in levels) if settings not in self.rungs), 1)

    def _is_copy(self, family: Settings) -> bool:
        """Whether a family gives the very values of the one as given: quadratic elements where a file has them already."""
        first = next(iter(self.meshes(family)), None)
        given = self.rungs.get(self.turned(self.base(), self._mesh, first.settings[self._mesh])) if first else None
        if family == self.base() or first is None or given is None:
            return False
        one, other = first.outcome.values, given.outcome.values
        return one.keys() == other.keys() and all(numpy.array_equal(one[name], other[name]) for name in one)

    def _differ(self, one: Rung, other: Rung) -> bool:
        """Whether two certified rungs differ by more than a small share of the least target."""
        if not (one.outcome.certified and other.outcome.certified):
            return False
        return any(float(abs(one.outcome.values[name] - other.outcome.values[name]).max()) >
                   NOTHING * self._least_target * one.outcome.sizes[name] for name in one.outcome.values)

    def _measure_choices(self) -> None:
        """Each choice on the finest mesh that leaves time for it."""
        for knob in self.indices(Role.CHOICE):
            for level in range(len(self.knobs[knob].levels)):
                if level == self.knobs[knob].given:
                    continue
                for rung in reversed(self.meshes(self.base())):
                    if GROWTH * rung.outcome.wall <= CHOICES * (self.budget.left() - KEPT * self.budget.seconds):
                        self.measure(self.turned(rung.settings, knob, level), "choice")
                        break
