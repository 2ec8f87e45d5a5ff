#!/usr/bin/python3
"""Draws an angle bracket on a plate, held by two bolts, as a STEP file [mm]: bolted_bracket.py FILE.step [HOLE]

The bolts, of diameter 8, have their threads in the plate and holes in the bracket, of diameter 9 unless HOLE says otherwise.
"""
import pathlib
import re
import sys

import gmsh


def draw(hole_diameter: float) -> dict[str, int]:
    """The solids by name."""
    kernel = gmsh.model.occ
    plate = kernel.addBox(-40, -30, -15, 80, 60, 15)
    foot, wall = kernel.addBox(-30, -20, 0, 60, 40, 8), kernel.addBox(-30, -20, 8, 8, 40, 40)
    bracket = kernel.fuse([(3, foot)], [(3, wall)])[0][0][1]
    result = {}
    for number, y in ((1, -10), (2, 10)):
        hole = kernel.addCylinder(10, y, 0, 0, 0, 8, hole_diameter / 2)
        bracket = kernel.cut([(3, bracket)], [(3, hole)])[0][0][1]
        thread = kernel.addCylinder(10, y, -12, 0, 0, 12, 4)
        plate = kernel.cut([(3, plate)], [(3, thread)])[0][0][1]
        shank, head = kernel.addCylinder(10, y, -12, 0, 0, 20, 4), kernel.addCylinder(10, y, 8, 0, 0, 5, 7)
        result[f"bolt_{number}"] = kernel.fuse([(3, shank)], [(3, head)])[0][0][1]
    return {"plate": plate, "bracket": bracket, **result}


def main() -> None:
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    solids = draw(float(sys.argv[2]) if len(sys.argv) > 2 else 9.0)
    gmsh.model.occ.synchronize()
    gmsh.write(sys.argv[1])
    gmsh.finalize()
    # Gmsh 4.8 writes no names: those of the products are put in their places.
    path, names = pathlib.Path(sys.argv[1]), list(solids)
    path.write_text(re.sub(r"'Open CASCADE STEP translator [\d.]+ 1\.(\d)'", lambda match: f"'{names[int(match[1]) - 1]}'",
                           path.read_text()))


if __name__ == "__main__":
    main()
