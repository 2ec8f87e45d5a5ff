#!/usr/bin/python3
"""How decks are written: encodings, blanks, quotes, lines in files of their own, numbers and names that are none or there twice.

deck_text.py HARMOS WORK_DIR
"""
import codecs
import re
import sys
import unittest

from deck_case import CUBE, HELD, PLAIN, STEEL, STEP, DeckCase, work

from harmos.exchange.exodus import read_exodus
from harmos.exchange.findings import Findings

NODES = "".join(CUBE.splitlines(keepends=True)[1:9])
REFERENCE = "*NODE\n100,0.5,0.5,1.\n*NSET,NSET=REF\n100\n*SURFACE,NAME=TOP\nCUBE,S2\n"


class DeckText(DeckCase):
    def demand_like_plain(self, text: "str | bytes") -> None:
        """The same scene as of PLAIN, but for its names and checksum."""
        def scene() -> str:
            return re.sub(r"<!-- as imported.*|CUBE|my_cube|WURFEL", "", (work / "out" / "deck.xml").read_text())

        self.assertEqual(self.imported(PLAIN)[0], 0)
        plain = scene()
        code, said = self.imported(text)
        self.assertEqual(code, 0, said)
        self.assertEqual(plain, scene())

    def test_encodings_and_ends_of_lines(self) -> None:
        named = PLAIN.replace("CUBE", "WÜRFEL")
        for text in (codecs.BOM_UTF8 + PLAIN.encode(), PLAIN.encode("utf-16"), named.encode("utf-8"), named.encode("latin-1"),
                     PLAIN.replace("\n", "\r\n").encode(), PLAIN.replace("\n", "\r").encode(), PLAIN.replace(", ", ",\t").encode()):
            with self.subTest(text[:30]):
                self.demand_like_plain(text)
        self.demand_like_plain(re.sub(r"^\*", " \t*", PLAIN, flags=re.MULTILINE).replace("*DENSITY", "** a comment\n*DENSITY"))
        self.demand_like_plain(re.sub(r"^\*.*", lambda line: line[0].replace(",", "\t,\t").replace("=", "\t=\t"), PLAIN, flags=re.MULTILINE))

    def test_commas_at_the_end_of_keywords(self) -> None:
        for keyword in ("*NODE,NSET=ALL", "*ELEMENT,TYPE=C3D8,ELSET=CUBE", "*ELASTIC", "*BOUNDARY", "*STEP", "*DLOAD"):
            with self.subTest(keyword):
                self.demand_like_plain(PLAIN.replace(keyword + "\n", keyword + ", \n", 1))
        # Abaqus goes on in the next line.
        self.demand_like_plain(PLAIN.replace("ELSET=CUBE,MATERIAL=STEEL", "ELSET=CUBE,\n Material = STEEL"))
        self.demand_like_plain(PLAIN.replace("*BOUNDARY\n1,1,3\n2,1,3\n3,1,3\n4,1,3", "*NSET,NSET=N,\ngenerate\n1,4,1\n*BOUNDARY\nN,1,3"))

    def test_elements_of_types_that_are_not_known(self) -> None:
        strange = "*ELEMENT,TYPE=STRANGE,ELSET=S\n7, 1,2,3,4,\n 5,6,7\n9, 1,2,3,4,\n 5,6,7\n"
        code, said = self.imported(PLAIN.replace("*MATERIAL", strange + "*MATERIAL"))
        self.assertEqual(code, 0, said)
        self.assertIn("deck.inp:12: *ELEMENT, TYPE=STRANGE: 2 elements are left out", said)

    def test_wide_text_that_breaks_off(self) -> None:
        self.demand_refused(PLAIN.encode("utf-16")[:-1], "it begins as UTF-16, and does not go on so")

    def test_names_with_blanks_and_quotes(self) -> None:
        for word in ('"my cube"', "my cube"):
            with self.subTest(word):
                self.demand_like_plain(PLAIN.replace("CUBE", word))

    def test_headings_with_what_no_scene_may_hold(self) -> None:
        code, said = self.imported(b"*HEADING\nbell \x07 & <escape> \x1b --\n" + PLAIN.encode())
        self.assertEqual(code, 0, said)
        self.assertIn("bell   &amp; &lt;escape&gt;", (work / "out" / "deck.xml").read_text())

    def test_data_in_files_of_their_own(self) -> None:
        (work / "nodes.txt").write_text("** a comment\n" + NODES)
        (work / "element.txt").write_text("1, 1,2,3,4,5,6,7,8\n")
        self.demand_like_plain(PLAIN.replace(NODES, "").replace("NSET=ALL", "NSET=ALL, INPUT=nodes.txt").replace(
            "1, 1,2,3,4,5,6,7,8\n", "").replace("TYPE=C3D8", "TYPE=C3D8, INPUT=element.txt"))

    def test_wrong_files_of_data(self) -> None:
        text = PLAIN.replace(NODES, "").replace("NSET=ALL", "NSET=ALL, INPUT=nodes.txt")
        self.demand_refused(text, "deck.inp:1: cannot read", "nodes.txt")
        (work / "nodes.txt").write_text(NODES.replace("6, 1, 0, 1", "6, 1, zero, 1"))
        self.demand_refused(text, "nodes.txt:6: *NODE: \"zero\" is no number")
        (work / "nodes.txt").write_text("*NODE\n" + NODES)
        self.demand_refused(text, "nodes.txt:1: a keyword, in a file of data", "*INCLUDE")
        self.demand_refused(PLAIN.replace("NSET=ALL", "NSET=ALL, INPUT=nodes.txt"), "deck.inp:1", "put them on two cards")

    def test_numbers_that_number_nothing(self) -> None:
        for number, shown in (("1e30", "1e+30"), ("1.7", "1.7"), ("-1", "-1"), ("99999999999", "99999999999")):
            with self.subTest(number):
                self.demand_refused(PLAIN.replace("\n1, 0, 0, 0", f"\n{number}, 0, 0, 0"), f"deck.inp:2: *NODE: {shown} is no number of")
        self.demand_refused(PLAIN.replace("1, 1,2,3,4,5,6,7,8\n", "1, 1,2,3,4,5,6,7,8.5\n"), "8.5 is no number of")
        for numbers, words in (("1, 99999999999, 1", "whole numbers up to"), ("1, 2000000000, 1", "more than 50000000 numbers"),
                               ("8, 1, 1", "the last is below the first"), ("8, 1, -1", "GENERATE takes")):
            with self.subTest(numbers):
                self.demand_refused(PLAIN.replace("*MATERIAL", f"*NSET,NSET=N,GENERATE\n{numbers}\n*MATERIAL"), "deck.inp:13", words)
        self.demand_refused(PLAIN.replace("4,1,3\n", "4,3,1\n"), "deck.inp:22: *BOUNDARY of components 3 to 1")
        self.demand_refused(PLAIN.replace("4,1,3\n", "4,0,3\n"), "deck.inp:22: *BOUNDARY of components 0 to 3")
        self.demand_refused(PLAIN.replace("4,1,3\n", "²,1,3\n"), "deck.inp:22", "there is no set \"²\"")

    def test_what_is_there_twice(self) -> None:
        code, said = self.imported(PLAIN.replace("8, 0, 1, 1\n", "8, 0, 1, 1\n8, 0, 1, 1\n7, 1, 1, 2\n"))
        self.assertEqual(code, 0, said)
        self.assertIn("1 nodes are given twice, at different places; the last one counts: 7", said)
        self.assertEqual(read_exodus(str(work / "out" / "deck.e"), Findings()).nodes[6, 2], 2.0)
        code, said = self.imported(PLAIN.replace("*STEP", "*MATERIAL,NAME=S2\n*ELASTIC\n5.,0.\n*SOLID SECTION,ELSET=CUBE,MATERIAL=S2\n*STEP"))
        self.assertEqual(code, 0, said)
        self.assertIn("deck.inp:17: *SOLID SECTION: 1 of its elements have the section of", said)
        self.assertIn("value=\"5\"", (work / "out" / "deck.xml").read_text())

    def test_elements_that_are_there_twice(self) -> None:
        self.demand_refused(PLAIN.replace("*MATERIAL", "*ELEMENT,TYPE=C3D8,ELSET=CUBE\n1, 5,6,7,8,1,2,3,4\n*MATERIAL"),
                            "deck.inp:12: element 1 is also at", "deck.inp:10")

    def test_names_that_are_nowhere(self) -> None:
        self.demand_refused(PLAIN.replace("MATERIAL=STEEL", "MATERIAL=Stahl"), "deck.inp:17: there is no *MATERIAL \"Stahl\"",
                            "There are: STEEL.")

    def test_nodes_of_element_sets(self) -> None:
        code, said = self.imported(PLAIN.replace("*MATERIAL", "*NSET,NSET=N,ELSET=CUBE\n*MATERIAL").replace("4,1,3\n", "4,1,3\nN,1,1\n"))
        self.assertEqual(code, 0, said)
        self.assertEqual(sorted(len(nodes) for nodes in read_exodus(str(work / "out" / "deck.e"), Findings()).node_sets.values()), [4, 4])

    def test_references_by_sets(self) -> None:
        force = STEP.format("*CLOAD\nREF,3,5.\n")
        for card in ("*COUPLING,REF NODE=REF,SURFACE=TOP,CONSTRAINT NAME=C\n*DISTRIBUTING\n1,3\n",
                     "*NSET,NSET=T\n5,6,7,8\n*RIGID BODY,NSET=T,REF NODE=REF\n"):
            with self.subTest(card):
                row = self.solved(CUBE + REFERENCE + STEEL + card + HELD + force)[-1]
                self.assertAlmostEqual(row["reaction_held_xyz_z"], -5.0, 4)

    def test_references_by_sets_of_several_nodes(self) -> None:
        card = "*COUPLING,REF NODE=ALL,SURFACE=TOP,CONSTRAINT NAME=C\n*DISTRIBUTING\n1,3\n"
        self.demand_refused(CUBE + REFERENCE + STEEL + card + HELD + STEP.format(""), "the set \"ALL\" holds 8 nodes")

    def test_generated_meshes_are_listed(self) -> None:
        code, said = self.imported(PLAIN.replace("*MATERIAL", "*NGEN,NSET=A\n1,3,1\n*ELGEN,ELSET=CUBE\n1,3,1\n*MATERIAL"))
        self.assertEqual(code, 0, said)
        self.assertIn("*NGEN: the nodes that it would make are missing", said)
        self.assertIn("*ELGEN: the elements that it would make are missing", said)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
