#!/usr/bin/python3
"""Supports of decks that begin late, and loads on what is held: scenes that `check` accepts, and what is told of them.

deck_supports.py HARMOS WORK_DIR
"""
import subprocess
import sys
import unittest

from deck_case import CUBE, HELD, STEEL, STEP, DeckCase, harmos, work

TOP = "*NSET,NSET=TOP\n5,6,7,8\n"
UP = "*SURFACE,NAME=UP\nCUBE,S2\n"
REFERENCE = "*NODE\n100, 0.5, 0.5, 2.\n" + UP + "*COUPLING,REF NODE=100,SURFACE=UP,CONSTRAINT NAME=C\n*KINEMATIC\n"
LATE = "are held from the beginning, though free up to this step"
CARRIED = "it goes into the reaction"


class Supports(DeckCase):
    def told(self, text: str) -> str:
        """What the import of a deck says, of which `check` accepts the scene."""
        said = super().told(text)
        checked = subprocess.run([harmos, "check", str(work / "out" / "deck.xml")], capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        return said

    def test_supports_that_begin_late(self) -> None:
        pull = STEP.format("*CLOAD\n5,3,1.\n")
        late = STEP.format("*BOUNDARY\n6,1,2\n6,3\n7,1\n")
        said = self.told(CUBE + STEEL + HELD + pull + late)
        self.assertIn(f"left out: deck.inp:30: *BOUNDARY: 2 nodes {LATE}", said.replace(str(work) + "/", ""))
        for text in (late, "*BOUNDARY\n6,1,3\n7,1\n" + pull + late, STEP.format("*FREQUENCY\n").replace("*STATIC\n", "") + late):
            self.assertNotIn(LATE, self.told(CUBE + STEEL + HELD + text))

    def test_reference_nodes_and_bolts_that_are_held_late(self) -> None:
        pull = STEP.format("*CLOAD\n100,1,1.\n")
        hold = STEP.format("*BOUNDARY\n100,3,3,0.1\n")
        self.assertIn(f"1 nodes {LATE}", self.told(CUBE + STEEL + REFERENCE + HELD + pull + hold))
        self.assertNotIn(LATE, self.told(CUBE + STEEL + REFERENCE + HELD + hold + hold))
        bolt = ("*NODE\n9, 0, 0, 2\n10, 1, 0, 2\n11, 1, 1, 2\n12, 0, 1, 2\n*ELEMENT,TYPE=C3D8,ELSET=CUBE\n2, 5,6,7,8,9,10,11,12\n"
                "*NODE\n99, 0, 0, 0\n" + STEEL + "*SURFACE,NAME=CUT\n2,S1\n*PRE-TENSION SECTION,SURFACE=CUT,NODE=99\n0., 0., -1.\n" + HELD)
        draw = STEP.format("*BOUNDARY\n99,1,1,0.01\n")
        self.assertIn(f"1 nodes {LATE}", self.told(CUBE + bolt + STEP.format("*CLOAD\n9,1,1.\n") + draw))
        self.assertNotIn(LATE, self.told(CUBE + bolt + STEP.format("*CLOAD\n99,1,1.\n") + draw.replace("0.01", "0.")))

    def test_supports_of_steps_that_are_left_out(self) -> None:
        modes = STEP.format("*FREQUENCY\n10\n" + HELD).replace("*STATIC\n", "")
        text = CUBE + STEEL + TOP + modes + STEP.format("*CLOAD\nTOP,3,1.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -4.0, 4)
        self.assertIn("the step *FREQUENCY: Harmos has static steps", self.told(text))
        self.assertIn("*BOUNDARY: boundaries of a step that is left out",
                      self.told(CUBE + STEEL + TOP + HELD + STEP.format("*CLOAD\nTOP,3,1.\n") + modes))

    def test_fixed_at_the_beginning(self) -> None:
        text = CUBE + STEEL + TOP + STEP.format(HELD.replace("*BOUNDARY", "*BOUNDARY,FIXED") + "*CLOAD\nTOP,3,1.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -4.0, 4)
        self.assertNotIn("left out", self.told(text))

    def test_loads_on_what_is_held(self) -> None:
        hold, row = "*BOUNDARY\nTOP,3,3\n", "31: "
        for load, count in (("*CLOAD\nTOP,3,1.\n", "4 nodes"), ("*CLOAD\nTOP,3,1.\nTOP,1,1.\n5,1,1.\n", "4 nodes"),
                            ("*CLOAD\n5,3,1.\n6,3,2.\n", "2 nodes"), ("*DLOAD\nCUBE,P2,1.\n", "1 faces"), ("*DSLOAD\nUP,P,1.\n", "1 faces")):
            with self.subTest(load):
                keyword = load.split("\n")[0]
                said = self.told(CUBE + STEEL + TOP + UP + HELD + hold + STEP.format(load)).replace(str(work) + "/", "")
                self.assertIn(f"left out: deck.inp:{row}{keyword}, reaction: on {count} that are held along it: {CARRIED}", said)
        said = self.told(CUBE + STEEL + TOP + HELD + STEP.format("*CLOAD\nTOP,3,1.\n") + STEP.format(hold))
        self.assertIn(CARRIED, said)
        self.assertIn(LATE, said)

    def test_loads_on_what_is_held_beside_others(self) -> None:
        text = CUBE + STEEL + TOP + HELD + "*BOUNDARY\n5,3\n" + STEP.format("*CLOAD\nTOP,3,1.\n")
        self.assertNotIn("left out", self.told(text))
        row = self.solved(text)[-1]
        self.assertAlmostEqual(sum(value for name, value in row.items() if name.startswith("reaction") and name.endswith("_z")), -4.0, 6)
        said = self.told(text.replace("TOP,3,1.", "5,3,1.\n6,3,2.\n"))
        self.assertIn(f"on 1 nodes that are held along it: {CARRIED}", said)

    def test_loads_along_axes_of_nodes_that_are_held(self) -> None:
        for kind in ("TYPE=R\n1., 1., 0., -1., 1., 0.\n", "TYPE=C\n-1., -2., 0., -1., -2., 1.\n", "TYPE=R\n0., 1., 0., -1., 0., 0.\n"):
            text = CUBE + STEEL + TOP + f"*TRANSFORM,NSET=TOP,{kind}" + HELD + "*BOUNDARY\nTOP,1,{}\n" + STEP.format("*CLOAD\nTOP,1,1.\n")
            with self.subTest(kind):
                self.assertIn(f"on 4 nodes that are held along it: {CARRIED}", self.told(text.format(3)))
                self.assertEqual("0., 1., 0." in kind, CARRIED in self.told(text.format(1)))

    def test_loads_on_held_reference_nodes(self) -> None:
        said = self.told(CUBE + STEEL + REFERENCE + HELD + "*BOUNDARY\n100,3,3,0.1\n" + STEP.format("*CLOAD\n100,3,1.\n100,1,1.\n"))
        self.assertIn(f"*COUPLING, force z: 1, on a node that is held along it: {CARRIED}", said)

    def test_choices_that_the_deck_makes(self) -> None:
        (work / "deck.inp").write_text(CUBE + STEEL + TOP + UP + HELD + STEP.format("*DSLOAD\nUP,P,1.\n"))
        for option, name in (("--hold", "TOP"), ("--load", "UP"), ("--perfect", "A_to_B")):
            result = subprocess.run([harmos, "import", str(work / "deck.inp"), "--output", str(work / "out"), option, name], capture_output=True,
                                    text=True, check=False)
            with self.subTest(option):
                self.assertEqual(result.returncode, 2, result.stdout)
                self.assertIn(f"{option} {name}: ", result.stderr)
                self.assertFalse((work / "out").exists())


unittest.main(argv=[sys.argv[0]])
