"""Where nodes lie: axes that their coordinates count in, and instances of parts."""
import dataclasses
import math

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.findings import Refused


class Placement:
    """A translation, and behind it a rotation about a line."""

    def __init__(self, card: Card) -> None:
        """That of an *INSTANCE.

        Raises:
            Refused: the lines of the card are no placement.
        """
        move = card.table(7) if card.data else numpy.zeros((0, 7))
        if len(move) > 2:
            raise Refused(f"{card.place}: *INSTANCE takes a translation and a rotation, two lines.")
        self._shift: Array = move[0, :3] if len(move) > 0 else numpy.zeros(3)
        self._turn: "Array | None" = move[1] if len(move) > 1 else None
        if self._turn is not None and not (self._turn[3:6] - self._turn[:3]).any():
            raise Refused(f"{card.place_of(1)}: *INSTANCE: both points of the axis lie at one place.")

    def points(self, at: Array) -> Array:
        """Where points of the part lie, n x 3 [length]."""
        moved: Array = at + self._shift
        if self._turn is None:
            return moved
        one, axis = self._turn[:3], self._turn[3:6] - self._turn[:3]
        result: Array = one + rotated(moved - one, axis, math.radians(float(self._turn[6])))
        return result

    def axes(self, card: Card) -> Card:
        """An *ORIENTATION or *TRANSFORM of the part with its points where they lie."""
        if card.get("DEFINITION") not in ("", "COORDINATES") or not card.data or not _are_numbers(card.rows()[0]):
            return card
        table = card.table(9, 2)[0].reshape(3, 3)
        is_about_origin = card.keyword == "TRANSFORM" and card.get("TYPE") != "C"
        if is_about_origin:
            table = self.points(table) - self.points(numpy.zeros((1, 3)))
        else:
            table = self.points(table)
        count = 2 if card.keyword == "TRANSFORM" else 3
        line = ", ".join(f"{x:.17g}" for x in table[:count].reshape(-1))
        return dataclasses.replace(card, data=[line, *card.data[1:]])


def rotated(vectors: Array, axis: Array, angle: float) -> Array:
    """Vectors turned about an axis of any length by an angle [radians] (Rodrigues)."""
    unit = axis / float(numpy.linalg.norm(axis))
    result: Array = (vectors * math.cos(angle) + numpy.cross(unit, vectors) * math.sin(angle)
                     + numpy.outer(vectors @ unit, unit) * (1 - math.cos(angle)))
    return result


def rectangular(card: Card, at: Array) -> Array:
    """Coordinates of a *NODE card, which may be cylindrical or spherical, angles in degrees.

    Raises:
        Refused: it names another system.
    """
    system = card.get("SYSTEM") or "R"
    if system == "R":
        return at
    angle = numpy.radians(at[:, 1])
    if system == "C":
        return numpy.column_stack([at[:, 0] * numpy.cos(angle), at[:, 0] * numpy.sin(angle), at[:, 2]])
    if system == "S":
        height = numpy.radians(at[:, 2])
        result: Array = at[:, :1] * numpy.column_stack(
            [numpy.cos(angle) * numpy.cos(height), numpy.sin(angle) * numpy.cos(height), numpy.sin(height)])
        return result
    raise Refused(f"{card.place}: *NODE: SYSTEM is R, C or S, not \"{card.parameters['SYSTEM']}\".")


def _are_numbers(words: list[str]) -> bool:
    try:
        return bool([float(word.upper().replace("D", "E")) for word in words if word])
    except ValueError:
        return False
