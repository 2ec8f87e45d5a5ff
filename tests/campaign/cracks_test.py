"""Cohesive zones of the reference, and verdicts on scenes of them: what is wrong is called wrong."""
import unittest

import numpy as np

from .reference.glue import Glue, GluedProblem
from .scenes.glued import glued
from .scenes.mesh import Floats
from .trial.cracks import CrackTrial, Judgement, Verdict, crack_report, judge_states


def glue(exponential: bool) -> Glue:
    def one(value: float) -> Floats:
        return np.array([value])

    return Glue(one(1000.0), (one(20.0), one(30.0)), (one(0.5), one(0.9)), one(2.0), np.array([exponential]))


def solved(seed: int) -> Floats:
    """States [step, dof] of the reference alone."""
    scene = glued(seed)
    problem = GluedProblem(scene)
    state, old, states = np.zeros(problem.stiffness.shape[0]), np.zeros(len(problem.area)), []
    for step in range(scene.steps):
        found = problem.solve(state, old, step)
        assert found is not None
        state, old = found, problem.glue.damage(problem.jumps(found), old)
        states.append(state)
    return np.array(states)


class Glues(unittest.TestCase):
    def test_costs_its_energy(self) -> None:
        way = np.linspace(0, 1.5, 150001)
        for exponential in (False, True):
            law = glue(exponential)
            for shear, energy in ((0.0, 0.5), (1.0, 0.9), (0.5, 0.5 + 0.4 * 0.25)):
                direction = np.array([np.sqrt(1 - shear), np.sqrt(shear)])
                forces = np.array([law.traction(np.outer([s], direction), np.zeros(1))[0] @ direction
                                   for s in way[::100]])
                self.assertAlmostEqual(float(np.trapz(forces, way[::100])), energy, delta=2e-3)
            self.assertAlmostEqual(float(law.traction(np.array([[0.02, 0.0]]), np.zeros(1))[0, 0]), 20.0)
            self.assertAlmostEqual(float(law.traction(np.array([[-1.0, 0.03]]), np.zeros(1))[0, 1]), 30.0)

    def test_damage_never_falls(self) -> None:
        law = glue(False)
        worn = law.damage(np.array([[0.03, 0.0]]), np.zeros(1))
        self.assertGreater(worn[0], 0.3)
        self.assertEqual(law.damage(np.array([[0.01, 0.0]]), worn)[0], worn[0])

    def test_tangent_is_the_derivative(self) -> None:
        law = glue(True)
        jump, way = np.array([[0.03, 0.02]]), np.array([[0.3, -0.7]])
        slope = (law.traction(jump + 1e-5 * way, np.zeros(1)) - law.traction(jump - 1e-5 * way, np.zeros(1))) / 2e-5
        np.testing.assert_allclose(law.tangent(jump, np.zeros(1))[0] @ way[0], slope[0], rtol=1e-5)


class JudgingCracks(unittest.TestCase):
    def test_what_is_exact_is_right(self) -> None:
        states = solved(20)
        judgement = judge_states(glued(20), states)
        self.assertIs(judgement.verdict, Verdict.RIGHT)
        self.assertLess(judgement.lacking, 1e-7)

    def test_what_is_off_is_wrong(self) -> None:
        states = solved(20)
        for free in (False, True):  # what boundaries prescribe, and what they do not
            moved = 1.01 * states
            if free:
                problem = GluedProblem(glued(20))
                moved = np.array([problem.prescribe(state, step) for step, state in enumerate(moved)])
            self.assertIs(judge_states(glued(20), moved).verdict, Verdict.WRONG, free)

    def test_goals(self) -> None:
        for one in Verdict:
            text, met = crack_report([CrackTrial(i, 9, Judgement(Verdict.RIGHT)) for i in range(4)]
                                     + [CrackTrial(7, 9, Judgement(one))])
            self.assertEqual(met, one not in (Verdict.WRONG, Verdict.FAILED))
            self.assertEqual(f"glued 7: {one.value}" in text, one is not Verdict.RIGHT)
        self.assertFalse(crack_report([CrackTrial(i, 9, Judgement(Verdict.REFUSED)) for i in range(2)])[1])


if __name__ == "__main__":
    unittest.main()
