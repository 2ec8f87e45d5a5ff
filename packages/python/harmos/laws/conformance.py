"""What every law must do, tried on a law in Python with lines drawn at random.

    harmos.laws.conform(Glue, {"Stiffness": 100.0})

The suite that laws in C++ pass (harmos_add_law_conformance in CMake) runs on files of laws in Python, too, and tries
more; this one needs no compiler.
"""
from collections.abc import Iterator, Mapping
from typing import Any

import numpy

from harmos.arrays import Floats, Integers
from harmos.laws import bridge
from harmos.laws.intersection import NoIntersection
from harmos.laws.law import Law, Where

POINTS = 60
"""Lines that are tried at a time."""
STEPS = 5
"""Load steps, one after the other."""
SEED = 20240405
"""Of the lines."""
ROUND_OFF = 1e-9
"""Relative to the sizes that are met; tractions found by Newton's method have about this."""


class DoesNotConform(AssertionError):
    """A law does not do what every law must; the message lists all of it."""


def conform(law: type[Law], parameters: Mapping[str, Any] | None = None, length: float = 1.0,
            stiffness: float = 1.0) -> None:
    """Tries a law: one graph whatever the line, no fall beyond `lowest_slope`, points that do not see each other, a
    history that begins from the old one, NaN that does not hang.

    Args:
        law: a class derived from harmos.laws.Law.
        parameters: its parameters by name; of those that are left out the defaults. Lists for numbers that vary.
        length: size of the jumps that are tried.
        stiffness: the lines have compliances around 1 / stiffness.

    Raises:
        DoesNotConform: with all that was found.
        TypeError, ValueError: what the law itself raises, or a shape that is wrong.
    """
    bridge.check_declaration(law)
    object_ = bridge.made(law, completed(law, parameters or {}))
    faults = list(dict.fromkeys(_faults(object_, length, stiffness)))  # each once
    if faults:
        raise DoesNotConform(f"{law.__name__}: " + "; ".join(faults))


def completed(law: type[Law], given: Mapping[str, Any]) -> dict[str, Any]:
    """With the defaults of a law; KeyError for a name that it does not have or that must be given."""
    entries = {entry.name: entry for entry in law.parameters}
    unknown = [name for name in given if name not in entries]
    if unknown:
        raise KeyError(f"{law.__name__} has no parameter {unknown[0]!r}")
    values: dict[str, Any] = {}
    for name, entry in entries.items():
        if name in given or entry.default is not None:
            value = given.get(name, entry.default)
            values[name] = numpy.atleast_1d(value).tolist() if entry.varying else value
        elif not entry.optional:
            raise KeyError(f"{law.__name__} needs the parameter {name!r}")
    return values


def _where(step: int, random: numpy.random.Generator) -> Where:
    """Points on a plane, at a load step of duration 1."""
    frames = numpy.broadcast_to(numpy.eye(3), (POINTS, 3, 3)).copy()
    return Where(step, step + 1.0, 1.0, numpy.zeros(POINTS), random.uniform(-1.0, 1.0, (POINTS, 3)), frames,
                 numpy.ones(POINTS), numpy.arange(POINTS))


def _part(at: Where, rows: Integers) -> Where:
    """Some of the points."""
    return Where(at.step, at.time, at.duration, at.gap[rows], at.position[rows], at.frame[rows], at.area[rows],
                 at.number[rows])


def _faults(law: Law, length: float, stiffness: float) -> Iterator[str]:
    try:
        yield from _faults_on_lines(law, length, stiffness)
    except NoIntersection as error:
        yield str(error)


def _faults_on_lines(law: Law, length: float, stiffness: float) -> Iterator[str]:
    random = numpy.random.default_rng(SEED)
    old = numpy.zeros((POINTS, law.history))
    limit = 0.5 / -law.lowest_slope if law.lowest_slope < 0.0 else numpy.inf
    for step in range(STEPS):
        at = _where(step, random)
        free = random.normal(scale=length, size=(POINTS, 3))
        compliance = numpy.minimum(10.0 ** random.uniform(-2.0, 2.0, (POINTS, 1)) / stiffness, limit)
        traction, history, _ = bridge.solved(law, at, free, compliance, old)
        if not numpy.isfinite(traction).all() or not numpy.isfinite(history).all():
            yield "tractions or histories are not finite"
            return
        yield from _one_graph(law, at, old, free, compliance, traction, limit)
        yield from _falls(law, at, old, free, compliance, traction, random)
        yield from _apart(law, at, old, free, compliance, traction, history)
        old = history
    bridge.solved(law, _where(STEPS, random), numpy.full((POINTS, 3), numpy.nan), numpy.ones((POINTS, 1)), old)


def _one_graph(law: Law, at: Where, old: Floats, free: Floats, compliance: Floats, traction: Floats,
               limit: float) -> Iterator[str]:
    """Any other line through the point that was found must lead to the same point."""
    jump = free - compliance * traction
    for ratio in (0.1, 3.0):
        other = numpy.minimum(ratio * compliance, limit)
        again = bridge.solved(law, at, jump + other * traction, other, old)[0]
        size = abs(traction).sum(1) + (abs(free).sum(1) / numpy.minimum(compliance, other)[:, 0])
        if (abs(again - traction).sum(1) > ROUND_OFF * size).any():
            yield "another line through the same point leads to another traction: it does not solve for one graph"
        again_there = bridge.solved(law, at, free, compliance, old)[0]
        if (again_there != traction).any():
            yield "asked twice, it gives two tractions: it keeps something from call to call"


def _falls(law: Law, at: Where, old: Floats, free: Floats, compliance: Floats, traction: Floats,
           random: numpy.random.Generator) -> Iterator[str]:
    """(t_a - t_b).(delta_a - delta_b) >= lowest_slope |delta_a - delta_b|^2; under the same normal line, where the cone
    of friction is, and along rays where it softens."""
    other = random.uniform(0.0, 3.0, (POINTS, 1)) * free if law.lowest_slope < 0.0 else free + random.normal(
        scale=abs(free).max(), size=free.shape)
    other[:, 0] = free[:, 0] if law.lowest_slope == 0.0 else other[:, 0]
    there = bridge.solved(law, at, other, compliance, old)[0]
    jumps, tractions = (free - other) - compliance * (traction - there), traction - there
    work = (jumps * tractions).sum(1) - law.lowest_slope * (jumps * jumps).sum(1)
    size = (abs(free) + abs(other)).sum(1) * (abs(traction) + abs(there)).sum(1)
    if (work < -ROUND_OFF * size).any():
        yield "the traction falls while the jump grows, by more than `lowest_slope` says"


def _apart(law: Law, at: Where, old: Floats, free: Floats, compliance: Floats, traction: Floats,
           history: Floats) -> Iterator[str]:
    """Some points alone give what they give among all."""
    rows = numpy.arange(0, POINTS, 7)
    alone = bridge.solved(law, _part(at, rows), free[rows], compliance[rows], old[rows])
    size = abs(traction[rows]).sum(1) + abs(free[rows]).sum(1) / compliance[rows, 0]
    if (abs(alone[0] - traction[rows]).sum(1) > ROUND_OFF * size).any():
        yield "a point gives another traction when others are asked with it"
    if law.history > 0 and (abs(alone[1] - history[rows]).sum(1) > ROUND_OFF * (1.0 + abs(history[rows]).sum(1))).any():
        yield "a point keeps another history when others are asked with it"
