#!/usr/bin/env python3
"""Tries packages.py on small trees, each with one mistake."""
import pathlib
import tempfile
import unittest

from packages import Packages

SOUND = {
    "packages/CMakeLists.txt": "set(HARMOS_PACKAGES\n    base mesh solver)\n",
    "packages/base/CMakeLists.txt": "harmos_package(base PUBLIC Harmos::trilinos)\n",
    "packages/base/Error.hpp": "",
    "packages/mesh/CMakeLists.txt": "# USES solver\nharmos_package(mesh USES base\n  PRIVATE Harmos::metis)\n",
    "packages/mesh/Mesh.hpp": "#include <harmos/base/Error.hpp>\n",
    "packages/mesh/Mesh.cpp": "#include <harmos/mesh/Mesh.hpp>\n#include <harmos/mesh/detail/Weights.hpp>\n",
    "packages/mesh/detail/Weights.hpp": "",
    "packages/solver/CMakeLists.txt": "harmos_package(solver USES base mesh)\n",
    "packages/solver/Solver.hpp": "#include <harmos/mesh/Mesh.hpp>\n",
    "tests/SolverTest.cpp": "#include <harmos/solver/Solver.hpp>\n#include <harmos/mesh/detail/Weights.hpp>\n",
}


class PackagesTest(unittest.TestCase):
    def packages(self, changes):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in {**SOUND, **changes}.items():
            path = pathlib.Path(folder.name, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return Packages(pathlib.Path(folder.name))

    def check(self, changes, *expected):
        self.assertEqual(list(self.packages(changes).errors()), list(expected))

    def test_sound(self):
        self.check({})
        self.assertEqual(list(self.packages({}).text()),
                         ["base: nothing", "mesh: base 1", "solver: mesh 1; only through headers: base"])

    def test_outside_the_row(self):
        self.check({"packages/solver/CMakeLists.txt": "harmos_package(solver USES base)\n"},
                   "packages/solver/Solver.hpp: includes <harmos/mesh/Mesh.hpp>, but the row of solver does not name mesh")

    def test_order(self):
        self.check({"packages/CMakeLists.txt": "set(HARMOS_PACKAGES mesh base solver)\n"},
                   "mesh: its row names base, which is not above it in HARMOS_PACKAGES")

    def test_needless_row(self):
        self.check({"packages/mesh/Mesh.hpp": "", "tests/ErrorTest.cpp": "#include <harmos/base/Error.hpp>\n"},
                   "mesh: its row names base, but no file needs it", "solver: its row names base, but no file needs it")

    def test_detail_of_another_package(self):
        self.check({"packages/solver/Solver.cpp": "#include <harmos/mesh/detail/Weights.hpp>\n"},
                   "packages/solver/Solver.cpp: includes <harmos/mesh/detail/Weights.hpp>, a detail of mesh")

    def test_detail_in_a_public_header(self):
        self.check({"packages/mesh/Mesh.hpp":
                    "#include <harmos/base/Error.hpp>\n#include <harmos/mesh/detail/Weights.hpp>\n"},
                   "packages/mesh/Mesh.hpp: a public header includes <harmos/mesh/detail/Weights.hpp>")

    def test_circle_between_pairs(self):
        self.check({"packages/mesh/detail/Weights.cpp": "#include <harmos/mesh/Mesh.hpp>\n"},
                   "circle: mesh/Mesh -> mesh/Weights -> mesh/Mesh")

    def test_header_that_nobody_includes(self):
        self.check({"packages/mesh/Private.hpp": "", "packages/mesh/Private.cpp": "#include <harmos/mesh/Private.hpp>\n"},
                   "packages/mesh/Private.hpp: only mesh itself includes it, it belongs into detail/")

    def test_missing_header(self):
        self.check({"packages/solver/Solver.cpp": "#include <harmos/mesh/Gone.hpp>\n"},
                   "packages/solver/Solver.cpp: there is no <harmos/mesh/Gone.hpp>")


if __name__ == "__main__":
    unittest.main()
