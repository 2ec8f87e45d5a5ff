"""How a drawing is to be meshed."""
import dataclasses


@dataclasses.dataclass
class Meshing:
    """How a drawing is meshed.

    Attributes:
        size: of elements [length]; 0: a twentieth of the diagonal of the assembly.
        order: 1 or 2.
        part_sizes: sizes of single parts, by name.
        conformal: parts that touch share nodes; otherwise they are meshed one by one.
        bolts: names of parts that are cut across for a preload.
        perfect: names of interfaces that join perfectly.
        length: unit of length that the mesh gets [m].
    """
    size: float = 0.0
    order: int = 1
    part_sizes: dict[str, float] = dataclasses.field(default_factory=dict)
    conformal: bool = False
    bolts: list[str] = dataclasses.field(default_factory=list)
    perfect: list[str] = dataclasses.field(default_factory=list)
    length: float = 1e-3
