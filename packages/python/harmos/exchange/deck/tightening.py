"""Bolts of a deck that are tightened at the reference nodes of their pretension sections."""
import dataclasses

from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.curves import UNLOADED, Course, Span, followed
from harmos.exchange.deck.loads import Preload
from harmos.exchange.findings import Findings


class Tightening:
    """Of all bolts.

    Attributes:
        nodes: ids of the reference nodes.
    """

    def __init__(self, contents: Contents, preloads: dict[int, Preload], findings: Findings) -> None:
        """Adds to the preloads, by the ids of the reference nodes."""
        self.nodes = {contents.single_node(card, "NODE") for card in contents.model
                      if card.keyword == "PRE-TENSIONSECTION" and card.get("NODE")}
        self._preloads, self._findings = preloads, findings

    def is_free(self, node: int) -> bool:
        """Whether nothing has acted on a bolt yet."""
        return node not in self._preloads

    def draw(self, node: int, card: Card, row: int, course: Course, value: float) -> None:
        """A displacement of the reference node of a pretension section; FIXED, or 0 after a force, locks the bolt."""
        preload = self._preloads.get(node, Preload())
        if preload.is_force:
            if "FIXED" not in card.parameters and value != 0.0:
                self._findings.leave_out(card.place_of(row), "*BOUNDARY of a pretension section",
                                         f"{value:g}, after a force: the bolt keeps what that has drawn together")
            if preload.locked is None:
                self._preloads[node] = dataclasses.replace(preload, locked=course.span.begin)
        elif "FIXED" not in card.parameters:
            self._preloads[node] = Preload(course.followed(preload.points, value))

    def force(self, node: int, card: Card, row: int, course: Course, value: float) -> None:
        """A force on the reference node of a pretension section."""
        preload = self._preloads.get(node, Preload())
        if preload.locked is not None or (not preload.is_force and preload.points != UNLOADED):
            self._findings.leave_out(card.place_of(row), "*CLOAD on a pretension section",
                                     f"{value:g}, after the bolt was locked or drawn together: it keeps that")
            return
        self._preloads[node] = Preload(course.followed(preload.points, value), True)

    def release(self, span: Span) -> None:
        """Lets the forces of bolts that are not locked go to 0 over a step."""
        for node, preload in self._preloads.items():
            if preload.is_force and preload.locked is None:
                self._preloads[node] = dataclasses.replace(preload, points=followed(preload.points, span, 0.0, None, False))
