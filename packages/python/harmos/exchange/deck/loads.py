"""Boundaries and loads of a deck over its steps."""
import dataclasses
import typing

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents, Scope, Step
from harmos.exchange.deck.couplings import Couplings
from harmos.exchange.deck.curves import UNLOADED, Points, Span, followed
from harmos.exchange.deck.materials import Material
from harmos.exchange.deck.solids import Solids
from harmos.exchange.deck.transforms import Axes, Transforms
from harmos.exchange.findings import Findings, Refusals, Refused, names_there

STATIC = ("STATIC",)
"""Procedures that Harmos has."""

ALONG = 1e-3
"""Difference of the cosine with a global axis from 1 that counts as none: decks have few digits."""

_Key = typing.TypeVar("_Key")

OUTPUT = ("NODEPRINT", "ELPRINT", "NODEFILE", "ELFILE", "CONTACTPRINT", "CONTACTFILE", "SECTIONPRINT", "FACEPRINT",
          "OUTPUT", "NODEOUTPUT", "ELEMENTOUTPUT", "CONTACTOUTPUT", "ELEMENTFILE", "ELEMENTPRINT", "PREPRINT", "RESTART",
          "MONITOR", "ENERGYPRINT", "CONTROLS", "FILEFORMAT")
"""What asks for output or steers iterations."""

_TYPES = {"ENCASTRE": [1, 2, 3], "PINNED": [1, 2, 3], "XSYMM": [1], "YSYMM": [2], "ZSYMM": [3],
          "XASYMM": [2, 3], "YASYMM": [1, 3], "ZASYMM": [1, 2]}


_TABLE = {"NAME", "TIME", "VALUE", "DEFINITION", "SHIFTX", "SHIFTY", "SMOOTH"}
"""Parameters of amplitudes that are tables."""


Turn = tuple[str, tuple[float, ...], tuple[float, ...]]
"""A part that turns, a point of the axis, and its direction."""


@dataclasses.dataclass
class Preload:
    """What tightens a bolt.

    Attributes:
        points: curve of the displacement or of the force.
        is_force: which of them.
        locked: time from which the bolt keeps what the force has drawn together; None: it never does.
    """
    points: Points = UNLOADED
    is_force: bool = False
    locked: "float | None" = None


@dataclasses.dataclass
class Loads:
    """What acts, over time.

    Attributes:
        held: curve of a displacement, by node (index in the mesh) and component from 0, of nodes in `axes` along those.
        axes: of nodes whose held components are no global ones.
        forces: curve of a force, by the same.
        pressures: curve of a pressure, by element and side.
        body_forces: curves of the acceleration times density [force/volume], by part and component.
        rotations: curve of the squared angular velocity, by part, point and axis.
        temperatures: curve of the temperature, by node; the first value is that without strain.
        preloads: of bolts, by the id of the reference node.
        steps: name, duration and increments.
    """
    held: dict[tuple[int, int], Points] = dataclasses.field(default_factory=dict)
    axes: dict[int, Axes] = dataclasses.field(default_factory=dict)
    forces: dict[tuple[int, int], Points] = dataclasses.field(default_factory=dict)
    pressures: dict[tuple[int, int], Points] = dataclasses.field(default_factory=dict)
    body_forces: dict[tuple[str, int], Points] = dataclasses.field(default_factory=dict)
    rotations: dict[Turn, Points] = dataclasses.field(default_factory=dict)
    temperatures: dict[int, Points] = dataclasses.field(default_factory=dict)
    preloads: dict[int, Preload] = dataclasses.field(default_factory=dict)
    steps: list[tuple[str, float, int]] = dataclasses.field(default_factory=list)


class LoadReader:
    """Follows the steps of a deck."""

    def __init__(self, contents: Contents, solids: Solids, materials: dict[str, Material], couplings: Couplings,
                 joined: set[int], findings: Findings) -> None:
        """Keeps all of them; what acts on reference nodes is added to the couplings. `joined`: nodes (indices in the mesh)
        of equations, which may be held without belonging to a solid."""
        self._contents, self._solids, self._materials, self._findings = contents, solids, materials, findings
        self._couplings = couplings
        self._holdable = numpy.union1d(solids.used_nodes(), numpy.array(sorted(joined), dtype=numpy.int64))
        self._scope = Scope()
        self._loads = Loads()
        self._refusals = Refusals()
        self._preload_nodes = {int(card.get("NODE")) for card in contents.model
                               if card.keyword == "PRE-TENSIONSECTION" and card.get("NODE").isdigit()}
        self._transforms = Transforms(contents, solids, findings)
        for card in contents.model:
            sets = contents.node_sets.get(card.get("NSET"), []) if card.keyword == "TRANSFORM" else []
            if any(numpy.isin(ids, list(couplings.at_node)).any() for ids in sets):
                findings.leave_out(card.place, "*TRANSFORM of a reference node", "what acts there counts in global axes")
        self._amplitudes = {card.get("NAME"): card for card in contents.model if card.keyword == "AMPLITUDE"}
        self._first: dict[tuple[int, int], tuple[str, float]] = {}

    def read(self) -> Loads:
        """All of it.

        Raises:
            Refused: loads on sets that are not there, boundaries that contradict each other.
        """
        for card in self._contents.model:
            if card.keyword == "BOUNDARY":
                with self._refusals.collect():
                    self._boundary(card, Span(-1.0, 0.0), True)
            elif card.keyword == "INITIALCONDITIONS" and card.get("TYPE") == "TEMPERATURE":
                with self._refusals.collect():
                    self._temperature(card, None, True)
        for key, points in self._loads.held.items():
            self._loads.held[key] = ((0.0, points[-1][1]),)
        time = 0.0
        for number, step in enumerate(self._contents.steps, 1):
            procedure = [card for card in step.cards if card.keyword in STATIC]
            if not procedure:
                named = [card for card in step.cards if card.keyword not in OUTPUT]
                self._findings.leave_out(step.card.place, "*STEP", f"the step *{named[0].keyword if named else 'STEP'}: "
                                         "Harmos has static steps")
                continue
            time = self._step(step, procedure[0], number, time)
        self._refusals.raise_if_any()
        return self._loads

    def _step(self, step: Step, static: Card, number: int, begin: float) -> float:
        """The end of the step."""
        words = static.rows()[0] if static.data else []
        increment = static.number(words[0], 0) if words else 0.0
        duration = static.number(words[1], 0) if len(words) > 1 else 0.0
        duration = duration or 1.0
        increments = round(duration / increment) if increment > 0.0 else 1
        self._loads.steps.append((f"step_{number}", duration, max(1, min(20, increments))))
        span = Span(begin, begin + duration)
        if "NLGEOM" in step.card.parameters and step.card.get("NLGEOM") != "NO":
            self._findings.leave_out(step.card.place, "*STEP, NLGEOM", "large rotations and strains: all is linear in geometry")
        if "PERTURBATION" in step.card.parameters:
            self._findings.leave_out(step.card.place, "*STEP, PERTURBATION", "the step goes on from the one before")
        at_once = step.card.get("AMPLITUDE") == "STEP"
        self._free(step, span)
        for card in step.cards:
            with self._refusals.collect():
                if card.keyword == "BOUNDARY":
                    self._boundary(card, span, at_once)
                elif card.keyword == "CLOAD":
                    self._force(card, span, at_once)
                elif card.keyword in ("DLOAD", "DSLOAD"):
                    self._distributed(card, span, at_once)
                elif card.keyword == "TEMPERATURE":
                    self._temperature(card, span, at_once)
                elif card.keyword not in OUTPUT and card is not static:
                    self._findings.leave_out(card.place, f"*{card.keyword}", "without effect on the scene")
        return span.end

    def _free(self, step: Step, span: Span) -> None:
        """What OP=NEW takes away."""
        kinds: dict[str, list[dict[tuple[int, int], Points]]] = {
            "CLOAD": [self._loads.forces], "DLOAD": [self._loads.pressures], "DSLOAD": [self._loads.pressures],
            "BOUNDARY": [self._loads.held]}
        for keyword, tables in kinds.items():
            new = [card for card in step.cards if card.keyword == keyword and card.get("OP") == "NEW"]
            if keyword == "CLOAD" and new:
                for coupling in self._couplings.all:
                    for component, points in coupling.forces.items():
                        coupling.forces[component] = followed(points, span, 0.0, None, False)
            if keyword == "DLOAD" and new:
                for turn, points in self._loads.rotations.items():
                    self._loads.rotations[turn] = followed(points, span, 0.0, None, False)
            if not new or not any(tables):
                continue
            if keyword == "BOUNDARY":
                self._list_released(new[0], step)
                continue
            for table in tables:
                for key, points in table.items():
                    table[key] = followed(points, span, 0.0, None, False)

    def _list_released(self, new: Card, step: Step) -> None:
        """OP=NEW of boundaries: lists what the step does not hold again, which stays held in the scene."""
        again: set[tuple[int, int]] = set()
        for card in step.cards:
            for row, words in enumerate(card.rows() if card.keyword == "BOUNDARY" else []):
                components, _ = self._components(card, row, words)
                for node in self._solids.nodes(self._nodes(words[0], card, row)).tolist():
                    again.update((node, self._degree(node, component)[0]) for component in components if 1 <= component <= 3)
        released = {node for node, along in self._loads.held if (node, along) not in again}
        if released:
            self._findings.leave_out(new.place, "*BOUNDARY, OP=NEW", f"{len(released)} nodes are released from here on: they stay held")

    @staticmethod
    def _components(card: Card, row: int, words: list[str]) -> tuple[list[int], float]:
        """Which components a line of *BOUNDARY holds, from 1, and at what."""
        named = words[1].upper() if len(words) > 1 else ""
        if named in _TYPES:
            return _TYPES[named], 0.0
        first = int(card.number(named, row))
        last = int(card.number(words[2], row)) if len(words) > 2 and words[2] else first
        return list(range(first, last + 1)), card.number(words[3], row) if len(words) > 3 else 0.0

    def _amplitude(self, card: Card, span: Span) -> "Points | None":
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
        later, more = (definition.number(definition.get(each), 0) for each in ("SHIFTX", "SHIFTY"))
        later += card.number(card.get("TIMEDELAY"), 0) - begin
        return tuple((float(time) + later, float(value) + more) for time, value in numbers.reshape(-1, 2))

    def _nodes(self, word: str, card: Card, row: int) -> Array:
        return self._contents.ids(word, self._contents.node_sets, self._scope, card, row)

    def _boundary(self, card: Card, span: Span, at_once: bool) -> None:
        for switch in ("SUBMODEL", "USER", "TYPE"):
            if switch in card.parameters and card.get(switch) != "DISPLACEMENT":
                self._findings.leave_out(card.place, f"*BOUNDARY, {switch}", "these boundaries are left out")
                return
        amplitude = self._amplitude(card, span)
        for row, words in enumerate(card.rows()):
            ids = self._nodes(words[0], card, row)
            components, value = self._components(card, row, words)
            for node in self._preload_nodes & set(ids.tolist()):
                if 1 in components:
                    self._draw(node, card, row, span, value, amplitude, at_once)
            ids, coupled = self._divided(ids)
            for node in coupled:
                coupling, first = self._couplings.at_node[node]
                for component in components:
                    at = component - 1 + first
                    points = coupling.held.get(at, UNLOADED)
                    coupling.held[at] = (((0.0, value),) if span.end <= 0.0
                                         else followed(points, span, value, amplitude, at_once))
            if not len(ids):
                continue
            if any(component > 3 for component in components):
                others = [component for component in components if component > 3]
                if not set(others) <= {4, 5, 6} or value != 0.0:
                    self._findings.leave_out(card.place_of(row), f"*BOUNDARY of component {others[0]}",
                                             "solids have displacements 1 to 3 only")
            inside = [c for c in components if 1 <= c <= self._solids.mesh.dimension]
            if "FIXED" in card.parameters:
                self._keep(card, row, ids, inside)
            else:
                self._hold(card, row, ids, inside, span, value, amplitude, at_once)

    def _keep(self, card: Card, row: int, ids: Array, components: list[int]) -> None:
        """FIXED: what is held stays where it is; what was free would have to stay where the step before has left it."""
        free = [node for node in self._solids.nodes(ids).tolist()
                if any((node, self._degree(node, component)[0]) not in self._loads.held for component in components)]
        if free:
            self._findings.leave_out(card.place_of(row), "*BOUNDARY, FIXED", f"{len(free)} of its nodes were free before: they "
                                     "stay free")

    def _draw(self, node: int, card: Card, row: int, span: Span, value: float, amplitude: "Points | None",
              at_once: bool) -> None:
        """A displacement of the reference node of a pretension section; FIXED, or 0 after a force, locks the bolt."""
        preload = self._loads.preloads.get(node, Preload())
        if preload.is_force:
            if "FIXED" not in card.parameters and value != 0.0:
                self._findings.leave_out(card.place_of(row), "*BOUNDARY of a pretension section",
                                         f"{value:g}, after a force: the bolt keeps what that has drawn together")
            if preload.locked is None:
                self._loads.preloads[node] = dataclasses.replace(preload, locked=span.begin)
        elif "FIXED" not in card.parameters:
            self._loads.preloads[node] = Preload(followed(preload.points, span, value, amplitude, at_once))

    def _tighten(self, node: int, card: Card, row: int, span: Span, value: float, amplitude: "Points | None",
                 at_once: bool) -> None:
        """A force on the reference node of a pretension section."""
        preload = self._loads.preloads.get(node, Preload())
        if preload.locked is not None or (not preload.is_force and preload.points != UNLOADED):
            self._findings.leave_out(card.place_of(row), "*CLOAD on a pretension section",
                                     f"{value:g}, after the bolt was locked or drawn together: it keeps that")
            return
        self._loads.preloads[node] = Preload(followed(preload.points, span, value, amplitude, at_once), True)

    def _degree(self, node: int, component: int) -> tuple[int, float]:
        """The component from 0 that a node is held along, and its sense; takes note of axes that are turned."""
        axes = self._transforms.of_node.get(node)
        if axes is None:
            return component - 1, 1.0
        along = axes.along_global()
        if along is not None:
            return along[component - 1]
        self._loads.axes[node] = axes
        return component - 1, 1.0

    def _hold(self, card: Card, row: int, ids: Array, components: list[int], span: Span, value: float,
              amplitude: "Points | None", at_once: bool) -> None:
        known = self._contents.node_ids
        at = numpy.minimum(numpy.searchsorted(known, ids), len(known) - 1)
        at = at[known[at] == ids]
        nodes = at[numpy.isin(at, self._holdable)]
        left = len(ids) - len(nodes) - len(self._preload_nodes & set(ids.tolist()))
        if left:
            self._findings.leave_out(card.place_of(row), "*BOUNDARY", f"{left} of its nodes belong to no solid")
        for node in nodes.tolist():
            if node in self._transforms.left_out:
                continue
            for component in components:
                along, sense = self._degree(node, component)
                key, wanted = (node, along), sense * value
                said = self._first.get(key)
                if span.end <= 0.0 and said is not None and said[1] != wanted:
                    raise Refused(f"{card.place_of(row)}: *BOUNDARY holds component {component} of a node at {wanted:g}, "
                                  f"{said[0]} at {said[1]:g}; remove one of them.")
                if span.end <= 0.0:
                    self._first[key] = card.place_of(row), wanted
                    self._loads.held[key] = ((0.0, wanted),)
                    continue
                points = self._loads.held.get(key, UNLOADED)
                if points[-1][0] >= span.end:
                    points = tuple(point for point in points if point[0] <= span.begin) or UNLOADED
                self._loads.held[key] = followed(points, span, wanted, amplitude, at_once)

    def _force(self, card: Card, span: Span, at_once: bool) -> None:
        amplitude = self._amplitude(card, span)
        for row, words in enumerate(card.rows()):
            if len(words) < 3:
                raise Refused(f"{card.place_of(row)}: *CLOAD takes a node or set, a component and a force.")
            ids, component = self._nodes(words[0], card, row), int(card.number(words[1], row))
            value = card.number(words[2], row)
            for node in self._preload_nodes & set(ids.tolist()):
                if component == 1:
                    self._tighten(node, card, row, span, value, amplitude, at_once)
            ids, coupled = self._divided(ids)
            for node in coupled:
                coupling, first = self._couplings.at_node[node]
                self._add(coupling.forces, component - 1 + first, span, value, amplitude, at_once)
            if not len(ids):
                continue
            if not 1 <= component <= self._solids.mesh.dimension:
                self._findings.leave_out(card.place_of(row), f"*CLOAD of component {component}", f"{value:g}, on "
                                         "rotations or temperatures, which solids have not")
                continue
            nodes = self._solids.nodes(ids)
            left = len(ids) - len(nodes) - len(self._preload_nodes & set(ids.tolist()))
            if left:
                self._findings.leave_out(card.place_of(row), "*CLOAD", f"{value:g} on {left} nodes that belong to no solid")
            for node in nodes.tolist():
                axes = self._transforms.of_node.get(node)
                if node in self._transforms.left_out:
                    continue
                if axes is None:
                    self._add(self._loads.forces, (node, component - 1), span, value, amplitude, at_once)
                    continue
                direction = axes.at(self._solids.mesh.nodes[node], self._transforms.size)[component - 1]
                for along in numpy.flatnonzero(numpy.abs(direction) > 1e-12).tolist():
                    self._add(self._loads.forces, (node, along), span, value * float(direction[along]), amplitude, at_once)

    def _temperature(self, card: Card, span: "Span | None", at_once: bool) -> None:
        """Temperatures of nodes; without a span the initial ones, at which there is no strain."""
        if span is not None and not any(material.expansion for material in self._materials.values()):
            self._findings.leave_out(card.place, "*TEMPERATURE", "no material expands: it has no effect")
            return
        for switch in ("SUBMODEL", "USER", "FILE", "BSTEP"):
            if switch in card.parameters:
                self._findings.leave_out(card.place, f"*{card.keyword}, {switch}", "temperatures that stand elsewhere")
                return
        amplitude = self._amplitude(card, span) if span is not None else None
        for row, words in enumerate(card.rows()):
            if len(words) < 2:
                raise Refused(f"{card.place_of(row)}: *{card.keyword} takes a node or set, and a temperature.")
            value = card.number(words[1], row)
            for node in self._solids.nodes(self._nodes(words[0], card, row)).tolist():
                if span is None:
                    self._loads.temperatures[node] = ((0.0, value),)
                else:
                    points = self._loads.temperatures.get(node, UNLOADED)
                    self._loads.temperatures[node] = followed(points, span, value, amplitude, at_once)

    def _divided(self, ids: Array) -> tuple[Array, list[int]]:
        """The nodes that are no reference of a coupling, and those that are."""
        is_reference = numpy.isin(ids, list(self._couplings.at_node))
        return ids[~is_reference], ids[is_reference].tolist()

    @staticmethod
    def _add(table: "dict[_Key, Points]", key: "_Key", span: Span, value: float,
             amplitude: "Points | None", at_once: bool) -> None:
        """Goes on to a value; what the step has said before is added to."""
        points = table.get(key, UNLOADED)
        if points[-1][0] >= span.end and points[-1][1] != 0.0:
            before = tuple(point for point in points if point[0] <= span.begin) or UNLOADED
            table[key] = followed(before, span, points[-1][1] + value, amplitude, at_once)
        else:
            before = tuple(point for point in points if point[0] <= span.begin) or UNLOADED
            table[key] = followed(before, span, value, amplitude, at_once)

    def _distributed(self, card: Card, span: Span, at_once: bool) -> None:
        amplitude = self._amplitude(card, span)
        for row, words in enumerate(card.rows()):
            label = words[1].upper() if len(words) > 1 else ""
            if card.keyword == "DSLOAD" and label == "P":
                surface = self._contents.surfaces.get(words[0].upper())
                if surface is None:
                    raise Refused(f"{card.place_of(row)}: *DSLOAD: there is no surface \"{words[0]}\". "
                                  f"{names_there(words[0], self._contents.surfaces)}")
                sides = self._solids.surface(surface)
            elif card.keyword == "DLOAD" and label == "GRAV":
                self._gravity(card, row, words, span, amplitude, at_once)
                continue
            elif card.keyword == "DLOAD" and label == "CENTRIF":
                self._centrifugal(card, row, words, span, amplitude, at_once)
                continue
            elif card.keyword == "DLOAD" and label[:1] == "P" and label[1:].isdigit():
                ids = self._contents.ids(words[0], self._contents.element_sets, self._scope, card, row)
                sides = self._solids.sides(ids, label, card.place_of(row))
                if len(sides) < len(ids):
                    self._findings.leave_out(card.place_of(row), f"*DLOAD {label}",
                                             f"on {len(ids) - len(sides)} elements that are no solids")
            else:
                self._findings.leave_out(card.place_of(row), f"*{card.keyword} {label}", "this load is left out")
                continue
            value = card.number(words[2], row) if len(words) > 2 else 0.0
            for element, side in sides.tolist():
                self._add(self._loads.pressures, (element, side), span, value, amplitude, at_once)

    def _gravity(self, card: Card, row: int, words: list[str], span: Span, amplitude: "Points | None",
                 at_once: bool) -> None:
        numbers = [card.number(word, row) for word in words[2:6]]
        if len(numbers) < 4:
            raise Refused(f"{card.place_of(row)}: GRAV takes an acceleration and a direction.")
        direction = numpy.array(numbers[1:]) / max(float(numpy.linalg.norm(numbers[1:])), 1e-300)
        for part, density in self._loaded_parts(card, row, words):
            for component in range(self._solids.mesh.dimension):
                value = density * numbers[0] * float(direction[component])
                if value != 0.0:
                    key = part, component
                    points = self._loads.body_forces.get(key, UNLOADED)
                    before = tuple(point for point in points if point[0] <= span.begin) or UNLOADED
                    self._loads.body_forces[key] = followed(before, span, value, amplitude, at_once)


    def _loaded_parts(self, card: Card, row: int, words: list[str]) -> list[tuple[str, float]]:
        """The parts on whose whole mass a line of *DLOAD acts, and their densities."""
        mesh = self._solids.mesh
        loaded = self._solids.elements(self._contents.ids(words[0], self._contents.element_sets, self._scope, card, row))
        count = numpy.bincount(mesh.block_of(loaded), minlength=len(mesh.blocks)) if len(loaded) else numpy.zeros(
            len(mesh.blocks), dtype=int)
        result = []
        for part, blocks in mesh.parts().items():
            held = sum(int(count[block]) for block in blocks)
            if not held:
                continue
            if held < sum(len(mesh.blocks[block].connectivity) for block in blocks):
                self._findings.leave_out(card.place_of(row), f"*DLOAD {words[1].upper()}", f"acts on a piece of part {part}: "
                                         "it is left out there; make that piece a section of its own")
                continue
            section = self._solids.sections[self._solids.section_of_part[part]]
            material = self._materials.get(section.material)
            density = material.density if material else 0.0
            if density == 0.0:
                self._findings.leave_out(card.place_of(row), f"*DLOAD {words[1].upper()}",
                                         f"the material of part {part} has no density")
                continue
            result.append((part, density))
        return result

    def _centrifugal(self, card: Card, row: int, words: list[str], span: Span, amplitude: "Points | None",
                     at_once: bool) -> None:
        numbers = [card.number(word, row) for word in words[2:9]]
        if len(numbers) < 7 or numbers[0] < 0.0 or not any(numbers[4:7]):
            raise Refused(f"{card.place_of(row)}: CENTRIF takes the square of an angular velocity, a point and a direction.")
        axis = numpy.array(numbers[4:7]) / float(numpy.linalg.norm(numbers[4:7]))
        about = {"C3D": None, "CAX": 1}.get(self._solids.family, 2)
        if about is not None and abs(abs(float(axis[about])) - 1.0) > ALONG:
            self._findings.leave_out(card.place_of(row), "*DLOAD CENTRIF", f"turns about another axis than {'xyz'[about]}")
            return
        for part, _ in self._loaded_parts(card, row, words):
            key = part, tuple(numbers[1:4]), tuple(float(x) for x in axis)
            points = self._loads.rotations.get(key, UNLOADED)
            before = tuple(point for point in points if point[0] <= span.begin) or UNLOADED
            self._loads.rotations[key] = followed(before, span, numbers[0], amplitude, at_once)
