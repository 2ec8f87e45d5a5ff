"""How far every rung is off: the limit of all ladders, and the errors of mesh, time, expansion and iteration."""
import math
from collections.abc import Collection
from dataclasses import dataclass, replace

import numpy

from harmos.arrays import Floats
from harmos.trade.knobs import Role
from harmos.trade.ladder import Ladder, Rung, Settings
from harmos.trade.limits import Limit, contradiction, limit_of
from harmos.trade.running import Outcome

LEVELS = 2
"""Meshes of a family from which on it may be left for a better one."""
TRUSTED = 1 / 3
"""Share of an estimate of the mesh's error that is believed at least, see docs/method/mesh-error.md."""
CLEARLY = 2.0
"""How many times smaller an error must be to count as clearly smaller."""


@dataclass
class Reference:
    """What a response goes to.

    Attributes:
        values: on the finest of all levels, [value].
        uncertainty: how far off they may be; inf: unknown, [value].
        size: what errors are relative to.
        space: the limit of the meshes alone.
        family: settings whose meshes have told it.
        is_disputed: whether other families differ by more than it would be uncertain without them.
        sides: limits of the side knobs by their indices.
        cause: knob that most of the largest uncertainty comes from.
    """

    values: Floats
    uncertainty: Floats
    size: float
    space: Limit
    family: Settings
    is_disputed: bool
    sides: dict[int, Limit]
    cause: str

    def largest(self) -> float:
        """The largest value, with its sign."""
        return float(self.values[numpy.argmax(abs(self.values))])

    def doubt(self) -> float:
        """The largest uncertainty, relative."""
        return _over(self.uncertainty, self.size)


@dataclass
class Family:
    """What the meshes of a family tell of a response.

    Attributes:
        settings: of the family.
        limit: of its meshes.
        sizes: of these, coarse ones first.
        values: on them, [mesh][value].
        finest: the run on the last one.
    """

    settings: Settings
    limit: Limit
    sizes: list[float]
    values: list[Floats]
    finest: Rung


class Judge:
    """Errors of rungs and of settings that have not been run, all relative; of what a ladder has measured so far.

    Attributes:
        references: by the names of the responses.
    """

    def __init__(self, ladder: Ladder, responses: Collection[str] = ()) -> None:
        """Finds the references of some responses, all if none is named; there are none while nothing is certified."""
        self._ladder = ladder
        self.references: dict[str, Reference] = {}
        base = ladder.rungs.get(ladder.base())
        if base is None or not base.outcome.certified:
            return
        for name in base.outcome.values:
            if responses and name.partition(", ")[0] not in responses:
                continue
            reference = self._reference(name)
            if reference is not None:
                self.references[name] = reference

    def doubt(self) -> float:
        """The largest uncertainty of all references, relative; inf: there is none."""
        return max((reference.doubt() for reference in self.references.values()), default=math.inf)

    def total(self, rung: Rung) -> dict[str, float]:
        """Measured distances of the responses from their references; NaN: no answer, or nothing tells how far off the reference is."""
        result = {}
        for name, reference in self.references.items():
            values = rung.outcome.values.get(name)
            if values is None or values.shape != reference.values.shape or reference.doubt() == math.inf:
                result[name] = math.nan
            else:
                result[name] = _relative(abs(values - reference.values), reference)
        return result

    def promised(self, rung: Rung) -> float:
        """The largest error of all responses with the uncertainty of its reference on top; inf: not certified."""
        if not rung.outcome.certified or not self.references:
            return math.inf
        largest = 0.0
        for name, reference in self.references.items():
            values = rung.outcome.values.get(name)
            if values is None or values.shape != reference.values.shape:
                return math.inf
            largest = max(largest, _relative(abs(values - reference.values) + reference.uncertainty, reference))
        return largest

    def worst(self, rung: Rung) -> float:
        """The largest measured error of all responses, without the uncertainty of the references; inf: no answer."""
        errors = list(self.total(rung).values())
        return max(errors) if errors and not any(map(math.isnan, errors)) else math.inf

    def is_beaten(self, family: Settings) -> bool:
        """Whether another family has come clearly nearer to the reference at less cost than the finest mesh of this one.

        None is where the response that is farthest off has a disputed reference: the finer mesh may be what is right.
        """
        own = self._ladder.meshes(family)
        if len(own) < LEVELS:
            return False
        errors = self.total(own[-1])
        if any(errors[name] == max(errors.values()) and one.is_disputed for name, one in self.references.items()):
            return False
        others = [rung for other in self._ladder.families() if other != family for rung in self._ladder.meshes(other)]
        return any(rung.outcome.cpu < own[-1].outcome.cpu and CLEARLY * self.worst(rung) < self.worst(own[-1])
                   for rung in others)

    def parts(self, settings: Settings, name: str) -> dict[str, float]:
        """What mesh, each side knob and choices do to a response, by the names of the knobs; NaN: not measured."""
        ladder, reference = self._ladder, self.references[name]
        base = ladder.base()
        parts = {}
        family = list(settings)
        for knob in ladder.indices(Role.SIDE, Role.CHOICE):
            family[knob] = base[knob]
            if ladder.knobs[knob].role is Role.SIDE:
                one = ladder.rungs.get(ladder.turned(base, knob, settings[knob]))
                limit = reference.sides[knob].values
            else:
                pair = ladder.choice(knob, settings[knob])
                one = pair[0] if pair else None
                limit = pair[1].outcome.values[name] if pair else reference.values
                if settings[knob] == ladder.knobs[knob].given:
                    continue
            is_known = one is not None and one.outcome.certified
            parts[ladder.knobs[knob].name] = (_relative(abs(one.outcome.values[name] - limit), reference)
                                              if one is not None and is_known else math.nan)
        mesh = ladder.rungs.get(tuple(family))
        parts["mesh"] = (_relative(abs(mesh.outcome.values[name] - reference.space.values), reference)
                         if mesh is not None and mesh.outcome.certified else math.nan)
        return parts

    def expected(self, settings: Settings) -> float:
        """The largest error that is expected of settings, uncertainties included; inf: not known."""
        largest = 0.0
        for name, reference in self.references.items():
            total = sum(self.parts(settings, name).values()) + reference.doubt()
            largest = max(largest, math.inf if math.isnan(total) else total)
        return largest if self.references else math.inf

    def cause(self, settings: Settings) -> str:
        """The knob that most of the error comes from that is expected() of settings."""
        def total(name: str) -> float:
            return sum(self.parts(settings, name).values()) + self.references[name].doubt()

        name = max(self.references, key=total)
        ladder, reference, parts = self._ladder, self.references[name], self.parts(settings, name)
        largest = max((knob for knob in parts if ladder.knobs[ladder.index(knob)].role is not Role.CHOICE),
                      key=lambda knob: parts[knob])
        return largest if parts[largest] > reference.doubt() else reference.cause

    def is_out_of_reach(self, target: float) -> bool:
        """Whether a side knob leaves more than a target on all its levels, the finest one included, which no mesh mends."""
        return any(self._left_by(knob) > target for knob in self._ladder.indices(Role.SIDE))

    def _left_by(self, knob: int) -> float:
        """What a side knob leaves at the best of its levels, the largest of all responses, relative; 0: finer ones are not measured."""
        ladder = self._ladder
        rungs = ladder.side(knob)
        if not rungs or rungs[-1].settings[knob] != len(ladder.knobs[knob].levels) - 1:
            return 0.0
        return max((min(self.parts(rung.settings, name)[ladder.knobs[knob].name] for rung in rungs)
                    for name in self.references), default=0.0)

    def _noise(self, rung: Rung, name: str) -> Floats:
        knob = self._ladder.index("accuracy")
        estimate = rung.outcome.estimates.get(name, math.nan)
        if math.isnan(estimate):
            estimate = self._ladder.knobs[knob].levels[rung.settings[knob]].size * rung.outcome.sizes[name]
        return numpy.full(rung.outcome.values[name].shape, estimate)

    def _family(self, settings: Settings, name: str) -> Family | None:
        """What the meshes of a family tell; None: none is certified."""
        rungs = [rung for rung in self._ladder.meshes(settings) if name in rung.outcome.values]
        if not rungs:
            return None
        sizes = [self._ladder.size(rung.settings) for rung in rungs]
        values = [rung.outcome.values[name] for rung in rungs]
        limit = limit_of(sizes, values, self._noise(rungs[-1], name))
        doubted = numpy.maximum(limit.uncertainty, _doubted(limit, rungs[-1].outcome, name))
        return Family(settings, replace(limit, uncertainty=doubted), sizes, values, rungs[-1])

    def _reference(self, name: str) -> Reference | None:
        ladder = self._ladder
        families = [family for settings in ladder.families() if (family := self._family(settings, name)) is not None]
        if not families:
            return None
        families.sort(key=lambda family: float(family.limit.uncertainty.max()))
        best, *others = families
        space, finest = best.limit, best.finest
        uncertainty = space.uncertainty + self._noise(finest, name)
        against = numpy.max([numpy.zeros(space.values.shape), *(_against(best, other) for other in others)], axis=0)
        is_disputed = bool((against > uncertainty).any())
        if is_disputed:
            space = replace(space, word=f"{space.word}; others differ")
        uncertainty = numpy.maximum(uncertainty, against)
        uncertainty = uncertainty + finest.outcome.design.get(name, 0.0)
        sides, shift = {}, numpy.zeros(space.values.shape)
        own = {"mesh": uncertainty}
        base = ladder.rungs[ladder.base()]
        foreign = _foreign(base.outcome.values[name], space.values)
        for knob in ladder.indices(Role.SIDE):
            rungs = [rung for rung in ladder.side(knob) if name in rung.outcome.values]
            sizes = [ladder.knobs[knob].levels[rung.settings[knob]].size for rung in rungs]
            if ladder.knobs[knob].name == "accuracy":  # what an iteration leaves does not shrink like a power
                tight = rungs[-1]
                sides[knob] = Limit(tight.outcome.values[name], self._noise(tight, name),
                                    numpy.full(space.values.shape, math.nan), "the tightest")
            else:
                sides[knob] = limit_of(sizes, [rung.outcome.values[name] for rung in rungs], self._noise(rungs[-1], name))
            own_shift = sides[knob].values - base.outcome.values[name]
            shift = shift + own_shift
            own[ladder.knobs[knob].name] = sides[knob].uncertainty + foreign * abs(own_shift)
        uncertainty = numpy.sum(list(own.values()), axis=0)
        worst = int(numpy.argmax(uncertainty))
        cause = max(own, key=lambda one: float(own[one][worst]))
        values = space.values + shift
        size = max(float(abs(values).max()), finest.outcome.sizes.get(name, 0.0))
        return Reference(values, uncertainty, size, space, best.settings, is_disputed, sides, cause)


def _against(best: Family, other: Family) -> Floats:
    """By how much another family disagrees with the one that gives the reference, [value]: where two do, one of them is wrong."""
    differing = contradiction(best.limit.values, best.sizes[-1], other.sizes, other.values)
    beyond = abs(other.limit.values - best.limit.values) - other.limit.uncertainty
    disagreement: Floats = numpy.maximum(differing, beyond)
    return disagreement


def _foreign(measured: Floats, limit: Floats) -> Floats:
    """Share of what a knob does on a mesh that may not carry over to fine ones: how far the mesh itself is off, [value]."""
    distance = abs(measured - limit)
    share = numpy.divide(distance, abs(limit), out=numpy.ones(limit.shape), where=limit != 0)
    capped: Floats = numpy.minimum(share, 1.0)
    return capped


def _doubted(limit: Limit, finest: Outcome, name: str) -> Floats:
    """What the estimate of the mesh's error in the finest run adds to the doubt of a limit, [value].

    Where no limit is claimed the finest mesh is off by the estimate. An extrapolation has to have gone at least a share
    of the way that is estimated.
    """
    estimate = finest.mesh.get(name, 0.0)
    carried = abs(limit.values - finest.values[name])
    missing: Floats = numpy.where(numpy.isnan(limit.orders), estimate, numpy.maximum(TRUSTED * estimate - carried, 0.0))
    return missing


def _relative(distance: Floats, reference: Reference) -> float:
    return _over(distance, reference.size)


def _over(distance: Floats, size: float) -> float:
    """The largest distance, relative; what is exactly 0 is known only where nothing is off."""
    largest = float(distance.max())
    if largest == 0.0:
        return 0.0
    return largest / size if size > 0 else math.inf
