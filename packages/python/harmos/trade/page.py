"""The page of a trade: what it has come to, the pictures, all rungs."""
import html

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
from matplotlib.axes import Axes

from harmos.report.writing import STYLE, Pictures, panel_grid, percent, table
from harmos.trade.judging import Judge
from harmos.trade.ladder import Ladder, Rung
from harmos.trade.promises import Promise
from harmos.trade.tables import estimate, part_names, pareto

MOST_PANELS = 12
"""Responses that are drawn, at most."""
FEW = 100.0
"""Span of costs below which ticks between powers of ten are named, too."""
MEGABYTE = 1e6
"""Bytes."""


def page(title: str, ladder: Ladder, judge: Judge, rungs: list[Rung], promises: list[Promise], picture: Pictures) -> str:
    """The whole page as HTML."""
    sections = [("Settings that keep a promise", promise_table(ladder, promises)),
                ("References", reference_table(judge)),
                ("Error against cost", error_pictures(ladder, judge, rungs, picture)),
                ("Pareto set", pareto_section(ladder, judge, rungs, picture)),
                ("All rungs", rung_table(ladder, judge, rungs))]
    body = "".join(f"<h2>{name}</h2>{content}" for name, content in sections)
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f"<style>{STYLE}</style></head><body><h1>{html.escape(title)}</h1>{body}</body></html>\n")


def promise_table(ladder: Ladder, promises: list[Promise]) -> str:
    """What each target costs, as a fresh run has shown."""
    rows = [(percent(one.target), percent(one.error), f"{one.rung.outcome.cpu:.2f}",
             f"{one.rung.outcome.memory / MEGABYTE:.0f}", ladder.words(one.rung.settings), str(one.files[0]))
            if one.rung is not None else (percent(one.target), "none", "", "", one.reason, "") for one in promises]
    return table(("target", "error at most", "CPU s", "memory MB", "settings", "file"), rows, (4, 5)) + (
        '<p class="note">Largest relative error of any response: distance of a fresh run from the reference, the '
        "uncertainty of that added.</p>")


def reference_table(judge: Judge) -> str:
    """What each response goes to, and how that is known."""
    rows = [(name, f"{one.largest():.7g}", f"{one.size:.5g}", percent(one.doubt()), one.space.word)
            for name, one in judge.references.items()]
    return table(("response", "goes to (largest value)", "errors are relative to", "uncertainty", "limit of the meshes"), rows, (4,))


def error_pictures(ladder: Ladder, judge: Judge, rungs: list[Rung], picture: Pictures) -> str:
    """Error of every response over CPU time and memory, a line for each family of meshes."""
    names = list(judge.references)[:MOST_PANELS]
    if not names:
        return '<p class="warning">Nothing is certified: there is no reference.</p>'
    parts = []
    for cost, label, unit in (("cpu", "CPU time [s]", 1.0), ("memory", "memory [MB]", MEGABYTE)):
        figure, axes = panel_grid(len(names))
        for name, axis in zip(names, axes):
            draw_errors(axis, ladder, judge, rungs, name, cost, unit)
            axis.set_xlabel(label)
            axis.set_ylabel("relative error")
        axes[0].legend(fontsize=7)
        parts.append(picture(figure, f"error_{cost}"))
    return "".join(parts) + ('<p class="note">Lines: meshes of one family, at one accuracy and the load steps as given. '
                             "Grey: below this the reference is not known. Crosses: not certified.</p>")


def draw_errors(axis: Axes, ladder: Ladder, judge: Judge, rungs: list[Rung], name: str, cost: str, unit: float) -> None:
    """Errors of one response over a cost, each in units of `unit`."""
    floor = 1e-12
    for family in ladder.families():
        points = [(getattr(rung.outcome, cost) / unit, max(judge.total(rung)[name], floor)) for rung in ladder.meshes(family)]
        label = ", ".join(ladder.knobs[i].levels[family[i]].name for i in range(len(family))
                          if ladder.knobs[i].role.value == "family")
        axis.plot(*zip(*points), "o-", label=label) if points else None
    in_lines = {rung.settings for family in ladder.families() for rung in ladder.meshes(family)}
    for certified, mark in ((True, "."), (False, "x")):
        points = [(getattr(rung.outcome, cost) / unit, max(judge.total(rung)[name], floor)) for rung in rungs
                  if rung.settings not in in_lines and rung.outcome.certified == certified and name in rung.outcome.values]
        if points:
            axis.plot(*zip(*points), mark, color="0.4")
    axis.axhspan(floor / 10, max(judge.references[name].doubt(), floor), color="0.9")
    drawn = [value for line in axis.lines for value in line.get_ydata() if value > 10 * floor]
    axis.set(xscale="log", yscale="log", ylim=(min(drawn, default=1e-6) / 3, 2 * max(drawn, default=1.0)), title=name)
    axis.xaxis.set_major_formatter("{x:g}")
    left, right = axis.get_xlim()
    if right < FEW * left:  # of little more than a decade one tick would be named
        axis.xaxis.set_minor_formatter(lambda value, _: f"{value:g}" if f"{value:.0e}"[0] in "25" else "")
    axis.grid(alpha=0.3)


def pareto_section(ladder: Ladder, judge: Judge, rungs: list[Rung], picture: Pictures) -> str:
    """The rungs that none beats in error and CPU time, with the parts of their errors in the worst response."""
    chosen = pareto(rungs, judge, "cpu")
    if not chosen:
        return ""
    names = part_names(ladder)
    heights: dict[str, list[float]] = {part: [] for part in names}
    rows = []
    for rung in chosen:
        total = judge.total(rung)
        response = max(total, key=lambda name: total[name])
        parts = judge.parts(rung.settings, response)
        for part in names:
            heights[part].append(parts[part])
        rows.append([percent(judge.worst(rung)), percent(judge.promised(rung)), response, *(percent(parts[part]) for part in names),
                     percent(estimate(rung, judge, response)), f"{rung.outcome.cpu:.2f}",
                     f"{rung.outcome.memory / MEGABYTE:.0f}", ladder.words(rung.settings)])
    figure, axis = pyplot.subplots(figsize=(9, 3.5), layout="constrained")
    width = 0.8 / len(names)
    for k, part in enumerate(names):
        axis.bar([i + k * width for i in range(len(chosen))], heights[part], width, label=part)
    axis.set_xticks(range(len(chosen)), [f"{rung.outcome.cpu:.2f} s" for rung in chosen])
    if any(height > 0 for part in names for height in heights[part]):
        axis.set_yscale("log")
    axis.set(ylabel="relative error", xlabel="CPU time")
    axis.legend()
    head = ("total error", "at most", "worst response", *names, "certificate", "CPU s", "memory MB", "settings")
    return picture(figure, "pareto") + table(head, rows, (2, len(head) - 1)) + (
        '<p class="note">Total: distance from the reference, as measured; at most: with the uncertainty of the reference. Parts: distances of ladders from their limits; '
        "those of side knobs were measured on one mesh.</p>")


def rung_table(ladder: Ladder, judge: Judge, rungs: list[Rung]) -> str:
    """Everything that was run."""
    rows = [(*(knob.levels[i].name for knob, i in zip(ladder.knobs, rung.settings)), rung.purpose,
             rung.outcome.status + ("" if rung.outcome.certified else " (not certified)"),
             percent(judge.worst(rung)) if rung.outcome.values else "", f"{rung.outcome.cpu:.2f}",
             f"{rung.predicted:.2f}" if rung.predicted == rung.predicted else "", f"{rung.outcome.memory / MEGABYTE:.0f}")
            for rung in rungs]
    head = (*(knob.name for knob in ladder.knobs), "run for", "status", "total error", "CPU s", "predicted", "memory MB")
    return table(head, rows, range(len(ladder.knobs) + 2))
