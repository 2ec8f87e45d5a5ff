"""Names of variables in files of results."""
import pathlib
import tempfile
import unittest

import numpy

from harmos.exodus_fields import read_fields

try:
    import netCDF4
except ImportError:
    netCDF4 = None


@unittest.skipIf(netCDF4 is None, "netCDF4 is not installed")
class NamesTest(unittest.TestCase):
    """read_fields()"""

    def test_names_end_with_their_zero(self) -> None:
        """The Exodus library does not clear what stands behind it."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "points.e"
            with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as file:
                for name, size in (("time_step", 1), ("num_nodes", 2), ("len_name", 12), ("num_nod_var", 1)):
                    file.createDimension(name, size)
                file.createVariable("time_whole", "f8", ("time_step",))[:] = 0.5
                file.createVariable("coordx", "f8", ("num_nodes",))[:] = (0.0, 1.0)
                names = file.createVariable("name_nod_var", "S1", ("num_nod_var", "len_name"))
                names[0] = numpy.array(list("disp_x\0left over"[:12]), "S1")
                file.createVariable("vals_nod_var1", "f8", ("time_step", "num_nodes"))[:] = (3.0, 4.0)
            numpy.testing.assert_array_equal(read_fields(path).at_nodes("disp_x", step=-1), (3.0, 4.0))


if __name__ == "__main__":
    unittest.main()
