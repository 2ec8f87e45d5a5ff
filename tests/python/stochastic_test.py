"""Expansions and statistics of studies with random parameters."""
import unittest
import uuid
from typing import Any

import h5py
import numpy

import harmos

NONE = float("nan")


def new_group() -> h5py.Group:
    """Of a file that exists in memory only."""
    return h5py.File(uuid.uuid4().hex, "w", driver="core", backing_store=False).create_group("group")


def add_germ(group: h5py.Group, **attributes: Any) -> h5py.Group:
    """A normal germ with the polynomials of Hermite up to degree 3."""
    group.attrs.update({"germ": "Normal", "map": "affine", "shift": 500.0, "scale": 100.0, **attributes})
    group["recurrence_a"], group["recurrence_b"] = numpy.zeros(4), [1.0, 1.0, 2.0, 3.0]
    group["germ_levels"], group["germ_quantiles"] = [0.25, 0.5, 0.75], [-1.0, 0.0, 2.0]
    return group


def add_basis(group: h5py.Group, **attributes: Any) -> h5py.Group:
    """All products of two germs up to degree 2."""
    group.attrs["order"] = 2
    group["degrees"] = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]]
    add_germ(group.create_group("k"), **attributes)
    add_germ(group.create_group("mu"), map="exponential", shift=-1.0, scale=0.5)
    return group


class GermTest(unittest.TestCase):
    def test_has_orthonormal_polynomials(self) -> None:
        x = numpy.array([-1.5, 0.0, 2.0])
        expected = [numpy.ones(3), x, (x ** 2 - 1) / numpy.sqrt(2), (x ** 3 - 3 * x) / numpy.sqrt(6)]
        germ = harmos.Germ(add_germ(new_group()))
        numpy.testing.assert_allclose(germ.polynomials(x), numpy.transpose(expected), atol=1e-14)

    def test_follows_from_the_parameter(self) -> None:
        self.assertEqual(harmos.Germ(add_germ(new_group())).of([400.0, 650.0]).tolist(), [-1.0, 1.5])
        lognormal = harmos.Germ(add_germ(new_group(), map="exponential", shift=1.0, scale=2.0))
        self.assertAlmostEqual(float(lognormal.of(numpy.exp(4.0))), 1.5)
        self.assertEqual(harmos.Germ(add_germ(new_group(), scale=0.0)).of([500.0]).tolist(), [0.0])

    def test_is_drawn_from_its_law(self) -> None:
        def sample(law: str) -> Any:
            return harmos.Germ(add_germ(new_group(), germ=law)).sample(10000, numpy.random.default_rng(1))
        self.assertAlmostEqual(sample("Normal").std(), 1.0, delta=0.02)
        self.assertAlmostEqual(sample("Uniform").std(), 1 / numpy.sqrt(3), delta=0.01)
        self.assertEqual(set(sample("Sample")), {-1.0, 0.0, 2.0})
        self.assertAlmostEqual((sample("Beta") < 1.0).mean(), 0.625, delta=0.02)  # between the quantiles: linear


class ExpansionTest(unittest.TestCase):
    def setUp(self) -> None:
        self.basis = harmos.Basis(add_basis(new_group()), ["k", "mu"], True)
        self.expansion = harmos.Expansion(self.basis, numpy.array([7.0, 3.0, 0.0, 0.0, 4.0, 0.0]))

    def test_is_the_sum_of_its_terms(self) -> None:
        self.assertEqual(self.expansion.evaluate([[0.5, -2.0], [0.0, 1.0]]).tolist(), [7 + 1.5 - 4, 7])
        at = self.expansion(k=[600.0, 500.0], mu=numpy.exp(-1.5))
        numpy.testing.assert_allclose(at, [7 + 3 - 4, 7], rtol=1e-14)

    def test_has_moments(self) -> None:
        self.assertEqual((self.expansion.mean, self.expansion.standard_deviation), (7.0, 5.0))
        sample = self.expansion.sample(100000, seed=1)
        self.assertAlmostEqual(sample.mean(), 7.0, delta=0.1)
        self.assertAlmostEqual(sample.std(), 5.0, delta=0.1)
        self.assertEqual(sample.tolist(), self.expansion.sample(100000, seed=1).tolist())

    def test_needs_all_parameters(self) -> None:
        with self.assertRaisesRegex(ValueError, "give values of k, mu"):
            self.expansion(k=500.0)

    def test_of_correlated_parameters_needs_germs(self) -> None:
        basis = harmos.Basis(add_basis(new_group(), map="none"), ["k", "mu"], False)
        with self.assertRaisesRegex(ValueError, r"k: correlated parameters do not tell their germs; use evaluate\("):
            basis.germs_of(k=500.0, mu=0.3)


class StatisticsTest(unittest.TestCase):
    def group(self, mean_error: float, **attributes: Any) -> h5py.Group:
        """Of a study with one response, and attributes besides those that were there from the beginning."""
        group = new_group()
        group.attrs.update({"method": "words", "variables": ["k", "mu"], "distributions": ["one", "two"],
                            "independent": 1, "solved": 9, "inadmissible": 2, **attributes})
        group["levels"] = [0.5]
        group.create_group("responses").attrs["order"] = ["F"]
        response = group["responses"].create_group("F")
        response.attrs.update(mean=1.0, standard_deviation=2.0, skewness=0.0, kurtosis=3.0, mean_error=mean_error,
                              standard_deviation_error=NONE, truncation=NONE, hold_out_error=NONE)
        for name in ("quantiles", "values", "density", "cumulative"):
            response[name] = [0.5]
        response["sobol_sets"], response["sobol_main"], response["sobol_total"] = ["k", "k*mu"], [0.7, 0.3], [1.0, 0.3]
        return group

    def test_hold_what_was_written(self) -> None:
        statistics = harmos.Statistics(self.group(NONE))
        self.assertEqual((statistics.solved, statistics.inadmissible, statistics.independent), (9, 2, True))
        self.assertEqual(statistics.responses["F"].sobol, {"k": (0.7, 1.0), "k*mu": (0.3, 0.3)})
        self.assertIsNone(statistics.sweep)

    def test_say_whether_they_are_those_of_a_sample(self) -> None:
        self.assertTrue(harmos.Statistics(self.group(NONE, sample=1)).is_sample)
        self.assertFalse(harmos.Statistics(self.group(0.1, sample=0)).is_sample)

    def test_of_old_files_tell_samples_by_their_errors(self) -> None:
        self.assertTrue(harmos.Statistics(self.group(0.1)).is_sample)
        self.assertFalse(harmos.Statistics(self.group(NONE)).is_sample)  # of an interpolation
        expanded = self.group(0.1)
        expanded["convergence/size"] = [1, 2]
        expanded["convergence/mean"] = expanded["convergence/standard_deviation"] = [[1.0], [1.5]]
        statistics = harmos.Statistics(expanded)
        self.assertFalse(statistics.is_sample)
        assert statistics.convergence is not None
        self.assertEqual(statistics.convergence.mean["F"].tolist(), [1.0, 1.5])

    def test_name_the_expansions_that_there_are(self) -> None:
        with self.assertRaisesRegex(ValueError, r"there is no expansion of F; there are: \[\]"):
            harmos.Statistics(self.group(NONE)).expansion("F")
        group = self.group(NONE)
        add_basis(group.create_group("basis"))
        group["responses/F/coefficients"] = [1.0, 2.0, 0.0, 0.0, 0.0, 0.0]
        self.assertEqual(harmos.Statistics(group).expansion("F")(k=600.0, mu=0.3).tolist(), [3.0])


if __name__ == "__main__":
    unittest.main()
