"""Studies of a scene: one or two numbers of its laws take several values each."""
from __future__ import annotations

import dataclasses
import pathlib
import random
import xml.etree.ElementTree as xml
from collections.abc import Mapping

from .scene import Joint, Law, Number, Scene, Varying
from .scene_file import entry, sublist

# Of the number that the scene has; 1 is the scene itself.
_FACTORS = (0.3, 0.6, 0.8, 1.0, 1.1, 1.3, 2.0)
_ACCURACIES = (1e-2, 1e-3, 1e-4)
_RANKS = (1, 1, 1, 2)
_VALUES_OF_ONE, _VALUES_OF_TWO = 4, 3
# Of studies of many configurations.
_LOWEST, _HIGHEST = 0.7, 1.3


@dataclasses.dataclass(frozen=True)
class Study:
    """values: by list path of the number in the scene. ranks: that it is run on."""
    values: Mapping[str, tuple[float, ...]]
    accuracy: float
    ranks: int


def _list_path(joint: Joint, name: str) -> str:
    return f"{'Boundaries' if joint.side2 is None else 'Interfaces'}/{joint.name}/Law/{name}"


def _numbers(scene: Scene) -> dict[str, float]:
    """All numbers of laws that are not 0, by list path."""
    found = {}
    for joint in scene.joints:
        for name, number in joint.law.parameters.items():
            value = number.value if isinstance(number, Varying) else number
            if value != 0:
                found[_list_path(joint, name)] = float(value)
    return found


def with_values(scene: Scene, values: Mapping[str, float]) -> Scene:
    """The scene with other numbers of laws, by list path."""
    def number(path: str, old: Number) -> Number:
        new = values.get(path)
        if new is None:
            return old
        return dataclasses.replace(old, value=new) if isinstance(old, Varying) else new

    def law(joint: Joint) -> Law:
        return dataclasses.replace(joint.law, parameters={
            name: number(_list_path(joint, name), old) for name, old in joint.law.parameters.items()})

    return dataclasses.replace(scene, joints=[dataclasses.replace(joint, law=law(joint)) for joint in scene.joints])


def draw_study(scene: Scene, name: str, seed: int, configurations: int = 0) -> Study | None:
    """The study of a scene of this class and seed: always the same; None where no law has a number.

    configurations: about how many, close to each other; 0: few, so that each is certified by itself.
    """
    numbers = _numbers(scene)
    if not numbers:
        return None
    chance = random.Random(f"{name} {seed}")
    paths = chance.sample(sorted(numbers), min(len(numbers), chance.choice((1, 2))))
    count = _VALUES_OF_ONE if len(paths) == 1 else _VALUES_OF_TWO
    factors = {path: sorted(chance.sample(_FACTORS, count)) for path in paths}
    if configurations:
        count = max(2, round(configurations ** (1 / len(paths))))
        factors = {path: [_LOWEST + (_HIGHEST - _LOWEST) * i / (count - 1) for i in range(count)] for path in paths}
    values = {path: tuple(sorted(factor * numbers[path] for factor in factors[path])) for path in paths}
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
