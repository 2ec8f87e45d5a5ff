"""Amplitudes of a deck."""
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.curves import Points, Span
from harmos.exchange.findings import Findings, Refused, names_there

_TABLE = {"NAME", "TIME", "VALUE", "DEFINITION", "SHIFTX", "SHIFTY", "SMOOTH"}
"""Parameters of amplitudes that are tables."""


class Amplitudes:
    """All of a deck."""

    def __init__(self, contents: Contents, findings: Findings) -> None:
        """Finds them; those that are no tables are listed where they are asked for."""
        self._amplitudes = {card.get("NAME"): card for card in contents.model if card.keyword == "AMPLITUDE"}
        self._findings = findings

    def goes_on(self, card: Card, span: Span) -> bool:
        """Whether a card names an amplitude of the time of all steps that changes behind this one."""
        definition = self._amplitudes.get(card.get("AMPLITUDE"))
        if definition is None or not definition.get("TIME").startswith("TOTAL"):
            return False
        points = self.of(card, span)
        return points is not None and points[-1][0] > span.end - span.begin

    def of(self, card: Card, span: Span) -> "Points | None":
        """Times from the beginning of the step and factors, for what stands on a card; None: it names no amplitude.

        Raises:
            Refused: there is no such amplitude, or its numbers are no pairs.
        """
        name = card.get("AMPLITUDE")
        if not name:
            return None
        definition = self._amplitudes.get(name)
        if definition is None:
            raise Refused(f"{card.place}: there is no *AMPLITUDE \"{name}\". {names_there(name, self._amplitudes)}")
        if set(definition.parameters) - _TABLE or definition.get("DEFINITION") not in ("", "TABULAR"):
            self._findings.leave_out(definition.place, f"*AMPLITUDE {name}", "is no table: what it multiplies rises linearly")
            return None
        numbers = definition.flat()
        if len(numbers) % 2:
            raise Refused(f"{definition.place}: *AMPLITUDE takes pairs of time and value.")
        begin = span.begin if definition.get("TIME").startswith("TOTAL") else 0.0
        if definition.get("VALUE") not in ("", "RELATIVE"):
            self._findings.leave_out(definition.place, f"*AMPLITUDE {name}, VALUE={definition.get('VALUE')}", "its values multiply what refers "
                                     "to it")
        later, more = (definition.number(definition.get(each), 0) for each in ("SHIFTX", "SHIFTY"))
        later += card.number(card.get("TIMEDELAY"), 0) - begin
        return tuple((float(time) + later, float(value) + more) for time, value in numbers.reshape(-1, 2))
