"""Inputs that a trade takes as they are: shared numbers, parts in pieces, links, and the files that it replaces."""
import contextlib
import io
import os
import pathlib
import signal
import tempfile
import unittest
from unittest import mock

from harmos.trade.__main__ import main
from harmos.trade.budget import free_memory
from harmos.trade.document import Document, find, value_of
from harmos.trade.knobs import elements_of, knobs_of
from harmos.trade.promises import REMARK, settings_files
from harmos.trade.publishing import publish
from harmos.trade.responses import chosen_responses, demand_moments
from harmos.trade.running import Runner

SCENE = """<ParameterList name="Harmos">
  <ParameterList name="Values"><Parameter name="acc" type="double" value="1e-2"/>
    <Parameter name="n" type="int" value="8"/></ParameterList>
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Boxes"/>
    <Parameter name="Element" type="string" value="{element}"/>
    <Parameter name="File" type="string" value="meshes/a.e"/><ParameterList name="Boxes"><ParameterList name="a">
      <Parameter name="Cells" type="Array(double)" value="{{$n, 4}}"/></ParameterList></ParameterList></ParameterList>
  <ParameterList name="Solver"><Parameter name="Accuracy" type="double" value="$acc"/></ParameterList>
  <ParameterList name="Steps"><ParameterList name="s"><Parameter name="Increments" type="int" value="3"/></ParameterList>
  </ParameterList>
  <ParameterList name="Responses"><ParameterList name="u"/></ParameterList>
</ParameterList>"""
STUDY = """<ParameterList name="Harmos Study"><Parameter name="Scene" type="string" value="scene.xml"/>
  <Parameter name="Scene Overrides" type="Array(string)" value="{Mesh/File=meshes/b.e, Values/acc=1e-4}"/>
  <ParameterList name="Parameters"><ParameterList name="cells"><Parameter name="Entry" type="string" value="Values/n"/>
  </ParameterList></ParameterList>
</ParameterList>"""


STUDY_OF = """<ParameterList name="Harmos Study"><Parameter name="Scene" type="string" value="scene.xml"/>
  <ParameterList name="Design"><Parameter name="Type" type="string" value="{design}"/></ParameterList>
</ParameterList>"""


class SettingsTest(unittest.TestCase):
    """A scene and a study of it in a folder."""

    def setUp(self) -> None:
        """Writes them."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "scene.xml").write_text(SCENE.format(element="Quad4"))
        (self.folder / "study.xml").write_text(STUDY)

    def test_shared_numbers_are_those_of_values(self) -> None:
        """Alone, in arrays, and as the overrides of a study leave them."""
        scene, study = Document(self.folder / "scene.xml"), Document(self.folder / "study.xml")
        self.assertEqual(scene.value("Solver/Accuracy", ""), "1e-2")
        self.assertEqual(scene.value("Mesh/Boxes/a/Cells", ""), "{8, 4}")
        self.assertEqual(study.value("Solver/Accuracy", ""), "1e-4")

    def test_a_number_that_the_study_varies_is_no_knob(self) -> None:
        """The cells are; nothing else is."""
        knobs = {knob.name: knob for knob in knobs_of(Document(self.folder / "study.xml"), lambda entries: True, {})}
        self.assertEqual([level.name for level in knobs["mesh"].levels], ["as the study varies it"])
        self.assertGreater(len(knobs["time steps"].levels), 1)

    def test_quadratic_elements_have_no_quadratic_candidate(self) -> None:
        """They would be measured twice."""
        for element, expected in (("Quad4", True), ("Quad8", False)):
            (self.folder / "scene.xml").write_text(SCENE.format(element=element))
            knobs = knobs_of(Document(self.folder / "scene.xml"), lambda entries: True, {})
            self.assertEqual("quadratic" in [level.name for level in knobs[1].levels], expected)

    def test_elements_of_pieces_are_those_of_their_part(self) -> None:
        """Names may have blanks and points."""
        words = """3 substructures:
  lower plate.1                             25 nodes         16 elements, rank 0
  lower plate.2                             25 nodes         18 elements, rank 0
  b.2                                       45 nodes         32 elements, rank 0
"""
        self.assertEqual(elements_of(["lower plate", "b.2"], words), {"lower plate": 34, "b.2": 32})

    def test_files_of_overrides_are_found_from_another_folder(self) -> None:
        """Also from one behind a link, and from where the settings will be moved."""
        (self.folder / "deep" / "er").mkdir(parents=True)
        os.symlink(self.folder / "deep" / "er", self.folder / "link")
        (self.folder / "deep" / "er" / "work").mkdir()
        for target, home in ((self.folder / "link" / "new.xml", None),
                             (self.folder / "deep" / "er" / "work" / "new.xml", self.folder / "link")):
            Document(self.folder / "study.xml").write([], target, "", home)
            found = Document(target).value("Mesh/File", "")
            self.assertEqual(os.path.realpath(os.path.realpath(home or target.parent) + "/" + found),
                             os.path.realpath(self.folder / "meshes" / "b.e"))

    def test_settings_of_other_scenes_are_not_those_of_this_one(self) -> None:
        """Nor is a folder of their name."""
        for name in ("scene_within_1_percent.xml", "scene_within_1_percent_scene.xml",
                     "scene_within_limits_within_1_percent.xml"):
            (self.folder / name).write_text(f"<!-- {REMARK} for -->")
        (self.folder / "scene_within_2_percent.xml").mkdir()
        found = settings_files(Document(self.folder / "scene.xml"), self.folder)
        self.assertEqual({file.name for file in found}, {"scene_within_1_percent.xml", "scene_within_1_percent_scene.xml"})

    def test_results_are_replaced_without_an_interruption(self) -> None:
        """One that comes in between is too late."""
        made = self.folder / "made"
        made.mkdir()
        for name in ("a", "b"):
            (made / name).write_text("new")
            (self.folder / name).write_text("old")
        replace = os.replace

        def interrupted(source: pathlib.Path, target: pathlib.Path) -> None:
            signal.raise_signal(signal.SIGINT)
            replace(source, target)

        with mock.patch("os.replace", interrupted):
            publish(made, self.folder, [self.folder / "study.xml"])
        self.assertEqual([(self.folder / name).read_text() for name in ("a", "b")], ["new", "new"])
        self.assertFalse((self.folder / "study.xml").exists())
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def refused(self, name: str) -> str:
        """What is said of an input that is refused before anything runs, where a results folder has that name."""
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            self.assertEqual(main([str(self.folder / name), "--program", "/bin/false", "--targets", "1%",
                                   "--output", str(self.folder / "out")]), 2)
        return said.getvalue()

    def test_what_cannot_be_written_is_said_before_anything_runs(self) -> None:
        """Settings where a folder is, of a study its scene as well."""
        for source, name in (("scene.xml", "scene_within_1_percent.xml"), ("study.xml", "study_within_1_percent_scene.xml")):
            (self.folder / "out" / name).mkdir(parents=True)
            self.assertIn("it is a folder", self.refused(source))

    def test_no_result_replaces_an_input(self) -> None:
        """Not the scene of a study that an earlier trade has recommended, nor what an entry or an override names."""
        out = self.folder / "out"
        out.mkdir()
        settings = f"<!-- {REMARK} for errors below 2 % -->" + SCENE.format(element="Quad4")
        for target in ("1", "2"):  # those of 2 % would be removed as old ones
            scene = out / f"study_within_{target}_percent_scene.xml"
            scene.write_text(settings)
            (self.folder / "study.xml").write_text(STUDY.replace("scene.xml", str(scene)))
            self.assertIn(f"would replace the input {scene}", self.refused("study.xml"))
            self.assertEqual(scene.read_text(), settings)
            scene.unlink()
        table = out / "scene_trade.h5"
        table.write_text("a mesh")
        (self.folder / "meshes").mkdir()
        for mesh in ("a.e", "b.e"):
            os.symlink(table, self.folder / "meshes" / mesh)
        (self.folder / "scene.xml").write_text(SCENE.format(element="Quad4"))
        self.assertIn("meshes/a.e", self.refused("scene.xml"))
        table.rename(out / "study_trade.csv")
        (self.folder / "meshes" / "b.e").unlink()
        os.symlink(out / "study_trade.csv", self.folder / "meshes" / "b.e")
        (self.folder / "study.xml").write_text(STUDY)
        self.assertIn("meshes/b.e", self.refused("study.xml"))

    def test_files_that_are_read_are_known(self) -> None:
        """Laws, points of a design and samples of a distribution as well."""
        (self.folder / "scene.xml").write_text('<ParameterList name="Harmos"><Parameter name="Plugins" '
                                               'type="Array(string)" value="{laws/a.so, b.so}"/></ParameterList>')
        (self.folder / "sub").mkdir()
        (self.folder / "sub" / "study.xml").write_text(
            '<ParameterList name="Harmos Study"><Parameter name="Scene" type="string" value="../scene.xml"/>'
            '<ParameterList name="Design"><Parameter name="File" type="string" value="points.csv"/></ParameterList>'
            "</ParameterList>")
        found = {os.path.relpath(file, self.folder) for file in Document(self.folder / "sub" / "study.xml").inputs()}
        self.assertEqual(found, {"scene.xml", "sub/study.xml", "laws/a.so", "b.so", "sub/points.csv"})

    def test_a_design_that_chooses_its_configurations_is_refused(self) -> None:
        """Those of one run were compared with others of the next."""
        (self.folder / "study.xml").write_text(STUDY_OF.format(design="Adaptive"))
        self.assertIn("chooses its configurations", self.refused("study.xml"))

    def test_an_expansion_without_responses_of_its_own_reports_those_of_the_scene(self) -> None:
        """The curves of configurations that are held out were compared instead."""
        for design, expected in (("Chaos", ["u"]), ("Collocation", ["u"]), ("Sobol", [])):
            (self.folder / "study.xml").write_text(STUDY_OF.format(design=design))
            document = Document(self.folder / "study.xml")
            demand_moments(document)
            target = self.folder / "new.xml"
            document.write([], target, "")
            written = Document(target).study
            assert written is not None
            own = find(written, "Responses")
            self.assertEqual([one.get("name") for one in own] if own is not None else [], expected)
            self.assertEqual(value_of(written, "Responses/u/Type"), "Final" if expected else None)
            self.assertEqual(chosen_responses("u", document), ["u"])

    def test_a_folder_is_no_input(self) -> None:
        """It is called one."""
        self.assertIn("is a folder", self.refused("."))

    def test_an_input_that_is_refused_leaves_no_folder(self) -> None:
        """It is checked where it is."""
        self.refused("scene.xml")
        self.assertFalse((self.folder / "out").exists())

    def test_why_a_trial_is_refused_names_no_file_of_the_trial(self) -> None:
        """It is gone when that is read."""
        runner = Runner("/bin/false", Document(self.folder / "scene.xml"), self.folder / "a work")
        (self.folder / "a work" / "messages").write_text(f"{self.folder}/a work/a scene.xml:26: Parts / a: Pieces = 400\n")
        self.assertEqual(runner._read(self.folder / "x", 2).status, "refused: Parts / a: Pieces = 400")

    def test_free_memory_is_what_the_machine_can_give(self) -> None:
        """Files that it keeps count as free."""
        with mock.patch("builtins.open", mock.mock_open(read_data="MemFree: 5 kB\nMemAvailable:  2000 kB\n")):
            self.assertEqual(free_memory(), 2048000.0)


if __name__ == "__main__":
    unittest.main()
