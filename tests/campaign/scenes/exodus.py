"""Writes meshes as Exodus II files in netCDF's classic format."""
from __future__ import annotations

import pathlib

import numpy as np
from scipy.io import netcdf_file

from .mesh import Mesh

NAME_LENGTH = 33


def _text(names: list[str]) -> np.ndarray[tuple[int, int], np.dtype[np.bytes_]]:
    rows = [list(name.ljust(NAME_LENGTH, "\0")) for name in names]
    return np.array(rows, dtype="S1")


def write_exodus(mesh: Mesh, path: pathlib.Path) -> None:
    """Writes nodes, blocks and side sets with their names, in double precision."""
    with netcdf_file(str(path), "w", version=2) as file:
        file.api_version = np.float32(5.1)
        file.version = np.float32(5.1)
        file.floating_point_word_size = np.int32(8)
        file.file_size = np.int32(1)
        file.title = "random scene"
        file.createDimension("time_step", None)
        file.createDimension("len_name", NAME_LENGTH)
        file.createDimension("len_string", NAME_LENGTH)
        file.createDimension("num_dim", mesh.dimension)
        file.createDimension("num_nodes", len(mesh.nodes))
        file.createDimension("num_elem", sum(len(block.nodes) for block in mesh.blocks))
        file.createDimension("num_el_blk", len(mesh.blocks))
        # The Exodus library does not see coordinates that are the first variable of a file; scipy sorts by size.
        file.createVariable("node_num_map", "i", ("num_nodes",))[:] = np.arange(1, len(mesh.nodes) + 1)
        for axis, name in enumerate("xyz"[:mesh.dimension]):
            file.createVariable(f"coord{name}", "d", ("num_nodes",))[:] = mesh.nodes[:, axis]
        file.createVariable("eb_status", "i", ("num_el_blk",))[:] = 1
        identity = file.createVariable("eb_prop1", "i", ("num_el_blk",))
        identity[:] = np.arange(1, len(mesh.blocks) + 1)
        identity.name = "ID"
        file.createVariable("eb_names", "c", ("num_el_blk", "len_name"))[:] = _text([b.name for b in mesh.blocks])
        for number, block in enumerate(mesh.blocks, 1):
            file.createDimension(f"num_el_in_blk{number}", block.nodes.shape[0])
            file.createDimension(f"num_nod_per_el{number}", block.nodes.shape[1])
            sizes = (f"num_el_in_blk{number}", f"num_nod_per_el{number}")
            connect = file.createVariable(f"connect{number}", "i", sizes)
            connect[:] = block.nodes + 1
            connect.elem_type = block.type
        if not mesh.side_sets:
            return
        file.createDimension("num_side_sets", len(mesh.side_sets))
        file.createVariable("ss_status", "i", ("num_side_sets",))[:] = 1
        identity = file.createVariable("ss_prop1", "i", ("num_side_sets",))
        identity[:] = np.arange(1, len(mesh.side_sets) + 1)
        identity.name = "ID"
        file.createVariable("ss_names", "c", ("num_side_sets", "len_name"))[:] = _text(list(mesh.side_sets))
        for number, sides in enumerate(mesh.side_sets.values(), 1):
            file.createDimension(f"num_side_ss{number}", len(sides))
            file.createVariable(f"elem_ss{number}", "i", (f"num_side_ss{number}",))[:] = [s.element + 1 for s in sides]
            file.createVariable(f"side_ss{number}", "i", (f"num_side_ss{number}",))[:] = [s.side + 1 for s in sides]
