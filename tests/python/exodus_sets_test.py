"""Sets in mesh files that are written."""
import pathlib
import tempfile
import unittest

import numpy

try:
    import netCDF4

    from harmos.exchange.elements import TYPES
    from harmos.exchange.exodus import write_exodus
    from harmos.exchange.mesh import Block, Mesh
except ImportError:
    netCDF4 = None


@unittest.skipIf(netCDF4 is None, "netCDF4 is not installed")
class SetsTest(unittest.TestCase):
    """write_exodus()"""

    def test_a_set_may_be_empty(self) -> None:
        """Its status says so; entries that nobody has written would be read as elements."""
        nodes = numpy.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
        nothing = numpy.zeros((0, 2), dtype=int)
        mesh = Mesh(2, nodes, [Block("plate", TYPES["QUAD4"], numpy.array([[0, 1, 2, 3]]))],
                    {"empty": nothing, "left": numpy.array([[0, 3]])}, {"none": nothing[:, 0]})
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "plate.e"
            write_exodus(path, mesh)
            with netCDF4.Dataset(path) as file:
                self.assertEqual(file["ss_status"][:].tolist(), [0, 1])
                self.assertEqual(file["ns_status"][:].tolist(), [0])
                self.assertEqual(file["elem_ss2"][:].tolist(), [1])
                self.assertNotIn("elem_ss1", file.variables)
                self.assertNotIn("node_ns1", file.variables)


if __name__ == "__main__":
    unittest.main()
