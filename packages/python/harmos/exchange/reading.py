"""Reads meshes of other programs by the ending of the file, in a child process where libraries crash on damaged ones."""
import importlib
import pathlib
from collections.abc import Callable

from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Mesh, demand_sound
from harmos.exchange.meshing import Meshing
from harmos.foreign import read_foreign

READERS: dict[str, tuple[str, str, str]] = {
    ".msh": ("harmos.exchange.gmsh_mesh", "read_gmsh", "python3-gmsh"),
    ".unv": ("harmos.exchange.universal", "read_universal", "python3-numpy"),
    ".med": ("harmos.exchange.salome", "read_salome", "python3-h5py"),
    ".e": ("harmos.exchange.exodus", "read_exodus", "python3-netcdf4"),
    ".exo": ("harmos.exchange.exodus", "read_exodus", "python3-netcdf4"),
    ".g": ("harmos.exchange.exodus", "read_exodus", "python3-netcdf4"),
    ".vtu": ("harmos.exchange.foreign_mesh", "read_meshio", "python3-meshio"),
    ".vtk": ("harmos.exchange.foreign_mesh", "read_meshio", "python3-meshio"),
}
"""Module, function and package of Debian that read a format."""

DECKS = (".inp",)
"""Endings of decks of Abaqus and CalculiX."""

MESHING_EFFORT = 100.0
"""Time and memory that meshing a drawing may take, over those of reading a file of its size."""

DRAWINGS = (".step", ".stp", ".brep", ".brp")
"""Endings of drawings."""

ENDINGS = sorted([*READERS, *DECKS, *DRAWINGS])
"""All endings that can be imported."""


class Missing(RuntimeError):
    """A package of Debian that a format needs is not installed."""


def load(module: str, package: str) -> object:
    """A module of this package that needs libraries of others.

    Raises:
        Missing: they are not installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise Missing(f"{error}.\n  It comes with a package of Debian: apt-get install {package} python3-netcdf4") \
            from None


def ending(path: str) -> str:
    """The ending of a file that can be imported, in small letters.

    Raises:
        Refused: there is no such file, or it has another ending.
    """
    name = pathlib.Path(path)
    suffix = name.suffix.lower()
    if suffix not in ENDINGS:
        raise Refused(f"{path}: files that end in \"{suffix}\" cannot be imported, only {', '.join(ENDINGS)}.")
    if not name.is_file():
        raise Refused(f"{path}: {'it is not a file' if name.exists() else 'there is no such file'}.")
    if name.stat().st_size == 0:
        raise Refused(f"{path}: it is empty.")
    return suffix


def read_mesh(path: str, findings: Findings) -> Mesh:
    """Reads a mesh that comes without physics.

    Raises:
        Refused: the file is damaged, or holds what Harmos has not.
        Missing: a package of Debian is not installed.
    """
    module, function, package = READERS[ending(path)]
    reader: Callable[[str, Findings], Mesh] = getattr(load(module, package), function)
    return _in_child(path, lambda told: reader(path, told), findings, 1.0)


def read_drawing(path: str, meshing: Meshing, findings: Findings) -> Mesh:
    """Meshes a drawing; raises as read_mesh() does."""
    mesher: Callable[[str, Meshing, Findings], Mesh] = getattr(load("harmos.exchange.drawing", "python3-gmsh"),
                                                               "mesh_drawing")
    return _in_child(path, lambda told: mesher(path, meshing, told), findings, MESHING_EFFORT)


def _in_child(path: str, make: Callable[[Findings], Mesh], findings: Findings, effort: float) -> Mesh:
    told = Findings()

    def read() -> tuple[Mesh, Findings]:
        mesh = make(told)
        demand_sound(path, mesh)
        return mesh, told

    try:
        mesh, said = read_foreign(path, read, effort)
    except Refused:
        raise
    except (OSError, ValueError) as error:
        named = str(error) if path in str(error) else f"{path}: {error}"
        raise Refused(f"{named}\n  The file is damaged or cannot be read.") from None
    for name in [name for sets in (mesh.side_sets, mesh.node_sets) for name in sets]:
        for sets in (mesh.side_sets, mesh.node_sets):
            if name in sets and not len(sets[name]):
                del sets[name]
                said.found.append(f"set \"{name}\" is empty and has been left out")
    findings.found += said.found
    findings.undecided += said.undecided
    findings.left_out += said.left_out
    return mesh
