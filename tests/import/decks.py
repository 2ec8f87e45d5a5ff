#!/usr/bin/python3
"""Decks of Abaqus and CalculiX: what they mean, by closed forms; what is left out is listed; wrong ones are refused.

decks.py HARMOS WORK_DIR; HARMOS_FUZZ_SEED goes before seed 1, HARMOS_FUZZ_CASES before 60 cases.
"""
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import unittest

import netCDF4
import numpy

from deck_case import CUBE, HELD, PLAIN, STEEL, STEP, DeckCase, harmos, work

chance = random.Random(int(os.environ.get("HARMOS_FUZZ_SEED") or 1))
cases = int(os.environ.get("HARMOS_FUZZ_CASES") or 60)
blocks = (pathlib.Path(__file__).parent / "pressed_blocks.inp").read_text()


class Decks(DeckCase):
    def test_pressure_gravity_and_force(self) -> None:
        self.assertAlmostEqual(self.solved(PLAIN)[-1]["reaction_held_xyz_z"], 10.0, 4)
        gravity = CUBE + STEEL + HELD + STEP.format("*DLOAD\nCUBE, GRAV, 9.81, 0., 0., -2.\n")
        self.assertAlmostEqual(self.solved(gravity)[-1]["reaction_held_xyz_z"], 2.0 * 9.81, 4)
        even = CUBE + STEEL + HELD + STEP.format("*CLOAD\n5,3,-2.5\n6,3,-2.5\n7,3,-2.5\n8,3,-2.5\n")
        row = self.solved(even)[-1]
        self.assertAlmostEqual(row["u_loaded_z"], -10.0 / 1000.0, 6)
        single = CUBE + STEEL + HELD + STEP.format("*CLOAD\n5,1,-2.5\n7,2,4.\n")
        row = self.solved(single)[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_x"], 2.5, 4)
        self.assertAlmostEqual(row["reaction_held_xyz_y"], -4.0, 4)

    def test_steps_and_amplitudes(self) -> None:
        amplitude = "*AMPLITUDE,NAME=SAW\n0., 0., 0.5, 1., 1., 0.\n"
        steps = (STEP.format("0.25, 1.\n*DLOAD,AMPLITUDE=SAW\nCUBE, P2, 8.\n")
                 + STEP.format("0.5, 2.\n*DLOAD,OP=NEW\nCUBE, P2, 6.\n"))
        history = self.solved(CUBE + STEEL + HELD + amplitude + steps)
        self.assertEqual([row["time"] for row in history], [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0])
        for row, force in zip(history, (0.0, 4.0, 8.0, 4.0, 0.0, 1.5, 3.0, 4.5, 6.0)):
            self.assertAlmostEqual(row["reaction_held_xyz_z"], force, 3)

    def test_amplitudes_that_start_later_or_are_no_tables(self) -> None:
        saw = "*AMPLITUDE,NAME=SAW{}\n0., 0., 0.5, 1., 1., 0.\n"
        text = CUBE + STEEL + HELD + saw + STEP.format("0.25, 1.\n*DLOAD,AMPLITUDE=SAW{}\nCUBE, P2, 8.\n")
        for shift, delay in ((",SHIFTX=0.25", ""), ("", ",TIME DELAY=0.25")):
            history = self.solved(text.format(shift, delay))
            for row, force in zip(history, (0.0, 0.0, 4.0, 8.0, 4.0)):
                self.assertAlmostEqual(row["reaction_held_xyz_z"], force, 3)
        history = self.solved(text.format(",SHIFTY=1.", ""))
        self.assertAlmostEqual(history[-1]["reaction_held_xyz_z"], 8.0, 3)
        code, said = self.imported(text.format(",DEFINITION=PERIODIC", ""))
        self.assertEqual(code, 0, said)
        self.assertIn("*AMPLITUDE SAW: is no table", said)
        shutil.rmtree(work / "out")
        self.demand_refused(text.format(",SHIFTX=x", ""), "\"X\" is no number")

    def test_weights_of_several_steps(self) -> None:
        weight = STEP.format("*DLOAD{}\nCUBE, GRAV, 9.81, 0., 0., -1.\n")
        text = CUBE + STEEL + HELD + weight.format("")
        history = self.solved(text + STEP.format("*DLOAD,OP=NEW\nCUBE, P2, 1.\n"))
        self.assertAlmostEqual(history[1]["reaction_held_xyz_z"], 19.62, 3)
        self.assertAlmostEqual(history[2]["reaction_held_xyz_z"], 1.0, 3)
        # As CalculiX does: of one direction those of a step add up, and those of a later one replace them; others stay.
        for more, x, z in (("0., 0., -3.", 0.0, 4.0), ("1., 0., 0.", -4.0, 19.62)):
            row = self.solved(text + STEP.format(f"*DLOAD\nCUBE, GRAV, 2., {more}\n"))[-1]
            self.assertAlmostEqual(row["reaction_held_xyz_x"], x, 3)
            self.assertAlmostEqual(row["reaction_held_xyz_z"], z, 3)
        row = self.solved(CUBE + STEEL + HELD + STEP.format("*DLOAD\nCUBE, GRAV, 9., 0., 0., -1.\nCUBE, GRAV, 2., 0., 0., -1.\n"))[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], 22.0, 3)

    def test_boundaries_that_are_said_anew(self) -> None:
        pull = "*BOUNDARY\n5,3,3,0.01\n6,3,3,0.01\n7,3,3,0.01\n8,3,3,0.01\n"
        again = "*BOUNDARY,OP=NEW\n1,1,3\n2,1,3\n3,1,3\n4,1,3\n{}"
        text = CUBE + STEEL + HELD + STEP.format(pull)
        history = self.solved(text + STEP.format(again.format(pull.replace("*BOUNDARY\n", "").replace("0.01", "0.02"))))
        self.assertAlmostEqual(history[-1]["reaction_moved_z_z"], 20.0, 4)
        code, said = self.imported(text + STEP.format(again.format(pull.replace("*BOUNDARY\n", ""))))
        self.assertNotIn("left out", said)
        code, said = self.imported(text + STEP.format(again.format("")))
        self.assertEqual(code, 0, said)
        self.assertIn("deck.inp:33: *BOUNDARY, OP=NEW: 4 nodes are released from here on: they stay held", said)

    def test_constraints_are_listed_by_what_they_would_change(self) -> None:
        code, said = self.imported(PLAIN.replace("*BOUNDARY", "*MPC\nPLANE,5,6,7,8\nMEANROT,5,6,7\nPLANE,1,2,3,4\n*BOUNDARY", 1))
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"deck.inp:\d+: \*MPC PLANE: its nodes need not stay in one plane")
        self.assertRegex(said, r"deck.inp:\d+: \*MPC MEANROT: the mean rotation")
        self.assertEqual(said.count("*MPC"), 2)

    def test_fixed(self) -> None:
        keep = STEP.format("*BOUNDARY\n5,3,3,0.01\n") + STEP.format("*BOUNDARY,FIXED\n5,3\n6,3\n*DLOAD\nCUBE, P2, 0.\n")
        code, said = self.imported(CUBE + STEEL + HELD + keep)
        self.assertEqual(code, 0, said)
        self.assertNotIn("deck.inp:31: *BOUNDARY, FIXED", said)
        self.assertIn("deck.inp:32: *BOUNDARY, FIXED: 1 of its nodes were free before", said)
        self.assertIn('"Z" type="double" value="0.01"', (work / "out" / "deck.xml").read_text())

    def test_instances_and_ties(self) -> None:
        part = f"*PART,NAME=BRICK\n{CUBE}*SOLID SECTION,ELSET=CUBE,MATERIAL=STEEL\n*END PART\n"
        turned = "*INSTANCE,NAME=B,PART=BRICK\n0., 0., 2.\n0., 0., 2., 1., 0., 2., -90.\n*END INSTANCE\n"
        assembly = (f"*ASSEMBLY,NAME=ALL\n*INSTANCE,NAME=A,PART=BRICK\n*END INSTANCE\n{turned}"
                    "*SURFACE,NAME=TOP_A\nA.CUBE, S2\n*SURFACE,NAME=END_B\nB.CUBE, S5\n"
                    "*NSET,NSET=BOTTOM,INSTANCE=A,GENERATE\n1, 4\n*END ASSEMBLY\n*TIE,NAME=GLUE\nEND_B, TOP_A\n")
        material = STEEL[:STEEL.index("*SOLID")]
        # B is turned about the x axis at z = 2 by -90 degrees: y goes to -z, z to y.
        move = "*BOUNDARY\nBOTTOM,1,3\n"
        text = part + assembly + material + move
        code, said = self.imported(text + STEP.format(""))
        self.assertEqual(code, 0, said)
        mesh = subprocess.run(["ncdump", "-v", "coordz", str(work / "out" / "deck.e")], capture_output=True, text=True)
        self.assertIn("interface end_b_top_a", said)
        self.assertIn("coordz = 0, 0, 0, 0, 1, 1, 1, 1", mesh.stdout)
        checked = subprocess.run([harmos, "check", str(work / "out" / "deck.xml")], capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        # The far end of B is no neighbour of the top of A.
        code, said = self.imported(text.replace("B.CUBE, S5", "B.CUBE, S3"))
        self.assertEqual(code, 0, said)
        self.assertIn("deck.inp:30: *TIE: no face of END_B lies opposite one of TOP_A", said)

    def test_stacked_instances_carry_a_pressure(self) -> None:
        part = f"*PART,NAME=BRICK\n{CUBE}*SOLID SECTION,ELSET=CUBE,MATERIAL=STEEL\n*END PART\n"
        assembly = ("*ASSEMBLY,NAME=ALL\n*INSTANCE,NAME=A,PART=BRICK\n*END INSTANCE\n*INSTANCE,NAME=B,PART=BRICK\n"
                    "0., 0., 1.\n*END INSTANCE\n*SURFACE,NAME=TOP_A\nA.CUBE, S2\n*SURFACE,NAME=BOTTOM_B\nB.CUBE, S1\n"
                    "*SURFACE,NAME=TOP_B\nB.CUBE, S2\n*NSET,NSET=BOTTOM,INSTANCE=A,GENERATE\n1, 4\n*END ASSEMBLY\n"
                    "*TIE,NAME=GLUE\nBOTTOM_B, TOP_A\n")
        material = STEEL[:STEEL.index("*SOLID")]
        text = part + assembly + material + "*BOUNDARY\nBOTTOM, ENCASTRE\n" + STEP.format("*DSLOAD\nTOP_B, P, -20.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -20.0, 4)

    def test_contact(self) -> None:
        history = self.solved(blocks)
        self.assertAlmostEqual(history[-1]["reaction_held_xyz_z"], 20000.0, 2)
        self.assertAlmostEqual(history[-1]["reaction_held_xyz_x"], -2000.0, 2)
        self.assertEqual([row["time"] for row in history], [0.0, 1.0, 1.5, 2.0])

    def stack(self, interaction: str, load: str, pair: str = "*CONTACT PAIR,INTERACTION=CC\n") -> str:
        """Two cubes, the upper one on the lower, which is held; its own sides are held against sliding."""
        upper = "".join(f"{node + 8}, {x}, {y}, {z + 1}\n" for node, (x, y, z) in enumerate(
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], 1))
        return (CUBE + f"*NODE\n{upper}*ELEMENT,TYPE=C3D8,ELSET=CUBE\n2, 9,10,11,12,13,14,15,16\n" + STEEL + HELD
                + "*NSET,NSET=TOP\n13,14,15,16\n*SURFACE,NAME=S\n2, S1\n*SURFACE,NAME=M\n1, S2\n"
                + f"*SURFACE INTERACTION,NAME=CC\n{interaction}{pair}S, M\n" + STEP.format(load))

    def test_pressure_overclosure(self) -> None:
        down = "*BOUNDARY\nTOP,1,2\nTOP,3,3,-0.01\n"
        # Two cubes of stiffness 1000 in a row, and the contact between them.
        for behavior, force in (
                ("*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=HARD\n", 0.01 * 500.0),
                ("*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n500., 3.\n", 0.01 / (1 / 500.0 + 2 / 1000.0)),
                ("*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=TIED\n500.\n", 0.01 / (1 / 500.0 + 2 / 1000.0)),
                ("*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=TABULAR\n0., -0.001\n2., 0.003\n3., 0.01\n",
                 2.0 + (0.01 - 0.003 - 2.0 * 2 / 1000.0) / (7e-3 + 2e-3))):
            with self.subTest(behavior):
                row = self.solved(self.stack(behavior, down))[-1]
                self.assertAlmostEqual(row["reaction_held_xyz_z"], force, 4)
        # Exponential: p = p0 100^(overclosure / c0), beside the pressure that is found.
        row = self.solved(self.stack("*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.004, 1.\n", down))[-1]
        pressure = row["reaction_held_xyz_z"]
        self.assertAlmostEqual(pressure / 100.0 ** ((0.01 - pressure * 2 / 1000.0) / 0.004), 1.0, 2)
        # Tied surfaces hang on each other.
        up = "*BOUNDARY\nTOP,1,2\nTOP,3,3,0.01\n"
        row = self.solved(self.stack("*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=TIED\n500.\n", up))[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], -2.5, 4)
        for wrong in ("LINEAR\n-1.\n", "EXPONENTIAL\n1.\n", "TABULAR\n1., 0.\n2., 1.\n", "ODD\n1.\n"):
            with self.subTest(wrong):
                code, said = self.imported(self.stack(f"*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE={wrong}", down))
                self.assertEqual(code, 0, said)
                self.assertIn("contact is hard", said)

    def test_adjust(self) -> None:
        # The upper cube stands 0.002 above the lower one; its slave nodes are the same four that ADJUST moves.
        down = "*BOUNDARY\nTOP,1,2\nTOP,3,3,-0.01\n"
        pair = "*NSET,NSET=LOW\n9,10,11,12\n*CONTACT PAIR,INTERACTION=CC,ADJUST={}\n"
        for adjust, gap in (("0.005", 0.0), ("0.001", 0.002), ("LOW", 0.0)):
            with self.subTest(adjust):
                text = self.stack("", down, pair.format(adjust))
                for node in range(9, 13):
                    text = re.sub(rf"^({node}, .*, 1)$", r"\1.002", text, flags=re.MULTILINE)
                row = self.solved(text)[-1]
                # The cube is 0.998 high, until its nodes have moved.
                self.assertAlmostEqual(row["reaction_held_xyz_z"], 1000.0 * (0.01 - gap) / (2.0 - gap), 4)
        self.assertIn("ADJUST: 4 nodes of S moved onto M", self.imported(text)[1])
        shutil.rmtree(work / "out")
        self.demand_refused(self.stack("", down, "*CONTACT PAIR,INTERACTION=CC,ADJUST=NONE\n"), "ADJUST=NONE", "distance or a node set")

    def test_adjust_of_curved_faces(self) -> None:
        # A quadratic face whose middle nodes ADJUST moves down to the other dips into it by 0.002 between them and the edge that
        # touches: that is no interference.
        bottom, top = [(0, 0, 1), (1, 0, 1.016), (1, 1, 1.016), (0, 1, 1)], [(0, 0, 2), (1, 0, 2), (1, 1, 2), (0, 1, 2)]

        def middle(one: tuple[float, ...], other: tuple[float, ...]) -> tuple[float, ...]:
            return tuple((a + b) / 2 for a, b in zip(one, other))

        corners = [*bottom, *top]
        edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
        nodes = corners + [(*middle(corners[a], corners[b])[:2], 1.004) if (a, b) in ((0, 1), (2, 3)) else middle(corners[a], corners[b])
                           for a, b in edges]
        rows = "".join(f"{number + 9}, {x}, {y}, {z}\n" for number, (x, y, z) in enumerate(nodes))
        numbers = ", ".join(str(number + 9) for number in range(20))
        text = (CUBE + f"*NODE\n{rows}*ELEMENT,TYPE=C3D20,ELSET=CUBE\n2, {numbers}\n" + STEEL + HELD
                + "*NSET,NSET=TOP\n13,14,15,16,21,22,23,24\n*BOUNDARY\nTOP,1,3\n*SURFACE,NAME=S\n2, S1\n*SURFACE,NAME=M\n1, S2\n"
                + "*NSET,NSET=SOME\n17,19\n*SURFACE INTERACTION,NAME=CC\n*CONTACT PAIR,INTERACTION=CC,ADJUST={}\nS, M\n" + STEP.format(""))
        for adjust in ("0.005", "SOME"):
            with self.subTest(adjust):
                self.assertAlmostEqual(self.solved(text.replace("{}", adjust))[-1]["reaction_held_xyz_z"], 0.0, 9)
        self.assertIn("ADJUST: 2 nodes of S moved onto M", self.imported(text.replace("{}", "SOME"))[1])

    def test_friction_with_a_slope_of_sticking(self) -> None:
        # Pressed by 2.5, then pushed aside: the cubes shear by 2 F / G, G = 500, and bend, and the contact gives F / slope.
        behavior = "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n500.\n*FRICTION\n0.4, 100.\n"
        shear = "*BOUNDARY\nTOP,1,1,{}\nTOP,2,2\nTOP,3,3,-0.01\n"
        forces = [-self.solved(self.stack(behavior.replace("100.", slope), shear.format(push)))[-1]["reaction_held_xyz_x"]
                  for slope, push in (("100.", "0.001"), ("1e6", "0.001"), ("100.", "0.1"))]
        # Of the same springs in series the one of the contact changes: 1/F100 - 1/F1e6 = (1/100 - 1/1e6) / push.
        self.assertAlmostEqual(1 / forces[0] - 1 / forces[1], (1 / 100.0 - 1e-6) / 0.001, delta=0.01)
        self.assertAlmostEqual(forces[2], 0.4 * 2.5, 3)
        code, said = self.imported(self.stack("*FRICTION\n0.4, 100.\n", ""))
        self.assertEqual(code, 0, said)
        self.assertIn("*FRICTION, stick slope", said)

    def test_ties_of_cyclic_symmetry_are_listed(self) -> None:
        code, said = self.imported(self.stack("", "", "*TIE,NAME=T,CYCLIC SYMMETRY\n"))
        self.assertEqual(code, 0, said)
        self.assertIn("*TIE, CYCLIC SYMMETRY", said)
        self.assertNotIn("interface", said)

    def test_surfaces_that_look_the_same_way_are_listed(self) -> None:
        code, said = self.imported(self.stack("", "").replace("*SURFACE,NAME=S\n2, S1", "*SURFACE,NAME=S\n2, S2"))
        self.assertEqual(code, 0, said)
        self.assertIn("*CONTACTPAIR: S and M look the same way: CUBE_2 and CUBE overlap", said)

    def test_two_surfaces_of_one_name(self) -> None:
        text = self.stack("", "*BOUNDARY\nTOP,1,2\nTOP,3,3,-0.01\n").replace(
            "*SURFACE,NAME=M\n", "*SURFACE,NAME=S,TYPE=NODE\n9\n*SURFACE,NAME=M\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], 5.0, 4)
        self.assertRegex(self.imported(text)[1], r"left out: \S*:38: \*SURFACE S, TYPE=NODE: .*the faces of the same name")

    def test_a_card_without_elements(self) -> None:
        empty = PLAIN.replace("1, 1,2,3,4,5,6,7,8\n", "").replace("CUBE, P2", "1, P2")
        self.demand_refused(empty, "the deck holds no solid elements")

    def test_elements_that_are_there_twice_are_refused(self) -> None:
        self.demand_refused(PLAIN.replace("1, 1,2,3,4,5,6,7,8\n", "1, 1,2,3,4,5,6,7,8\n2, 2,3,4,1,6,7,8,5\n"),
                            "1 elements have the nodes of another one")

    def test_more_nodes_than_the_type_has(self) -> None:
        text = PLAIN.replace("1, 1,2,3,4,5,6,7,8\n", "1, 1,2,3,4,5,6,7,8,91,92,93\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], 10.0, 4)
        self.assertIn("more than 8 nodes", self.imported(text)[1])

    def test_rigid_nodes_on_a_line_and_elasticity_without_stiffness_are_listed(self) -> None:
        rigid = "*NODE\n99,0,0,2\n*NSET,NSET=EDGE\n5,6\n*RIGID BODY,NSET=EDGE,REF NODE=99\n*STEP\n"
        code, said = self.imported(PLAIN.replace("*STEP\n", rigid))
        self.assertEqual(code, 0, said)
        self.assertIn("*RIGID BODY: of nodes on one line", said)
        # Corners of a quadratic tetrahedron have no share of its faces.
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        places = corners + [tuple((a + b) / 2 for a, b in zip(corners[i], corners[j]))
                            for i, j in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
        nodes = "".join(f"{number}, {x}, {y}, {z}\n" for number, (x, y, z) in enumerate(places, 1))
        code, said = self.imported(f"*NODE\n{nodes}99,0,0,2\n*ELEMENT,TYPE=C3D10,ELSET=CUBE\n1,1,2,3,4,5,6,7,8,9,10\n{STEEL}"
                                   "*NSET,NSET=FACE\n2,3,4\n*RIGID BODY,NSET=FACE,REF NODE=99\n*BOUNDARY\n1,1,3\n")
        self.assertEqual(code, 0, said)
        self.assertIn("*RIGID BODY: of nodes without a share of the surface", said)
        code, said = self.imported(PLAIN.replace("*ELASTIC\n1000., 0.\n", "*ELASTIC,TYPE=ORTHO\n" + "1., " * 8 + "\n1.\n"))
        self.assertEqual(code, 0, said)
        self.assertIn("no stiffness in some direction", said)

    def test_forces_on_corners_of_quadratic_tetrahedra_act(self) -> None:
        # Constant tractions have no share there, and one such force is not like the others.
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        places = corners + [tuple((a + b) / 2 for a, b in zip(corners[i], corners[j]))
                            for i, j in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
        nodes = "".join(f"{number}, {x}, {y}, {z}\n" for number, (x, y, z) in enumerate(places, 1))
        text = (f"*NODE\n{nodes}*ELEMENT,TYPE=C3D10,ELSET=CUBE\n1,1,2,3,4,5,6,7,8,9,10\n{STEEL}*NSET,NSET=FOOT\n1,2,3,5,6,7\n"
                "*BOUNDARY\nFOOT,1,3\n" + STEP.format("*CLOAD\n4,3,7.\n8,3,2.\n9,3,2.\n4,1,1.\n"))
        row = self.solved(text)[-1]
        held = [sum(value for name, value in row.items() if name.startswith("reaction_held") and name.endswith(axis))
                for axis in "xyz"]
        for found, expected in zip(held, (-1.0, 0.0, -11.0)):
            self.assertAlmostEqual(found, expected, 4)
        self.assertNotIn("left out:", self.imported(text)[1])

    def test_temperatures_that_stand_elsewhere_are_listed(self) -> None:
        code, said = self.imported(PLAIN.replace("*DENSITY", "*EXPANSION\n1e-5\n*DENSITY").replace(
            "*DLOAD", "*TEMPERATURE,SUBMODEL,STEP=1\nALL\n*DLOAD"))
        self.assertEqual(code, 0, said)
        self.assertIn("*TEMPERATURE, SUBMODEL", said)

    def test_equations_with_held_nodes(self) -> None:
        # The top follows node 99, which is in no solid, by way of node 5.
        equations = "*EQUATION\n2\n5,3,1.,99,3,-1.\n" + "".join(f"2,\n5,3,-2.,{node},3,2.\n" for node in (6, 7, 8))
        text = CUBE.replace("*ELEMENT", "99, 0, 0, 5\n*ELEMENT") + STEEL + HELD + equations
        row = self.solved(text + STEP.format("*BOUNDARY\n99,3,3,0.02\n"))[-1]
        self.assertAlmostEqual(row["reaction_moved_z_z"], 20.0, 4)
        code, said = self.imported(text + STEP.format("*BOUNDARY\n99,3,3,0.02\n"))
        self.assertNotIn("left out:", said)
        # Without it nothing says how they move; axes of their own, and other coefficients, are something else.
        for changed in (text + STEP.format(""), text.replace("1.,99,3,-1.", "1.,99,3,-2.") + STEP.format("*BOUNDARY\n99,3,3,0.1\n"),
                        text + "*TRANSFORM,NSET=ALL\n0.,1.,0.,1.,0.,0.\n" + STEP.format("*BOUNDARY\n99,3,3,0.1\n")):
            code, said = self.imported(changed)
            self.assertEqual(code, 0, said)
            self.assertIn("deck.inp:24: *EQUATION: 4 of 4 equations", said)
        shutil.rmtree(work / "out")
        self.demand_refused(text.replace("1.,99,3", "1.,98,3") + STEP.format(""), "deck.inp:26", "node 98 is nowhere")
        self.demand_refused(text.replace("8,3,2.\n", "8,3\n") + STEP.format(""), "*EQUATION takes")

    def test_equations_that_tie(self) -> None:
        # A quarter of the face of the lower cube carries a small one, whose nodes move as points of that face.
        small = "".join(f"{node + 8}, {0.5 * x}, {0.5 * y}, {1 + 0.5 * z}\n" for node, (x, y, z) in enumerate(
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], 1))
        shares = {9: (1, 0, 0, 0), 10: (0.5, 0.5, 0, 0), 11: (0.25,) * 4, 12: (0.5, 0, 0, 0.5)}
        equations = "".join(
            f"{1 + sum(share > 0 for share in of)}\n{node},{axis},1." + "".join(
                f",{corner},{axis},{-share}" for corner, share in zip((5, 6, 7, 8), of) if share) + "\n"
            for node, of in shares.items() for axis in (1, 2, 3))
        text = (CUBE + f"*NODE\n{small}*ELEMENT,TYPE=C3D8,ELSET=CUBE\n2, 9,10,11,12,13,14,15,16\n" + STEEL + HELD
                + f"*EQUATION\n{equations}" + STEP.format("*DLOAD\n2, P2, -8.\n"))
        row = self.solved(text)[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], -2.0, 4)
        code, said = self.imported(text)
        self.assertIn("equations tie CUBE_2 to CUBE: interface", said)
        self.assertNotIn("left out:", said)
        code, said = self.imported(text.replace("0.25", "0.2"))
        self.assertIn("*EQUATION: 12 of 12 equations", said)

    def test_nodes_on_the_axis_of_revolution(self) -> None:
        # A disk of quadratic elements, pulled along the axis on nodes of which some lie on it.
        places = {(i, j): 1 + i + 5 * j for j in range(5) for i in range(5) if not (i % 2 and j % 2)}
        nodes = "".join(f"{node}, {0.5 * i}, {0.5 * j}\n" for (i, j), node in places.items())
        rows = "".join(f"{1 + i + 2 * j}, " + ", ".join(
            str(places[2 * i + a, 2 * j + b]) for a, b in ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))) + "\n"
            for j in range(2) for i in range(2))
        top, foot, axis = (",".join(str(places[each]) for each in places if each[at] == value)
                           for at, value in ((1, 4), (1, 0), (0, 0)))
        text = (f"*NODE\n{nodes}*ELEMENT,TYPE=CAX8,ELSET=CUBE\n{rows}{STEEL}*NSET,NSET=TOP\n{top}\n*NSET,NSET=FOOT\n{foot}\n"
                f"*NSET,NSET=AXIS\n{axis}\n*BOUNDARY\nAXIS,1,1\nFOOT,2,2\n" + STEP.format("*BOUNDARY\nTOP,2,2,0.02\n"))
        row = self.solved(text)[-1]
        pulled = sum(value for name, value in row.items() if name.startswith("reaction_moved") and name.endswith("_y"))
        self.assertAlmostEqual(pulled, 1000.0 * 0.01 * 3.141592653589793 * 4.0, 3)
        # A point of the axis, inside of the disk, is a point, and holds a force.
        middle = str(places[0, 2])
        text = text.replace("*BOUNDARY\nTOP,2,2,0.02\n", f"*CLOAD\n{middle},2,7.\n")
        row = self.solved(text)[-1]
        held = sum(value for name, value in row.items() if name.startswith("reaction_held") and name.endswith("_y"))
        self.assertAlmostEqual(held, -7.0, 3)

    def bar(self, vector: str, load: str) -> str:
        """Ten cubes in a row, held at both ends, with a pretension section in the middle."""
        nodes = "".join(f"{4 * k + n}, {x}, {y}, {k}\n" for k in range(11)
                        for n, (x, y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)), 1))
        rows = "".join(f"{k + 1}, " + ", ".join(str(4 * k + n) for n in range(1, 9)) + "\n" for k in range(10))
        return (f"*NODE\n{nodes}999,0,0,0\n*ELEMENT,TYPE=C3D8,ELSET=CUBE\n{rows}{STEEL}*SURFACE,NAME=CUT\n5, S2\n"
                f"*PRE-TENSION SECTION,SURFACE=CUT,NODE=999\n{vector}"
                "*NSET,NSET=ENDS\n1,2,3,4,41,42,43,44\n*BOUNDARY\nENDS,1,3\n" + STEP.format(load))

    def test_pretension(self) -> None:
        for vector, value in (("", 0.01), ("0,0,1\n", 0.01), ("0,0,-1\n", -0.01)):
            with self.subTest(vector):
                row = self.solved(self.bar(vector, f"*BOUNDARY\n999,1,1,{value}\n"))[-1]
                self.assertAlmostEqual(row["bolt_force_preload_cut"], 1000.0 * 0.01 / 10.0, 5)

    def test_tetrahedra_beside_a_pretension_section_are_told(self) -> None:
        # Each cube as six tetrahedra about the diagonal from its first to its seventh corner.
        text = self.bar("", "*BOUNDARY\n999,1,1,0.01\n")
        begin, end = text.index("*ELEMENT"), text.index("*MATERIAL")
        rows, upper = [], []
        for cube in range(10):
            nodes = [4 * cube + n for n in range(1, 9)]
            for one, other in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1)):
                rows.append((nodes[0], nodes[one], nodes[other], nodes[6]))
                if cube == 4 and {nodes[one], nodes[other]} <= set(nodes[4:]):
                    upper.append(len(rows))
        elements = "".join(f"{k}, {', '.join(map(str, row))}\n" for k, row in enumerate(rows, 1))
        text = f"{text[:begin]}*ELEMENT,TYPE=C3D4,ELSET=CUBE\n{elements}{text[end:]}"
        text = text.replace("5, S2\n", "".join(f"{each}, S3\n" for each in upper))
        row = self.solved(text)[-1]
        self.assertAlmostEqual(row["bolt_force_preload_cut"], 1000.0 * 0.01 / 10.0, 5)
        self.assertIn("4 elements of CUBE touch the section without a face on it", self.imported(text)[1])
        self.assertNotIn("without a face on it", self.imported(self.bar("", ""))[1])

    def test_pretension_by_force(self) -> None:
        pull = "*BOUNDARY\n41,3,3,0.02\n42,3,3,0.02\n43,3,3,0.02\n44,3,3,0.02\n"
        for vector, force in (("", 7.0), ("0,0,-1\n", -7.0)):
            for lock in ("*BOUNDARY,FIXED\n999,1,1\n", "*BOUNDARY\n999,1,1\n"):
                with self.subTest(vector + lock):
                    text = self.bar(vector, f"*CLOAD\n999,1,{force}\n") + STEP.format(lock + pull)
                    history = self.solved(text)
                    # Locked, the bar goes on as one of ten cubes.
                    self.assertAlmostEqual(history[1]["bolt_force_preload_cut"], 7.0, 4)
                    self.assertAlmostEqual(history[-1]["bolt_force_preload_cut"], 7.0 + 1000.0 * 0.02 / 10.0, 4)
        text = self.bar("", "*CLOAD\n999,1,7.\n") + STEP.format(pull)
        self.assertAlmostEqual(self.solved(text)[-1]["bolt_force_preload_cut"], 7.0, 4)

    def test_couplings(self) -> None:
        # The end of ten cubes, of unit modulus times 1000, from a point beyond it.
        def bar(kind: str, more: str, load: str) -> str:
            text = self.bar("", load).replace("*SURFACE,NAME=CUT\n5, S2\n*PRE-TENSION SECTION,SURFACE=CUT,NODE=999\n",
                                              f"*SURFACE,NAME=END\n10, S2\n{kind}")
            return text.replace("1,2,3,4,41,42,43,44", "1,2,3,4").replace("999,0,0,0", "999,0.5,0.5,12.").replace(
                "TYPE=C3D8", "TYPE=C3D8I") .replace("*BOUNDARY\nENDS", more + "*BOUNDARY\nENDS")
        distributing = "*COUPLING,CONSTRAINT NAME=C,REF NODE=999,SURFACE=END\n*DISTRIBUTING\n"
        kinematic = "*COUPLING,CONSTRAINT NAME=C,REF NODE=999,SURFACE=END\n*KINEMATIC\n1,3\n"
        nodes = "*NSET,NSET=LAST\n41,42,43,44\n"
        rigid = "*RIGID BODY,NSET=LAST,REF NODE=999\n"
        for kind in (distributing, kinematic, nodes + rigid):
            with self.subTest(kind):
                row = self.solved(bar(kind, "", "*CLOAD\n999,1,3.\n999,3,5.\n"))[-1]
                self.assertAlmostEqual(row["reaction_held_xyz_x"], -3.0, 4)
                self.assertAlmostEqual(row["reaction_held_xyz_z"], -5.0, 4)
                row = self.solved(bar(kind, "", "*BOUNDARY\n999,3,3,0.02\n"))[-1]
                self.assertAlmostEqual(row["reaction_held_xyz_z"], -1000.0 * 0.02 / 10.0, 4)
        # The older form acts in the middle of its nodes.
        older = ("*ELEMENT,TYPE=DCOUP3D,ELSET=E1\n99,999\n*DISTRIBUTING COUPLING,ELSET=E1\nLAST,1.\n")
        text = bar(nodes + older, "", "*CLOAD\n999,3,5.\n").replace("999,0.5,0.5,12.", "999,0.,0.,0.")
        row = self.solved(text)[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], -5.0, 4)
        code, said = self.imported(text)
        self.assertNotIn("left out:", said)
        self.assertIn("in Abaqus they act in the reference node (0, 0, 0)", said)
        with netCDF4.Dataset(work / "run" / "deck.e") as file:
            self.assertLess(numpy.abs(file["vals_nod_var1"][-1]).max(), 1e-8)
        code, said = self.imported(bar(kinematic.replace("1,3", "3,3"), "", ""))
        self.assertEqual(code, 0, said)
        self.assertIn("*KINEMATIC: of some components", said)

    def test_springs_of_reference_nodes(self) -> None:
        # A bar of stiffness 100 whose end is on a spring of 50 to the ground: it takes two thirds of a force.
        surface = "*SURFACE,NAME=END\n10, S2\n*COUPLING,CONSTRAINT NAME=C,REF NODE=999,SURFACE=END\n*KINEMATIC\n1,3\n"
        bar = self.bar("", "*CLOAD\n999,3,6.\n").replace(
            "*SURFACE,NAME=CUT\n5, S2\n*PRE-TENSION SECTION,SURFACE=CUT,NODE=999\n", surface).replace("1,2,3,4,41,42,43,44", "1,2,3,4").replace(
            "999,0,0,0", "998,0.5,0.5,15.\n999,0.5,0.5,12.").replace("TYPE=C3D8", "TYPE=C3D8I")
        held = "*BOUNDARY\n998,1,3\n"
        kinds = {"SPRING1": ("999", "3\n", ""), "SPRING2": ("999, 998", "3, 3\n", held), "SPRINGA": ("998, 999", "\n", held)}
        for kind, (nodes, components, more) in kinds.items():
            with self.subTest(kind):
                spring = f"*ELEMENT,TYPE={kind},ELSET=S1\n90, {nodes}\n*SPRING,ELSET=S1\n{components}50.\n"
                row = self.solved(bar.replace("*BOUNDARY\nENDS", spring + more + "*BOUNDARY\nENDS"))[-1]
                self.assertAlmostEqual(row["reaction_held_xyz_z"], -4.0, 4)
                code, said = self.imported(bar.replace("*BOUNDARY\nENDS", spring + more + "*BOUNDARY\nENDS"))
                self.assertNotIn("left out:", said)
        for spring, why in (("*ELEMENT,TYPE=SPRING2,ELSET=S1\n90, 999, 998\n*SPRING,ELSET=S1\n3, 3\n50.\n", "node 998 at its other end is"),
                            ("*ELEMENT,TYPE=SPRINGA,ELSET=S1\n90, 41, 998\n*SPRING,ELSET=S1\n\n50.\n" + held, "reference node"),
                            ("*ELEMENT,TYPE=SPRING1,ELSET=S1\n90, 999\n*SPRING,ELSET=S1,NONLINEAR\n3\n0.,0.\n1.,1.\n", "nonlinear"),
                            ("*ELEMENT,TYPE=SPRING1,ELSET=S1\n90, 999\n", "no *SPRING names a set that they are in")):
            with self.subTest(why):
                code, said = self.imported(bar.replace("*BOUNDARY\nENDS", spring + "*BOUNDARY\nENDS"))
                self.assertEqual(code, 0, said)
                self.assertIn("1 springs are left out: ", said)
                self.assertIn(why, said)

    def test_elements_that_calculix_makes_softer_are_told(self) -> None:
        wedges = PLAIN.replace("TYPE=C3D8,ELSET=CUBE\n1, 1,2,3,4,5,6,7,8", "TYPE=C3D6,ELSET=CUBE\n1, 1,2,3,5,6,7\n2, 1,3,4,5,7,8")
        code, said = self.imported(wedges)
        self.assertEqual(code, 0, said)
        self.assertIn("TYPE=C3D6: CalculiX integrates this wedge with 2 points", said)
        # Under a constant stress it makes no difference.
        self.assertAlmostEqual(self.solved(wedges)[-1]["reaction_held_xyz_z"], 10.0, 5)

    def test_rotation(self) -> None:
        # A cube of mass 2 whose centre is 0.5 above a horizontal axis through its foot.
        turn = "*DLOAD\nCUBE, CENTRIF, 9., 0., 0., 0., 0., 2., 0.\n"
        history = self.solved(CUBE + STEEL + HELD + STEP.format("0.25, 1.\n" + turn))
        for row in history:
            self.assertAlmostEqual(row["reaction_held_xyz_z"], -2.0 * 9.0 * row["time"] * 0.5, 4)
            self.assertAlmostEqual(row["reaction_held_xyz_x"], -2.0 * 9.0 * row["time"] * 0.5, 4)

    def test_temperatures(self) -> None:
        warm = "*INITIAL CONDITIONS,TYPE=TEMPERATURE\nALL, 20.\n"
        expansion = STEEL.replace("*DENSITY", "*EXPANSION\n1e-5\n*DENSITY")
        held = "*BOUNDARY\n1,1,3\n2,2,3\n3,3,3\n4,3,3\n5,3,3\n6,3,3\n7,3,3\n8,3,3\n"
        for initial, change in ((warm, 100.0), ("", 120.0)):
            text = CUBE + expansion + held + initial + STEP.format("*TEMPERATURE\nALL, 120.\n")
            row = self.solved(text)[-1]
            # Held between its ends: sigma = - E alpha dT, of which two of four nodes carry half.
            two = row["reaction_held_xyz_z"] + row["reaction_held_yz_z"]
            self.assertAlmostEqual(two, 0.5 * 1000.0 * 1e-5 * change, 5)
        code, said = self.imported(CUBE + expansion + held + STEP.format("*TEMPERATURE\n1, 120.\n"))
        self.assertEqual(code, 0, said)
        self.assertIn("*TEMPERATURE: of part", said)

    def test_orthotropic_in_turned_axes(self) -> None:
        text = PLAIN.replace("*ELASTIC\n1000., 0.\n", "*ELASTIC,TYPE=ENGINEERING CONSTANTS\n"
                             "1000., 2000., 4000., 0., 0., 0., 500., 500.,\n500.\n")
        text = text.replace("MATERIAL=STEEL\n*B", "MATERIAL=STEEL,ORIENTATION=OR\n*ORIENTATION,NAME=OR\n"
                            "0., 0., 1., 0., 1., 0.\n*B").replace("*DLOAD\nCUBE, P2, 10.\n", "*BOUNDARY\n5,3,3,0.01\n"
                            "6,3,3,0.01\n7,3,3,0.01\n8,3,3,0.01\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_moved_z_z"], 10.0, 4)

    def test_plane_with_thickness(self) -> None:
        text = ("*NODE\n1,0,0\n2,2,0\n3,2,1\n4,0,1\n*ELEMENT,TYPE=CPS4,ELSET=CUBE\n1, 1,2,3,4\n" + STEEL + "0.5\n"
                "*BOUNDARY\n1,1,2\n4,1,1\n" + STEP.format("*DLOAD\n1, P2, -30.\n"))
        row = self.solved(text)[-1]
        self.assertAlmostEqual(row["reaction_held_xy_x"] + row["reaction_held_x_x"], -30.0 * 0.5, 4)

    def test_pressure_inside_of_a_part_is_listed(self) -> None:
        text = self.bar("", "").replace("*SURFACE,NAME=CUT\n5, S2\n*PRE-TENSION SECTION,SURFACE=CUT,NODE=999\n", "")
        code, said = self.imported(text.replace("*STATIC\n", "*STATIC\n*DLOAD\n3, P2, 1.\n4, P3, 1.\n"))
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"deck.inp:\d+: \*DLOAD, pressure: 1 of its faces lie inside of a part")

    def test_force_inside_of_a_part(self) -> None:
        nodes = "".join(f"{1 + i + 3 * j + 9 * k}, {i}, {j}, {k}\n" for k in range(3) for j in range(3) for i in range(3))
        rows = "".join(f"{1 + i + 2 * j + 4 * k}, " + ", ".join(
            str(1 + i + x + 3 * (j + y) + 9 * (k + z)) for x, y, z in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1),
                                                                    (1, 0, 1), (1, 1, 1), (0, 1, 1))) + "\n"
            for k in range(2) for j in range(2) for i in range(2))
        text = (f"*NODE\n{nodes}*ELEMENT,TYPE=C3D8,ELSET=CUBE\n{rows}{STEEL}*NSET,NSET=BOTTOM,GENERATE\n1,9\n*BOUNDARY\n"
                "BOTTOM,1,3\n" + STEP.format("*CLOAD\n14,1,7.\n"))
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_x"], -7.0, 4)

    def test_axes_of_nodes(self) -> None:
        top = "*NSET,NSET=TOP\n5,6,7,8\n"
        # Axes along others: the first one is z.
        along = f"{top}*TRANSFORM,NSET=TOP\n0.,0.,1.,1.,0.,0.\n"
        row = self.solved(CUBE + STEEL + HELD + along + STEP.format("*BOUNDARY\nTOP,1,1,0.01\n"))[-1]
        self.assertAlmostEqual(row["reaction_moved_z_z"], 10.0, 4)
        row = self.solved(CUBE + STEEL + HELD + along + STEP.format("*CLOAD\nTOP,1,2.5\n"))[-1]
        self.assertAlmostEqual(row["u_loaded_z"], 0.01, 6)
        # The same cube turned by 30 degrees about x, pulled along its own z.
        cosine, sine = 3.0 ** 0.5 / 2.0, 0.5
        nodes = [line.split(",") for line in CUBE.splitlines()[1:9]]
        turned = CUBE
        for line, (node, x, y, z) in zip(CUBE.splitlines()[1:9], nodes):
            across, up = cosine * float(y) - sine * float(z), sine * float(y) + cosine * float(z)
            turned = turned.replace(line, f"{node},{x},{across:.12f},{up:.12f}")
        own = f"{top}*TRANSFORM,NSET=TOP,TYPE=R\n1.,0.,0.,0.,{cosine:.12f},{sine}\n"
        row = self.solved(turned + STEEL + HELD + own + STEP.format("*BOUNDARY\nTOP,3,3,0.01\n"))[-1]
        self.assertAlmostEqual(row["reaction_moved_3_3"], 10.0, 4)
        # In the plane with the third axis the other way.
        plane = "*NODE\n1,0,0\n2,2,0\n3,2,1\n4,0,1\n*ELEMENT,TYPE=CPE4,ELSET=CUBE\n1, 1,2,3,4\n" + STEEL + "*NSET,NSET=END\n2,3\n"
        held = "*BOUNDARY\n1,1,2\n4,1,2\n"
        for axes, at in (("1.,0.,0.,0.,-1.,0.", (1.0, -2.0)), ("0.,1.,0.,1.,0.,0.", (2.0, 1.0)), ("0.6,0.8,0.,0.8,-0.6,0.", (2.2, -0.4))):
            with self.subTest(axes):
                text = plane + f"*TRANSFORM,NSET=END\n{axes}\n" + held
                row = self.solved(text + STEP.format("*CLOAD\nEND,1,0.5\nEND,2,1.\n"))[-1]
                for axis, force in zip("xy", at):
                    self.assertAlmostEqual(row[f"reaction_held_xy_{axis}"], -force, 5)
                self.assertNotIn("left out:", self.imported(text + STEP.format("*CLOAD\nEND,1,0.5\n"))[1])
                self.solved(text + STEP.format("*BOUNDARY\nEND,1,1,0.01\nEND,2,2,0.02\n"))
                with netCDF4.Dataset(work / "run" / "deck.e") as file:
                    for component, moved in enumerate(at):
                        self.assertAlmostEqual(float(numpy.sum(file[f"vals_nod_var{component + 1}"][-1])), 2.0 * 0.01 * moved, 6)
        # About an axis: a small rotation moves the cube without strain; a tangential force at (1, 1).
        turn = "*NSET,NSET=RIM\n2,3,4,6,7,8\n*TRANSFORM,NSET=ALL,TYPE=C\n0.,0.,0.,0.,0.,1.\n"
        spin = "".join(f"{node},2,2,{0.001 * radius}\n" for node, radius in
                       ((1, 0), (2, 1), (3, 2 ** 0.5), (4, 1), (5, 0), (6, 1), (7, 2 ** 0.5), (8, 1)))
        text = CUBE + STEEL + turn + "*BOUNDARY\nALL,1,1\nALL,3,3\n1,2,2\n5,2,2\n"
        row = self.solved(text + STEP.format(f"*BOUNDARY\n{spin}"))[-1]
        self.assertTrue(all(abs(value) < 1e-6 for name, value in row.items() if name.startswith("reaction")), row)
        with netCDF4.Dataset(work / "run" / "deck.e") as file:
            names = [netCDF4.chartostring(name).item().strip("\0 ") for name in file["name_nod_var"][:]]
            at, moved = file["coordx"][:], file[f"vals_nod_var{names.index('disp_y') + 1}"][-1]
        self.assertLess(numpy.abs(moved - 0.001 * at).max(), 1e-8)
        row = self.solved(CUBE + STEEL + HELD + turn.replace("NSET=ALL", "NSET=RIM").replace("2,3,4,6,7,8", "7")
                          + STEP.format("*CLOAD\n7,2,2.\n"))[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_x"], 2.0 / 2.0 ** 0.5, 4)
        self.assertAlmostEqual(row["reaction_held_xyz_y"], -2.0 / 2.0 ** 0.5, 4)
        shutil.rmtree(work / "out")
        self.demand_refused(CUBE + STEEL + HELD + "*TRANSFORM,NSET=NONE\n1,0,0,0,1,0\n" + STEP.format(""), "no set \"NONE\"")
        self.demand_refused(CUBE + STEEL + HELD + "*TRANSFORM,NSET=ALL\n1,0,0,2,0,0\n" + STEP.format(""), "on one line with the")

    def test_equal_forces_on_a_grid_share_boundaries(self) -> None:
        # Nine equal forces are no constant traction; corners have other shares of the surface.
        nodes = "".join(f"{1 + i + 3 * j + 9 * k}, {i}, {j}, {k}\n" for k in range(2) for j in range(3) for i in range(3))
        rows = "".join(f"{1 + i + 2 * j}, " + ", ".join(
            str(1 + i + x + 3 * (j + y) + 9 * z) for x, y, z in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1),
                                                              (1, 0, 1), (1, 1, 1), (0, 1, 1))) + "\n"
            for j in range(2) for i in range(2))
        text = (f"*NODE\n{nodes}*ELEMENT,TYPE=C3D8,ELSET=CUBE\n{rows}{STEEL}*NSET,NSET=BOTTOM,GENERATE\n1,9\n*NSET,NSET=TOP,"
                "GENERATE\n10,18\n*BOUNDARY\nBOTTOM,1,3\n" + STEP.format("*CLOAD\nTOP,1,2.\n"))
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_x"], -18.0, 4)
        self.assertEqual((work / "out" / "deck.xml").read_text().count('"Nodal Force"'), 1)

    def test_equal_forces_per_area_on_faces_and_beside_them(self) -> None:
        # All four nodes of a face that is no constant traction, for their areas are those of three faces each: two times 2.5.
        corner = CUBE + STEEL + HELD + STEP.format("*CLOAD\n5,1,2.5\n6,1,2.5\n7,1,2.5\n8,1,2.5\n5,2,1.\n6,2,1.\n7,2,1.\n8,2,1.001\n")
        row = self.solved(corner)[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_x"], -10.0, 4)
        self.assertAlmostEqual(row["reaction_held_xyz_y"], -4.001, 4)
        # The middle of a larger face, which has a ring of others around it.
        nodes = "".join(f"{1 + i + 6 * j + 36 * k}, {i}, {j}, {k}\n" for k in range(2) for j in range(6) for i in range(6))
        rows = "".join(f"{1 + i + 5 * j}, " + ", ".join(
            str(1 + i + x + 6 * (j + y) + 36 * z) for x, y, z in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1),
                                                               (1, 0, 1), (1, 1, 1), (0, 1, 1))) + "\n"
            for j in range(5) for i in range(5))
        inner = "".join(f"{37 + i + 6 * j},1,2.\n" for j in range(1, 5) for i in range(1, 5))
        text = (f"*NODE\n{nodes}*ELEMENT,TYPE=C3D8,ELSET=CUBE\n{rows}{STEEL}*NSET,NSET=BOTTOM,GENERATE\n1,36\n*BOUNDARY\n"
                "BOTTOM,1,3\n" + STEP.format(f"*CLOAD\n{inner}"))
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_x"], -32.0, 4)

    def test_includes(self) -> None:
        (work / "part.inc").write_text(CUBE)
        self.assertEqual(self.imported("*INCLUDE,INPUT=part.inc\n" + PLAIN[len(CUBE):])[0], 0)
        shutil.rmtree(work / "out")
        (work / "one.inc").write_text("*HEADING\n*INCLUDE,INPUT=two.inc\n")
        (work / "two.inc").write_text("*NSET,NSET=A\n1\n*INCLUDE,INPUT=one.inc\n")
        self.demand_refused("*INCLUDE,INPUT=one.inc\n" + PLAIN, "two.inc:3", "includes itself", "one.inc")
        self.demand_refused("*INCLUDE,INPUT=none.inc\n" + PLAIN, "deck.inp:1", "none.inc")

    def test_nothing_is_dropped_in_silence(self) -> None:
        text = PLAIN.replace("*STEP", "*EQUATION\n2\n5,1,1.,6,1,-1.\n*ELEMENT,TYPE=B31\n9,1,2\n*STEP,NLGEOM").replace(
            "*DENSITY", "*PLASTIC\n1., 0.\n*DENSITY").replace("*END STEP", "*TEMPERATURE\nALL, 20.\n*END STEP")
        code, said = self.imported(text)
        self.assertEqual(code, 0)
        lines = text.splitlines()
        for keyword in ("*EQUATION", "*ELEMENT,TYPE=B31", "*STEP,NLGEOM", "*PLASTIC", "*TEMPERATURE"):
            line = lines.index(keyword) + 1
            self.assertRegex(said, rf"left out: \S*deck\.inp:{line}: \{keyword.split(',')[0]}")
        scene = (work / "out" / "deck.xml").read_text()
        self.assertIn("left out:", scene)

    def test_wrong_decks(self) -> None:
        element = "1, 1,2,3,4,5,6,7,8\n"
        for old, new, words in (
                (element, "1, 1,2,3,4,5,6,7\n", ("deck.inp:10", "no multiple of 9")),
                (element, "1, 1,2,3,4,5,6,7,99\n", ("deck.inp:10", "element 1", "node 99")),
                ("1000., 0.", "1000., none", ("deck.inp:14", "\"none\" is no number")),
                ("ELSET=CUBE,MATERIAL", "ELSET=CUBES,MATERIAL", ("deck.inp:17", "CUBES")),
                ("CUBE, P2, 10.", "CUBE, P7, 10.", ("deck.inp:26", "P7", "S1 to S6")),
                ("CUBE, P2, 10.", "TUBE, P2, 10.", ("deck.inp:26", "\"TUBE\"", "Did you mean \"CUBE\"? There are: CUBE.")),
                ("*END STEP", "", ("deck.inp:23", "truncated")),
                ("1,1,3\n", "NONE,1,3\n", ("deck.inp:19", "\"NONE\"", "There are: ALL.")),
                ("4,1,3\n", "4,1,3\n1,1,1,5.\n", ("deck.inp:23", "component 1", "deck.inp:19")),
                ("*MATERIAL,NAME=STEEL", "*MATERIAL,NAME=STEEL\n*MATERIAL,NAME=STEEL", ("deck.inp:13", "deck.inp:12")),
                ("*STEP", "*SURFACE,NAME=S\nCUBE,S1\n*SURFACE,NAME=S\nCUBE,S2\n*STEP", ("\"S\" is also at",)),
                ("*STEP", "*SURFACE,NAME=S\n77,S1\n*SURFACE,NAME=T\nCUBE,S2\n*TIE,NAME=G\nS,T\n*STEP",
                 ("deck.inp:23", "element 77 is nowhere")),
                ("*STEP", "*CONTACT PAIR,INTERACTION=NO\nA,B\n*STEP", ("deck.inp:23", "SURFACE INTERACTION \"NO\"")),
                ("2, 1, 0, 0\n", "2, 1, inf, 0\n", ("deck.inp:3", "\"inf\" is no number")),
                ("*NODE,NSET", "1, 2, 3\n*NODE,NSET", ("deck.inp:1", "above the first keyword"))):
            with self.subTest(new):
                self.assertIn(old, PLAIN)
                self.demand_refused(PLAIN.replace(old, new, 1), *words)
        self.demand_refused(PLAIN.replace("1,1,3\n", "NONE,1,3\n").replace("CUBE, P2", "CUBE, P9").replace("2,1,3\n", "SOME,1,3\n"),
                            "deck.inp:19", "\"NONE\"", "deck.inp:26", "P9")
        self.demand_refused("no deck at all", "deck.inp:1", "a deck begins with one")
        self.demand_refused("** a comment\n", "this is no deck")
        self.demand_refused("*HEADING\n\0\1\2", "no text")

    def test_mesh_file_takes_decks(self) -> None:
        self.assertEqual(self.imported(blocks)[0], 0)
        scene = work / "out" / "deck.xml"
        scene.write_text(scene.read_text().replace("deck.e", "../deck.inp"))
        result = subprocess.run([harmos, "check", str(scene)], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        (work / "deck.inp").write_text(PLAIN.replace("8, 0, 1, 1\n", ""))
        result = subprocess.run([harmos, "check", str(scene)], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"deck\.inp:9: element 1 of this card refers to node 8")

    def test_mutations_never_crash(self) -> None:
        for number in range(cases):
            text = bytearray(blocks.encode())
            for _ in range(chance.randint(1, 3)):
                at = chance.randrange(len(text))
                if chance.random() < 0.5:
                    text[at] = chance.choice(b",*=0123456789.\nabcSP -")
                else:
                    del text[at:at + chance.randint(1, 60)]
            with self.subTest(number=number):
                shutil.rmtree(work / "out", ignore_errors=True)
                code, said = self.imported(text.decode())
                self.assertIn(code, (0, 2), said)
                self.assertEqual((work / "out").exists(), code == 0)

    def test_large_decks_take_linear_time(self) -> None:
        seconds = []
        for count in (10_000, 40_000):
            nodes = "".join(f"{n + 1}, {n % 4 // 2 ^ n % 2}, {n % 4 // 2}, {n // 4}\n" for n in range(count))
            rows = "".join(f"{k + 1}, " + ", ".join(str(4 * k + n) for n in range(1, 9)) + "\n"
                           for k in range(count // 4 - 1))
            text = f"*NODE\n{nodes}*ELEMENT,TYPE=C3D8,ELSET=CUBE\n{rows}{STEEL}{HELD}" + STEP.format("")
            begin = os.times().user
            self.assertEqual(self.imported(text)[0], 0)
            seconds.append(os.times().user - begin)
        self.assertLess(seconds[1], 12.0 * max(seconds[0], 0.05))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
