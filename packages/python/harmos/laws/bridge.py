"""What the program asks of laws in Python: to load a file of them, and to ask one with arrays whose shapes are checked.

drivers/python_laws in C++ calls these functions; nothing else need.
"""
import importlib.util
import pathlib
import sys
import traceback
from collections.abc import Mapping
from typing import Any

import numpy

from harmos.arrays import Array, Floats
from harmos.laws.law import Law, Schedule, Step, Where
from harmos.laws.shapes import shaped
from harmos.laws.intersection import NoIntersection

SIDES = ("two", "one", "any")
"""What `sides` of a law may be."""
FRAMES = ("interface", "global")
"""What `frame` of a law may be."""


def load(path: str) -> list[type[Law]]:
    """The laws that a file defines, in its order. It is run once, under a name of its own; modules beside it can be
    imported.

    Raises:
        ImportError: it defines none.
        TypeError: a law is not what harmos.laws.law says.
    """
    file = pathlib.Path(path).resolve()
    name = "harmos_laws_of_" + "".join(c if c.isalnum() else "_" for c in str(file))
    if name not in sys.modules:
        if str(file.parent) not in sys.path:
            sys.path.append(str(file.parent))
        spec = importlib.util.spec_from_file_location(name, file)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        try:
            spec.loader.exec_module(module)
        except BaseException:
            del sys.modules[name]
            raise
    laws = [each for each in vars(sys.modules[name]).values()
            if isinstance(each, type) and issubclass(each, Law) and each.__module__ == name and each.name]
    if not laws:
        raise ImportError("no class in it is derived from harmos.laws.Law and has a name")
    for law in laws:
        check_declaration(law)
    return laws


def check_declaration(law: type[Law]) -> None:
    """Raises TypeError where a class does not say what it must."""
    def demand(condition: bool, what: str) -> None:
        if not condition:
            raise TypeError(f"{law.__name__}: {what}")

    demand(isinstance(law.name, str), "`name` is no text")
    demand(bool((law.__doc__ or "").strip()), "it has no docstring, which is what `harmos doc` says of it")
    demand(law.sides in SIDES, f"`sides` is {law.sides!r}, and not one of {', '.join(SIDES)}")
    demand(law.frame in FRAMES, f"`frame` is {law.frame!r}, and not one of {', '.join(FRAMES)}")
    demand(law.traction is not Law.traction or law.solve is not Law.solve, "it has neither traction() nor solve()")
    demand(not law.outputs or law.output is not Law.output, "it has `outputs` and no output()")


def made(law: type[Law], parameters: Mapping[str, Any]) -> Law:
    """A law of these parameters; lists in place of schedules and arrays are made such."""
    kinds = {entry.name: entry for entry in law.parameters}
    values: dict[str, Any] = {}
    for name, value in parameters.items():
        entry = kinds[name]
        if entry.varying:
            values[name] = Schedule(list(value))
        else:
            values[name] = numpy.array(value, dtype=float) if entry.kind == "numbers" else value
    found = law(values)
    history = found.history
    if not isinstance(history, int) or history < 0:
        raise TypeError(f"`history` is {history!r}, and no number of numbers")
    if history > 0 and law.update is Law.update:
        raise TypeError(f"it keeps {history} numbers and has no update()")
    if not found.lowest_slope <= 0.0:
        raise ValueError(f"`lowest_slope` is {found.lowest_slope!r}, and must be 0 or less")
    return found


def solved(law: Law, at: Where, free_jump: Floats, compliance: Floats, old: Floats) -> tuple[Floats, Floats, Array]:
    """Tractions, histories and states of all points, checked."""
    count = len(free_jump)
    traction = shaped(law.solve(free_jump.copy(), compliance.copy(), old.copy(), at), (count, 3), "solve()")
    jump = free_jump - compliance * traction
    history = old
    if law.history > 0:
        history = shaped(law.update(jump.copy(), traction.copy(), old.copy(), at), (count, law.history), "update()")
    states = law.status(jump, traction.copy(), old.copy(), at)
    if states is None:
        return traction, history, numpy.full(count, 3, dtype=numpy.int32)
    known = numpy.asarray(states)
    if known.shape != (count,) or not ((known >= 0) & (known <= 4)).all():
        raise ValueError(f"status() gives an array of shape {known.shape}, and must give one Status for each of {count} "
                         "points")
    return traction, history, known.astype(numpy.int32)


def stepped(law: Law, what: str, step: Step) -> Floats:
    """What "kept_work", "stored_energy" or "output" gives, checked."""
    count = len(step.jump)
    shape = (count, len(law.outputs)) if what == "output" else (count,)
    return shaped(getattr(law, what)(step), shape, f"{what}()")


def reason(error: BaseException, path: str) -> str:
    """What went wrong and where in the file, in a line."""
    text = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    if isinstance(error, SyntaxError) and error.filename and error.lineno is not None:
        return f"{type(error).__name__}: {error.msg} ({pathlib.Path(error.filename).name}, line {error.lineno})"
    file = pathlib.Path(path).resolve()
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__)
             if frame.filename and pathlib.Path(frame.filename).resolve() == file]
    return text + (f" ({file.name}, line {lines[-1]})" if lines else "")


def missed_point(error: BaseException) -> int:
    """The point that a NoIntersection names, counted from 0; -1: it is another error."""
    return error.point if isinstance(error, NoIntersection) else -1
