"""Types of elements as decks call them."""

SPRINGS = ("SPRING1", "SPRING2", "SPRINGA")
"""Springs to the ground along one component, between equal components of two nodes, along the line between two nodes."""

_OTHER_KINDS = {"B31": 2, "B31R": 2, "B32": 3, "B32R": 3, "T2D2": 2, "T3D2": 2, "SPRINGA": 2, "SPRING2": 2,
                "SPRING1": 1, "DASHPOTA": 2, "GAPUNI": 2, "MASS": 1, "D": 3, "DCOUP3D": 1, "S3": 3, "S4": 4, "S4R": 4,
                "S6": 6, "S8": 8, "S8R": 8, "M3D3": 3, "M3D4": 4, "M3D4R": 4, "M3D6": 6, "M3D8": 8, "M3D8R": 8, "M3D9": 9, "T3D3": 3}


def nodes_of_kind(kind: str) -> int:
    """How many nodes an element has by the number in its type; 0 when that is not known."""
    if kind in _OTHER_KINDS:
        return _OTHER_KINDS[kind]
    for family in ("C3D", "DC3D", "F3D", "AC3D", "CPS", "CPE", "CAX", "CPEG", "SC"):
        if kind.startswith(family):
            digits = ""
            for letter in kind[len(family):]:
                if not letter.isdecimal():
                    break
                digits += letter
            return int(digits or 0)
    return 0
