"""Imports files of other programs; `harmos import` and the entry Mesh/File call it.

python3 -m harmos.exchange import FILE --output DIR [--units "mm N s"] [--hold SET] [--load SET] [--perfect INTERFACE]
       [--size SIZE] [--order 2] [--part-size PART=SIZE] [--conformal] [--preload PART=FORCE]
python3 -m harmos.exchange convert FILE MESH.e
"""
import argparse
import math
import os
import pathlib
import re
import sys
import zlib

from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Mesh, clean_name
from harmos.exchange.meshing import Meshing
from harmos.exchange.reading import DECKS, DRAWINGS, Missing, ending, load, read_drawing, read_mesh
from harmos.exchange.scene import Comment, SceneList
from harmos.exchange.start import Choices, starting_scene
from harmos.exchange.units import SYSTEMS, UnitSystem
from harmos.outputs import writing


UNCHANGED = "<!-- as imported: {:08x} -->\n"
"""The last line of a scene: the checksum of all before it, by which a scene that was changed since is known."""


def main(words: "list[str] | None" = None) -> int:
    """Does what the command line says; returns the exit code, 2 when the file cannot be imported."""
    parser = argparse.ArgumentParser(prog="harmos", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(dest="verb", required=True)
    importing = verbs.add_parser("import")
    importing.add_argument("file")
    importing.add_argument("--output", required=True)
    importing.add_argument("--units", default="")
    importing.add_argument("--size", type=float, default=0.0)
    importing.add_argument("--order", type=int, choices=(1, 2), default=1)
    importing.add_argument("--part-size", action="append", default=[])
    importing.add_argument("--conformal", action="store_true")
    importing.add_argument("--preload", action="append", default=[])
    importing.add_argument("--hold", action="append", default=[])
    importing.add_argument("--load", action="append", default=[])
    importing.add_argument("--perfect", action="append", default=[])
    converting = verbs.add_parser("convert")
    converting.add_argument("file")
    converting.add_argument("mesh")
    arguments = parser.parse_args(words)
    try:
        if arguments.verb == "convert":
            _convert(arguments.file, arguments.mesh)
        else:
            _import(arguments)
    except Refused as error:
        print(error if arguments.verb == "convert" else f"{error}\nNothing was written.", file=sys.stderr)
        return 2
    except (Missing, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def _convert(path: str, mesh_path: str) -> None:
    """The mesh alone, for the entry Mesh/File."""
    findings = Findings()
    if ending(path) in DECKS:
        from harmos.exchange.deck.imported import import_deck
        mesh = import_deck(path, "", "", findings).mesh
    elif ending(path) in DRAWINGS:
        raise Refused(f"{path}: a drawing is no mesh. Run \"harmos import {path} --output DIR\" and take the mesh it makes.")
    else:
        mesh = read_mesh(path, findings)
        for each in findings.found + [f"{left.keyword}: {left.effect}" for left in findings.left_out]:
            print(" ".join(each.split()), file=sys.stderr)  # the caller warns of every line
    _write_mesh(mesh_path, mesh)


def _write_mesh(path: str, mesh: Mesh) -> None:
    writer = load("harmos.exchange.exodus", "python3-netcdf4")
    writer.write_exodus(path, mesh)  # type: ignore[attr-defined]


def _import(arguments: argparse.Namespace) -> None:
    path = arguments.file
    findings = Findings()
    if arguments.units and arguments.units not in SYSTEMS:
        raise Refused(f"--units \"{arguments.units}\": there are {', '.join(SYSTEMS)}.")
    units = SYSTEMS[arguments.units or "mm N s"]
    stem = clean_name(pathlib.Path(path).stem)
    folder = pathlib.Path(arguments.output)
    outputs = [folder / f"{stem}.e", folder / f"{stem}.xml"]
    suffix = ending(path)
    for output in outputs:
        if output.exists() and output.samefile(path):
            raise Refused(f"the result {output} would replace the input {path}. Name another folder by --output.")
        if output.is_dir():
            raise Refused(f"the result {output} cannot be written: it is a folder. Name another folder by --output.")
    if outputs[1].exists() and _was_changed(outputs[1]):
        raise Refused(f"{outputs[1]} is not as it was imported, and its changes would be lost. Rename it, or name another "
                      "folder by --output.")
    if arguments.preload and suffix not in DRAWINGS:
        raise Refused(f"--preload: {path} is no drawing that can be cut. Give the scene an interface with Part, Point, Normal and the "
                      "law Pretension, along a layer of element faces.")
    scene = None
    if suffix in DECKS:
        from harmos.exchange.deck.imported import import_deck
        deck = import_deck(path, f"{stem}.e", arguments.units, findings)
        mesh, scene = deck.mesh, deck.scene
        for option, names in (("--hold", arguments.hold), ("--load", arguments.load), ("--perfect", arguments.perfect)):
            if scene is not None and names:
                raise Refused(f"{option} {names[0]}: {path} says itself what holds, loads and joins its parts. Change it there, or in the scene.")
    elif suffix in DRAWINGS:
        mesh = read_drawing(path, _meshing(arguments, units), findings)
    else:
        mesh = read_mesh(path, findings)
    if scene is None:
        findings.found.insert(0, mesh.text())
        choices = Choices(arguments.hold, arguments.load, arguments.perfect,
                          _numbers_by_part("--preload", arguments.preload, "a force"))
        scene = starting_scene(mesh, f"{stem}.e", stem, units, bool(arguments.units), choices, findings)
    scene.items.insert(0, _heading(path, findings))
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    _write_both(outputs, mesh, scene)
    for line in findings.text():
        print(line)
    print(f"{outputs[1]}: the starting scene; \"harmos check {outputs[1]}\" says what it will take.", flush=True)


def _meshing(arguments: argparse.Namespace, units: UnitSystem) -> Meshing:
    """How to mesh a drawing, as the words say."""
    sizes = _numbers_by_part("--part-size", arguments.part_size, "a size")
    if not arguments.size >= 0.0:
        raise Refused(f"--size {arguments.size:g}: it must be above 0.")
    return Meshing(arguments.size, arguments.order, sizes, arguments.conformal,
                   list(_numbers_by_part("--preload", arguments.preload, "a force")), arguments.perfect, units.length)


def _numbers_by_part(option: str, words: list[str], what: str) -> dict[str, float]:
    """What an option that takes PART=NUMBER says, numbers above 0."""
    numbers = {}
    for word in words:
        name, _, number = word.rpartition("=")
        try:
            numbers[name] = float(number)
        except ValueError:
            numbers[name] = 0.0
        if not name or not 0.0 < numbers[name] < math.inf:
            raise Refused(f"{option} \"{word}\": it takes PART={what.split()[-1].upper()}, {what} above 0.")
    return numbers


def _heading(path: str, findings: Findings) -> Comment:
    return Comment([f"Imported from {pathlib.Path(path).name}.", *findings.text()])


def _was_changed(scene: pathlib.Path) -> bool:
    """Whether somebody has worked on a scene since it was imported, or it was not imported at all."""
    content = scene.read_bytes()
    last = re.search(rb"[^\n]*\n\Z", content)
    return last is None or last.group().decode("utf-8", "replace") != UNCHANGED.format(zlib.crc32(content[:last.start()]))


def _write_both(outputs: list[pathlib.Path], mesh: Mesh, scene: SceneList) -> None:
    """Replaces both files when both are complete."""
    partial = [output.with_name(f"{output.name}.partial.{os.getpid()}") for output in outputs]
    try:
        with writing(outputs[0]):
            _write_mesh(str(partial[0]), mesh)
        content = (scene.text() + "\n").encode()
        with writing(outputs[1]):
            partial[1].write_bytes(content + UNCHANGED.format(zlib.crc32(content)).encode())
        for complete, output in zip(partial, outputs):
            with writing(output):
                os.replace(complete, output)
    finally:
        for left in partial:
            left.unlink(missing_ok=True)


if __name__ == "__main__":
    sys.exit(main())
