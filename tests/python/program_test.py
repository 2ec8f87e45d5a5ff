"""How the program is found and run, and what its exit codes become, with a stand-in for the program."""
import os
import pathlib
import stat
import tempfile
import unittest
from unittest import mock

import harmos

STAND_IN = """#!/bin/sh
[ "$1" = --version ] && { echo "Harmos 9.8.7"; exit 0; }
printf '%s\\n' "$@" > "$0.words"
[ -n "$WRITTEN" ] && mkdir -p "$4" && printf '%s' "$WRITTEN" > "$4/scene_result.json"
[ -n "$MESSAGE" ] && printf '%b' "$MESSAGE" >&2
exit ${CODE:-0}
"""
CERTIFIED = '{"program": "Harmos", "status": "certified", "response_error_estimates": {"u": 1e-3, "f": null}}'


class Program(unittest.TestCase):
    def setUp(self) -> None:
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        self.program = self.folder / "harmos"
        self.program.write_text(STAND_IN)
        self.program.chmod(self.program.stat().st_mode | stat.S_IXUSR)
        self.output = self.folder / "results"

    def environment(self, **variables: str) -> "mock._patch_dict":
        return mock.patch.dict(os.environ, {"HARMOS_PROGRAM": str(self.program), **variables})

    def words(self) -> list[str]:
        return pathlib.Path(f"{self.program}.words").read_text().splitlines()

    def test_is_found_by_the_variable_first(self) -> None:
        with self.environment(PATH="/nowhere"):
            self.assertEqual(harmos.find_program(), str(self.program))
            self.assertEqual(harmos.version(), "9.8.7")

    def test_is_found_on_the_path(self) -> None:
        with mock.patch.dict(os.environ, {"PATH": str(self.folder)}):
            os.environ.pop("HARMOS_PROGRAM", None)
            self.assertEqual(harmos.find_program(), str(self.program))

    def test_that_is_not_found_says_where_it_was_looked_for(self) -> None:
        with mock.patch.dict(os.environ, {"PATH": "/nowhere"}):
            os.environ.pop("HARMOS_PROGRAM", None)
            with self.assertRaisesRegex(harmos.NotFound, "HARMOS_PROGRAM.*PATH"):
                harmos.find_program()
        with mock.patch.dict(os.environ, {"HARMOS_PROGRAM": "/nowhere/harmos"}):
            with self.assertRaisesRegex(harmos.NotFound, "/nowhere/harmos"):
                harmos.find_program()

    def test_is_given_changes_as_the_command_line_has_them(self) -> None:
        with self.environment(WRITTEN=CERTIFIED):
            result = harmos.run("a/scene.xml", self.output,
                                {"Values/mu": 0.2, "Solver/On": True, "Law/X": [1, 2.5], "Law/Type": "Perfect"})
        self.assertEqual(self.words(), ["run", "a/scene.xml", "--output", str(self.output), "--quiet", "--set",
                                        "Values/mu=0.2", "--set", "Solver/On=true", "--set", "Law/X={1, 2.5}", "--set",
                                        "Law/Type=Perfect"])
        self.assertTrue(result.is_certified)
        self.assertEqual(result.errors["u"], 1e-3)
        self.assertNotEqual(result.errors["f"], result.errors["f"])

    def test_exit_codes_are_exceptions_with_the_messages(self) -> None:
        message = "s.xml:3: Solver: wrong.\\n  Repair it.\\ns.xml:4: Mesh: wrong, too.\\n2 errors; nothing was run.\\n"
        for code, kind in ((1, harmos.HarmosError), (2, harmos.InputError), (3, harmos.NotConverged),
                           (4, harmos.NoEquilibrium), (130, harmos.Interrupted)):
            with self.environment(CODE=str(code), MESSAGE=message), self.assertRaises(kind) as caught:
                harmos.run("scene.xml", self.output)
            self.assertIs(type(caught.exception), kind)
            self.assertEqual(caught.exception.exit_code, code)
            self.assertEqual(caught.exception.messages,
                             ["s.xml:3: Solver: wrong.\n  Repair it.", "s.xml:4: Mesh: wrong, too."])
            self.assertIn("Repair it.", str(caught.exception))
            self.assertIsNone(caught.exception.result)

    def test_what_was_written_without_convergence_can_be_read(self) -> None:
        written = CERTIFIED.replace('"certified"', '"not converged"')
        with self.environment(CODE="3", WRITTEN=written), self.assertRaises(harmos.NotConverged) as caught:
            harmos.run("scene.xml", self.output)
        self.assertEqual(caught.exception.result.status, "not converged")

    def test_what_an_earlier_run_has_left_is_no_result(self) -> None:
        with self.environment(WRITTEN=CERTIFIED):
            self.assertTrue(harmos.run("scene.xml", self.output).is_certified)
        for code, kind in ((3, harmos.NotConverged), (4, harmos.NoEquilibrium), (130, harmos.Interrupted)):
            with self.environment(CODE=str(code)), self.assertRaises(kind) as caught:
                harmos.run("scene.xml", self.output)
            self.assertIsNone(caught.exception.result)
        with self.environment(), self.assertRaises(harmos.HarmosError):
            harmos.run("scene.xml", self.output)

    def test_no_processes_are_no_number_of_ranks(self) -> None:
        with self.environment(WRITTEN=CERTIFIED):
            for ranks in (0, -1):
                with self.assertRaisesRegex(ValueError, f"ranks.*{ranks}"):
                    harmos.run("scene.xml", self.output, ranks=ranks)
            with self.assertRaises(TypeError):
                harmos.run("scene.xml", self.output, ranks=1.5)  # type: ignore[arg-type]

    def test_that_ends_without_a_word_is_an_error_as_well(self) -> None:
        with self.environment(CODE="7"), self.assertRaisesRegex(harmos.HarmosError, "exit code 7"):
            harmos.run("scene.xml", self.output)

    def test_studies_are_given_their_options(self) -> None:
        with self.environment(CODE="2", MESSAGE="no\\n"), self.assertRaises(harmos.InputError):
            harmos.run_study("study.xml", self.output, ranks_per_configuration=2, restart=True, points="p.csv")
        self.assertEqual(self.words()[4:], ["--quiet", "--ranks-per-configuration", "2", "--restart", "--points",
                                            "p.csv"])


class Record(unittest.TestCase):
    def test_that_is_none_is_refused(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a_result.json"
            for text in ("", "{", "[1]", '{"program": "other"}'):
                path.write_text(text)
                with self.assertRaises(ValueError):
                    harmos.read_result(path)
            with self.assertRaises(ValueError):
                harmos.read_result(path.with_name("a.json"))


if __name__ == "__main__":
    unittest.main()
