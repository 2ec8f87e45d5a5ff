"""Forces and temperatures of nodes of a deck."""
from harmos.exchange.deck.acting import Acting
from harmos.exchange.deck.amplitudes import Amplitudes
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.curves import Course, Span
from harmos.exchange.deck.loads import NO_SHARE
from harmos.exchange.deck.materials import Material
from harmos.exchange.findings import Refused


class NodalLoads:
    """Reads *CLOAD and *TEMPERATURE."""

    def __init__(self, acting: Acting, amplitudes: Amplitudes, materials: dict[str, Material]) -> None:
        """Adds to what acts."""
        self._acting, self._amplitudes, self._materials = acting, amplitudes, materials

    def read_forces(self, card: Card, span: Span, at_once: bool) -> None:
        """A *CLOAD.

        Raises:
            Refused: a set or an amplitude is not there, or a line is no force.
        """
        course = Course(span, self._amplitudes.of(card, span), at_once)
        acted: set[tuple[int, int]] = set()
        self._acting.loads.force_cards.append((card, acted))
        for row, words in enumerate(card.rows()):
            if len(words) < 3:
                raise Refused(f"{card.place_of(row)}: *CLOAD takes a node or set, a component and a force.")
            ids, component = self._acting.nodes(words[0], card, row), int(card.number(words[1], row))
            value = card.number(words[2], row)
            for node in self._acting.tightening.nodes & set(ids.tolist()):
                if component == 1:
                    self._acting.tightening.force(node, card, row, course, value)
            ids, coupled = self._acting.divided(ids)
            for node in coupled:
                coupling, first = self._acting.couplings.at_node[node]
                course.add(coupling.forces, component - 1 + first, value)
            if not len(ids):
                continue
            if not 1 <= component <= self._acting.solids.mesh.dimension:
                self._acting.findings.leave_out(card.place_of(row), f"*CLOAD of component {component}", f"{value:g}, on "
                                         "rotations or temperatures, which solids have not")
                continue
            nodes = self._acting.solids.nodes(ids)
            left = len(ids) - len(nodes) - len(self._acting.tightening.nodes & set(ids.tolist()))
            if left:
                self._acting.findings.leave_out(card.place_of(row), "*CLOAD", f"{value:g} on {left} nodes that belong to no solid")
            for node in nodes.tolist():
                axes = self._acting.transforms.of_node.get(node)
                if node in self._acting.transforms.left_out:
                    continue
                if axes is None:
                    course.add(self._acting.loads.forces, (node, component - 1), value)
                    acted.add((node, component - 1))
                    continue
                direction = axes.at(self._acting.solids.mesh.nodes[node], self._acting.transforms.size)[component - 1]
                course.add(self._acting.loads.turned_forces, (node, component - 1, tuple(map(float, direction))), value)
                acted.update((node, along) for along, share in enumerate(direction) if abs(share) > NO_SHARE)

    def read_temperatures(self, card: Card, span: "Span | None", at_once: bool) -> None:
        """Temperatures of nodes; without a span the initial ones, at which there is no strain.

        Raises:
            Refused: a set or an amplitude is not there, or a line is no temperature.
        """
        if span is not None and not any(material.expansion for material in self._materials.values()):
            self._acting.findings.leave_out(card.place, "*TEMPERATURE", "no material expands: it has no effect")
            return
        for switch in ("SUBMODEL", "USER", "FILE", "BSTEP", "LINTEMP"):
            if switch in card.parameters:
                self._acting.findings.leave_out(card.place, f"*{card.keyword}, {switch}", "temperatures that stand elsewhere")
                return
        course = Course(span, self._amplitudes.of(card, span), at_once) if span is not None else None
        for row, words in enumerate(card.rows()):
            if len(words) < 2:
                raise Refused(f"{card.place_of(row)}: *{card.keyword} takes a node or set, and a temperature.")
            value = card.number(words[1], row)
            for node in self._acting.solids.nodes(self._acting.nodes(words[0], card, row)).tolist():
                if course is None:
                    self._acting.loads.temperatures[node] = ((0.0, value),)
                else:
                    course.set(self._acting.loads.temperatures, node, value)
