"""Springs of a deck between the reference node of a coupling and the ground."""
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents, ElementTable
from harmos.exchange.deck.couplings import Couplings
from harmos.exchange.deck.kinds import SPRINGS
from harmos.exchange.deck.scopes import Scope
from harmos.exchange.findings import Findings, Refused

ALONG = 1e-3
"""Difference of the cosine with a global axis from 1 that counts as none: decks have few digits."""


class Springs:
    """All springs of a deck.

    Attributes:
        ground: ids of the nodes at which those that were taken end, all held.
    """

    def __init__(self, contents: Contents, couplings: Couplings, findings: Findings) -> None:
        """Gives the couplings their springs; all others are listed.

        Raises:
            Refused: a *SPRING lacks a number.
        """
        self._contents, self._couplings, self._findings = contents, couplings, findings
        self.ground: set[int] = set()
        self._held = self._held_nodes()
        laws = [card for card in contents.model if card.keyword == "SPRING"]
        law_of = {int(element): number for number, card in enumerate(laws)
                  for table in contents.elements_of(card.get("ELSET")) for element in table.ids}
        for table in contents.elements:
            if table.kind not in SPRINGS:
                continue
            numbers = numpy.array([law_of.get(int(element), -1) for element in table.ids], dtype=numpy.int64)
            for number in numpy.unique(numbers).tolist():
                rows = numbers == number
                own = dataclasses.replace(table, ids=table.ids[rows], nodes=table.nodes[rows])
                self._read(own, laws[number] if number >= 0 else None)

    def _held_nodes(self) -> set[int]:
        """Ids of nodes that the model, or a step, holds at 0 in all directions."""
        held: dict[int, set[int]] = {}
        moved: set[int] = set()
        for card in [*self._contents.model, *(card for step in self._contents.steps for card in step.cards)]:
            for row, words in enumerate(card.rows() if card.keyword == "BOUNDARY" else []):
                word = words[0].strip()
                if not word.isdecimal() and word.upper() not in self._contents.node_sets:
                    continue
                ids = self._contents.ids(word, self._contents.node_sets, Scope(), card, row).tolist()
                named = words[1].upper() if len(words) > 1 else ""
                if named in ("ENCASTRE", "PINNED"):
                    components = {1, 2, 3}
                elif named.isdecimal():
                    last = words[2] if len(words) > 2 and words[2] else named
                    components = set(range(int(named), int(card.number(last, row)) + 1))
                else:
                    continue
                if len(words) > 3 and card.number(words[3], row) != 0.0:
                    moved.update(ids)
                for node in ids:
                    held.setdefault(node, set()).update(components)
        return {node for node, components in held.items() if {1, 2, 3} <= components} - moved

    def _read(self, table: ElementTable, law: "Card | None") -> None:
        if law is None or "NONLINEAR" in law.parameters:
            self._list(table, "its *SPRING is nonlinear" if law else "no *SPRING names a set that they are in")
            return
        rows = [(row, [word for word in words if word]) for row, words in enumerate(law.rows()) if any(words)]
        if len(rows) < (1 if table.kind == "SPRINGA" else 2):
            raise Refused(f"{law.place}: *SPRING takes {'a blank line' if table.kind == 'SPRINGA' else 'a line of components'}, and a "
                          "line with the stiffness.")
        stiffness = law.number(rows[-1][1][0], rows[-1][0])
        components = [] if table.kind == "SPRINGA" else [int(law.number(word, rows[0][0])) for word in rows[0][1]]
        left = [why for why in (self._add(nodes, components, stiffness, table.kind) for nodes in table.nodes) if why]
        if left:
            self._list(table, left[0], len(left))

    def _list(self, table: ElementTable, why: str, count: int = 0) -> None:
        self._findings.leave_out(table.card.place, f"*ELEMENT, TYPE={table.kind}",
                                 f"{count or len(table.ids)} springs are left out: {why}")

    def _add(self, nodes: Array, components: list[int], stiffness: float, kind: str) -> str:
        """Adds a spring to the coupling of its node; why not, where it cannot."""
        ends = [int(node) for node in nodes]
        own = [node for node in ends if node in self._couplings.at_node]
        if len(own) != 1:
            return "Harmos has springs between the reference node of a coupling and the ground"
        other = [node for node in ends if node != own[0]]
        if other and other[0] not in self._held:
            return f"node {other[0]} at its other end is not held at 0"
        coupling, first = self._couplings.at_node[own[0]]
        if kind == "SPRINGA":
            axis = self._axis(own[0], other[0])
            if axis is None:
                return "it lies along no global axis"
            components = [axis + 1]
        if len(set(components)) != 1 or not 1 <= components[0] <= 6 - first:
            return "it joins different components"
        component = components[0] - 1 + first
        coupling.springs[component] = coupling.springs.get(component, 0.0) + stiffness
        self.ground.update(other)
        return ""

    def _axis(self, one: int, other: int) -> "int | None":
        """The global axis along which two nodes lie."""
        at = [self._contents.coordinates[int(numpy.flatnonzero(self._contents.node_ids == node)[0])] for node in (one, other)]
        way = numpy.abs(at[1] - at[0])
        length = float(numpy.linalg.norm(way))
        axis = int(way.argmax())
        return axis if length > 0.0 and way[axis] >= (1.0 - ALONG) * length else None
