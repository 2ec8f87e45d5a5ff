#!/usr/bin/python3
"""Drawings: from a STEP file to a certified result, and what is refused. drawings.py HARMOS WORK_DIR"""
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import netCDF4
import numpy

harmos = sys.argv[1]
work = pathlib.Path(sys.argv[2])


def run(*words: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([harmos, *map(str, words)], capture_output=True, text=True)


class Drawings(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        subprocess.run([pathlib.Path(__file__).parent / "bolted_bracket.py", work / "joint.step"], check=True,
                       stdout=subprocess.DEVNULL)

    def test_contacts_and_certificate(self) -> None:
        end = run("import", work / "joint.step", "--output", work / "a", "--units", "mm N s", "--size", 8, "--hold",
                  "plate_face_5", "--load", "bracket_face_5", "--perfect", "plate_to_bolt_1", "--perfect",
                  "plate_to_bolt_2")
        self.assertEqual(end.returncode, 0, end.stderr)
        self.assertIn("4 solids: plate, bracket, bolt_1, bolt_2", end.stdout)
        exact = {"plate_to_bracket": 60 * 40 - 2 * math.pi * 4.5**2, "plate_to_bolt_1": math.pi * (8 * 12 + 16),
                 "bracket_to_bolt_2": math.pi * (7**2 - 4.5**2)}
        for name, area in exact.items():
            found = re.search(rf"touch, area ([\d.]+)(?: and ([\d.]+))?: interface {name}$", end.stdout, re.MULTILINE)
            assert found is not None, (name, end.stdout)
            for given in filter(None, found.groups()):
                self.assertLess(abs(float(given) / area - 1), 0.3, name)
        scene = work / "a" / "joint.xml"
        end = run("run", scene, "--output", work / "a" / "run", "--set", "Boundaries/bracket_face_5/Law/X=1", "--set",
                  "Interfaces/bracket_to_bolt_1/Law/Gap=-0.01", "--set", "Interfaces/bracket_to_bolt_2/Law/Gap=-0.01",
                  "--set", "Solver/Mesh Error=false")
        self.assertEqual(end.returncode, 0, end.stderr)
        record = json.loads((work / "a" / "run" / "joint_result.json").read_text())
        self.assertEqual((record["status"], record["units"]), ("certified", "mm N s"))
        reaction = float((work / "a" / "run" / "joint_history.csv").read_text().splitlines()[-1].split(",")[2])
        self.assertAlmostEqual(reaction, -320.0, 4)
        self.demand_forces_of_areas(work / "a" / "run" / "joint_interfaces.e", record["last_step"]["interfaces"])

    def demand_forces_of_areas(self, path: pathlib.Path, interfaces: "dict[str, dict[str, list[float]]]") -> None:
        """Sums of area times traction over the points of each interface are the forces of the record, covered in part or not."""
        with netCDF4.Dataset(path) as file:
            file.set_auto_mask(False)
            names = [row.tobytes().split(b"\0")[0].decode() for row in file.variables["name_nod_var"][:]]
            field = {name: file.variables[f"vals_nod_var{number}"][-1] for number, name in enumerate(names, 1)}
            blocks = [row.tobytes().split(b"\0")[0].decode() for row in file.variables["eb_names"][:]]
            self.assertEqual(set(blocks), set(interfaces))
            for number, block in enumerate(blocks, 1):
                points = numpy.unique(file.variables[f"connect{number}"][:]) - 1
                for axis, force in zip("xyz", interfaces[block]["force"]):
                    total = float((field["area"] * field[f"traction_{axis}"])[points].sum())
                    self.assertLess(abs(total - force), 1e-6 * 320.0, block)

    def test_bolts_are_tightened_by_force(self) -> None:
        words = ["--units", "mm N s", "--size", 8, "--hold", "plate_face_5", "--load", "bracket_face_5", "--perfect", "plate_to_bolt_1",
                 "--perfect", "plate_to_bolt_2", "--preload", "bolt_1=5000", "--preload", "bolt_2=6000"]
        end = run("import", work / "joint.step", "--output", work / "p", *words)
        self.assertEqual(end.returncode, 0, end.stderr)
        # The shank is free in the hole of the bracket alone, from 0 to 8.
        self.assertIn("bolt_1 is tightened to 5000 at (10, -10, 4): interface preload_bolt_1", end.stdout)
        self.assertNotIn("nothing holds", end.stdout)
        end = run("run", work / "p" / "joint.xml", "--output", work / "p" / "run", "--set", "Boundaries/bracket_face_5/Law/X=2",
                  "--set", "Solver/Mesh Error=false")
        self.assertEqual(end.returncode, 0, end.stdout + end.stderr)
        with open(work / "p" / "run" / "joint_history.csv", newline="") as file:
            start, tight, loaded = ({name: float(value) for name, value in row.items()} for row in csv.DictReader(file))
        self.assertEqual(start["force_bolt_1"], 0.0)
        self.assertAlmostEqual(tight["force_bolt_1"], 5000.0, delta=1.0)
        self.assertAlmostEqual(tight["force_bolt_2"], 6000.0, delta=1.0)
        self.assertAlmostEqual(tight["reaction_plate_face_5_x"], 0.0, delta=1e-3)
        self.assertAlmostEqual(loaded["reaction_plate_face_5_x"], -640.0, delta=1e-3)
        # The wall is pulled away: bolts that are locked take more.
        self.assertGreater(loaded["force_bolt_1"], 5005.0)
        self.assertLess(loaded["force_bolt_1"], 5300.0)

    def test_bolts_in_fitted_holes(self) -> None:
        subprocess.run([pathlib.Path(__file__).parent / "bolted_bracket.py", work / "fitted.step", "8"], check=True, stdout=subprocess.DEVNULL)
        words = ["--units", "mm N s", "--size", 8, "--hold", "plate_face_5", "--load", "bracket_face_5", "--perfect", "plate_to_bolt_1",
                 "--perfect", "plate_to_bolt_2", "--preload", "bolt_1=8000", "--preload", "bolt_2=8000"]
        for order in (1, 2):
            with self.subTest(order=order):
                end = run("import", work / "fitted.step", "--output", work / "fit", *words, "--order", order, "--part-size", "bracket=14",
                          "--part-size", "plate=20")
                self.assertEqual(end.returncode, 0, end.stderr)
                self.assertRegex(end.stdout, r"bracket_to_bolt_1: \d+ curved faces at the edge of flat ones")
                end = run("check", work / "fit" / "fitted.xml")
                self.assertEqual(end.returncode, 0, end.stderr)
        # At the edge under the head, friction and the pressure of the shank had held one motion twice: no run came to an end.
        end = run("import", work / "fitted.step", "--output", work / "fit", *words)
        self.assertEqual(end.returncode, 0, end.stderr)
        end = run("run", work / "fit" / "fitted.xml", "--output", work / "fit" / "run", "--set", "Values/friction=0.2",
                  "--set", "Boundaries/bracket_face_5/Law/X=2", "--set", "Solver/Mesh Error=false")
        self.assertEqual(end.returncode, 0, end.stdout + end.stderr)

    def test_bolts_that_nothing_holds_are_told(self) -> None:
        import gmsh
        gmsh.initialize(["loose"], False)
        gmsh.option.setNumber("General.Terminal", 0)
        kernel = gmsh.model.occ
        # The head lies on the cover; the thread is 1 too thin for its hole.
        block, cover = kernel.addBox(-20, -20, -20, 40, 40, 20), kernel.addBox(-20, -20, 0, 40, 40, 10)
        kernel.cut([(3, block)], [(3, kernel.addCylinder(0, 0, -16, 0, 0, 16, 6))])
        kernel.cut([(3, cover)], [(3, kernel.addCylinder(0, 0, 0, 0, 0, 10, 6))])
        kernel.fuse([(3, kernel.addCylinder(0, 0, -14, 0, 0, 24, 5))], [(3, kernel.addCylinder(0, 0, 10, 0, 0, 6, 9))])
        kernel.synchronize()
        gmsh.write(str(work / "loose.brep"))
        gmsh.finalize()
        end = run("import", work / "loose.brep", "--output", work / "l", "--size", 6, "--hold", "solid_1_face_5",
                  "--preload", "solid_3=1000")
        self.assertEqual(end.returncode, 0, end.stderr)
        self.assertIn("solid_3: nothing holds it beyond its cut, along (0, 0, -1)", end.stdout)
        self.assertNotIn("along (0, 0, 1)", end.stdout)
        end = run("run", work / "l" / "loose.xml", "--output", work / "l" / "run")
        self.assertEqual(end.returncode, 4, end.stdout + end.stderr)
        self.assertIn("no forces that the interface laws admit balance the loads of load step 1", end.stdout + end.stderr)

    def test_facets_of_fitted_faces_do_not_press(self) -> None:
        import gmsh
        gmsh.initialize(["fitted"], False)
        gmsh.option.setNumber("General.Terminal", 0)
        kernel = gmsh.model.occ
        # A pin in a hole of the same radius; a block beside it that only touches; holes in a row that only follow each other.
        plates = [kernel.addBox(-10, -10, height, 20, 20, 5) for height in (0, 5)]
        for height, plate in zip((0, 5), plates):
            kernel.cut([(3, plate)], [(3, kernel.addCylinder(0, 0, height, 0, 0, 5, 4))])
        kernel.addCylinder(0, 0, -5, 0, 0, 10, 4)
        kernel.synchronize()
        gmsh.write(str(work / "pin.brep"))
        gmsh.finalize()
        end = run("import", work / "pin.brep", "--output", work / "f", "--size", 4)
        self.assertEqual(end.returncode, 0, end.stderr)
        scene = (work / "f" / "pin.xml").read_text()
        names = re.findall(r'<ParameterList name="(solid_\d_to_solid_\d)">', scene)
        self.assertEqual(len(names), 2, end.stdout)
        closed = re.findall(r'<ParameterList name="(solid_\d_to_solid_\d)">(?:(?!</ParameterList>).)*name="Gap"', scene, re.DOTALL)
        self.assertEqual(closed, ["solid_1_to_solid_3"])

    def test_conformal_and_quadratic(self) -> None:
        end = run("import", work / "joint.step", "--output", work / "b", "--size", 15, "--part-size", "bolt_1=8", "--conformal",
                  "--preload", "bolt_1=5000")
        self.assertEqual(end.returncode, 0, end.stderr)
        end = run("check", work / "b" / "joint.xml")
        self.assertEqual(end.returncode, 0, end.stderr)
        self.assertNotIn("do not match", end.stdout)
        end = run("import", work / "joint.step", "--output", work / "b", "--size", 40, "--order", 2)
        self.assertEqual(end.returncode, 0, end.stderr)
        self.assertEqual(run("check", work / "b" / "joint.xml").returncode, 0)

    def test_lengths_are_those_of_the_units(self) -> None:
        with_units = {}
        for units, size in (("mm N s", "20"), ("m N s", "0.02"), ("in lbf s", "0.8")):
            end = run("import", work / "joint.step", "--output", work / "u", "--units", units, "--size", size)
            self.assertEqual(end.returncode, 0, end.stderr)
            found = re.search(r"area ([\d.e-]+)(?: and [\d.e-]+)?: interface plate_to_bracket", end.stdout)
            assert found is not None, end.stdout
            with_units[units] = float(found.group(1))
            self.assertEqual("converted" in end.stdout, units != "mm N s")
        # Each is meshed anew, and contact is found face by face.
        self.assertLess(abs(with_units["m N s"] / with_units["mm N s"] * 1e6 - 1.0), 0.2)
        self.assertLess(abs(with_units["in lbf s"] / with_units["mm N s"] * 25.4**2 - 1.0), 0.2)

    def test_solids_in_each_other_and_loose_surfaces_are_told(self) -> None:
        import gmsh
        gmsh.initialize(["overlap"], False)
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.model.occ.addBox(0, 0, 0, 10, 10, 10)
        gmsh.model.occ.addBox(5, 0, 0, 10, 10, 10)
        gmsh.model.occ.addBox(15, 0, 0, 10, 10, 10)
        gmsh.model.occ.addRectangle(40, 0, 0, 5, 5)
        gmsh.model.occ.synchronize()
        gmsh.write(str(work / "overlap.brep"))
        gmsh.finalize()
        end = run("import", work / "overlap.brep", "--output", work / "o", "--size", 5)
        self.assertEqual(end.returncode, 0, end.stderr)
        self.assertIn("to decide: solid_1 and solid_2 overlap by a volume of 500: ", end.stdout)
        self.assertEqual(end.stdout.count("overlap by"), 1)
        self.assertIn("surfaces and curves: 1 that belong to no solid", end.stdout)

    def test_refused(self) -> None:
        content = (work / "joint.step").read_bytes()
        (work / "cut.step").write_bytes(content[:len(content) // 2])
        (work / "garbage.brep").write_bytes(bytes(range(256)) * 20)
        (work / "cut.brep").write_text("DBRep_DrawableShape\n\nCASCADE Topology V1\nTShapes 3\nVe\n*\n")
        for words, said in (((work / "cut.step",), "cut.step"), ((work / "cut.brep",), "cut.brep: the file is truncated: 1 of 3 shapes"), ((work / "garbage.brep",), "garbage.brep"),
                            ((work / "joint.step", "--part-size", "nut=3"), "there is no part \"nut\"; there are: plate"),
                            ((work / "joint.step", "--part-size", "bolt_1"), "takes PART=SIZE"),
                            ((work / "joint.step", "--size", "15", "--hold", "none"), "--hold none: there are plate_face_1"),
                            ((work / "joint.step", "--preload", "nut=5"), "there is no part \"nut\"; there are: plate"),
                            ((work / "joint.step", "--preload", "bolt_1"), "takes PART=FORCE, a force above 0"),
                            ((work / "joint.step", "--preload", "bolt_1=-5"), "takes PART=FORCE, a force above 0"),
                            ((work / "joint.step", "--preload", "bolt_1=inf"), "takes PART=FORCE, a force above 0"),
                            ((work / "joint.step", "--preload", "plate=5"), "--preload plate: "),
                            ((work / "joint.step", "--units", "mm"), "--units \"mm\": there are mm N s")):
            with self.subTest(said):
                end = run("import", *words, "--output", work / "c")
                self.assertEqual(end.returncode, 2, end.stdout + end.stderr)
                self.assertIn(said, end.stderr)
                self.assertFalse((work / "c").exists())


unittest.main(argv=[sys.argv[0]])
