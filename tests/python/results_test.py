"""What is read of study files and histories, and response surfaces."""
import pathlib
import tempfile
import unittest

import numpy

import harmos
import small_study
from harmos.arrays import Floats


class TemporaryFolder(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "joint.h5"


class StudyTest(TemporaryFolder):
    def read(self) -> harmos.Study:
        small_study.write(self.path)
        return harmos.read_study(self.path)

    def test_holds_what_was_written(self) -> None:
        study = self.read()
        self.assertEqual((study.name, study.title, study.state), ("joint", "A <joint>", "complete"))
        self.assertEqual(study.accuracy, 1e-3)
        self.assertEqual(list(study.parameters), ["mu", "load", "twice"])
        self.assertEqual(study.units["load"], "N")
        self.assertEqual(study.entries["mu"], ["Values/mu"])
        self.assertEqual(study.curves["force"].shape, (6, 2))
        self.assertEqual((study.left_out, study.notes), ({"not too tight": 3}, {"audit": "1 of 1"}))
        self.assertEqual(study.reason[-1], "too much")
        self.assertEqual(study.surrogate_models, {})
        self.assertIsNone(study.statistics)

    def test_knows_what_is_solved_and_free(self) -> None:
        study = self.read()
        self.assertEqual(study.solved.tolist(), [True] * 5 + [False])
        self.assertEqual(study.free, ["mu", "load"])  # the other one is derived
        self.assertEqual(study.points().tolist()[3], [0.2, 20.0])
        self.assertEqual(study.points(["twice"]).tolist()[5], [0.6])
        self.assertEqual(study.select(mu=0.2, load=20).tolist(), [False, False, False, True, False, False])

    def test_is_a_table(self) -> None:
        table = self.read().table()
        self.assertEqual(table.dtype.names, ("id", "mu", "load", "twice", "status", "iterations", "error_estimate",
                                             "start", "F"))
        self.assertEqual(table["status"][4], "calibrated")
        self.assertEqual(table[3]["F"], 4.0)

    def test_refuses_damage(self) -> None:
        small_study.write(self.path)
        content = bytearray(self.path.read_bytes())
        content[len(content) // 2] ^= 0x55
        self.path.write_bytes(content)
        with self.assertRaisesRegex(ValueError, "joint.h5 is no file of a study, or was damaged or changed since. Run"):
            harmos.read_study(self.path)

    def test_refuses_other_files(self) -> None:
        small_study.write(self.path, schema="other")
        with self.assertRaisesRegex(ValueError, "is not a study of Harmos"):
            harmos.read_study(self.path)
        small_study.write(self.path, version=2)
        with self.assertRaisesRegex(ValueError, "was written by a newer Harmos, 0.1.0"):
            harmos.read_study(self.path)
        with self.assertRaises(OSError):
            harmos.read_study(self.path.with_name("none.h5"))

    def test_names_the_surfaces_that_there_are(self) -> None:
        with self.assertRaisesRegex(ValueError, r"there is no response surface of F; there are: \[\]"):
            self.read().surrogate("F")


class SurrogateTest(unittest.TestCase):
    model: harmos.SurrogateModel = {
        "lower": numpy.array([0.0, 10.0]), "upper": numpy.array([1.0, 30.0]), "lengths": numpy.array([1.0, 2.0]),
        "degree": 2, "nugget": 1e-10, "calibration": 2.0, "largest_left_out_error": 0.2, "mean_left_out_error": 0.1}
    points = numpy.random.default_rng(1).uniform([0.0, 10.0], [1.0, 30.0], (20, 2))

    @staticmethod
    def parabola(x: Floats) -> Floats:
        y: Floats = 1 + x[:, 0] * x[:, 1] - 3 * x[:, 0] ** 2
        return y

    def test_is_the_polynomial_that_explains_all(self) -> None:
        surface = harmos.Surrogate(self.points, self.parabola(self.points), self.model)
        values, deviations = surface([[0.5, 20.0], [0.25, 15.0]])
        numpy.testing.assert_allclose(values, self.parabola(numpy.array([[0.5, 20.0], [0.25, 15.0]])), rtol=1e-6)
        numpy.testing.assert_allclose(deviations, 0.0, atol=1e-6)

    def test_goes_through_its_points_and_is_uncertain_between_them(self) -> None:
        values = numpy.sin(9 * self.points[:, 0])
        surface = harmos.Surrogate(self.points, values, self.model)
        there, deviations = surface(self.points)
        numpy.testing.assert_allclose(there, values, atol=1e-6)
        self.assertGreater(surface([0.5, 30.0])[1][0], 10 * deviations.max())

    def test_knows_where_it_extrapolates(self) -> None:
        surface = harmos.Surrogate(self.points, self.parabola(self.points), self.model)
        self.assertEqual(surface.is_inside([[0.0, 30.0], [1.1, 20.0]]).tolist(), [True, False])


class HistoryTest(TemporaryFolder):
    def test_has_named_columns(self) -> None:
        self.path.write_text("step,time,reaction\n1,0.5,-2e3\n2,1,7\n")
        history = harmos.read_history(self.path)
        self.assertEqual(history["time"].tolist(), [0.5, 1.0])
        self.assertEqual(history["reaction"].tolist(), [-2000.0, 7.0])

    def test_holds_numbers_only(self) -> None:
        self.path.write_text("step,time\n1,one\n")
        with self.assertRaises(ValueError):
            harmos.read_history(self.path)


if __name__ == "__main__":
    unittest.main()
