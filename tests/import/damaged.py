#!/usr/bin/python3
"""Damaged files of every format: exit code 2, a message that names the file, nothing written, no signal.

damaged.py HARMOS WORK_DIR; HARMOS_FUZZ_SEED goes before seed 1, HARMOS_FUZZ_CASES before 8 cases per format.
"""
import contextlib
import io
import os
import pathlib
import random
import shutil
import subprocess
import sys
import unittest

import meshio

from boxes import boxes_mesh
from gmsh_writer import write_gmsh
from harmos.exchange.__main__ import main

harmos = sys.argv[1]
work = pathlib.Path(sys.argv[2])
chance = random.Random(int(os.environ.get("HARMOS_FUZZ_SEED") or 1))
cases = int(os.environ.get("HARMOS_FUZZ_CASES") or 8)


def mutated(content: bytes) -> bytes:
    """With some bytes changed, cut out or doubled."""
    result = bytearray(content)
    for _ in range(chance.randint(1, 4)):
        at = chance.randrange(len(result))
        kind = chance.randrange(3)
        if kind == 0:
            result[at] = chance.randrange(256)
        elif kind == 1:
            del result[at:at + chance.randint(1, 40)]
        else:
            result[at:at] = result[at:at + chance.randint(1, 40)]
    return bytes(result)


class Damaged(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        cls.mesh = boxes_mesh(harmos, work, "Tet4")
        for name, version, binary in (("text2", 2.2, False), ("binary2", 2.2, True), ("text4", 4.1, False),
                                      ("binary4", 4.1, True)):
            write_gmsh(work / f"{name}.msh", cls.mesh, version, binary)
        cells = [("tetra", block.connectivity) for block in cls.mesh.blocks]
        meshio.write(work / "grid.vtu", meshio.Mesh(cls.mesh.nodes, cells))
        meshio.write(work / "salome.med", meshio.Mesh(cls.mesh.nodes, [("tetra", cls.mesh.blocks[0].connectivity)]))
        write_gmsh(work / "universal.unv", cls.mesh)
        shutil.copy(work / "Tet4.e", work / "exodus.e")

    def imported(self, path: pathlib.Path) -> tuple[int, str]:
        said = io.StringIO()
        shutil.rmtree(work / "out", ignore_errors=True)
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
            code = main(["import", "--output", str(work / "out"), str(path)])
        return code, said.getvalue()

    def demand_refused(self, path: pathlib.Path, *words: str) -> None:
        code, said = self.imported(path)
        self.assertEqual(code, 2, said)
        for word in (path.name, *words):
            self.assertIn(word, said)
        self.assertFalse((work / "out").exists(), said)

    def sound_files(self) -> list[pathlib.Path]:
        return [work / name for name in ("text2.msh", "binary2.msh", "text4.msh", "binary4.msh", "grid.vtu",
                                         "salome.med", "universal.unv", "exodus.e")]

    def test_truncated(self) -> None:
        for path in self.sound_files():
            content = path.read_bytes()
            for share in (0.1, 0.6):
                short = work / f"short{path.suffix}"
                short.write_bytes(content[:int(share * len(content))])
                with self.subTest(path.name, share=share):
                    self.demand_refused(short)

    def test_garbage(self) -> None:
        garbage = chance.randbytes(5000)
        for suffix in (".msh", ".unv", ".med", ".vtu", ".e"):
            path = work / f"garbage{suffix}"
            path.write_bytes(garbage)
            with self.subTest(suffix):
                self.demand_refused(path)
            path.write_bytes(b"")
            self.demand_refused(path, "empty")

    def test_mutations_never_crash(self) -> None:
        for path in self.sound_files():
            content = path.read_bytes()
            for number in range(cases):
                changed = work / f"changed{path.suffix}"
                changed.write_bytes(mutated(content))
                with self.subTest(path.name, number=number):
                    code, said = self.imported(changed)
                    self.assertIn(code, (0, 2), said)
                    if code == 2:
                        self.assertIn(changed.name, said)
                        self.assertFalse((work / "out").exists())

    def test_the_line_of_a_section_that_does_not_end(self) -> None:
        lines = (work / "text4.msh").read_text().splitlines()
        at = lines.index("$Elements")
        path = work / "cut.msh"
        path.write_text("\n".join(lines[:at + 20]))
        self.demand_refused(path, f"cut.msh:{at + 1}: the section $Elements does not end")

    def test_elements_that_harmos_has_not(self) -> None:
        path = work / "unknown.msh"
        nodes = "\n".join(f"{number} {number % 3} {number % 5} {number}" for number in range(1, 14))
        path.write_text(f"""$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n13\n{nodes}\n$EndNodes
$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 19 2 1 1 {" ".join(map(str, range(1, 14)))}\n$EndElements\n""")
        self.demand_refused(path, "1 of type \"Pyramid 13\"", "TET4")

    def test_other_files(self) -> None:
        self.demand_refused(work / "missing.msh", "there is no such file")
        (work / "mesh.stl").write_text("solid")
        self.demand_refused(work / "mesh.stl", ".stl", ".msh")
        code, said = self.imported(work / "text4.msh")
        self.assertEqual((code, said), (0, ""))

    def test_no_result_replaces_the_input(self) -> None:
        (work / "same").mkdir()
        path = work / "same" / "mesh.e"
        shutil.copy(work / "exodus.e", path)
        result = subprocess.run([harmos, "import", str(path), "--output", str(work / "same")], capture_output=True,
                                text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("would replace the input", result.stderr)
        self.assertEqual(path.read_bytes(), (work / "exodus.e").read_bytes())

    def test_a_scene_that_was_changed_is_kept(self) -> None:
        words = [harmos, "import", str(work / "text4.msh"), "--output", str(work / "again")]
        scene = work / "again" / "text4.xml"
        for _ in range(2):
            result = subprocess.run(words, capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)
        edited = scene.read_text().replace("0.3", "0.25")
        self.assertNotEqual(edited, scene.read_text())
        scene.write_text(edited)
        mesh = (work / "again" / "text4.e").read_bytes()
        result = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("text4.xml is not as it was imported, and its changes would be lost", result.stderr)
        self.assertEqual(scene.read_text(), edited)
        self.assertEqual((work / "again" / "text4.e").read_bytes(), mesh)

    def test_through_a_scene(self) -> None:
        scene = (work / "Tet4.xml").read_text()
        begin, end = scene.index('<ParameterList name="Mesh">'), scene.index('<ParameterList name="Materials">')
        (work / "bad.msh").write_bytes((work / "text4.msh").read_bytes()[:3000])
        (work / "scene.xml").write_text(f"""{scene[:begin]}<ParameterList name="Mesh">
          <Parameter name="Type" type="string" value="Exodus"/>
          <Parameter name="File" type="string" value="bad.msh"/></ParameterList>{scene[end:]}""")
        result = subprocess.run([harmos, "check", str(work / "scene.xml")], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertRegex(result.stderr, r"bad\.msh:\d+: the section \$\w+ does not end")


unittest.main(argv=[sys.argv[0]])
