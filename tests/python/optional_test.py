"""What is said where a package is missing that only some functions need."""
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import numpy

import harmos
import small_study
from harmos.optional import demand_package
from harmos.tables import frame_of


class OptionalPackageTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def expect(self, name: str) -> "unittest.case._AssertRaisesContext[ImportError]":
        hidden = mock.patch.dict(sys.modules, {name: None})
        hidden.start()
        self.addCleanup(hidden.stop)
        return self.assertRaisesRegex(ImportError, f"^{name} is not installed.*pip install {name},.*"
                                                   f"python3-{name.lower()} of Debian$")

    def test_tables_name_pandas(self) -> None:
        with self.expect("pandas"):
            frame_of(numpy.zeros(2, [("step", int), ("F", float)]), "step")

    def test_datasets_name_xarray(self) -> None:
        small_study.write(self.path / "joint.h5")
        study = harmos.read_study(self.path / "joint.h5")
        with self.expect("xarray"):
            study.dataset()

    def test_fields_name_netcdf4_and_not_damage(self) -> None:
        (self.path / "joint.e").write_bytes(b"CDF\1" + bytes(60))
        with mock.patch("harmos.exodus_fields.demand_complete"), self.expect("netCDF4"):
            harmos.read_fields(self.path / "joint.e")

    def test_what_the_package_itself_lacks_is_left_as_it_is(self) -> None:
        (self.path / "half.py").write_text("import nowhere_to_be_found\n", encoding="ascii")
        with mock.patch.object(sys, "path", [str(self.path), *sys.path]):
            with self.assertRaisesRegex(ModuleNotFoundError, "nowhere_to_be_found"):
                demand_package("half")


if __name__ == "__main__":
    unittest.main()
