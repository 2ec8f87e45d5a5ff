"""Reads what Harmos writes into numpy arrays.

    import harmos
    study = harmos.read_study("results/bolted_joint_study.h5")
    study.parameters["mu"], study.responses["F_max"]    one number per configuration
    study.curves["reaction"]                            one row per configuration, one column per load step
    study.table()                                       everything as one structured array
    study.statistics.responses["u_A_y"].mean            of a study with random parameters; see harmos.stochastic
    history = harmos.read_history("results/bolted_joint_history.csv")
    history["time"], history["reaction"]

All numbers have the units of the scene. Lengths of arrays: c configurations, s load steps, n free parameters.
"""
import csv
import os
import zlib
from collections.abc import Iterable
from typing import Any, TypedDict

import h5py
import numpy
from numpy.typing import ArrayLike, NDArray

from harmos.arrays import Floats, Integers, Mask, Records, Texts
from harmos.foreign import read_foreign
from harmos.optional import demand_package
from harmos.stochastic import Statistics
from harmos.tables import frame_of

SCHEMA, SCHEMA_VERSION = "harmos-study", 1
"""What a study file says it is, and the newest version of it that is understood here."""
SEAL_LENGTH = 16
"""Bytes of the checksum at the end of a study file."""
SOLVED = ("certified", "certified, not unique", "calibrated", "calibrated, not unique")
"""Statuses of configurations with a solution as accurate as asked for."""
MOST_SURROGATE_POINTS = 2000
"""Configurations that a response surface goes through at most; Harmos takes as many."""


class SurrogateModel(TypedDict):
    """How Harmos has fitted a response surface.

    Attributes:
        lower: least values of the free parameters, [n].
        upper: largest values of the free parameters, [n].
        lengths: correlation lengths in coordinates from -1 to 1, [n].
        degree: of the polynomial, 0 to 2.
        nugget: variance of what differs between two solutions of one point, over that of the process.
        calibration: factor on the standard deviations that the process predicts.
        largest_left_out_error: largest difference between a value and what the others predict there; unit of the
            response.
        mean_left_out_error: root mean square of these differences; unit of the response.
    """

    lower: Floats
    upper: Floats
    lengths: Floats
    degree: int
    nugget: float
    calibration: float
    largest_left_out_error: float
    mean_left_out_error: float


class Study:
    """A study as its file has it; arrays have one row per configuration, in the order of their ids.

    Attributes:
        version: of the Harmos that wrote the file.
        name: of the study.
        title: of the study, may be empty.
        scene: path of its scene, as the study gives it.
        accuracy: relative error that was asked for.
        state: "running", "complete", "interrupted" or "aborted".
        parameters: values by name, in the order of the input, [c].
        units: of the parameters, by name; empty: not given.
        formulas: of the parameters that follow from others, by name; empty: none.
        entries: of the scene that a parameter sets, by its name.
        phases: what a new value of a parameter changes, in words, by its name.
        responses: values by name, in the order of the input, [c]; NaN: no solution.
        curves: histories by name, [c, s]; NaN: no solution.
        curve_errors: estimated relative error of every curve, by its name, [c].
        mesh_errors: estimated relative error that the mesh makes in a curve at its last load step, by its name, [c];
            NaN: not estimated. Empty in files of before.
        mesh_changes: the same as converged value less that on this mesh, in the unit of the curve.
        mesh_words: what such an estimate is worth, by name of the curve: estimated, uncertain, too coarse, locks, [c].
        times: ends of the load steps, [s].
        id: of the configurations, [c].
        status: of the configurations in words, [c].
        reason: of the status in words, may be empty, [c].
        iterations: of LATIN, [c].
        linear_stages: solved, [c].
        error_estimate: relative, [c]; NaN: none.
        starts: ids of the configurations whose solutions each started from, [c, most starts], filled up with 0.
        cpu_seconds: spent, [c]; NaN: not solved.
        notes: what the solver says about the study as a whole, by title.
        left_out: how many points of the design each condition left out, by its name.
        study_input: XML of the study with all defaults.
        scene_input: XML of the scene with all defaults.
        surrogate_models: how the surface of a response was fitted, by its name; empty before the study has ended.
        statistics: of a study with random parameters that has ended, else None.
    """

    def __init__(self, path: str | os.PathLike[str], name: str | None = None) -> None:
        """Reads the file; see read_study()."""
        if name is None:
            _demand_seal(path)
        with h5py.File(path, "r") as file:
            if file.attrs.get("schema") != SCHEMA:
                raise ValueError(f"{path} is not a study of Harmos")
            if file.attrs["schema_version"] > SCHEMA_VERSION:
                raise ValueError(f"{path} was written by a newer Harmos, {file.attrs['program_version']}")
            self.version: str = file.attrs["program_version"]
            self.name: str = name or next(iter(file))
            group = file[self.name]
            self.title: str = group.attrs["title"]
            self.scene: str = group.attrs["scene"]
            self.accuracy: float = group.attrs["accuracy"]
            self.state: str = group.attrs["state"]
            self.parameters = _arrays(group["parameters"])
            attributes = {name: dict(group["parameters"][name].attrs) for name in self.parameters}
            self.units: dict[str, str] = {name: a["unit"] for name, a in attributes.items()}
            self.formulas: dict[str, str] = {name: a["formula"] for name, a in attributes.items()}
            self.entries: dict[str, list[str]] = {name: list(a["entries"]) for name, a in attributes.items()}
            self.phases: dict[str, str] = {name: a["phase"] for name, a in attributes.items()}
            self.responses = _arrays(group["responses"])
            self.curves = _arrays(group["curves"])
            self.curve_errors: dict[str, Floats] = {name: group["curve_errors"][name][()] for name in self.curves}
            self.mesh_errors: dict[str, Floats] = {n: a[()] for n, a in group.get("mesh_errors", {}).items()}
            self.mesh_changes: dict[str, Floats] = {n: a[()] for n, a in group.get("mesh_changes", {}).items()}
            self.mesh_words: dict[str, Texts] = {n: a.asstr()[()].astype(str)
                                                 for n, a in group.get("mesh_words", {}).items()}
            self.times: Floats = group["times"][()]
            rows = group["configurations"]
            self.id: Integers = rows["id"][()]
            self.status: Texts = rows["status"].asstr()[()].astype(str)
            self.reason: NDArray[numpy.object_] = rows["reason"].asstr()[()]
            self.iterations: Integers = rows["iterations"][()]
            self.linear_stages: Integers = rows["linear_stages"][()]
            self.error_estimate: Floats = rows["error_estimate"][()]
            self.starts: Integers = rows["starts"][()]
            self.cpu_seconds: Floats = rows["cpu_seconds"][()]
            self.notes: dict[str, str] = dict(group["notes"].attrs)
            self.left_out: dict[str, int] = {name: int(count) for name, count in group["left_out"].attrs.items()}
            self.surrogate_models = {name: _surrogate_model(model)
                                     for name, model in group.get("surrogates", {}).items()}
            self.statistics = Statistics(group["statistics"]) if "statistics" in group else None
            self.study_input: str = group["input"].attrs["study"]
            self.scene_input: str = group["input"].attrs["scene"]
        self._demand_sizes(path)

    def _demand_sizes(self, path: str | os.PathLike[str]) -> None:
        rows = [self.id, self.status, self.reason, self.iterations, self.linear_stages, self.error_estimate,
                self.cpu_seconds, *self.parameters.values(), *self.responses.values()]
        tables = [*self.curves.values()]
        if any(array.shape != self.id.shape for array in rows) or any(
                array.shape != (len(self.id), len(self.times)) for array in tables) or len(self.starts) != len(self.id):
            raise ValueError(f"{path} is damaged: the sizes of its arrays do not fit together")

    @property
    def solved(self) -> Mask:
        """Which configurations have a solution as accurate as asked for, [c]."""
        return numpy.isin(self.status, SOLVED)

    @property
    def free(self) -> list[str]:
        """Names of the parameters that the design chooses, without those that never change."""
        return [name for name, values in self.parameters.items()
                if not self.formulas[name] and len(numpy.unique(values)) > 1]

    def points(self, names: Iterable[str] | None = None) -> Floats:
        """Values of parameters (all free ones by default), [c, parameter]."""
        return numpy.column_stack([self.parameters[name] for name in names or self.free])

    def table(self) -> Records:
        """One structured array, [c]: id, parameters, status, iterations, error_estimate, start, responses."""
        columns: dict[str, NDArray[Any]] = {
            "id": self.id, **self.parameters, "status": self.status, "iterations": self.iterations,
            "error_estimate": self.error_estimate, "start": self.starts[:, 0], **self.responses}
        result = numpy.empty(len(self.id), [(name, array.dtype) for name, array in columns.items()])
        for name, array in columns.items():
            result[name] = array
        return result

    def frame(self) -> Any:
        """The same as a DataFrame of pandas, with the ids as index.

        Raises:
            ImportError: pandas is not installed.
        """
        return frame_of(self.table(), "id")

    def dataset(self) -> Any:
        """Parameters, responses and curves as a Dataset of xarray, with the dimensions id and time.

        Raises:
            ImportError: xarray is not installed.
        """
        rows: dict[str, NDArray[Any]] = {**self.parameters, **self.responses, "status": self.status}
        variables: dict[str, Any] = {name: ("id", values) for name, values in rows.items()}
        for name, curves in self.curves.items():
            variables[f"{name}_curve" if name in rows else name] = (("id", "time"), curves)
        return demand_package("xarray").Dataset(variables, coords={"id": self.id, "time": self.times})

    def surrogate(self, response: str) -> "Surrogate":
        """The response surface of a study that has ended.

        Raises:
            ValueError: the response has none.
        """
        if response not in self.surrogate_models:
            raise ValueError(f"there is no response surface of {response}; there are: {list(self.surrogate_models)}")
        known = numpy.flatnonzero(self.solved & numpy.isfinite(self.responses[response]))
        count = min(len(known), MOST_SURROGATE_POINTS)
        chosen = known[numpy.arange(count) * len(known) // count]
        return Surrogate(self.points()[chosen], self.responses[response][chosen], self.surrogate_models[response])

    def select(self, **values: float) -> Mask:
        """Which configurations have these values of parameters, [c]: select(mu=0.3, preload_1=0.1)."""
        mask = numpy.ones(len(self.id), bool)
        for name, value in values.items():
            mask &= numpy.isclose(self.parameters[name], value, rtol=1e-9, atol=0.0)
        return mask


class Surrogate:
    """A response surface with error bars, the same as `harmos predict` evaluates: polynomial and Gaussian process.

    surface = study.surrogate("F_max")
    values, deviations = surface(points)

    Attributes:
        lower: least values of the free parameters, [n].
        upper: largest values of the free parameters, [n].
        lengths: correlation lengths in coordinates from -1 to 1, [n].
        degree: of the polynomial, 0 to 2.
        calibration: factor on the standard deviations that the process predicts.
        largest_left_out_error: largest difference between a value and what the others predict there.
        mean_left_out_error: root mean square of these differences.
    """

    def __init__(self, points: Floats, values: Floats, model: SurrogateModel) -> None:
        """Goes through `values` [c] at `points` [c, n]; study.surrogate() knows all three."""
        self.lower, self.upper, self.lengths = model["lower"], model["upper"], model["lengths"]
        self.degree, self.calibration = model["degree"], model["calibration"]
        self.largest_left_out_error = model["largest_left_out_error"]
        self.mean_left_out_error = model["mean_left_out_error"]
        self._x = self._scaled(points)
        correlations = self._correlations(self._x) + model["nugget"] * numpy.eye(len(values))
        self._factor = numpy.linalg.cholesky(correlations)
        self._trend = self._solve(self._monomials(self._x))
        rest = self._solve(values)
        self._trend_factor = numpy.linalg.cholesky(self._trend.T @ self._trend)
        self._coefficients: Floats = numpy.linalg.lstsq(self._trend, rest, rcond=None)[0]
        rest = rest - self._trend @ self._coefficients
        self._variance = float(rest @ rest) / max(len(values) - self._trend.shape[1], 1)
        self._weights: Floats = numpy.linalg.solve(self._factor.T, rest)

    def __call__(self, points: ArrayLike) -> tuple[Floats, Floats]:
        """Values and their standard deviations, each [point], at points [point, n] or at one point [n]."""
        x = self._scaled(numpy.atleast_2d(points))
        f = self._monomials(x)
        r = self._correlations(x)
        values: Floats = f @ self._coefficients + r @ self._weights
        solved = self._solve(r.T)
        u = numpy.linalg.solve(self._trend_factor, self._trend.T @ solved - f.T)
        share = 1 - (solved ** 2).sum(axis=0) + (u ** 2).sum(axis=0)
        return values, self.calibration * numpy.sqrt(self._variance * share.clip(0))

    def is_inside(self, points: ArrayLike) -> Mask:
        """Whether points [point, n] lie in the box of the study, [point]; elsewhere the surface is an extrapolation."""
        inside: Mask = (numpy.abs(self._scaled(numpy.atleast_2d(points))) <= 1 + 1e-9).all(axis=1)
        return inside

    def _scaled(self, points: ArrayLike) -> Floats:
        return (2 * numpy.asarray(points, float) - self.lower - self.upper) / (self.upper - self.lower)

    def _monomials(self, x: Floats) -> Floats:
        n = x.shape[1]
        columns = [numpy.ones(len(x))]
        if self.degree >= 1:
            columns += [x[:, i] for i in range(n)]
        if self.degree >= 2:
            columns += [x[:, i] * x[:, j] for i in range(n) for j in range(i, n)]
        return numpy.column_stack(columns)

    def _correlations(self, x: Floats) -> Floats:
        distance = numpy.sqrt(5 * (((x[:, None] - self._x[None]) / self.lengths) ** 2).sum(axis=2))
        correlations: Floats = (1 + distance + distance ** 2 / 3) * numpy.exp(-distance)
        return correlations

    def _solve(self, right: Floats) -> Floats:
        return numpy.linalg.solve(self._factor, right)


def read_study(path: str | os.PathLike[str], name: str | None = None) -> Study:
    """Reads STUDY.h5, also while the study is running.

    Args:
        path: of the file.
        name: chooses among several studies in one file that somebody else has put together.

    Raises:
        OSError: the file cannot be read.
        ValueError: it is not the file of a study, has changed since Harmos wrote it, or is of a newer Harmos.
    """
    return read_foreign(path, lambda: Study(path, name))


def read_history(path: str | os.PathLike[str]) -> Records:
    """Reads SCENE_history.csv into a structured array with the columns step, time and the responses, [s].

    Raises:
        OSError: the file cannot be read.
        ValueError: it holds something else than numbers.
    """
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    values = [tuple(map(float, row)) for row in rows[1:]]
    return numpy.array(values, [(name, float) for name in rows[0]])


def _demand_seal(path: str | os.PathLike[str]) -> None:
    """HDF5 crashes on some damages and returns others as values: Harmos writes a checksum behind what HDF5 reads."""
    with open(path, "rb") as file:
        content = file.read()
    if content[-SEAL_LENGTH:] != b"harmos:%08x\n" % zlib.crc32(content[:-SEAL_LENGTH]):
        raise ValueError(f"{path} is no file of a study, or was damaged or changed since. "
                         "Run the study again to restore it.")


def _arrays(group: h5py.Group) -> dict[str, Floats]:
    return {name: group[name][()] for name in group.attrs["order"]}


def _surrogate_model(group: h5py.Group) -> SurrogateModel:
    return {"lower": group["lower"][()], "upper": group["upper"][()], "lengths": group["lengths"][()],
            "degree": int(group.attrs["degree"]), "nugget": group.attrs["nugget"],
            "calibration": group.attrs["calibration"],
            "largest_left_out_error": group.attrs["largest_left_out_error"],
            "mean_left_out_error": group.attrs["mean_left_out_error"]}
