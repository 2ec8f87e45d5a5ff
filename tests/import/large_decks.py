#!/usr/bin/python3
"""Decks of up to a million lines, imported in linear time: large_decks.py HARMOS WORK_DIR

Prints lines and CPU time of every deck; fails where a line of the largest takes twice the time of one of the smallest.
"""
import pathlib
import resource
import shutil
import subprocess
import sys

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
CELLS = (40, 56, 79)
"""Of a cube along each edge."""


def write_cube(path, cells):
    """A cube that stands on its lower face, under a pressure above, with a force on each node there, line by line; its lines."""
    across, layer = cells + 1, (cells + 1)**2
    with open(path, "w") as deck:
        deck.write("*NODE, NSET=ALL\n")
        for node in range(across**3):
            deck.write(f"{node + 1}, {node % across}., {node // across % across}., {node // layer}.\n")
        deck.write("*ELEMENT, TYPE=C3D8, ELSET=CUBE\n")
        for number in range(cells**3):
            first = 1 + number % cells + across * (number // cells % cells) + layer * (number // cells**2)
            lower = (first, first + 1, first + 1 + across, first + across)
            deck.write(", ".join(map(str, (number + 1, *lower, *(node + layer for node in lower)))) + "\n")
        deck.write("*NSET, NSET=BELOW\n" + "".join(f"{node + 1}\n" for node in range(layer)))
        deck.write("*SURFACE, NAME=ABOVE\n" + "".join(f"{number + 1}, S2\n" for number in range(cells**3 - cells**2, cells**3)))
        deck.write("*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.3\n*SOLID SECTION, ELSET=CUBE, MATERIAL=STEEL\n*BOUNDARY\nBELOW, 1, 3\n"
                   "*STEP\n*STATIC\n*DSLOAD\nABOVE, P, 2.\n*CLOAD\n")
        deck.write("".join(f"{node + 1}, 3, 1.\n" for node in range(layer * cells, layer * across)) + "*END STEP\n")
    with open(path) as deck:
        return sum(1 for _ in deck)


def cpu_time():
    """Of all processes that have ended [s]."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
per_line = []
for cells in CELLS:
    path = WORK / f"cube_{cells}.inp"
    lines = write_cube(path, cells)
    begin = cpu_time()
    end = subprocess.run([HARMOS, "import", path, "--output", WORK / f"scene_{cells}"], capture_output=True, text=True)
    assert end.returncode == 0, end.stderr
    assert f"{(cells + 1)**3} nodes, {cells**3} elements" in end.stdout, end.stdout
    taken = cpu_time() - begin
    per_line.append(taken / lines)
    print(f"{lines} lines: {taken:.1f} s")
    path.unlink()
assert lines > 1e6, lines
sys.exit(per_line[-1] > 2.0 * per_line[0])
