"""Laws in Python without the program: where graphs meet lines, what is refused, what conformance finds."""
import pathlib
import tempfile
import unittest
from typing import Any

import numpy

from harmos.laws import Law, NoIntersection, bridge, conform, number, resolvent
from harmos.laws.conformance import DoesNotConform

random = numpy.random.default_rng(7)


def lines(count: int, size: float = 1.0) -> tuple[Any, Any]:
    """Free jumps and compliances over six decades."""
    return random.normal(scale=size, size=(count, 3)), 10.0 ** random.uniform(-3.0, 3.0, (count, 1))


class Resolvent(unittest.TestCase):
    def met(self, traction: Any, size: float = 1.0) -> None:
        """The point that is found lies on the line and on the graph."""
        free, compliance = lines(200, size)
        found = resolvent(traction, free, compliance)
        jump = free - compliance * found
        terms = abs(free).sum(1) + compliance[:, 0] * abs(found).sum(1)
        rest = abs(jump + compliance * traction(jump) - free).sum(1)
        self.assertLess((rest / terms).max(), 1e-8)  # slopes carry the round-off of jumps into tractions

    def test_springs_are_met_to_round_off(self) -> None:
        stiffness = numpy.array([1e4, 3.0, 0.0])
        free, compliance = lines(200)
        found = resolvent(lambda jump: stiffness * jump, free, compliance)
        self.assertLess((abs(found - stiffness * free / (1.0 + stiffness * compliance)) * compliance
                         / abs(free).max(1)[:, None]).max(), 1e-13)

    def test_curves_and_kinks(self) -> None:
        self.met(lambda jump: jump * (1.0 + 30.0 * (jump * jump).sum(1, keepdims=True)))
        self.met(lambda jump: numpy.sinh(jump), 1e-3)
        self.met(lambda jump: numpy.exp(jump) - 5.0)
        self.met(lambda jump: jump @ numpy.array([[4.0, 1.0, 0.0], [1.0, 2.0, 0.5], [0.0, 0.5, 1.0]]))
        self.met(lambda jump: jump + numpy.cross(jump, [3.0, 0.0, 0.0]))  # monotone, without a potential

    def test_stiff_contact(self) -> None:
        free, compliance = lines(200)
        stiffness = numpy.where(free < 0.0, 1e6, 1e-2)
        found = resolvent(lambda jump: numpy.where(jump < 0.0, 1e6, 1e-2) * jump, free, compliance)
        expected = stiffness * free / (1.0 + stiffness * compliance)
        self.assertLess((abs(found - expected) / abs(expected).max(1)[:, None]).max(), 1e-9)

    def test_jumps_of_the_graph(self) -> None:
        free, compliance = lines(200)
        found = resolvent(lambda jump: numpy.sign(jump) * 0.3 + 0.1 * jump, free, compliance)
        slips = (abs(free) - 0.3 * compliance) / (1.0 + 0.1 * compliance)
        expected = numpy.where(slips > 0.0, numpy.sign(free) * (0.3 + 0.1 * slips), free / compliance)
        self.assertLess((abs(found - expected) * compliance / abs(free)).max(), 1e-8)

    def test_what_is_no_number_is_handed_on(self) -> None:
        free = numpy.array([[numpy.nan, 1.0, 2.0], [1.0, 1.0, 1.0]])
        found = resolvent(lambda jump: jump, free, numpy.ones((2, 1)))
        self.assertTrue(numpy.isnan(found[0, 0]))
        self.assertTrue((found[1] == 0.5).all())

    def test_no_point(self) -> None:
        with self.assertRaises(NoIntersection) as caught:
            resolvent(lambda jump: numpy.asarray(numpy.where(jump > 1.0, numpy.nan, jump)),
                      numpy.array([[0.0, 0.0, 0.0], [9.0, 0.0, 0.0]]), numpy.ones((2, 1)))
        self.assertEqual(caught.exception.point, 1)


class Spring(Law):
    """A spring."""

    name = "Spring"
    parameters = (number("Stiffness", "k.", default=2.0),)

    def __init__(self, p: Any) -> None:
        self.stiffness = p["Stiffness"]

    def traction(self, jump: Any, old: Any, at: Any) -> Any:
        return numpy.asarray(self.stiffness * jump)


def law(**members: Any) -> type[Law]:
    """The spring with something else."""
    return type("Other", (Spring,), {"__doc__": "Another one.", **members})


class Conformance(unittest.TestCase):
    def test_laws_that_are_right(self) -> None:
        conform(Spring, {"Stiffness": 10.0})
        conform(Spring)

    def found(self, words: str, **members: Any) -> None:
        with self.assertRaises(DoesNotConform) as caught:
            conform(law(**members))
        self.assertIn(words, str(caught.exception))

    def test_faults_are_found(self) -> None:
        self.found("falls", traction=lambda self, jump, old, at: -0.4 * jump, lowest_slope=-0.2)
        self.found("the traction falls", traction=lambda self, jump, old, at: -2.0 * jump)
        self.found("when others are asked", solve=lambda self, free, compliance, old, at:
                   free / (1.0 + compliance) / len(free))
        self.found("does not solve for one graph", solve=lambda self, free, compliance, old, at: 0.5 * free)
        self.found("another history", history=1,
                   update=lambda self, jump, traction, old, at: old + abs(jump).sum() / len(jump))
        calls = iter(range(1000))
        self.found("two tractions", solve=lambda self, free, compliance, old, at:
                   (1.0 + 1e-3 * next(calls)) * free / (1.0 + compliance))

    def test_softening_that_is_declared(self) -> None:
        conform(law(traction=lambda self, jump, old, at: -0.2 * jump, lowest_slope=-0.2))

    def test_parameters(self) -> None:
        with self.assertRaisesRegex(KeyError, "no parameter 'Stifness'"):
            conform(Spring, {"Stifness": 1.0})


class Shapes(unittest.TestCase):
    def asked(self, **members: Any) -> Any:
        at: Any = None
        known = law(**members)
        bridge.check_declaration(known)
        return bridge.solved(bridge.made(known, {"Stiffness": 1.0}), at, numpy.ones((4, 3)), numpy.ones((4, 1)),
                             numpy.zeros((4, known.history)))

    def test_are_named(self) -> None:
        def gives(value: Any) -> Any:
            return lambda self, *rest: value

        for words, members in (
                (r"solve\(\) gives an array of shape \(3,\), and must give \(4, 3\)", {"solve": gives(numpy.ones(3))}),
                (r"traction\(\) gives an array of shape", {"solve": Law.solve, "traction": gives(numpy.ones((4, 2)))}),
                (r"update\(\) gives .* must give \(4, 2\)", {"history": 2, "update": gives(numpy.ones((4, 1)))}),
                (r"solve\(\) gives NoneType", {"solve": gives(None)}),
                (r"solve\(\) gives ndarray of complex128", {"solve": gives(numpy.ones((4, 3)) * 1j)}),
                (r"status\(\) gives", {"status": gives(numpy.full(4, 7))}),
                ("has no update", {"history": 1}),
                ("`history` is 'two'", {"history": "two"}),
                ("`lowest_slope` is 1.0", {"lowest_slope": 1.0}),
                ("`sides` is 'three'", {"sides": "three"}),
                ("no docstring", {"__doc__": None}),
                ("no output", {"outputs": ("x",)})):
            with self.subTest(words), self.assertRaisesRegex((TypeError, ValueError), words):
                self.asked(**members)

    def test_what_is_handed_over_is_a_copy(self) -> None:
        def spoils(self: Any, free: Any, compliance: Any, old: Any, at: Any) -> Any:
            free *= 0.0
            return free

        traction, _, status = self.asked(solve=spoils)
        self.assertTrue((traction == 0.0).all() and (status == 3).all())

    def test_tractions_may_spoil_what_they_are_given_and_fill_one_array_again(self) -> None:
        kept = numpy.zeros((4, 3))

        def spoils(self: Any, jump: Any, old: Any, at: Any) -> Any:
            jump *= 2.0
            old += 1.0
            numpy.multiply(jump, old, out=kept)
            return kept

        def update(self: Any, jump: Any, traction: Any, old: Any, at: Any) -> Any:
            return numpy.ones((4, 3))

        traction, _, _ = self.asked(solve=Law.solve, traction=spoils, history=3, update=update)
        numpy.testing.assert_allclose(traction, 2.0 / 3.0)  # t = 2 delta on delta = 1 - t


class Files(unittest.TestCase):
    def loaded(self, text: str) -> Any:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "laws.py"
            path.write_text(text)
            try:
                return bridge.load(str(path))
            except Exception as error:
                return bridge.reason(error, str(path))

    def test_laws_in_their_order_and_no_others(self) -> None:
        text = ("from harmos.laws import Law\nclass Base(Law):\n    def traction(self, jump, old, at):\n        return jump\n"
                "class B(Base):\n    'b'\n    name = 'B'\nclass A(Base):\n    'a'\n    name = 'A'\n")
        self.assertEqual([each.name for each in self.loaded(text)], ["B", "A"])

    def test_what_is_wrong_is_said_with_its_line(self) -> None:
        self.assertEqual(self.loaded("x = 1\nclass (:\n"), "SyntaxError: invalid syntax (laws.py, line 2)")
        self.assertEqual(self.loaded("\n\nx = 1 / 0\n"), "ZeroDivisionError: division by zero (laws.py, line 3)")
        self.assertIn("no class in it is derived", self.loaded("x = 1\n"))


if __name__ == "__main__":
    unittest.main()
