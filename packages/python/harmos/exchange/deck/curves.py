"""Values over the time of all steps, and the histories that a scene follows for them."""
import dataclasses
import typing

import numpy

from harmos.exchange.scene import SceneList

Points = tuple[tuple[float, float], ...]
"""Times and values, piecewise linear."""

ONSET = 1e-6
"""Share of a step within which what does not rise is there."""

UNLOADED: Points = ((0.0, 0.0),)
"""Before anything is said."""


@dataclasses.dataclass(frozen=True)
class Span:
    """The time of a step.

    Attributes:
        begin: of it [time].
        end: of it.
    """
    begin: float
    end: float


def followed(points: Points, span: Span, value: float, amplitude: "Points | None", at_once: bool) -> Points:
    """Goes on to a value over a step: linearly, by an amplitude that multiplies it, or at once."""
    last = points[-1][1]
    result = list(points)
    if span.begin > result[-1][0]:
        result.append((span.begin, last))
    if amplitude is not None:
        times, factors = [time for time, _ in amplitude], [factor for _, factor in amplitude]

        def at(time: float) -> float:
            return value * float(numpy.interp(time, times, factors))

        duration = span.end - span.begin
        if at(0.0) != last:
            result.append((span.begin + ONSET * duration, at(0.0)))
        result += [(span.begin + time, value * factor) for time, factor in amplitude if ONSET * duration < time < duration]
        result.append((span.end, at(duration)))
    elif at_once:
        step = ONSET * (span.end - span.begin)
        result += [(span.begin + step, value), (span.end, value)]
    else:
        result.append((span.end, value))
    return tuple(result)


_Key = typing.TypeVar("_Key")


@dataclasses.dataclass(frozen=True)
class Course:
    """How what a card names comes about over a step.

    Attributes:
        span: the step.
        amplitude: that multiplies it; None: it rises linearly.
        at_once: it does not rise, but is there from the beginning.
    """
    span: Span
    amplitude: "Points | None"
    at_once: bool

    def followed(self, points: Points, value: float) -> Points:
        """Goes on to a value."""
        return followed(points, self.span, value, self.amplitude, self.at_once)

    def set(self, table: dict[_Key, Points], key: _Key, value: float) -> None:
        """Goes on to a value, whatever the step has said before."""
        table[key] = self.followed(self._before(table.get(key, UNLOADED)), value)

    def add(self, table: dict[_Key, Points], key: _Key, value: float) -> None:
        """Goes on to a value; what the step has said before is added to."""
        points = table.get(key, UNLOADED)
        if points[-1][0] < self.span.end:
            self.set(table, key, value)
        else:
            table[key] = summed([(points, 1.0), (self.followed(((self.span.begin, 0.0),), value), 1.0)])

    def _before(self, points: Points) -> Points:
        return tuple(point for point in points if point[0] <= self.span.begin) or UNLOADED


def summed(shares: list[tuple[Points, float]]) -> Points:
    """Curves times factors, added up."""
    times = sorted({time for points, _ in shares for time, _ in points}) or [0.0]
    value = numpy.zeros(len(times))
    for points, factor in shares:
        table = numpy.array(points)
        value += factor * numpy.interp(times, table[:, 0], table[:, 1])
    return tuple(zip(times, value.tolist()))


def peak(points: Points) -> float:
    """The value that is largest in magnitude."""
    return max((value for _, value in points), key=abs)


def shape(points: Points) -> Points:
    """With that value divided out."""
    largest = peak(points)
    return tuple((time, value / largest if largest else 0.0) for time, value in points)


class Histories:
    """The list Histories of a scene; equal shapes are written once."""

    def __init__(self, scene: SceneList) -> None:
        """Adds to this scene."""
        self._scene = scene
        self._names: dict[Points, str] = {}

    def set(self, law: SceneList, entry: str, points: Points, factor: float = 1.0) -> None:
        """Sets an entry with its history."""
        value = peak(points) * factor
        law.set(entry, value)
        if value != 0.0:
            law.set(f"{entry} History", self._name(shape(points)))

    def _name(self, points: Points) -> str:
        if points not in self._names:
            name = f"history_{len(self._names) + 1}"
            self._names[points] = name
            history = self._scene.child("Histories").child(name).set("Type", "Table")
            history.set("Times", [time for time, _ in points]).set("Values", [value for _, value in points])
        return self._names[points]
