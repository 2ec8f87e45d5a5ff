"""Holds studies against runs of their configurations, which are solved more accurately one by one."""
from __future__ import annotations

import dataclasses
import enum
import json
import pathlib
import shutil
import subprocess

import h5py
import numpy as np

from ..reference.problem import assemble
from ..reference.solver import equilibria_near
from ..scenes.classes import make_scene
from ..scenes.mesh import Floats
from ..scenes.scene import Scene
from ..scenes.scene_file import write_scene
from ..scenes.studies import Study, draw_study, with_values, write_study
from .fields import read_displacements
from .program import Ending, Run, environment, run_harmos

# Runs are so much more accurate, or as accurate as this.
_TIGHTER = 1 / 20
_TIGHTEST = 1e-7
_SOLVED = ("certified", "calibrated")
_SAID = ("certified, not unique", "calibrated, not unique")


class Verdict(enum.Enum):
    """Of one configuration."""
    RIGHT = "right"
    NOT_DETERMINED = "not determined and said so"
    UNSOLVED_RIGHT = "unsolved like the run"
    WRONG = "certified and wrong"
    OTHER = "certified, another solution of friction"
    REFUSED = "refused, the run is certified"
    RUN_REFUSED = "certified, the run is refused"
    EQUILIBRIUM_WRONG = "certified without equilibrium"
    FAILED = "crash, hang or failure"


FORBIDDEN = (Verdict.WRONG, Verdict.REFUSED, Verdict.EQUILIBRIUM_WRONG, Verdict.FAILED)


@dataclasses.dataclass(frozen=True)
class Judgement:
    """error: the largest of a response over the accuracy asked for; detail: what there is to say of it."""
    verdict: Verdict
    error: float = 0.0
    detail: str = ""


@dataclasses.dataclass(frozen=True)
class StudyTrial:
    """One study: class and seed make it anew. stages: linear stages of the study and of the runs."""
    name: str
    seed: int
    judgements: list[Judgement]
    stages: tuple[int, int]


@dataclasses.dataclass(frozen=True)
class Configuration:
    """What the study says of one: curves: per response [step]; claims: error estimates of them."""
    status: str
    reason: str
    values: dict[str, float]
    curves: dict[str, Floats]
    claims: dict[str, float]
    stages: int


def _read(path: pathlib.Path, study: Study) -> list[Configuration]:
    with h5py.File(path) as file:
        table = file["study"]
        curves = {name: data[()] for name, data in table["curves"].items()}
        claims = {name: data[()] for name, data in table["curve_errors"].items()}
        values = {path: table[f"parameters/p{number}"][()] for number, path in enumerate(study.values)}
        rows = zip(table["configurations/status"][()], table["configurations/reason"][()],
                   table["configurations/linear_stages"][()])
        return [Configuration(status.decode(), reason.decode(), {path: float(v[i]) for path, v in values.items()},
                               {name: curve[i] for name, curve in curves.items()},
                               {name: float(claim[i]) for name, claim in claims.items()}, int(stages))
                for i, (status, reason, stages) in enumerate(rows)]


def _run_study(program: pathlib.Path, study: Study, path: pathlib.Path, limit: float) -> list[Configuration] | str:
    """Its configurations, or what went wrong."""
    launcher = ["mpirun", "-n", str(study.ranks)] if study.ranks > 1 else []
    try:
        done = subprocess.run([*launcher, str(program), "study", path.name, "--output", "study"], cwd=path.parent,
                              env=environment(), timeout=limit, capture_output=True, text=True, errors="replace",
                              check=False)
    except subprocess.TimeoutExpired:
        return f"the study takes more than {limit:g} s"
    (path.parent / "study.log").write_text(done.stdout + done.stderr)
    table = path.parent / "study" / "study.h5"
    if done.returncode not in (0, 3, 4) or not table.exists():
        return f"the study ends with exit code {done.returncode}; {done.stderr.strip()[-300:]}"
    return _read(table, study)


def _largest_error(said: Configuration, values: dict[str, Floats], sizes: dict[str, float],
                   accuracy: float) -> tuple[float, str]:
    """Over the accuracy, and of which response."""
    distances = {name: np.abs(said.curves[name] - one).max(initial=0.0) for name, one in values.items()
                 if sizes.get(name)}
    return max((float(distance) / sizes[name] / accuracy if np.isfinite(distance) else np.inf, name)
               for name, distance in distances.items())


def judge_configuration(said: Configuration, run: Run, sizes: dict[str, float], accuracy: float) -> Judgement:
    """What a configuration of a study is worth beside a run of it; sizes: that errors of responses are relative to."""
    if run.ending in (Ending.CRASHED, Ending.HUNG, Ending.FAILED):
        return Judgement(Verdict.FAILED, detail=f"the run: {run.reason}")
    if said.status not in _SOLVED + _SAID:
        is_same = run.ending is not Ending.CERTIFIED
        return Judgement(Verdict.UNSOLVED_RIGHT if is_same else Verdict.REFUSED, detail=said.reason)
    if run.ending is not Ending.CERTIFIED:
        lacks = run.ending is Ending.NO_EQUILIBRIUM
        return Judgement(Verdict.EQUILIBRIUM_WRONG if lacks else Verdict.RUN_REFUSED, detail=run.reason)
    if said.status in _SAID or run.ranges or run.remarks:
        return Judgement(Verdict.NOT_DETERMINED)
    error, name = _largest_error(said, run.values, sizes, accuracy)
    # The run has an error as well.
    if error > 1 + _TIGHTER:
        return Judgement(Verdict.WRONG, error, f"{name} {error:.2f} of the accuracy off, {said.claims[name]:.1e} claimed")
    return Judgement(Verdict.RIGHT, error)


def _judge_again(scene: Scene, said: Configuration, fields: list[Floats], accuracy: float,
                 judgement: Judgement) -> Judgement:
    """A second look at what seems wrong: a study starts from what it has solved, and where friction may jam or let go,
    that leads to another equilibrium than a run. The reference must find it, next to one of the fields; what it finds
    is added to these, for other configurations."""
    configured = with_values(scene, said.values)
    problem = assemble(configured)
    for found in (one for displacement in fields for one in equilibria_near(configured, problem, displacement)):
        values = {one.name: found.response(one) for one in scene.responses}
        sizes = {one.name: found.size(one) for one in scene.responses}
        if _largest_error(said, values, sizes, accuracy)[0] <= 1 + _TIGHTER:
            fields.append(found.displacement)
            return dataclasses.replace(judgement, verdict=Verdict.OTHER)
    return judgement


def try_study(name: str, seed: int, program: pathlib.Path, folder: pathlib.Path, limit: float,
              configurations: int = 0) -> StudyTrial | None:
    """Solves a study of a scene and runs of its configurations; the files of bad ones stay in folder/CLASS_SEED. None
    where no law of the scene has a number. configurations: as of draw_study()."""
    scene = make_scene(name, seed)
    study = draw_study(scene, name, seed, configurations)
    if study is None:
        return None
    place = folder / f"{name}_{seed}"
    path = write_scene(scene, place)
    read = _run_study(program, study, write_study(study, path), 5 * limit)
    if isinstance(read, str):
        return StudyTrial(name, seed, [Judgement(Verdict.FAILED, detail=read)], (0, 0))

    def run(said: Configuration, accuracy: float) -> Run:
        sets = [word for path_, value in said.values.items() for word in ("--set", f"{path_}={value!r}")]
        done = run_harmos(program, path, limit, *sets, "--set", f"Solver/Accuracy={accuracy!r}",
                          "--set", "Solver/Mesh Error=false")
        if done.ending is Ending.CERTIFIED:
            fields.append(read_displacements(place / "results" / "scene.e", scene.mesh))
        return done

    judgements: list[Judgement] = []
    fields: list[Floats] = []  # of the runs, and what the reference has found next to them
    stages = 0
    for said in read:
        own = run(said, max(study.accuracy * _TIGHTER, _TIGHTEST))
        record = place / "results" / "scene_result.json"
        sizes = json.loads(record.read_text())["response_sizes"] if record.exists() else {}
        judgements.append(judge_configuration(said, own, sizes, study.accuracy))
        stages += own.stages
    for i, said in enumerate(read):
        if judgements[i].verdict is Verdict.WRONG:
            run(said, study.accuracy)
            judgements[i] = _judge_again(scene, said, fields, study.accuracy, judgements[i])
    if not any(judgement.verdict in FORBIDDEN for judgement in judgements):
        shutil.rmtree(place)
    return StudyTrial(name, seed, judgements, (sum(said.stages for said in read), stages))


def study_report(trials: list[StudyTrial]) -> tuple[str, bool]:
    """Verdicts by class and in total, every configuration that is not as it should be, and whether the goals are met."""
    lines = ["| class | studies | " + " | ".join(verdict.value for verdict in Verdict) + " |",
             "|---" * (2 + len(Verdict)) + "|"]
    for name in [*dict.fromkeys(trial.name for trial in trials), "total"]:
        some = [trial for trial in trials if name in (trial.name, "total")]
        verdicts = [judgement.verdict for trial in some for judgement in trial.judgements]
        lines.append(f"| {name} | {len(some)} | " + " | ".join(str(verdicts.count(one)) for one in Verdict) + " |")
    right = [one.error for trial in trials for one in trial.judgements if one.verdict is Verdict.RIGHT]
    if right:
        lines += ["", f"largest error over the accuracy where right: {max(right):.2f}, median {np.median(right):.3f}"]
    study, runs = (sum(trial.stages[i] for trial in trials) for i in (0, 1))
    lines += [f"linear stages of studies and of runs {1 / _TIGHTER:g} times as accurate: {study}, {runs}", ""]
    bad = [(trial, judgement) for trial in trials for judgement in trial.judgements if judgement.verdict in FORBIDDEN]
    lines += [f"{trial.name} {trial.seed}: {judgement.verdict.value}; {judgement.detail}" for trial, judgement in bad]
    return "\n".join([*lines, "goals: " + ("MISSED" if bad else "met")]), not bad
