"""Interfaces of a deck: ties, contact pairs, pretension sections, and parts that share nodes."""
import itertools
from collections.abc import Callable

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.adjust import gaps_of_faces, longest_edge, move_onto
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.curves import Histories
from harmos.exchange.deck.equations import Tie
from harmos.exchange.deck.interactions import Interactions
from harmos.exchange.deck.loads import Preload
from harmos.exchange.deck.solids import Solids
from harmos.exchange.findings import Findings, Refusals, Refused, names_there
from harmos.exchange.contact import face_each_other, face_measures, lie_opposite
from harmos.exchange.mesh import FORBIDDEN, clean_name, codes, ended_name, outer_faces, unused_name
from harmos.exchange.scene import SceneList
from harmos.exchange.sides import split_by_part

TIE_REACH = 0.1
"""Distance up to which tied surfaces are joined, over the longest edge of both: that of the program."""

SAME = 1e-6
"""Distance over the size of the mesh that is none: decks have six digits."""

SEARCH = 1.1
"""Distance within which faces are looked for, over the largest of those that a deck ties: facets lie farther than their nodes."""

DIP = 1.5
"""Overlap of faces whose middle nodes ADJUST moves, over that distance: 4/3 in the mean that contact sees where a parabola of height h
loses its h/4 in the middle."""


class Joints:
    """Writes the interfaces of a scene.

    Attributes:
        has_contact: one of them may open.
    """

    def __init__(self, contents: Contents, solids: Solids, scene: SceneList, findings: Findings) -> None:
        """Adds to this scene and to the sets of the mesh of the solids."""
        self._contents, self._solids, self._scene, self._findings = contents, solids, scene, findings
        self._faces: dict[frozenset[str], list[Array]] = {}
        self.has_contact = False
        self._interactions = Interactions(contents.model, findings)

    @property
    def joined(self) -> set[frozenset[str]]:
        """Pairs of parts between which there is an interface."""
        return set(self._faces)

    def write(self, histories: Histories, preloads: dict[int, Preload], ties: list[Tie]) -> None:
        """All of them; `preloads`: by reference node; `ties`: of equations."""
        refusals = Refusals()
        for card in self._contents.model:
            with refusals.collect():
                if card.keyword == "TIE":
                    self._tie(card)
                elif card.keyword == "CONTACTPAIR":
                    self._contact(card)
                elif card.keyword == "PRE-TENSIONSECTION":
                    self._pretension(card, histories, preloads)
        refusals.raise_if_any()
        for tie in ties:
            self._equal_motions(tie)
        self._shared_nodes()

    def _tie(self, card: Card) -> None:
        if "CYCLICSYMMETRY" in card.parameters:
            self._findings.leave_out(card.place, "*TIE, CYCLIC SYMMETRY", "a sector is not joined to its copies: its cuts are free")
            return
        self._pairs(card, "tie", lambda interface: interface.child("Law").set("Type", "Perfect"))

    def _equal_motions(self, tie: Tie) -> None:
        sides = self._unjoined((tie.parts[0], tie.parts[1]), tie.sides)
        if not len(sides[0]) or not len(sides[1]):
            self._findings.leave_out(tie.card.place, "*EQUATION", f"equations that tie {tie.parts[0]} to {tie.parts[1]} on faces that an interface "
                                     "has already")
            return
        name = self._join((tie.parts[0], tie.parts[1]), sides)
        self._findings.found.append(f"{tie.card.place}: equations tie {tie.parts[0]} to {tie.parts[1]}: interface {name}")

    def _contact(self, card: Card) -> None:
        if "TIED" in card.parameters:
            self._tie(card)
            return
        interaction = self._interactions.find(card)
        closed = self._adjust(card) if "ADJUST" in card.parameters else 0.0

        def write(interface: SceneList) -> None:
            if closed > 0.0:
                interface.comment("Between nodes that ADJUST has moved, curved faces would lie in the others.")
                interface.set("Gap", "Closed").set("Closed Within", closed)
            interaction.write(interface.child("Law"))

        if self._pairs(card, "contact", write):
            self.has_contact |= interaction.may_open

    def _adjust(self, card: Card) -> float:
        """Moves the nodes of slave surfaces onto their masters, up to a gap or of a node set; the gap up to which the surfaces count as
        closed then, 0 where no node was moved."""
        word = card.get("ADJUST")
        sets = self._contents.node_sets
        chosen = self._solids.nodes(numpy.unique(numpy.concatenate(sets[word]))) if sets.get(word) else None
        reach = 0.0
        if chosen is None:
            try:
                reach = float(word or "0")
            except ValueError:
                raise Refused(f"{card.place}: *CONTACT PAIR, ADJUST={word}: it takes a distance or a node set. "
                              f"{names_there(word, sets)}") from None
        farthest = 0.0
        for row, words in enumerate(card.rows()):
            if len(words) < 2 or not words[1]:
                continue
            slave, master = (self._surface(each, card, row) for each in words[:2])
            if not len(slave) or not len(master):
                continue
            moved = move_onto(self._solids.mesh, slave, master, reach, chosen)
            farthest = max(farthest, float(moved.max(initial=0.0)))
            self._findings.found.append(f"{card.place_of(row)}: ADJUST: {len(moved)} nodes of {words[0]} moved onto {words[1]}")
        return max(reach, DIP * farthest) if farthest > 0.0 else 0.0

    def _pairs(self, card: Card, word: str, write: Callable[[SceneList], object]) -> int:
        """An interface for each line with two surfaces and each pair of parts on them; how many."""
        count = 0
        for row, words in enumerate(card.rows()):
            if len(words) < 2 or not words[1]:
                self._findings.leave_out(card.place_of(row), f"*{card.keyword}", "contact of a surface with itself")
                continue
            slave, master = (self._surface(each, card, row) for each in words[:2])
            reach, beyond = (TIE_REACH if word == "tie" else 1.0), 0.0
            if word == "tie" and card.get("POSITIONTOLERANCE") and len(slave) and len(master):
                slave, gap = self._tied(slave, master, card, words)
                if not len(slave):
                    continue
                longest = max(longest_edge(self._solids.mesh, each) for each in (slave, master))
                beyond = SEARCH * gap if SEARCH * gap > reach * longest else 0.0
                reach = max(reach, beyond / longest)
            pieces = list(itertools.product(split_by_part(self._solids.mesh, slave).items(),
                                            split_by_part(self._solids.mesh, master).items()))
            mesh = self._solids.mesh
            near, far, why = [], 0, "contact of a part with itself, or of surfaces that no solid has"
            for (part, rows), (other_part, other_rows) in pieces:
                if part == other_part:
                    continue
                if not lie_opposite(mesh, rows, other_rows, reach):
                    why = f"no face of {words[0]} lies opposite one of {words[1]} nearer than {reach:g} of the longest edge"
                    far += 1
                elif not face_each_other(mesh, rows, other_rows):
                    why = f"{words[0]} and {words[1]} look the same way: {part} and {other_part} overlap"
                else:
                    near.append(((part, rows), (other_part, other_rows)))
            if not near:
                self._findings.leave_out(card.place_of(row), f"*{card.keyword}", why)
            elif far:
                self._findings.found.append(f"{card.place_of(row)}: {far} of {len(pieces)} pairs of parts on {words[0]} and {words[1]} lie "
                                            f"farther apart than {reach:g} of the longest edge: between them there is no {word}")
            for (part, rows), (other_part, other_rows) in near:
                base = clean_name(f"{words[0]}_{words[1]}".lower()) if len(near) == 1 else f"{part}_{other_part}"
                name = unused_name(base, set(self._scene.child("Interfaces").names()))
                interface = self._scene.child("Interfaces").child(name)
                for side, (given, faces) in enumerate(((words[0], rows), (words[1], other_rows)), 1):
                    interface.set(f"Side {side}", self.add_side_set(given, faces))
                if beyond > 0.0:
                    interface.set("Search Distance", beyond)
                write(interface)
                self._note((part, other_part), rows, other_rows)
                self._findings.found.append(f"{card.place_of(row)}: {word} of {words[0]} and {words[1]}: interface {name}")
                count += 1
        return count

    def _tied(self, slave: Array, master: Array, card: Card, words: list[str]) -> tuple[Array, float]:
        """The faces of a slave surface that the deck ties, whose nodes are moved onto the master unless ADJUST forbids it; and how far
        they lie from it then."""
        mesh = self._solids.mesh
        tolerance = card.number(card.get("POSITIONTOLERANCE"), len(card.first))
        gap = gaps_of_faces(mesh, slave, master)
        near = gap <= max(tolerance, SAME * float(numpy.ptp(mesh.nodes, axis=0).max()))
        if not near.all():
            self._findings.found.append(f"{card.place}: {int((~near).sum())} of {len(near)} faces of {words[0]} lie beside {words[1]} or farther "
                                        f"from it than {tolerance:g}: they are not tied, as in the deck")
        if not near.any() or card.get("ADJUST") == "NO":
            return slave[near], float(gap[near].max(initial=0.0))
        moved = move_onto(mesh, slave[near], master, tolerance, None)
        if len(moved):
            self._findings.found.append(f"{card.place}: {len(moved)} nodes of {words[0]} moved onto {words[1]}, as without ADJUST=NO, by up to "
                                        f"{float(moved.max()):.3g}")
        return slave[near], 0.0

    def add_side_set(self, name: str, rows: Array) -> str:
        """The name of the side set with these faces, which is made unless there is one."""
        for known, given in self._solids.mesh.side_sets.items():
            if len(given) == len(rows) and numpy.array_equal(given, rows):
                return known
        result = unused_name(FORBIDDEN.sub("_", name), {**self._solids.mesh.side_sets, **self._solids.mesh.node_sets})
        self._solids.mesh.side_sets[result] = rows
        return result

    def _surface(self, name: str, card: Card, row: int) -> Array:
        surface = self._contents.surfaces.get(name.upper())
        if surface is None:
            raise Refused(f"{card.place_of(row)}: *{card.keyword}: there is no surface \"{name}\". "
                          f"{names_there(name, self._contents.surfaces)}")
        rows = self._solids.surface(surface)
        if not len(rows):
            self._findings.leave_out(surface.card.place, f"*SURFACE {name}", "no solid has a face on it")
        return rows

    def _pretension(self, card: Card, histories: Histories, preloads: dict[int, Preload]) -> None:
        surface = self._contents.surfaces.get(card.get("SURFACE"))
        if surface is None or not card.get("NODE"):
            self._findings.leave_out(card.place, "*PRE-TENSION SECTION", "preload of beams, or without a surface and a node")
            return
        rows = self._solids.surface(surface)
        names = list(self._solids.mesh.parts())
        owners = {names[self._solids.mesh.part_of_block()[block]]
                  for block in self._solids.mesh.block_of(rows[:, 0])} if len(rows) else set()
        twins = self._twins(rows)
        others = {names[self._solids.mesh.part_of_block()[block]]
                  for block in self._solids.mesh.block_of(twins[:, 0])} if len(twins) else set()
        if len(owners) != 1 or len(others) != 1 or owners == others:
            self._findings.leave_out(card.place, "*PRE-TENSION SECTION", "its surface does not cut a body in two; give the "
                                     "preload by the law Preload Jump between two parts")
            return
        own, other = owners.pop(), others.pop()
        name = unused_name(f"preload_{clean_name(card.parameters['SURFACE'])}".lower(),
                           set(self._scene.child("Interfaces").names()))
        preload = preloads.get(self._contents.single_node(card, "NODE"), Preload())
        points = preload.points
        if self._points_inwards(card, rows):
            points = tuple((time, -value) for time, value in points)
        interface = self._scene.child("Interfaces").child(name)
        interface.set("Side 1", self.add_side_set(card.parameters["SURFACE"], rows))
        interface.set("Side 2", self.add_side_set(f"{card.parameters['SURFACE']}_other", twins))
        law = interface.child("Law").set("Type", "Pretension" if preload.is_force else "Preload Jump")
        histories.set(law, "Force" if preload.is_force else "Jump", points)
        if preload.is_force and preload.locked is not None:
            law.set("Locked From", preload.locked)
        self._scene.child("Responses").child(ended_name(f"bolt_force_{name}", "")).set("Type", "Bolt Force").set("Interface", name)
        self._note((own, other), rows, twins)
        self._findings.found.append(f"{card.place}: pretension section: interface {name} between {own} and {other}")
        beside = self._beside(rows, own)
        if beside:
            self._findings.found.append(f"{card.place}: {beside} elements of {own} touch the section without a face on it: CalculiX does "
                                        "not cut them, and they hold its halves together there; here they are cut")

    def _beside(self, rows: Array, part: str) -> int:
        """How many elements of a part have nodes of sides, but none of these."""
        mesh = self._solids.mesh
        outer = outer_faces(mesh)
        corners = outer.corners[numpy.isin(*codes(outer.rows(), rows))]
        touching = sum(int(numpy.isin(mesh.blocks[block].connectivity, corners).any(axis=1).sum()) for block in mesh.parts()[part])
        return touching - len(numpy.unique(rows[:, 0]))

    def _points_inwards(self, card: Card, rows: Array) -> bool:
        """Whether the vector of a pretension section, along which displacements count, points into its elements."""
        if not card.data:
            return False
        vector = card.table(3)[0]
        outer = outer_faces(self._solids.mesh)
        chosen = outer.chosen(numpy.isin(codes(outer.rows(), rows)[0], codes(outer.rows(), rows)[1]))
        _, _, normal, area = face_measures(self._solids.mesh, chosen)
        return bool((normal * area[:, None]).sum(axis=0) @ vector < 0.0)

    def _twins(self, rows: Array) -> Array:
        """The sides on the other parts that have the same corners."""
        outer = outer_faces(self._solids.mesh)
        key = outer.key()
        of = {tuple(each) for each in rows.tolist()}
        mine = numpy.array([pair in of for pair in map(tuple, outer.rows().tolist())], dtype=bool)
        wanted = {tuple(each) for each in key[mine].tolist()}
        theirs = numpy.array([tuple(each) in wanted for each in key.tolist()], dtype=bool) & ~mine
        return outer.chosen(theirs).rows()

    def _shared_nodes(self) -> None:
        """Parts that share nodes are one body in the deck."""
        mesh = self._solids.mesh
        used = {name: numpy.unique(numpy.concatenate([mesh.blocks[block].connectivity.reshape(-1) for block in blocks]))
                for name, blocks in mesh.parts().items()}
        for (one, nodes), (other, theirs) in itertools.combinations(used.items(), 2):
            shared = numpy.intersect1d(nodes, theirs)
            if not len(shared):
                continue
            sides = self._unjoined((one, other), (self._solids.faces_on(shared, one), self._solids.faces_on(shared, other)))
            if len(sides[0]) and len(sides[1]):
                name = self._join((one, other), sides)
                self._findings.found.append(f"{one} and {other} share nodes: interface {name}")
            elif frozenset([one, other]) not in self._faces:
                self._findings.leave_out(self._solids.sections[self._solids.section_of_part[other]].card.place, "*SOLID SECTION",
                                         f"{one} and {other} share {len(shared)} nodes, but no face: these move as they like")

    def _unjoined(self, parts: tuple[str, str], sides: tuple[Array, Array]) -> tuple[Array, Array]:
        """The faces that no interface between two parts has yet."""
        taken = self._faces.get(frozenset(parts), [])
        one, other = (rows[~numpy.isin(*codes(rows, numpy.concatenate(taken)))] if taken else rows for rows in sides)
        return one, other

    def _note(self, parts: tuple[str, str], *sides: Array) -> None:
        """Takes note of an interface between two parts."""
        self._faces.setdefault(frozenset(parts), []).extend(sides)

    def _join(self, parts: tuple[str, str], sides: tuple[Array, Array]) -> str:
        """Makes a perfect interface; its name."""
        name = unused_name("_".join(parts), set(self._scene.child("Interfaces").names()))
        interface = self._scene.child("Interfaces").child(name)
        for side, (own, other, faces) in enumerate(zip(parts, reversed(parts), sides), 1):
            interface.set(f"Side {side}", self.add_side_set(f"{own}_on_{other}", faces))
        interface.child("Law").set("Type", "Perfect")
        self._note(parts, *sides)
        return name
