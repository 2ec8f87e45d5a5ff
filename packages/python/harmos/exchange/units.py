"""Consistent systems of units, as the entry Units of a scene names them."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class UnitSystem:
    """Units that belong together: a force is mass times length over time squared.

    Attributes:
        name: length, force, time.
        stress: its unit of stress [Pa].
        length: its unit of length [m].
    """
    name: str
    stress: float
    length: float


SYSTEMS: dict[str, UnitSystem] = {each.name: each for each in (
    UnitSystem("mm N s", 1e6, 1e-3),
    UnitSystem("m N s", 1.0, 1.0),
    UnitSystem("mm kN s", 1e9, 1e-3),
    UnitSystem("m kN s", 1e3, 1.0),
    UnitSystem("m MN s", 1e6, 1.0),
    UnitSystem("cm N s", 1e4, 1e-2),
    UnitSystem("um uN s", 1e6, 1e-6),
    UnitSystem("in lbf s", 6894.757293168361, 0.0254),
)}
"""All of them by name; the program's own list is in packages/scene/Units.cpp."""
