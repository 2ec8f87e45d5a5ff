"""The report: its numbers, and the page of a small study."""
import contextlib
import io
import pathlib
import tempfile
import unittest
from unittest import mock

import numpy

import harmos
import small_study
from harmos.report.__main__ import main
from harmos.report.maps import Grid, panels
from harmos.report.page import span
from harmos.report.sensitivities import classes, main_effects, missing_note, quadratic_fit
from harmos.report.stochastic import running_deviations
from harmos.report.writing import label, number, percent, table


class WritingTest(unittest.TestCase):
    def test_numbers(self) -> None:
        self.assertEqual((number(1 / 3), number(numpy.nan, "n/a")), ("0.33333", "n/a"))
        self.assertEqual((percent(0.12345), percent(numpy.nan)), ("12 %", "n/a"))

    def test_tables_are_escaped(self) -> None:
        self.assertEqual(table(("a", "b"), [(1, "<")], (1,)), "<table><tr><th>a</th><th>b</th></tr>"
                                                              "<tr><td>1</td><td class=text>&lt;</td></tr></table>")


class NumbersTest(unittest.TestCase):
    def test_quadratic_fit_finds_derivatives(self) -> None:
        x = numpy.random.default_rng(1).uniform(size=(30, 2))
        low, high = x.min(axis=0), x.max(axis=0)
        scaled = (2 * x - low - high) / (high - low)
        fit = quadratic_fit(x, 5 + 2 * scaled[:, 0] - 3 * scaled[:, 1] + scaled[:, 0] * scaled[:, 1])
        assert fit is not None
        numpy.testing.assert_allclose(fit.derivatives, [2.0, -3.0])
        numpy.testing.assert_allclose(fit.errors, 0.0, atol=1e-12)
        self.assertAlmostEqual(fit.share, 1.0)

    def test_quadratic_fit_needs_points(self) -> None:
        points = numpy.column_stack([small_study.MU, small_study.LOAD])[:3]
        self.assertIsNone(quadratic_fit(points, numpy.ones(3)))

    def test_running_deviations_end_with_that_of_all(self) -> None:
        values = numpy.random.default_rng(1).normal(size=1000)
        counts, deviations = running_deviations(values)
        self.assertEqual((counts[0], counts[-1]), (2, 1000))
        self.assertEqual(deviations[-1], values.std(ddof=1))

    def test_span_is_never_zero(self) -> None:
        self.assertEqual(span(numpy.array([1.0, numpy.nan, 4.0])), 3.0)
        self.assertEqual(span(numpy.array([2.0, 2.0])), 1.0)


class PageTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        small_study.write(self.folder / "joint.h5")
        self.study = harmos.read_study(self.folder / "joint.h5")

    def run_main(self, *options: str) -> tuple[int, str]:
        """Exit code and what is printed."""
        words = ["report", str(self.folder / "joint.h5"), str(self.folder / "joint.html"), *options]
        with mock.patch("sys.argv", words), contextlib.redirect_stdout(io.StringIO()) as printed, \
                contextlib.redirect_stderr(printed):
            return main(), printed.getvalue()

    def test_grid_holds_results(self) -> None:
        grid = Grid(self.study)
        self.assertEqual((grid.names, grid.shape), (["mu", "load"], (3, 2)))
        self.assertTrue(grid.fits(6))
        self.assertFalse(grid.fits(1))
        field = grid.of(self.study.responses["F"])
        self.assertEqual(field[1].tolist(), [2.0, 4.0])
        self.assertTrue(numpy.isnan(field[2, 1]))
        self.assertEqual(panels(grid), [()])

    def test_main_effects_of_a_grid_are_means(self) -> None:
        effects = main_effects(self.study, ["mu", "load"], 2 * small_study.MU)
        self.assertEqual(effects.levels[0].tolist(), [0.1, 0.2, 0.3])
        numpy.testing.assert_allclose(effects.means[0], [0.2, 0.4, 0.6])
        numpy.testing.assert_allclose(effects.shares, [1.0, 0.0], atol=1e-12)
        self.assertAlmostEqual(effects.rest, 0.0)

    def test_shares_add_up_where_solutions_are_missing(self) -> None:
        # A sum of both parameters without the corner where both are large: the variances of the means add up to 126 %.
        values = 10 * small_study.MU + small_study.LOAD / 10
        values[-1] = numpy.nan
        effects = main_effects(self.study, ["mu", "load"], values)
        self.assertAlmostEqual(effects.shares.sum(), 1.0)
        self.assertAlmostEqual(effects.rest, 0.0)
        self.assertTrue((effects.shares > 0.2).all())
        # What the others do is not shown as the effect of one.
        numpy.testing.assert_allclose(numpy.diff(effects.means[0]), 1.0)
        numpy.testing.assert_allclose(numpy.diff(effects.means[1]), 1.0)

    def test_shares_add_up_with_interaction(self) -> None:
        effects = main_effects(self.study, ["mu", "load"], self.study.responses["F"])
        self.assertAlmostEqual(effects.shares.sum() + effects.rest, 1.0)
        self.assertGreater(effects.rest, 0.001)

    def test_a_value_of_its_own_explains_nothing(self) -> None:
        # Each of 30 random points has its own value of every parameter: means over them would explain everything.
        generator = numpy.random.default_rng(1)
        x = generator.uniform(size=30)
        levels, place = classes(x)
        self.assertEqual(len(levels), 5)
        self.assertEqual(numpy.bincount(place).tolist(), [6] * 5)
        numpy.testing.assert_allclose(levels, [x[place == i].mean() for i in range(5)])

    def test_missing_solutions_are_named(self) -> None:
        note = missing_note(self.study)
        self.assertIn("1 of 6 configurations have no solution", note)
        self.assertIn("1 no equilibrium", note)
        self.assertIn("1 of 2 at mu = 0.3", note)
        self.assertIn("1 of 3 at load [N] = 20", note)
        self.study.status[:] = "certified"
        self.assertEqual(missing_note(self.study), "")

    def test_label_has_the_unit(self) -> None:
        self.assertEqual((label(self.study, "load"), label(self.study, "mu")), ("load [N]", "mu"))

    def test_page_is_written(self) -> None:
        code, printed = self.run_main("--abscissa", "", "--pictures", str(self.folder / "pictures"))
        self.assertEqual((code, printed), (0, f"{self.folder / 'joint.html'}\n"))
        text = (self.folder / "joint.html").read_text(encoding="utf-8")
        self.assertTrue(text.endswith("</html>\n"))
        self.assertIn("<h1>A &lt;joint&gt;</h1>", text)
        self.assertIn("too much", text)
        self.assertTrue((self.folder / "pictures" / "F_maps.png").exists())

    def test_the_study_is_never_replaced(self) -> None:
        study, page = self.folder / "joint.h5", self.folder / "joint.html"
        content = study.read_bytes()
        for is_symbolic in (True, False):
            if is_symbolic:
                page.symlink_to(study)
            else:
                page.hardlink_to(study)
            code, printed = self.run_main()
            self.assertEqual(code, 2)
            self.assertIn(f"the result {page} would replace the input {study}", printed)
            page.unlink()
        pictures = self.folder / "pictures"
        pictures.mkdir()
        (pictures / "F_maps.png").symlink_to(study)
        code, printed = self.run_main("--pictures", str(pictures))
        self.assertEqual((code, list(pictures.iterdir())), (2, [pictures / "F_maps.png"]))
        self.assertEqual(study.read_bytes(), content)

    def test_an_old_page_stays_until_the_new_one_is_complete(self) -> None:
        page = self.folder / "joint.html"
        page.write_text("old")
        with mock.patch("os.replace", side_effect=OSError("disk full")):
            self.assertEqual(self.run_main(), (1, f"harmos report: cannot write {page}: disk full.\n"
                                               "  Make room, or write into another folder (--output).\n"))
        self.assertEqual(page.read_text(), "old")
        self.assertEqual(list(self.folder.glob("*.partial.*")), [])

    def test_unknown_curves_are_refused(self) -> None:
        self.assertEqual(self.run_main("--abscissa", "u"), (2, "harmos report: there is no curve u; there are force\n"
                                                            "Nothing was written.\n"))


if __name__ == "__main__":
    unittest.main()
