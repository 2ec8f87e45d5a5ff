"""What can be traded in a scene or a study: knobs with levels, each a few entries of the input."""
import enum
import math
import re
from collections.abc import Callable
from dataclasses import dataclass

from harmos.trade.document import Document, Entry, value_of

MESH_FACTORS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
"""Elements along an edge, over those of the scene as given; the budget ends the ladder before, unless they are few."""
COARSER, FINER, MOST = 2, 6, 8
"""Splits of a mesh from a file: fewer and more than as given, and those that Harmos takes."""
STEP_FACTORS = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
"""Increments of the load steps, over those of the scene as given."""
ACCURACIES = (3e-2, 1e-2, 1e-3, 1e-4, 1e-5)
"""Accuracies asked of the iteration, relative."""
CHAOS_ACCURACIES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
"""Accuracies asked of an expansion, relative to standard deviations."""
PIECES = (1, 2, 4)
"""Pieces of the largest part; others get fewer, by their elements."""
QUADRATIC = ("Hex20", "Hex27", "Wedge15", "Tet10", "Quad8", "Quad9", "Tri6")
"""Elements of boxes whose order nothing raises."""


class Role(enum.Enum):
    """What the levels of a knob do to the answer.

    Attributes:
        MESH: they converge as the size of the elements goes to 0.
        FAMILY: with each of them the meshes converge to the same limit, in a way of their own.
        SIDE: they converge by themselves, whatever the mesh.
        CHOICE: they compute the same, at different cost.
    """

    MESH = "mesh"
    FAMILY = "family"
    SIDE = "side"
    CHOICE = "choice"


@dataclass(frozen=True)
class Level:
    """A position of a knob.

    Attributes:
        name: for tables.
        entries: of the input that it sets; none: the input as given.
        size: what goes to 0 when the answer converges, relative to the input as given; of elements the distance of nodes.
    """

    name: str
    entries: tuple[Entry, ...]
    size: float = 1.0


@dataclass(frozen=True)
class Knob:
    """What can be turned.

    Attributes:
        name: for tables.
        role: of its levels.
        levels: coarsest first.
        given: the one that the input has, or is nearest to it.
    """

    name: str
    role: Role
    levels: tuple[Level, ...]
    given: int


Accepts = Callable[[tuple[Entry, ...]], bool]
"""Says whether Harmos takes the input with these changes."""


def knobs_of(document: Document, accepts: Accepts, elements: dict[str, int]) -> list[Knob]:
    """All knobs that an input has; what Harmos refuses for it is left out. `elements` are counts of the parts by name."""
    knobs = [_mesh(document), _elements(document, accepts), _mass(document), _steps(document), _accuracy(document)]
    if document.study is not None and value_of(document.study, "Design/Type") in ("Chaos", "Collocation"):
        knobs += [_order(document), _method(document)]
    elif document.study is None:
        knobs.append(_pieces(elements))
    return [_pinned(document, knob) for knob in knobs]


def elements_of(parts: list[str], words: str) -> dict[str, int]:
    """Counts of elements by part, from what `harmos check` says; it lists pieces of a part as PART.1, PART.2 and so on."""
    counts: dict[str, int] = {}
    for name, count in re.findall(r"^  (\S.*?)\s+\d+ nodes\s+(\d+) elements", words, re.M):
        part = name if name in parts else re.sub(r"\.\d+$", "", name)
        if part in parts:
            counts[part] = counts.get(part, 0) + int(count)
    return counts


def _pinned(document: Document, knob: Knob) -> Knob:
    """The knob, which nothing turns where a parameter of the study sets one of its entries."""
    paths = {entry.path for level in knob.levels for entry in level.entries}
    if not any(document.is_varied(path) for path in paths):
        return knob
    return Knob(knob.name, knob.role, (Level("as the study varies it", (), knob.levels[knob.given].size),), 0)


def dimension_of(document: Document) -> int:
    """Whether the meshes of an input grow with 2 or 3 numbers of elements along an edge."""
    boxes = document.names("Mesh/Boxes")
    if boxes:
        return len(_numbers(document.value(f"Mesh/Boxes/{boxes[0]}/Cells", "{1, 1, 1}")))
    is_plane = document.value("Model/Kinematics", "").startswith(("Plane", "Axi"))
    return 2 if is_plane or document.value("Mesh/Type", "") == "Glued Assembly" else 3


def _mesh(document: Document) -> Knob:
    kind = document.value("Mesh/Type", "")
    levels: list[Level] = []
    if kind == "Bolted Joint":
        given = float(document.value("Mesh/Refinement", "1"))
        levels = [Level(f"refinement {given * f:g}", (Entry("Mesh/Refinement", "double", f"{given * f!r}"),), 1 / f)
                  for f in MESH_FACTORS if given * f <= 20]
    elif kind == "Glued Assembly":
        cells = round(1 / float(document.value("Mesh/Cell Size", "0.5")))
        counts = [(round(cells * f), f) for f in MESH_FACTORS if cells * f >= 1 and (cells * f).is_integer()]
        levels = [Level(f"cells of 1/{n}", (Entry("Mesh/Cell Size", "double", repr(1 / n)),), 1 / f)
                  for n, f in counts if n <= 100]
    elif kind == "Boxes":
        boxes = {name: _numbers(document.value(f"Mesh/Boxes/{name}/Cells", "{}")) for name in document.names("Mesh/Boxes")}
        for f in MESH_FACTORS:
            if all(n * f >= 1 and (n * f).is_integer() for cells in boxes.values() for n in cells):
                entries = tuple(Entry(f"Mesh/Boxes/{name}/Cells", "Array(double)",
                                      "{" + ", ".join(f"{n * f:g}" for n in cells) + "}") for name, cells in boxes.items())
                levels.append(Level(f"{f:g} times the cells", entries, 1 / f))
    else:
        given_splits = int(document.value("Mesh/Refine", "0"))
        levels = [Level(f"split {n} times", (Entry("Mesh/Refine", "int", str(n)),), 2.0 ** (given_splits - n))
                  for n in range(max(0, given_splits - COARSER), min(MOST, given_splits + FINER) + 1)]
    return Knob("mesh", Role.MESH, tuple(levels), next(i for i, level in enumerate(levels) if level.size == 1.0))


def _elements(document: Document, accepts: Accepts) -> Knob:
    levels = [Level("as given", ())]
    if document.value("Mesh/Type", "") == "Bolted Joint":
        other = "Hex20" if document.value("Mesh/Element", "Hex8") == "Hex8" else "Hex8"
        candidates = [Level(other, (Entry("Mesh/Element", "string", other),), 0.5 if other == "Hex20" else 2.0)]
    elif document.value("Mesh/Element", "") in QUADRATIC:
        candidates = []
    else:
        order = 1 if document.value("Mesh/Order", "1") == "2" else 2
        candidates = [Level("quadratic" if order == 2 else "linear", (Entry("Mesh/Order", "int", str(order)),),
                            0.5 if order == 2 else 2.0)]
    for formulation in ("Incompatible Modes", "Full Integration"):
        entries = [Entry(f"Parts/{part}/Formulation", "string", formulation) for part in document.names("Parts")
                   if document.value(f"Parts/{part}/Formulation", "Full Integration") != formulation]
        taken = tuple(entries) if entries and accepts(tuple(entries)) else tuple(
            entry for entry in entries if len(entries) > 1 and accepts((entry,)))
        if taken:
            candidates.append(Level(formulation.lower(), taken))
    levels += [level for level in candidates if accepts(level.entries)]
    return Knob("elements", Role.FAMILY, tuple(levels), 0)


def _mass(document: Document) -> Knob:
    words = ("Lumped", "Consistent")
    levels = tuple(Level(word.lower(), (Entry("Solver/Interface Mass", "string", word),)) for word in words)
    return Knob("interface mass", Role.FAMILY, levels, words.index(document.value("Solver/Interface Mass", "Lumped")))


def _steps(document: Document) -> Knob:
    given = {name: int(document.value(f"Steps/{name}/Increments", "1")) for name in document.names("Steps")}
    levels: dict[tuple[int, ...], Level] = {}
    for f in STEP_FACTORS:
        counts = tuple(max(1, math.ceil(count * f)) for count in given.values())
        entries = tuple(Entry(f"Steps/{name}/Increments", "int", str(count)) for name, count in zip(given, counts))
        levels[counts] = Level(f"{sum(counts)}", entries, 1 / f)  # a later factor of the same counts is nearer to 1
    ordered = sorted(levels.values(), key=lambda level: -level.size)
    return Knob("time steps", Role.SIDE, tuple(ordered), next(i for i, level in enumerate(ordered) if level.size == 1.0))


def _accuracy(document: Document) -> Knob:
    is_study = document.study is not None
    is_chaos = document.study is not None and value_of(document.study, "Design/Type") == "Chaos"
    choices = CHAOS_ACCURACIES if is_chaos else ACCURACIES
    path = "Study/Accuracy" if is_study else "Solver/Accuracy"
    own = value_of(document.study, "Accuracy") if document.study is not None else None
    given = float(own or document.value("Solver/Accuracy", "1e-3"))
    levels = tuple(Level(f"{a:g}", (Entry(path, "double", repr(a)),), a) for a in choices)
    return Knob("accuracy", Role.SIDE, levels, min(range(len(choices)), key=lambda i: abs(math.log(choices[i] / given))))


def _pieces(elements: dict[str, int]) -> Knob:
    most = max(elements.values(), default=1)
    levels = tuple(Level(f"up to {n}" if n > 1 else "1",
                         tuple(Entry(f"Parts/{part}/Pieces", "int", str(max(1, round(n * count / most))))
                               for part, count in elements.items())) for n in PIECES)
    return Knob("pieces per part", Role.CHOICE, levels, 0)


def _order(document: Document) -> Knob:
    assert document.study is not None
    given = int(value_of(document.study, "Design/Order") or "3")
    levels = tuple(Level(str(n), (Entry("Study/Design/Order", "int", str(n)),), 1.0 / n) for n in range(1, given + 3))
    return Knob("order of chaos", Role.SIDE, levels, given - 1)


def _method(document: Document) -> Knob:
    assert document.study is not None

    def level(kind: str, local_stage: str | None, points: str | None) -> Level:
        return Level(f"{kind}, {local_stage or points}", (
            Entry("Study/Design/Type", "string", kind), Entry("Study/Design/Local Stage", "string", local_stage),
            Entry("Study/Design/Points In", "string", points), Entry("Study/Design/Tolerance", "double", None),
            Entry("Study/Design/Response", "string", None)))

    levels = (Level("as given", ()), level("Chaos", "Galerkin", None), level("Chaos", "Pseudo-Spectral", None),
              level("Collocation", None, "Tensor"), level("Collocation", None, "Sparse"))
    return Knob("method", Role.CHOICE, levels, 0)


def _numbers(text: str) -> list[float]:
    return [float(word) for word in text.strip().strip("{}").split(",") if word.strip()]
