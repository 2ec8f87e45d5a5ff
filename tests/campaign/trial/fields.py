"""Reads nodal displacements from Harmos's result file."""
from __future__ import annotations

import pathlib

import numpy as np
from scipy.io import netcdf_file
from scipy.spatial import cKDTree

from ..scenes.mesh import Floats, Mesh


def _names(rows: Floats) -> list[str]:
    # After the first zero stands whatever the library had in memory.
    return [row.tobytes().split(b"\0")[0].decode() for row in rows]


def read_displacements(path: pathlib.Path, mesh: Mesh) -> Floats:
    """[step, dof of the mesh], without time 0; parts that were cut have several blocks, PART and PART.n."""
    with netcdf_file(str(path), "r", mmap=False) as file:
        data = file.variables
        places = np.column_stack([data["coord" + axis].data for axis in "xyz"[:mesh.dimension]])
        fields = _names(data["name_nod_var"].data)
        columns = [fields.index("disp_" + axis) + 1 for axis in "xyz"[:mesh.dimension]]
        moved = np.stack([data[f"vals_nod_var{column}"].data for column in columns], axis=2)[1:]
        result = np.zeros((len(moved),) + mesh.nodes.shape)
        for number, name in enumerate(_names(data["eb_names"].data), 1):
            part = next(block for block in mesh.blocks if block.name == name.split(".")[0])
            found = np.unique(data[f"connect{number}"].data) - 1
            nodes = np.unique(part.nodes)
            _, nearest = cKDTree(mesh.nodes[nodes]).query(places[found])
            result[:, nodes[nearest]] = moved[:, found]
    return result.reshape(len(moved), -1)
