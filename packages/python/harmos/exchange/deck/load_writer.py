"""Boundaries and loads of a deck as boundaries of a scene."""
import collections

import numpy

from harmos.arrays import Array
from harmos.exchange.deck.areas import nodal_areas
from harmos.exchange.deck.carried import Carried
from harmos.exchange.deck.curves import Histories, Points, peak, shape, summed
from harmos.exchange.deck.loads import Loads
from harmos.exchange.deck.solids import Solids
from harmos.exchange.deck.transforms import Axes
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import ended_name, outer_faces, unused_name
from harmos.exchange.scene import SceneList

SAME = 1e-3
"""Difference of nodal forces from those of a constant traction, over the largest of them, that counts as none."""


class LoadWriter:
    """Writes the boundaries of a scene.

    Attributes:
        touched: names of the parts that have one.
    """

    def __init__(self, solids: Solids, scene: SceneList, histories: Histories, thickness: float,
                 findings: Findings) -> None:
        """Adds to this scene and to the sets of the mesh."""
        self._solids, self._scene, self._histories = solids, scene, histories
        self._thickness, self._findings = thickness, findings
        mesh = solids.mesh
        self._outer = outer_faces(mesh)
        self._part_of_face = numpy.asarray(mesh.part_of_block())[mesh.block_of(self._outer.element)]
        self._part_of_node = numpy.full(len(mesh.nodes), -1)
        for number in range(len(mesh.blocks) - 1, -1, -1):
            self._part_of_node[mesh.blocks[number].connectivity] = mesh.part_of_block()[number]
        self.touched: set[str] = set()

    def write(self, loads: Loads) -> None:
        """All of them."""
        for part in dict.fromkeys(part for part, _ in loads.body_forces):
            force = self._scene.child("Parts").child(part).child("Body Force")
            for component in range(self._solids.mesh.dimension):
                shares = [(points, direction[component]) for (of, direction), points in loads.body_forces.items() if of == part]
                points = summed([share for share in shares if share[1]])
                if peak(points):
                    self._histories.set(force, "XYZ"[component], points)
        self._write_held(loads.held, loads.axes)
        carried = Carried(loads, self._solids.mesh)
        self._write_pressures(loads, carried)
        self._write_forces(loads.global_forces(), carried)
        carried.tell(self._findings)

    def _boundary(self, name: str) -> "tuple[str, SceneList]":
        boundaries = self._scene.child("Boundaries")
        taken = {*boundaries.names(), *self._scene.child("Interfaces").names()}
        free = unused_name(name, taken)
        return free, boundaries.child(free)

    def _set_name(self, wanted: str) -> str:
        mesh = self._solids.mesh
        return unused_name(wanted, {**mesh.side_sets, **mesh.node_sets})

    def _write_held(self, held: dict[tuple[int, int], Points], axes: dict[int, Axes]) -> None:
        by_node: dict[int, dict[int, Points]] = collections.defaultdict(dict)
        for (node, component), points in held.items():
            by_node[node][component] = points
        groups: dict[tuple[int, Axes | None, tuple[tuple[int, Points], ...]], list[int]] = collections.defaultdict(list)
        for node, curves in by_node.items():
            groups[int(self._part_of_node[node]), axes.get(node), tuple(sorted(curves.items()))].append(node)
        names = list(self._solids.mesh.parts())
        for (part, turned, components), nodes in groups.items():
            letters = "".join(("xyz" if turned is None else "rta" if turned.is_cylindrical else "123")[component]
                              for component, _ in components)
            moved = any(peak(points) for _, points in components)
            name = self._set_name(f"{'moved' if moved else 'held'}_{letters}")
            self._solids.mesh.node_sets[name] = numpy.array(sorted(nodes))
            boundary_name, boundary = self._boundary(name)
            boundary.set("Node Set", name).set("Part", names[part])
            self.touched.add(names[part])
            if turned is not None:
                self._hold_about(boundary, boundary_name, turned, dict(components), nodes)
                continue
            law = boundary.child("Law").set("Type", "Prescribed Displacement")
            for component, points in components:
                self._histories.set(law, "XYZ"[component], points)
                axis = [float(component == each) for each in range(self._solids.mesh.dimension)]
                self._add_reaction(boundary_name, "xyz"[component], axis)

    def _hold_about(self, boundary: SceneList, name: str, axes: Axes, components: dict[int, Points], nodes: list[int]) -> None:
        """Holds nodes in axes of their own."""
        mesh = self._solids.mesh
        size = float(numpy.ptp(mesh.nodes, axis=0).max())
        point, direction = axes.cylinder(mesh.nodes[nodes].mean(axis=0), size)
        if not axes.is_cylindrical:
            boundary.comment("Rectangular axes: those of a cylinder so large that they do not turn.")
        law = boundary.child("Law").set("Type", "Cylindrical Displacement").set("Point", point[:mesh.dimension])
        if mesh.dimension == 3:
            law.set("Axis", direction)
        # In the plane scenes turn about the third global axis.
        senses = (1.0, 1.0 if mesh.dimension == 3 else direction[2], 1.0)
        for component, points in components.items():
            self._histories.set(law, ("Radial", "Tangential", "Axial")[component], points, senses[component])
        if axes.is_cylindrical and 2 in components:
            self._add_reaction(name, "axial", direction)
        if not axes.is_cylindrical:
            rows = axes.at(mesh.nodes[nodes[0]], size)
            for component in components:
                self._add_reaction(name, str(component + 1), [float(x) for x in rows[component][:mesh.dimension]])

    def _add_reaction(self, boundary: str, along: str, direction: list[float]) -> None:
        response = self._scene.child("Responses").child(ended_name(f"reaction_{boundary}", f"_{along}"))
        response.set("Type", "Interface Force").set("Interface", boundary).set("Direction", direction)

    def _write_pressures(self, loads: Loads, carried: Carried) -> None:
        groups = collections.defaultdict(list)
        for face, points in loads.pressures.items():
            groups[points].append(face)
        number = {(element, side): row for row, (element, side) in enumerate(self._outer.rows().tolist())}
        for card, acted in loads.pressure_cards:
            inside = sum(face not in number for face in acted)
            if inside:
                self._findings.leave_out(card.place, f"*{card.keyword}, pressure", f"{inside} of its faces lie inside of a part: they "
                                         "bear none")
        for points, faces in groups.items():
            name = self._set_name("pressed")
            outer = sorted(face for face in faces if face in number)
            if not outer:
                continue
            if carried.takes_pressures(self._outer.chosen(numpy.array([number[face] for face in outer]))):
                carried.leave_out_pressures(set(outer))
                continue
            rows = numpy.array(outer)
            self._solids.mesh.side_sets[name] = rows
            _, boundary = self._boundary(name)
            law = boundary.set("Side Set", name).child("Law").set("Type", "Pressure")
            self._histories.set(law, "Pressure", points)
            names = list(self._solids.mesh.parts())
            self.touched |= {names[self._solids.mesh.part_of_block()[block]]
                             for block in self._solids.mesh.block_of(rows[:, 0])}

    def _write_forces(self, forces: dict[tuple[int, int], Points], carried: Carried) -> None:
        groups: dict[tuple[int, int, Points], dict[int, float]] = collections.defaultdict(dict)
        for (node, component), points in forces.items():
            if peak(points) != 0.0:
                groups[int(self._part_of_node[node]), component, shape(points)][node] = peak(points)
        names = list(self._solids.mesh.parts())
        nodal: dict[tuple[int, int], list[tuple[int, float, Points]]] = collections.defaultdict(list)
        for (part, component, form), values in groups.items():
            self.touched.add(names[part])
            free = [node for node in values if not carried.takes_force(node, component)]
            if free and self._as_traction(part, component, form, values):
                continue
            carried.leave_out_forces({(node, component) for node in values.keys() - free})
            for node in free:
                nodal[part, node].append((component, values[node], form))
        alike: dict[tuple[int, tuple[tuple[int, float, Points], ...]], list[int]] = collections.defaultdict(list)
        for (part, node), of_node in nodal.items():
            alike[part, tuple(sorted(of_node))].append(node)
        for (part, entries), nodes in alike.items():
            name = self._set_name("force")
            self._solids.mesh.node_sets[name] = numpy.array(sorted(nodes))
            _, boundary = self._boundary(name)
            law = boundary.set("Node Set", name).set("Part", names[part]).child("Law").set("Type", "Nodal Force")
            for component, value, form in entries:
                self._histories.set(law, "XYZ"[component], form, value)

    def _areas(self, which: Array) -> Array:
        return nodal_areas(self._solids.mesh, self._outer.chosen(which), self._thickness, self._solids.family == "CAX")

    def _as_traction(self, part: int, component: int, form: Points, values: dict[int, float]) -> bool:
        """Whether the forces are those of a constant traction on the faces between the nodes, which is then written."""
        mesh = self._solids.mesh
        nodes = numpy.array(sorted(values))
        inside = (numpy.isin(self._outer.corners, nodes) | (self._outer.corners < 0)).all(axis=1)
        which = inside & (self._part_of_face == part)
        if not which.any():
            return False
        areas = self._areas(which)
        loaded = numpy.flatnonzero(areas)
        given = numpy.zeros(len(mesh.nodes))
        given[nodes] = [values[int(node)] for node in nodes]
        traction = given.sum() / areas.sum()
        if numpy.abs(given - traction * areas).max() > SAME * numpy.abs(given).max() or not len(loaded):
            return False
        rows = self._outer.chosen(which).rows()
        same = [known for known, of in mesh.side_sets.items() if len(of) == len(rows) and numpy.array_equal(of, rows)]
        name = same[0] if same else self._set_name("loaded")
        mesh.side_sets[name] = rows
        _, boundary = self._boundary(name)
        law = boundary.set("Side Set", name).child("Law").set("Type", "Prescribed Traction")
        self._histories.set(law, "XYZ"[component], form, traction)
        response = self._scene.child("Responses").child(ended_name(f"u_{name}", f"_{'xyz'[component]}"))
        response.set("Type", "Mean Displacement").set("Side Set", name).set(
            "Direction", [float(component == each) for each in range(mesh.dimension)])
        return True
