"""Holds scenes against their restatements: whatever is certified must agree within both estimates."""
from __future__ import annotations

import dataclasses
import json
import pathlib
import shutil
import zlib
from collections.abc import Iterator

import numpy as np

from ..scenes.classes import make_scene
from ..scenes.scene_file import write_scene
from ..scenes.restatements import RESTATEMENTS, Restatement
from .program import Ending, Run, run_harmos

# Of the accuracy: smaller differences need not be explained by the estimates, which are no bounds.
NEGLIGIBLE = 1e-2


@dataclasses.dataclass(frozen=True)
class Pair:
    """One scene and a restatement of it. error: the largest difference over the accuracies that both were certified at; excess: over
    what both estimates say. is_said: one of them names what the problem does not determine. stages: of both."""
    name: str
    seed: int
    restatement: str
    endings: tuple[Ending, Ending]
    error: float
    excess: float
    response: str
    is_said: bool
    stages: tuple[int, int]

    @property
    def is_compared(self) -> bool:
        """Whether both are certified, with answers that the problem determines."""
        return self.endings == (Ending.CERTIFIED, Ending.CERTIFIED) and not self.is_said

    @property
    def is_bad(self) -> bool:
        """Certified twice with answers that exclude each other, or ended otherwise."""
        return self.endings[0] is not self.endings[1] or self.is_compared and self.error > 1


def _sizes(place: pathlib.Path) -> dict[str, float]:
    record = json.loads((place / "results" / "scene_result.json").read_text())
    return {name: float(size) for name, size in record["response_sizes"].items()}


def _differences(own: Run, other: Run, restated: Restatement, sizes: dict[str, float], accuracy: float) -> Iterator[
        tuple[float, float, str]]:
    for name in restated.factors:
        difference = float(abs(other.values[name] / restated.factors[name] - own.values[name]).max(initial=0.0)) / sizes[name]
        said = own.estimates[name] + other.estimates[name] + NEGLIGIBLE * accuracy
        yield difference / (2 * accuracy), difference / said, name


def try_restatements(name: str, seed: int, program: pathlib.Path, folder: pathlib.Path, limit: float,
              kinds: list[str]) -> list[Pair]:
    """Solves a scene and its restatements; the files of bad pairs stay in folder/CLASS_SEED."""
    scene = make_scene(name, seed)
    place = folder / f"{name}_{seed}"
    own = run_harmos(program, write_scene(scene, place / "own"), limit)
    pairs = []
    for kind in kinds:
        restated = RESTATEMENTS[kind](scene, np.random.default_rng((zlib.crc32(name.encode()), seed)))
        there = place / kind.replace(" ", "_")
        other = run_harmos(program, write_scene(restated.scene, there), limit, *restated.arguments)
        error, excess, response = 0.0, 0.0, ""
        if other.ending is Ending.REFUSED_INPUT and kind == "cut":  # too small to be cut
            continue
        if own.ending is other.ending is Ending.CERTIFIED:
            error, excess, response = max(_differences(own, other, restated, _sizes(place / "own"), scene.accuracy))
        said = bool(own.ranges or other.ranges or own.remarks or other.remarks)
        pairs.append(Pair(name, seed, kind, (own.ending, other.ending), error, excess, response, said,
                          (own.stages, other.stages)))
        if not pairs[-1].is_bad:
            shutil.rmtree(there)
    if not any(pair.is_bad for pair in pairs):
        shutil.rmtree(place)
    return pairs


def restatement_report(pairs: list[Pair]) -> tuple[str, bool]:
    """A table by restatement, every bad pair, and whether there is none."""
    lines = ["| restatement | pairs | certified | largest difference over both accuracies | over both estimates | stages over the scene's own | bad |",
             "|---|---|---|---|---|---|---|"]
    for kind in RESTATEMENTS:
        some = [pair for pair in pairs if pair.restatement == kind]
        certified = [pair for pair in some if pair.endings == (Ending.CERTIFIED, Ending.CERTIFIED)]
        if certified:
            own, other = (sum(column) for column in zip(*(pair.stages for pair in certified)))
            compared = [pair for pair in certified if pair.is_compared]
            error = max((pair.error for pair in compared), default=0.0)
            excess = max((pair.excess for pair in compared), default=0.0)
            lines.append(f"| {kind} | {len(some)} | {len(certified)} | {error:.2f} | {excess:.2f} | {other / own:.2f} | "
                         f"{sum(pair.is_bad for pair in some)} |")
    bad = [pair for pair in pairs if pair.is_bad]
    lines += [""] + [f"{pair.name} {pair.seed}, {pair.restatement}: {pair.endings[0].name.lower()} and "
                     f"{pair.endings[1].name.lower()}, {pair.response} {pair.error:.2f} of both accuracies" for pair in bad]
    return "\n".join(lines + ["restatements: " + ("agree" if not bad else "DISAGREE")]), not bad
