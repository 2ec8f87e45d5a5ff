"""Reads what Harmos writes into numpy arrays.

    import harmos_results
    study = harmos_results.read_study("results/bolted_joint_study.h5")
    study.parameters["mu"], study.responses["F_max"]    one number per configuration
    study.curves["reaction"]                            one row per configuration, one column per load step
    study.table()                                       everything as one structured array
    history = harmos_results.read_history("results/bolted_joint_history.csv")
    history["time"], history["reaction"]
"""
import csv

import h5py
import numpy

SCHEMA, SCHEMA_VERSION = "harmos-study", 1
SOLVED = ("certified", "calibrated")


class Study:
    """A study as its file has it; arrays have one row per configuration, in the order of their ids.

    name, title, scene, accuracy, state, version: what it is
    parameters, responses    dictionaries of arrays by name, in the order of the input; NaN: no solution
    units, formulas, entries, phases    dictionaries by name of the parameter
    curves                   dictionary of arrays [configuration, load step] by name; NaN: no solution
    curve_errors             dictionary of arrays: estimated relative error of every curve
    times                    of the load steps
    id, status, reason, iterations, linear_stages, error_estimate, starts, cpu_seconds    arrays
    left_out                 how many points of the design each condition left out
    study_input, scene_input XML with all defaults
    """

    def __init__(self, path, name=None):
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
            self.left_out = dict(group["left_out"].attrs)
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
                if not self.formulas[name] and values.min() < values.max()]

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

    def select(self, **values):
        """Mask of the configurations with these values of parameters: select(mu=0.3, preload_1=0.1)."""
        mask = numpy.ones(len(self.id), bool)
        for name, value in values.items():
            mask &= numpy.isclose(self.parameters[name], value, rtol=1e-9, atol=0.0)
        return mask


def read_study(path, name=None):
    """Reads STUDY.h5, also while the study is running. `name` chooses among several studies in one file."""
    return Study(path, name)


def read_history(path):
    """Reads SCENE_history.csv into a structured array with the columns step, time and the responses."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    values = [tuple(map(float, row)) for row in rows[1:]]
    return numpy.array(values, [(name, float) for name in rows[0]])


def _arrays(group):
    return {name: group[name][()] for name in group.attrs["order"]}
