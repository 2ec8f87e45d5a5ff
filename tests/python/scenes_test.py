"""Scenes built, read, changed and written in code."""
import pathlib
import tempfile
import unittest

import numpy

import harmos
from harmos.scenes import value_text

CONTENT = {"Title": "A & B", "Values": {"mu": 0.3},
           "Mesh": {"Type": "Exodus", "File": "m.e"},
           "Solver": {"Accuracy": 1e-4, "Mesh Error": False, "Maximum Iterations": 20},
           "Interfaces": {"joint": {"Direction": [1.0, 0.0, 0.5], "Parts": ["a", "b"],
                                    "Law": {"Friction Coefficient": "$mu"}}}}


class Scenes(unittest.TestCase):
    def setUp(self) -> None:
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def test_come_back_as_they_were_written(self) -> None:
        scene = harmos.Scene("a", CONTENT, self.folder)
        again = harmos.read_scene(scene.write())
        self.assertEqual({name: again[name] for name in again}, CONTENT)
        self.assertEqual((again.name, again.folder), ("a", self.folder))
        self.assertIs(again["Solver/Mesh Error"], False)
        self.assertIs(type(again["Solver/Maximum Iterations"]), int)

    def test_are_addressed_by_paths(self) -> None:
        scene = harmos.Scene("a", CONTENT)
        scene["Interfaces/joint/Law/Friction Coefficient"] = 0.1
        scene["New/List/Entry"] = "x"
        scene["Parts"] = {"one": {"Material": "steel"}}
        self.assertEqual(scene["Interfaces/joint/Law"], {"Friction Coefficient": 0.1})
        self.assertEqual(scene["New/List/Entry"], "x")
        self.assertIn("Parts/one/Material", scene)
        del scene["Parts/one"]
        self.assertNotIn("Parts/one", scene)
        self.assertNotIn("Title/one", scene)
        with self.assertRaises(KeyError):
            scene["Solver/Accurasy"]
        with self.assertRaises(KeyError):
            scene["Title/x"] = 1.0
        self.assertEqual(CONTENT["Interfaces"]["joint"]["Law"], {"Friction Coefficient": "$mu"})  # type: ignore[index]

    def test_give_lists_away_as_copies(self) -> None:
        scene = harmos.Scene("a", CONTENT)
        scene["Solver"]["Accuracy"] = 1.0
        self.assertEqual(scene["Solver/Accuracy"], 1e-4)

    def test_write_numbers_of_numpy_as_their_values(self) -> None:
        scene = harmos.Scene("a", {"x": numpy.float64(0.1), "n": numpy.int64(3), "v": numpy.array([1.5, 2.0])})
        text = scene.xml()
        self.assertIn('name="x" type="double" value="0.1"', text)
        self.assertIn('name="n" type="int" value="3"', text)
        self.assertIn('name="v" type="Array(double)" value="{1.5, 2}"', text)

    def test_what_no_entry_may_hold_is_refused_with_its_path(self) -> None:
        for value in (None, object(), {1, 2}, b"x", 1j, [1, "a"], numpy.eye(2), (each for each in (1, 2))):
            scene = harmos.Scene("a", {"Law": {"X": value}})
            with self.assertRaisesRegex(TypeError, "^Law/X: .*neither text nor a number"):
                scene.xml()
        with self.assertRaisesRegex(TypeError, "neither text nor a number"):
            value_text(None)  # type: ignore[arg-type]

    def test_paths_are_text(self) -> None:
        text = harmos.Scene("a", {"File": pathlib.Path("b/m.e"), "Plugins": [pathlib.Path("p.so")]}).xml()
        self.assertIn('name="File" type="string" value="b/m.e"', text)
        self.assertIn('name="Plugins" type="Array(string)" value="{p.so}"', text)

    def test_names_are_those_of_files(self) -> None:
        for name in ("", "a/b", "../a"):
            with self.assertRaisesRegex(ValueError, "without folder"):
                harmos.Scene(name)

    def test_name_their_plugins_wherever_they_are_written(self) -> None:
        (self.folder / "laws.so").touch()
        scene = harmos.Scene("a", {"Plugins": ["laws.so", "/else/more.so"]}, self.folder)
        elsewhere = self.folder / "results"
        elsewhere.mkdir()
        self.assertEqual(harmos.read_scene(scene.write(elsewhere / "a.xml"))["Plugins"],
                         [str(self.folder / "laws.so"), "/else/more.so"])

    def test_name_their_files_wherever_they_are_written(self) -> None:
        (self.folder / "m.e").touch()
        scene = harmos.Scene("a", CONTENT, self.folder)
        elsewhere = self.folder / "results"
        elsewhere.mkdir()
        self.assertEqual(harmos.read_scene(scene.write())["Mesh/File"], "m.e")
        self.assertEqual(harmos.read_scene(scene.write(elsewhere / "a.xml"))["Mesh/File"], str(self.folder / "m.e"))

    def test_that_cannot_be_read_are_refused_with_their_place(self) -> None:
        path = self.folder / "bad.xml"
        for text, message in (("<ParameterList", "bad.xml: "),
                              ('<ParameterList><Parameter name="x" type="double" value="abc"/></ParameterList>', "x: "),
                              ('<ParameterList><Thing name="x"/></ParameterList>', "Thing")):
            path.write_text(text)
            with self.assertRaisesRegex(ValueError, message):
                harmos.read_scene(path)

    def test_values_are_written_as_on_the_command_line(self) -> None:
        for value, text in ((True, "true"), (0.1, "0.1"), (3, "3"), ([1, 2.5], "{1, 2.5}"), (["a", "b"], "{a, b}"),
                            ("$mu", "$mu"), (1e-9, "1e-09"), (numpy.float32(0.5), "0.5"), (numpy.int64(3), "3"),
                            (pathlib.Path("a/b"), "a/b"), (numpy.array([1.0, 2.5]), "{1, 2.5}"), ((1, 2), "{1, 2}")):
            self.assertEqual(value_text(value), text)  # type: ignore[arg-type]


if __name__ == "__main__":
    unittest.main()
