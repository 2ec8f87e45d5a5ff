#!/usr/bin/python3
"""What joins the parts of a deck: nodes that they share, equations, ties and contact beside each other; and loads that add up.

deck_joints.py HARMOS WORK_DIR
"""
import shutil
import sys
import unittest

from deck_case import CUBE, HELD, STEEL, STEP, DeckCase, work

WIDE = """*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 2, 0, 0
4, 0, 1, 0
5, 1, 1, 0
6, 2, 1, 0
11, 0, 0, 1
12, 1, 0, 1
13, 2, 0, 1
14, 0, 1, 1
15, 1, 1, 1
16, 2, 1, 1
21, 0, 0, 2
22, 1, 0, 2
23, 2, 0, 2
24, 0, 1, 2
25, 1, 1, 2
26, 2, 1, 2
33, 2, 0, 1
36, 2, 1, 1
*ELEMENT,TYPE=C3D8,ELSET=LOWER
1, 1,2,5,4,11,12,15,14
2, 2,3,6,5,12,13,16,15
*ELEMENT,TYPE=C3D8,ELSET=UPPER
3, 11,12,15,14,21,22,25,24
4, 12,33,36,15,22,23,26,25
*NSET,NSET=FOOT
1,2,3,4,5,6
*NSET,NSET=TOP
21,22,23,24,25,26
*SURFACE,NAME=UP
2,S2
*SURFACE,NAME=DOWN
4,S1
"""
"""A block of 2 x 1 on another one; beside the middle they have nodes of their own."""
APART = WIDE.replace("3, 11,12,15,14", "3, 31,32,35,34").replace("4, 12,33,36,15", "4, 32,33,36,35").replace(
    "33, 2, 0, 1\n", "31, 0, 0, 1\n32, 1, 0, 1\n33, 2, 0, 1\n34, 0, 1, 1\n35, 1, 1, 1\n")
"""The same with nodes of their own everywhere."""
MATERIAL = STEEL.replace("ELSET=CUBE", "ELSET=LOWER") + "*SOLID SECTION,ELSET=UPPER,MATERIAL=STEEL\n"
FIXED = "*BOUNDARY\nFOOT,1,3\nTOP,1,2\n"
CONTACT = ("*SURFACE INTERACTION,NAME=I\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=HARD\n"
           "*CONTACT PAIR,INTERACTION=I,TYPE=SURFACE TO SURFACE\nDOWN,UP\n")
PULL = "*BOUNDARY\nTOP,3,3,0.01\n"


def equal_motions(*nodes: int) -> str:
    """Equations that tie upper nodes to these lower ones of APART."""
    return "".join(f"*EQUATION\n2\n{20 + node},{component},1.,{node},{component},-1.\n" for node in nodes for component in (1, 2, 3))


class Joints(DeckCase):
    def test_a_slit_between_parts_that_share_nodes(self) -> None:
        # Of two columns of stiffness 500 only one is pulled: what the other one carries comes through their sides.
        slit = WIDE + MATERIAL + FIXED + STEP.format(PULL)
        whole = slit.replace("4, 12,33,36,15", "4, 12,13,16,15")
        force = {}
        for name, text in (("slit", slit), ("whole", whole)):
            force[name] = self.solved(text)[-1]["reaction_moved_xyz_z"]
            self.assertIn("LOWER and UPPER share nodes: interface LOWER_UPPER", self.told(text))
            self.assertNotIn("left out:", self.told(text))
        self.assertAlmostEqual(force["whole"], 10.0, 4)
        self.assertLess(force["slit"], 9.0)
        self.assertGreater(force["slit"], 5.0)

    def test_contact_and_ties_beside_shared_nodes(self) -> None:
        for joint, pressed, pulled in ((CONTACT, -10.0, None), ("*TIE,NAME=T\nDOWN,UP\n", -10.0, 10.0)):
            with self.subTest(joint):
                text = WIDE + MATERIAL + joint + FIXED + STEP.format(PULL)
                self.assertAlmostEqual(self.solved(text.replace("0.01", "-0.01"))[-1]["reaction_moved_xyz_z"], pressed, 3)
                force = self.solved(text)[-1]["reaction_moved_xyz_z"]
                if pulled is None:
                    self.assertLess(force, 9.0)
                    self.assertGreater(force, 5.0)
                else:
                    self.assertAlmostEqual(force, pulled, 3)

    def test_equations_beside_a_contact(self) -> None:
        # Equations tie the left half, contact is on the right one.
        equations = equal_motions(11, 12, 14, 15)
        text = APART + MATERIAL + CONTACT + equations + FIXED + STEP.format(PULL)
        self.assertNotIn("left out:", self.told(text))
        force = self.solved(text)[-1]["reaction_moved_xyz_z"]
        self.assertLess(force, 9.0)
        self.assertGreater(force, 5.0)
        on_contact = equal_motions(12, 13, 15, 16)
        self.assertIn("*EQUATION: equations that tie UPPER to LOWER on faces that an interface has already",
                      self.told(text.replace(equations, on_contact)))

    def test_nodes_of_a_surface_on_no_face_are_listed(self) -> None:
        text = WIDE.replace("*SURFACE,NAME=UP", "*NSET,NSET=N\n12,15,33,36,22\n*SURFACE,NAME=UP") + MATERIAL
        text += "*SURFACE,NAME=NODES,TYPE=NODE\nN\n*TIE,NAME=T\nNODES,UP\n" + FIXED + STEP.format(PULL)
        self.assertIn("*SURFACE, TYPE=NODE: 1 of its nodes are on no face whose corners are all in it", self.told(text))
        self.assertNotIn("left out:", self.told(text.replace("36,22", "36")))

    def test_what_no_face_or_interface_takes_is_told(self) -> None:
        equations = equal_motions(11, 12, 14, 15, 13)
        said = self.told(APART + MATERIAL + equations + FIXED + STEP.format(PULL))
        self.assertIn("*EQUATION: 1 nodes of UPPER that equations tie to LOWER are on no face whose corners they all tie", said)
        third = "*NODE\n" + "".join(f"{50 + n}, {x}, {y}, {z}\n" for n, (x, y, z) in enumerate(
            ((0, 0, 5), (1, 0, 5), (1, 1, 5), (0, 1, 5), (0, 0, 6), (1, 0, 6), (1, 1, 6), (0, 1, 6)))) + (
                "*ELEMENT,TYPE=C3D8,ELSET=FAR\n9, 50,51,52,53,54,55,56,57\n*SOLID SECTION,ELSET=FAR,MATERIAL=STEEL\n")
        said = self.told(APART.replace("4,S1", "4,S1\n9,S1") + third + MATERIAL + CONTACT + FIXED + "50,1,3\n51,1,3\n52,1,3\n"
                         + STEP.format(PULL))
        self.assertIn("1 of 2 pairs of parts on DOWN and UP lie farther apart than 1 of the longest edge: between them there is no contact", said)

    def test_equations_of_bolts_are_listed(self) -> None:
        joint = "*NODE\n98,0,0,9\n99,0,0,9\n*PRE-TENSION SECTION,SURFACE=CUT,NODE=99\n*EQUATION\n2\n99,1,1.,98,1,-1.\n"
        text = WIDE.replace("4, 12,33,36,15", "4, 12,13,16,15") + "*SURFACE,NAME=CUT\n1,S2\n2,S2\n" + MATERIAL + joint + FIXED
        said = self.told(text + STEP.format("*BOUNDARY\n98,1,1,0.01\n"))
        self.assertIn("*EQUATION: 1 of 1 equations: nodes that they tie move as they like", said)

    def test_sets_in_steps(self) -> None:
        text = CUBE + STEEL + HELD + STEP.format("*NSET,NSET=LATE\n5,6,7,8\n*CLOAD\nLATE,3,2.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -8.0, 4)
        shutil.rmtree(work / "out")
        self.demand_refused(text.replace("5,6,7,8\n*CLOAD", "5,six,7,8\n*CLOAD"), "deck.inp:26", "there is no set \"six\"")

    def test_loads_that_are_said_twice_in_a_step_add_up(self) -> None:
        start = CUBE + STEEL + "*AMPLITUDE,NAME=HALF\n0.,0.,1.,0.5\n*NSET,NSET=TOP\n5,6,7,8\n" + HELD
        for once, again, first, both in (("*CLOAD{}\nTOP,3,1.\n", "TOP,3,2.\n", -4.0, -12.0), ("*DLOAD{}\nCUBE,P2,-5.\n", "CUBE,P2,-1.\n", -5.0, -6.0),
                                         ("*DLOAD{}\nCUBE,GRAV,3.,0.,0.,1.\n", "*DLOAD{}\nCUBE,GRAV,4.,0.,0.,1.\n", -6.0, -14.0)):
            for name, factor in (("", 1.0), (",AMPLITUDE=HALF", 0.5)):
                with self.subTest(once + name):
                    text = start + STEP.format((once + again).format(name, name))
                    self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], factor * both, 4)
                    # A later step says them anew.
                    text += STEP.format(once.format(name))
                    self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], factor * first, 4)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
