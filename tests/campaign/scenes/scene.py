"""A scene in the words of Harmos's input, as data: what is written as XML and what the reference solves."""
from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence

from .mesh import Mesh


@dataclasses.dataclass(frozen=True)
class Varying:
    """A number times a factor per load step."""
    value: float
    factors: tuple[float, ...]


Number = float | Varying


def at_step(number: Number, step: int) -> float:
    """Value of a number at a load step, counted from 0."""
    return number.value * number.factors[step] if isinstance(number, Varying) else number


@dataclasses.dataclass(frozen=True)
class Law:
    """A law by its name in the input, with its parameters, and the words among its entries."""
    type: str
    parameters: dict[str, Number] = dataclasses.field(default_factory=dict)
    words: Mapping[str, str] = dataclasses.field(default_factory=dict)


@dataclasses.dataclass(frozen=True)
class Joint:
    """An interface between two side sets; a boundary when there is no second one.

    points_on: the side (1 or 2) whose corners are the points of a join of meshes that do not match, or are not to be
    taken so; none: the sides match, node by node. reach: its search distance [length].
    """
    name: str
    side1: str
    side2: str | None
    law: Law
    points_on: int | None = None
    reach: float | None = None


@dataclasses.dataclass(frozen=True)
class Part:
    """The element block of the same name. body_force: per global component [force/volume], empty for none."""
    name: str
    young: float
    poisson: float
    body_force: tuple[Number, ...] = ()


@dataclasses.dataclass(frozen=True)
class Response:
    """A response by its type in the input.

    target: name of the joint, or side set of a mean displacement. vectors: Direction, Centre, Axis. field: of a
    maximum.
    """
    name: str
    type: str
    target: str
    vectors: Mapping[str, tuple[float, ...]] = dataclasses.field(default_factory=dict)
    field: str = ""


@dataclasses.dataclass
class Scene:
    """kinematics: 3-D, Plane Strain or Plane Stress. accuracy: the one asked for. pieces: of parts."""
    mesh: Mesh
    kinematics: str
    thickness: float
    parts: list[Part]
    joints: list[Joint]
    steps: int
    accuracy: float
    responses: list[Response]
    pieces: dict[str, int] = dataclasses.field(default_factory=dict)

    def joint(self, name: str) -> Joint:
        """The joint of this name."""
        return next(joint for joint in self.joints if joint.name == name)


def vector(components: Sequence[float]) -> tuple[float, ...]:
    """Of plain numbers, which print the same everywhere."""
    return tuple(float(x) for x in components)
