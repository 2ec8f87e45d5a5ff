"""How much each parameter of a study changes its responses: mean effects, and derivatives from a quadratic fit."""
import html
from typing import NamedTuple

import matplotlib.pyplot as pyplot
import numpy

from harmos.arrays import Floats
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


def main_effects(study: Study, name: str, values: Floats) -> tuple[Floats, Floats, float]:
    """How a response, [configuration], follows one parameter on the average over all others.

    Returns:
        Levels (or ten classes) of the parameter, the mean response of each, and the share of the variance they explain;
        NaN where there is none.
    """
    x = study.parameters[name]
    levels = numpy.unique(x)
    if len(levels) > 20:
        edges = numpy.quantile(x, numpy.linspace(0, 1, 11))
        place = numpy.clip(numpy.searchsorted(edges, x, side="right") - 1, 0, 9)
        levels = numpy.array([x[place == i].mean() for i in range(10) if (place == i).any()])
        place = numpy.unique(place, return_inverse=True)[1]
    else:
        place = numpy.searchsorted(levels, x)
    known = ~numpy.isnan(values)
    means = numpy.array([values[known & (place == i)].mean() if (known & (place == i)).any() else numpy.nan
                         for i in range(len(levels))])
    total = values[known].var()
    between = ((means[place[known]] - values[known].mean()) ** 2).mean()
    return levels, means, between / total if total > 0 else numpy.nan


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
        shares = []
        for axis, name in zip(axes[0], names):
            levels, means, share = main_effects(study, name, values)
            shares.append(share)
            axis.plot(levels, means, "o-", color="#31688e")
            axis.set_xlabel(label(study, name))
            axis.grid(alpha=0.3)
        axes[0, 0].set_ylabel(f"mean {response}")
        points = study.points(names)[known]
        fit = quadratic_fit(points, values[known])
        rows = []
        for i, name in enumerate(names):
            low, high = points[:, i].min(), points[:, i].max()
            row = [label(study, name), number(low), number(high), f"{100 * shares[i]:.1f} %"]
            if fit:
                half = (high - low) / 2
                row += [f"{fit.derivatives[i] / half:.4g} ± {fit.errors[i] / half:.2g}",
                        f"{2 * fit.derivatives[i]:.4g}"]
            rows.append(row)
        header = ["parameter", "from", "to", "share of variance"]
        header += [f"d {response} / d parameter", f"change of {response} over the range"] if fit else []
        parts.append(f"<h3>{html.escape(response)}</h3>" + picture(figure, f"{response}_effects") + table(header, rows))
        if fit:
            parts.append(f'<p class="note">Derivatives at the middle of the box, from a quadratic fit by least squares '
                         f"that explains {100 * fit.share:.2f} % of the variance. Share of variance: of the mean over "
                         f"all other parameters (first order); the rest is interaction.</p>")
    return "".join(parts) or '<p class="note">The study reports no responses.</p>'
