"""Axes of materials of a deck (*ORIENTATION)."""
import math

import numpy

from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.placement import rotated
from harmos.exchange.findings import Findings, Refused, names_there


class Orientations:
    """All of a deck."""

    def __init__(self, cards: list[Card], findings: Findings) -> None:
        """Finds those of the model."""
        self._cards = {card.get("NAME"): card for card in cards if card.keyword == "ORIENTATION"}
        self._findings = findings

    def axes(self, name: str, section: Card) -> "tuple[list[float], list[float]] | None":
        """Directions of the first and the second axis; None: the section names none, or axes that Harmos has not, which are listed.

        Raises:
            Refused: there is no such orientation, or its points make no axes.
        """
        if not name:
            return None
        card = self._cards.get(name)
        if card is None:
            raise Refused(f"{section.place}: there is no *ORIENTATION \"{name}\". {names_there(name, self._cards)}")
        for switch, known in (("SYSTEM", ("", "R", "RECTANGULAR")), ("DEFINITION", ("", "COORDINATES"))):
            if card.get(switch) not in known:
                self._findings.leave_out(card.place, f"*ORIENTATION, {switch}={card.get(switch)}", "axes that turn from point to point, or "
                                         "follow nodes: the global ones are taken")
                return None
        words = [word for word in card.rows()[0] if word] if card.data else []
        if len(words) == 1:
            self._findings.leave_out(card.place, "*ORIENTATION", f"the axes of the distribution \"{words[0]}\", which differ from element to "
                                     "element: the global ones are taken")
            return None
        if len(words) < 6:
            raise Refused(f"{card.place_of(0)}: *ORIENTATION takes the coordinates of two points.")
        first, second, origin = (numpy.array([card.number(word, 0) for word in ([*card.rows()[0], *[""] * 9])[:9]])).reshape(3, 3)
        one, other = first - origin, second - origin
        third = numpy.cross(one, other)
        if not numpy.linalg.norm(third) > 1e-9 * float(numpy.linalg.norm(one)) * float(numpy.linalg.norm(other)):
            raise Refused(f"{card.place_of(0)}: *ORIENTATION: both points lie on one line with the origin of its axes.")
        rows = numpy.array([one, numpy.cross(third, one), third])
        rows /= numpy.linalg.norm(rows, axis=1)[:, None]
        if len(card.data) > 1:
            words = card.rows()[1]
            about, angle = int(card.number(words[0], 1)) or 1, card.number(words[1], 1) if len(words) > 1 else 0.0
            if not 1 <= about <= 3:
                raise Refused(f"{card.place_of(1)}: *ORIENTATION turns about axis 1, 2 or 3.")
            rows = rotated(rows, rows[about - 1], math.radians(angle))
        one, other = ([round(float(x), 15) + 0.0 for x in row] for row in rows[:2])
        return one, other
