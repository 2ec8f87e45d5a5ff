"""Couplings of a deck: faces that follow a reference node, as boundaries of a scene."""
import dataclasses

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.areas import nodal_areas
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.carried import INTO_REACTION
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.curves import Histories, Points, peak
from harmos.exchange.deck.scopes import Scope
from harmos.exchange.deck.solids import Solids
from harmos.exchange.findings import Findings, Refused, names_there
from harmos.exchange.mesh import clean_name, ended_name, outer_faces, unused_name
from harmos.exchange.scene import SceneList

ON_ONE_LINE = 1e-6
"""Width of nodes over their largest coordinate up to which they lie on one line, and share of them in the surface over the
largest of a node up to which they have none."""

LARGE_ROTATION = 0.1
"""Rotation from which an import warns [radians]: displacements linear in it are off by its half."""

_HELD = ("X", "Y", "Z", "Rotation X", "Rotation Y", "Rotation Z")
_FORCES = ("Force X", "Force Y", "Force Z", "Moment X", "Moment Y", "Moment Z")
_WRITTEN = {"COUPLING": "COUPLING", "DISTRIBUTINGCOUPLING": "DISTRIBUTING COUPLING", "RIGIDBODY": "RIGID BODY"}


@dataclasses.dataclass
class Coupling:
    """A face, or some nodes, that follow a reference node.

    Attributes:
        card: it stands on.
        name: of the surface or node set.
        point: where the reference node is.
        is_rigid: they move as a rigid body; else on the mean.
        sides: element and side of the faces; None: nodes.
        nodes: index in the mesh, where it is nodes.
        held: curve by component from 0, rotations behind displacements.
        forces: the same of forces and moments.
        springs: stiffness of springs to the ground, by the same.
    """
    card: Card
    name: str
    point: list[float]
    is_rigid: bool
    sides: "Array | None"
    nodes: Array
    held: dict[int, Points] = dataclasses.field(default_factory=dict)
    forces: dict[int, Points] = dataclasses.field(default_factory=dict)
    springs: dict[int, float] = dataclasses.field(default_factory=dict)

    def has_faces(self) -> bool:
        """Whether faces follow, not nodes."""
        return self.sides is not None

    def take(self, other: "Coupling") -> None:
        """Adds the faces of another one."""
        self.sides = numpy.unique(numpy.concatenate([sides for sides in (self.sides, other.sides) if sides is not None]), axis=0)


class Couplings:
    """All couplings of a deck.

    Attributes:
        all: in their order.
        at_node: coupling and first component, by the id of a reference node.
    """

    def __init__(self, contents: Contents, solids: Solids, findings: Findings) -> None:
        """Reads them; what Harmos has not is listed.

        Raises:
            Refused: a surface, set or node is not there.
        """
        self._contents, self._solids, self._findings = contents, solids, findings
        self.all: list[Coupling] = []
        self.at_node: dict[int, tuple[Coupling, int]] = {}
        for number, card in enumerate(contents.model):
            if card.keyword == "COUPLING":
                follower = contents.model[number + 1] if number + 1 < len(contents.model) else None
                self._coupling(card, follower)
            elif card.keyword == "DISTRIBUTINGCOUPLING":
                self._distributing(card)
            elif card.keyword == "RIGIDBODY":
                self._rigid_body(card)

    def _coupling(self, card: Card, kind: "Card | None") -> None:
        if kind is None or kind.keyword not in ("KINEMATIC", "DISTRIBUTING"):
            raise Refused(f"{card.place}: *COUPLING is followed by *KINEMATIC or *DISTRIBUTING.")
        is_rigid = kind.keyword == "KINEMATIC"
        if not is_rigid and not {1, 2, 3} <= self._components(kind):
            self._findings.leave_out(kind.place, "*DISTRIBUTING", "of some components only: all of them are joined to the mean motion")
        if kind.get("WEIGHTINGMETHOD") not in ("", "UNIFORM"):
            self._findings.leave_out(kind.place, f"*DISTRIBUTING, WEIGHTINGMETHOD={kind.get('WEIGHTINGMETHOD')}", "all of the surface counts alike")
        if is_rigid and not {1, 2, 3} <= self._components(kind):
            self._findings.leave_out(card.place, "*COUPLING, *KINEMATIC", "of some components only: the face is free")
            return
        surface = self._contents.surfaces.get(card.get("SURFACE"))
        if surface is None:
            raise Refused(f"{card.place}: *COUPLING: there is no surface \"{card.get('SURFACE')}\". "
                          f"{names_there(card.get('SURFACE'), self._contents.surfaces)}")
        rows = self._solids.surface(surface)
        if not len(rows):
            self._findings.leave_out(card.place, "*COUPLING", "no solid has a face on its surface")
            return
        node = self._id(card, "REFNODE")
        self._add(Coupling(card, card.parameters["SURFACE"], self._point(node), is_rigid, rows,
                           numpy.zeros(0, dtype=numpy.int64)), node, None)

    def _components(self, kind: Card) -> set[int]:
        """Those that lines of *KINEMATIC or *DISTRIBUTING name; all, without lines."""
        if not kind.data:
            return {1, 2, 3}
        result: set[int] = set()
        for row, words in enumerate(kind.rows()):
            numbers = [int(kind.number(word, row)) for word in words if word]
            result.update(range(numbers[0], numbers[-1] + 1))
        return result

    def _distributing(self, card: Card) -> None:
        """The older form: nodes with weights, and the reference node in an element of its own."""
        elements = [table for table in self._contents.elements_of(card.get("ELSET")) if table.kind.startswith("DCOUP")]
        if not elements:
            raise Refused(f"{card.place}: *DISTRIBUTING COUPLING: no element DCOUP3D is in the set \"{card.get('ELSET')}\". "
                          f"{names_there(card.get('ELSET'), self._contents.element_sets)}")
        found, weights = [], []
        for row, words in enumerate(card.rows()):
            ids = self._contents.ids(words[0], self._contents.node_sets, Scope(), card, row)
            found.append(ids)
            weights += [card.number(words[1], row) if len(words) > 1 and words[1] else 1.0] * len(ids)
        ids = numpy.concatenate(found) if found else numpy.zeros(0, dtype=numpy.int64)
        nodes = numpy.unique(self._solids.nodes(ids))
        sides = numpy.unique(self._solids.faces_on(nodes), axis=0)
        if not len(sides):
            self._findings.leave_out(card.place, "*DISTRIBUTING COUPLING", "its nodes are those of no face of a solid: what acts on its "
                                     "reference node is left out")
            return
        loose = numpy.setdiff1d(nodes, self._solids.nodes_of_sides(sides))
        if len(loose):
            self._findings.leave_out(card.place, "*DISTRIBUTING COUPLING", f"{len(loose)} of its nodes are on no face whose corners are all in "
                                     "it: they count in the middle only")
        self._findings.found.append(f"{card.place}: nodes count by their area"
                                    + ("" if max(weights) == min(weights) else ", not by the weights that the deck gives them"))
        node = int(elements[0].nodes[0, 0])
        point = [float(x) for x in self._solids.mesh.nodes[nodes].mean(axis=0)[:self._solids.mesh.dimension]]
        if numpy.abs(numpy.array(point) - self._point(node)).max() > ON_ONE_LINE * float(numpy.ptp(self._solids.mesh.nodes, axis=0).max()):
            self._findings.undecided.append(f"{card.place}: forces act in the middle of the nodes, as in CalculiX; in Abaqus they act in "
                                            f"the reference node ({', '.join(f'{x:g}' for x in self._point(node))})")
        self._add(Coupling(card, card.parameters["ELSET"], point, False, sides, numpy.zeros(0, dtype=numpy.int64)),
                  node, None)

    def _rigid_body(self, card: Card) -> None:
        if not card.get("NSET"):
            self._findings.leave_out(card.place, "*RIGID BODY", "of elements: the body is elastic")
            return
        sets = self._contents.node_sets
        if card.get("NSET") not in sets:
            raise Refused(f"{card.place}: *RIGID BODY: there is no set \"{card.get('NSET')}\". "
                          f"{names_there(card.get('NSET'), sets)}")
        nodes = self._solids.nodes(numpy.concatenate(sets[card.get("NSET")]))
        parts = self._solids.parts_of(nodes)
        if len(parts) != 1:
            self._findings.leave_out(card.place, "*RIGID BODY", "of nodes of several parts, or of none: it is elastic")
            return
        if not self._turn(nodes):
            self._findings.leave_out(card.place, "*RIGID BODY", "of nodes on one line, which have no rotation about it: they move as "
                                     "they like, and what acts on its reference nodes is left out")
            return
        areas = nodal_areas(self._solids.mesh, outer_faces(self._solids.mesh), 1.0, self._solids.family == "CAX")
        if not areas[nodes].sum() > ON_ONE_LINE * float(numpy.abs(areas).max()):
            self._findings.leave_out(card.place, "*RIGID BODY", "of nodes without a share of the surface, as corners of quadratic "
                                     "faces: they move as they like, and what acts on its reference nodes is left out")
            return
        rotation = self._id(card, "ROTNODE") if "ROTNODE" in card.parameters else None
        if "REFNODE" in card.parameters:
            node = self._id(card, "REFNODE")
            point = self._point(node)
        else:
            node = None
            point = [float(x) for x in self._solids.mesh.nodes[nodes].mean(axis=0)[:self._solids.mesh.dimension]]
        self._add(Coupling(card, card.parameters["NSET"], point, True, None, nodes), node, rotation)

    def _turn(self, nodes: Array) -> bool:
        """Whether nodes can be turned about every axis: in space those on one line cannot."""
        at = self._solids.mesh.nodes[nodes]
        spread = numpy.linalg.svd(at - at.mean(axis=0), compute_uv=False)
        return bool(spread[self._solids.mesh.dimension - 2] > ON_ONE_LINE * max(float(numpy.abs(at).max()), 1e-300))

    def _id(self, card: Card, parameter: str) -> int:
        node = self._contents.single_node(card, parameter)
        if node not in self._contents.node_ids:
            raise Refused(f"{card.place}: *{card.keyword}: there is no node \"{card.get(parameter)}\" for its reference.")
        return node

    def _point(self, node: int) -> list[float]:
        at = int(numpy.flatnonzero(self._contents.node_ids == node)[0])
        return [float(x) for x in self._contents.coordinates[at][:self._solids.mesh.dimension]]

    def _add(self, coupling: Coupling, node: "int | None", rotation: "int | None") -> None:
        if node is not None and self._is_of_another_solid(coupling, node):
            self._findings.leave_out(coupling.card.place, f"*{_WRITTEN[coupling.card.keyword]}", f"its reference node {node} is one of a solid, "
                                     "which its face or nodes do not follow: they are free")
            return
        if node is not None and node in self.at_node:
            self._unite(self.at_node[node][0], coupling, node)
            return
        self.all.append(coupling)
        if node is not None:
            self.at_node[node] = coupling, 0
        if rotation is not None:
            self.at_node[rotation] = coupling, 3

    def _unite(self, one: Coupling, other: Coupling, node: int) -> None:
        """Faces that are rigid and follow one node are one.

        Raises:
            Refused: something else follows the same node.
        """
        if not (one.is_rigid and other.is_rigid and one.has_faces() and other.has_faces()):
            raise Refused(f"{other.card.place}: node {node} is the reference of {one.card.place} already, and not both are rigid faces; "
                          "give each a node of its own.")
        one.take(other)
        self._findings.undecided.append(f"{other.card.place}: with {one.card.place} it is one rigid face, as in Abaqus; in CalculiX both "
                                        f"turn by themselves about node {node}")

    def _is_of_another_solid(self, coupling: Coupling, node: int) -> bool:
        """Whether a reference node belongs to a solid, but not to what follows it."""
        at = self._solids.nodes(numpy.array([node]))
        own = coupling.nodes if coupling.sides is None else self._solids.nodes_of_sides(coupling.sides)
        return bool(len(at)) and not numpy.isin(at, own).any()

    def write(self, scene: SceneList, histories: Histories) -> set[str]:
        """Adds a boundary for each; the names of the parts that they touch."""
        touched: set[str] = set()
        for coupling in self.all:
            if not (coupling.is_rigid or coupling.held or coupling.forces or coupling.springs):
                self._findings.leave_out(coupling.card.place, "*COUPLING, *DISTRIBUTING", "nothing acts on its node")
                continue
            touched |= self._write(coupling, scene, histories)
        return touched

    def _write(self, coupling: Coupling, scene: SceneList, histories: Histories) -> set[str]:
        mesh = self._solids.mesh
        sets = {**mesh.side_sets, **mesh.node_sets}
        taken = {*scene.child("Boundaries").names(), *scene.child("Interfaces").names()}
        name = unused_name(clean_name(f"{coupling.name}_point".lower()), {*taken, *sets})
        boundary = scene.child("Boundaries").child(name)
        if coupling.sides is not None:
            mesh.side_sets[name] = coupling.sides
            boundary.set("Side Set", name)
            blocks = mesh.block_of(coupling.sides[:, 0])
            names = list(mesh.parts())
            parts = {names[mesh.part_of_block()[block]] for block in blocks}
        else:
            mesh.node_sets[name] = numpy.unique(coupling.nodes)
            parts = self._solids.parts_of(coupling.nodes)
            boundary.set("Node Set", name).set("Part", next(iter(parts)))
        law = boundary.child("Law").set("Type", "Remote Displacement")
        law.set("Kind", "Rigid" if coupling.is_rigid else "Distributing").set("Point", coupling.point)
        in_space = set(range(6)) if mesh.dimension == 3 else {0, 1, 5}
        for component, points in {**coupling.held, **coupling.forces}.items():
            if component not in in_space and peak(points) != 0.0:
                self._findings.leave_out(coupling.card.place, f"*{coupling.card.keyword}, component {component + 1}",
                                         f"{peak(points):g}, which leaves the plane")
        held = {component: points for component, points in sorted(coupling.held.items()) if component in in_space}
        for component in sorted(held.keys() & coupling.forces.keys()):
            self._findings.leave_out(coupling.card.place, f"*{coupling.card.keyword}, {_FORCES[component].lower()}",
                                     f"{peak(coupling.forces[component]):g}, on a node that is held along it: {INTO_REACTION}")
        for component, points in held.items():
            if component > 2 and abs(peak(points)) > LARGE_ROTATION:
                self._findings.leave_out(coupling.card.place, f"*{coupling.card.keyword}, rotation", f"{peak(points):g} is not small: all "
                                         "is linear in geometry, and displacements are this times the arm")
            histories.set(law, _HELD[component], points)
        springs = {component: stiffness for component, stiffness in sorted(coupling.springs.items())
                   if component in in_space and component not in held and stiffness > 0.0}
        for component, points in sorted(coupling.forces.items()):
            if component in in_space and component not in held and peak(points) != 0.0:
                if component in springs:
                    # K (F / K - u) is the force F and that of the spring.
                    histories.set(law, _HELD[component], points, 1.0 / springs[component])
                else:
                    histories.set(law, _FORCES[component], points)
        for component, stiffness in springs.items():
            law.set(f"{_HELD[component]} Stiffness", stiffness)
        for component in held:
            axis = [float(component % 3 == each) for each in range(mesh.dimension)]
            response = scene.child("Responses").child(
                ended_name(f"reaction_{name}", f"_{_HELD[component].replace(' ', '_').lower()}"))
            if component < 3:
                response.set("Type", "Interface Force").set("Interface", name).set("Direction", axis)
            else:
                response.set("Type", "Interface Moment").set("Interface", name).set("Centre", coupling.point)
                if mesh.dimension == 3:
                    response.set("Axis", axis)
        self._findings.found.append(f"{coupling.card.place}: {'rigid' if coupling.is_rigid else 'distributing'} coupling: "
                                    f"boundary {name}")
        return parts
