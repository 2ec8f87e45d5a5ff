"""A bolted lap joint of tetrahedra as a deck of CalculiX: two plates, one bolt tightened by force, then pulled.

Units mm, N, MPa; x is the load direction, z the bolt's axis. The lower plate (z from -4 to 0) is held at x = -30, the upper
one (z from 0 to 4) is pulled at x = 30; they overlap by 20 mm. The bolt is one body of shank, head and nut; its shank does
not touch the plates' holes. Meshed by Gmsh, nodes of faces in contact lie on each other; that of the bolt has a plane of
faces at z = 0, where the deck has its pretension section.
"""
import gmsh
import numpy as np

HALF_WIDTH, THICKNESS, SHANK, HOLE, HEAD, HEAD_HEIGHT = 10.0, 4.0, 3.0, 3.5, 6.0, 3.0
FRICTION, YOUNG, POISSON = 0.2, 210000.0, 0.3
TENSION, TRACTION = 4000.0, 3.0  # of the bolt [N]; on the pulled face [MPa], 60 % of sliding
PARTS = ("lower", "upper", "bolt")
# Corners of the faces S1 to S4 of a tetrahedron.
FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))
# Nodes of Gmsh's tetrahedra in CalculiX's order.
ORDERS = {1: [0, 1, 2, 3], 2: [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]}


class LapJoint:
    """Mesh of the joint: `nodes` by number, `elements` of each part (numbers from 0, CalculiX's order of nodes)."""

    def __init__(self, size, order):
        gmsh.initialize()
        try:
            gmsh.option.setNumber("General.Verbosity", 1)
            volumes = self.draw()
            gmsh.option.setNumber("Mesh.MeshSizeMax", size)
            gmsh.option.setNumber("Mesh.MeshSizeMin", size)
            gmsh.option.setNumber("Mesh.ElementOrder", order)
            gmsh.option.setNumber("Mesh.HighOrderOptimize", 2)  # or elements at the shank are folded where they are large
            gmsh.option.setNumber("Mesh.RandomSeed", 1)
            gmsh.model.mesh.generate(3)
            tags, places, _ = gmsh.model.mesh.getNodes()
            place = dict(zip(tags.astype(int), places.reshape(-1, 3)))
            nodes, self.elements = [], {}
            for part in PARTS:  # each with nodes of its own
                own, cells = {}, []
                for volume in volumes[part]:
                    _, _, connectivity = gmsh.model.mesh.getElements(3, volume)
                    cells.append(connectivity[0].astype(int).reshape(-1, len(ORDERS[order]))[:, ORDERS[order]])
                cells = np.concatenate(cells)
                for tag in np.unique(cells):
                    own[tag] = len(nodes)
                    nodes.append(place[tag])
                self.elements[part] = np.vectorize(own.get)(cells)
            self.nodes = np.array(nodes)
            self.order = order
        finally:
            gmsh.finalize()

    @staticmethod
    def draw():
        """Volumes of every part, with common faces."""
        shapes = gmsh.model.occ

        def plate(begin, bottom):
            whole = shapes.addBox(begin, -HALF_WIDTH, bottom, 40, 2 * HALF_WIDTH, THICKNESS)
            hole = shapes.addCylinder(0, 0, bottom, 0, 0, THICKNESS, HOLE)
            return shapes.cut([(3, whole)], [(3, hole)])[0][0]

        def half(direction):
            shank = shapes.addCylinder(0, 0, 0, 0, 0, direction * (THICKNESS + HEAD_HEIGHT), SHANK)
            head = shapes.addCylinder(0, 0, direction * THICKNESS, 0, 0, direction * HEAD_HEIGHT, HEAD)
            return shapes.fuse([(3, shank)], [(3, head)])[0][0]

        bodies = [plate(-30, -THICKNESS), plate(-10, 0), half(1), half(-1)]
        _, made = shapes.fragment(bodies[:1], bodies[1:])
        shapes.synchronize()
        found = [[tag for dimension, tag in one if dimension == 3] for one in made]
        return dict(zip(PARTS, (found[0], found[1], found[2] + found[3])))

    def first(self, part):
        """Number of the first element of a part, from 0."""
        return sum(len(self.elements[one]) for one in PARTS[:PARTS.index(part)])

    def faces(self, part, chosen):
        """(element, face) of a part, from 0, whose corners all satisfy `chosen`, inner faces included."""
        result = []
        for face, corners in enumerate(FACES):
            x = self.nodes[self.elements[part][:, corners]]
            result += [(self.first(part) + int(e), face) for e in np.flatnonzero(chosen(x).all(axis=1))]
        return sorted(result)

    def plane(self, part, axis, at):
        """Faces of a part in a plane."""
        return self.faces(part, lambda x: np.abs(x[..., axis] - at) < 1e-6)

    def section(self):
        """Faces of the bolt at z = 0 of the elements above."""
        middle = {self.first("bolt") + e for e, nodes in enumerate(self.elements["bolt"])
                  if self.nodes[nodes[:4], 2].mean() > 0}
        return [one for one in self.plane("bolt", 2, 0.0) if one[0] in middle]

    def contacts(self):
        """Pairs of surfaces: names and faces."""
        def under_head(x):
            return np.hypot(x[..., 0], x[..., 1]) < HEAD + 1e-6

        for name, plate, at in (("nut", "lower", -THICKNESS), ("head", "upper", THICKNESS)):
            on_plate = self.faces(plate, lambda x, at=at: (np.abs(x[..., 2] - at) < 1e-6) & under_head(x))
            on_bolt = self.faces("bolt", lambda x, at=at: (np.abs(x[..., 2] - at) < 1e-6)
                                 & (np.hypot(x[..., 0], x[..., 1]) > HOLE - 1e-6))
            yield (f"{name}_bolt", on_bolt), (f"{name}_plate", on_plate)
        yield tuple((f"{part}_middle", self.faces(part, lambda x: (np.abs(x[..., 2]) < 1e-6) & (
            np.abs(x[..., 0]) < 10 + 1e-6))) for part in ("lower", "upper"))

    def write(self, path, penalty, stick, increments):
        """The deck. penalty, stick: of contact [stress/length]; increments: of the pull."""
        with open(path, "w", encoding="utf-8") as file:
            file.write("*NODE, NSET=ALL\n")
            for number, x in enumerate(self.nodes, 1):
                file.write("%d, %.12g, %.12g, %.12g\n" % (number, *x))
            reference = len(self.nodes) + 1
            file.write(f"*NODE, NSET=TENSION\n{reference}, 0, 0, 0\n")
            number = 0
            for part in PARTS:
                file.write(f"*ELEMENT, TYPE=C3D{4 if self.order == 1 else 10}, ELSET={part}\n")
                for nodes in self.elements[part]:
                    number += 1
                    file.write(", ".join(map(str, [number, *(nodes + 1)])) + "\n")
            file.write(f"*MATERIAL, NAME=steel\n*ELASTIC\n{YOUNG}, {POISSON}\n")
            for part in PARTS:
                file.write(f"*SOLID SECTION, ELSET={part}, MATERIAL=steel\n")

            def surface(name, faces):
                file.write(f"*SURFACE, NAME={name}\n")
                for element, face in faces:
                    file.write(f"{element + 1}, S{face + 1}\n")

            file.write(f"*SURFACE INTERACTION, NAME=dry\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{penalty}\n"
                       f"*FRICTION\n{FRICTION}, {stick}\n")
            for slave, master in self.contacts():
                surface(*slave)
                surface(*master)
                file.write(f"*CONTACT PAIR, INTERACTION=dry, TYPE=SURFACE TO SURFACE\n{slave[0]}, {master[0]}\n")
            surface("section", self.section())
            surface("pulled", self.plane("upper", 0, 30.0))
            file.write(f"*PRE-TENSION SECTION, SURFACE=section, NODE={reference}\n0, 0, -1\n*NSET, NSET=held\n")
            for node in np.flatnonzero(np.abs(self.nodes[:, 0] + 30) < 1e-6):
                file.write(f"{node + 1}\n")
            file.write(f"*BOUNDARY\nheld, 1, 3\n*STEP, INC=1000\n*STATIC\n1, 1\n*CLOAD\n{reference}, 1, {TENSION}\n"
                       f"*END STEP\n*STEP, INC=1000\n*STATIC\n{1 / increments}, 1, 1e-5, {1 / increments}\n"
                       f"*BOUNDARY, FIXED\n{reference}, 1, 1\n*DSLOAD\npulled, P, {-TRACTION}\n*END STEP\n")
