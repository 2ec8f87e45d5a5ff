"""What the names and numbers of a card mean: those of the deck, or of an instance of a part in it."""
import dataclasses
from collections.abc import Container

from harmos.exchange.deck.cards import Card

INSTANCE_OFFSET = 10_000_000_000
"""Between the numbers of nodes and elements of one instance and the next; those of the assembly come before."""

_REFERENCES = {"COUPLING": ("REFNODE",), "RIGIDBODY": ("REFNODE", "ROTNODE"), "PRE-TENSIONSECTION": ("NODE",)}
"""Parameters that name a node, by its number or by a set, by keyword."""


@dataclasses.dataclass
class Scope:
    """What names refer to: the deck, or an instance of a part in it.

    Attributes:
        prefix: of names of sets.
        offset: of ids.
    """
    prefix: str = ""
    offset: int = 0

    def card(self, card: Card, axes: set[str], node_sets: Container[str]) -> Card:
        """A card of the part as the deck knows it; `axes`: orientations of the part, `node_sets`: of the deck, in capitals."""
        return dataclasses.replace(card, parameters=self._parameters(card, axes), data=self._data(card, node_sets))

    def _parameters(self, card: Card, axes: set[str]) -> dict[str, str]:
        """Parameters with names of sets, of axes and of nodes."""
        references = _REFERENCES.get(card.keyword, ())

        def scoped(name: str, value: str) -> str:
            if name in references and value.lstrip("+").isdecimal():
                return str(int(value) + self.offset)
            is_axes = value.upper() in axes and (name == "ORIENTATION" or (card.keyword == "ORIENTATION" and name == "NAME"))
            return self.prefix + value if value and (is_axes or name in ("ELSET", "NSET", "SURFACE", *references)) else value

        return {name: scoped(name, value) for name, value in card.parameters.items()}

    def _data(self, card: Card, node_sets: Container[str]) -> list[str]:
        """Lines of data with nodes, by numbers and sets."""
        if card.keyword not in ("EQUATION", "BOUNDARY", "DISTRIBUTINGCOUPLING"):
            return card.data

        def named(word: str) -> str:
            if word.lstrip("+").isdecimal():
                return str(int(word) + self.offset)
            return self.prefix + word if (self.prefix + word).upper() in node_sets else word

        rows = card.rows()
        if card.keyword != "EQUATION":
            return [", ".join([named(words[0]), *words[1:]]) for words in rows]
        waiting = 0  # words of an equation that come yet
        for row, words in enumerate(rows):
            for at, word in enumerate(words):
                if word and not waiting:
                    waiting = 3 * int(card.number(word, row))
                elif word:
                    words[at] = named(word) if waiting % 3 == 0 else word
                    waiting -= 1
        return [", ".join(words) for words in rows]
