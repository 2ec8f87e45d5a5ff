"""What a run has written: its record, its history and its fields.

    result = harmos.read_result("results/bolted_joint_result.json")
    result.status, result.errors["reaction"], result.history["reaction"]
    parts = result.fields()
    parts.at_nodes("disp_x"), parts.nodes, parts.blocks["centre"]
"""
import csv
import json
import os
import pathlib
from typing import Any

from harmos.arrays import Floats, Records
from harmos.exodus_fields import Fields
from harmos.results import read_history
from harmos.tables import frame_of

ENDING = "_result.json"
"""How the name of a record ends."""


class Result:
    """One run, read from its files when they are asked for.

    Attributes:
        path: of the record.
        record: all that it says, as it stands in the file: status, errors, warnings, times.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Reads the record; see read_result()."""
        self.path = pathlib.Path(path)
        if not self.path.name.endswith(ENDING):
            raise ValueError(f"{path} is no record of a run: its name does not end with {ENDING}")
        try:
            self.record: dict[str, Any] = json.loads(self.path.read_text(encoding="utf-8"))
        except ValueError as error:
            raise ValueError(f"{path} is damaged: {error}") from None
        if not isinstance(self.record, dict) or self.record.get("program") != "Harmos":
            raise ValueError(f"{path} is no record of a run of Harmos")

    @property
    def status(self) -> str:
        """How it ended: certified; certified, not unique; not converged; no equilibrium; interrupted; failed; or
        running."""
        return str(self.record["status"])

    @property
    def is_certified(self) -> bool:
        """Whether all responses are as accurate as asked for."""
        return self.status.startswith("certified")

    @property
    def errors(self) -> dict[str, float]:
        """Estimated relative error of every response and of both fields, by name; NaN: none."""
        return {name: float("nan") if value is None else float(value)
                for name, value in self.record["response_error_estimates"].items()}

    @property
    def history(self) -> Records:
        """One row for each load step and the unloaded start: columns step, time and the responses.

        Raises:
            OSError: there is none.
        """
        return read_history(self._beside("_history.csv"))

    def frame(self) -> Any:
        """The history as a DataFrame of pandas, with the load steps as index."""
        return frame_of(self.history, "step")

    @property
    def derivatives(self) -> dict[tuple[str, str], Floats]:
        """Derivatives of responses with respect to parameters that the scene lists, by (response, parameter), one
        value for each load step; empty: none were asked for."""
        try:
            with open(self._beside("_derivatives.csv"), newline="") as file:
                rows = list(csv.DictReader(file))
        except FileNotFoundError:
            return {}
        import numpy
        names = dict.fromkeys((row["response"], row["parameter"]) for row in rows)
        return {key: numpy.array([float(row["derivative"]) for row in rows
                                  if (row["response"], row["parameter"]) == key]) for key in names}

    def fields(self, interfaces: bool = False) -> Fields:
        """Fields on the parts, or on the interfaces.

        Raises:
            OSError, ValueError: the file is not there, or damaged.
            ImportError: netCDF4 is not installed.
        """
        return Fields(self._beside("_interfaces.e" if interfaces else ".e"))

    def _beside(self, ending: str) -> pathlib.Path:
        return self.path.with_name(self.path.name.removesuffix(ENDING) + ending)


def read_result(path: str | os.PathLike[str]) -> Result:
    """A run by its record, NAME_result.json.

    Raises:
        OSError: the file cannot be read.
        ValueError: it is no record of a run.
    """
    return Result(path)
