"""Reads what a run or a study has left: the numbers that are traded for."""
import json
import math
import pathlib
from xml.etree.ElementTree import Element

import numpy

from harmos.arrays import Floats
from harmos.results import read_history, read_study
from harmos.trade.document import Document, value_of

Answer = tuple[str, bool, dict[str, Floats], dict[str, float], dict[str, float], dict[str, float],
               dict[str, float]]
"""Status, whether it is certified; of the responses values, estimates of the iteration's error, sizes,
estimates of the mesh's error and of the design's."""


ROUND_OFF = 1e-9
"""Relative difference of numbers that files have rounded in different ways."""


def read_outcome(document: Document, base: pathlib.Path) -> Answer:
    """The answer in the files that begin with `base`.

    Raises:
        OSError: they are not there.
        ValueError: they hold something else.
    """
    return _run(document, base) if document.study is None else _study(base, _refines_itself(document.study))


def read_floors(document: Document, base: pathlib.Path) -> dict[str, float]:
    """Sizes below which responses of the scene count as nothing, from a run of it whose files begin with `base`.

    Its `Scale`, else the size that the run says, where that is more than every value: 0 of a response that is no less.

    Raises:
        OSError: the files are not there.
        ValueError: they hold something else.
    """
    sizes = json.loads(base.with_name(base.name + "_result.json").read_text())["response_sizes"]
    history = read_history(base.with_name(base.name + "_history.csv"))
    floors = {}
    for name, size in sizes.items():
        stated = float(size) if numpy.abs(history[name]).max() < (1 - ROUND_OFF) * float(size) else 0.0
        floors[name] = float(document.value(f"Responses/{name}/Scale", str(stated)))
    return floors


def read_reason(base: pathlib.Path) -> str:
    """Why the run of a scene, whose files begin with `base`, has ended.

    Raises:
        OSError: the files are not there.
    """
    return str(json.loads(base.with_name(base.name + "_result.json").read_text())["reason"])


def step_ends(document: Document) -> list[float]:
    """The times at which the load steps of a scene end."""
    durations = [float(document.value(f"Steps/{name}/Duration", "1")) for name in document.names("Steps")]
    return list(numpy.cumsum(durations))


def _run(document: Document, base: pathlib.Path) -> Answer:
    record = json.loads(base.with_name(base.name + "_result.json").read_text())
    history = read_history(base.with_name(base.name + "_history.csv"))
    is_certified = record["exit_code"] == 0
    times = numpy.asarray(history["time"], float)
    ends = step_ends(document)
    sizes = {name: float(size) for name, size in record["response_sizes"].items()}
    values = {}
    for name in sizes:
        curve = numpy.asarray(history[name], float)
        if times[-1] > ends[-1] - 1e-9 * ends[-1]:  # otherwise it has not come to the end
            values[name] = numpy.array([curve[numpy.argmin(abs(times - end))] for end in ends])
    estimates = {name: sizes[name] * _number(record["response_error_estimates"].get(name)) for name in values}
    mesh = {name: abs(_number(estimate["change"]))
            for name, estimate in record["mesh_error_estimates"].items() if name in values}
    return record["status"], is_certified and bool(values), values, estimates, sizes, _finite(mesh), {}


def _refines_itself(study: Element) -> bool:
    """Whether no knob turns the order of an expansion or interpolation, so that its own estimate is all that tells its error."""
    return value_of(study, "Design/Type") == "Adaptive Collocation"


def _study(base: pathlib.Path, refines_itself: bool) -> Answer:
    study = read_study(base.with_name(base.name + ".h5"))
    values: dict[str, Floats] = {}
    estimates: dict[str, float] = {}
    design: dict[str, float] = {}
    statistics = study.statistics
    if statistics is not None and not statistics.is_sample:
        for name, each in statistics.responses.items():
            values[f"{name}, mean"] = numpy.array([each.mean])
            values[f"{name}, standard deviation"] = numpy.array([each.standard_deviation])
            for key in ("mean", "standard deviation"):
                estimates[f"{name}, {key}"] = each.iteration_error
            if refines_itself:
                errors = (each.mean_error, each.standard_deviation_error)
                design.update(zip((f"{name}, mean", f"{name}, standard deviation"),
                                  (math.inf if math.isnan(error) else error for error in errors)))
        is_certified = study.state == "complete"
        status = study.state
    else:
        is_certified = study.state == "complete" and bool(study.solved.all())
        status = f"{study.state}, {int(study.solved.sum())} of {len(study.id)} solved"
        names = list(study.responses) or list(study.curves)
        for name in names:
            values[name] = study.responses[name] if name in study.responses else study.curves[name][:, -1]
            estimates[name] = math.nan
    values = {name: array for name, array in values.items() if numpy.isfinite(array).all()}
    sizes = {name: float(abs(array).max()) for name, array in values.items()}
    for name in values:
        moment = name.removesuffix(", standard deviation")
        # What the iteration cannot tell from 0, as of a force that balances loads, is small beside the mean.
        if moment != name and sizes[name] <= estimates[name] and f"{moment}, mean" in sizes:
            sizes[name] = max(sizes[name], sizes[f"{moment}, mean"])
    mesh = {name: float(numpy.nanmax(abs(changes))) for name, changes in study.mesh_changes.items()
            if name in values and numpy.isfinite(changes).any()}
    return status, is_certified and bool(values), values, estimates, sizes, mesh, design


def _finite(numbers: dict[str, float]) -> dict[str, float]:
    return {name: number for name, number in numbers.items() if math.isfinite(number)}


def _number(value: float | None) -> float:
    return math.nan if value is None else float(value)
