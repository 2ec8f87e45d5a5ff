"""The page of a report: its sections and what they draw.

Works for any number of parameters and responses. On a grid the last two parameters span the pictures and the others
are fixed, one picture for each of their combinations (nine at most); other designs are shown point by point.
"""
import html
import itertools

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.colors import ListedColormap
from matplotlib.ticker import MaxNLocator

from harmos.report import stochastic
from harmos.report.writing import STYLE, label, number, picture, table

STATUS_COLOURS = {"certified": "#1b7837", "calibrated": "#7fbf7b", "not converged": "#fdae61",
                  "no equilibrium": "#2c7bb6", "failed": "#d7191c", "inadmissible": "#888888", "open": "#eeeeee"}
MOST_PANELS = 9
MOST_ROWS = 200


class Grid:
    """The free parameters of a study as the axes of a grid, and arrays of results on it."""

    def __init__(self, study):
        self.names = study.free
        self.levels = [numpy.unique(study.parameters[name]) for name in self.names]
        self.shape = tuple(len(levels) for levels in self.levels)
        self.positions = tuple(numpy.searchsorted(levels, study.parameters[name])
                               for name, levels in zip(self.names, self.levels))

    def fits(self, count):
        """Whether the points fill enough of it; points chosen at random have as many levels as points."""
        return bool(self.names) and numpy.prod([float(n) for n in self.shape]) <= 4 * count

    def of(self, values):
        result = numpy.full(self.shape, numpy.nan)
        result[self.positions] = values
        return result


def panels(grid):
    """The combinations of levels of all but the last two parameters: at most nine, evenly spread."""
    every = list(itertools.product(*[range(n) for n in grid.shape[:-2]]))
    chosen = numpy.unique(numpy.linspace(0, len(every) - 1, min(MOST_PANELS, len(every))).round().astype(int))
    return [every[i] for i in chosen]


def maps(study, grid, values, what, **style):
    """One map over the last two parameters for every combination of the others; `what` names the colours, if shown."""
    fixed = panels(grid)
    columns = min(3, len(fixed))
    rows = -(-len(fixed) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(4 * columns + 1, 3.3 * rows + 0.3), squeeze=False,
                                   sharex=True, sharey=True, layout="constrained")
    field = grid.of(values)
    low, high = numpy.nanmin(field), numpy.nanmax(field)
    y_levels, x_levels = grid.levels[-2:]
    contours = style.pop("contours", False) and high > low
    for axis, at in itertools.zip_longest(axes.flat, fixed):
        if at is None:
            axis.set_visible(False)
            continue
        shown = field[at]
        if contours and min(shown.shape) > 1:
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


def surface(study, grid, values, what):
    """The response over the last two parameters as surfaces, for a few combinations of the others."""
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


def scatter(study, names, values, what):
    """The response against every parameter, point by point."""
    figure, axes = pyplot.subplots(1, len(names), figsize=(3.6 * len(names) + 1, 3.2), squeeze=False, sharey=True,
                                   layout="constrained")
    for axis, name in zip(axes[0], names):
        axis.plot(study.parameters[name], values, ".", color="#31688e")
        axis.set_xlabel(label(study, name))
        axis.grid(alpha=0.3)
    axes[0, 0].set_ylabel(what)
    return figure


def response_section(study, grid, is_grid):
    parts = []
    for name, values in study.responses.items():
        if numpy.isnan(values).all():
            continue
        parts.append(f"<h3>{html.escape(name)}</h3>")
        if is_grid and len(grid.names) >= 2:
            parts.append(picture(maps(study, grid, values, name, contours=True), f"{name}_maps"))
            if min(grid.shape[-2:]) > 1:
                parts.append(picture(surface(study, grid, values, name), f"{name}_surfaces"))
        elif study.free:
            parts.append(picture(scatter(study, study.free, values, name), f"{name}_points"))
    if study.surrogate_models:
        rows = [(name, f"{100 * model['mean_left_out_error'] / span(study.responses[name]):.2g} %",
                 f"{100 * model['largest_left_out_error'] / span(study.responses[name]):.2g} %")
                for name, model in study.surrogate_models.items()]
        parts.append("<h3>Surfaces with error bars</h3>" + table(
            ("response", "mean error", "largest error"), rows) +
            '<p class="note">Polynomial and Gaussian process, evaluated by <code>harmos predict</code> and '
            "<code>study.surrogate()</code>. Errors: every configuration against the surface of all others, relative to "
            "the range of the response.</p>")
    return "".join(parts) or '<p class="note">The study reports no responses.</p>'


def span(values):
    """The range of a response; 1 if it has none."""
    width = numpy.nanmax(values) - numpy.nanmin(values)
    return width if width > 0 else 1.0


def curve_section(study, grid, is_grid, abscissa):
    """Curves coloured by the first parameter, the others as near to their middle level as the design has them."""
    if not study.free:
        mask = study.solved
        colour = numpy.zeros(len(study.id))
        note = ""
    else:
        colour = study.parameters[study.free[0]]
        mask = study.solved.copy()
        middle = [(name, levels[len(levels) // 2]) for name, levels in zip(grid.names[1:], grid.levels[1:])]
        if is_grid:
            for name, level in middle:
                mask &= study.parameters[name] == level
        note = ", ".join(f"{name} = {level:g}" for name, level in middle) if is_grid else "all configurations"
    chosen = numpy.flatnonzero(mask)[:MOST_ROWS]
    if len(chosen) == 0:
        return '<p class="note">No configuration is solved.</p>'
    names = [name for name in study.curves if name != abscissa]
    columns = min(2, len(names))
    rows = -(-len(names) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(5.2 * columns, 3.6 * rows), squeeze=False,
                                   layout="constrained")
    norm = pyplot.Normalize(colour.min(), colour.max() if colour.max() > colour.min() else colour.min() + 1)
    for axis, name in itertools.zip_longest(axes.flat, names):
        if name is None:
            axis.set_visible(False)
            continue
        for i in chosen:
            x = study.curves[abscissa][i] if abscissa else study.times
            axis.plot(numpy.r_[0, x], numpy.r_[0, study.curves[name][i]], color=pyplot.cm.viridis(norm(colour[i])),
                      linewidth=1.2)
        axis.set_xlabel(abscissa or "time")
        axis.set_ylabel(name)
        axis.grid(alpha=0.3)
    if study.free:
        figure.colorbar(pyplot.cm.ScalarMappable(norm, "viridis"), ax=axes, label=label(study, study.free[0]))
    return f'<p class="note">{html.escape(note)}</p>' + picture(figure, "curves")


def main_effects(study, name, values):
    """Levels (or ten classes) of a parameter, the mean response of each, and the share of the variance they explain."""
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


def quadratic_fit(points, values):
    """Least squares with all terms up to the second degree, in coordinates from -1 to 1.

    Returns the derivatives at the middle of the box per half range, their standard errors, and the share of the
    variance that the fit explains; None when there are too few points.
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
    return solution[1:n + 1], numpy.sqrt(numpy.diag(covariance))[1:n + 1], share


def sensitivity_section(study):
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
                row += [f"{fit[0][i] / half:.4g} ± {fit[1][i] / half:.2g}", f"{2 * fit[0][i]:.4g}"]
            rows.append(row)
        header = ["parameter", "from", "to", "share of variance"]
        header += [f"d {response} / d parameter", f"change of {response} over the range"] if fit else []
        parts.append(f"<h3>{html.escape(response)}</h3>" + picture(figure, f"{response}_effects") + table(header, rows))
        if fit:
            parts.append(f'<p class="note">Derivatives at the middle of the box, from a quadratic fit by least squares '
                         f"that explains {100 * fit[2]:.2f} % of the variance. Share of variance: of the mean over all "
                         f"other parameters (first order); the rest is interaction.</p>")
    return "".join(parts) or '<p class="note">The study reports no responses.</p>'


def effort_section(study, grid, is_grid):
    statuses = [status for status in STATUS_COLOURS if (study.status == status).any()]
    code = numpy.array([list(STATUS_COLOURS).index(status) for status in study.status], float)
    parts = []
    if is_grid and len(grid.names) >= 2:
        done = numpy.where(study.status == "open", numpy.nan, study.iterations)
        if not numpy.isnan(done).all():
            parts.append("<h3>Iterations</h3>" + picture(maps(study, grid, done, "iterations"), "iterations"))
        colours = ListedColormap(list(STATUS_COLOURS.values()))
        figure = maps(study, grid, code, "", cmap=colours, vmin=-0.5, vmax=len(STATUS_COLOURS) - 0.5)
        legend = ", ".join(f'<span style="color:{STATUS_COLOURS[status]}">&#9632;</span> {status}'
                           for status in statuses)
        parts.append(f"<h3>Status</h3><p>{legend}</p>" + picture(figure, "status"))
    else:
        figure, axis = pyplot.subplots(figsize=(9, 3), layout="constrained")
        for status in statuses:
            mask = study.status == status
            axis.plot(study.id[mask], study.iterations[mask], ".", color=STATUS_COLOURS[status], label=status)
        axis.set_xlabel("configuration")
        axis.set_ylabel("iterations")
        axis.legend()
        parts.append(picture(figure, "effort"))
    return "".join(parts)


def failure_section(study):
    bad = numpy.flatnonzero(~study.solved & (study.status != "open"))
    if len(bad) == 0:
        return "<p>None.</p>"
    rows = [[study.id[i]] + [number(values[i]) for values in study.parameters.values()] +
            [study.status[i], study.reason[i]] for i in bad[:MOST_ROWS]]
    names = list(study.parameters)
    note = f'<p class="note">The first {MOST_ROWS} of {len(bad)}.</p>' if len(bad) > MOST_ROWS else ""
    return note + table(["id"] + [label(study, name) for name in names] + ["status", "reason"], rows,
                        (len(names) + 1, len(names) + 2))


def overview(study):
    done = study.status != "open"
    rows = [("scene", study.scene), ("state", study.state), ("accuracy asked for", f"{study.accuracy:g}"),
            ("configurations", len(study.id))]
    rows += [(status, (study.status == status).sum()) for status in STATUS_COLOURS if (study.status == status).any()]
    rows += [(f"left out by the condition {name}", count) for name, count in study.left_out.items()]
    if study.solved.any():
        rows.append(("largest error estimate", f"{numpy.nanmax(study.error_estimate[study.solved]):.3g}"))
    if done.any():
        rows += [("linear stages per configuration", f"{study.linear_stages[done].mean():.1f}"),
                 ("CPU time", f"{numpy.nansum(study.cpu_seconds[done]):.1f} s"),
                 ("started from another solution", f"{(study.starts[done, 0] != 0).sum()} of {done.sum()}")]
    rows += list(study.notes.items())
    rows += [("written by", f"Harmos {study.version}")]
    parameters = [[label(study, name), number(values.min()) if len(values) else "",
                   number(values.max()) if len(values) else "", len(numpy.unique(values)),
                   study.formulas[name] or ", ".join(study.entries[name]), study.phases[name]]
                  for name, values in study.parameters.items()]
    return table(("", ""), rows, (1,)) + table(
        ("parameter", "from", "to", "values", "sets", "changes"), parameters, (4, 5))


def page(study, abscissa):
    grid = Grid(study)
    is_grid = grid.fits(len(study.id))
    title = study.title or study.name
    sections = stochastic.sections(study) if study.statistics else []
    if len(study.id) and (not study.statistics or study.statistics.is_sample):
        sections.append(("Response surfaces", response_section(study, grid, is_grid)))
    if len(study.id):
        sections.append(("Curves", curve_section(study, grid, is_grid, abscissa)))
        if not study.statistics:
            sections.append(("Sensitivities", sensitivity_section(study)))
        sections += [("Effort", effort_section(study, grid, is_grid)), ("Failures", failure_section(study))]
    sections.append(("Input", "".join(f"<details><summary>{name}</summary><pre>{html.escape(text)}</pre></details>"
                                      for name, text in (("study", study.study_input), ("scene", study.scene_input)))))
    body = "".join(f"<h2>{name}</h2>{content}" for name, content in sections)
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f"<style>{STYLE}</style></head><body><h1>{html.escape(title)}</h1>{overview(study)}{body}</body></html>\n")
