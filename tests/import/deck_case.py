"""What tests of decks share: a cube, and a deck imported and solved."""
import contextlib
import csv
import io
import pathlib
import shutil
import subprocess
import sys
import unittest

from harmos.exchange.__main__ import main

harmos = sys.argv[1]
work = pathlib.Path(sys.argv[2])

CUBE = """*NODE,NSET=ALL
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT,TYPE=C3D8,ELSET=CUBE
1, 1,2,3,4,5,6,7,8
"""
STEEL = """*MATERIAL,NAME=STEEL
*ELASTIC
1000., 0.
*DENSITY
2.
*SOLID SECTION,ELSET=CUBE,MATERIAL=STEEL
"""
HELD = "*BOUNDARY\n1,1,3\n2,1,3\n3,1,3\n4,1,3\n"
STEP = "*STEP\n*STATIC\n{}*END STEP\n"
PLAIN = CUBE + STEEL + HELD + STEP.format("*DLOAD\nCUBE, P2, 10.\n")


class DeckCase(unittest.TestCase):
    """Imports and solves decks in the folder of the test."""

    def setUp(self) -> None:
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)

    def imported(self, text: "str | bytes", name: str = "deck") -> tuple[int, str]:
        """Exit code and what is printed."""
        (work / f"{name}.inp").write_bytes(text if isinstance(text, bytes) else text.encode())
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = main(["import", "--output", str(work / "out"), str(work / f"{name}.inp")])
        return code, said.getvalue()

    def told(self, text: str) -> str:
        """What an import says that is not refused."""
        code, said = self.imported(text)
        self.assertEqual(code, 0, said)
        return said

    def solved(self, text: str, *words: str) -> list[dict[str, float]]:
        """The history of all responses."""
        code, said = self.imported(text)
        self.assertEqual(code, 0, said)
        result = subprocess.run([harmos, "run", str(work / "out" / "deck.xml"), "--output", str(work / "run"), "--set",
                                 "Solver/Accuracy=1e-6", *words], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr + result.stdout)
        with open(work / "run" / "deck_history.csv", encoding="utf-8") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def demand_refused(self, text: "str | bytes", *words: str) -> None:
        """Exit code 2, a message with these words, and nothing written."""
        code, said = self.imported(text)
        self.assertEqual(code, 2, said)
        for word in words:
            self.assertIn(word, said)
        self.assertFalse((work / "out").exists())
