"""What the readers of boundaries and loads share."""
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.couplings import Couplings
from harmos.exchange.deck.loads import Loads
from harmos.exchange.deck.scopes import Scope
from harmos.exchange.deck.solids import Solids, is_solid
from harmos.exchange.deck.tightening import Tightening
from harmos.exchange.deck.transforms import Transforms
from harmos.exchange.findings import Findings


@dataclasses.dataclass
class Acting:
    """A deck, and what has been found to act so far.

    Attributes:
        contents: of the deck.
        solids: of it.
        couplings: whose reference nodes take what acts on them.
        transforms: axes of nodes.
        tightening: of bolts, by their reference nodes.
        loads: that are added to.
        findings: that are added to.
    """
    contents: Contents
    solids: Solids
    couplings: Couplings
    transforms: Transforms
    tightening: Tightening
    loads: Loads
    findings: Findings

    def nodes(self, word: str, card: Card, row: int) -> Array:
        """Ids of a node or of a node set that a line names."""
        return self.contents.ids(word, self.contents.node_sets, Scope(), card, row)

    def elements(self, word: str, card: Card, row: int) -> Array:
        """Ids of an element or of an element set; of all solids where the line names none."""
        if not word:
            return numpy.concatenate([table.ids for table in self.contents.elements if is_solid(table.kind)])
        return self.contents.ids(word, self.contents.element_sets, Scope(), card, row)

    def divided(self, ids: Array) -> tuple[Array, list[int]]:
        """The nodes that are no reference of a coupling, and those that are."""
        is_reference = numpy.isin(ids, list(self.couplings.at_node))
        return ids[~is_reference], ids[is_reference].tolist()
