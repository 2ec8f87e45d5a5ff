"""What one run of a trade may take: a multiple of its predicted time, and what is said of a run that takes more."""
import contextlib
import math
import pathlib
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from collections.abc import Callable
from unittest import mock

import numpy

from harmos.trade.budget import Allowance, Budget
from harmos.trade.document import Document
from harmos.trade.judging import Judge
from harmos.trade.knobs import Knob, Level, Role
from harmos.trade.ladder import Ladder, Rung, Settings
from harmos.trade.promises import keep
from harmos.trade.running import Outcome, Runner
from harmos.trade.tables import all_rungs

STUCK = "stopped after 50 s, predicted 10 s: more than 5 times as long"
SCENE = '<ParameterList name="Harmos"><ParameterList name="Mesh"/></ParameterList>'


class BudgetTest(unittest.TestCase):
    """A budget of 1000 s."""

    def setUp(self) -> None:
        """Nothing of it is spent."""
        self.budget = Budget(1000.0, 1e9)

    def test_a_run_may_take_a_multiple_of_its_prediction(self) -> None:
        """Predictions are right within a factor of 3: that must not end a run."""
        self.assertGreater(self.budget.allowance(20.0).seconds, 3 * 20.0)
        self.assertLess(self.budget.allowance(20.0).seconds, 10 * 20.0)

    def test_a_run_may_take_no_more_than_what_remains(self) -> None:
        """Less what is kept."""
        self.assertLess(self.budget.allowance(500.0).seconds, 1000.0)
        self.assertAlmostEqual(self.budget.allowance(500.0, 300.0).seconds, 700.0, delta=1.0)
        self.budget._begin -= 2000.0
        self.assertLessEqual(self.budget.allowance(500.0).seconds, 1.0)

    def test_short_predictions_end_nothing_early(self) -> None:
        """A hundredth of a second is no more than the start of a program."""
        self.assertGreater(self.budget.allowance(0.01).seconds, 5.0)

    def test_a_first_run_leaves_time_for_a_second_mesh(self) -> None:
        """Nothing predicts it, and without the second there is no reference."""
        self.assertLess(self.budget.allowance(None).seconds, 200.0)

    def test_the_words_say_what_was_expected(self) -> None:
        """And which of the limits it was."""
        self.assertEqual(self.budget.allowance(10.0).words(50.2), STUCK)
        self.assertEqual(self.budget.allowance(500.0).words(990.0),
                         "stopped after 990 s, predicted 500 s: no more of the budget is left")
        self.assertRegex(self.budget.allowance(None).words(120.0), "^stopped after 120 s, nothing predicted: ")


class RunnerTest(unittest.TestCase):
    """A program that never ends."""

    def test_it_is_ended_and_said_so(self) -> None:
        """Without an answer."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "scene.xml").write_text(SCENE)
            program = folder / "endless"
            program.write_text("#!/bin/sh\nexec sleep 60\n")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            begin = time.monotonic()
            outcome = Runner(str(program), Document(folder / "scene.xml"), folder / "work").run(
                (), Allowance(0.3, 0.05, "more than 6 times as long"), 1e9)
            self.assertLess(time.monotonic() - begin, 10.0)
        self.assertRegex(outcome.status, r"^stopped after 0\.\d+ s, predicted 0\.05 s: more than 6 times as long$")
        self.assertFalse(outcome.certified or outcome.values)


    def test_an_interruption_while_it_is_started_ends_it(self) -> None:
        """What the handler raised was dropped by what forks, and with one handler for all interruptions nothing ended the trade."""
        started: list[subprocess.Popen[bytes]] = []
        start = subprocess.Popen

        def interrupted(command: object, **options: object) -> subprocess.Popen[bytes]:
            started.append(start(["sleep", "60"]))
            with contextlib.suppress(SystemExit):
                signal.raise_signal(signal.SIGTERM)
            return started[0]

        def end(*_: object) -> None:
            sys.exit(130)

        handler = signal.signal(signal.SIGTERM, end)
        self.addCleanup(signal.signal, signal.SIGTERM, handler)
        with tempfile.TemporaryDirectory() as name, mock.patch("subprocess.Popen", interrupted):
            (pathlib.Path(name) / "scene.xml").write_text(SCENE)
            runner = Runner("harmos", Document(pathlib.Path(name) / "scene.xml"), pathlib.Path(name) / "work")
            with self.assertRaises(SystemExit):
                runner.run((), Allowance(0.3, None, "nothing"), 1e9)
        self.assertEqual(started[0].poll(), -signal.SIGKILL)
        self.assertIs(signal.getsignal(signal.SIGTERM), end)


class StuckTest(unittest.TestCase):
    """Meshes of two families, of which some runs do not end."""

    def ladder(self, is_stuck: Callable[[Settings], bool], seconds: float = 1000.0) -> tuple[Ladder, list[Settings]]:
        """Explored, and what was run; each run takes ten times as long as on the mesh before."""
        knobs = [Knob("mesh", Role.MESH, tuple(Level(f"mesh {n}", (), 2.0 ** -n) for n in range(4)), 0),
                 Knob("elements", Role.FAMILY, (Level("as given", ()), Level("quadratic", ())), 0),
                 Knob("accuracy", Role.SIDE, (Level("0.01", (), 1e-2), Level("0.001", (), 1e-3)), 1)]
        runs: list[Settings] = []
        budget = Budget(seconds, 1e9)

        def run(entries: object, allowance: Allowance, memory: float) -> Outcome:
            settings = next(one for one in wanted if one not in runs)
            runs.append(settings)
            if is_stuck(settings):
                budget._begin -= allowance.seconds
                return Outcome(allowance.words(allowance.seconds), stopped=True, cpu=allowance.seconds, wall=allowance.seconds)
            cost = 0.1 * 10 ** settings[0]
            budget._begin -= cost
            value = numpy.array([1 + 0.1 * 0.25 ** (settings[0] + settings[1])])
            return Outcome("certified", True, {"u": value}, {"u": 0.0}, {"u": 1.0}, cpu=cost, wall=cost, memory=1)

        wanted: list[Settings] = []
        ladder = Ladder(knobs, 2, mock.MagicMock(run=run), budget, lambda rung: None)
        measure = ladder.measure

        def noted(settings: Settings, purpose: str) -> Rung:
            wanted.append(settings)
            return measure(settings, purpose)

        with mock.patch.object(ladder, "measure", noted):
            ladder.explore(1e-6, lambda: False, lambda family: False)
        return ladder, runs

    def test_the_ladder_goes_on_along_other_directions(self) -> None:
        """The third mesh as given does not end: the quadratic family and the accuracies are measured all the same."""
        ladder, runs = self.ladder(lambda settings: settings[:2] == (2, 0))
        stuck = ladder.rungs[(2, 0, 1)]
        self.assertRegex(stuck.outcome.status, "^stopped after .* predicted .*: more than")
        self.assertLess(stuck.outcome.wall, 100.0)
        self.assertIn((3, 1, 1), ladder.rungs)
        self.assertIn((1, 0, 0), ladder.rungs)
        self.assertGreater(runs.index((3, 1, 1)), runs.index((2, 0, 1)))

    def test_the_ladder_leaves_time_to_run_what_it_recommends(self) -> None:
        """Even where its last run takes far longer than predicted."""
        ladder, _ = self.ladder(lambda settings: settings[0] == 3, 200.0)
        self.assertGreater(ladder.budget.left(), 0.1 * 200.0)

    def test_the_last_mesh_is_tried_without_a_margin(self) -> None:
        """Nothing else fits, and what it may take leaves time for promises: a lap joint had ended after 34 of 600 s."""
        ladder, _ = self.ladder(lambda settings: False, 24.0)
        self.assertIn((2, 0, 1), ladder.rungs)

    def test_a_first_run_that_does_not_end_is_tried_less_accurately(self) -> None:
        """Then on other meshes."""
        ladder, _ = self.ladder(lambda settings: settings == (0, 0, 1))
        self.assertTrue(ladder.rungs[(0, 0, 0)].outcome.certified)

    def test_a_trial_of_a_promise_that_does_not_end_is_shown(self) -> None:
        """It is the reason that there are no settings, and one of the rungs."""
        ladder, _ = self.ladder(lambda settings: False)
        runner, document = mock.MagicMock(), mock.MagicMock()
        runner.run_file.side_effect = lambda path, allowance, memory: Outcome(allowance.words(50.0))
        promise = keep(0.02, ladder, Judge(ladder), runner, document, pathlib.Path("out"), pathlib.Path("work"))
        self.assertIsNone(promise.rung)
        self.assertIn("stopped after 50 s", promise.reason)
        self.assertNotIn("inf", promise.reason)
        self.assertTrue(any("stopped" in rung.outcome.status for rung in all_rungs(ladder)))
        self.assertFalse(any(math.isinf(rung.predicted) for rung in ladder.fresh.values()))


if __name__ == "__main__":
    unittest.main()
