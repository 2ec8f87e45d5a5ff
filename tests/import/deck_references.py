#!/usr/bin/python3
"""What follows reference nodes of a deck, and what these nodes follow.

deck_references.py HARMOS WORK_DIR
"""
import sys
import unittest

from deck_case import CUBE, HELD, STEEL, STEP, DeckCase, work

FACE = "*NODE\n100, 0.5, 0.5, 2.\n*SURFACE,NAME=FACE\nCUBE,S2\n*COUPLING,REF NODE=100,SURFACE=FACE,CONSTRAINT NAME=C\n*KINEMATIC\n1,3\n"
SECOND = ("*NODE\n11, 0, 0, 3\n12, 1, 0, 3\n13, 1, 1, 3\n14, 0, 1, 3\n15, 0, 0, 4\n16, 1, 0, 4\n17, 1, 1, 4\n18, 0, 1, 4\n"
          "*ELEMENT,TYPE=C3D8,ELSET=CUBE\n2, 11,12,13,14,15,16,17,18\n")


class References(DeckCase):
    def test_springs_whose_elements_are_named_by_a_set(self) -> None:
        # A cube of stiffness 1000 on a spring of 500: it takes two thirds of a force.
        spring = "*ELEMENT,TYPE=SPRING1\n90, 100\n91, 100\n*ELSET,ELSET=S1\n90\n*SPRING,ELSET=S1\n3\n500.\n"
        rest = "*ELSET,ELSET=S2\n91\n*SPRING,ELSET=S2\n3\n1e-9\n"
        text = CUBE + STEEL + FACE + spring + rest + HELD + STEP.format("*CLOAD\n100,3,6.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -4.0, 4)
        self.assertNotIn("left out:", self.told(text))
        self.assertIn("TYPE=SPRING1: 1 springs are left out: no *SPRING names a set that they are in", self.told(text.replace(rest, "")))

    def test_distributing_elements_that_are_named_by_a_set(self) -> None:
        joint = ("*NODE\n100, 0.5, 0.5, 1.\n*NSET,NSET=TOP\n5,6,7,8\n*ELEMENT,TYPE=DCOUP3D\n90, 100\n*ELSET,ELSET=D\n90\n"
                 "*DISTRIBUTING COUPLING,ELSET=D\nTOP,1.\n")
        text = CUBE + STEEL + joint + HELD + STEP.format("*CLOAD\n100,3,6.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -6.0, 4)
        self.assertNotIn("left out:", self.told(text))

    def test_rigid_bodies_without_a_reference(self) -> None:
        rigid = "*NSET,NSET=TOP\n5,6,7,8\n*RIGID BODY,NSET=TOP\n"
        text = CUBE + STEEL + rigid + HELD + STEP.format("*CLOAD\n5,3,3.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -3.0, 4)
        self.assertNotIn("left out:", self.told(text))

    def test_two_rigid_faces_of_one_node(self) -> None:
        # Two cubes of stiffness 1000 side by side.
        both = FACE.replace("CUBE,S2", "1,S2") + FACE.replace("*NODE\n100, 0.5, 0.5, 2.\n", "").replace("=FACE", "=FOOT").replace("CUBE,S2", "2,S1")
        text = CUBE + SECOND + STEEL + both + HELD + "15,1,3\n16,1,3\n17,1,3\n18,1,3\n" + STEP.format("*BOUNDARY\n100,3,3,0.01\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_face_point_z"], 20.0, 4)
        self.assertIn("it is one rigid face, as in Abaqus; in CalculiX both turn by themselves about node 100", self.told(text))
        self.imported(text)
        (work / "out" / "deck.xml").unlink()
        code, said = self.imported(text.replace("*KINEMATIC", "*DISTRIBUTING", 1))
        self.assertEqual(code, 2, said)
        self.assertIn("and not both are rigid faces; give each a node of its own", said)

    def test_references_that_are_nodes_of_solids(self) -> None:
        joint = FACE.replace("*NODE\n100, 0.5, 0.5, 2.\n", "").replace("CUBE,S2", "1,S2").replace("=100", "={}")
        text = CUBE + SECOND + STEEL + joint + HELD + "15,1,3\n16,1,3\n17,1,3\n18,1,3\n" + STEP.format("*DLOAD\n1,P3,1.\n")
        self.assertIn("*COUPLING: its reference node 11 is one of a solid, which its face or nodes do not follow", self.told(text.format(11)))
        self.assertNotIn("left out:", self.told(text.format(5)))

    def test_equations_between_references_and_others(self) -> None:
        joint = "*NODE\n101, 0, 0, 5\n*EQUATION\n2\n100,3,1.,101,3,-1.\n"
        text = CUBE + STEEL + FACE + joint + HELD + STEP.format("*BOUNDARY\n101,3,3,0.02\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_face_point_z"], 20.0, 4)
        self.assertNotIn("left out:", self.told(text))
        # The other way round, a node of a solid that follows.
        text = CUBE + STEEL + FACE.replace("CUBE,S2", "CUBE,S4") + joint.replace("101,3,-1.", "5,3,-1.") + HELD + STEP.format(
            "*BOUNDARY\n100,3,3,0.02\n")
        self.assertNotIn("left out:", self.told(text))
        self.assertGreater(self.solved(text)[-1]["reaction_moved_z_z"] ** 2, 1e-6)
        self.assertIn("1 of 1 equations", self.told(text.replace("100,3,3,0.02", "100,1,1,0.02")))

    def test_references_and_equations_of_parts(self) -> None:
        # Two instances of a part, each with a joint of its own.
        deck = ("*PART,NAME=P\n" + CUBE + "*NODE,NSET=RP\n100, 0.5, 0.5, 2.\n101, 0, 0, 5\n*NSET,NSET=FOOT\n1,2,3,4\n*SURFACE,NAME=FACE\nCUBE,S2\n"
                "*SOLID SECTION,ELSET=CUBE,MATERIAL=STEEL\n*COUPLING,REF NODE={},SURFACE=FACE,CONSTRAINT NAME=C\n*KINEMATIC\n1,3\n"
                "*EQUATION\n2\n100,3,1.,101,3,-1.\n*END PART\n*ASSEMBLY,NAME=A\n*INSTANCE,NAME=I,PART=P\n*END INSTANCE\n"
                "*INSTANCE,NAME=J,PART=P\n5.,0.,0.\n*END INSTANCE\n*END ASSEMBLY\n" + STEEL.split("*SOLID")[0]
                + "*BOUNDARY\nI.FOOT,1,3\nJ.FOOT,1,3\n" + STEP.format("*BOUNDARY\nI.101,3,3,0.01\nJ.101,3,3,-0.02\n"))
        for reference, text in (("100", deck), ("ONE", deck.replace("*NSET,NSET=FOOT", "*NSET,NSET=ONE\n100\n*NSET,NSET=FOOT"))):
            with self.subTest(reference):
                row = self.solved(text.format(reference))[-1]
                forces = sorted(value for name, value in row.items() if "point" in name and name.endswith("_z"))
                self.assertEqual(len(forces), 2, row)
                for found, expected in zip(forces, (-20.0, 10.0)):
                    self.assertAlmostEqual(found, expected, 4)

    def test_fixed_references_stay(self) -> None:
        keep = STEP.format("*BOUNDARY\n100,3,3,0.02\n") + STEP.format("*BOUNDARY,FIXED\n100,3\n")
        text = CUBE + STEEL + FACE + HELD + keep
        history = self.solved(text)
        for row in history[1:]:
            self.assertAlmostEqual(row["reaction_face_point_z"], 20.0, 4)
        self.assertNotIn("left out:", self.told(text))
        self.assertIn("*BOUNDARY, FIXED: 1 of its nodes were free before", self.told(text.replace("FIXED\n100,3", "FIXED\n100,1,3")))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
