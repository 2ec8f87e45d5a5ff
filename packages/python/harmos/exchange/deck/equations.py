"""Equations of a deck that mean a known connection: nodes held by way of others, and nodes tied to faces."""
import collections
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.couplings import Couplings
from harmos.exchange.deck.curves import Points
from harmos.exchange.deck.scopes import Scope
from harmos.exchange.deck.solids import Solids
from harmos.exchange.findings import Findings, Refusals, Refused

SAME = 1e-4
"""Differences of coefficients, over the first, and of places, over the size of the mesh, that count as none: decks have six
digits."""

Degree = tuple[int, int]
"""A node (index in the mesh) and a component from 0."""


@dataclasses.dataclass
class Equation:
    """Coefficients times displacements add up to 0.

    Attributes:
        card: it stands on.
        terms: node, component and coefficient; the first is what the deck makes depend on the others.
    """
    card: Card
    terms: list[tuple[int, int, float]]

    @property
    def is_equal_pair(self) -> bool:
        """Whether it says that two displacements are equal."""
        return len(self.terms) == 2 and abs(self.terms[0][2] + self.terms[1][2]) <= SAME * abs(self.terms[0][2])


@dataclasses.dataclass
class Tie:
    """Nodes of one part that move as points of the faces of another.

    Attributes:
        card: of the first of its equations.
        parts: their names, that of the tied nodes first.
        sides: side sets of both.
    """
    card: Card
    parts: tuple[str, str]
    sides: tuple[Array, Array]


class Equations:
    """All equations of a deck."""

    def __init__(self, contents: Contents, solids: Solids, findings: Findings) -> None:
        """Reads them.

        Raises:
            Refused: numbers or nodes are not there.
        """
        self._contents, self._solids, self._findings = contents, solids, findings
        self._all: list[Equation] = []
        self._turned = {int(node) for card in contents.model if card.keyword == "TRANSFORM"
                        for ids in contents.node_sets.get(card.get("NSET"), []) for node in self._solids.nodes(ids)}
        refusals = Refusals()
        for card in contents.model:
            if card.keyword != "EQUATION":
                continue
            if "REMOVE" in card.parameters:
                findings.leave_out(card.place, "*EQUATION, REMOVE", "the equations stay")
                continue
            with refusals.collect():
                self._read(card)
        refusals.raise_if_any()

    def nodes(self) -> set[int]:
        """Those that they join, in solids or not."""
        return {node for equation in self._all for node, _, _ in equation.terms}

    def _read(self, card: Card) -> None:
        words = [(word, row) for row, listed in enumerate(card.rows()) for word in listed if word]
        at = 0
        while at < len(words):
            count = int(card.number(*words[at]))
            terms = words[at + 1:at + 1 + 3 * count]
            if count < 1 or len(terms) < 3 * count:
                raise Refused(f"{card.place_of(words[at][1])}: *EQUATION takes a number of terms, and for each a node, a component "
                              "and a coefficient; the deck is truncated or damaged.")
            at += 1 + 3 * count
            nodes = [self._node(card, *terms[3 * k]) for k in range(count)]
            components = [int(card.number(*terms[3 * k + 1])) - 1 for k in range(count)]
            coefficients = [card.number(*terms[3 * k + 2]) for k in range(count)]
            if None in nodes or coefficients[0] == 0.0:
                self._findings.leave_out(card.place_of(terms[0][1]), "*EQUATION", "of node sets, or without a first coefficient: "
                                         "nodes that it ties move as they like")
                continue
            self._all.append(Equation(card, [(int(node), component, coefficient) for node, component, coefficient
                                             in zip(nodes, components, coefficients) if node is not None]))

    def _node(self, card: Card, word: str, row: int) -> "int | None":
        """Index in the mesh; nothing for sets of several nodes."""
        ids = self._contents.ids(word, self._contents.node_sets, Scope(), card, row)
        known = self._contents.node_ids
        if len(ids) != 1:
            return None
        at = int(numpy.searchsorted(known, ids[0]))
        if at >= len(known) or known[at] != ids[0]:
            raise Refused(f"{card.place_of(row)}: *EQUATION: node {word} is nowhere in the deck.")
        return at

    def apply(self, held: dict[Degree, Points], couplings: Couplings) -> list[Tie]:
        """Holds what moves as something that is held, reference nodes of couplings as well, takes nodes of no solid out of
        `held`, and gives the ties; what is left, as equations of nodes whose displacements mean something else, is listed."""
        bolts = {self._contents.single_node(card, "NODE") for card in self._contents.model
                 if card.keyword == "PRE-TENSIONSECTION" and card.get("NODE")}
        turns = {node for node, (_, first) in couplings.at_node.items() if first != 0}
        others = {int(numpy.searchsorted(self._contents.node_ids, node)) for node in bolts | turns}
        references = {int(numpy.searchsorted(self._contents.node_ids, node)): coupling
                      for node, (coupling, first) in couplings.at_node.items() if first == 0}
        for node, coupling in references.items():
            held.update({(node, component): points for component, points in coupling.held.items() if component < 3})
        left = self._hold(held, self._turned | others)
        for node, coupling in references.items():
            coupling.held.update({component: held[node, component] for component in range(3) if (node, component) in held})
        ties, left = self._ties(left)
        of_solids = set(self._solids.used_nodes().tolist())
        for node, component in [degree for degree in held if degree[0] not in of_solids]:
            del held[node, component]
        if left:
            cards = list(dict.fromkeys(equation.card.place for equation in left))
            more = f", here and in {len(cards) - 1} further cards" if len(cards) > 1 else ""
            self._findings.leave_out(cards[0], "*EQUATION", f"{len(left)} of {len(self._all)} equations{more}: nodes that they tie "
                                     "move as they like")
        return ties

    def _hold(self, held: dict[Degree, Points], others: set[int]) -> list[Equation]:
        """The equations that do not follow from what is held then; `others`: nodes whose displacements mean something else."""
        waiting = [equation for equation in self._all
                   if equation.is_equal_pair and not others & {node for node, _, _ in equation.terms}]
        done: set[int] = set()
        is_changed = True
        while is_changed:
            is_changed = False
            for equation in waiting:
                one, other = ((node, component) for node, component, _ in equation.terms)
                if id(equation) in done or (one in held) == (other in held):
                    continue
                held.setdefault(one, held.get(other, ()))
                held.setdefault(other, held[one])
                done.add(id(equation))
                is_changed = True
        for equation in waiting:
            one, other = ((node, component) for node, component, _ in equation.terms)
            if one in held and held.get(one) == held.get(other):
                done.add(id(equation))
        if done:
            self._findings.found.append(f"{len(done)} equations between equal displacements, of which one is held: both are held")
        return [equation for equation in self._all if id(equation) not in done]

    def _ties(self, equations: list[Equation]) -> tuple[list[Tie], list[Equation]]:
        """Ties of what says that nodes move as points of faces, and the equations that are none of them."""
        dimension = self._solids.mesh.dimension
        by_node: dict[int, dict[int, Equation]] = collections.defaultdict(dict)
        for equation in equations:
            node, component, _ = equation.terms[0]
            if component < dimension and self._is_point_of_a_face(equation):
                by_node[node][component] = equation
        complete = {node: of_node for node, of_node in by_node.items() if len(of_node) == dimension}
        groups: dict[tuple[str, str], list[int]] = collections.defaultdict(list)
        for node, of_node in complete.items():
            one = self._solids.parts_of(numpy.array([node]))
            other = self._solids.parts_of(numpy.array([each for each, _, _ in of_node[0].terms[1:]]))
            if len(one) == 1 and len(other) == 1 and one != other:
                groups[one.pop(), other.pop()].append(node)
        ties, done = [], set()
        for (part, other_part), nodes in groups.items():
            masters = [node for tied in nodes for node, _, _ in complete[tied][0].terms[1:]]
            sides = (self._solids.faces_on(numpy.array(nodes), part), self._solids.faces_on(numpy.array(masters), other_part))
            if not len(sides[0]) or not len(sides[1]):
                continue
            loose = set(nodes) - set(self._solids.nodes_of_sides(sides[0]).tolist())
            if loose:
                self._findings.leave_out(complete[nodes[0]][0].card.place, "*EQUATION", f"{len(loose)} nodes of {part} that equations tie to "
                                         f"{other_part} are on no face whose corners they all tie: they move as they like")
            ties.append(Tie(complete[nodes[0]][0].card, (part, other_part), sides))
            done |= {id(equation) for node in nodes for equation in complete[node].values()}
        return ties, [equation for equation in equations if id(equation) not in done]

    def _is_point_of_a_face(self, equation: Equation) -> bool:
        """Whether the first displacement is the same component of others, weighed so that every linear field is met."""
        (node, component, coefficient), *others = equation.terms
        if any(each != component for _, each, _ in others) or self._turned & {each for each, _, _ in equation.terms}:
            return False
        weights = numpy.array([-each / coefficient for _, _, each in others])
        places = self._solids.mesh.nodes[[other for other, _, _ in others]]
        size = float(numpy.ptp(self._solids.mesh.nodes, axis=0).max())
        return bool(abs(weights.sum() - 1.0) <= SAME
                    and numpy.abs(weights @ places - self._solids.mesh.nodes[node]).max() <= SAME * size)
