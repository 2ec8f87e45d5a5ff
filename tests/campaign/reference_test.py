"""The reference against closed forms."""
import unittest

import numpy as np

from .reference.solver import Answer, Outcome, finer, follow, solve
from .scenes.classes import make_scene
from .scenes.lattice import Lattice
from .scenes.scene import Joint, Law, Part, Response, Scene, Varying

YOUNG, WIDTH, HEIGHT, THICKNESS = 1000.0, 2.0, 0.5, 0.25
AREA = WIDTH * THICKNESS


def pile(law: Law, loads: list[tuple[float, float]], more: list[tuple[str, int, Law]] | None = None,
         kinematics: str = "Plane Stress", weight: float = 0.0) -> Scene:
    """Two equal blocks on each other without Poisson's effect: the lower held below, the upper under tractions (x, y)
    from above; more: boundaries on the left (0) or right (1) face of a block."""
    lattice = Lattice([[0.0, 1.0, 2.0], [0.0, 0.5, 1.0]])
    lattice.fill("low", (0, 2), (0, 1))
    lattice.fill("high", (0, 2), (1, 2))
    mesh = lattice.build({"low": "QUAD4", "high": "TRI3"}, lambda x: x)
    joints = [Joint("joint", c.side1, c.side2, law) for c in lattice.contacts()]
    held = Law("Prescribed Displacement", {"X": 0.0, "Y": 0.0})
    joints.append(Joint("ground", lattice.outer("ground", "low", 1, 0), None, held))
    x, y = zip(*loads)
    traction = Law("Prescribed Traction", {"X": Varying(1.0, x), "Y": Varying(1.0, y)})
    joints.append(Joint("load", lattice.outer("load", "high", 1, 1), None, traction))
    for part, end, law_of in more or []:
        name = f"side_{part}_{end}"
        joints.append(Joint(name, lattice.outer(name, part, 0, end), None, law_of))
    force = (0.0, -weight) if weight else ()
    up, right = {"Direction": (0.0, 1.0)}, {"Direction": (1.0, 0.0)}
    responses = [Response("N", "Bolt Force", "joint"), Response("T", "Interface Force", "joint", right),
                 Response("R", "Interface Force", "ground", up), Response("v", "Mean Displacement", "load", up),
                 Response("w", "Mean Displacement", "load", right), Response("D", "Dissipation", "joint"),
                 Response("M", "Interface Moment", "ground", {"Centre": (1.0, 0.0)}),
                 Response("p", "Maximum", "joint", {}, "Contact Pressure")]
    return Scene(mesh, kinematics, THICKNESS, [Part("low", YOUNG, 0.0), Part("high", YOUNG, 0.0, force)], joints,
                 len(loads), 1e-3, responses)


def coulomb(friction: float, gap: float = 0.0) -> Law:
    return Law("Coulomb Friction", {"Friction Coefficient": friction, "Gap": gap})


class ClosedForms(unittest.TestCase):
    def close(self, answer: Answer, name: str, expected: list[float], digits: int = 10) -> None:
        self.assertIs(answer.outcome, Outcome.SOLVED)
        np.testing.assert_allclose(answer.values[name], expected, rtol=0, atol=10.0**-digits, err_msg=name)

    def test_pressed_through_contact(self) -> None:
        answer = solve(pile(coulomb(0.3), [(0.0, -10.0)]))
        self.close(answer, "N", [-10 * AREA])
        self.close(answer, "R", [10 * AREA])
        self.close(answer, "p", [10.0])
        self.close(answer, "v", [-10 * 2 * HEIGHT / YOUNG])
        self.assertEqual(len(answer.determined), 8)

    def test_spring_in_series(self) -> None:
        glue = Law("Linear Elastic", {"Normal Stiffness": 50.0, "Tangential Stiffness": 20.0})
        answer = solve(pile(glue, [(0, 7.0)]))
        self.close(answer, "v", [7 / 50 + 7 * 2 * HEIGHT / YOUNG])

    def test_gap_closes_and_preload_pulls(self) -> None:
        spring = Law("Elastic Foundation", {"Normal Stiffness": 1e-3, "Tangential Stiffness": 4.0})
        sides = [("high", 0, spring), ("high", 1, spring)]
        answer = solve(pile(Law("Unilateral Contact", {"Gap": 0.1}), [(0, -0.01), (0, -1.0)], sides))
        springs = 2 * 4.0 * HEIGHT * THICKNESS  # carry what closes the gap; next to nothing bends
        self.assertAlmostEqual(float(answer.values["N"][0]), 0.0, 12)
        self.assertAlmostEqual(float(answer.values["v"][0]), -0.01 * AREA / springs, 4)
        self.assertAlmostEqual(float(answer.values["N"][1]), 0.1 * springs - 1.0 * AREA, 3)
        both = solve(pile(Law("Preload Jump", {"Jump": 0.02}), [(0.0, 0.0)]))
        self.close(both, "v", [-0.02])
        self.close(both, "N", [0.0])

    def test_block_slides_and_returns(self) -> None:
        """Rigid sliding against a spring k: the jump follows (F - mu N) / k; back, it sticks for 2 mu N."""
        k, mu, pressure = 5.0, 0.2, 10.0
        spring = Law("Elastic Foundation", {"Normal Stiffness": k, "Tangential Stiffness": 0.0})
        loads = [(3.0, -pressure), (1.0, -pressure), (-1.5, -pressure)]
        scene = pile(coulomb(mu), loads, [("high", 1, spring)])
        scene.parts = [Part(part.name, 1e7, 0.0) for part in scene.parts]
        answer = solve(scene)
        bound, per_area = mu * pressure * AREA, k * HEIGHT * THICKNESS
        slid = (3.0 * AREA - bound) / per_area
        back = (-1.5 * AREA + bound) / per_area
        self.close(answer, "w", [slid, slid, back], 4)
        # Traction on the lower block: what the upper one drags it along with.
        self.close(answer, "T", [bound, 1.0 * AREA - per_area * slid, -bound], 4)
        self.close(answer, "D", [bound * slid, bound * slid, bound * (slid + slid - back)], 4)

    def test_weight_and_moment(self) -> None:
        answer = solve(pile(Law("Perfect"), [(2.0, 0.0)], weight=3.0, kinematics="Plane Strain"))
        self.close(answer, "R", [3.0 * WIDTH * HEIGHT * THICKNESS])
        self.close(answer, "M", [2.0 * AREA * 2 * HEIGHT])

    def test_beyond_friction_there_is_no_equilibrium(self) -> None:
        self.assertIs(solve(pile(coulomb(0.2), [(1.9, -10.0)])).outcome, Outcome.SOLVED)
        beyond = solve(pile(coulomb(0.2), [(1.0, -10.0), (2.1, -10.0)]))
        self.assertIs(beyond.outcome, Outcome.NO_EQUILIBRIUM)
        self.assertEqual(beyond.failed_step, 1)
        self.assertIs(solve(pile(coulomb(0.2), [(0.0, 1.0)])).outcome, Outcome.NO_EQUILIBRIUM)

    def test_friction_in_space_opposes_sliding(self) -> None:
        """A cube dragged askew over another one, held by springs k on top: it moves by (F - mu W) / k along F."""
        drag, weight, mu, k = np.array([0.3, 0.4]), 1.2, 0.25, 2.0
        for kind in ("HEX8", "TET4"):
            lattice = Lattice([[0.0, 1.0], [0.0, 1.0], [0.0, 1.0, 2.0]])
            lattice.fill("low", (0, 1), (0, 1), (0, 1))
            lattice.fill("high", (0, 1), (0, 1), (1, 2))
            mesh = lattice.build({"low": kind, "high": kind}, lambda x: x)
            joints = [Joint("joint", c.side1, c.side2, coulomb(mu)) for c in lattice.contacts()]
            held = Law("Prescribed Displacement", {"X": 0.0, "Y": 0.0, "Z": 0.0})
            joints.append(Joint("ground", lattice.outer("ground", "low", 2, 0), None, held))
            spring = Law("Elastic Foundation", {"Normal Stiffness": 0.0, "Tangential Stiffness": k})
            joints.append(Joint("top", lattice.outer("top", "high", 2, 1), None, spring))
            along, across = {"Direction": (0.6, 0.8, 0.0)}, {"Direction": (-0.8, 0.6, 0.0)}
            responses = [Response("w", "Mean Displacement", "top", along), Response("N", "Bolt Force", "joint"),
                         Response("T", "Interface Force", "joint", along),
                         Response("S", "Interface Force", "joint", across)]
            parts = [Part("low", 1e7, 0.0), Part("high", 1e7, 0.0, (*drag.tolist(), -weight))]
            answer = solve(Scene(mesh, "3-D", 1.0, parts, joints, 1, 1e-3, responses))
            self.close(answer, "N", [-weight], 9)
            self.close(answer, "T", [mu * weight], 6)
            self.close(answer, "S", [0.0], 6)
            self.close(answer, "w", [(0.5 - mu * weight) / k], 5)

    def test_what_is_free_to_move_is_not_determined(self) -> None:
        answer = solve(pile(Law("Unilateral Contact"), [(0.0, -10.0)]))
        self.assertNotIn("w", answer.determined)
        self.assertIn("v", answer.determined)
        self.assertIn("N", answer.determined)

    def test_shared_reaction_is_not_determined(self) -> None:
        """Both blocks are held across at one side, and at their corner by friction that does not slip, too."""
        symmetry = Law("Symmetry")
        answer = solve(pile(coulomb(0.5), [(1.0, -10.0)], [("high", 1, symmetry), ("low", 1, symmetry)]))
        self.assertNotIn("T", answer.determined)
        self.assertIn("N", answer.determined)

    def test_follows_to_the_equilibrium_nearby(self) -> None:
        answer = solve(pile(coulomb(0.3), [(1.0, -10.0)]))
        again = follow(answer, answer.histories[0].displacement * (1 + 1e-3))
        self.assertEqual(len(again.histories), len(answer.histories) + 1)
        np.testing.assert_allclose(again.values["v"], answer.values["v"], rtol=1e-9)

    def test_integrates_more_finely_where_joins_are_not_resolved(self) -> None:
        matching = solve(pile(coulomb(0.3), [(1.0, -10.0)]))
        self.assertIs(finer(matching.histories[0].scene, matching), matching)
        scene = make_scene("slabs", 3)
        coarse = solve(scene)
        fine = finer(scene, coarse)
        change = abs(fine.values["max_j0"] - coarse.values["max_j0"]).max() / coarse.sizes["max_j0"]
        self.assertGreater(change, 1e-8)
        self.assertLess(change, coarse.quadrature["max_j0"])
        self.assertLess(fine.quadrature["max_j0"], coarse.quadrature["max_j0"] / 10)


if __name__ == "__main__":
    unittest.main()
