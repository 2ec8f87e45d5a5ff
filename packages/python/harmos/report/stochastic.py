"""The sections of a report on a study with random parameters."""
import html

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from harmos.arrays import Floats, Integers
from harmos.report.writing import Pictures, number, panel_grid, percent, table
from harmos.results import Study
from harmos.stochastic import ResponseStatistics, Statistics, Sweep

BLUE = "#31688e"
"""Colour of all lines."""


def drawn(statistics: Statistics) -> list[str]:
    """Responses that vary."""
    return [name for name, each in statistics.responses.items()
            if each.standard_deviation > 0 and not numpy.isnan(each.skewness)]


def errors(response: ResponseStatistics) -> str:
    """What is known of the errors of a response, for the title of a picture."""
    parts = [f"{what} {percent(value)}" for what, value in (("hold-out", response.hold_out_error),
                                                             ("last degree", response.truncation))
             if not numpy.isnan(value)]
    if not parts and response.standard_deviation_error > 0:
        parts = [f"error of the std {percent(response.standard_deviation_error / response.standard_deviation)}"]
    return ", ".join(parts)


def curves(study: Study, statistics: Statistics, which: str, ylabel: str) -> Figure:
    """A panel with a curve of probability, "density" or "cumulative", for every response that varies."""
    names = drawn(statistics)
    figure, axes = panel_grid(len(names))
    for axis, name in zip(axes, names):
        response = statistics.responses[name]
        if which == "density" and statistics.is_sample:
            values = study.responses[name][study.solved]
            axis.hist(values, bins="auto", density=True, color="#c6dbef", edgecolor="white", linewidth=0.4)
        axis.plot(response.values, getattr(response, which), color=BLUE)
        axis.axvline(response.mean, color="#888", linewidth=0.8, linestyle="--")
        axis.set_xlabel(name)
        axis.set_ylabel(ylabel)
        axis.set_ylim(bottom=0)
        axis.xaxis.set_major_locator(MaxNLocator(6))
        axis.set_title(errors(response), fontsize=8, color="#555")
        axis.grid(alpha=0.3)
    return figure


def density_section(study: Study, statistics: Statistics, picture: Pictures) -> str:
    """Densities and distributions of the responses."""
    if not drawn(statistics):
        return '<p class="note">No response varies.</p>'
    how = ("Bars: histogram of the configurations; line: kernel estimate." if statistics.is_sample else
           "From samples of the expansions or the interpolation; nothing was solved for them.")
    return (picture(curves(study, statistics, "density", "probability density"), "densities") +
            picture(curves(study, statistics, "cumulative", "probability"), "cumulative") +
            f'<p class="note">{how} Dashed: mean. Above each picture: hold-out error (root mean square at random '
            "configurations solved besides, over the standard deviation), variance share of the last degree.</p>")


def moment_section(statistics: Statistics) -> str:
    """Moments and quantiles of the responses, with their errors."""
    rows = []
    for name, each in statistics.responses.items():
        rows.append([name] + [number(value, "n/a") for value in (each.mean, each.standard_deviation, each.skewness,
                                                                 each.kurtosis)] +
                    [number(value) for value in (each.mean_error, each.standard_deviation_error)] +
                    [percent(each.truncation), percent(each.hold_out_error)])
    moments = table(["response", "mean", "std", "skewness", "kurtosis", "error of mean", "error of std", "last degree",
                     "hold-out"], rows)
    note = ('<p class="note">Kurtosis of a normal response: 3. Errors of mean and std: '
            + ("standard errors of the sample" if statistics.is_sample else
               "estimates of the whole error, of the iteration, truncation and quadrature (last degree: share of the "
               "variance; hold-out: root mean square error over the std)") + ".</p>")
    quantiles = table(["response"] + [f"{level:g}" for level in statistics.levels],
                      [[name] + [number(value) for value in each.quantiles]
                       for name, each in statistics.responses.items()])
    return moments + note + "<h3>Quantiles</h3>" + quantiles


def sobol_section(statistics: Statistics, picture: Pictures) -> str:
    """Shares of the parameters in the variance of the responses."""
    shown = [name for name in drawn(statistics) if statistics.responses[name].sobol]
    if not shown:
        return '<p class="note">There are no indices.</p>'
    figure, axis = pyplot.subplots(figsize=(7, 0.5 + 0.55 * len(shown)), layout="constrained")
    colours = pyplot.cm.viridis(numpy.linspace(0.1, 0.9, len(statistics.variables)))
    rows = []
    for place, name in enumerate(shown):
        sobol = statistics.responses[name].sobol
        left = 0.0
        for variable, colour in zip(statistics.variables, colours):
            main, total = sobol.get(variable, (0.0, 0.0))
            axis.barh(place, main, left=left, color=colour, label=variable if place == 0 else None)
            left += main
        if left < 1:
            axis.barh(place, 1 - left, left=left, color="#bbb", label="interaction" if place == 0 else None)
        rows += [[name, variables, number(main), number(total)] for variables, (main, total) in sobol.items()]
    axis.set_yticks(range(len(shown)), shown)
    axis.invert_yaxis()
    axis.set_xlim(0, 1)
    axis.set_xlabel("share of the variance")
    axis.legend(loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    note = "" if statistics.independent else (
        '<p class="note">The parameters are correlated: the shares are those of the independent germs, the first of '
        "which is the first parameter's own.</p>")
    return picture(figure, "sobol") + note + table(["response", "variables", "main", "total"], rows, (1,))


def coefficient_section(statistics: Statistics) -> str:
    """Coefficients of all expansions."""
    basis = statistics.basis
    if basis is None:
        return '<p class="note">There are no expansions.</p>'
    known = {name: each.coefficients for name, each in statistics.responses.items()
             if each.coefficients is not None}
    rows = [[" ".join(map(str, degrees))] + [f"{coefficients[a]:.6e}" for coefficients in known.values()]
            for a, degrees in enumerate(basis.degrees)]
    return (f'<p class="note">Order {basis.order}, {len(basis.degrees)} orthonormal polynomials; degrees in '
            f'{html.escape(", ".join(basis.germs))}, graded lexicographic.</p>' +
            table(["degrees"] + list(known), rows))


def running_deviations(values: Floats) -> tuple[Integers, Floats]:
    """About a hundred numbers n up to that of the values, and the standard deviation of the first n values."""
    counts = numpy.unique(numpy.geomspace(2, len(values), 100).astype(int))
    return counts, numpy.array([values[:n].std(ddof=1) for n in counts])


def convergence_section(study: Study, statistics: Statistics, picture: Pictures) -> str:
    """Standard deviations of the responses over the number of configurations or over the order."""
    names = drawn(statistics)
    if not names or (statistics.convergence is None and not statistics.is_sample):
        return '<p class="note">Nothing to show.</p>'
    figure, axes = panel_grid(len(names))
    for axis, name in zip(axes, names):
        if statistics.is_sample:
            counts, deviations = running_deviations(study.responses[name][study.solved])
            axis.semilogx(counts, deviations, color=BLUE)
            axis.set_xlabel("configurations")
        elif statistics.convergence is not None:
            axis.plot(statistics.convergence.size, statistics.convergence.standard_deviation[name], "o-", color=BLUE)
            axis.xaxis.set_major_locator(MaxNLocator(integer=True))
            axis.set_xlabel("order")
        axis.set_ylabel(f"std of {name}")
        axis.grid(alpha=0.3)
    return picture(figure, "convergence")


def sweep_section(sweep: Sweep, picture: Pictures) -> str:
    """Mean and standard deviation over coefficients of variation: the last two as axes, the others at their largest."""
    parts = []
    names = sweep.names[-2:]
    mask = (sweep.coefficients[:, :-2] == sweep.coefficients[:, :-2].max(axis=0, initial=-1)).all(axis=1)
    axes_values = [numpy.unique(column) for column in sweep.coefficients[:, -len(names):].T]
    shape = [len(values) for values in axes_values]
    if numpy.prod(shape) != mask.sum():
        return '<p class="note">The sweep is not complete.</p>'
    for response in sweep.mean:
        fields = [("mean", sweep.mean[response][mask]), ("std", sweep.standard_deviation[response][mask])]
        is_surface = len(names) == 2 and min(shape) > 1
        figure = pyplot.figure(figsize=(9.5, 3.9), layout="constrained")
        for place, (what, values) in enumerate(fields, 1):
            if is_surface:
                axis = figure.add_subplot(1, 2, place, projection="3d")
                y, x = numpy.meshgrid(*axes_values, indexing="ij")
                axis.plot_surface(x, y, values.reshape(shape), cmap="viridis", rstride=1, cstride=1)
                axis.set_ylabel(names[0])
                axis.set_title(f"{what} of {response}")
            else:
                axis = figure.add_subplot(1, 2, place)
                longest = int(numpy.argmax(shape))
                lines = numpy.moveaxis(values.reshape(shape), longest, 0)
                axis.plot(axes_values[longest], lines.reshape(len(lines), -1), "o-")
                axis.set_ylabel(f"{what} of {response}")
                axis.grid(alpha=0.3)
            axis.set_xlabel(names[-1] if is_surface else names[longest])
        parts.append(picture(figure, f"{response}_sweep"))
    return ("".join(parts) +
            f'<p class="note">Over the coefficients of variation {html.escape(", ".join(sweep.names))}.</p>')


def parameter_table(statistics: Statistics) -> str:
    """How the study was solved, and its random parameters."""
    rows = [[sentence] for sentence in statistics.distributions]
    text = f"<p>{html.escape(statistics.method)}</p>" + table(["random parameters"], rows)
    text += "".join(f'<p class="warning"><b>Warning:</b> {html.escape(warning)}.</p>' for warning in statistics.warnings)
    if statistics.inadmissible:
        text += (f"<p><b>{statistics.inadmissible} draws</b> have values that the scene refuses; they were not solved "
                 "and are left out of all figures.</p>")
    return text


def sections(study: Study, statistics: Statistics, picture: Pictures) -> list[tuple[str, str]]:
    """Names and contents."""
    result = [("Random parameters", parameter_table(statistics)),
              ("Densities", density_section(study, statistics, picture)), ("Moments", moment_section(statistics)),
              ("Sobol' indices", sobol_section(statistics, picture)), ("Expansions", coefficient_section(statistics)),
              ("Convergence", convergence_section(study, statistics, picture))]
    if statistics.sweep is not None:
        result.append(("Sweep", sweep_section(statistics.sweep, picture)))
    return result
