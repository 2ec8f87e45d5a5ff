"""Where a sequence of answers on finer and finer levels goes to, and how well that is known."""
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy

from harmos.arrays import Floats

ORDERS = (0.4, 4.5)
"""Orders of convergence that are believed, least and largest: quadratic elements have 4 at the best, and a step that is small by chance
looks like more."""
EQUAL_RATIOS = 0.02
"""Relative difference of two ratios of sizes that count as equal."""
LEAST_DOUBT = 0.2
"""Uncertainty of an extrapolation, at least, over the distance that it has been carried."""


@dataclass
class Limit:
    """The limit of a sequence, each for every value.

    Attributes:
        values: the limit, or the finest level where none is claimed, [value].
        uncertainty: how far the true limit may be from it; inf: unknown, [value].
        orders: of convergence; NaN: no limit is claimed, [value].
        word: how it was found.
    """

    values: Floats
    uncertainty: Floats
    orders: Floats
    word: str


def limit_of(sizes: Sequence[float], values: Sequence[Floats], noise: Floats) -> Limit:
    """The limit of `values` [level][value] as `sizes` [level] go to 0; coarse levels first.

    With three levels whose sizes have one ratio, and whose differences shrink without changing sign at a credible
    order, it is that of Richardson. Its uncertainty is the distance to the finest level; with a fourth level what the last
    one has changed in it, at least LEAST_DOUBT of that distance and at most the larger of it and the last difference, and
    that where the levels before have no limit. Otherwise it is the finest level. Its uncertainty is what the least credible
    order leaves of the last difference where there are two levels only, or the differences grow or shrink slowly; else the
    largest of the last two. The noise comes on top.

    Args:
        sizes: decreasing.
        values: at least one.
        noise: what the values themselves are uncertain by, [value].
    """
    finest = values[-1]
    if len(values) == 1:
        return Limit(finest, numpy.full(finest.shape, numpy.inf), numpy.full(finest.shape, numpy.nan), "one level only")
    parts = [_scalar(sizes, [float(level[i]) for level in values], float(noise[i])) for i in range(len(finest))]
    words = [part[3] for part in parts]
    worst = int(numpy.argmax([part[1] for part in parts]))
    return Limit(numpy.array([part[0] for part in parts]), numpy.array([part[1] for part in parts]),
                 numpy.array([part[2] for part in parts]), words[worst])


def contradiction(limit: Floats, finest: float, sizes: Sequence[float], values: Sequence[Floats]) -> Floats:
    """How far another sequence speaks against a limit that was told by sizes down to `finest`, [value].

    It counts for no less than the distance of every level that is as fine, unless its last two approach the limit with a
    credible order at least: whatever it says of its own limit, one that diverges says nothing else.

    Args:
        limit: of which it is asked.
        finest: least size that told it.
        sizes: of the other sequence, decreasing.
        values: of the other sequence, at least one.
    """
    distances = [abs(level - limit) for level in values]
    against = [distance for size, distance in zip(sizes, distances) if size <= finest * (1 + EQUAL_RATIOS)]
    if not against:
        return numpy.zeros(limit.shape)
    farthest: Floats = numpy.max(against, axis=0)
    if len(distances) == 1:
        return farthest
    approaches = distances[-1] <= (sizes[-1] / sizes[-2]) ** ORDERS[0] * distances[-2]
    return numpy.where(approaches, 0.0, farthest)


def _scalar(sizes: Sequence[float], values: Sequence[float], noise: float) -> tuple[float, float, float, str]:
    last = values[-1]
    steps = [fine - coarse for coarse, fine in zip(values[:-1], values[1:])][-2:]
    floor = max(noise, 1e-12 * abs(last))
    largest = max(abs(step) for step in steps)
    slowest = 1 / ((sizes[-2] / sizes[-1]) ** ORDERS[0] - 1)
    if largest <= floor:  # noise is a bound: what is seen may all the same be a change, with more to come
        return last, floor + slowest * largest, math.nan, "does not change"
    limit, order = _richardson(sizes[-3:], values[-3:])
    if math.isnan(order):
        if len(values) == 2:
            return last, slowest * abs(steps[-1]) + noise, math.nan, "two levels"
        if steps[0] * steps[1] > 0 and abs(steps[1]) >= abs(steps[0]):
            return last, slowest * abs(steps[1]) + noise, math.nan, "does not converge yet"
        if steps[0] * steps[1] > 0:
            fast = abs(steps[1]) < abs(steps[0]) / 2
            return last, (largest if fast else slowest * abs(steps[1])) + noise, math.nan, "the finest, no limit claimed"
        return last, largest + noise, math.nan, "not monotone, difference to the finest"
    carried = abs(limit - last)
    doubt = carried
    if len(values) > 3:
        before, order_before = _richardson(sizes[-4:-1], values[-4:-1])
        moved = math.inf if math.isnan(order_before) else abs(limit - before)
        doubt = max(min(moved, max(carried, abs(steps[1]))), LEAST_DOUBT * carried)
    return limit, doubt + noise, order, f"Richardson, order {order:.1f}"


def _richardson(sizes: Sequence[float], values: Sequence[float]) -> tuple[float, float]:
    """The limit and the order; NaN where they are not credible."""
    if len(values) < 3 or abs(sizes[0] * sizes[2] / sizes[1] ** 2 - 1) > EQUAL_RATIOS:
        return math.nan, math.nan
    first, second = values[1] - values[0], values[2] - values[1]
    if first * second <= 0 or abs(second) >= abs(first):
        return math.nan, math.nan
    order = math.log(first / second) / math.log(sizes[0] / sizes[1])
    if not ORDERS[0] <= order <= ORDERS[1]:
        return math.nan, math.nan
    return values[2] + second / (first / second - 1), order
