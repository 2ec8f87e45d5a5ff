"""What a deck holds, names resolved: nodes, elements, sets, surfaces, physics, steps."""
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import LARGEST_ID, Card
from harmos.exchange.deck.kinds import nodes_of_kind
from harmos.exchange.deck.placement import Placement, rectangular
from harmos.exchange.deck.scopes import INSTANCE_OFFSET, Scope
from harmos.exchange.findings import Findings, Refusals, Refused, names_there

LARGEST_RANGE = 50_000_000
"""Numbers that a range may have: ten times the nodes of the largest mesh that fits into the memory of this import."""


@dataclasses.dataclass
class ElementTable:
    """Elements of a card.

    Attributes:
        kind: the type as the deck calls it.
        ids: of the elements.
        nodes: their ids, a row per element, in the order of the deck.
        set: that the card names; may be empty.
        card: it stands on.
    """
    kind: str
    ids: Array
    nodes: Array
    set: str
    card: Card


@dataclasses.dataclass
class Surface:
    """A surface.

    Attributes:
        of_nodes: it is given by nodes, not by faces.
        rows: element ids and labels of faces, or node ids and empty labels.
        card: it stands on.
    """
    of_nodes: bool
    rows: list[tuple[Array, str]]
    card: Card


@dataclasses.dataclass
class Step:
    """A step of the deck.

    Attributes:
        card: it stands on.
        cards: in it.
    """
    card: Card
    cards: list[Card] = dataclasses.field(default_factory=list)


class Contents:
    """A deck.

    Attributes:
        node_ids: of all nodes.
        coordinates: of them.
        elements: as they stand.
        node_sets: ids by name in capitals.
        element_sets: the same.
        set_places: FILE:LINE where element sets that are not internal first stand, by name.
        surfaces: by name.
        model: cards of physics before the first step, in their order.
        steps: in their order.
    """

    def __init__(self, cards: list[Card], findings: Findings) -> None:
        """Reads the cards; what instances stand for is copied."""
        self.node_ids: Array = numpy.zeros(0, dtype=numpy.int64)
        self.coordinates: Array = numpy.zeros((0, 3))
        self.elements: list[ElementTable] = []
        self.node_sets: dict[str, list[Array]] = {}
        self.element_sets: dict[str, list[Array]] = {}
        self.set_places: dict[str, str] = {}
        self.surfaces: dict[str, Surface] = {}
        self._written: dict[str, str] = {}
        self.model: list[Card] = []
        self.steps: list[Step] = []
        self._findings = findings
        self._nodes: list[tuple[Array, Array]] = []
        self._parts: dict[str, list[Card]] = {}
        self._instances: dict[str, Scope] = {}
        self._refusals = Refusals()
        self._read(cards)
        self._refusals.raise_if_any()
        self._demand_single_elements()
        self._gather_nodes()

    def written(self, name: str) -> str:
        """The name of a set or surface, in capitals here, as the deck writes it."""
        return self._written.get(name, name)

    def elements_of(self, name: str) -> list[ElementTable]:
        """The elements of a set, in capitals here: of each card those that are in it."""
        if name not in self.element_sets:
            return []
        held = numpy.concatenate([numpy.zeros(0, dtype=numpy.int64), *self.element_sets[name]])
        inside = [(table, numpy.isin(table.ids, held)) for table in self.elements]
        return [dataclasses.replace(table, ids=table.ids[rows], nodes=table.nodes[rows]) for table, rows in inside if rows.any()]

    def _read(self, cards: list[Card]) -> None:
        at = 0
        scope = Scope()
        while at < len(cards):
            card = cards[at]
            if card.keyword == "PART":
                end = self._end(cards, at, "ENDPART")
                self._parts[card.get("NAME")] = cards[at + 1:end]
                at = end + 1
                continue
            if card.keyword == "INSTANCE":
                end = self._end(cards, at, "ENDINSTANCE")
                with self._refusals.collect():
                    self._place(card, cards[at + 1:end])
                at = end + 1
                continue
            if card.keyword == "STEP" and at == len(cards) - 1:
                self._findings.leave_out(card.place, "*STEP", "the deck ends behind it: there is nothing in this step")
                break
            if card.keyword == "STEP":
                end = self._end(cards, at, "ENDSTEP")
                step = Step(card)
                for each in cards[at + 1:end]:
                    with self._refusals.collect():
                        if each.keyword not in ("NSET", "ELSET", "SURFACE") or not self._take(each, scope):
                            step.cards.append(each)
                self.steps.append(step)
                at = end + 1
                continue
            with self._refusals.collect():
                if card.keyword not in ("ASSEMBLY", "ENDASSEMBLY") and not self._take(card, scope):
                    self.model.append(card)
            at += 1

    @staticmethod
    def _end(cards: list[Card], start: int, keyword: str) -> int:
        for at in range(start + 1, len(cards)):
            if cards[at].keyword == keyword:
                return at
        raise Refused(f"{cards[start].place}: *{cards[start].keyword} does not end: there is no *{keyword}. The deck is "
                      "truncated.")

    def _place(self, card: Card, own: list[Card]) -> None:
        """Copies a part to where its instance is."""
        part = self._parts.get(card.get("PART"))
        if part is None:
            raise Refused(f"{card.place}: *INSTANCE of the part \"{card.get('PART')}\", which is not above. "
                          f"{names_there(card.get('PART'), self._parts)}")
        name = card.get("NAME")
        scope = Scope(f"{name}.", INSTANCE_OFFSET * (1 + len(self._instances)))
        self._instances[name] = scope
        before = len(self._nodes)
        placement = Placement(card)
        axes = {each.get("NAME") for each in part if each.keyword == "ORIENTATION"}
        for each in [*part, *own]:
            if each.keyword in ("ORIENTATION", "TRANSFORM"):
                each = placement.axes(each)
            if not self._take(each, scope):
                self.model.append(scope.card(each, axes, self.node_sets))
        for number in range(before, len(self._nodes)):
            ids, at = self._nodes[number]
            self._nodes[number] = ids, placement.points(at)

    def _take(self, card: Card, scope: Scope) -> bool:
        """Takes what is geometry; whether it was."""
        for parameter in ("NSET", "ELSET", "NAME"):
            if card.keyword in ("NODE", "ELEMENT", "NSET", "ELSET", "SURFACE") and card.get(parameter):
                self._written.setdefault(scope.prefix + card.get(parameter), scope.prefix + card.parameters[parameter])
        if card.keyword in ("ELEMENT", "ELSET") and card.get("ELSET") and "INTERNAL" not in card.parameters:
            self.set_places.setdefault(scope.prefix + card.get("ELSET"), card.place)
        if card.keyword == "NODE" and card.data:
            table = card.table(4)
            ids = card.ids(table[:, 0]) + scope.offset
            at = table[:, 1:4]
            self._nodes.append((ids, rectangular(card, at)))
            self._add(self.node_sets, card.get("NSET"), scope, ids)
        elif card.keyword == "NODE":
            pass
        elif card.keyword == "ELEMENT":
            self._take_elements(card, scope)
        elif card.keyword in ("NSET", "ELSET"):
            sets = self.node_sets if card.keyword == "NSET" else self.element_sets
            name = card.get(card.keyword)
            if not name:
                raise Refused(f"{card.place}: *{card.keyword} without a name: {card.keyword}=NAME.")
            inside = self._scope(card, scope)
            for ids in self._of_elements(card, inside) if card.get("ELSET") and card.keyword == "NSET" else self._listed(card, sets, inside):
                self._add(sets, name, scope, ids)
            sets.setdefault(scope.prefix + name, [])
        elif card.keyword == "SURFACE":
            self._take_surface(card, scope)
        else:
            return False
        return True

    def _scope(self, card: Card, scope: Scope) -> Scope:
        name = card.get("INSTANCE")
        if not name:
            return scope
        if name not in self._instances:
            raise Refused(f"{card.place}: there is no instance \"{name}\" above. {names_there(name, self._instances)}")
        return self._instances[name]

    @staticmethod
    def _add(sets: dict[str, list[Array]], name: str, scope: Scope, ids: Array) -> None:
        if name:
            sets.setdefault(scope.prefix + name, []).append(ids)

    def _take_elements(self, card: Card, scope: Scope) -> None:
        kind = card.get("TYPE")
        if not kind:
            raise Refused(f"{card.place}: *ELEMENT without TYPE.")
        flat = card.ids(card.flat())
        width = nodes_of_kind(kind)
        if width == 0:
            rows = _continued(card.rows())
            ids = numpy.array([int(card.number(words[0], row)) for row, words in enumerate(rows)], dtype=numpy.int64)
            width = len(rows[0]) - 1 if len({len(words) for words in rows}) == 1 else 0
            nodes = numpy.array([[int(card.number(word, row)) for word in words[1:1 + width]]
                                 for row, words in enumerate(rows)], dtype=numpy.int64).reshape(len(rows), width)
        else:
            if len(flat) % (width + 1):
                flat = card.ids(self._one_per_line(card, width))
            if len(flat) % (width + 1):
                raise Refused(f"{card.place}: *ELEMENT of type {kind}: {len(flat)} numbers are no multiple of "
                              f"{width + 1}, an element with its {width} nodes; the deck is truncated or damaged.")
            rows_of = flat.reshape(-1, width + 1)
            ids, nodes = rows_of[:, 0], rows_of[:, 1:]
        ids, nodes = ids + scope.offset, nodes + scope.offset
        name = card.get("ELSET")
        self.elements.append(ElementTable(kind, ids, nodes, scope.prefix + card.parameters["ELSET"] if name else "", card))
        self._add(self.element_sets, name, scope, ids)

    def _one_per_line(self, card: Card, width: int) -> Array:
        """Elements that have more nodes in their lines than their type, as the last nodes of incompatible modes in
        CalculiX: those of the type count. All numbers, where lines are shorter."""
        rows = [[word for word in words if word] for words in card.rows()]
        if min(map(len, rows)) <= width:
            return card.flat()
        self._findings.leave_out(card.place, f"*ELEMENT, TYPE={card.get('TYPE')}, more than {width} nodes",
                                 "the further numbers of its lines")
        return numpy.array([card.number(word, row) for row, words in enumerate(rows) for word in words[:width + 1]])

    def _listed(self, card: Card, sets: dict[str, list[Array]], scope: Scope) -> list[Array]:
        """Ids that the data of a set name, by numbers, ranges and other sets."""
        if "GENERATE" in card.parameters:
            return [self._range(card, row, words) + scope.offset for row, words in enumerate(card.rows())]
        flat = _numbers_or_none(card)
        if flat is not None:
            return [card.ids(flat) + scope.offset]
        result: list[Array] = []
        for row, words in enumerate(card.rows()):
            for word in words:
                if word:
                    result.append(self.ids(word, sets, scope, card, row))
        return result

    def _of_elements(self, card: Card, scope: Scope) -> list[Array]:
        """Ids of the nodes of an element set, which a node set may name instead of nodes."""
        held = self.ids(card.get("ELSET"), self.element_sets, scope, card, len(card.first))
        return [numpy.unique(table.nodes[numpy.isin(table.ids, held)]) for table in self.elements]

    @staticmethod
    def _range(card: Card, row: int, words: list[str]) -> Array:
        numbers = [int(card.number(word, row)) for word in words if word]
        if len(numbers) not in (2, 3) or min(numbers) < 0 or numbers[1] > LARGEST_ID or (len(numbers) == 3 and numbers[2] == 0):
            raise Refused(f"{card.place_of(row)}: GENERATE takes first, last and increment, whole numbers up to {LARGEST_ID}.")
        result = range(numbers[0], numbers[1] + 1, numbers[2] if len(numbers) == 3 else 1)
        if not 0 < len(result) <= LARGEST_RANGE:
            raise Refused(f"{card.place_of(row)}: GENERATE from {numbers[0]} to {numbers[1]}: "
                          f"{'the last is below the first' if not result else f'more than {LARGEST_RANGE} numbers'}.")
        return numpy.arange(result.start, result.stop, result.step)

    def ids(self, word: str, sets: dict[str, list[Array]], scope: Scope, card: Card, row: int) -> Array:
        """What a word stands for: a number, a set, or one of an instance, INSTANCE.NAME.

        Raises:
            Refused: there is no such set.
        """
        name = word.strip().strip("\"").upper()
        if name.lstrip("+").isdecimal():
            return numpy.array([int(name) + scope.offset])
        for candidate in (scope.prefix + name, name):
            if candidate in sets:
                found = sets[candidate]
                return numpy.concatenate(found) if found else numpy.zeros(0, dtype=numpy.int64)
        instance, _, inside = name.partition(".")
        if instance in self._instances and inside.isdecimal():
            return numpy.array([int(inside) + self._instances[instance].offset])
        raise Refused(f"{card.place_of(row)}: *{card.keyword}: there is no set \"{word}\" above this line. "
                      f"{names_there(word, sets)}")

    def single_node(self, card: Card, parameter: str) -> int:
        """The id of the node that a parameter names, by its number or by a set that holds it alone.

        Raises:
            Refused: there is no such set, or it holds more.
        """
        ids = numpy.unique(self.ids(card.get(parameter), self.node_sets, Scope(), card, len(card.first)))
        if len(ids) != 1:
            raise Refused(f"{card.place}: *{card.keyword}: the set \"{card.get(parameter)}\" holds {len(ids)} nodes; one is wanted.")
        return int(ids[0])

    def _take_surface(self, card: Card, scope: Scope) -> None:
        name = scope.prefix + card.get("NAME")
        kind = card.get("TYPE") or "ELEMENT"
        if kind not in ("ELEMENT", "NODE"):
            self._findings.leave_out(card.place, f"*SURFACE, TYPE={kind}", "what refers to this surface is left out")
            return
        known = self.surfaces.get(name)
        if known is not None and known.of_nodes != (kind == "NODE"):
            nodes, faces = (card, known.card) if kind == "NODE" else (known.card, card)
            self._findings.leave_out(nodes.place, f"*SURFACE {name}, TYPE=NODE", f"what refers to it means the faces of the same "
                                     f"name, {faces.place}")
            if kind == "NODE":
                return
        elif known is not None:
            raise Refused(f"{card.place}: the surface \"{name}\" is also at {known.card.place}; rename one.")
        if card.get("COMBINE"):
            self._combine(card, name)
            return
        rows: list[tuple[Array, str]] = []
        sets = self.node_sets if kind == "NODE" else self.element_sets
        inside = self._scope(card, scope)
        for row, words in enumerate(card.rows()):
            label = words[1].upper() if kind == "ELEMENT" and len(words) > 1 else ""
            rows.append((self.ids(words[0], sets, inside, card, row), label))
        self.surfaces[name] = Surface(kind == "NODE", rows, card)

    def _combine(self, card: Card, name: str) -> None:
        """The union of surfaces; other combinations are listed."""
        if card.get("COMBINE") != "UNION":
            self._findings.leave_out(card.place, f"*SURFACE, COMBINE={card.get('COMBINE')}", "what refers to this surface is left out")
            return
        rows: list[tuple[Array, str]] = []
        kinds = set()
        for row, words in enumerate(card.rows()):
            for word in words:
                one = self.surfaces.get(word.upper())
                if word and one is None:
                    raise Refused(f"{card.place_of(row)}: *SURFACE: there is no surface \"{word}\" above this line. "
                                  f"{names_there(word, self.surfaces)}")
                if one is not None:
                    kinds.add(one.of_nodes)
                    rows += one.rows
        if len(kinds) != 1:
            raise Refused(f"{card.place}: *SURFACE, COMBINE=UNION takes surfaces of one kind, of faces or of nodes.")
        self.surfaces[name] = Surface(kinds.pop(), rows, card)

    def _demand_single_elements(self) -> None:
        """Refuses an element that is given twice: its nodes, and what refers to it, would be open."""
        if not self.elements:
            return
        ids = numpy.concatenate([table.ids for table in self.elements])
        first = numpy.zeros(len(ids), dtype=bool)
        first[numpy.unique(ids, return_index=True)[1]] = True
        if first.all():
            return
        twice = ids[numpy.flatnonzero(~first)[0]]
        one, *others = [table for table in self.elements for each in table.ids if each == twice]
        raise Refused(f"{others[0].card.place}: element {twice % INSTANCE_OFFSET} is also at {one.card.place}; number one of them anew.")

    def _gather_nodes(self) -> None:
        if not self._nodes:
            return
        ids = numpy.concatenate([ids for ids, _ in self._nodes])
        at = numpy.concatenate([at for _, at in self._nodes])
        # Of a node that is given twice, the last counts, as in CalculiX.
        self.node_ids, of = numpy.unique(ids[::-1], return_index=True)
        self.coordinates = at[::-1][of]
        moved = numpy.unique(ids[(self.coordinates[numpy.searchsorted(self.node_ids, ids)] != at).any(axis=1)])
        if len(moved):
            self._findings.found.append(f"{len(moved)} nodes are given twice, at different places; the last one counts: "
                                        f"{', '.join(str(each % INSTANCE_OFFSET) for each in moved[:5])}{', ...' if len(moved) > 5 else ''}")


def _numbers_or_none(card: Card) -> "Array | None":
    try:
        return card.flat()
    except Refused:
        return None


def _continued(lines: list[list[str]]) -> list[list[str]]:
    """Their words, lines that end in a comma together with the next one."""
    rows: list[list[str]] = []
    goes_on = False
    for words in lines:
        own = [word for word in words if word]
        if goes_on:
            rows[-1] += own
        elif own:
            rows.append(own)
        goes_on = bool(rows) and not words[-1]
    return rows
