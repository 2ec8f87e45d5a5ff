"""Shape functions and joins of the reference against closed forms."""
import unittest

import numpy as np

from .reference.cells import divide, sort_parts
from .reference.elements import elasticity, nodal_volumes, stiffness
from .reference.mortar import join
from .reference.shapes import rule_of, shape_of
from .scenes.mesh import LINEAR, SIDES, Floats

KINDS = tuple(LINEAR) + ("LINE2", "LINE3")


def strip(places: Floats, kind: str, height: float, up: bool) -> tuple[Floats, list[np.ndarray[tuple[int], np.dtype[np.int64]]]]:
    """Nodes and edges along x; up: their normals look upwards."""
    middles = 0.5 * (places[:-1] + places[1:]) if kind == "LINE3" else np.zeros(0)
    nodes = np.column_stack([np.concatenate([places, middles]), np.full(len(places) + len(middles), height)])
    faces = []
    for i in range(len(places) - 1):
        ends = [i + 1, i] if up else [i, i + 1]
        faces.append(np.array(ends + ([len(places) + i] if kind == "LINE3" else []), dtype=np.int64))
    return nodes, faces


class Shapes(unittest.TestCase):
    def test_functions_belong_to_nodes_and_sum_to_one(self) -> None:
        for kind in KINDS:
            shape = shape_of(kind)
            np.testing.assert_allclose(shape.values(shape.nodes), np.eye(len(shape.nodes)), atol=1e-13, err_msg=kind)
            places, _ = rule_of(kind)
            np.testing.assert_allclose(shape.values(places).sum(axis=1), 1, atol=1e-13, err_msg=kind)
            np.testing.assert_allclose(shape.slopes(places).sum(axis=1), 0, atol=1e-12, err_msg=kind)

    def test_slopes_are_derivatives(self) -> None:
        for kind in KINDS:
            shape, step = shape_of(kind), 1e-6
            at = np.full((1, shape.nodes.shape[1]), 0.2)
            for axis in range(at.shape[1]):
                move = step * np.eye(at.shape[1])[axis]
                difference = (shape.values(at + move) - shape.values(at - move)) / (2 * step)
                np.testing.assert_allclose(shape.slopes(at)[:, :, axis], difference, atol=1e-8, err_msg=kind)

    def test_quadratic_displacement_has_its_energy(self) -> None:
        """u_x = x^2 of straight-edged elements: int C_xxxx (2 x)^2 dV by a rule of high degree."""
        for kind in ("TRI6", "QUAD8", "QUAD9", "TET10", "WEDGE15", "HEX20", "HEX27"):
            parent = shape_of(kind).nodes
            nodes = 1.5 * parent + 2.0
            material = elasticity(7.0, 0.3, "3-D" if parent.shape[1] == 3 else "Plane Strain")
            u = np.zeros_like(nodes)
            u[:, 0] = nodes[:, 0] ** 2
            volumes = nodal_volumes(kind, nodes, 1.0)  # exact for quadratic functions
            expected = 4 * material[0, 0] * volumes @ nodes[:, 0] ** 2
            self.assertAlmostEqual(u.ravel() @ stiffness(kind, nodes, material, 1.0) @ u.ravel() / expected, 1, 12, kind)

    def test_sides_have_the_nodes_of_their_corners(self) -> None:
        for kind, linear in LINEAR.items():
            nodes = shape_of(kind).nodes
            for side, corners in zip(SIDES[kind], SIDES[linear]):
                self.assertEqual(side[:len(corners)], corners)
                if len(side) == len(corners):
                    continue
                for i, node in enumerate(side[len(corners):2 * len(corners) if len(corners) > 2 else 3]):
                    ends = [corners[i], corners[(i + 1) % len(corners)]]
                    np.testing.assert_allclose(nodes[node], nodes[ends].mean(axis=0), err_msg=kind)
                if len(side) > 2 * len(corners):
                    np.testing.assert_allclose(nodes[side[-1]], nodes[list(corners)].mean(axis=0), err_msg=kind)


class Joins(unittest.TestCase):
    def test_parts_fill_their_cell(self) -> None:
        for cell in ([[0.0], [2.0]], [[0, 0], [2, 0], [0, 3.0]], [[0, 0], [2, 0.1], [2.2, 3.0], [-0.1, 1]]):
            corners = np.array(cell)
            parts = divide(corners, 5)
            np.testing.assert_allclose(parts.min(axis=(0, 1)), corners.min(axis=0), atol=1e-14)
            np.testing.assert_allclose(parts.max(axis=(0, 1)), corners.max(axis=0), atol=1e-14)

    def test_parts_know_what_they_lie_in(self) -> None:
        square = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
        left, right = square * [0.5, 1], square * [0.25, 1] + [0.5, 0]
        found = sort_parts(square, [left, right], 1e-9, 64)
        self.assertEqual(len(found.mixed), 0)
        self.assertTrue((found.parts[found.owner == 0][:, :, 0] <= 0.5 + 1e-9).all())
        self.assertEqual(found.parts[:, :, 0].max(), 0.75)  # beyond there is nothing

    def test_linear_motions_are_handed_on(self) -> None:
        """Also by partly covered faces, and with a corner of which too little is covered."""
        for own_kind in ("LINE2", "LINE3"):
            for other_kind in ("LINE2", "LINE3"):
                for end, points in ((1.0, 5), (0.7, 4), (0.51, 3)):
                    low, faces1 = strip(np.array([0.0, 0.25, 0.5, 0.75, 1.0]), own_kind, 0.0, True)
                    high, faces2 = strip(end * np.array([0.0, 0.3, 0.4, 1.0]), other_kind, 0.0, False)
                    nodes = np.concatenate([low, high])
                    found = join(faces1, [face + len(low) for face in faces2], nodes, 0.5, None, 64)
                    np.testing.assert_allclose(found.own.sum(axis=1), 1, atol=1e-12)
                    np.testing.assert_allclose(found.other.sum(axis=1), 1, atol=1e-12)
                    np.testing.assert_allclose(found.own @ nodes, found.other @ nodes, atol=1e-9)
                    self.assertAlmostEqual(found.area.sum(), 0.5 * end, 9)
                    self.assertEqual(len(found.area), points)

    def test_one_face_on_another(self) -> None:
        """Equal edges: B selects nodes. An edge against its two halves: int psi N by hand."""
        low, faces1 = strip(np.array([0.0, 1.0]), "LINE2", 0.0, True)
        high, faces2 = strip(np.array([0.0, 0.5, 1.0]), "LINE2", 0.0, False)
        nodes = np.concatenate([low, high])
        found = join(faces1, [face + 2 for face in faces2], nodes, 1.0, None, 64)
        np.testing.assert_allclose(found.own.toarray()[:, :2], np.eye(2), atol=1e-12)
        # psi = 2 - 3 x at the left end; h = 1/2. Columns: 2 int psi N over [0, 1/2], of the hat, over [1/2, 1].
        np.testing.assert_allclose(found.other.toarray()[0, 2:], [0.75, 0.5, -0.25], atol=1e-8)

    def test_quadrature_converges_where_lines_do_not_meet(self) -> None:
        """A square under one that is turned by 30 degrees: linear motions are handed on the better the finer."""
        angle = np.pi / 6
        turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
        square = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
        nodes = np.concatenate([square, 2 * square @ turn.T, [[0, 0, 0.0]]])
        fan = [np.array([4, 8, 5]), np.array([5, 8, 6]), np.array([6, 8, 7]), np.array([7, 8, 4])]
        errors = []
        for finest in (16, 128):
            found = join([np.array([0, 1, 2, 3])], fan, nodes, 1.0, None, finest)
            self.assertAlmostEqual(found.area.sum(), 4.0, 6)
            errors.append(abs(found.other @ nodes - found.own @ nodes).max())
        self.assertLess(errors[1], 1e-3)
        self.assertLess(errors[1], 0.3 * errors[0] + 1e-9)


if __name__ == "__main__":
    unittest.main()
