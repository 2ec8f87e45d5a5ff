"""Boundaries and loads of a deck over its steps."""
import typing

import numpy

from harmos.exchange.deck.acting import Acting
from harmos.exchange.deck.amplitudes import Amplitudes
from harmos.exchange.deck.boundaries import Boundaries
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents, Step
from harmos.exchange.deck.couplings import Couplings
from harmos.exchange.deck.curves import Points, Span, followed
from harmos.exchange.deck.distributed import DistributedLoads
from harmos.exchange.deck.loads import Loads
from harmos.exchange.deck.materials import Material
from harmos.exchange.deck.nodal_loads import NodalLoads
from harmos.exchange.deck.parameters import UNKNOWN
from harmos.exchange.deck.solids import Solids
from harmos.exchange.deck.tightening import Tightening
from harmos.exchange.deck.transforms import Transforms
from harmos.exchange.findings import Findings, Refusals

STATIC = ("STATIC",)
"""Procedures that Harmos has."""

OUTPUT = ("NODEPRINT", "ELPRINT", "NODEFILE", "ELFILE", "CONTACTPRINT", "CONTACTFILE", "SECTIONPRINT", "FACEPRINT",
          "OUTPUT", "NODEOUTPUT", "ELEMENTOUTPUT", "CONTACTOUTPUT", "ELEMENTFILE", "ELEMENTPRINT", "PREPRINT", "RESTART",
          "MONITOR", "ENERGYPRINT", "CONTROLS", "FILEFORMAT")
"""What asks for output or steers iterations."""

class LoadReader:
    """Follows the steps of a deck."""

    def __init__(self, contents: Contents, solids: Solids, materials: dict[str, Material], couplings: Couplings,
                 joined: set[int], ground: set[int], findings: Findings) -> None:
        """Keeps all of them; what acts on reference nodes is added to the couplings. `joined`: nodes (indices in the mesh)
        of equations, which may be held without belonging to a solid; `ground`: ids of nodes where springs end."""
        self._contents, self._couplings, self._findings = contents, couplings, findings
        self._loads = Loads()
        self._refusals = Refusals()
        self._tightening = Tightening(contents, self._loads.preloads, findings)
        acting = Acting(contents, solids, couplings, Transforms(contents, solids, findings), self._tightening, self._loads, findings)
        self._amplitudes = amplitudes = Amplitudes(contents, findings)
        self._boundaries = Boundaries(acting, amplitudes, joined, ground)
        self._nodal = NodalLoads(acting, amplitudes, materials)
        self._distributed = DistributedLoads(acting, amplitudes, materials)
        for card in contents.model:
            sets = contents.node_sets.get(card.get("NSET"), []) if card.keyword == "TRANSFORM" else []
            if any(numpy.isin(ids, list(couplings.at_node)).any() for ids in sets):
                findings.leave_out(card.place, "*TRANSFORM of a reference node", "what acts there counts in global axes")

    def read(self) -> Loads:
        """All of it.

        Raises:
            Refused: loads on sets that are not there, boundaries that contradict each other.
        """
        for card in self._contents.model:
            if card.keyword == "BOUNDARY":
                with self._refusals.collect():
                    self._boundaries.read(card, Span(-1.0, 0.0), True)
            elif card.keyword == "INITIALCONDITIONS" and card.get("TYPE") == "TEMPERATURE":
                with self._refusals.collect():
                    self._nodal.read_temperatures(card, None, True)
        for key, points in self._loads.held.items():
            self._loads.held[key] = ((0.0, points[-1][1]),)
        time = 0.0
        for number, step in enumerate(self._contents.steps, 1):
            procedure = [card for card in step.cards if card.keyword in STATIC]
            if not procedure:
                named = [card for card in step.cards if card.keyword not in OUTPUT]
                self._findings.leave_out(step.card.place, "*STEP", f"the step *{named[0].keyword if named else 'STEP'}: "
                                         "Harmos has static steps")
                self._hold_from(step, time)
                continue
            time = self._step(step, procedure[0], number, time)
        self._refusals.raise_if_any()
        return self._loads

    def _hold_from(self, step: Step, time: float) -> None:
        """Boundaries of a step that is left out stay: those before all other steps hold from the beginning, others are listed."""
        for card in step.cards:
            if card.keyword != "BOUNDARY":
                continue
            if time > 0.0:
                self._findings.leave_out(card.place, "*BOUNDARY", "boundaries of a step that is left out")
                continue
            with self._refusals.collect():
                self._boundaries.read(card, Span(-1.0, 0.0), True)

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
        self._tell_what_ends(step, span)
        self._free(step, span)
        for card in step.cards:
            with self._refusals.collect():
                if card.keyword == "BOUNDARY":
                    self._boundaries.read(card, span, at_once)
                elif card.keyword == "CLOAD":
                    self._nodal.read_forces(card, span, at_once)
                elif card.keyword in ("DLOAD", "DSLOAD"):
                    self._distributed.read(card, span, at_once)
                elif card.keyword == "TEMPERATURE":
                    self._nodal.read_temperatures(card, span, at_once)
                elif card.keyword not in OUTPUT and card is not static:
                    self._findings.leave_out(card.place, f"*{card.keyword}", UNKNOWN)
        return span.end

    def _tell_what_ends(self, step: Step, span: Span) -> None:
        """Lists amplitudes of the time of all steps that would go on in later ones."""
        if step is self._contents.steps[-1]:
            return
        for card in step.cards:
            if card.get("AMPLITUDE") and self._amplitudes.goes_on(card, span):
                self._findings.leave_out(card.place, f"*{card.keyword}, AMPLITUDE={card.get('AMPLITUDE')}", "its total time goes on behind "
                                         "this step: from there on what it multiplies stays as it is")

    def _free(self, step: Step, span: Span) -> None:
        """What OP=NEW takes away."""
        new = {card.keyword: card for card in step.cards if card.get("OP") == "NEW"}
        loads = self._loads
        if "CLOAD" in new:
            _release(loads.forces, span)
            _release(loads.turned_forces, span)
            for coupling in self._couplings.all:
                _release(coupling.forces, span)
            self._tightening.release(span)
        if "DLOAD" in new or "DSLOAD" in new:
            _release(loads.pressures, span)
            _release(loads.body_forces, span)
            _release(loads.rotations, span)
        if "TEMPERATURE" in new:
            for node, points in loads.temperatures.items():
                loads.temperatures[node] = followed(points, span, points[0][1], None, False)
        if "BOUNDARY" in new:
            self._boundaries.list_released(new["BOUNDARY"], step)


_Key = typing.TypeVar("_Key")


def _release(table: dict[_Key, Points], span: Span) -> None:
    """Lets all curves go to 0 over a step."""
    for key, points in table.items():
        table[key] = followed(points, span, 0.0, None, False)
