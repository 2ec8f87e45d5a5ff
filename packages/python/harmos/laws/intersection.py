"""Where graphs meet lines, for many points at once.

A law that gives t(delta) is solved for delta + H t(delta) = delta_free at every point: Newton's method with central
differences, its steps halved until the residual falls; where that comes to no end, as at jumps of the graph, the three
components in turn, each bracketed: with a traction that does not fall, of g(delta) = delta + H t(delta) - delta_free,
whose slope is 1 at least, the root lies between 0 and -g(0). packages/laws/NewtonOnLine.hpp does the same for laws in
C++.
"""
from collections.abc import Callable

import numpy

from harmos.arrays import Floats, Mask

Graph = Callable[[Floats], Floats]
"""The tractions [stress] of all points at jumps [length], both (n, 3)."""

ROUND_OFF = 16.0 * float(numpy.finfo(float).eps)
"""Of the largest term, what may be left of a line that is met."""
SMALL = 1e-12
"""The same, where the terms of a formula cancel."""
LEAST_JUMP = 1e-6
"""Of the free jump, below which differences are no longer taken in parts of the jump."""
ITERATIONS = 100
"""Steps of Newton's method at most."""
LEAST_DECREASE = 1e-8
"""Of the residual, in parts of a whole step of Newton's method; small, as differences across a kink tell half of it."""
HALVINGS = 60
"""Of a step of Newton's method, at most."""
ROUNDS = 300
"""In which the components are taken in turn, at most."""
BISECTIONS = 200
"""Steps of a bracket at most."""


class NoIntersection(ArithmeticError):
    """No traction was found on the line of a point; the program ends with exit code 3.

    Attributes:
        point: the first of them, counted from 0.
    """

    def __init__(self, message: str, point: int) -> None:
        """`message`: a clause for the message of the program."""
        super().__init__(message)
        self.point = point


def resolvent(traction: Graph, free_jump: Floats, compliance: Floats) -> Floats:
    """The tractions, (n, 3), at which a graph meets the lines jump = free_jump - compliance * traction.

    Args:
        traction: the graph. It is asked for all points at a time, and at any jump.
        free_jump: [length], (n, 3). What is not finite is handed on.
        compliance: [length/stress], above 0, (n, 1).

    Raises:
        NoIntersection: the graph falls, or has no value somewhere.
    """
    finite = numpy.isfinite(free_jump).all(axis=1)
    lines = _Lines(traction, numpy.where(finite[:, None], free_jump, 0.0), compliance)
    with numpy.errstate(all="ignore"):
        found, met = _newton(lines)
        if not met.all():
            found, met = _in_turn(lines, found, met)
    if not met.all():
        point = int(numpy.argmin(met))
        raise NoIntersection("neither Newton's method nor the components in turn come to an end: the traction falls "
                             "while the jump grows, or is no number somewhere", point)
    return numpy.where(finite[:, None], found, free_jump)


class _Lines:
    """Lines, and the graph that is to meet them."""

    def __init__(self, traction: Graph, free_jump: Floats, compliance: Floats) -> None:
        self.traction, self.free_jump, self.compliance = traction, free_jump, compliance

    def residual(self, jump: Floats, traction: Floats) -> tuple[Floats, Floats, Floats]:
        """delta + H t - delta_free, its size, and the size of its terms, point by point."""
        rest = jump + self.compliance * traction - self.free_jump
        terms = abs(jump).sum(1) + self.compliance[:, 0] * abs(traction).sum(1) + abs(self.free_jump).sum(1)
        return rest, numpy.sqrt((rest * rest).sum(1)), terms

    def slopes(self, jump: Floats, traction: Floats) -> Floats:
        """dt_i / d(delta_j) by central differences, (n, 3, 3)."""
        largest = numpy.maximum(abs(self.free_jump).max(1), self.compliance[:, 0] * abs(traction).max(1))
        # Of the jump itself: laws that regularise a kink change within a small part of the free jump.
        size = numpy.maximum(abs(jump).max(1), LEAST_JUMP * largest)
        width = numpy.cbrt(numpy.finfo(float).eps) * numpy.where(size > 0.0, size, 1.0)
        slopes = numpy.empty((len(jump), 3, 3))
        for j in range(3):
            before, after = jump.copy(), jump.copy()
            before[:, j] -= width
            after[:, j] += width
            slopes[:, :, j] = (self.traction(after) - self.traction(before)) / (after[:, j] - before[:, j])[:, None]
        return slopes


def _newton(lines: _Lines) -> tuple[Floats, Mask]:
    """Tractions, and which points are met."""
    jump = numpy.zeros_like(lines.free_jump)
    traction = lines.traction(jump)
    rest, size, terms = lines.residual(jump, traction)
    for _ in range(ITERATIONS):
        met = size <= ROUND_OFF * terms
        if met.all():
            break
        matrix = numpy.eye(3) + lines.compliance[:, :, None] * lines.slopes(jump, traction)
        usable = numpy.isfinite(matrix).all(axis=(1, 2)) & numpy.isfinite(rest).all(axis=1)
        matrix[~usable] = numpy.eye(3)
        usable &= abs(numpy.linalg.det(matrix)) > 0.0
        matrix[~usable] = numpy.eye(3)
        move = numpy.linalg.solve(matrix, rest[:, :, None])[:, :, 0]
        waiting = usable & ~met
        part = 1.0
        for _halving in range(HALVINGS):
            trial = numpy.where(waiting[:, None], jump - part * move, jump)
            there = lines.traction(trial)
            new_rest, new_size, new_terms = lines.residual(trial, there)
            better = waiting & ((new_size < (1.0 - LEAST_DECREASE * part) * size) | (new_size <= ROUND_OFF * new_terms))
            jump[better], traction[better], rest[better] = trial[better], there[better], new_rest[better]
            size[better], terms[better] = new_size[better], new_terms[better]
            waiting &= ~better
            if not waiting.any():
                break
            part *= 0.5
        if not (usable & ~met & ~waiting).any():
            break
    return traction, size <= SMALL * terms


def _in_turn(lines: _Lines, known: Floats, met: Mask) -> tuple[Floats, Mask]:
    """The tractions of points that are not met, component by component."""
    jump = numpy.where(met[:, None], lines.free_jump - lines.compliance * known, 0.0)
    found, met = known.copy(), met.copy()
    open_points = ~met
    for _ in range(ROUNDS):
        latest = numpy.zeros_like(found)
        failed = numpy.zeros(len(found), dtype=bool)
        for c in range(3):
            latest[:, c], broken = _bracketed(lines, jump, c)
            failed |= broken
            jump[:, c] = lines.free_jump[:, c] - lines.compliance[:, 0] * latest[:, c]
        # The graph may jump where it is met: what counts is that the components no longer move each other.
        change = abs(latest - found).sum(1)
        found[open_points] = latest[open_points]
        settled = open_points & ~failed & (change <= SMALL * abs(latest).sum(1))
        met |= settled
        open_points &= ~(settled | failed)
        if not open_points.any():
            break
    return found, met


def _bracketed(lines: _Lines, jump: Floats, c: int) -> tuple[Floats, Mask]:
    """Component c of the tractions at which it meets its line, the others given, and which have none."""
    free, compliance = lines.free_jump[:, c], lines.compliance[:, 0]

    def at(value: Floats) -> tuple[Floats, Floats]:
        trial = jump.copy()
        trial[:, c] = value
        traction = lines.traction(trial)[:, c]
        return traction, value + compliance * traction - free

    first = jump[:, c].copy()
    t_first, g_first = at(first)
    second = first - g_first
    t_second, g_second = at(second)
    low, high = numpy.minimum(first, second), numpy.maximum(first, second)
    is_first_low = first <= second
    t_low, t_high = numpy.where(is_first_low, t_first, t_second), numpy.where(is_first_low, t_second, t_first)
    g_low, g_high = numpy.where(is_first_low, g_first, g_second), numpy.where(is_first_low, g_second, g_first)
    slack = SMALL * (abs(low) + abs(high) + abs(free))
    broken = ~((g_low <= slack) & (g_high >= -slack))  # also where one is no number
    for k in range(BISECTIONS):
        width = high - low
        if not (width > numpy.finfo(float).eps * (abs(low) + abs(high))).any():
            break
        middle = 0.5 * (low + high)
        if k % 3 != 2:  # the chord meets straight lines at once, a bisection now and then bounds the number of steps
            chord = low - g_low * width / numpy.where(g_high != g_low, g_high - g_low, 1.0)
            middle = numpy.where((chord > low) & (chord < high), chord, middle)
        t, g = at(middle)
        broken |= ~numpy.isfinite(g)
        is_low = g <= 0.0
        low, t_low, g_low = (numpy.where(is_low, new, old) for new, old in ((middle, low), (t, t_low), (g, g_low)))
        is_high = g >= 0.0
        high, t_high, g_high = (numpy.where(is_high, new, old) for new, old in ((middle, high), (t, t_high), (g, g_high)))
    # Where the graph is vertical, any traction between its ends.
    traction = (free - 0.5 * (low + high)) / compliance
    return numpy.clip(traction, numpy.minimum(t_low, t_high), numpy.maximum(t_low, t_high)), broken
