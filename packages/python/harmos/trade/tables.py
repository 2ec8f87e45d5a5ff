"""Writes all rungs as a table (CSV) and as arrays (HDF5)."""
import csv
import io
import math
import os

import h5py
import numpy

from harmos.outputs import replace_file
from harmos.trade.judging import Judge
from harmos.trade.ladder import Ladder, Rung

SCHEMA = "harmos-trade"
"""What the HDF5 file says it is."""
BETTER = 0.95
"""An error must be so many times that of a cheaper rung to count as a gain."""


def all_rungs(ladder: Ladder) -> list[Rung]:
    """Those of the ladder, then the fresh runs of settings that should keep a promise."""
    return [*ladder.rungs.values(), *ladder.fresh.values()]


def write_csv(path: str, ladder: Ladder, judge: Judge, rungs: list[Rung]) -> None:
    """One row per rung: settings, status, cost, and value, errors and estimate of every response; errors are relative."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    names = list(judge.references)
    knobs = [knob.name for knob in ladder.knobs]
    heads = ("value", "total_error", *(f"{part}_error" for part in part_names(ladder)), "iteration_estimate",
             "reference_uncertainty")
    writer.writerow([*knobs, "purpose", "status", "certified", "cpu_s", "predicted_cpu_s", "wall_s", "memory_bytes",
                     *(f"{name} {head}" for name in names for head in heads)])
    for rung in rungs:
        row: list[object] = [knob.levels[i].name for knob, i in zip(ladder.knobs, rung.settings)]
        outcome = rung.outcome
        row += [rung.purpose, outcome.status, int(outcome.certified), f"{outcome.cpu:.3f}", f"{rung.predicted:.3f}",
                f"{outcome.wall:.3f}", outcome.memory]
        total = judge.total(rung)
        for name in names:
            values = outcome.values.get(name)
            parts = judge.parts(rung.settings, name)
            row += ["nan" if values is None else repr(float(values[-1])), f"{total[name]:.3e}"]
            row += [f"{parts.get(part, 0.0):.3e}" for part in part_names(ladder)]
            row += [f"{estimate(rung, judge, name):.3e}", f"{judge.references[name].doubt():.3e}"]
        writer.writerow(row)
    replace_file(path, buffer.getvalue().encode())


def write_hdf5(path: str, ladder: Ladder, judge: Judge, rungs: list[Rung]) -> None:
    """The same as arrays, [rung] or [rung, value], with the references and their uncertainties, [value]."""
    partial = f"{path}.partial.{os.getpid()}"
    try:
        with h5py.File(partial, "w") as file:
            file.attrs["schema"], file.attrs["schema_version"] = SCHEMA, 1
            for name, column in (("cpu", [rung.outcome.cpu for rung in rungs]),
                                 ("predicted_cpu", [rung.predicted for rung in rungs]),
                                 ("wall", [rung.outcome.wall for rung in rungs]),
                                 ("memory", [rung.outcome.memory for rung in rungs]),
                                 ("certified", [rung.outcome.certified for rung in rungs]),
                                 ("settings", [rung.settings for rung in rungs])):
                file[name] = numpy.array(column)
            file["status"] = [rung.outcome.status for rung in rungs]
            for knob in ladder.knobs:
                file[f"knobs/{knob.name}"] = [level.name for level in knob.levels]
            for name, reference in judge.references.items():
                group = file.create_group(f"responses/{name.replace('/', '_')}")
                group["reference"], group["uncertainty"] = reference.values, reference.uncertainty
                group["orders"] = reference.space.orders
                group.attrs["size"], group.attrs["limit"] = reference.size, reference.space.word
                nothing = numpy.full(reference.values.shape, numpy.nan)
                values = [rung.outcome.values.get(name, nothing) for rung in rungs]
                group["values"] = numpy.array([v if v.shape == nothing.shape else nothing for v in values])
                group["total_error"] = numpy.array([judge.total(rung)[name] for rung in rungs])
        os.replace(partial, path)
    finally:
        if os.path.exists(partial):
            os.remove(partial)


def part_names(ladder: Ladder) -> list[str]:
    """The parts of an error that knobs make: the mesh, then side knobs; the iteration's is that of its accuracy."""
    return ["mesh", *(ladder.knobs[i].name for i in range(len(ladder.knobs)) if ladder.knobs[i].role.value == "side")]


def estimate(rung: Rung, judge: Judge, name: str) -> float:
    """What the certificate of a rung states of the iteration's error, relative; NaN: nothing."""
    size = judge.references[name].size
    value = rung.outcome.estimates.get(name, float("nan"))
    return value / size if size > 0 else value


def pareto(rungs: list[Rung], judge: Judge, cost: str) -> list[Rung]:
    """The certified rungs to which none is at least as good in error and cost ("cpu" or "memory"), cheap ones first; none where no error is known."""
    chosen: list[Rung] = []
    certified = [rung for rung in rungs if rung.outcome.certified and judge.doubt() < math.inf]
    for rung in sorted(certified, key=lambda one: (getattr(one.outcome, cost), judge.worst(one))):
        if not chosen or judge.worst(rung) < BETTER * judge.worst(chosen[-1]):
            chosen.append(rung)
    return chosen

