#!/usr/bin/python3
"""Decks of CalculiX, imported and solved, beside CalculiX's own displacements; prints a table.

deck_table.py HARMOS WORK_DIR [--decks FOLDER] [--write PAGE]

Every deck in the folder (that of Debian's calculix-ccx-test, where most are packed by gzip) must end in a scene that `harmos check` accepts, or be
refused with exit code 2 and a reason. Those of static steps are solved by both; the error is the largest difference of
displacements at the end over CalculiX's largest displacement, nodes found by their coordinates; reduced integration and
NLGEOM are switched off in both, for Harmos has none. Fails when a deck ends
in another way, or when one is off by more than DECISIVE of which nothing that matters was left out, and whose mesh is fine enough to tell.
"""
import argparse
import gzip
import json
import os
import pathlib
import re
import shutil
import subprocess

import netCDF4
import numpy
from scipy.spatial import cKDTree

MINOR = re.compile(r"^(\*FRICTION, stick slope|\*CONDUCTIVITY|\*SPECIFICHEAT|\*DAMPING|TYPE=\w+R|TYPE=C3D6|TYPE=C3D15|"
                   r"\*STEP, NLGEOM|\*(CLOAD|DLOAD|DSLOAD), reaction|\*ELEMENT, TYPE=CPS[68]R?)$")
"""What is left out without effect on the displacements that are compared."""

OTHER_METHOD = {"cubef2f3": "CalculiX ties node by node, which is 2.5 % off its own cubef2f1 and cubef2f2"}
"""Decks of which CalculiX's own solution is not what Harmos is held against, and why."""

COARSE = ("beamcontact", "contact4", "cubef2f1", "cubef2f2", "cubespring", "plate", "punch1", "punch2")
"""Decks of surfaces that do not match, a few elements wide: halved elements have to move what is compared by more than the
programs differ."""

DECISIVE = 2e-3
"""Error of displacements up to which a deck counts as solved alike: both solvers stop at about 1e-3."""


def displacements_of_calculix(frd: pathlib.Path) -> "tuple[numpy.ndarray, numpy.ndarray] | None":
    """Coordinates and the last displacements of a result file."""
    nodes: dict[int, list[float]] = {}
    last: dict[int, list[float]] = {}
    block = ""
    for line in frd.read_text(errors="replace").splitlines():
        if line.startswith("    2C"):
            block = "nodes"
        elif line.startswith(" -4"):
            block = line[5:11].strip()
            if block == "DISP":
                last = {}
        elif line.startswith(" -3"):
            block = ""
        elif line.startswith(" -1") and block in ("nodes", "DISP"):
            (nodes if block == "nodes" else last)[int(line[3:13])] = [float(line[13 + 12 * i:25 + 12 * i])
                                                                      for i in range(3)]
    ids = [node for node in nodes if node in last]
    if not ids:
        return None
    return numpy.array([nodes[node] for node in ids]), numpy.array([last[node] for node in ids])


def displacements_of_harmos(results: pathlib.Path) -> tuple[numpy.ndarray, numpy.ndarray]:
    """The same of an Exodus file."""
    with netCDF4.Dataset(results) as file:
        file.set_auto_mask(False)
        names = [row.tobytes().split(b"\0")[0].decode() for row in file.variables["name_nod_var"][:]]
        axes = "xyz"[:len(file.dimensions["num_dim"])]
        at = numpy.zeros((len(file.dimensions["num_nodes"]), 3))
        by = numpy.zeros_like(at)
        for column, axis in enumerate(axes):
            at[:, column] = file.variables["coord" + axis][:]
            by[:, column] = file.variables[f"vals_nod_var{names.index('disp_' + axis) + 1}"][-1]
    return at, by


def difference(ours: tuple[numpy.ndarray, numpy.ndarray], theirs: tuple[numpy.ndarray, numpy.ndarray],
               dimension: int) -> float:
    """Largest difference over CalculiX's largest displacement; of nodes at one place, the nearer one."""
    size = float(numpy.abs(theirs[1][:, :dimension]).max())
    span = float(numpy.ptp(ours[0], axis=0).max())
    tree = cKDTree(theirs[0][:, :dimension])
    worst = 0.0
    for at, by in zip(ours[0][:, :dimension], ours[1][:, :dimension]):
        same = tree.query_ball_point(at, 1e-4 * span)
        if same:
            worst = max(worst, min(float(numpy.abs(theirs[1][k, :dimension] - by).max()) for k in same))
    return worst / size if size > 0.0 else 0.0


def unpacked(folder: pathlib.Path, into: pathlib.Path) -> list[pathlib.Path]:
    """Copies of all decks of a folder, in the order of their names."""
    into.mkdir(parents=True, exist_ok=True)
    for deck in folder.glob("*.inp"):
        shutil.copyfile(deck, into / deck.name)
    for deck in folder.glob("*.inp.gz"):
        (into / deck.stem).write_bytes(gzip.decompress(deck.read_bytes()))
    return sorted(into.glob("*.inp"))


class Deck:
    """What became of one."""

    def __init__(self, harmos: str, deck: pathlib.Path, work: pathlib.Path) -> None:
        self.name, self.error, self.moved, self.outcome, self.left_out = deck.stem, None, None, "", []
        folder = work / deck.stem
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        imported = subprocess.run([harmos, "import", str(deck), "--output", str(folder)], capture_output=True, text=True)
        self.left_out = [line for line in imported.stdout.splitlines() if line.startswith("left out")]
        if imported.returncode == 2 and imported.stderr.strip():
            self.outcome = "refused: " + re.sub(r"^\S*: |\S*/", "", imported.stderr.splitlines()[0])
            return
        scene = folder / f"{deck.stem}.xml"
        checked = subprocess.run([harmos, "check", str(scene)], capture_output=True, text=True)
        if imported.returncode or checked.returncode:
            self.outcome = f"WRONG: import {imported.returncode}, check {checked.returncode}"
            return
        self.outcome = "scene"
        text = deck.read_text(errors="replace")
        if not re.search(r"^\*STATIC", text, re.MULTILINE | re.IGNORECASE):
            return
        self._solve(harmos, scene, folder, text)

    def _solve(self, harmos: str, scene: pathlib.Path, folder: pathlib.Path, text: str) -> None:
        try:
            run = subprocess.run([harmos, "run", str(scene), "--output", str(folder / "run"), "--set",
                                  "Solver/Mesh Error=false", "--set", "Solver/Accuracy=1e-4"], capture_output=True,
                                 text=True, timeout=120)
        except subprocess.TimeoutExpired:
            self.outcome = "not solved within 2 minutes"
            return
        record = json.loads((folder / "run" / f"{scene.stem}_result.json").read_text())
        self.outcome = record["status"]
        if run.returncode:
            return
        # Reduced integration is another discretisation and NLGEOM another theory, which Harmos has not: both go without.
        text = re.sub(r"(TYPE *= *(?:C3D20|CPS8|CPE8|CAX8))R", r"\1", text, flags=re.IGNORECASE)
        text = re.sub(r"^(\*STEP.*?), *NLGEOM( *= *YES)?", r"\1", text, flags=re.MULTILINE | re.IGNORECASE)
        asked = re.sub(r"^(\*END *STEP.*)$", r"*NODE FILE\nU\n\1", text, flags=re.MULTILINE | re.IGNORECASE)
        (folder / "deck.inp").write_text(asked)
        try:
            subprocess.run(["ccx", "deck"], cwd=folder, capture_output=True, timeout=120)
        except subprocess.TimeoutExpired:
            return
        theirs = displacements_of_calculix(folder / "deck.frd") if (folder / "deck.frd").exists() else None
        if theirs is None:
            return
        ours = displacements_of_harmos(folder / "run" / f"{scene.stem}.e")
        with netCDF4.Dataset(folder / "run" / f"{scene.stem}.e") as file:
            dimension = len(file.dimensions["num_dim"])
        self.error = difference(ours, theirs, dimension)
        if self.name in COARSE:
            subprocess.run([harmos, "run", str(scene), "--output", str(folder / "fine"), "--set", "Solver/Mesh Error=false", "--set",
                            "Solver/Accuracy=1e-4", "--set", "Mesh/Refine=1"], capture_output=True, timeout=600, check=True)
            self.moved = difference(ours, displacements_of_harmos(folder / "fine" / f"{scene.stem}.e"), dimension)

    def is_explained(self) -> bool:
        """Whether something else than a fault accounts for its error."""
        return bool(self.matters() or self.name in OTHER_METHOD or (self.moved is not None and self.moved > self.error))

    def matters(self) -> list[str]:
        """Keywords of what was left out and may change displacements."""
        words = [re.sub(r"^left out: (\S*:\d+|\S*\.inp): ", "", line).removeprefix("left out: ").split(": ")[0]
                 for line in self.left_out]
        return [word for word in dict.fromkeys(words) if not MINOR.match(word)]


def table(decks: list[Deck]) -> str:
    """In the syntax of Markdown."""
    lines = ["| deck | outcome | largest difference of displacements | left out |", "|---|---|---|---|"]
    for deck in decks:
        if deck.outcome.startswith("refused"):
            continue
        error = "" if deck.error is None else f"{deck.error:.1e}"
        lines.append(f"| {deck.name} | {deck.outcome} | {error} | {'; '.join(deck.matters())} |")
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("harmos")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--decks", type=pathlib.Path, default="/usr/share/doc/calculix-ccx-test/examples/test")
    parser.add_argument("--write", type=pathlib.Path)
    arguments = parser.parse_args()
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    harmos = os.path.abspath(arguments.harmos)
    decks = [Deck(harmos, deck, arguments.work) for deck in unpacked(arguments.decks, arguments.work / "decks")]
    refused = [deck for deck in decks if deck.outcome.startswith("refused")]
    reasons: dict[str, int] = {}
    for deck in refused:
        reasons[deck.outcome] = reasons.get(deck.outcome, 0) + 1
    text = table(decks) + f"\n\n{len(decks)} decks: {len(decks) - len(refused)} scenes, {len(refused)} refused.\n"
    for reason, count in sorted(reasons.items(), key=lambda item: -item[1]):
        text += f"\n* {count} {reason}"
    for name, reason in OTHER_METHOD.items():
        text += f"\n* {name}: {reason}."
    for deck in decks:
        if deck.moved is not None:
            text += (f"\n* {deck.name}: surfaces that do not match, a few elements wide: halved elements (Mesh/Refine=1) move what is "
                     f"compared by {deck.moved:.1e}.")
    print(text)
    if arguments.write:
        begin, end = "<!-- table -->\n", "\n<!-- end -->"
        page = arguments.write.read_text()
        arguments.write.write_text(page[:page.index(begin) + len(begin)] + text + page[page.index(end):])
    wrong = [deck for deck in decks if deck.outcome.startswith("WRONG")
             or (deck.error is not None and deck.error > DECISIVE and not deck.is_explained())]
    for deck in wrong:
        print(f"WRONG: {deck.name}: {deck.outcome}, {deck.error}")
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
