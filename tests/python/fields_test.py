"""Names, steps and scales of what pictures show."""
import unittest

from harmos import fields

CONTENTS = fields.Contents(times=[0.0, 1.0, 2.0], nodal=["disp_"], element=["stress_xx", "von_mises"],
                           surface=["contact_pressure", "safety_slip", "disp_"], title="", units="")


class FieldTest(unittest.TestCase):
    """fields.field()"""

    def test_short_names_stand_for_variables(self) -> None:
        """Stress at the nodes wins where there is one."""
        self.assertEqual(fields.field("von_mises", CONTENTS), fields.Field("von_mises", "elements"))
        both = fields.Contents([0.0], ["disp_", "nodal_von_mises"], ["von_mises"], [], "", "")
        self.assertEqual(fields.field("von_mises", both), fields.Field("nodal_von_mises", "nodes"))
        self.assertEqual(fields.field("pressure", CONTENTS), fields.Field("contact_pressure", "interfaces"))
        self.assertEqual(fields.field("stress_xx", CONTENTS), fields.Field("stress_xx", "elements"))

    def test_unknown_names_are_refused_with_the_nearest(self) -> None:
        """And those that the result has not."""
        with self.assertRaisesRegex(ValueError, 'Did you mean "pressure"'):
            fields.field("presure", CONTENTS)
        with self.assertRaisesRegex(ValueError, "no field \"gaping\""):
            fields.field("gaping", CONTENTS)

    def test_limits_of_safeties_do_not_depend_on_values(self) -> None:
        """1 is always red."""
        self.assertEqual(fields.Field("safety_slip", "interfaces").limits(1.3, 1000.0), (1.0, fields.SAFE))
        self.assertEqual(fields.Field("stress_xx", "elements").limits(-2.0, 3.0), (-2.0, 3.0))
        self.assertEqual(fields.Field("von_mises", "elements").limits(1.0, 3.0), (0.0, 3.0))
        self.assertEqual(fields.Field("von_mises", "elements").limits(0.0, 0.0), (0.0, 1.0))


class StepTest(unittest.TestCase):
    """fields.step()"""

    def test_counts_from_the_unloaded_start_and_from_the_end(self) -> None:
        """As slices do."""
        self.assertEqual([fields.step(i, CONTENTS) for i in (None, 0, 2, -1, -3)], [2, 0, 2, 2, 0])

    def test_refuses_what_is_not_there(self) -> None:
        """In both directions."""
        for number in (3, -4):
            with self.assertRaisesRegex(ValueError, "0 \\(unloaded\\) to 2"):
                fields.step(number, CONTENTS)


class ScaleTest(unittest.TestCase):
    """fields.visible_scale()"""

    def test_is_round_and_makes_displacements_a_twentieth_of_the_size(self) -> None:
        """At most; and never makes them smaller."""
        self.assertEqual(fields.visible_scale(100.0, 0.024), 200.0)
        self.assertEqual(fields.visible_scale(100.0, 0.05), 100.0)
        self.assertEqual(fields.visible_scale(100.0, 2.0), 2.0)
        self.assertEqual(fields.visible_scale(100.0, 50.0), 1.0)
        self.assertEqual(fields.visible_scale(100.0, 0.0), 1.0)


if __name__ == "__main__":
    unittest.main()
