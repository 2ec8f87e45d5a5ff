"""Interface laws as conditions on the components of the jump and of the traction at a point, by load step."""
from __future__ import annotations

import dataclasses
import enum

from ..scenes.scene import Law, Number, at_step


class Kind(enum.IntEnum):
    """What is known of a component; delta: jump, t: traction on side 1, c: the number that goes with it.

    FREE: t = 0. TIED: delta = c. SPRING: t = c delta. CONTACT: delta + c >= 0, t <= 0, (delta + c) t = 0. FRICTION:
    |t_t| <= c |t_n|, sliding along t_t, of a point whose first component is CONTACT. LOAD: t = c.
    """
    FREE = 0
    TIED = 1
    SPRING = 2
    CONTACT = 3
    FRICTION = 4
    LOAD = 5


@dataclasses.dataclass(frozen=True)
class Condition:
    """One component at all load steps."""
    kind: Kind
    values: tuple[float, ...]


# Laws that speak of global components instead of those along normal and tangents.
GLOBAL = ("Prescribed Displacement", "Prescribed Traction")
# Laws whose work in the plane of the joint Harmos counts as dissipation.
DISSIPATIVE = ("Coulomb Friction",)


def conditions(law: Law, dimension: int, steps: int) -> list[Condition]:
    """One condition per component: normal and tangents, or the axes for laws in GLOBAL."""
    def over_steps(kind: Kind, number: Number, sign: float = 1.0) -> Condition:
        return Condition(kind, tuple(sign * at_step(number, step) for step in range(steps)))

    def given(name: str, kind: Kind, sign: float = 1.0) -> Condition:
        return over_steps(kind, law.parameters.get(name, 0.0), sign)

    tangents = dimension - 1
    free = over_steps(Kind.FREE, 0.0)
    tied = over_steps(Kind.TIED, 0.0)
    match law.type:
        case "Perfect":
            return [tied] * dimension
        case "Symmetry":
            return [tied] + [free] * tangents
        case "Preload Jump":
            return [given("Jump", Kind.TIED, -1.0)] + [tied] * tangents
        case "Linear Elastic" | "Elastic Foundation":
            return ([given("Normal Stiffness", Kind.SPRING)]
                    + [given("Tangential Stiffness", Kind.SPRING)] * tangents)
        case "Unilateral Contact":
            return [given("Gap", Kind.CONTACT)] + [free] * tangents
        case "Coulomb Friction":
            return [given("Gap", Kind.CONTACT)] + [given("Friction Coefficient", Kind.FRICTION)] * tangents
        case "Prescribed Displacement":  # side 2 is the ground at rest: delta = -w
            return [given(axis, Kind.TIED, -1.0) if axis in law.parameters else free for axis in "XYZ"[:dimension]]
        case "Prescribed Traction":
            return [given(axis, Kind.LOAD) for axis in "XYZ"[:dimension]]
        case "Pressure":
            return [given("Pressure", Kind.LOAD, -1.0)] + [over_steps(Kind.LOAD, 0.0)] * tangents
    raise ValueError(f"unknown law {law.type}")
