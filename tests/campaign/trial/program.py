"""Runs Harmos on a scene and reads what it says."""
from __future__ import annotations

import csv
import dataclasses
import enum
import json
import os
import pathlib
import shutil
import subprocess

import numpy as np

from ..scenes.mesh import Floats

_ENVIRONMENT = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_pml": "ob1", "OMPI_MCA_osc": "^ucx",
                "OMPI_MCA_ess_singleton_isolated": "1"}


class Ending(enum.Enum):
    """How a run ended, by its exit code."""
    CERTIFIED = 0
    FAILED = 1
    REFUSED_INPUT = 2
    NOT_CONVERGED = 3
    NO_EQUILIBRIUM = 4
    CRASHED = -1
    HUNG = -2


@dataclasses.dataclass
class Run:
    """What Harmos said. status, reason, remarks: its words. values: per response [step]. stages: linear stages.
    ranges: by name of the responses that it says the problem does not determine, their least and largest values [step]."""
    ending: Ending
    status: str
    reason: str
    values: dict[str, Floats]
    estimates: dict[str, float]
    stages: int
    seconds: float
    ranges: dict[str, tuple[Floats, Floats]] = dataclasses.field(default_factory=dict)
    remarks: tuple[str, ...] = ()


def environment() -> dict[str, str]:
    """Of this process, with one thread and Open MPI's settings for a single machine."""
    return {**os.environ, **_ENVIRONMENT}


def _ending(code: int) -> Ending:
    return Ending(code) if 0 <= code <= 4 else Ending.CRASHED


def run_harmos(program: pathlib.Path, scene: pathlib.Path, limit: float, *arguments: str) -> Run:
    """Solves a scene into the folder beside it; ends it after so many seconds. What it prints stays in harmos.log."""
    results = scene.parent / "results"
    shutil.rmtree(results, ignore_errors=True)  # or the record of an earlier run would count
    command = [str(program), "run", scene.name, "--output", results.name, *arguments]
    try:
        done = subprocess.run(command, cwd=scene.parent, env=environment(), timeout=limit,
                              capture_output=True, text=True, errors="replace", check=False)
    except subprocess.TimeoutExpired:
        return Run(Ending.HUNG, "", f"more than {limit:g} s", {}, {}, 0, limit)
    (scene.parent / "harmos.log").write_text(done.stdout + done.stderr)
    record_file = results / f"{scene.stem}_result.json"
    if not record_file.exists():
        said = " ".join(line for line in done.stderr.split("\n") if line.strip("- "))
        return Run(_ending(done.returncode), "", f"exit code {done.returncode}; {said}", {}, {}, 0, 0.0)
    record = json.loads(record_file.read_text())
    return Run(_ending(done.returncode), record["status"], record["reason"],
               _history(results / f"{scene.stem}_history.csv"),
               {name: float("nan") if estimate is None else float(estimate)
                for name, estimate in record.get("response_error_estimates", {}).items()},
               int(record["linear_stages"]), float(record["wall_seconds"]),
               {name: (np.array(range_["lower"], float), np.array(range_["upper"], float))
                for name, range_ in record.get("response_ranges", {}).items()}, tuple(record.get("remarks", [])))


def _history(path: pathlib.Path) -> dict[str, Floats]:
    """Columns by name, without time 0."""
    with path.open() as file:
        header, *rows = list(csv.reader(file))
    solved = [[float(cell) for cell in row] for row in rows if float(row[0]) > 0]
    table = np.array(solved).reshape(len(solved), len(header))
    return {name: table[:, column] for column, name in enumerate(header) if name not in ("step", "time")}
