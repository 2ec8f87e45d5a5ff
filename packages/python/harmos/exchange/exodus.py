"""Writes and reads Exodus II files through netCDF.

Source: Schoof, Yarberry, EXODUS II: a finite element data model, SAND92-2137 (1995).
"""
import collections
import os

import netCDF4
import numpy

from harmos.arrays import Array
from harmos.exchange.elements import TYPES
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import LONGEST_NAME, Block, Mesh, demand_sound, unused_name
from harmos.exchange.sense import oriented

NAME_LENGTH = LONGEST_NAME + 1
"""Room for a name with its end."""


def write_exodus(path: str | os.PathLike[str], mesh: Mesh, title: str = "") -> None:
    """Writes a mesh in the format with 64-bit offsets."""
    with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as file:
        file.setncatts({"api_version": numpy.float32(6.02), "version": numpy.float32(6.02),
                        "floating_point_word_size": numpy.int32(8), "file_size": numpy.int32(1),
                        "maximum_name_length": numpy.int32(LONGEST_NAME), "title": title[:80] or "Harmos"})
        sizes = {"len_string": 33, "len_line": 81, "four": 4, "len_name": NAME_LENGTH, "num_dim": mesh.dimension,
                 "num_nodes": len(mesh.nodes), "num_elem": int(mesh.first_elements()[-1]),
                 "num_el_blk": len(mesh.blocks)}
        for name, size in sizes.items():
            file.createDimension(name, size)
        file.createDimension("time_step", None)
        file.createVariable("time_whole", "f8", ("time_step",))
        for axis in "xyz"[:mesh.dimension]:
            file.createVariable("coord" + axis, "f8", ("num_nodes",))[:] = mesh.nodes[:, "xyz".index(axis)]
        _write_numbers(file, "node_num_map", "num_nodes", mesh.node_numbers)
        _write_numbers(file, "elem_num_map", "num_elem", mesh.element_numbers())
        _write_blocks(file, mesh)
        _write_sets(file, "ss", "side", mesh.side_sets)
        _write_sets(file, "ns", "node", mesh.node_sets)


def _write_names(file: netCDF4.Dataset, variable: str, dimension: str, names: list[str]) -> None:
    table = numpy.zeros((len(names), NAME_LENGTH), dtype="S1")
    for row, name in zip(table, names):
        letters = name.encode("ascii", "replace")[:LONGEST_NAME]
        row[:len(letters)] = [letters[i:i + 1] for i in range(len(letters))]
    file.createVariable(variable, "S1", (dimension, "len_name"))[:] = table


def _write_ids(file: netCDF4.Dataset, prefix: str, dimension: str, count: int) -> None:
    file.createVariable(prefix + "_status", "i4", (dimension,))[:] = numpy.ones(count)
    ids = file.createVariable(prefix + "_prop1", "i4", (dimension,))
    ids.setncattr("name", "ID")
    ids[:] = numpy.arange(1, count + 1)


def _write_numbers(file: netCDF4.Dataset, variable: str, dimension: str, numbers: "Array | None") -> None:
    """Numbers that tell nodes or elements apart, as readers of such files demand; others are left out."""
    if numbers is None or numbers.min() < 1 or numbers.max() >= 2**31 or len(numpy.unique(numbers)) < len(numbers):
        return
    file.createVariable(variable, "i4", (dimension,))[:] = numbers


def _write_blocks(file: netCDF4.Dataset, mesh: Mesh) -> None:
    _write_ids(file, "eb", "num_el_blk", len(mesh.blocks))
    _write_names(file, "eb_names", "num_el_blk", [block.name for block in mesh.blocks])
    for number, block in enumerate(mesh.blocks, 1):
        file.createDimension(f"num_el_in_blk{number}", len(block.connectivity))
        file.createDimension(f"num_nod_per_el{number}", block.type.nodes)
        variable = file.createVariable(f"connect{number}", "i4",
                                       (f"num_el_in_blk{number}", f"num_nod_per_el{number}"))
        variable.setncattr("elem_type", block.type.name)
        variable[:] = block.connectivity + 1


def _write_sets(file: netCDF4.Dataset, short: str, word: str, sets: dict[str, Array]) -> None:
    if not sets:
        return
    dimension = f"num_{word}_sets"
    file.createDimension(dimension, len(sets))
    _write_ids(file, short, dimension, len(sets))
    _write_names(file, short + "_names", dimension, list(sets))
    for number, entries in enumerate(sets.values(), 1):
        if len(entries) == 0:
            file.variables[short + "_status"][number - 1] = 0  # a set of which nothing else is written
            continue
        size = f"num_{'side_ss' if short == 'ss' else 'nod_ns'}{number}"
        file.createDimension(size, len(entries))
        columns = [("elem_ss", entries[:, 0]), ("side_ss", entries[:, 1])] if short == "ss" else [("node_ns", entries)]
        for name, column in columns:
            file.createVariable(f"{name}{number}", "i4", (size,))[:] = column + 1


def _read_names(file: netCDF4.Dataset, variable: str, count: int, unnamed: str) -> list[str]:
    names = [f"{unnamed}{number}" for number in range(1, count + 1)]
    if variable in file.variables:
        table = file.variables[variable]
        table.set_auto_mask(False)
        for number, row in enumerate(table[:]):
            name = row.tobytes().split(b"\0")[0].decode("ascii", "replace").strip()
            names[number] = name or names[number]
    return names


def _size(file: netCDF4.Dataset, dimension: str) -> int:
    return len(file.dimensions[dimension]) if dimension in file.dimensions else 0


def _numbers(file: netCDF4.Dataset, variable: str, count: int) -> "Array | None":
    """By which the file knows its nodes or elements; None: by none, or by a map that is damaged."""
    if variable not in file.variables or file.variables[variable].shape != (count,):
        return None
    return numpy.asarray(file.variables[variable][:], dtype=numpy.int64)


def _entries(file: netCDF4.Dataset, variable: str) -> Array:
    """Of a set, counted from 0; an empty set has no table."""
    table = file.variables[variable][:] if variable in file.variables else numpy.zeros(0)
    return numpy.asarray(table, dtype=numpy.int64) - 1


def _distinct(path: str, file: netCDF4.Dataset, variable: str, dimension: str, unnamed: str, findings: Findings) -> list[str]:
    """Names of all blocks, side sets or node sets; those that are longer than a scene's are cut."""
    given = _read_names(file, variable, _size(file, dimension), unnamed)
    twice = [name for name, count in collections.Counter(given).items() if count > 1]
    if twice:
        kind = {"num_el_blk": "element blocks", "num_side_sets": "side sets", "num_node_sets": "node sets"}[dimension]
        raise Refused(f"{path}: two {kind} are named \"{twice[0]}\"; rename one.")
    names: list[str] = []
    for name in given:
        names.append(name if len(name) <= LONGEST_NAME else unused_name(name, {*given, *names}))
        if names[-1] != name:
            findings.found.append(f"\"{name}\" is too long, and called {names[-1]} here")
    return names


def _read_blocks(path: str, file: netCDF4.Dataset, dimension: int, findings: Findings) -> list[Block]:
    """Those that have elements."""
    blocks = []
    for number, name in enumerate(_distinct(path, file, "eb_names", "num_el_blk", "block_", findings), 1):
        if not _size(file, f"num_el_in_blk{number}"):
            continue
        connectivity = file.variables[f"connect{number}"]
        said = getattr(connectivity, "elem_type", "")
        family = said.upper().rstrip("0123456789 \0")
        if dimension == 2 and family == "SHELL":
            family = "QUAD"
        kind = [each for each in TYPES.values()
                if each.nodes == connectivity.shape[1] and each.dimension == dimension
                and family and each.name.rstrip("0123456789").startswith(family[:3])]
        if not kind:
            raise Refused(f"{path}: block \"{name}\" has elements \"{said}\" of {connectivity.shape[1]} nodes, which Harmos has not in "
                          f"{dimension} dimensions.")
        blocks.append(Block(name, kind[0], connectivity[:].astype(numpy.int64) - 1))
    return blocks


def _sides_before_edges(file: netCDF4.Dataset, mesh: Mesh) -> Array:
    """Of every element how many sides come before its edges: a shell has two faces."""
    kinds = [getattr(file.variables[f"connect{number}"], "elem_type", "").upper()
             for number in range(1, _size(file, "num_el_blk") + 1) if _size(file, f"num_el_in_blk{number}")]
    return numpy.concatenate([numpy.full(len(block.connectivity), 2 if "SHELL" in kind and mesh.dimension == 2 else 0)
                              for kind, block in zip(kinds, mesh.blocks)])


def read_exodus(path: str, findings: Findings) -> Mesh:
    """Reads the mesh of a file, for a starting scene; the program itself has a reader of its own.

    Raises:
        Refused: elements that Harmos has not.
    """
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        dimension = _size(file, "num_dim")
        nodes = numpy.zeros((_size(file, "num_nodes"), 3))
        for column, axis in enumerate("xyz"[:dimension]):
            nodes[:, column] = file.variables["coord" + axis][:] if "coord" + axis in file.variables \
                else file.variables["coord"][column]
        mesh = Mesh(dimension, nodes, _read_blocks(path, file, dimension, findings))
        mesh.node_numbers = _numbers(file, "node_num_map", len(nodes))
        numbers = _numbers(file, "elem_num_map", int(mesh.first_elements()[-1]))
        for first, block in zip(mesh.first_elements(), mesh.blocks):
            block.numbers = None if numbers is None else numbers[first:first + len(block.connectivity)]
        before = _sides_before_edges(file, mesh)
        for number, name in enumerate(_distinct(path, file, "ss_names", "num_side_sets", "sideset_", findings), 1):
            elements, sides = _entries(file, f"elem_ss{number}"), _entries(file, f"side_ss{number}")
            if len(elements) and int(elements.max()) < len(before):
                is_face = sides < before[elements]
                if is_face.any():
                    raise Refused(f"{path}: side set \"{name}\" refers to side {int(sides[is_face][0]) + 1} of a shell, which is its face; in "
                                  "the plane there are edges only, which count from 3. Write the block as QUAD or TRI, whose edges count "
                                  "from 1.")
                sides = sides - before[elements]
            mesh.side_sets[name] = numpy.column_stack([elements, sides])
        for number, name in enumerate(_distinct(path, file, "ns_names", "num_node_sets", "nodeset_", findings), 1):
            mesh.node_sets[name] = _entries(file, f"node_ns{number}")
    demand_sound(path, mesh)
    oriented(mesh, findings)
    return mesh
