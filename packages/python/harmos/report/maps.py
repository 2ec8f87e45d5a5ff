"""Pictures of numbers over the parameters of a study: maps and surfaces on a grid, points elsewhere.

On a grid the last two parameters span the pictures and the others are fixed, one picture for each of their
combinations (nine at most).
"""
import itertools
from collections.abc import Sequence
from typing import Any

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from harmos.arrays import Floats
from harmos.report.writing import label
from harmos.results import Study

MOST_PANELS = 9
"""Pictures of one response at most."""


class Grid:
    """The free parameters of a study as the axes of a grid, and arrays of results on it.

    Attributes:
        names: of the parameters.
        levels: the different values of each parameter, in rising order.
        shape: how many these are.
        positions: of the configurations in the levels of each parameter, [configuration] each.
    """

    def __init__(self, study: Study) -> None:
        """Finds the levels of a study of any design; fits() says whether they make a grid."""
        self.names = study.free
        self.levels: list[Floats] = [numpy.unique(study.parameters[name]) for name in self.names]
        self.shape = tuple(len(levels) for levels in self.levels)
        self.positions = tuple(numpy.searchsorted(levels, study.parameters[name])
                               for name, levels in zip(self.names, self.levels))

    def fits(self, count: int) -> bool:
        """Whether the points fill enough of it; points chosen at random have as many levels as points."""
        return bool(self.names) and bool(numpy.prod([float(n) for n in self.shape]) <= 4 * count)

    def of(self, values: ArrayLike) -> Floats:
        """Values of the configurations, [configuration], on the grid; NaN where there is none."""
        result = numpy.full(self.shape, numpy.nan)
        result[self.positions] = values
        return result


def panels(grid: Grid) -> list[tuple[int, ...]]:
    """The combinations of levels of all but the last two parameters: at most nine, evenly spread."""
    every = list(itertools.product(*[range(n) for n in grid.shape[:-2]]))
    chosen = numpy.unique(numpy.linspace(0, len(every) - 1, min(MOST_PANELS, len(every))).round().astype(int))
    return [every[i] for i in chosen]


def maps(study: Study, grid: Grid, values: ArrayLike, what: str, contours: bool = False, **style: Any) -> Figure:
    """One map over the last two parameters for every combination of the others.

    Args:
        study: whose parameters are the axes.
        grid: of the study, with two parameters at least.
        values: of the configurations, [configuration].
        what: name of the colours; empty: no colour bar.
        contours: whether to draw contours instead of cells.
        style: further arguments of pyplot's pcolormesh.
    """
    fixed = panels(grid)
    columns = min(3, len(fixed))
    rows = -(-len(fixed) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(4 * columns + 1, 3.3 * rows + 0.3), squeeze=False,
                                   sharex=True, sharey=True, layout="constrained")
    field = grid.of(values)
    low, high = numpy.nanmin(field), numpy.nanmax(field)
    y_levels, x_levels = grid.levels[-2:]
    for axis, at in itertools.zip_longest(axes.flat, fixed):
        if at is None:
            axis.set_visible(False)
            continue
        shown = field[at]
        if contours and high > low and min(shown.shape) > 1:
            levels = MaxNLocator(20).tick_values(low, high)
            drawn = axis.contourf(x_levels, y_levels, shown, levels=levels, cmap="viridis")
            axis.contour(x_levels, y_levels, shown, levels=levels[::2], colors="white", linewidths=0.5)
        else:
            drawn = axis.pcolormesh(x_levels, y_levels, shown, shading="nearest",
                                    **{"vmin": low, "vmax": high, "cmap": "viridis", **style})
        axis.set_title(", ".join(f"{name} = {levels[i]:g}" for name, levels, i in zip(grid.names, grid.levels, at)),
                       fontsize=10)
    for axis in axes[-1]:
        axis.set_xlabel(label(study, grid.names[-1]))
    for axis in axes[:, 0]:
        axis.set_ylabel(label(study, grid.names[-2]))
    if what:
        figure.colorbar(drawn, ax=axes, label=what)
    return figure


def surface(study: Study, grid: Grid, values: ArrayLike, what: str) -> Figure:
    """The response, [configuration], over the last two parameters as surfaces, for a few combinations of the others."""
    fixed = panels(grid)
    fixed = [fixed[i] for i in sorted({0, len(fixed) // 2, len(fixed) - 1})]
    figure = pyplot.figure(figsize=(4.6 * len(fixed), 4.2), layout="constrained")
    field = grid.of(values)
    y, x = numpy.meshgrid(*grid.levels[-2:], indexing="ij")
    for i, at in enumerate(fixed):
        axis = figure.add_subplot(1, len(fixed), i + 1, projection="3d")
        axis.plot_surface(x, y, field[at], cmap="viridis", vmin=numpy.nanmin(field), vmax=numpy.nanmax(field))
        axis.set_zlim(0 if numpy.nanmin(field) >= 0 else numpy.nanmin(field), numpy.nanmax(field))
        axis.set_xlabel(label(study, grid.names[-1]))
        axis.set_ylabel(label(study, grid.names[-2]))
        axis.set_title(", ".join(f"{name} = {levels[k]:g}" for name, levels, k in zip(grid.names, grid.levels, at)))
        if i == len(fixed) - 1:
            axis.set_zlabel(what)
    return figure


def scatter(study: Study, names: Sequence[str], values: Floats, what: str) -> Figure:
    """The response, [configuration], against every parameter, point by point."""
    figure, axes = pyplot.subplots(1, len(names), figsize=(3.6 * len(names) + 1, 3.2), squeeze=False, sharey=True,
                                   layout="constrained")
    for axis, name in zip(axes[0], names):
        axis.plot(study.parameters[name], values, ".", color="#31688e")
        axis.set_xlabel(label(study, name))
        axis.grid(alpha=0.3)
    axes[0, 0].set_ylabel(what)
    return figure
