"""Decks whose bolts are cut by equations instead of pretension sections: the same joint, as CalculiX can solve it.

At a pretension section CalculiX (pretensionsections.f) gives new nodes to those elements only that have a face on it. Of
tetrahedra others touch the section with an edge or a corner: they keep the old nodes and go on holding both halves together,
so that a force or displacement of the section hardly reaches the bolt. With nodes of its own for each half, and the equations
that CalculiX itself means, u_lower - u_upper + u_ref n = 0, it does.
"""
import numpy as np

from harmos.exchange.deck.cards import read_cards
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.steps import OUTPUT
from harmos.exchange.deck.solids import Solids
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import faces_of


class HalvedBolts:
    """A deck.

    Attributes:
        held_together: number of elements that in CalculiX go on holding halves together, were the sections left.
    """

    def __init__(self, path):
        """Reads the deck; its sections lie across x, y or z."""
        self.cards = read_cards(str(path))
        findings = Findings()
        self.contents = Contents(self.cards, findings)
        self.solids = Solids(self.contents, findings, str(path))
        self.held_together = 0
        self._new_nodes = []
        self._new_in_elements = {}
        self._equations = {}
        for card in self.cards:
            if card.keyword == "PRE-TENSIONSECTION":
                self._halve(card)

    def _halve(self, card):
        """Gives the half that has the faces of a section nodes of its own."""
        mesh, ids = self.solids.mesh, self.contents.node_ids
        faces = self.solids.surface(self.contents.surfaces[card.get("SURFACE")])
        part_of = np.array(mesh.part_of_block())
        own = part_of[mesh.block_of(faces[:1, 0])][0]
        nodes_of = [np.unique(np.concatenate([block.connectivity.ravel() for block, part in zip(mesh.blocks, part_of)
                                              if (part == own) == is_own])) for is_own in (True, False)]
        shared = np.intersect1d(*nodes_of)
        first = int(ids.max()) + 1 + len(self._new_nodes)
        new = {int(ids[node]): first + k for k, node in enumerate(shared)}
        self._new_nodes += [(first + k, *self.contents.coordinates[node]) for k, node in enumerate(shared)]
        touching = sum(int(np.isin(block.connectivity, shared).any(axis=1).sum())
                       for block, part in zip(mesh.blocks, part_of) if part == own)
        self.held_together += touching - len(np.unique(faces[:, 0]))
        for table in self.contents.elements:
            numbers = self.solids.elements(table.ids)
            if len(numbers) == len(table.ids):
                for element in table.ids[part_of[mesh.block_of(numbers)] == own].tolist():
                    self._new_in_elements[element] = new
        normal = card.table(3)[0] if card.data else self._normal(faces)
        axis = int(np.abs(normal).argmax())
        sign = float(np.sign(normal[axis]))
        self._equations[id(card)] = [
            [(old, component + 1, 1.0), (made, component + 1, -1.0)]
            + ([(int(card.get("NODE")), 1, sign)] if component == axis else [])
            for old, made in new.items() for component in range(3)]

    def _normal(self, rows):
        """Of faces, out of their elements."""
        faces = faces_of(self.solids.mesh)
        wanted = {tuple(row) for row in rows.tolist()}
        corners = self.solids.mesh.nodes[faces.corners[[tuple(row) in wanted for row in faces.rows().tolist()], :3]]
        return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]).sum(axis=0)

    def write(self, path, controls=""):
        """The deck with displacements of all nodes, and forces of the reference nodes of bolts, as its only output.
        controls: cards for every step."""
        tables = {id(table.card): table for table in self.contents.elements}
        last_nodes = max(number for number, card in enumerate(self.cards) if card.keyword == "NODE" and card.data)
        references = [card.get("NODE") for card in self.cards if card.keyword == "PRE-TENSIONSECTION"]
        with open(path, "w", encoding="latin-1") as file:
            for number, card in enumerate(self.cards):
                if card.keyword in OUTPUT:
                    continue
                if id(card) in self._equations:
                    file.write("*EQUATION\n")
                    for terms in self._equations[id(card)]:
                        file.write(f"{len(terms)}\n" + ", ".join(f"{n}, {c}, {value:g}" for n, c, value in terms) + "\n")
                    continue
                if card.keyword == "ENDSTEP":
                    file.write("*NODE FILE\nU\n*NODE PRINT, NSET=BOLT_REFERENCES\nU, RF\n")
                file.write("*" + ", ".join([card.keyword, *(f"{name}={value}" if value else name
                                                           for name, value in card.parameters.items())]) + "\n")
                if id(card) in tables:
                    for element, nodes in zip(tables[id(card)].ids.tolist(), tables[id(card)].nodes.tolist()):
                        new = self._new_in_elements.get(element, {})
                        file.write(", ".join(map(str, [element, *(new.get(node, node) for node in nodes)])) + "\n")
                else:
                    file.write("".join(f"{line}\n" for line in card.data))
                if number == last_nodes:
                    file.write("*NODE\n" + "".join("%d, %.12g, %.12g, %.12g\n" % row for row in self._new_nodes))
                    file.write("*NSET, NSET=BOLT_REFERENCES\n" + ",\n".join(references) + "\n")
                if card.keyword == "STEP":
                    file.write(controls)
