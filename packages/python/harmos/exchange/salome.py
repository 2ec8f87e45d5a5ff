"""Meshes of Salome (.med): HDF5 files, whose layout is told in https://docs.salome-platform.org/latest/dev/MEDCoupling/developer/med-file.html.

meshio reads them as well, but not where some tables of elements have no families, or elements are WEDGE15 or HEX27.
"""
import h5py
import numpy

from harmos.arrays import Array
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.foreign_mesh import Cells, Source, mesh_of
from harmos.exchange.mesh import Mesh

_TYPES = {
    "PO1": "vertex", "SE2": "line", "SE3": "line3", "TR3": "triangle", "TR6": "triangle6", "QU4": "quad", "QU8": "quad8",
    "QU9": "quad9", "TE4": "tetra", "T10": "tetra10", "PY5": "pyramid", "PE6": "wedge", "P15": "wedge15", "HE8": "hexahedron",
    "H20": "hexahedron20",
}
"""Types of meshio by the names of the format; both order nodes in the same way, but for elements inside out."""


def read_salome(path: str, findings: Findings) -> Mesh:
    """Reads a mesh; groups of elements become blocks and side sets, those of nodes node sets.

    Raises:
        Refused: the file is damaged, holds several meshes, or has elements that Harmos has not.
    """
    try:
        with h5py.File(path, "r") as file:
            source = _source(path, file)
    except Refused:
        raise
    except (OSError, KeyError, ValueError, AttributeError, IndexError, TypeError, RuntimeError) as error:  # of h5py on damaged files
        raise Refused(f"{path}: this is no MED file, or it is damaged: {error}.") from None
    return mesh_of(path, source, findings)


def _source(path: str, file: h5py.File) -> Source:
    names = list(file["ENS_MAA"])
    if len(names) != 1:
        raise Refused(f"{path}: it holds {len(names)} meshes{': ' if names else ''}{', '.join(names)}; write one to a file.")
    mesh = file["ENS_MAA"][names[0]]
    while "NOE" not in mesh:  # below the steps of time, of which the last counts
        mesh = mesh[sorted(mesh)[-1]]
    nodes = mesh["NOE"]["COO"]
    count = int(nodes.attrs["NBR"])
    points = numpy.asarray(nodes[()], dtype=numpy.float64).reshape(-1, count).T
    cells, families = [], []
    for name, table in mesh["MAI"].items():
        held = int(table["NOD"].attrs["NBR"])
        cells.append(Cells(_TYPES.get(name, name), numpy.asarray(table["NOD"][()], dtype=numpy.int64).reshape(-1, held).T - 1,
                           _numbers(table, held)))
        families.append(table["FAM"][()] if "FAM" in table else numpy.zeros(held, dtype=numpy.int64))
    of_nodes = mesh["NOE"]["FAM"][()] if "FAM" in mesh["NOE"] else numpy.zeros(count, dtype=numpy.int64)
    if len(of_nodes) != count or any(len(of) != len(table.data) for of, table in zip(families, cells)):
        raise ValueError("its families are of another length than its elements")
    told = file["FAS"][names[0]] if names[0] in file.get("FAS", {}) else {}
    return Source(points, cells, {"cell_tags": families}, {"point_tags": of_nodes}, {}, _groups(told.get("ELEME", {})),
                  _groups(told.get("NOEUD", {})), _numbers(mesh["NOE"], count))


def _numbers(entities: h5py.Group, count: int) -> "Array | None":
    """By which the file knows nodes or elements of a type; None: by none."""
    numbers = numpy.asarray(entities["NUM"][()], dtype=numpy.int64) if "NUM" in entities else None
    return numbers if numbers is not None and len(numbers) == count else None


def _groups(families: "h5py.Group | dict[str, h5py.Group]") -> dict[int, list[str]]:
    """Names of groups, by the numbers of families; those without groups have none."""
    return {int(family.attrs["NUM"]): ["".join(map(chr, row)).split("\0")[0].strip() for row in family["GRO"]["NOM"][()].view("u1")]
            for family in families.values() if "GRO" in family}
