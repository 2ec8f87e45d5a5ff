"""Elements of the reference: rigid motions, patches, volumes."""
import unittest

import numpy as np

from .reference.elements import elasticity, nodal_volumes, stiffness

CORNERS = {
    "TRI3": np.array([[0, 0], [2, 0.3], [0.4, 1.5]]),
    "QUAD4": np.array([[0, 0], [2, 0.3], [2.4, 1.8], [0.2, 1.1]]),
    "TET4": np.array([[0, 0, 0], [1, 0.1, 0], [0.2, 1.3, 0], [0.1, 0.3, 0.9]]),
    "HEX8": np.array([[0, 0, 0], [1, 0, 0.1], [1.2, 1, 0], [0, 1.1, 0],
                      [0, 0.1, 1], [1, 0, 1.2], [1.1, 1, 1], [0, 1, 1]]),
}


def material(kind: str, kinematics: str = "Plane Strain") -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    return elasticity(7.0, 0.3, "3-D" if kind in ("TET4", "HEX8") else kinematics)


class Elements(unittest.TestCase):
    def test_rigid_motions_need_no_force(self) -> None:
        for kind, x in CORNERS.items():
            turned = np.zeros_like(x)
            turned[:, 0], turned[:, 1] = -x[:, 1], x[:, 0]
            for motion in (np.ones_like(x), turned):
                force = stiffness(kind, x, material(kind), 1.0) @ motion.ravel()
                self.assertLess(abs(force).max(), 1e-13, kind)

    def test_uniform_strain_has_its_energy(self) -> None:
        strain = np.array([[0.2, 0.1, -0.3], [0.1, -0.5, 0.4], [-0.3, 0.4, 0.7]])
        for kind, x in CORNERS.items():
            d = x.shape[1]
            e = strain[:d, :d]
            voigt = [e[0, 0], e[1, 1], 2 * e[0, 1]] if d == 2 else [*np.diag(e), 2 * e[0, 1], 2 * e[1, 2], 2 * e[2, 0]]
            u = (x @ e).ravel()
            density = np.array(voigt) @ material(kind) @ np.array(voigt)
            volume = nodal_volumes(kind, x, 0.5).sum()
            self.assertAlmostEqual(u @ stiffness(kind, x, material(kind), 0.5) @ u, density * volume, 12, kind)

    def test_plane_stress_has_no_stress_across(self) -> None:
        plane, space = elasticity(7.0, 0.3, "Plane Stress"), elasticity(7.0, 0.3, "3-D")
        across = -space[2, :2] @ np.array([0.1, 0.2]) / space[2, 2]
        expected = space[:2, :3] @ np.array([0.1, 0.2, across])
        np.testing.assert_allclose(plane[:2, :2] @ np.array([0.1, 0.2]), expected, rtol=1e-13)

    def test_element_turned_inside_out_is_refused(self) -> None:
        with self.assertRaises(ValueError):
            stiffness("TRI3", CORNERS["TRI3"][::-1], material("TRI3"), 1.0)


if __name__ == "__main__":
    unittest.main()
