"""The solids of a deck as a mesh with parts, and where its nodes and faces are in it."""
import collections
import dataclasses
import re

import numpy
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents, ElementTable, Surface
from harmos.exchange.deck.kinds import SPRINGS
from harmos.exchange.deck.scopes import INSTANCE_OFFSET
from harmos.exchange.elements import MESHIO, TYPES, Order, to_exodus
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Block, Mesh, demand_sound, faces_of, outer_faces, unused_name
from harmos.exchange.sense import oriented, turned_sides

_SOLID = re.compile(r"^(C3D|CPS|CPE|CAX)(\d+)([A-Z]*)$")

_KINDS: dict[str, dict[int, str]] = {
    "C3D": {4: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron", 10: "tetra10", 15: "wedge15", 20: "hexahedron20"},
    "plane": {3: "triangle", 4: "quad", 6: "triangle6", 8: "quad8"},
}

WEDGES = {"C3D6": 2, "C3D15": 9}
"""Points with which CalculiX integrates wedges, fewer than their stiffness needs."""

KINEMATICS = {"C3D": "3-D", "CPS": "Plane Stress", "CPE": "Plane Strain", "CAX": "Axisymmetric"}
"""What a family of elements computes."""

FACES: dict[str, list[str]] = {
    "TET": ["012", "013", "123", "023"], "PYRAMID": ["0123", "014", "124", "234", "034"],
    "WEDGE": ["012", "345", "0134", "1245", "0235"],
    "HEX": ["0123", "4567", "0145", "1256", "2367", "0347"],
    "TRI": ["01", "12", "02"], "QUAD": ["01", "12", "23", "03"],
}
"""Corners of the faces that decks number S1, S2, ..."""


@dataclasses.dataclass
class Section:
    """A solid section.

    Attributes:
        card: it stands on.
        material: its name in capitals.
        orientation: its name in capitals; may be empty.
        thickness: of plane elements; 0: not given.
    """
    card: Card
    material: str
    orientation: str
    thickness: float


def is_solid(kind: str) -> bool:
    """Whether a type of elements of a deck is a solid, or one of the plane, that Harmos has."""
    match = _SOLID.match(kind)
    return match is not None and int(match[2]) in _KINDS["C3D" if match[1] == "C3D" else "plane"]


def side_of(type_name: str, label: str) -> int:
    """The side in Exodus of a face such as S3 or P3; -1 where there is none."""
    digits = label.lstrip("SP")
    faces = FACES[type_name.rstrip("0123456789")]
    if not digits.isdecimal() or not 1 <= int(digits) <= len(faces):
        return -1
    wanted = {int(corner) for corner in faces[int(digits) - 1]}
    return [set(side) for side in TYPES[type_name].sides].index(wanted)


def _number(mesh: Mesh, node_ids: Array, element_ids: Array, findings: Findings) -> None:
    """Gives nodes and elements the numbers of the deck."""
    mesh.node_numbers = _numbers_of(node_ids, "nodes", findings)
    numbers = _numbers_of(element_ids, "elements", findings)
    for first, block in zip(mesh.first_elements(), mesh.blocks):
        block.numbers = numbers[first:first + len(block.connectivity)]


def _numbers_of(ids: Array, what: str, findings: Findings) -> Array:
    """Those of the deck; where its instances have the same ones, those of each after the first get digits in front."""
    numbers: Array = ids % INSTANCE_OFFSET
    instance = ids // INSTANCE_OFFSET
    if len(numpy.unique(numbers)) < len(numbers):
        step = 10 ** len(str(int(numbers.max())))
        numbers = numbers + step * (instance - instance.min())
        findings.found.append(f"instances of the deck have {what} of the same numbers: those of each but the first have {step}, {2 * step} "
                              "and so on added in the mesh")
    return numbers


class Solids:
    """The mesh of a deck.

    Attributes:
        mesh: whose blocks are those of parts.
        family: C3D, CPS, CPE or CAX.
        sections: of the deck.
        section_of_part: number of the section of each part, by name.
        modes_of_part: whether its elements have incompatible modes, by name.
    """

    def __init__(self, contents: Contents, findings: Findings, path: str, tells_formulations: bool = True) -> None:
        """Refuses what refers to nodes or elements that are not there; lists formulations of elements that Harmos has not."""
        self._tells_formulations = tells_formulations
        self._contents, self._findings, self._path = contents, findings, path
        self.sections: list[Section] = []
        self._section_ids: list[Array] = []
        self.section_of_part: dict[str, int] = {}
        self.modes_of_part: dict[str, bool] = {}
        for card in contents.model:
            if card.keyword == "SOLIDSECTION":
                self._read_section(card)
        tables = self._tables()
        self.mesh = Mesh(3 if self.family == "C3D" else 2, contents.coordinates.copy(), [])
        self._ids: Array = numpy.zeros(0, dtype=numpy.int64)
        self._make_parts(tables)
        demand_sound(path, self.mesh, self._name_of)
        self._turned = oriented(self.mesh, findings)
        self._order = numpy.argsort(self._ids, kind="stable")
        self._known = self._ids[self._order]
        self._used = numpy.zeros(len(self.mesh.nodes), dtype=bool)
        for block in self.mesh.blocks:
            self._used[block.connectivity] = True

    def _name_of(self, element: int) -> str:
        """What the deck calls an element of the mesh, and where it stands."""
        number = int(self._ids[element])
        place = next(table.card.place for table in self._contents.elements if (table.ids == number).any())
        return f"element {number % INSTANCE_OFFSET}, {place}"

    def _read_section(self, card: Card) -> None:
        name = card.get("ELSET")
        if name not in self._contents.element_sets:
            raise Refused(f"{card.place}: *SOLID SECTION of the element set \"{name}\", which is nowhere in the deck.")
        first = card.rows()[0] if card.data else [""]
        self.sections.append(Section(card, card.get("MATERIAL"), card.get("ORIENTATION"), card.number(first[0], 0)))
        found = self._contents.element_sets[name]
        self._section_ids.append(numpy.concatenate(found) if found else numpy.zeros(0, dtype=numpy.int64))

    def _tables(self) -> list[tuple[str, Order, bool, str, Array, Array]]:
        """Exodus type, order, incompatible modes, set, ids and node indices of the solids."""
        contents = self._contents
        self.family = self._family()
        coupled = [table.ids for card in contents.model if card.keyword == "DISTRIBUTINGCOUPLING"
                   for table in contents.elements_of(card.get("ELSET"))]
        result = []
        for table in contents.elements:
            if not len(table.ids):
                continue
            match = _SOLID.match(table.kind)
            kinds = _KINDS["C3D" if match and match[1] == "C3D" else "plane"]
            if table.kind in SPRINGS:
                continue
            if table.kind.startswith("DCOUP") and coupled and numpy.isin(table.ids, numpy.concatenate(coupled)).all():
                continue
            if not match or not is_solid(table.kind):
                self._findings.leave_out(table.card.place, f"*ELEMENT, TYPE={table.kind}",
                                         f"{len(table.ids)} elements are left out, with their stiffness and loads")
                continue
            if match[1] != self.family:
                self._findings.leave_out(table.card.place, f"*ELEMENT, TYPE={table.kind}",
                                         f"{len(table.ids)} elements are left out: a scene has one kind of mechanics, "
                                         f"here {KINEMATICS[self.family]}")
                continue
            if self._tells_formulations:
                self._tell_formulation(table, match[3])
            name, order = MESHIO[kinds[int(match[2])]]
            at = numpy.searchsorted(contents.node_ids, table.nodes)
            at = numpy.minimum(at, max(0, len(contents.node_ids) - 1))
            wrong = contents.node_ids[at] != table.nodes if len(contents.node_ids) else numpy.ones_like(at, dtype=bool)
            if wrong.any():
                row = int(numpy.flatnonzero(wrong.any(axis=1))[0])
                raise Refused(f"{table.card.place}: element {table.ids[row]} of this card refers to node "
                              f"{table.nodes[row][wrong[row]][0]}, which is nowhere in the deck.")
            result.append((name, order, "I" in match[3] and name in ("HEX8", "QUAD4"), table.set, table.ids, at))
        if not result:
            raise Refused(f"{self._path}: the deck holds no solid elements that Harmos has.\n"
                          + "\n".join(f"  left out: {each}" for each in self._findings.left_out))
        return result

    def _tell_formulation(self, table: ElementTable, letters: str) -> None:
        if "R" in letters:
            self._findings.leave_out(table.card.place, f"TYPE={table.kind}", "reduced integration: elements are "
                                     "integrated fully, which changes displacements by a part of the mesh error")
        if table.kind in WEDGES:
            self._findings.leave_out(table.card.place, f"TYPE={table.kind}", f"CalculiX integrates this wedge with {WEDGES[table.kind]} "
                                     "points: here it is integrated fully, which makes coarse meshes stiffer")
        if table.kind.startswith("CPS"):
            self._findings.leave_out(table.card.place, f"*ELEMENT, TYPE={table.kind}", "CalculiX makes a solid of each, "
                                     "whose stress across the plane is zero in the mean only: coarse meshes differ")
        if table.kind in ("C3D10M", "C3D10HS", "C3D10I") or letters.strip("RHIM"):
            self._findings.leave_out(table.card.place, f"TYPE={table.kind}", f"{table.kind.removesuffix(letters)} with displacements alone is "
                                     "taken: coarse meshes, and fields besides displacements, differ")
        if "H" in letters:
            self._findings.leave_out(table.card.place, f"TYPE={table.kind}", "hybrid elements: pressure is no "
                                     "unknown; use the formulation B-Bar where Poisson's ratio is above 0.45")

    def _family(self) -> str:
        """That of the elements with sections: solids before others, which may only mark surfaces."""
        held = numpy.unique(numpy.concatenate(self._section_ids)) if self._section_ids else numpy.zeros(0, dtype=numpy.int64)
        tables = [table for table in self._contents.elements if is_solid(table.kind)]
        of = [match[1] for table in tables if (match := _SOLID.match(table.kind)) and numpy.isin(table.ids, held).any()]
        of = of or [match[1] for table in tables if (match := _SOLID.match(table.kind))]
        return "C3D" if "C3D" in of else next(iter(of), "")

    def _make_parts(self, tables: list[tuple[str, Order, bool, str, Array, Array]]) -> None:
        section_of = self._sections_of(numpy.concatenate([ids for *_, ids, _ in tables]))
        split = numpy.cumsum([0] + [len(ids) for *_, ids, _ in tables])
        groups = collections.defaultdict(list)
        for number, (name, order, modes, own, ids, at) in enumerate(tables):
            rows = to_exodus(name, order, at)
            of = section_of[split[number]:split[number + 1]]
            without = int((of < 0).sum())
            if without:
                self._findings.leave_out(self._path, "elements without *SOLID SECTION", f"{without} elements are left out")
            for section in sorted(set(of[of >= 0].tolist())):
                groups[section, modes].append((name, own, ids[of == section], rows[of == section]))
        if not groups:
            raise Refused(f"{self._path}: no element has a *SOLID SECTION.")
        cuts = self._cut_faces()
        all_ids = []
        taken: set[str] = set()
        for (section, modes), members in groups.items():
            label = self._components(members, cuts)
            start = 0
            pieces: dict[int, list[tuple[str, str, Array, Array]]] = collections.defaultdict(list)
            for name, own, ids, rows in members:
                of = label[start:start + len(ids)]
                start += len(ids)
                for piece in numpy.unique(of):
                    pieces[int(piece)].append((name, own, ids[of == piece], rows[of == piece]))
            for piece in sorted(pieces):
                owners = {own for _, own, _, _ in pieces[piece]}
                part = unused_name((owners.pop() if len(owners) == 1 else "")
                                   or self.sections[section].card.parameters.get("ELSET", "part"), taken)
                taken.add(part)
                self.section_of_part[part], self.modes_of_part[part] = section, modes
                by_type = collections.defaultdict(list)
                for name, _, ids, rows in pieces[piece]:
                    by_type[name].append((ids, rows))
                for name, listed in by_type.items():
                    block = part if len(by_type) == 1 else unused_name(f"{part}_{name.lower()}", taken)
                    taken.add(block)
                    self.mesh.blocks.append(Block(block, TYPES[name], numpy.concatenate([rows for _, rows in listed]),
                                                  part))
                    all_ids.append(numpy.concatenate([ids for ids, _ in listed]))
        self._ids = numpy.concatenate(all_ids)
        _number(self.mesh, self._contents.node_ids, self._ids, self._findings)

    def _sections_of(self, ids: Array) -> Array:
        result = numpy.full(len(ids), -1)
        order = numpy.argsort(ids, kind="stable")
        for number, members in enumerate(self._section_ids):
            at = numpy.minimum(numpy.searchsorted(ids[order], members), len(ids) - 1)
            own = order[at[ids[order][at] == members]]
            for earlier in numpy.unique(result[own][result[own] >= 0]).tolist():
                self._findings.leave_out(self.sections[earlier].card.place, "*SOLID SECTION", f"{int((result[own] == earlier).sum())} of its "
                                         f"elements have the section of {self.sections[number].card.place}, which counts")
            result[own] = number
        return result

    def _cut_faces(self) -> list[tuple[int, str]]:
        """Element ids and labels of the faces of pretension sections."""
        result = []
        for card in self._contents.model:
            if card.keyword != "PRE-TENSIONSECTION":
                continue
            surface = self._contents.surfaces.get(card.get("SURFACE"))
            for ids, label in surface.rows if surface and not surface.of_nodes else []:
                result += [(int(each), label) for each in ids]
        return result

    @staticmethod
    def _components(members: list[tuple[str, str, Array, Array]], cuts: list[tuple[int, str]]) -> Array:
        """A number per element that is the same for those that hang together: by nodes, and where pretension sections
        cut through them by faces, but not by those of the sections."""
        count = sum(len(ids) for _, _, ids, _ in members)
        nodes = numpy.concatenate([rows[:, column] for _, _, _, rows in members for column in range(rows.shape[1])])
        element = numpy.concatenate([numpy.arange(len(rows)) + start for start, (_, _, _, rows) in zip(
            numpy.cumsum([0] + [len(each[2]) for each in members]), members) for _ in range(rows.shape[1])])
        shared = numpy.unique(nodes, return_inverse=True)[1].reshape(-1)
        size = count + int(shared.max()) + 1
        by_node = connected_components(coo_matrix((numpy.ones(len(nodes)), (element, shared + count)),
                                                  shape=(size, size)), directed=False)[1][:count]
        ids = numpy.concatenate([each[2] for each in members])
        wanted = {element_id for element_id, _ in cuts}
        own = numpy.array([int(each) in wanted for each in ids]) if wanted else numpy.zeros(count, dtype=bool)
        if not own.any():
            whole: Array = numpy.unique(by_node, return_inverse=True)[1].reshape(-1)
            return whole
        mesh = Mesh(TYPES[members[0][0]].dimension, numpy.zeros((int(nodes.max()) + 1, 3)),
                    [Block(str(n), TYPES[name], rows) for n, (name, _, _, rows) in enumerate(members)])
        faces = faces_of(mesh)
        key = numpy.unique(faces.key(), axis=0, return_inverse=True)[1].reshape(-1)
        number_of = {int(each): number for number, each in enumerate(ids)}
        of_block = mesh.block_of(numpy.arange(count))
        cut_rows = {(number_of[each], side_of(members[of_block[number_of[each]]][0], label))
                    for each, label in cuts if each in number_of}
        cut_keys = {int(k) for k, e, s in zip(key, faces.element, faces.side) if (int(e), int(s)) in cut_rows}
        open_faces = ~numpy.isin(key, list(cut_keys))
        size = count + int(key.max()) + 1
        by_face = connected_components(coo_matrix(
            (numpy.ones(int(open_faces.sum())), (faces.element[open_faces], key[open_faces] + count)),
            shape=(size, size)), directed=False)[1][:count]
        is_cut = numpy.isin(by_node, by_node[own])
        label = numpy.where(is_cut, by_face + by_node.max() + 1, by_node)
        result: Array = numpy.unique(label, return_inverse=True)[1].reshape(-1)
        return result

    def nodes(self, ids: Array) -> Array:
        """Indices of nodes that solids have, of those with these ids."""
        known = self._contents.node_ids
        at = numpy.minimum(numpy.searchsorted(known, ids), len(known) - 1)
        at = at[known[at] == ids]
        found: Array = at[self._used[at]]
        return found

    def used_nodes(self) -> Array:
        """Indices of all nodes that solids have."""
        return numpy.flatnonzero(self._used)

    def parts_of(self, nodes: Array) -> set[str]:
        """Names of the parts that have one of these nodes, given by their indices."""
        return {part for part, blocks in self.mesh.parts().items()
                if any(numpy.isin(nodes, self.mesh.blocks[block].connectivity).any() for block in blocks)}

    def elements(self, ids: Array) -> Array:
        """Numbers in the mesh of the elements with these ids, those that are solids."""
        known = self._known
        at = numpy.minimum(numpy.searchsorted(known, ids), len(known) - 1)
        found: Array = self._order[at[known[at] == ids]]
        return found

    def sides(self, ids: Array, label: str, place: str) -> Array:
        """The face with this label of the elements with these ids, as a side set.

        Raises:
            Refused: an element has no such face, or is nowhere in the deck.
        """
        known = {int(each) for table in self._contents.elements for each in table.ids} if not len(ids) or len(
            self.elements(ids)) < len(ids) else set()
        missing = [int(each) for each in ids if known and int(each) not in known]
        if missing:
            raise Refused(f"{place}: the element {missing[0]} is nowhere in the deck.")
        elements = self.elements(ids)
        rows = []
        for number, element in zip(self.mesh.block_of(elements), elements):
            side = side_of(self.mesh.blocks[number].type.name, label)
            if side < 0:
                raise Refused(f"{place}: elements {self.mesh.blocks[number].type.name} have no face \"{label}\"; they have "
                              f"S1 to S{len(self.mesh.blocks[number].type.sides)}.")
            rows.append((int(element), side))
        return turned_sides(self.mesh, self._turned, numpy.array(rows, dtype=numpy.int64).reshape(-1, 2))

    def nodes_of_sides(self, rows: Array) -> Array:
        """Indices of all nodes of faces, given as a side set."""
        first = self.mesh.first_elements()
        numbers = self.mesh.block_of(rows[:, 0])
        found = [numpy.zeros(0, dtype=numpy.int64)]
        for number, side in sorted(set(zip(numbers.tolist(), rows[:, 1].tolist()))):
            block = self.mesh.blocks[number]
            own = rows[(numbers == number) & (rows[:, 1] == side), 0] - first[number]
            found.append(block.connectivity[own][:, block.type.nodes_of_side(side)].reshape(-1))
        return numpy.unique(numpy.concatenate(found))

    def faces_on(self, nodes: Array, part: str = "") -> Array:
        """The outer faces, of all parts or of one, whose corners are all among these nodes, as a side set."""
        outer = outer_faces(self.mesh)
        inside = (numpy.isin(outer.corners, nodes) | (outer.corners < 0)).all(axis=1)
        if part:
            inside &= numpy.asarray(self.mesh.part_of_block())[self.mesh.block_of(outer.element)] == list(self.mesh.parts()).index(part)
        return outer.chosen(inside).rows()

    def surface(self, surface: Surface) -> Array:
        """A surface as a side set; of nodes: the outer faces whose corners are all among them, of elements without
        labels: their outer faces."""
        outer = outer_faces(self.mesh)
        rows = [numpy.zeros((0, 2), dtype=numpy.int64)]
        for ids, label in surface.rows:
            if surface.of_nodes:
                continue
            if label:
                rows.append(self.sides(ids, label, surface.card.place))
            else:
                rows.append(outer.chosen(numpy.isin(outer.element, self.elements(ids))).rows())
        if surface.of_nodes and surface.rows:
            held = self.nodes(numpy.concatenate([ids for ids, _ in surface.rows]))
            rows.append(self.faces_on(held))
            loose = numpy.setdiff1d(held, self.nodes_of_sides(rows[-1]))
            if len(loose):
                self._findings.leave_out(surface.card.place, "*SURFACE, TYPE=NODE", f"{len(loose)} of its nodes are on no face whose corners "
                                         "are all in it: they move as they like")
        return numpy.unique(numpy.concatenate(rows), axis=0)
