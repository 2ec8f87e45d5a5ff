"""Reads meshes of other programs by the ending of the file, in a child process where libraries crash on damaged ones."""
import importlib
import pathlib

from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Mesh, demand_sound
from harmos.foreign import read_foreign

READERS: dict[str, tuple[str, str, str]] = {
    ".msh": ("harmos.exchange.gmsh_mesh", "read_gmsh", "python3-gmsh"),
    ".unv": ("harmos.exchange.gmsh_mesh", "read_gmsh", "python3-gmsh"),
    ".med": ("harmos.exchange.foreign_mesh", "read_meshio", "python3-meshio"),
    ".e": ("harmos.exchange.exodus", "read_exodus", "python3-netcdf4"),
    ".exo": ("harmos.exchange.exodus", "read_exodus", "python3-netcdf4"),
    ".g": ("harmos.exchange.exodus", "read_exodus", "python3-netcdf4"),
    ".vtu": ("harmos.exchange.foreign_mesh", "read_meshio", "python3-meshio"),
}
"""Module, function and package of Debian that read a format."""

ENDINGS = sorted(READERS)
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


def demand_importable(path: str) -> str:
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
    module, function, package = READERS[demand_importable(path)]
    reader = getattr(load(module, package), function)
    child = Findings()

    def read() -> tuple[Mesh, Findings]:
        mesh = reader(path, child)
        demand_sound(path, mesh)
        return mesh, child

    try:
        mesh, told = read_foreign(path, read)
    except Refused:
        raise
    except (OSError, ValueError) as error:
        named = str(error) if path in str(error) else f"{path}: {error}"
        raise Refused(f"{named}\n  The file is damaged or cannot be read.") from None
    for name in [name for sets in (mesh.side_sets, mesh.node_sets) for name in sets]:
        for sets in (mesh.side_sets, mesh.node_sets):
            if name in sets and not len(sets[name]):
                del sets[name]
                told.found.append(f"set \"{name}\" is empty and has been left out")
    findings.found += told.found
    findings.left_out += told.left_out
    return mesh
