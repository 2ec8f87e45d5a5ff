"""Verdicts and the table: what is wrong is called wrong."""
import dataclasses
import unittest

import numpy as np

from .reference.solver import Answer, Outcome
from .scenes.classes import make_scene
from .scenes.mesh import Floats
from .trial.campaign import Trial, report
from .trial.program import Ending, Run
from .trial.verdict import Judgement, Verdict, judge, judge_again

SCENE = dataclasses.replace(make_scene("inclines", 0), accuracy=1e-2)


def answer(outcome: Outcome = Outcome.SOLVED, spread: float = 0.0) -> Answer:
    values: dict[str, Floats] = {"u": np.array([1.0, 2.0]), "F": np.array([5.0, 5.0])}
    return Answer(outcome, [], values, {"u": 2.0, "F": 5.0}, {"u": 0.0, "F": spread}, None, [])


def run(ending: Ending = Ending.CERTIFIED, error: float = 0.0, reason: str = "") -> Run:
    values = {"u": np.array([1.0, 2.0 + error]), "F": np.array([5.0, 5.0])}
    return Run(ending, "", reason, values, {"u": 1e-3, "F": 1e-3}, 10, 0.1)


class Judging(unittest.TestCase):
    def expect(self, verdict: Verdict, said: Run, true: Answer) -> Judgement:
        judgement = judge(SCENE, said, true)
        self.assertIs(judgement.verdict, verdict)
        return judgement

    def test_certified(self) -> None:
        self.assertAlmostEqual(self.expect(Verdict.RIGHT, run(error=0.019), answer()).error, 0.0095)
        self.expect(Verdict.WRONG, run(error=0.021), answer())
        missing = run()
        missing.values["u"] = np.array([1.0])
        self.expect(Verdict.WRONG, missing, answer())
        self.expect(Verdict.WRONG, run(), Answer(Outcome.NO_EQUILIBRIUM, [], {}, {}, {}, 0, []))

    def test_only_what_is_determined_counts(self) -> None:
        wrong = run()
        wrong.values["F"] = np.array([7.0, 5.0])
        self.expect(Verdict.NOT_DETERMINED_UNSAID, wrong, answer(spread=0.1))
        around = (np.array([1.0, 1.0]), np.array([9.0, 9.0]))
        self.expect(Verdict.NOT_DETERMINED_UNSAID, dataclasses.replace(wrong, ranges={"u": around}), answer(spread=0.1))
        self.expect(Verdict.NOT_DETERMINED_SAID, dataclasses.replace(wrong, ranges={"F": around}), answer(spread=0.1))
        warned = dataclasses.replace(wrong, remarks=("nothing holds part",))
        self.expect(Verdict.NOT_DETERMINED_SAID, warned, answer(spread=0.1))
        # What is not determined by less than was asked for is right all the same.
        self.expect(Verdict.NOT_DETERMINED_SAID, wrong, answer(spread=1e-4))
        self.expect(Verdict.WRONG, wrong, answer(spread=1e-9))
        self.expect(Verdict.WRONG, run(error=0.1), answer(spread=0.1))

    def test_a_range_with_the_true_values_is_not_wrong(self) -> None:
        around, beside = ((np.array([1.0, least]), np.array([9.0, 9.0])) for least in (1.5, 2.05))
        said = dataclasses.replace(run(error=0.1), ranges={"u": around})
        self.expect(Verdict.NOT_DETERMINED_SAID, dataclasses.replace(said, remarks=("nothing holds part",)), answer(spread=0.1))
        self.expect(Verdict.NOT_DETERMINED_UNSAID, said, answer(spread=0.1))
        self.expect(Verdict.WRONG, dataclasses.replace(said, ranges={"u": beside}), answer(spread=0.1))
        self.expect(Verdict.WRONG, said, answer())

    def test_other_endings(self) -> None:
        self.expect(Verdict.REFUSED, run(Ending.NOT_CONVERGED), answer())
        self.expect(Verdict.NOT_DETERMINED_REFUSED, run(Ending.NOT_CONVERGED), answer(spread=0.1))
        self.expect(Verdict.EQUILIBRIUM_WRONG, run(Ending.NO_EQUILIBRIUM), answer())
        self.expect(Verdict.EQUILIBRIUM_RIGHT, run(Ending.NO_EQUILIBRIUM), answer(Outcome.NO_EQUILIBRIUM))
        self.expect(Verdict.EQUILIBRIUM_MISSED, run(Ending.NOT_CONVERGED), answer(Outcome.NO_EQUILIBRIUM))
        self.expect(Verdict.SLIDES, run(Ending.NOT_CONVERGED), answer(Outcome.SLIDES))
        self.expect(Verdict.UNKNOWN, run(), answer(Outcome.UNKNOWN))
        for ending, verdict in ((Ending.CRASHED, Verdict.CRASHED), (Ending.FAILED, Verdict.CRASHED),
                                (Ending.HUNG, Verdict.HUNG), (Ending.REFUSED_INPUT, Verdict.INPUT)):
            self.expect(verdict, run(ending), answer())

    def test_another_solution(self) -> None:
        wrong = run(error=0.1)
        first = judge(SCENE, wrong, answer())
        near = answer()
        near.values["u"] = np.array([1.0, 2.1])
        near.spread["u"] = 0.05
        self.assertIs(judge_again(SCENE, wrong, near, first).verdict, Verdict.OTHER)
        self.assertIs(judge_again(SCENE, wrong, answer(), first).verdict, Verdict.WRONG)

    def test_goals(self) -> None:
        def trials(*verdicts: Verdict) -> list[Trial]:
            return [Trial("rings", i, 30, 12, 0.1, 0.1, Judgement(v, 1e-3, 2e-3, "")) for i, v in enumerate(verdicts)]

        text, met = report(trials(Verdict.RIGHT, Verdict.EQUILIBRIUM_RIGHT))
        self.assertTrue(met)
        self.assertIn("| total | 2 | 1 | 0 |", text)
        self.assertIn("least 2.00, median 2.00", text)
        for verdict in (Verdict.WRONG, Verdict.REFUSED, Verdict.CRASHED, Verdict.HUNG, Verdict.EQUILIBRIUM_WRONG):
            text, met = report(trials(Verdict.RIGHT, verdict))
            self.assertFalse(met)
            self.assertIn("rings 1: " + verdict.value, text)
        self.assertTrue(report(trials(*[Verdict.EQUILIBRIUM_RIGHT] * 49, Verdict.EQUILIBRIUM_MISSED))[1])
        self.assertFalse(report(trials(*[Verdict.EQUILIBRIUM_RIGHT] * 48, Verdict.EQUILIBRIUM_MISSED))[1])


if __name__ == "__main__":
    unittest.main()
