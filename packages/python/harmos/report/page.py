"""The page of a report: its sections and what they draw.

Works for any number of parameters and responses. On a grid the last two parameters span the pictures; other designs
are shown point by point.
"""
import html
import itertools

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.colors import ListedColormap

from harmos.arrays import Floats
from harmos.report import stochastic
from harmos.report.maps import Grid, maps, scatter, surface
from harmos.report.sensitivities import sensitivity_section
from harmos.report.writing import STYLE, Pictures, label, number, table
from harmos.results import Study

STATUS_COLOURS = {"certified": "#1b7837", "certified, not unique": "#5aae61", "calibrated": "#7fbf7b",
                  "calibrated, not unique": "#a6dba0", "reopened": "#fee08b", "not converged": "#fdae61",
                  "no equilibrium": "#2c7bb6", "failed": "#d7191c", "inadmissible": "#888888", "open": "#eeeeee"}
"""All statuses that a configuration can have, and how they are drawn."""
MOST_ROWS = 200
"""Rows of a table, or curves in a picture, at most."""


def response_section(study: Study, grid: Grid, is_grid: bool, picture: Pictures) -> str:
    """Pictures of the responses over the parameters, and how well their surfaces fit."""
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
            "<code>study.surrogate()</code>. Errors: every configuration against the surface of all others, relative "
            "to the range of the response.</p>")
    return "".join(parts) or '<p class="note">The study reports no responses.</p>'


def span(values: Floats) -> float:
    """The range of a response; 1 if it has none."""
    width = float(numpy.nanmax(values) - numpy.nanmin(values))
    return width if width > 0 else 1.0


def curve_section(study: Study, grid: Grid, is_grid: bool, abscissa: str, picture: Pictures) -> str:
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


def effort_section(study: Study, grid: Grid, is_grid: bool, picture: Pictures) -> str:
    """Iterations and status of the configurations."""
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


def failure_section(study: Study) -> str:
    """The configurations without a solution, with their reasons."""
    bad = numpy.flatnonzero(~study.solved & (study.status != "open"))
    if len(bad) == 0:
        return "<p>None.</p>"
    rows = [[study.id[i]] + [number(values[i]) for values in study.parameters.values()] +
            [study.status[i], study.reason[i]] for i in bad[:MOST_ROWS]]
    names = list(study.parameters)
    note = f'<p class="note">The first {MOST_ROWS} of {len(bad)}.</p>' if len(bad) > MOST_ROWS else ""
    return note + table(["id"] + [label(study, name) for name in names] + ["status", "reason"], rows,
                        (len(names) + 1, len(names) + 2))


def overview(study: Study) -> str:
    """What the study is and what came of it, and its parameters."""
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


def page(study: Study, abscissa: str, picture: Pictures) -> str:
    """The whole page as HTML; curves are drawn against the curve `abscissa`, if it is not empty, else against time."""
    grid = Grid(study)
    is_grid = grid.fits(len(study.id))
    title = study.title or study.name
    sections = stochastic.sections(study, study.statistics, picture) if study.statistics else []
    if len(study.id) and (not study.statistics or study.statistics.is_sample):
        sections.append(("Response surfaces", response_section(study, grid, is_grid, picture)))
    if len(study.id):
        sections.append(("Curves", curve_section(study, grid, is_grid, abscissa, picture)))
        if not study.statistics:
            sections.append(("Sensitivities", sensitivity_section(study, picture)))
        sections += [("Effort", effort_section(study, grid, is_grid, picture)), ("Failures", failure_section(study))]
    sections.append(("Input", "".join(f"<details><summary>{name}</summary><pre>{html.escape(text)}</pre></details>"
                                      for name, text in (("study", study.study_input), ("scene", study.scene_input)))))
    body = "".join(f"<h2>{name}</h2>{content}" for name, content in sections)
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f"<style>{STYLE}</style></head><body><h1>{html.escape(title)}</h1>{overview(study)}{body}</body></html>\n")
