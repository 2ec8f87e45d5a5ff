"""Scenes: the same from the same seed, sound meshes, files that say the same."""
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree as xml

import numpy as np
from scipy.io import netcdf_file

from .reference.elements import nodal_volumes
from .reference.laws import conditions
from .reference.problem import assemble
from .reference.solver import solve
from .reference.surfaces import nodal_areas
from .scenes.classes import APART, CLASSES, MATCHING, make_scene, make_twin
from .scenes.lattice import Lattice
from .scenes.mesh import LINEAR
from .scenes.restatements import RESTATEMENTS
from .scenes.scene_file import scene_element, write_scene

SEEDS = range(6)


class Scenes(unittest.TestCase):
    def test_class_and_seed_say_all(self) -> None:
        for name in CLASSES:
            first, again, other = (xml.tostring(scene_element(make_scene(name, seed))) for seed in (3, 3, 4))
            self.assertEqual(first, again, name)
            self.assertNotEqual(first, other, name)

    def test_scenes_are_sound(self) -> None:
        for name in CLASSES:
            for seed in SEEDS if name in MATCHING else SEEDS[:1]:
                with self.subTest(name=name, seed=seed):
                    scene = make_scene(name, seed)
                    self.assertLessEqual(len(scene.mesh.nodes), 1000)
                    problem = assemble(scene)  # refuses folded elements and sides that do not conform
                    self.assertLess(abs(problem.stiffness - problem.stiffness.T).max(), 1e-9 * problem.stiffness.max())
                    for joint in scene.joints:
                        for condition in conditions(joint.law, scene.mesh.dimension, scene.steps):
                            self.assertTrue(np.isfinite(condition.values).all())

    def test_normals_of_a_part_look_out_of_it(self) -> None:
        """The volume of a part by its faces is that by its elements, with every type of element."""
        for kind in LINEAR:
            lines = [[0.0, 1.0, 3.0], [0.0, 0.5, 2.0], [0.0, 1.0, 1.5]][:2 if kind.startswith(("QUAD", "TRI")) else 3]
            lattice = Lattice(lines)
            lattice.fill("body")
            turned = np.array([[1.0, 0.4, 0.1], [-0.3, 1.0, 0.2], [0.1, -0.2, 1.1]])[:len(lines), :len(lines)]
            mesh = lattice.build({"body": kind}, lambda x: np.asarray(x @ turned.T))
            flux = 0.0
            for axis in range(len(lines)):
                for end in (0, 1):
                    areas = nodal_areas(mesh, lattice.outer(f"{axis}{end}", "body", axis, end), 1.0)
                    flux += float((mesh.nodes[areas.nodes] * areas.flux).sum())
            volume = sum(nodal_volumes(kind, mesh.nodes[nodes], 1.0).sum() for nodes in mesh.blocks[0].nodes)
            self.assertAlmostEqual(flux / len(lines), volume, 10, kind)

    def test_twins_match(self) -> None:
        for name in APART:
            scene, twin = make_scene(name, 2), make_twin(name, 2)
            assert twin is not None
            self.assertTrue(all(joint.points_on is None for joint in twin.joints))
            self.assertEqual([j.law for j in scene.joints if j.side2], [j.law for j in twin.joints if j.side2])
            assemble(twin)  # refuses sides that do not conform

    def test_restatements_say_the_same(self) -> None:
        for name in ("laps", "strips"):
            scene = make_scene(name, 1)
            own = solve(scene)
            self.assertTrue(own.determined)
            for kind, restate in RESTATEMENTS.items():
                restated = restate(scene, np.random.default_rng(1))
                answer = solve(restated.scene)
                for response in own.determined:
                    expected = restated.factors[response] * own.values[response]
                    tolerance = 1e-6 * abs(restated.factors[response]) * own.sizes[response]
                    np.testing.assert_allclose(answer.values[response], expected, rtol=0.0, atol=tolerance,
                                               err_msg=f"{name} {kind}")

    def test_files(self) -> None:
        scene = make_scene("laps", 1)
        with tempfile.TemporaryDirectory() as folder:
            path = write_scene(scene, pathlib.Path(folder) / "scene")
            root = xml.parse(path).getroot()
            with netcdf_file(str(path.parent / "mesh.e"), "r", mmap=False) as file:
                np.testing.assert_array_equal(file.variables["coordx"].data, scene.mesh.nodes[:, 0])
                np.testing.assert_array_equal(file.variables["connect1"].data, scene.mesh.blocks[0].nodes + 1)
        lists = {element.get("name"): element for element in root}
        self.assertEqual([element.get("name") for element in lists["Parts"]], [part.name for part in scene.parts])
        self.assertEqual(len(lists["Interfaces"]) + len(lists["Boundaries"]), len(scene.joints))


if __name__ == "__main__":
    unittest.main()
