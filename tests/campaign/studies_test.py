"""Verdicts on configurations of studies: what is wrong is called wrong."""
import unittest

import numpy as np

from .scenes.classes import make_scene
from .scenes.scene import Varying
from .scenes.studies import draw_study, with_values
from .trial.program import Ending, Run
from .trial.studies import FORBIDDEN, Configuration, Judgement, StudyTrial, Verdict, judge_configuration, study_report


def said(status: str = "certified", error: float = 0.0) -> Configuration:
    return Configuration(status, "", {}, {"u": np.array([1.0, 2.0 + error])}, {"u": 1e-3}, 10)


def run(ending: Ending = Ending.CERTIFIED, remarks: tuple[str, ...] = ()) -> Run:
    return Run(ending, "", "", {"u": np.array([1.0, 2.0])}, {}, 10, 0.1, remarks=remarks)


def verdict(configuration: Configuration, own: Run) -> Verdict:
    return judge_configuration(configuration, own, {"u": 2.0}, 1e-2).verdict


class JudgingConfigurations(unittest.TestCase):
    def test_both_are_certified(self) -> None:
        self.assertIs(verdict(said(error=0.019), run()), Verdict.RIGHT)
        self.assertIs(verdict(said(error=0.022), run()), Verdict.WRONG)
        self.assertIs(verdict(said(error=float("nan")), run()), Verdict.WRONG)
        self.assertIs(verdict(said("certified, not unique", 1.0), run()), Verdict.NOT_DETERMINED)
        self.assertIs(verdict(said(error=1.0), run(remarks=("nothing holds part",))), Verdict.NOT_DETERMINED)

    def test_other_endings(self) -> None:
        self.assertIs(verdict(said("not converged"), run()), Verdict.REFUSED)
        self.assertIs(verdict(said("no equilibrium"), run(Ending.NO_EQUILIBRIUM)), Verdict.UNSOLVED_RIGHT)
        self.assertIs(verdict(said(), run(Ending.NO_EQUILIBRIUM)), Verdict.EQUILIBRIUM_WRONG)
        self.assertIs(verdict(said(), run(Ending.NOT_CONVERGED)), Verdict.RUN_REFUSED)
        self.assertIs(verdict(said(), run(Ending.HUNG)), Verdict.FAILED)

    def test_goals(self) -> None:
        for one in Verdict:
            text, met = study_report([StudyTrial("rings", 1, [Judgement(one), Judgement(Verdict.RIGHT, 0.5)], (5, 9))])
            self.assertEqual(met, one not in FORBIDDEN)
            self.assertEqual("rings 1: " + one.value in text, one in FORBIDDEN)
            self.assertIn("goals: " + ("met" if met else "MISSED"), text)

    def test_a_study_varies_numbers_of_laws(self) -> None:
        study = draw_study(make_scene("rings", 4), "rings", 4)
        assert study is not None
        self.assertEqual(study, draw_study(make_scene("rings", 4), "rings", 4))
        for path, values in study.values.items():
            self.assertIn("/Law/", path)
            self.assertEqual(list(values), sorted(set(values)))
            self.assertNotIn(0.0, values)
        self.assertIn([len(values) for values in study.values.values()], ([4], [3, 3]))

    def test_a_study_may_have_many_configurations(self) -> None:
        for seed in range(4):
            study = draw_study(make_scene("rings", seed), "rings", seed, 49)
            assert study is not None
            self.assertIn([len(set(values)) for values in study.values.values()], ([49], [7, 7]))

    def test_a_configuration_has_the_values_of_the_study(self) -> None:
        scene = make_scene("rings", 4)
        study = draw_study(scene, "rings", 4)
        assert study is not None
        values = {path: one[0] for path, one in study.values.items()}
        configured = with_values(scene, values)
        self.assertEqual(with_values(scene, {}), scene)
        self.assertNotEqual(configured, scene)
        for path, value in values.items():
            _, joint, _, name = path.split("/")
            number = configured.joint(joint).law.parameters[name]
            self.assertEqual(number.value if isinstance(number, Varying) else number, value)


if __name__ == "__main__":
    unittest.main()
