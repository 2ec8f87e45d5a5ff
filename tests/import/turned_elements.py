#!/usr/bin/python3
"""Elements that a file numbers in the other sense are turned, and every set keeps its faces: of all types, from decks, .msh and
Exodus files, and in what acts on them. turned_elements.py HARMOS WORK_DIR"""
import sys
import unittest

import numpy

from deck_case import CUBE, HELD, STEEL, STEP, DeckCase, work
from gmsh_writer import write_gmsh
from harmos.exchange.deck.imported import import_deck
from harmos.exchange.deck.solids import FACES
from harmos.exchange.elements import GMSH, MESHIO, TYPES, ElementType, permutation
from harmos.exchange.exodus import read_exodus, write_exodus
from harmos.exchange.findings import Findings
from harmos.exchange.gmsh_mesh import read_gmsh
from harmos.exchange.mesh import Block, Mesh

CORNERS = {"TRI": ["000", "100", "010"], "QUAD": ["000", "100", "110", "010"], "TET": ["000", "100", "010", "001"],
           "PYRAMID": ["000", "100", "110", "010", "001"], "WEDGE": ["000", "100", "010", "001", "101", "011"],
           "HEX": ["000", "100", "110", "010", "001", "101", "111", "011"]}

DECK_TYPES = {"C3D4": "tetra", "C3D5": "pyramid", "C3D6": "wedge", "C3D8": "hexahedron", "C3D10": "tetra10", "C3D15": "wedge15",
              "C3D20": "hexahedron20", "CPS3": "triangle", "CPE4": "quad", "CAX6": "triangle6", "CPS8": "quad8"}

Place = tuple[float, ...]


def family(kind: ElementType) -> str:
    return kind.name.rstrip("0123456789")


def pair_of(kind: ElementType) -> Mesh:
    """Two elements that share no nodes, the second one numbered in the other sense; a side set of both for each side."""
    corners = numpy.array([[float(digit) for digit in corner] for corner in CORNERS[family(kind)]])
    right = numpy.array([corners[sorted(spot)].mean(axis=0) for spot in kind.order])
    turned = right * [-1.0, 1.0, 1.0] + [9.0, 0.0, 0.0]
    count = kind.nodes
    mesh = Mesh(kind.dimension, numpy.concatenate([right, turned]), [Block("pair", kind, numpy.arange(2 * count).reshape(2, count))])
    mesh.side_sets = {f"side_{side}": numpy.array([[0, side], [1, side]]) for side in range(len(kind.sides))}
    return mesh


def places(mesh: Mesh, name: str) -> list[list[Place]]:
    """Where the corners of the faces of a side set are."""
    faces, rows = [], mesh.side_sets[name]
    for (element, side), number in zip(rows, mesh.block_of(rows[:, 0])):
        block, row = mesh.blocks[number], element - mesh.first_elements()[number]
        faces.append(sorted(map(tuple, mesh.nodes[block.connectivity[row, list(block.type.sides[side])]].tolist())))
    return sorted(faces)


class TurnedElements(DeckCase):
    def demand_same_faces(self, given: Mesh, back: Mesh) -> None:
        self.assertEqual(set(given.side_sets), set(back.side_sets))
        for name in given.side_sets:
            self.assertEqual(places(given, name), places(back, name), name)
        rows = numpy.concatenate([block.connectivity for block in back.blocks])
        for node, spot in enumerate(back.blocks[0].type.order):
            self.assertLess(numpy.abs(back.nodes[rows[:, node]] - back.nodes[rows[:, sorted(spot)]].mean(axis=1)).max(), 1e-12)
        self.assertFalse((rows == given.blocks[0].connectivity).all(), "nothing was turned")

    def test_exodus(self) -> None:
        for kind in TYPES.values():
            with self.subTest(kind.name):
                mesh, findings = pair_of(kind), Findings()
                write_exodus(str(work / "pair.e"), mesh)
                self.demand_same_faces(mesh, read_exodus(str(work / "pair.e"), findings))
                self.assertEqual(findings.found, ["1 elements were numbered in the other sense and have been turned"])

    def test_a_side_that_an_element_has_not(self) -> None:
        mesh = pair_of(TYPES["TET4"])
        mesh.side_sets["side_0"][1, 1] = 5
        write_exodus(str(work / "pair.e"), mesh)
        with self.assertRaisesRegex(ValueError, "\"side_0\" refers to a side that is not there"):
            read_exodus(str(work / "pair.e"), Findings())

    def test_gmsh(self) -> None:
        for name, _ in GMSH.values():
            with self.subTest(name):
                mesh = pair_of(TYPES[name])
                write_gmsh(work / "pair.msh", mesh)
                self.demand_same_faces(mesh, read_gmsh(str(work / "pair.msh"), Findings()))

    def test_faces_of_decks(self) -> None:
        for own, of_meshio in DECK_TYPES.items():
            name, order = MESHIO[of_meshio]
            mesh = pair_of(TYPES[name])
            mesh.side_sets.clear()
            nodes = "".join(f"{number}, {', '.join(map(repr, map(float, at)))}\n" for number, at in enumerate(mesh.nodes, 1))
            rows = mesh.blocks[0].connectivity[:, numpy.argsort(permutation(name, order))] + 1
            elements = "".join(", ".join(map(str, [number, *row])) + "\n" for number, row in enumerate(rows, 1))
            text = f"*NODE\n{nodes}*ELEMENT,TYPE={own},ELSET=PAIR\n{elements}"
            for number, corners in enumerate(FACES[family(mesh.blocks[0].type)], 1):
                text += f"*SURFACE,NAME=F{number}\nPAIR,S{number}\n"
                wanted = {int(corner) for corner in corners}
                side = [set(side) for side in mesh.blocks[0].type.sides].index(wanted)
                mesh.side_sets[f"F{number}"] = numpy.array([[0, side], [1, side]])
            (work / "pair.inp").write_text(text)
            with self.subTest(own):
                self.demand_same_faces(mesh, import_deck(str(work / "pair.inp"), "", "", Findings()).mesh)

    def test_what_acts_on_turned_elements(self) -> None:
        turned = CUBE.replace("1, 1,2,3,4,5,6,7,8", "1, 5,6,7,8,1,2,3,4")
        self.assertNotEqual(turned, CUBE)
        up = "5,3,0.25\n6,3,0.25\n7,3,0.25\n8,3,0.25\n"
        for loads in ("*DLOAD\nCUBE,P{},-1.\n", "*DSLOAD\nUP,P,-1.\n", "*CLOAD\n" + up):
            for cube, face in ((CUBE, 2), (turned, 1)):
                text = cube + STEEL + f"*SURFACE,NAME=UP\nCUBE,S{face}\n" + HELD + STEP.format(loads.format(face))
                with self.subTest(loads, face=face):
                    self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -1.0, 6)

    def test_pretension_across_turned_elements(self) -> None:
        second = ("*NODE\n9, 0, 0, 2\n10, 1, 0, 2\n11, 1, 1, 2\n12, 0, 1, 2\n*ELEMENT,TYPE=C3D8,ELSET=CUBE\n2, {}\n*NODE\n99, 0, 0, 0\n")
        section = "*SURFACE,NAME=CUT\n2,S{}\n*PRE-TENSION SECTION,SURFACE=CUT,NODE=99\n0., 0., -1.\n"
        held = HELD + "9,1,3\n10,1,3\n11,1,3\n12,1,3\n"
        forces = []
        for nodes, face in (("5,6,7,8,9,10,11,12", 1), ("9,10,11,12,5,6,7,8", 2)):
            text = CUBE + second.format(nodes) + STEEL + section.format(face) + held + STEP.format("*BOUNDARY\n99,1,1,0.01\n")
            forces.append(self.solved(text)[-1]["bolt_force_preload_cut"])
        self.assertGreater(forces[0], 1.0)
        self.assertAlmostEqual(forces[1], forces[0], 6)


unittest.main(argv=[sys.argv[0]])
