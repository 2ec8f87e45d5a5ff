"""Fields of result files as arrays of numpy and xarray, without VTK.

    fields = harmos.read_fields("results/bolted_joint.e")
    fields.times, fields.nodes, fields.blocks["centre"]
    fields.at_nodes("disp_x", step=-1), fields.vectors("disp_")
    fields.at_elements("stress_xx", "centre")
    fields.dataset()["disp_x"]
"""
import os
from typing import Any

import numpy

from harmos.arrays import Floats, Integers
from harmos.classic import demand_complete
from harmos.foreign import read_foreign
from harmos.optional import demand_package


class Fields:
    """An Exodus file of results: its mesh at once, its fields when they are asked for.

    Attributes:
        path: of the file.
        times: of the steps, the first one unloaded, [t].
        nodes: undeformed coordinates, [n, dimension].
        blocks: by name: the nodes of the elements, counted from 0, [element, node].
        nodal: names of the fields at nodes.
        elements: names of the fields of elements.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """See read_fields()."""
        self.path = os.fspath(path)
        self.times: Floats
        self.nodes: Floats
        self.blocks: dict[str, Integers]
        self.nodal: list[str]
        self.elements: list[str]
        demand_complete(path)
        demand_package("netCDF4")  # in a child process it would look like damage
        self.times, self.nodes, self.blocks, self.nodal, self.elements = read_foreign(path, self._read_mesh)

    def at_nodes(self, name: str, step: int | None = -1) -> Floats:
        """Values of a nodal field at a step, counted from 0, or with negative numbers from the end, [n]; with None at
        all of them, [t, n].

        Raises:
            KeyError: there is no such field.
            IndexError: there is no such step.
        """
        number = _index(name, self.nodal) + 1
        rows = self._steps(step)
        return read_foreign(self.path, lambda: self._variable(f"vals_nod_var{number}", rows))

    def vectors(self, name: str, step: int | None = -1) -> Floats:
        """The components NAMEx, NAMEy, NAMEz of a nodal field as one array, [n, component] or [t, n, component]."""
        return numpy.stack([self.at_nodes(name + axis, step) for axis in "xyz" if name + axis in self.nodal], axis=-1)

    def at_elements(self, name: str, block: str, step: int | None = -1) -> Floats:
        """Values of a field of the elements of a block at a step, [element], or with None at all, [t, element].

        Raises:
            KeyError: there is no such field or block.
            IndexError: there is no such step.
        """
        number = _index(name, self.elements) + 1
        place = _index(block, list(self.blocks)) + 1
        rows = self._steps(step)
        return read_foreign(self.path, lambda: self._variable(f"vals_elem_var{number}eb{place}", rows))

    def dataset(self) -> Any:
        """All nodal fields as a Dataset of xarray with the dimensions time and node, and x, y, z as coordinates.

        Raises:
            ImportError: xarray is not installed.
        """
        coordinates: dict[str, Any] = {axis: ("node", self.nodes[:, i])
                                       for i, axis in enumerate("xyz"[:self.nodes.shape[1]])}
        variables = {name: (("time", "node"), self.at_nodes(name, None)) for name in self.nodal}
        return demand_package("xarray").Dataset(variables, coords={"time": self.times, **coordinates})

    def _steps(self, step: int | None) -> Any:
        if step is None:
            return slice(None)
        if not -len(self.times) <= step < len(self.times):
            raise IndexError(f"{self.path} has no step {step}; it has 0 (unloaded) to {len(self.times) - 1}")
        return step % len(self.times)

    def _variable(self, name: str, rows: Any) -> Floats:
        with _open(self.path) as file:
            return numpy.asarray(file.variables[name][rows], float)

    def _read_mesh(self) -> tuple[Floats, Floats, dict[str, Integers], list[str], list[str]]:
        with _open(self.path) as file:
            variables = file.variables
            axes = ["coord" + axis for axis in "xyz" if "coord" + axis in variables]
            nodes = numpy.stack([numpy.asarray(variables[axis][:], float) for axis in axes], axis=1)
            blocks: dict[str, Integers] = {name: numpy.asarray(variables[f"connect{number}"][:], int) - 1
                      for number, name in enumerate(_names(variables, "eb_names"), 1)}
            times = numpy.asarray(variables["time_whole"][:], float)
            return (times, nodes, blocks,
                    _names(variables, "name_nod_var"), _names(variables, "name_elem_var"))


def read_fields(path: str | os.PathLike[str]) -> Fields:
    """An Exodus file of results.

    Raises:
        OSError: it cannot be read.
        ValueError: it is damaged or no Exodus file.
        ImportError: netCDF4 is not installed.
    """
    return Fields(path)


def _open(path: str) -> Any:
    file = demand_package("netCDF4").Dataset(path)
    file.set_auto_mask(False)
    return file


def _names(variables: Any, name: str) -> list[str]:
    if name not in variables:
        return []
    # After the zero that ends a name stands whatever the Exodus library had in memory.
    return [row.tobytes().split(b"\0")[0].decode() for row in variables[name][:]]


def _index(name: str, names: list[str]) -> int:
    if name not in names:
        raise KeyError(f"\"{name}\" is none of {', '.join(names)}")
    return names.index(name)
