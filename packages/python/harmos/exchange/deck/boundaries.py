"""Nodes of a deck that are held or moved."""
import numpy

from harmos.arrays import Array
from harmos.exchange.deck.acting import Acting
from harmos.exchange.deck.amplitudes import Amplitudes
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Step
from harmos.exchange.deck.curves import UNLOADED, Course, Span
from harmos.exchange.findings import Refused

_TYPES = {"ENCASTRE": [1, 2, 3], "PINNED": [1, 2, 3], "XSYMM": [1], "YSYMM": [2], "ZSYMM": [3],
          "XASYMM": [2, 3], "YASYMM": [1, 3], "ZASYMM": [1, 2]}


class Boundaries:
    """Reads *BOUNDARY."""

    def __init__(self, acting: Acting, amplitudes: Amplitudes, joined: set[int], ground: set[int]) -> None:
        """Adds to what acts. `joined`: nodes (indices in the mesh) of equations, which may be held without belonging to a solid;
        `ground`: ids of nodes where springs end, which are held by that."""
        self._acting, self._amplitudes, self._ground = acting, amplitudes, ground
        self._holdable = numpy.union1d(acting.solids.used_nodes(), numpy.array(sorted(joined), dtype=numpy.int64))
        self._first: dict[tuple[int, int], tuple[str, float]] = {}

    def read(self, card: Card, span: Span, at_once: bool) -> None:
        """A card of the model, of which the span ends at 0, or of a step.

        Raises:
            Refused: a set or an amplitude is not there, or boundaries of the model contradict each other.
        """
        for switch in ("SUBMODEL", "USER", "TYPE"):
            if switch in card.parameters and card.get(switch) != "DISPLACEMENT":
                self._acting.findings.leave_out(card.place, f"*BOUNDARY, {switch}", "these boundaries are left out")
                return
        course = Course(span, self._amplitudes.of(card, span), at_once)
        # Where nothing has moved yet, to stay is to be held at 0.
        stays = "FIXED" in card.parameters and span.begin > 0.0
        late: set[int] = set()
        for row, words in enumerate(card.rows()):
            ids = self._acting.nodes(words[0], card, row)
            components, value = self._components(card, row, words)
            for node in self._acting.tightening.nodes & set(ids.tolist()):
                if 1 in components:
                    if self._acting.tightening.is_free(node):
                        late.add(-node)
                    self._acting.tightening.draw(node, card, row, course, value)
            ids, coupled = self._acting.divided(ids)
            for node in coupled:
                coupling, first = self._acting.couplings.at_node[node]
                places = [component - 1 + first for component in components]
                if stays:
                    self._tell_free(card, row, int(any(at not in coupling.held for at in places)))
                    continue
                for at in places:
                    if at not in coupling.held:
                        late.add(-node)
                    points = coupling.held.get(at, UNLOADED)
                    coupling.held[at] = (((0.0, value),) if span.end <= 0.0
                                         else course.followed(points, value))
            if not len(ids):
                continue
            if any(component > 3 for component in components):
                others = [component for component in components if component > 3]
                if not set(others) <= {4, 5, 6} or value != 0.0:
                    self._acting.findings.leave_out(card.place_of(row), f"*BOUNDARY of component {others[0]}",
                                             "solids have displacements 1 to 3 only")
            inside = [c for c in components if 1 <= c <= self._acting.solids.mesh.dimension]
            if stays:
                self._keep(card, row, ids, inside)
            else:
                late |= self._hold(card, row, ids, inside, course, value)
        if late and span.begin > 0.0:
            self._acting.findings.leave_out(card.place, "*BOUNDARY", f"{len(late)} nodes are held from the beginning, though free up to "
                                     "this step: the results of earlier steps are those of nodes that are held")

    def list_released(self, new: Card, step: Step) -> None:
        """OP=NEW of boundaries: lists what the step does not hold again, which stays held in the scene."""
        again: set[tuple[int, int]] = set()
        driven: set[tuple[int, int]] = set()
        for card in step.cards:
            for row, words in enumerate(card.rows() if card.keyword == "BOUNDARY" else []):
                components, _ = self._components(card, row, words)
                ids, coupled = self._acting.divided(self._acting.nodes(words[0], card, row))
                driven.update((node, component) for node in coupled for component in components)
                for node in self._acting.solids.nodes(ids).tolist():
                    again.update((node, self._degree(node, component)[0]) for component in components if 1 <= component <= 3)
        released = {node for node, along in self._acting.loads.held if (node, along) not in again}
        for node, (coupling, first) in self._acting.couplings.at_node.items():
            if any((node, component - first + 1) not in driven for component in coupling.held if component >= first):
                released.add(-node)
        if released:
            self._acting.findings.leave_out(new.place, "*BOUNDARY, OP=NEW", f"{len(released)} nodes are released from here on: they stay held")

    @staticmethod
    def _components(card: Card, row: int, words: list[str]) -> tuple[list[int], float]:
        """Which components a line of *BOUNDARY holds, from 1, and at what."""
        named = words[1].upper() if len(words) > 1 else ""
        if named in _TYPES:
            return _TYPES[named], 0.0
        first = int(card.number(named, row))
        last = int(card.number(words[2], row)) if len(words) > 2 and words[2] else first
        if not 1 <= first <= last:
            raise Refused(f"{card.place_of(row)}: *BOUNDARY of components {first} to {last}; they count from 1, the first one first.")
        return list(range(first, last + 1)), card.number(words[3], row) if len(words) > 3 else 0.0

    def _keep(self, card: Card, row: int, ids: Array, components: list[int]) -> None:
        """FIXED: what is held stays where it is; what was free would have to stay where the step before has left it."""
        free = [node for node in self._acting.solids.nodes(ids).tolist()
                if any((node, self._degree(node, component)[0]) not in self._acting.loads.held for component in components)]
        self._tell_free(card, row, len(free))

    def _tell_free(self, card: Card, row: int, count: int) -> None:
        """Lists nodes of a FIXED boundary that were free before."""
        if count:
            self._acting.findings.leave_out(card.place_of(row), "*BOUNDARY, FIXED", f"{count} of its nodes were free before: they stay free")

    def _degree(self, node: int, component: int) -> tuple[int, float]:
        """The component from 0 that a node is held along, and its sense; takes note of axes that are turned."""
        axes = self._acting.transforms.of_node.get(node)
        if axes is None:
            return component - 1, 1.0
        along = axes.along_global()
        if along is not None:
            return along[component - 1]
        self._acting.loads.axes[node] = axes
        return component - 1, 1.0

    def _hold(self, card: Card, row: int, ids: Array, components: list[int], course: Course,
              value: float) -> set[int]:
        """The nodes that were free, as they are in the mesh."""
        known = self._acting.contents.node_ids
        at = numpy.minimum(numpy.searchsorted(known, ids), len(known) - 1)
        at = at[known[at] == ids]
        nodes = at[numpy.isin(at, self._holdable)]
        left = len(ids) - len(nodes) - len((self._acting.tightening.nodes | self._ground) & set(ids.tolist()))
        if left > 0:
            self._acting.findings.leave_out(card.place_of(row), "*BOUNDARY", f"{left} of its nodes belong to no solid")
        free: set[int] = set()
        for node in nodes.tolist():
            if node in self._acting.transforms.left_out:
                continue
            for component in components:
                along, sense = self._degree(node, component)
                key, wanted = (node, along), sense * value
                if key not in self._acting.loads.held:
                    free.add(node)
                said = self._first.get(key)
                if course.span.end <= 0.0 and said is not None and said[1] != wanted:
                    raise Refused(f"{card.place_of(row)}: *BOUNDARY holds component {component} of a node at {wanted:g}, "
                                  f"{said[0]} at {said[1]:g}; remove one of them.")
                if course.span.end <= 0.0:
                    self._first[key] = card.place_of(row), wanted
                    self._acting.loads.held[key] = ((0.0, wanted),)
                    continue
                points = self._acting.loads.held.get(key, UNLOADED)
                if points[-1][0] >= course.span.end:
                    points = tuple(point for point in points if point[0] <= course.span.begin) or UNLOADED
                self._acting.loads.held[key] = course.followed(points, wanted)
        return free
