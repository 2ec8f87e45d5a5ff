"""What a law in Python declares: its parameters, from which come the check of a scene, its messages and `harmos doc`,
and what it adds to the results."""
import dataclasses
from collections.abc import Sequence
from typing import Any


@dataclasses.dataclass(frozen=True)
class Entry:
    """A parameter of a law; number(), integer(), flag(), text() and numbers() make them.

    Attributes:
        kind: "number", "integer", "flag", "text" or "numbers".
        name: as written in scenes.
        doc: what it means, in complete sentences.
        unit: such as "stress/length"; "-" of pure numbers.
        default: of an entry that is absent; None: there is none.
        optional: may be absent, without a default; the law does not find it among its parameters then.
        varying: a number that may follow a history of the scene; the law finds a Schedule.
        at_least: the least number that is allowed; also of every one of a list.
        above: it must be more than that.
        at_most: the most.
        below: it must be less than that.
        choices: the texts that are allowed; empty: any.
    """

    kind: str
    name: str
    doc: str
    unit: str = ""
    default: Any = None
    optional: bool = False
    varying: bool = False
    at_least: float | None = None
    above: float | None = None
    at_most: float | None = None
    below: float | None = None
    choices: tuple[str, ...] = ()


def number(name: str, doc: str, unit: str = "-", default: float | None = None, optional: bool = False,
           varying: bool = False, at_least: float | None = None, above: float | None = None,
           at_most: float | None = None, below: float | None = None) -> Entry:
    """A number; required without a default, unless it is optional. Arguments as Entry has them."""
    return Entry("number", name, doc, unit, default, optional, varying, at_least, above, at_most, below)


def integer(name: str, doc: str, default: int | None = None, optional: bool = False, at_least: float | None = None,
            at_most: float | None = None) -> Entry:
    """A whole number."""
    return Entry("integer", name, doc, "-", default, optional, False, at_least, None, at_most)


def flag(name: str, doc: str, default: bool = False) -> Entry:
    """True or false."""
    return Entry("flag", name, doc, default=default)


def text(name: str, doc: str, default: str | None = None, optional: bool = False,
         choices: Sequence[str] = ()) -> Entry:
    """A text."""
    return Entry("text", name, doc, default=default, optional=optional, choices=tuple(choices))


def numbers(name: str, doc: str, unit: str = "-", optional: bool = False, at_least: float | None = None,
            above: float | None = None, at_most: float | None = None, below: float | None = None) -> Entry:
    """A list of numbers of any length; the law finds an array."""
    return Entry("numbers", name, doc, unit, None, optional, False, at_least, above, at_most, below)


@dataclasses.dataclass(frozen=True)
class Output:
    """A number per point and load step that a law adds to the results.

    Attributes:
        name: in files: small letters, digits and underscores, at most 32.
        unit: such as "length" or "-".
        doc: what it is, in a few words.
    """

    name: str
    unit: str
    doc: str
