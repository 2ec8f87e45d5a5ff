"""Studies of a scene: one or two numbers of its laws take several values each."""
from __future__ import annotations

import dataclasses
import pathlib
import random
import xml.etree.ElementTree as xml
from collections.abc import Mapping

from .scene import Scene, Varying
from .scene_file import entry, sublist

# Of the number that the scene has; 1 is the scene itself.
_FACTORS = (0.3, 0.6, 0.8, 1.0, 1.1, 1.3, 2.0)
_ACCURACIES = (1e-2, 1e-3, 1e-4)
_RANKS = (1, 1, 1, 2)
_VALUES_OF_ONE, _VALUES_OF_TWO = 4, 3


@dataclasses.dataclass(frozen=True)
class Study:
    """values: by list path of the number in the scene. ranks: that it is run on."""
    values: Mapping[str, tuple[float, ...]]
    accuracy: float
    ranks: int


def _numbers(scene: Scene) -> dict[str, float]:
    """All numbers of laws that are not 0, by list path."""
    found = {}
    for joint in scene.joints:
        group = "Boundaries" if joint.side2 is None else "Interfaces"
        for name, number in joint.law.parameters.items():
            value = number.value if isinstance(number, Varying) else number
            if value != 0:
                found[f"{group}/{joint.name}/Law/{name}"] = float(value)
    return found


def draw_study(scene: Scene, name: str, seed: int) -> Study | None:
    """The study of a scene of this class and seed: always the same; None where no law has a number."""
    numbers = _numbers(scene)
    if not numbers:
        return None
    chance = random.Random(f"{name} {seed}")
    paths = chance.sample(sorted(numbers), min(len(numbers), chance.choice((1, 2))))
    count = _VALUES_OF_ONE if len(paths) == 1 else _VALUES_OF_TWO
    values = {path: tuple(sorted(factor * numbers[path] for factor in chance.sample(_FACTORS, count))) for path in paths}
    return Study(values, chance.choice(_ACCURACIES), chance.choice(_RANKS))


def write_study(study: Study, scene: pathlib.Path) -> pathlib.Path:
    """Writes study.xml beside the scene; parameters are called p0, p1."""
    root = xml.Element("ParameterList", name="Harmos Study")
    entry(root, "Scene", scene.name)
    entry(root, "Accuracy", study.accuracy)
    parameters = sublist(root, "Parameters")
    for number, (path, values) in enumerate(study.values.items()):
        parameter = sublist(parameters, f"p{number}")
        entry(parameter, "Entry", path)
        entry(parameter, "Values", values)
    xml.indent(root)
    file = scene.parent / "study.xml"
    file.write_text(xml.tostring(root, encoding="unicode") + "\n")
    return file
