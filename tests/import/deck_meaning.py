#!/usr/bin/python3
"""Decks that mean something else than they seem to at first sight: closed forms, and what is told of the rest.

deck_meaning.py HARMOS WORK_DIR
"""
import math
import re
import shutil
import unittest

from deck_case import CUBE, HELD, PLAIN, STEEL, STEP, DeckCase, work

MATERIAL, SECTION = STEEL[:STEEL.index("*SOLID")], STEEL[STEEL.index("*SOLID"):]
STIFF_ALONG_Z = MATERIAL.replace("*ELASTIC\n1000., 0.", "*ELASTIC,TYPE=ENGINEERING CONSTANTS\n1000., 1000., 2000., 0., 0., 0., 400., 400.\n400.")
PRESS = STEP.format("*DLOAD\nCUBE, P2, 10.\n")
TOP = "*NSET,NSET=TOP\n5,6,7,8\n"


def upper(bottom: "list[float]") -> str:
    """A second cube above the first one; `bottom`: heights of its lower nodes."""
    nodes = "".join(f"{11 + i}, {x}, {y}, {z}\n" for i, (x, y, z) in enumerate(
        (*((x, y, z) for (x, y), z in zip(((0, 0), (1, 0), (1, 1), (0, 1)), bottom)), (0, 0, 2), (1, 0, 2), (1, 1, 2), (0, 1, 2))))
    return (f"*NODE\n{nodes}*ELEMENT,TYPE=C3D8,ELSET=UPPER\n2, 11,12,13,14,15,16,17,18\n*SOLID SECTION,ELSET=UPPER,MATERIAL=STEEL\n"
            "*SURFACE,NAME=M\nCUBE,S2\n*SURFACE,NAME=S\nUPPER,S1\n")


class Meaning(DeckCase):
    def demand_told(self, text: str, *patterns: str) -> str:
        """A scene, and a message for each pattern; the scene."""
        code, said = self.imported(text)
        self.assertEqual(code, 0, said)
        for pattern in patterns:
            self.assertRegex(said, pattern)
        return (work / "out" / "deck.xml").read_text()

    def demand_refused(self, text: "str | bytes", *words: str) -> None:
        shutil.rmtree(work / "out", ignore_errors=True)
        super().demand_refused(text, *words)

    def demand_axes(self, orientation: str, one: "list[float]", other: "list[float]") -> None:
        text = CUBE + STIFF_ALONG_Z + orientation + SECTION.replace("MATERIAL=", "ORIENTATION=O,MATERIAL=") + HELD + PRESS
        scene = self.demand_told(text)
        for name, wanted in (("Axis 1", one), ("Axis 2", other)):
            found = re.search(f'"{name}" type="Array\\(double\\)" value="{{(.*?)}}"', scene)
            self.assertIsNotNone(found, orientation)
            for value, component in zip(found[1].split(","), wanted):
                self.assertAlmostEqual(float(value), component, 12, orientation)

    def test_axes_of_orientations(self) -> None:
        half = math.sqrt(0.5)
        self.demand_axes("*ORIENTATION,NAME=O\n2., 0., 0., 1., 1., 0.\n", [1, 0, 0], [0, 1, 0])
        self.demand_axes("*ORIENTATION,NAME=O\n1., 0., 0., 0., 1., 0.\n3, 45.\n", [half, half, 0], [-half, half, 0])
        self.demand_axes("*ORIENTATION,NAME=O\n1., 0., 0., 0., 1., 0.\n1, 90.\n", [1, 0, 0], [0, 0, 1])
        self.demand_axes("*ORIENTATION,NAME=O\n2., 1., 0., 1., 2., 0., 1., 1., 0.\n", [1, 0, 0], [0, 1, 0])

    def test_what_a_file_or_a_rule_distributes_is_listed(self) -> None:
        axes = "*DISTRIBUTION,NAME=D\n,1.,0.,0.,0.,1.,0.\n*ORIENTATION,NAME=O\nD\n"
        elastic = "*ELASTIC,TYPE=ENGINEERING CONSTANTS\n1000.,1000.,1000.,0.,0.,0.,500.,500.\n500.\n"
        self.demand_told(CUBE + axes + STEEL.replace("*ELASTIC\n1000., 0.\n", elastic).replace("MATERIAL=STEEL\n", "MATERIAL=STEEL,ORIENTATION=O\n")
                         + HELD + STEP.format("*DLOAD\nCUBE,P2,1.\n"), "ORIENTATION: the axes of the distribution \"D\", which differ")
        self.demand_told(PLAIN.replace("*DENSITY", "*EXPANSION\n1e-5\n*DENSITY").replace(
            "*DLOAD", "*TEMPERATURE,LINTEMP\n0.,1.,0.,.1,300.,.5,650.\n*DLOAD"), "TEMPERATURE, LINTEMP: temperatures that stand elsewhere")

    def test_axes_that_are_not_there(self) -> None:
        section = SECTION.replace("MATERIAL=", "ORIENTATION=O,MATERIAL=")
        text = CUBE + STIFF_ALONG_Z + "{}" + section + HELD + PRESS
        self.demand_refused(text.format(""), "deck.inp:18", "no *ORIENTATION \"O\"")
        self.demand_refused(text.format("*ORIENTATION,NAME=O\n1., 0., 0., 2., 0., 0.\n"), "deck.inp:19", "one line")
        for how, lines in (("DEFINITION=NODES", "2, 4, 1"), ("SYSTEM=CYLINDRICAL", "0., 0., 0., 0., 0., 1.")):
            self.demand_told(text.format(f"*ORIENTATION,NAME=O,{how}\n{lines}\n"), f"deck.inp:18: \\*ORIENTATION, {how}: axes that")

    def test_axes_turn_with_instances(self) -> None:
        # Stiff along its z, one of two bricks lies on its side, pressed along its own x.
        own = "*ORIENTATION,NAME=O\n1., 0., 0., 0., 1., 0.\n" + SECTION.replace("MATERIAL=", "ORIENTATION=O,MATERIAL=")
        part = f"*PART,NAME=BRICK\n{CUBE}{own}*SURFACE,NAME=END\nCUBE,S2\n*NSET,NSET=FOOT\n1,2,3,4\n*END PART\n"
        lie = "*INSTANCE,NAME=LIE,PART=BRICK\n5., 0., 0.\n5., 0., 0., 5., 1., 0., 90.\n*END INSTANCE\n"
        text = (f"{part}*INSTANCE,NAME=STAND,PART=BRICK\n*END INSTANCE\n{lie}{STIFF_ALONG_Z}"
                "*BOUNDARY\nSTAND.FOOT,1,3\nLIE.FOOT,1,3\n" + STEP.format("*CLOAD\nSTAND.5,3,-1.\nSTAND.6,3,-1.\nSTAND.7,3,-1.\n"
                "STAND.8,3,-1.\nLIE.5,1,-1.\nLIE.6,1,-1.\nLIE.7,1,-1.\nLIE.8,1,-1.\n"))
        row = self.solved(text)[-1]
        moved = [value for name, value in row.items() if re.match("u_loaded.*_[xz]$", name)]
        self.assertEqual(len(moved), 2)
        for value in moved:
            self.assertAlmostEqual(value, -4.0 / 2000.0, 8)

    def test_parameters_that_nothing_reads(self) -> None:
        pair = "*SURFACE INTERACTION,NAME=I\n{}*CONTACT PAIR,INTERACTION=I\nS, M\n"
        two = CUBE + STEEL + upper([1, 1, 1, 1]) + pair + HELD + STEP.format("*DLOAD\nUPPER, P2, 1.\n")
        for said, told in (("*FRICTION,ROUGH\n", "FRICTION, ROUGH: surfaces that touch may slide"),
                           ("*FRICTION,TAUMAX=1.\n0.2,\n", "FRICTION, TAUMAX: the shear stress"),
                           ("*SURFACE BEHAVIOR,NO SEPARATION\n", "SURFACEBEHAVIOR, NOSEPARATION: .* may open"),
                           ("*FRICTION,STRANGE\n0.2,\n", "FRICTION, STRANGE: the scene is as it would be without it")):
            self.demand_told(two.format(said), f"deck.inp:\\d+: \\*{told}")
        self.demand_told(PLAIN.replace("*STATIC", "*STATIC,RIKS"), "STATIC, RIKS: the whole load")
        self.demand_told("*RESTART, READ\n" + PLAIN, "deck.inp:1: \\*RESTART, READ: the deck goes on")
        self.demand_told(PLAIN.replace("*DLOAD", "*DLOAD,LOAD CASE=2"), "DLOAD, LOADCASE")
        self.demand_told(PLAIN.replace("*DLOAD", "*DLOAD,OP=foo"), "deck.inp:\\d+: \\*DLOAD, OP=FOO: it is neither NEW nor MOD, and counts as MOD")
        self.assertNotIn("left out", self.imported(PLAIN.replace("*DLOAD", "*DLOAD,OP=Mod"))[1])
        self.assertNotIn("left out", self.imported(PLAIN.replace("*STEP", "*STEP, NAME=LOAD, NLGEOM=NO, INC=100"))[1])

    def test_types_of_elements_with_more_fields(self) -> None:
        self.demand_told(PLAIN.replace("TYPE=C3D8", "TYPE=C3D8T"), "deck.inp:\\d+: TYPE=C3D8T: C3D8 with displacements alone")

    def test_moduli_that_depend_on_temperature(self) -> None:
        self.demand_told(PLAIN.replace("1000., 0.", "1000., 0., 20.\n900., 0., 100."), "ELASTIC: moduli that depend on temperature")
        hot = STIFF_ALONG_Z.replace("400.\n400.", "400.\n400., 20.\n900., 900., 900., 0., 0., 0., 400., 400.\n400., 90.")
        self.demand_told(CUBE + hot + SECTION + HELD + PRESS, "ELASTIC: moduli that depend on temperature")

    def test_moduli_that_no_material_has(self) -> None:
        ratio = "Poisson's Ratio = {} is out of range: at least -0.999 and at most 0.4999999"
        for numbers, words in (("1000., .5", ratio.format("0.5")), ("1000., -1.", ratio.format("-1")),
                               ("0., .3", "Young's Modulus = 0 is out of range: above 0")):
            self.demand_refused(PLAIN.replace("1000., 0.", numbers), f"deck.inp:13: *ELASTIC: {words}")
        orthotropic = CUBE + STIFF_ALONG_Z + SECTION + HELD + PRESS
        self.demand_refused(orthotropic.replace("400., 400.", "-400., 400."), "deck.inp:13: *ELASTIC: Shear Modulus 12 = -400 is out of range: above 0")
        for ratios in ("1.1, 0., 0.", "0.7, 0.7, -0.7", "1., 0., 0."):
            self.demand_refused(orthotropic.replace(" 0., 0., 0.,", f" {ratios},"), "deck.inp:13: *ELASTIC: these Poisson's ratios leave no energy")
        self.demand_told(orthotropic.replace(" 0., 0., 0.,", " 0.9, 0., 0.,"))
        unused = "*MATERIAL,NAME=RUBBER\n*ELASTIC\n1., 0.5\n"
        self.demand_told(CUBE + unused + STEEL + HELD + PRESS)

    def test_weight_of_the_whole_model(self) -> None:
        text = CUBE + STEEL + HELD + STEP.format("*DLOAD\n, GRAV, 9.81, 0., 0., -1.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], 2.0 * 9.81, 4)

    def test_spherical_nodes(self) -> None:
        # Node 7 of the cube: radius sqrt 3, 45 degrees around, and up.
        up = math.degrees(math.asin(1.0 / math.sqrt(3.0)))
        text = PLAIN.replace("7, 1, 1, 1\n", "").replace("*ELEMENT", f"*NODE,NSET=ALL,SYSTEM=S\n7, {math.sqrt(3.0)!r}, 45., {up!r}\n*ELEMENT")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], 10.0, 4)
        self.demand_refused(PLAIN.replace("*NODE,", "*NODE,SYSTEM=Q,"), "deck.inp:1", "SYSTEM is R, C or S")

    def test_unions_of_surfaces(self) -> None:
        text = CUBE + STEEL + "*SURFACE,NAME=A\nCUBE,S2\n*SURFACE,NAME=B\nCUBE,S1\n*SURFACE,NAME=C,COMBINE=UNION\nA, B\n" + HELD
        scene = self.demand_told(text + STEP.format("*DSLOAD\nC, P, 3.\n"))
        self.assertIn("pressed", scene)
        row = self.solved(text.replace("A, B", "A,") + STEP.format("*DSLOAD\nC, P, 3.\n"))[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], 3.0, 4)
        self.demand_refused(text.replace("A, B", "A, Q") + PRESS, "deck.inp:23", "no surface \"Q\"")
        self.demand_told(text.replace("UNION", "CROP") + PRESS, "SURFACE, COMBINE=CROP: what refers")

    def test_contact_pairs_that_are_tied(self) -> None:
        pair = "*SURFACE INTERACTION,NAME=I\n*CONTACT PAIR,INTERACTION=I,TIED\nS, M\n"
        text = CUBE + STEEL + upper([1, 1, 1, 1]) + pair + HELD + STEP.format("*DLOAD\nUPPER, P2, -1.\n")
        self.assertAlmostEqual(self.solved(text)[-1]["reaction_held_xyz_z"], -1.0, 4)

    def test_ties_reach_as_far_as_they_say(self) -> None:
        pull = "".join(f"{node},3,0.25\n" for node in range(15, 19))
        two = CUBE + STEEL + "{}*TIE,NAME=T,POSITION TOLERANCE={}\nS, M\n" + HELD + STEP.format("*CLOAD\n" + pull)
        # Moved onto the other surface as without ADJUST=NO, which makes the upper cube one again; E = 1000, length 2.
        row = self.solved(two.format(upper([1, 1.4, 1.4, 1]), 0.5))[-1]
        self.assertAlmostEqual(row["u_loaded_z"], 2.0 / 1000.0, 6)
        self.demand_told(two.format(upper([1.3, 1.3, 1.3, 1.3]), 0.1), "1 of 1 faces of S lie beside M or farther from it than 0.1: they are not tied")
        row = self.solved(two.format(upper([1.3, 1.3, 1.3, 1.3]), "0.5,ADJUST=NO"))[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], -1.0, 4)

    def test_amplitudes_that_begin_late(self) -> None:
        text = CUBE + STEEL + HELD + "*AMPLITUDE,NAME=LATE\n0.5, 1., 1., 2.\n" + STEP.format("0.25, 1.\n*DLOAD,AMPLITUDE=LATE\nCUBE, P2, 8.\n")
        for row, force in zip(self.solved(text), (0.0, 8.0, 8.0, 12.0, 16.0)):
            self.assertAlmostEqual(row["reaction_held_xyz_z"], force, 3)
        total = "*AMPLITUDE,NAME=LONG,TIME=TOTAL TIME\n0., 0., 2., 1.\n"
        self.demand_told(CUBE + STEEL + HELD + total + STEP.format("*DLOAD,AMPLITUDE=LONG\nCUBE, P2, 8.\n") + STEP.format(""),
                         "DLOAD, AMPLITUDE=LONG: its total time goes on")
        self.demand_told(CUBE + STEEL + HELD + "*AMPLITUDE,NAME=A,VALUE=ABSOLUTE\n0., 0., 1., 1.\n"
                         + STEP.format("*DLOAD,AMPLITUDE=A\nCUBE, P2, 8.\n"), "AMPLITUDE A, VALUE=ABSOLUTE")

    def test_temperatures_that_begin_at_once_and_go_back(self) -> None:
        warm = CUBE + STEEL.replace("*DENSITY", "*EXPANSION\n1e-3\n*DENSITY") + "*INITIAL CONDITIONS,TYPE=TEMPERATURE\nALL, 20.\n"
        hold = HELD + "*BOUNDARY\n5,3\n6,3\n7,3\n8,3\n"
        at_once = "*AMPLITUDE,NAME=ONE\n0., 1., 1., 1.\n" + STEP.format("*TEMPERATURE,AMPLITUDE=ONE\nALL, 120.\n")
        # sigma = - E alpha (120 - 20), nu = 0.
        history = self.solved(warm + hold + at_once + STEP.format("*TEMPERATURE,OP=NEW\n"))
        self.assertAlmostEqual(history[1]["reaction_held_z_z"], -100.0, 3)
        self.assertAlmostEqual(history[2]["reaction_held_z_z"], 0.0, 3)

    def test_forces_in_axes_of_nodes_over_steps(self) -> None:
        axes = TOP + "*TRANSFORM,NSET=TOP,TYPE=R\n1., 1., 0., -1., 1., 0.\n"
        text = CUBE + STEEL + axes + HELD + STEP.format("*CLOAD\nTOP,1,1.\n") + STEP.format("*CLOAD\nTOP,2,1.\n")
        history, half = self.solved(text), math.sqrt(0.5)
        for row, x, y in zip(history[1:], (4.0 * half, 0.0), (4.0 * half, 8.0 * half)):
            self.assertAlmostEqual(row["reaction_held_xyz_x"], -x, 4)
            self.assertAlmostEqual(row["reaction_held_xyz_y"], -y, 4)

    def test_reference_nodes(self) -> None:
        face = "*NODE\n100, 0.5, 0.5, 2.\n*SURFACE,NAME=FACE\nCUBE,S2\n*COUPLING,REF NODE=100,SURFACE=FACE,CONSTRAINT NAME=C\n"
        again = STEP.format("*BOUNDARY,OP=NEW\n" + HELD.replace("*BOUNDARY\n", ""))
        self.demand_told(CUBE + STEEL + face + "*KINEMATIC\n1,3\n" + HELD + STEP.format("*BOUNDARY\n100,1,1,0.1\n") + again,
                         "OP=NEW: 1 nodes are released from here on")
        pull = STEP.format("*CLOAD\n100,3,1.\n")
        self.demand_told(CUBE + STEEL + face + "*DISTRIBUTING\n1,2\n" + HELD + pull, "DISTRIBUTING: of some components only")
        self.demand_told(CUBE + STEEL + face + "*DISTRIBUTING,WEIGHTING METHOD=LINEAR\n" + HELD + pull, "WEIGHTINGMETHOD=LINEAR: all of the surface")
        self.demand_told(CUBE + STEEL + face.replace("CONSTRAINT", "INFLUENCE RADIUS=1.,CONSTRAINT") + "*DISTRIBUTING\n" + HELD + pull,
                         "COUPLING, INFLUENCERADIUS: the whole surface")

    def test_sets_of_solids_and_shells(self) -> None:
        shell = "*NODE\n9, 2, 0, 0\n10, 2, 1, 0\n*ELEMENT,TYPE=S4,ELSET=SHELL\n2, 2,9,10,3\n*ELSET,ELSET=MIX\n1, 2\n"
        second = "*NODE\n19, 2, 0, 1\n20, 2, 1, 1\n*ELEMENT,TYPE=C3D8,ELSET=CUBE\n3, 2,9,10,3,6,19,20,7\n"
        scene = self.demand_told(CUBE + shell, "deck.inp:17: \\*ELSET MIX: 1 of its flat elements are sides of no solid")
        self.assertIn('ParameterList name="MIX"', scene)
        self.demand_told(CUBE + shell + second + "*ELSET,ELSET=HALF\n1,\n*ELSET,ELSET=ALL\n1, 3\n",
                         "deck.inp:\\d+: \\*ELSET ALL: 2 solids in it make no part of their own: they belong to ")

    def test_elements_are_named_as_the_deck_numbers_them(self) -> None:
        other = "*ELEMENT,TYPE=C3D8,ELSET=CUBE\n40, 5,6,7,8,5,6,7,8\n"
        self.demand_refused(CUBE + other + STEEL + HELD + PRESS, "is element 40, ", "deck.inp:12")
        self.demand_refused(CUBE + other.replace("5,6,7,8,5,6,7,8", "1,2,3,4,5,6,7,8") + STEEL + HELD + PRESS, "element 40, ", "deck.inp:12")

    def test_letters_with_accents(self) -> None:
        scene = self.demand_told(CUBE.replace("ELSET=CUBE", "ELSET=St\u00fctze gro\u00df"))
        self.assertIn('ParameterList name="Stutze_gross"', scene)

    def test_includes_are_looked_for_beside_the_deck(self) -> None:
        (work / "parts").mkdir()
        (work / "parts" / "all.inc").write_text("*INCLUDE,INPUT=parts/cube.inc\n*INCLUDE,INPUT=steel.inc\n")
        (work / "parts" / "cube.inc").write_text(CUBE)
        (work / "parts" / "steel.inc").write_text(STEEL)
        row = self.solved("*INCLUDE,INPUT=parts/all.inc\n" + HELD + PRESS)[-1]
        self.assertAlmostEqual(row["reaction_held_xyz_z"], 10.0, 4)


if __name__ == "__main__":
    unittest.main(argv=["deck_meaning"])
