"""Reads what Harmos writes into numpy arrays.

    import harmos
    study = harmos.read_study("results/bolted_joint_study.h5")
    study.parameters["mu"], study.responses["F_max"]    one number per configuration
    study.curves["reaction"]                            one row per configuration, one column per load step
    study.table()                                       everything as one structured array
    study.statistics.responses["u_A_y"].mean            of a study with random parameters; see harmos.stochastic
    history = harmos.read_history("results/bolted_joint_history.csv")
    history["time"], history["reaction"]
"""
import csv
import zlib

import h5py
import numpy

from harmos.stochastic import Statistics

SCHEMA, SCHEMA_VERSION = "harmos-study", 1
SEAL_LENGTH = 16
SOLVED = ("certified", "calibrated")
MOST_SURROGATE_POINTS = 2000  # as Harmos takes


class Study:
    """A study as its file has it; arrays have one row per configuration, in the order of their ids.

    name, title, scene, accuracy, state, version: what it is
    parameters, responses    dictionaries of arrays by name, in the order of the input; NaN: no solution
    units, formulas, entries, phases    dictionaries by name of the parameter
    curves                   dictionary of arrays [configuration, load step] by name; NaN: no solution
    curve_errors             dictionary of arrays: estimated relative error of every curve
    times                    of the load steps
    id, status, reason, iterations, linear_stages, error_estimate, starts, cpu_seconds    arrays
    notes                    what the solver says about the study as a whole
    left_out                 how many points of the design each condition left out
    study_input, scene_input XML with all defaults
    surrogate_models         dictionaries by response: how its surface was fitted, once the study has ended
    statistics               of a study with random parameters that has ended, else None; see harmos.stochastic
    """

    def __init__(self, path, name=None):
        if name is None:
            _demand_seal(path)
        with h5py.File(path, "r") as file:
            if file.attrs.get("schema") != SCHEMA:
                raise ValueError(f"{path} is not a study of Harmos")
            if file.attrs["schema_version"] > SCHEMA_VERSION:
                raise ValueError(f"{path} was written by a newer Harmos, {file.attrs['program_version']}")
            self.version = file.attrs["program_version"]
            self.name = name or next(iter(file))
            group = file[self.name]
            for key in ("title", "scene", "accuracy", "state"):
                setattr(self, key, group.attrs[key])
            self.parameters = _arrays(group["parameters"])
            attributes = {name: dict(group["parameters"][name].attrs) for name in self.parameters}
            self.units = {name: a["unit"] for name, a in attributes.items()}
            self.formulas = {name: a["formula"] for name, a in attributes.items()}
            self.entries = {name: list(a["entries"]) for name, a in attributes.items()}
            self.phases = {name: a["phase"] for name, a in attributes.items()}
            self.responses = _arrays(group["responses"])
            self.curves = _arrays(group["curves"])
            self.curve_errors = {name: group["curve_errors"][name][()] for name in self.curves}
            self.times = group["times"][()]
            rows = group["configurations"]
            for key in ("id", "iterations", "linear_stages", "error_estimate", "starts", "cpu_seconds"):
                setattr(self, key, rows[key][()])
            self.status = rows["status"].asstr()[()].astype(str)
            self.reason = rows["reason"].asstr()[()]
            self.notes = dict(group["notes"].attrs)
            self.left_out = dict(group["left_out"].attrs)
            self.surrogate_models = {name: {**dict(model.attrs), **{key: model[key][()] for key in model}}
                                     for name, model in group.get("surrogates", {}).items()}
            self.statistics = Statistics(group["statistics"]) if "statistics" in group else None
            self.study_input = group["input"].attrs["study"]
            self.scene_input = group["input"].attrs["scene"]

    @property
    def solved(self):
        """Which configurations have a solution as accurate as asked for."""
        return numpy.isin(self.status, SOLVED)

    @property
    def free(self):
        """Names of the parameters that the design chooses, without those that never change."""
        return [name for name, values in self.parameters.items()
                if not self.formulas[name] and len(numpy.unique(values)) > 1]

    def points(self, names=None):
        """Values of parameters (all free ones by default), [configuration, parameter]."""
        return numpy.column_stack([self.parameters[name] for name in names or self.free])

    def table(self):
        """One structured array: id, parameters, status, iterations, error_estimate, start, responses."""
        columns = {"id": self.id, **self.parameters, "status": self.status, "iterations": self.iterations,
                   "error_estimate": self.error_estimate, "start": self.starts[:, 0], **self.responses}
        result = numpy.empty(len(self.id), [(name, array.dtype) for name, array in columns.items()])
        for name, array in columns.items():
            result[name] = array
        return result

    def surrogate(self, response):
        """The response surface of a study that has ended; see Surrogate."""
        if response not in self.surrogate_models:
            raise ValueError(f"there is no response surface of {response}; there are: {list(self.surrogate_models)}")
        known = numpy.flatnonzero(self.solved & numpy.isfinite(self.responses[response]))
        count = min(len(known), MOST_SURROGATE_POINTS)
        chosen = known[numpy.arange(count) * len(known) // count]
        return Surrogate(self.points()[chosen], self.responses[response][chosen], self.surrogate_models[response])

    def select(self, **values):
        """Mask of the configurations with these values of parameters: select(mu=0.3, preload_1=0.1)."""
        mask = numpy.ones(len(self.id), bool)
        for name, value in values.items():
            mask &= numpy.isclose(self.parameters[name], value, rtol=1e-9, atol=0.0)
        return mask


class Surrogate:
    """A response surface with error bars, the same as `harmos predict` evaluates: polynomial and Gaussian process.

    surface = study.surrogate("F_max")
    values, deviations = surface(points)    points [point, free parameter] or one point; one standard deviation
    largest_left_out_error, mean_left_out_error    between the value at a point and what the others predict there
    """

    def __init__(self, points, values, model):
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
        self._coefficients = numpy.linalg.lstsq(self._trend, rest, rcond=None)[0]
        rest = rest - self._trend @ self._coefficients
        self._variance = rest @ rest / max(len(values) - self._trend.shape[1], 1)
        self._weights = numpy.linalg.solve(self._factor.T, rest)

    def __call__(self, points):
        x = self._scaled(numpy.atleast_2d(points))
        f = self._monomials(x)
        r = self._correlations(x)
        values = f @ self._coefficients + r @ self._weights
        solved = self._solve(r.T)
        u = numpy.linalg.solve(self._trend_factor, self._trend.T @ solved - f.T)
        share = 1 - (solved ** 2).sum(axis=0) + (u ** 2).sum(axis=0)
        return values, self.calibration * numpy.sqrt(self._variance * share.clip(0))

    def is_inside(self, points):
        """Whether points lie in the box of the study; elsewhere the surface is an extrapolation."""
        return (numpy.abs(self._scaled(numpy.atleast_2d(points))) <= 1 + 1e-9).all(axis=1)

    def _scaled(self, points):
        return (2 * numpy.asarray(points, float) - self.lower - self.upper) / (self.upper - self.lower)

    def _monomials(self, x):
        n = x.shape[1]
        columns = [numpy.ones(len(x))]
        if self.degree >= 1:
            columns += [x[:, i] for i in range(n)]
        if self.degree >= 2:
            columns += [x[:, i] * x[:, j] for i in range(n) for j in range(i, n)]
        return numpy.column_stack(columns)

    def _correlations(self, x):
        distance = numpy.sqrt(5 * (((x[:, None] - self._x[None]) / self.lengths) ** 2).sum(axis=2))
        return (1 + distance + distance ** 2 / 3) * numpy.exp(-distance)

    def _solve(self, right):
        return numpy.linalg.solve(self._factor, right)


def read_study(path, name=None):
    """Reads STUDY.h5, also while the study is running; ValueError when it has changed since Harmos wrote it.

    `name` chooses among several studies in one file that somebody else has put together.
    """
    return Study(path, name)


def read_history(path):
    """Reads SCENE_history.csv into a structured array with the columns step, time and the responses."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    values = [tuple(map(float, row)) for row in rows[1:]]
    return numpy.array(values, [(name, float) for name in rows[0]])


def _demand_seal(path):
    """HDF5 crashes on some damages and returns others as values: Harmos writes a checksum behind what HDF5 reads."""
    with open(path, "rb") as file:
        content = file.read()
    if content[-SEAL_LENGTH:] != b"harmos:%08x\n" % zlib.crc32(content[:-SEAL_LENGTH]):
        raise ValueError(f"{path} is no file of a study, or was damaged or changed since. "
                         "Run the study again to restore it.")


def _arrays(group):
    return {name: group[name][()] for name in group.attrs["order"]}
