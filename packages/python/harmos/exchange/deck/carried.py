"""Loads of a deck on nodes that are held along them: they go into reactions alone, and a scene that has them is refused."""
import numpy

from harmos.arrays import Array
from harmos.exchange.contact import face_measures
from harmos.exchange.deck.loads import Loads
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Faces, Mesh

ALONG = 1e-6
"""Part of a direction across what is held that counts as none, as in `harmos check`."""

INTO_REACTION = "it goes into the reaction, and is left out"
"""What becomes of such a load."""


class Carried:
    """What supports carry at once."""

    def __init__(self, loads: Loads, mesh: Mesh) -> None:
        """Looks at what is held in the end."""
        self._loads, self._mesh = loads, mesh
        self._size = float(numpy.ptp(mesh.nodes, axis=0).max())
        self._components: dict[int, list[int]] = {}
        for node, component in loads.held:
            self._components.setdefault(node, []).append(component)
        self._forces: set[tuple[int, int]] = set()
        self._pressures: set[tuple[int, int]] = set()

    def takes_force(self, node: int, component: int) -> bool:
        """Whether a node is held along a global axis."""
        return self._takes(node, numpy.eye(3)[component])

    def takes_pressures(self, faces: Faces) -> bool:
        """Whether all nodes of faces are held along their normals."""
        first, blocks = self._mesh.first_elements(), self._mesh.block_of(faces.element)
        for element, side, number, normal in zip(faces.element, faces.side, blocks, face_measures(self._mesh, faces)[2]):
            block = self._mesh.blocks[number]
            nodes = block.connectivity[element - first[number], block.type.nodes_of_side(int(side))]
            if not all(self._takes(node, normal) for node in nodes.tolist()):
                return False
        return True

    def leave_out_forces(self, keys: set[tuple[int, int]]) -> None:
        """Takes note of forces, by node and component, that the scene lacks."""
        self._forces |= keys

    def leave_out_pressures(self, keys: set[tuple[int, int]]) -> None:
        """Takes note of pressures, by element and side, that the scene lacks."""
        self._pressures |= keys

    def tell(self, findings: Findings) -> None:
        """Lists what is left out, card by card."""
        for acting, left_out, what in ((self._loads.force_cards, self._forces, "nodes"), (self._loads.pressure_cards, self._pressures, "faces")):
            for card, keys in acting:
                lost = {key[0] if what == "nodes" else key for key in keys & left_out}
                if lost:
                    findings.leave_out(card.place, f"*{card.keyword}, reaction", f"on {len(lost)} {what} that are held along it: {INTO_REACTION}")

    def _takes(self, node: int, direction: Array) -> bool:
        components = self._components.get(node)
        if components is None:
            return False
        axes = self._loads.axes.get(node)
        held = (numpy.eye(3) if axes is None else axes.at(self._mesh.nodes[node], self._size))[components]
        return bool(numpy.linalg.norm(direction - held.T @ (held @ direction)) <= ALONG)
