"""Limits of ladders, and inputs that settings are changed in."""
import pathlib
import tempfile
import unittest
from collections.abc import Callable
from unittest import mock

import numpy

from harmos.trade.budget import Allowance
from harmos.trade.document import Document, Entry, value_of
from harmos.trade.knobs import Role, knobs_of
from harmos.trade.ladder import Rung, Settings
from harmos.trade.limits import contradiction, limit_of
from harmos.trade.outcome import Answer, read_floors
from harmos.trade.promises import TRIALS, Promise, candidates, keep
from harmos.trade.running import Outcome, Runner

SCENE = """<ParameterList name="Harmos">
  <!-- kept -->
  <Parameter name="Plugins" type="Array(string)" value="{{laws/a.so, /else/b.so}}"/>
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="{type}"/>
    <Parameter name="File" type="string" value="meshes/a.e"/></ParameterList>
  <ParameterList name="Parts"><ParameterList name="a"/><ParameterList name="b"/></ParameterList>
  <ParameterList name="Steps"><ParameterList name="s"><Parameter name="Increments" type="int" value="3"/></ParameterList>
  </ParameterList>
</ParameterList>"""
STUDY = """<ParameterList name="Harmos Study"><Parameter name="Scene" type="string" value="scene.xml"/>
  <Parameter name="Scene Overrides" type="Array(string)" value="{Mesh/Refinement=0.5, Steps/s/Increments=4}"/>
</ParameterList>"""


class LimitTest(unittest.TestCase):
    """Sequences whose limits are known."""

    def limit(self, values: list[float], noise: float = 0.0, ratio: float = 2.0) -> tuple[float, float, float]:
        """Limit, uncertainty and order of values on levels with one ratio of sizes."""
        sizes = [ratio ** -i for i in range(len(values))]
        found = limit_of(sizes, [numpy.array([value]) for value in values], numpy.array([noise]))
        return float(found.values[0]), float(found.uncertainty[0]), float(found.orders[0])

    def test_a_power_is_extrapolated_whatever_its_order_and_ratio(self) -> None:
        """3 + 2 h^p."""
        for order in (0.5, 1.0, 1.6, 2.0, 4.0):
            for ratio in (1.5, 2.0):
                limit, doubt, found = self.limit([3 + 2 * ratio ** (-order * i) for i in range(3)], ratio=ratio)
                self.assertAlmostEqual(limit, 3.0, places=12)
                self.assertAlmostEqual(found, order, places=9)
                self.assertAlmostEqual(doubt, 2 * ratio ** (-2 * order), places=12)

    def test_the_limit_lies_within_its_uncertainty_when_two_powers_mix(self) -> None:
        """3 + h + 4 h^2, not yet in the range where one power rules."""
        for levels in (3, 4, 5, 6):
            limit, doubt, _ = self.limit([3 + 2.0 ** -i + 4 * 4.0 ** -i for i in range(levels)])
            self.assertLessEqual(abs(limit - 3), doubt)

    def test_no_limit_is_claimed_where_levels_do_not_converge_monotonically(self) -> None:
        """Differences that change their sign, grow, or shrink too slowly: these two count for what order 0.4 leaves."""
        for values, factor in (([1.0, 2.0, 1.5], 1.0), ([1.0, 1.1, 1.3], 3.1), ([1.0, 2.0, 2.99], 3.1)):
            limit, doubt, order = self.limit(values)
            self.assertEqual(limit, values[-1])
            self.assertTrue(numpy.isnan(order))
            self.assertGreaterEqual(doubt, factor * max(abs(values[1] - values[0]), abs(values[2] - values[1])) - 0.04)

    def test_a_step_that_is_small_by_chance_is_no_limit(self) -> None:
        """Lap joints whose edges lie within the cells of both parts, in other places on every mesh: 10.66 and 10.6403 are right."""
        for values, right in (([9.98, 10.36, 12.17, 11.12, 11.23, 10.822, 10.8214], 10.66),
                              ([9.297495, 10.236168, 10.583312, 10.656774, 10.658372], 10.6403)):
            for levels in range(2, len(values) + 1):
                limit, doubt, _ = self.limit(values[:levels])
                self.assertLessEqual(abs(limit - right), doubt, levels)

    def test_levels_that_were_irregular_before_leave_the_last_difference(self) -> None:
        """A limit of three levels that the fourth one does not know of is known to what it has changed."""
        limit, doubt, order = self.limit([4.0, 3.0, 3.2, 3.1, 3.05])
        self.assertAlmostEqual(limit, 3.0)
        self.assertAlmostEqual(order, 1.0)
        self.assertAlmostEqual(doubt, 0.05)

    def test_one_level_tells_nothing_and_two_what_the_slowest_order_leaves(self) -> None:
        """What has not been refined is not known."""
        self.assertEqual(self.limit([1.0])[1], numpy.inf)
        limit, doubt, _ = self.limit([1.0, 1.25])
        self.assertEqual(limit, 1.25)
        self.assertAlmostEqual(doubt, 0.25 / (2 ** 0.4 - 1))

    def test_what_does_not_change_is_known_to_its_noise(self) -> None:
        """As forces that balance loads."""
        self.assertEqual(self.limit([5.0, 5.0, 5.0], noise=1e-3)[:2], (5.0, 1e-3))

    def test_a_change_within_the_noise_may_be_one_of_the_levels(self) -> None:
        """3 + 0.002 h^0.4: the noise is asked of the iteration, which mostly leaves less; two levels were said to be known to it."""
        for levels in (2, 3):
            limit, doubt, _ = self.limit([3 + 0.002 * 2.0 ** (-0.4 * i) for i in range(levels)], noise=5e-4)
            self.assertGreaterEqual(doubt, limit - 3)


class ContradictionTest(unittest.TestCase):
    """Meshes that a limit of 1, told by meshes down to a quarter, is held against."""

    def against(self, values: list[float]) -> float:
        """Of meshes whose sizes are halved, from 1 on."""
        sizes = [2.0 ** -i for i in range(len(values))]
        return float(contradiction(numpy.array([1.0]), 0.25, sizes, [numpy.array([value]) for value in values])[0])

    def test_finer_meshes_that_leave_a_limit_contradict_it_in_full(self) -> None:
        """However far they differ among themselves."""
        self.assertAlmostEqual(self.against([0.9, 0.99, 1.001, 1.2]), 0.2)
        self.assertAlmostEqual(self.against([0.9, 0.95, 1.3, 1.02]), 0.0)
        self.assertAlmostEqual(self.against([0.9, 0.95, 1.3, 1.29]), 0.3)

    def test_finer_meshes_that_approach_a_limit_do_not(self) -> None:
        """As linear elements, which need finer meshes for the same; but not where they do so more slowly than is believed."""
        self.assertEqual(self.against([0.2, 0.6, 0.8, 0.9]), 0.0)
        self.assertAlmostEqual(self.against([0.2, 0.6, 0.8, 0.84]), 0.2)

    def test_coarser_meshes_do_not(self) -> None:
        """They are mostly farther off."""
        self.assertEqual(self.against([0.9, 0.5]), 0.0)
        self.assertEqual(self.against([0.9, 0.5, 0.4]), 0.6)


class FloorsTest(unittest.TestCase):
    """Sizes below which a response counts as nothing."""

    def setUp(self) -> None:
        """A run of a scene with a response that is 0 by symmetry and one that is not, and a study of it."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "scene_result.json").write_text('{"response_sizes": {"zero": 0.01, "u": 2.0, "v": 0.5}}')
        (self.folder / "scene_history.csv").write_text("step,time,zero,u,v\n1,1,1e-17,-2.0,0.01\n2,2,0,1.5,0.02\n")
        (self.folder / "scene.xml").write_text(
            '<ParameterList name="Harmos"><ParameterList name="Responses"><ParameterList name="v">'
            '<Parameter name="Scale" type="double" value="0.5"/></ParameterList></ParameterList></ParameterList>')
        (self.folder / "study.xml").write_text(
            '<ParameterList name="Harmos Study"><Parameter name="Scene" type="string" value="scene.xml"/>'
            '<Parameter name="Scene Overrides" type="Array(string)" value="{Mesh/Refine=1}"/>'
            '<ParameterList name="Responses"><ParameterList name="z"><Parameter name="Response" type="string" value="zero"/>'
            "</ParameterList></ParameterList></ParameterList>")

    def test_only_what_is_below_its_size_tells_a_floor(self) -> None:
        """The size of the other is its own."""
        self.assertEqual(read_floors(Document(self.folder / "scene.xml"), self.folder / "scene"),
                         {"zero": 0.01, "u": 0.0, "v": 0.5})

    def test_responses_of_a_study_have_the_floors_of_its_scene(self) -> None:
        """Round-off was compared with round-off, and nothing was promised; the scene is run once for all."""
        answers: list[Answer] = [("complete", True, {}, {}, {"z, mean": 1e-17, "z, standard deviation": 0.25}, {}, {})] * 2
        with mock.patch("harmos.trade.running.read_outcome", side_effect=answers), \
                mock.patch("harmos.trade.running.read_floors", return_value={"zero": 0.01}) as floors, \
                mock.patch("harmos.trade.running._watched", return_value=(0, "", mock.MagicMock())) as watched:
            runner = Runner("harmos", Document(self.folder / "study.xml"), self.folder / "work")
            outcomes = [runner.run((), Allowance(1.0, None, ""), 1e9) for _ in range(2)]
        self.assertEqual([outcome.sizes for outcome in outcomes], [{"z, mean": 0.01, "z, standard deviation": 0.25}] * 2)
        self.assertEqual(floors.call_count, 1)
        words = [call.args[0] for call in watched.call_args_list]
        self.assertEqual([each[1] for each in words], ["study", "run", "study"])
        self.assertEqual(words[1][3:5], ["--set", "Mesh/Refine=1"])


class DocumentTest(unittest.TestCase):
    """Inputs that are changed and written elsewhere."""

    def setUp(self) -> None:
        """A scene and a study of it."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "scene.xml").write_text(SCENE.format(type="Bolted Joint"))
        (self.folder / "study.xml").write_text(STUDY)
        (self.folder / "deep" / "out").mkdir(parents=True)

    def test_a_scene_keeps_what_does_not_change(self) -> None:
        """Comments, entries, and where its mesh lies."""
        target = self.folder / "deep" / "out" / "new.xml"
        changes = [Entry("Mesh/Refinement", "double", "2.0"), Entry("Steps/s/Increments", "int", None)]
        self.assertEqual(Document(self.folder / "scene.xml").write(changes, target, "a -- b"), [target])
        written = Document(target)
        self.assertEqual(written.value("Mesh/Refinement", ""), "2.0")
        self.assertEqual(written.value("Steps/s/Increments", "none"), "none")
        self.assertEqual((target.parent / written.value("Mesh/File", "")).resolve(),
                         (self.folder / "meshes" / "a.e").resolve())
        self.assertEqual(written.value("Plugins", ""), "{../../laws/a.so, /else/b.so}")
        self.assertIn("<!-- kept -->", target.read_text())

    def test_parts_may_have_slashes_in_their_names(self) -> None:
        """Lists of the pieces of a name were made instead, every run was refused, and nothing could be certified."""
        scene = self.folder / "scene.xml"
        scene.write_text(SCENE.format(type="Bolted Joint").replace('name="b"', 'name="a/b"'))
        target = self.folder / "new.xml"
        Document(scene).write([Entry("Parts/a/b/Pieces", "int", "2"), Entry("Parts/a/Pieces", "int", "3"),
                               Entry("Solver/Search Direction/Scale", "double", "4")], target, "")
        written = Document(target)
        self.assertEqual(written.names("Parts"), ["a", "a/b"])
        for path, value in (("Parts/a/b/Pieces", "2"), ("Parts/a/Pieces", "3"), ("Solver/Search Direction/Scale", "4")):
            self.assertEqual(written.value(path, ""), value)
        self.assertEqual(len(written.scene.findall(".//Parameter[@name='Pieces']/../..")), 1)

    def test_changes_of_a_study_win_over_its_overrides(self) -> None:
        """They are made in the scene, which is written beside."""
        target = self.folder / "deep" / "out" / "new.xml"
        study = Document(self.folder / "study.xml")
        self.assertEqual(study.value("Mesh/Refinement", ""), "0.5")
        files = study.write([Entry("Mesh/Refinement", "double", "2.0"), Entry("Study/Accuracy", "double", "1e-4")], target, "")
        written = Document(target)
        self.assertEqual(files, [target, written.scene_path])
        self.assertEqual(written.value("Mesh/Refinement", ""), "2.0")
        self.assertEqual(written.value("Steps/s/Increments", ""), "4")
        assert written.study is not None
        self.assertEqual(value_of(written.study, "Accuracy"), "1e-4")

    def test_levels_of_knobs_are_of_the_input(self) -> None:
        """Meshes around the given one, steps in whole increments, pieces by elements; refused elements are left out."""
        def accepts(entries: tuple[Entry, ...]) -> bool:
            return not any(entry.value == "Incompatible Modes" and "Parts/b" in entry.path for entry in entries)

        knobs = {knob.name: knob for knob in knobs_of(Document(self.folder / "scene.xml"), accepts, {"a": 400, "b": 90})}
        self.assertEqual([level.name for level in knobs["mesh"].levels][:3],
                         ["refinement 0.25", "refinement 0.5", "refinement 1"])
        self.assertEqual(knobs["mesh"].levels[knobs["mesh"].given].name, "refinement 1")
        self.assertEqual([level.name for level in knobs["time steps"].levels],
                         ["1", "2", "3", "6", "12", "24"])
        self.assertEqual(knobs["elements"].levels[-1].entries,
                         (Entry("Parts/a/Formulation", "string", "Incompatible Modes"),))
        self.assertEqual([entry.value for entry in knobs["pieces per part"].levels[-1].entries], ["4", "1"])
        self.assertIs(knobs["interface mass"].role, Role.FAMILY)


class PromiseTest(unittest.TestCase):
    """Settings that are tried in the order of their costs."""

    def kept(self, outcome: Callable[[int], Outcome], fresh: dict[Settings, Rung] | None = None) -> Promise:
        """What comes of a target of 5 % where the run of settings n, which should cost n, ends with outcome(n)."""
        settings = [(n,) for n in range(3 * TRIALS)]
        ladder, judge, runner, document = (mock.MagicMock() for _ in range(4))
        ladder.budget.left.return_value = 1.0
        ladder.predicted.side_effect = lambda settings, what: float(settings[0]) if what == "cpu" else 0.1
        ladder.knobs, ladder.refused, ladder.fresh = [], set(), fresh if fresh is not None else {}
        judge.doubt.return_value = 0.0
        judge.promised.side_effect = lambda rung: 0.01 if rung.outcome.certified else numpy.inf
        runs = iter(range(len(settings)))
        runner.run_file.side_effect = lambda path, allowance, memory: outcome(next(runs))
        expected = [(float(n), 0.02, (n,)) for (n,) in settings]
        with mock.patch("harmos.trade.promises.expected_costs", return_value=expected):
            return keep(0.05, ladder, judge, runner, document, pathlib.Path("out"), pathlib.Path("work"))

    def test_settings_that_are_refused_are_no_trials(self) -> None:
        """As many pieces as a coarse mesh has no elements for, over and over, before those that keep the promise."""
        many = 2 * TRIALS
        promise = self.kept(lambda n: Outcome("refused: Pieces", refused=True) if n < many else Outcome("", True))
        assert promise.rung is not None
        self.assertEqual(promise.rung.settings, (many,))
        self.assertEqual(promise.error, 0.01)

    def test_few_settings_are_tried_that_do_not_keep_it(self) -> None:
        """Each costs a run."""
        self.assertIsNone(self.kept(lambda n: Outcome("", certified=n >= TRIALS)).rung)
        self.assertIsNotNone(self.kept(lambda n: Outcome("", certified=n >= TRIALS - 1)).rung)

    def test_settings_that_were_run_afresh_for_one_target_are_not_run_for_another(self) -> None:
        """The same input would be: its cost would differ by chance only, and 1 % could seem cheaper than 5 %."""
        fresh: dict[Settings, Rung] = {}
        first = self.kept(lambda n: Outcome("", certified=True), fresh)

        def never(n: int) -> Outcome:
            raise AssertionError(n)

        self.assertIs(self.kept(never, fresh).rung, first.rung)

    def test_settings_that_have_kept_a_target_are_candidates_where_none_is_expected_to(self) -> None:
        """Within a tenth below the target it was said that none comes so near, under a table in which one did."""
        ladder, judge = mock.MagicMock(), mock.MagicMock()
        ladder.rungs = {(n,): Rung((n,), Outcome("", certified=n < 2), 1.0, "ladder") for n in range(3)}
        judge.promised.side_effect = lambda rung: (0.06, 0.048)[rung.settings[0]] if rung.outcome.certified else numpy.inf
        for expected, found in ((0.049, [(1,)]), (0.04, [(n,) for n in range(4)])):
            costs = [(float(n), expected, (n,)) for n in range(4)]
            with mock.patch("harmos.trade.promises.expected_costs", return_value=costs):
                self.assertEqual(candidates(0.05, ladder, judge), found)

    def test_a_reason_is_given_where_all_are_refused(self) -> None:
        """The first one's."""
        promise = self.kept(lambda n: Outcome(f"refused: {n}", refused=True))
        self.assertIsNone(promise.rung)
        self.assertIn("refused: 0", promise.reason)


if __name__ == "__main__":
    unittest.main()
