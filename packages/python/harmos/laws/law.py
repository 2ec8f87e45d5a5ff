"""What a law in Python gives, and what it sees.

Signs and frames are those of all laws (docs/guide/embedding.md): the normal points from side 1 to side 2, the jump is
w2 - w1, the traction that on side 1; columns are n, t1, t2, or x, y, z of a law whose frame is "global". All arrays have
a row per point; points do not see each other. What a law is given are copies.
"""
import dataclasses
import enum
from collections.abc import Mapping
from typing import Any, ClassVar

from harmos.arrays import Array, Floats
from harmos.laws.declaration import Entry, Output
from harmos.laws.intersection import resolvent
from harmos.laws.shapes import shaped

Parameters = Mapping[str, Any]
"""The checked values of a law by name, defaults filled in: float, int, bool, str, array, or Schedule of a number that
varies."""


class Status(enum.IntEnum):
    """What a point does: open, sticking, slipping, bonded, or broken, which was bonded.

    Attributes:
        OPEN: the sides are apart.
        STICK: in contact, without sliding over the load step.
        SLIP: in contact, sliding or free to slide.
        BONDED: joined, by springs too; also all of a law that knows no states.
        BROKEN: was bonded.
    """

    OPEN = 0
    STICK = 1
    SLIP = 2
    BONDED = 3
    BROKEN = 4


class Schedule:
    """A number at every load step: schedule[at.step], with its history multiplied in."""

    def __init__(self, values: list[float]) -> None:
        """`values`: one per load step, or one for all of them."""
        self._values = values

    def __getitem__(self, step: int) -> float:
        """At a load step, counted from 0."""
        return self._values[0] if len(self._values) == 1 else self._values[step]


@dataclasses.dataclass(frozen=True)
class Where:
    """Where and when a law is asked: n points at one load step.

    Attributes:
        step: load step, counted from 0.
        time: end of the load step.
        duration: of the load step; 0: not known.
        gap: geometric opening of the undeformed surfaces, (n,).
        position: undeformed places in x, y, z, (n, 3).
        frame: axes n, t1, t2 as rows in x, y, z, (n, 3, 3).
        area: shares of the surface, (n,).
        number: of the points in their interface, counted from 0, (n,).
    """

    step: int
    time: float
    duration: float
    gap: Floats
    position: Floats
    frame: Floats
    area: Floats
    number: Array


@dataclasses.dataclass(frozen=True)
class Step:
    """A load step of n points: how they were at its beginning and at its end.

    Attributes:
        old_jump: at the end of the load step before, (n, 3).
        jump: at the end of this one, (n, 3).
        traction: at the end of this one, (n, 3).
        old: the history at the end of the load step before, (n, history).
        history: at the end of this one, (n, history).
        at: where and when.
    """

    old_jump: Floats
    jump: Floats
    traction: Floats
    old: Floats
    history: Floats
    at: Where


class Law:
    """The behaviour of an interface: which traction belongs to which jump. To be derived from.

    A law gives traction(), or solve() where the traction is no function of the jump, as in contact. What it raises ends
    the check or the run with its message, the interface and the line of the file.

    Attributes:
        name: as written in scenes; unique among all laws.
        parameters: what number() and the like declare.
        history: numbers that every point keeps between load steps; 0 at the unloaded start.
        sides: "two" bodies, "one" body and the ground, or "any".
        frame: "interface" for n, t1, t2, or "global" for x, y, z.
        source: where it comes from.
        equation: what it does, in a line.
        dissipates: work that is done on it is reported as dissipation, less kept_work().
        smooth: the traction has no kinks.
        affine: without memory, and t_i = k_i delta_i + c_i at every load step, the same at all points.
        lowest_slope: the steepest fall of the traction over the jump [stress/length], 0 or less; 0: it never falls.
            May be set in the constructor.
        outputs: what output() adds to the results.
    """

    name: ClassVar[str] = ""
    parameters: ClassVar[tuple[Entry, ...]] = ()
    history: int = 0
    sides: ClassVar[str] = "two"
    frame: ClassVar[str] = "interface"
    source: ClassVar[str] = ""
    equation: ClassVar[str] = ""
    dissipates: ClassVar[bool] = False
    smooth: ClassVar[bool] = False
    affine: ClassVar[bool] = False
    lowest_slope: float = 0.0
    outputs: ClassVar[tuple[Output, ...]] = ()

    def __init__(self, p: Parameters) -> None:
        """Copies what it needs of its checked parameters. Raises ValueError where they do not go together: the check of
        a scene reports it."""

    def traction(self, jump: Floats, old: Floats, at: Where) -> Floats:
        """The graph: tractions [stress], (n, 3), that belong to jumps [length], (n, 3), with the history `old`,
        (n, history), of the load step before."""
        raise NotImplementedError(f"{type(self).__name__} has neither traction() nor solve()")

    def solve(self, free_jump: Floats, compliance: Floats, old: Floats, at: Where) -> Floats:
        """The tractions, (n, 3), at which the graph meets the lines jump = free_jump - compliance * traction;
        free_jump [length], (n, 3), compliance [length/stress], (n, 1), above 0.

        Without a solve() of its own, harmos.laws.intersection.resolvent() finds them of traction().
        """
        def graph(jump: Floats) -> Floats:
            given = self.traction(jump.copy(), old.copy(), at)
            return shaped(given, jump.shape, "traction()").copy()  # it may be an array that the law fills again

        return resolvent(graph, free_jump, compliance)

    def update(self, jump: Floats, traction: Floats, old: Floats, at: Where) -> Floats:
        """The history at the end of the load step, (n, history). A load step is asked for many times: always begin from
        `old`. To be given where there is a history."""
        raise NotImplementedError(f"{type(self).__name__} keeps {self.history} numbers and has no update()")

    def status(self, jump: Floats, traction: Floats, old: Floats, at: Where) -> Array | None:
        """What the points do at the end of the load step, Status, (n,); None: all are bonded."""
        return None

    def admissible(self, step: int) -> tuple[Any, Any, float] | None:
        """What it can carry at a load step, whatever the jump: the least and the largest traction, three numbers each,
        and how much of |t_t| per pressure goes beyond. None: not known."""
        return None

    def kept_work(self, step: Step) -> Floats:
        """Of the work t.(jump - old_jump) what is not lost [stress length], (n,); 0. Asked where it dissipates."""
        return step.jump[:, 0] * 0.0

    def stored_energy(self, step: Step) -> Floats:
        """Free energy of its springs [stress length], (n,); 0."""
        return step.jump[:, 0] * 0.0

    def output(self, step: Step) -> Floats:
        """The numbers of `outputs`, (n, number of outputs)."""
        raise NotImplementedError(f"{type(self).__name__} has outputs and no output()")
