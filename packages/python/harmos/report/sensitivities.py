"""How much each parameter of a study changes its responses: mean effects, and derivatives from a quadratic fit."""
import html
import itertools
import math
from typing import NamedTuple

import matplotlib.pyplot as pyplot
import numpy

from harmos.arrays import Floats, Integers
from harmos.report.writing import Pictures, label, number, table
from harmos.results import Study


class Fit(NamedTuple):
    """What a quadratic fit says of a response.

    Attributes:
        derivatives: at the middle of the box per half range, [parameter]; unit of the response.
        errors: their standard errors, [parameter].
        share: of the variance that the fit explains; NaN: there is none.
    """

    derivatives: Floats
    errors: Floats
    share: float


class Effects(NamedTuple):
    """How a response follows each parameter on the average over all others, and how much of its variance that is.

    Attributes:
        levels: of each parameter: its values, or the means of classes of them.
        means: of the response at these levels, [parameter][level]; NaN: no solution there.
        shares: of the variance, [parameter]; with `rest` they add up to 1. NaN: no variance.
        rest: share of the variance that no sum of functions of one parameter each explains: interaction.
    """

    levels: list[Floats]
    means: list[Floats]
    shares: Floats
    rest: float


MOST_ORDERS = 120
"""Orders of the parameters over which shares are averaged: all of five; of more, as many random ones."""


def classes(x: Floats) -> tuple[Floats, Integers]:
    """Levels of a parameter and the number of its level in every configuration, [c]: its values where each is that of
    two configurations or more on the average, else classes of equal size."""
    levels, place = numpy.unique(x, return_inverse=True)
    if len(levels) <= min(20, len(x) / 2):
        return levels, place
    edges = numpy.quantile(x, numpy.linspace(0, 1, int(numpy.clip(len(x) // 6, 2, 10)) + 1))
    place = numpy.unique(numpy.searchsorted(edges[1:-1], x, side="right"), return_inverse=True)[1]
    return numpy.array([x[place == i].mean() for i in range(place.max() + 1)]), place


def main_effects(study: Study, names: list[str], values: Floats) -> Effects:
    """Effects of parameters on a response, [configuration], from the configurations that have a value.

    The response is fitted by a sum of functions of one parameter each, by least squares. On a complete grid these are the
    means over all other parameters. Where solutions are missing, parameters are no longer independent of each other
    among those that are left: means would show the effect of one as that of another, and their variances would add up to
    more than there is. The share of a parameter is what it adds to the variance that is explained, on the average over
    all orders in which the parameters can be added.
    Source: Lindeman, Merenda, Gold, Introduction to Bivariate and Multivariate Analysis (1980), p. 120.
    """
    known = ~numpy.isnan(values)
    y = values[known] - values[known].mean()
    found = [classes(study.parameters[name]) for name in names]
    columns = [(place[known][:, None] == numpy.arange(len(levels))).astype(float) for levels, place in found]
    columns = [block - block.mean(axis=0) for block in columns]

    def explained(which: tuple[int, ...]) -> float:
        if not which:
            return 0.0
        matrix = numpy.column_stack([columns[i] for i in which])
        return float(((matrix @ numpy.linalg.lstsq(matrix, y, rcond=1e-10)[0]) ** 2).sum())

    solution = numpy.linalg.lstsq(numpy.column_stack(columns), y, rcond=1e-10)[0]
    means, first = [], 0
    for (levels, place), block in zip(found, columns):
        effect = block @ solution[first:first + len(levels)] + values[known].mean()
        means.append(numpy.array([effect[place[known] == i].mean() if (place[known] == i).any() else numpy.nan
                                  for i in range(len(levels))]))
        first += len(levels)
    total = float(y @ y)
    values_of = [each for each, _ in found]
    if not total > 0:
        return Effects(values_of, means, numpy.full(len(names), numpy.nan), numpy.nan)
    every = range(len(names))
    generator = numpy.random.default_rng(1)
    orders = (list(itertools.permutations(every)) if math.factorial(len(names)) <= MOST_ORDERS else
              [tuple(generator.permutation(len(names))) for _ in range(MOST_ORDERS)])
    sums: dict[frozenset[int], float] = {}
    shares = numpy.zeros(len(names))
    for order in orders:
        before = 0.0
        for count, i in enumerate(order, 1):
            subset = frozenset(order[:count])
            if subset not in sums:
                sums[subset] = explained(tuple(sorted(subset)))
            shares[i] += (sums[subset] - before) / total / len(orders)
            before = sums[subset]
    return Effects(values_of, means, shares, 1.0 - float(shares.sum()))


def quadratic_fit(points: Floats, values: Floats) -> Fit | None:
    """Least squares with all terms up to the second degree, in coordinates from -1 to 1.

    Args:
        points: values of the parameters, [point, parameter]; each parameter has two at least.
        values: of the response, [point].

    Returns:
        None when there are too few points.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    x = (2 * points - low - high) / (high - low)
    n = x.shape[1]
    degrees = [len(numpy.unique(points[:, i])) for i in range(n)]
    columns = [numpy.ones(len(x))] + [x[:, i] for i in range(n)]
    columns += [x[:, i] * x[:, j] for i in range(n) for j in range(i, n) if i != j or degrees[i] > 2]
    matrix = numpy.column_stack(columns)
    if len(x) < matrix.shape[1]:
        return None
    solution, _, rank, _ = numpy.linalg.lstsq(matrix, values, rcond=None)
    if rank < matrix.shape[1]:
        return None
    residual = values - matrix @ solution
    freedom = max(len(x) - rank, 1)
    covariance = numpy.linalg.inv(matrix.T @ matrix) * (residual @ residual) / freedom
    total = ((values - values.mean()) ** 2).sum()
    share = 1 - residual @ residual / total if total > 0 else numpy.nan
    return Fit(solution[1:n + 1], numpy.sqrt(numpy.diag(covariance))[1:n + 1], share)


def sensitivity_section(study: Study, picture: Pictures) -> str:
    """Main effects and derivatives of all responses."""
    parts = []
    names = study.free
    if not names:
        return '<p class="note">No parameter changes.</p>'
    for response, values in study.responses.items():
        known = ~numpy.isnan(values)
        if known.sum() < 2:
            continue
        figure, axes = pyplot.subplots(1, len(names), figsize=(3.4 * len(names) + 1, 3), squeeze=False, sharey=True,
                                       layout="constrained")
        effects = main_effects(study, names, values)
        for axis, name, levels, means in zip(axes[0], names, effects.levels, effects.means):
            axis.plot(levels, means, "o-", color="#31688e")
            axis.set_xlabel(label(study, name))
            axis.grid(alpha=0.3)
        axes[0, 0].set_ylabel(f"mean {response}")
        points = study.points(names)[known]
        fit = quadratic_fit(points, values[known])
        rows = []
        for i, name in enumerate(names):
            low, high = points[:, i].min(), points[:, i].max()
            row = [label(study, name), number(low), number(high), f"{100 * effects.shares[i]:.1f} %"]
            if fit:
                half = (high - low) / 2
                row += [f"{fit.derivatives[i] / half:.4g} ± {fit.errors[i] / half:.2g}",
                        f"{2 * fit.derivatives[i]:.4g}"]
            rows.append(row)
        rows.append(["interaction and rest", "", "", f"{100 * effects.rest:.1f} %"] + ["", ""] * bool(fit))
        header = ["parameter", "from", "to", "share of variance"]
        header += [f"d {response} / d parameter", f"change of {response} over the range"] if fit else []
        parts.append(f"<h3>{html.escape(response)}</h3>" + picture(figure, f"{response}_effects") + table(header, rows))
        note = ("Share of variance: what a function of this parameter alone adds to a sum of such functions, on the "
                "average over all orders; the shares and the rest add up to 100 %.")
        if fit:
            note = ("Derivatives at the middle of the box, from a quadratic fit by least squares that explains "
                    f"{100 * fit.share:.2f} % of the variance. " + note)
        parts.append(f'<p class="note">{note}</p>')
    return missing_note(study) + "".join(parts) if parts else '<p class="note">The study reports no responses.</p>'


def missing_note(study: Study) -> str:
    """A warning that names what has no solution, and where that is; empty when everything has one."""
    missing = ~study.solved
    if not missing.any():
        return ""
    statuses = ", ".join(f"{(study.status == status).sum()} {status}" for status in numpy.unique(study.status[missing]))
    places = []
    for name in study.free:
        levels, place = classes(study.parameters[name])
        counts = [(int((missing & (place == i)).sum()), int((place == i).sum()), level)
                  for i, level in enumerate(levels)]
        lost, all_of_it, level = max(counts, key=lambda each: each[0] / each[1])
        places.append(f"{lost} of {all_of_it} at {label(study, name)} = {number(level)}")
    return (f'<p class="warning"><b>{missing.sum()} of {len(missing)} configurations have no solution</b> '
            f"({html.escape(statuses)}) and are missing here, most of them at: {html.escape('; '.join(places))}. Effects, "
            "shares and derivatives are those of the others, and say nothing of where these are.</p>")
