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
        length: unit of length that the mesh gets [m].
    """
    size: float = 0.0
    order: int = 1
    part_sizes: dict[str, float] = dataclasses.field(default_factory=dict)
    conformal: bool = False
    length: float = 1e-3
