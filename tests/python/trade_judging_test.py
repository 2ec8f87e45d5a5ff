"""References of trades: ladders of levels, what does not carry over, errors of a design."""
import math
import pathlib
import unittest
from collections.abc import Mapping
from dataclasses import replace
from typing import cast
from unittest import mock

import numpy
from matplotlib.figure import Figure

from harmos.report.writing import Pictures
from harmos.trade.budget import Budget
from harmos.trade.judging import Judge
from harmos.trade.knobs import Knob, Level, Role
from harmos.trade.ladder import Ladder, Rung, Settings
from harmos.trade.outcome import read_outcome
from harmos.trade.page import pareto_section
from harmos.trade.promises import keep
from harmos.trade.running import Outcome
from harmos.trade.tables import pareto


def knob(name: str, role: Role, sizes: list[float], given: int = 0) -> Knob:
    """With levels of these sizes."""
    return Knob(name, role, tuple(Level(f"{name} {size:g}", (), size) for size in sizes), given)


def answer(value: float, design: float = 0.0, certified: bool = True) -> Outcome:
    """A run with one response of size 1."""
    status = "certified" if certified else "stagnation"
    return Outcome(status, certified, {"u": numpy.array([value])}, {"u": 0.0}, {"u": abs(value)},
                   design={"u": design} if design else {}, cpu=1.0, wall=1.0)


class LadderTest(unittest.TestCase):
    """Three meshes with four counts of increments, and what is known from them."""

    def ladder(self, outcomes: Mapping[tuple[int, int, int, int], Outcome], meshes: int = 3) -> Ladder:
        """With these outcomes; settings are levels of the mesh, the elements, the time steps and the accuracy."""
        knobs = [knob("mesh", Role.MESH, [2.0 ** -n for n in range(meshes)]), knob("elements", Role.FAMILY, [1.0, 1.0]),
                 knob("time steps", Role.SIDE, [1.0, 0.5, 0.25, 0.125]), knob("accuracy", Role.SIDE, [1e-3])]
        ladder = Ladder(knobs, 2, mock.MagicMock(), Budget(1e3, 1e9), lambda rung: None)
        ladder.rungs = {settings: Rung(settings, outcome, math.nan, "ladder") for settings, outcome in outcomes.items()}
        return ladder

    def wanted(self, steps: list[float]) -> set[Settings]:
        """What is measured next, after so many levels of time steps with these values."""
        ladder = self.ladder({(0, 0, level, 0): answer(value) for level, value in enumerate(steps)})
        return set(ladder._next_sides())

    def test_one_finer_count_of_increments_that_changes_nothing_does_not_tell_that_none_does(self) -> None:
        """Both may miss the same peak; the third has seen it."""
        self.assertEqual(self.wanted([1.0, 1.0]), {(0, 0, 2, 0)})
        self.assertEqual(self.wanted([1.0, 1.0, 1.0]), set())
        self.assertEqual(self.wanted([1.0, 1.0, 3.0]), {(0, 0, 3, 0)})

    def test_what_steps_do_on_a_mesh_that_is_far_off_is_doubted_on_fine_ones(self) -> None:
        """Meshes go from 1 to 4 and on; on the first, steps add 0.5."""
        def doubt(finer: float) -> float:
            outcomes = {(n, 0, 0, 0): answer(value) for n, value in enumerate((1.0, 3.0, 4.0))}
            outcomes |= {(0, 0, level, 0): answer(finer) for level in (1, 2)}
            return float(Judge(self.ladder(outcomes)).references["u"].uncertainty[0])

        # The limit is 5, from which the first mesh is off by four fifths; the levels of steps themselves leave 0.5 open.
        self.assertAlmostEqual(doubt(1.5) - doubt(1.0), 0.5 + 0.8 * 0.5, places=9)

    def test_errors_are_relative_to_what_the_response_goes_to_with_its_load_steps(self) -> None:
        """Two increments of a cycle end where nothing is left; a percentage of that was printed beside what more of them had shown."""
        outcomes = {(n, 0, 0, 0): answer(1e-6) for n in range(3)} | {(0, 0, n, 0): answer(1 - 0.1 * 4.0 ** -n) for n in (1, 2, 3)}
        reference = Judge(self.ladder(outcomes)).references["u"]
        self.assertGreaterEqual(reference.size, abs(reference.largest()))
        self.assertEqual(reference.cause, "time steps")

    def test_an_error_of_the_design_counts_in_the_reference(self) -> None:
        """Finer meshes do not show it."""
        def doubt(design: float) -> float:
            outcomes = {(n, 0, 0, 0): answer(3 + 2 * 4.0 ** -n, design) for n in range(3)}
            return float(Judge(self.ladder(outcomes | {(0, 0, 1, 0): answer(5.0)})).references["u"].uncertainty[0])

        self.assertAlmostEqual(doubt(0.25) - doubt(0.0), 0.25)

    def test_what_finer_meshes_of_another_family_contradict_is_not_known(self) -> None:
        """A stress at a corner: three meshes seemed to converge, on finer ones it grows, and growing counted as knowing nothing."""
        coarse = {(n, 0, 0, 0): answer(3 + 2 * 4.0 ** -n) for n in range(3)}
        growing = {(n, 1, 0, 0): answer(value) for n, value in enumerate((2.9, 2.99, 3.01, 3.5))}
        growing[(3, 1, 0, 0)].cpu = 2.0
        judge = Judge(self.ladder(coarse | growing | {(0, 0, 1, 0): answer(5.0)}, 4))
        reference = judge.references["u"]
        self.assertAlmostEqual(reference.values[0], 3.0)
        self.assertGreaterEqual(reference.uncertainty[0], 0.5)
        self.assertRegex(reference.space.word, "^Richardson, order 2.0; others differ$")
        self.assertFalse(judge.is_beaten((0, 1, 0, 0)))
        reference.is_disputed = False
        self.assertTrue(judge.is_beaten((0, 1, 0, 0)))

    def test_an_adaptive_collocation_states_the_error_of_its_moments(self) -> None:
        """Other expansions are refined by a knob of their own."""
        for kind, expected in (("Adaptive Collocation", {"u, mean": 0.1, "u, standard deviation": 0.2}), ("Collocation", {})):
            document, study = mock.MagicMock(), mock.MagicMock(state="complete", mesh_changes={})
            each = mock.MagicMock(mean=1.0, standard_deviation=0.5, mean_error=0.1, standard_deviation_error=0.2, iteration_error=0.0)
            study.statistics = mock.MagicMock(is_sample=False, responses={"u": each})
            with mock.patch("harmos.trade.outcome.read_study", return_value=study), mock.patch(
                    "harmos.trade.outcome.value_of", return_value=kind):
                self.assertEqual(read_outcome(document, pathlib.Path("x"))[-1], expected)

    def test_a_deviation_that_may_be_zero_counts_relative_to_its_mean(self) -> None:
        """Whatever the iteration leaves of it, settings keep their targets."""
        for deviation, size in ((0.0, 7.0), (1e-5, 7.0), (0.5, 0.5)):
            study = mock.MagicMock(state="complete", mesh_changes={})
            each = mock.MagicMock(mean=-7.0, standard_deviation=deviation, iteration_error=1e-4)
            study.statistics = mock.MagicMock(is_sample=False, responses={"u": each})
            with mock.patch("harmos.trade.outcome.read_study", return_value=study), mock.patch(
                    "harmos.trade.outcome.value_of", return_value="Chaos"):
                self.assertEqual(read_outcome(mock.MagicMock(), pathlib.Path("x"))[4], {"u, mean": 7.0, "u, standard deviation": size})

    def test_a_zero_of_one_mesh_is_not_known(self) -> None:
        """A second one tells that it is."""
        self.assertEqual(Judge(self.ladder({(0, 0, 0, 0): answer(0.0)})).references["u"].doubt(), math.inf)
        zeros = {(mesh, 0, 0, 0): answer(0.0) for mesh in (0, 1)} | {(0, 0, 1, 0): answer(0.0)}
        self.assertEqual(Judge(self.ladder(zeros)).references["u"].doubt(), 0.0)

    def test_of_one_mesh_no_error_is_said(self) -> None:
        """Its distance from itself is none; there is nothing to recommend, and the reason is that a second one is missing."""
        ladder = self.ladder({(0, 0, 0, 0): answer(1.0), (0, 0, 1, 0): answer(1.1)})
        judge = Judge(ladder)
        rungs = list(ladder.rungs.values())
        self.assertTrue(all(math.isinf(judge.worst(rung)) for rung in rungs))
        self.assertEqual(pareto(rungs, judge, "cpu"), [])
        promise = keep(0.01, ladder, judge, mock.MagicMock(), mock.MagicMock(), pathlib.Path("x"), pathlib.Path("x"))
        self.assertRegex(promise.reason, r"^one mesh alone tells no error, and the next one may take 4 s: .* about 6 s$")

    def test_the_second_mesh_comes_before_everything_else(self) -> None:
        """Two steps, an accuracy and all else were measured first, and left no time for it: nothing could be said."""
        ladder = self.ladder({(0, 0, 0, 0): answer(1.0)})
        self.assertEqual(ladder.second_mesh(), (1, 0, 0, 0))
        for second in (answer(1.1), answer(1.1, certified=False)):
            self.assertIsNone(self.ladder({(0, 0, 0, 0): answer(1.0), (1, 0, 0, 0): second}).second_mesh())

    def test_the_reason_names_the_response_that_is_not_known(self) -> None:
        """So that others can be asked for alone."""
        ladder = self.ladder({(n, 0, 0, 0): answer(value) for n, value in enumerate((1.0, 2.0))} | {(0, 0, 1, 0): answer(1.0)})
        promise = keep(0.01, ladder, Judge(ladder), mock.MagicMock(), mock.MagicMock(), pathlib.Path("x"), pathlib.Path("x"))
        self.assertRegex(promise.reason, "^the reference of u itself is known to [0-9]+ % only$")

    def test_what_the_budget_has_no_time_for_is_named(self) -> None:
        """A third mesh, which would tell how far the reference is off."""
        ladder = self.ladder({(n, 0, 0, 0): answer(value) for n, value in enumerate((1.0, 2.0))} | {(0, 0, 1, 0): answer(1.0)})
        ladder.unaffordable = (2, 0, 0, 0)
        promise = keep(0.01, ladder, Judge(ladder), mock.MagicMock(), mock.MagicMock(), pathlib.Path("x"), pathlib.Path("x"))
        self.assertRegex(promise.reason,
                         "^the reference of u itself is known to [0-9]+ % only; the next run, mesh .*, may take [0-9]+ s: "
                         "that takes a budget of about [0-9]+ s$")

    def test_a_budget_that_is_named_is_more_than_the_one_that_has_not_done(self) -> None:
        """About 3 s were said to be needed of 3 s."""
        ladder = self.ladder({(n, 0, 0, 0): answer(value) for n, value in enumerate((1.0, 2.0))} | {(0, 0, 1, 0): answer(1.0)})
        ladder.budget.seconds, ladder.unaffordable = 3.0, (2, 0, 0, 0)
        needed = ladder.predicted((2, 0, 0, 0), "wall") or 0.0
        ladder.budget._begin -= 0.7 * 3.0 - needed
        folder = pathlib.Path("x")
        promise = keep(0.01, ladder, Judge(ladder), mock.MagicMock(), mock.MagicMock(), folder, folder)
        self.assertRegex(promise.reason, "about 4 s$")

    def test_load_steps_at_their_last_level_are_said_to_be_what_is_not_known(self) -> None:
        """A finer mesh was advised, which does not help."""
        def reason(levels: int) -> str:
            outcomes = {(n, 0, 0, 0): answer(3 + 1e-3 * 4.0 ** -n) for n in range(3)}
            outcomes |= {(0, 0, level, 0): answer(3 + 0.2 * level) for level in range(1, levels)}
            ladder = self.ladder(outcomes, 4)
            ladder.unaffordable = (3, 0, 0, 0)
            folder = pathlib.Path("x")
            return keep(0.01, ladder, Judge(ladder), mock.MagicMock(), mock.MagicMock(), folder, folder).reason

        self.assertRegex(reason(4), "only, most of it because of time steps, of which time steps 0.125 is the finest level: "
                                    "the input has to have a finer one$")
        self.assertRegex(reason(3), "only, most of it because of time steps; the next run")

    def test_load_steps_at_their_last_level_are_said_to_be_what_keeps_settings_off(self) -> None:
        """The limit is known to less than the target, but no count of increments comes near it: a finer mesh was advised."""
        def ladder(levels: int) -> Ladder:
            outcomes = {(n, 0, 0, 0): answer(3.0) for n in range(3)}
            outcomes |= {(0, 0, level, 0): answer(3 + 0.2 * (1 - 2.0 ** -level)) for level in range(1, levels)}
            result = self.ladder(outcomes, 4)
            result.unaffordable = (3, 0, 0, 0)
            return result

        def reason(levels: int) -> str:
            of, folder = ladder(levels), pathlib.Path("x")
            return keep(0.007, of, Judge(of), mock.MagicMock(), mock.MagicMock(), folder, folder).reason

        self.assertRegex(reason(4), "^no settings that were measured come nearer than [0-9.]+ %, most of it because of time steps, "
                                    "of which time steps 0.125 is the finest level: the input has to have a finer one$")
        self.assertRegex(keep(0.02, ladder(3), Judge(ladder(3)), mock.MagicMock(), mock.MagicMock(), pathlib.Path("x"),
                              pathlib.Path("x")).reason, "most of it because of time steps; the next run, .* time steps 0.125")
        self.assertTrue(Judge(ladder(4)).is_out_of_reach(0.007))
        self.assertFalse(Judge(ladder(4)).is_out_of_reach(0.02))
        self.assertFalse(Judge(ladder(3)).is_out_of_reach(0.007))

    def test_a_scene_without_equilibrium_ends_the_ladder_with_the_reason(self) -> None:
        """On the mesh as given: all finer ones were asked until the budget had gone, and the reason was that it had."""
        knobs = [knob("mesh", Role.MESH, [4.0, 2.0, 1.0, 0.5, 0.25], given=2), knob("accuracy", Role.SIDE, [1e-2, 1e-3], given=1)]
        runner = mock.MagicMock()
        runner.run.return_value = Outcome("no equilibrium", values={"u": numpy.array([1.0])}, sizes={"u": 1.0}, cpu=0.1, wall=0.1,
                                          no_equilibrium="nothing resists part \"a\"")
        ladder = Ladder(knobs, 3, runner, Budget(1e3, math.inf), lambda _: None)
        ladder.explore(1e-3, lambda: False, lambda _: False)
        self.assertEqual(list(ladder.rungs), [(0, 1), (2, 1)])
        folder = pathlib.Path("x")
        promise = keep(0.01, ladder, Judge(ladder), mock.MagicMock(), mock.MagicMock(), folder, folder)
        self.assertEqual(promise.reason, "no equilibrium: nothing resists part \"a\"")

    def test_a_ladder_knows_what_it_has_no_time_for(self) -> None:
        """Neither more meshes nor more time are left out in silence."""
        knobs = [knob("mesh", Role.MESH, [1.0, 0.5, 0.25]), knob("accuracy", Role.SIDE, [1e-3])]
        runner = mock.MagicMock()
        runner.run.return_value = replace(answer(1.0), wall=40.0, cpu=40.0, memory=1e6)
        budget = mock.MagicMock(seconds=100.0, memory=math.inf)
        budget.left.side_effect = lambda: 100.0 - 20.0 * runner.run.call_count
        ladder = Ladder(knobs, 3, runner, budget, lambda _: None)
        ladder.explore(0.01, lambda: False, lambda _: False)
        self.assertIsNotNone(ladder.unaffordable)

    def test_a_next_mesh_is_predicted_to_grow_with_the_dimension(self) -> None:
        """Three meshes that cost little more than the start of the program tell nothing else."""
        ladder = self.ladder({(n, 0, 0, 0): replace(answer(1.0), cpu=cost) for n, cost in enumerate((0.2, 0.25, 0.4))}, 4)
        predicted = ladder.predicted((3, 0, 0, 0), "cpu")
        assert predicted is not None
        self.assertAlmostEqual(predicted, 0.4 * 2 ** 2)

    def test_a_power_of_costs_that_grows_goes_on_to_grow(self) -> None:
        """As factors take over: 18 s after 2.4 and 0.5 s became more than 250 where 90 had been predicted."""
        ladder = self.ladder({(n, 0, 0, 0): replace(answer(1.0), cpu=cost) for n, cost in enumerate((0.49, 2.35, 18.0))}, 4)
        ladder.dimension = 3
        predicted = ladder.predicted((3, 0, 0, 0), "cpu")
        assert predicted is not None
        self.assertTrue(200 < predicted < 300, predicted)

    def test_choices_leave_what_is_kept(self) -> None:
        """They had been begun with a second left for each, and stopped."""
        knobs = [knob("mesh", Role.MESH, [1.0]), knob("pieces", Role.CHOICE, [1.0, 1.0]), knob("accuracy", Role.SIDE, [1e-3])]
        runner = mock.MagicMock()
        runner.run.return_value = answer(1.0)
        for spent, runs in ((0.0, 1), (90.0, 0)):
            ladder = Ladder(knobs, 2, runner, Budget(100.0, 1e9), lambda rung: None)
            ladder.rungs = {(0, 0, 0): Rung((0, 0, 0), answer(1.0), math.nan, "ladder")}
            ladder.budget._begin -= spent
            runner.run.reset_mock()
            ladder._measure_choices()
            self.assertEqual(runner.run.call_count, runs)

    def test_an_accuracy_is_tightened_while_the_run_states_a_larger_error(self) -> None:
        """As an expansion does of deviations that are small beside the mean."""
        errors = (0.2, 0.02, 0.001)
        accuracies = Knob("accuracy", Role.SIDE, tuple(Level("", (), size) for size in (1e-2, 1e-3, 1e-4)), 0)
        runner = mock.MagicMock()
        runner.run.side_effect = [replace(answer(1.0), estimates={"u": error}) for error in errors]
        ladder = Ladder([knob("mesh", Role.MESH, [1.0]), accuracies], 2, runner, Budget(1e3, 1e9), lambda rung: None)
        ladder._choose_accuracy(0.01)
        self.assertEqual(ladder.accuracy, 2)

    def test_an_accuracy_leaves_room_for_other_errors_where_the_run_states_none(self) -> None:
        """As asked for it counts three times in the reference of a study: 1 % could never be promised with 1 %."""
        accuracies = Knob("accuracy", Role.SIDE, tuple(Level("", (), size) for size in (1e-2, 1e-3, 1e-4)), 0)
        runner = mock.MagicMock()
        runner.run.side_effect = [replace(answer(1.0), estimates={"u": math.nan}) for _ in range(3)]
        ladder = Ladder([knob("mesh", Role.MESH, [1.0]), accuracies], 2, runner, Budget(1e3, 1e9), lambda rung: None)
        ladder._choose_accuracy(0.01)
        self.assertEqual(ladder.accuracy, 1)

    def test_without_an_answer_in_time_nothing_else_is_tried(self) -> None:
        """Two meshes and their accuracies have used enough of the budget."""
        runner = mock.MagicMock()
        runner.run.return_value = Outcome("stopped", stopped=True)
        ladder = Ladder([knob("mesh", Role.MESH, [1.0, 0.5, 0.25, 0.125]), knob("elements", Role.FAMILY, [1.0, 1.0]),
                         knob("accuracy", Role.SIDE, [1e-2, 1e-3])], 2, runner, Budget(1e3, 1e9), lambda rung: None)
        ladder.explore(1e-3, lambda: False, lambda family: False)
        self.assertEqual(set(ladder.rungs), {(0, 0, 1), (0, 0, 0), (1, 0, 0)})

    def test_elements_that_give_the_very_same_are_not_measured_again(self) -> None:
        """As those of a file that are quadratic already."""
        for value, expected in ((1.0, False), (1.5, True)):
            ladder = self.ladder({(0, 0, 0, 0): answer(1.0), (0, 1, 0, 0): answer(value)})
            self.assertEqual((1, 1, 0, 0) in set(ladder._next(lambda family: False)), expected)

    def test_where_nothing_is_certified_the_reason_is_what_runs_came_to(self) -> None:
        """Not that the budget is too small."""
        ladder = self.ladder({(0, 0, 0, 0): answer(1.0, certified=False), (1, 0, 0, 0): answer(1.0, certified=False)})
        folder = pathlib.Path("x")
        promise = keep(0.01, ladder, Judge(ladder), mock.MagicMock(), mock.MagicMock(), folder, folder)
        self.assertIn("stagnation", promise.reason)

    def test_a_picture_without_heights_has_no_logarithm(self) -> None:
        """It would be warned of."""
        zeros = {(mesh, 0, 0, 0): answer(0.0) for mesh in (0, 1)} | {(0, 0, 1, 0): answer(0.0)}
        ladder = self.ladder(zeros)
        figures: list[Figure] = []

        def kept(figure: Figure, name: str) -> str:
            figures.append(figure)
            return name

        pareto_section(ladder, Judge(ladder), list(ladder.rungs.values()), cast(Pictures, kept))
        self.assertEqual(figures[0].axes[0].get_yscale(), "linear")


if __name__ == "__main__":
    unittest.main()
