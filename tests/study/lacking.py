#!/usr/bin/python3
"""Random configurations of which some have no solution, in every design: what is said of them, and of the moments.

lacking.py HARMOS WORK_DIR

A plate of the height h lies on the ground by friction mu under a pressure p, and its side is drawn with a force of 0.3 p A:
where mu is below 0.3 nothing holds it.
"""
import pathlib
import shutil
import subprocess
import sys

from checks import check, finish
from lists import entries, entry, law

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
HEIGHT, SHARE, LEAST, MOST = 0.05, 0.3, 0.1, 0.6


def write():
    scene = entries(
        "Harmos", entries("Values", entry("mu", 0.5)),
        entries("Mesh", entry("Type", "Boxes"),
                entries("Boxes", entries("plate", entry("Lower Corner", "{0, 0, 0}"),
                                         entry("Upper Corner", f"{{1, 1, {HEIGHT}}}"), entry("Cells", "{4, 4, 1}")))),
        entries("Materials", entries("m", entry("Type", "Isotropic"), entry("Young's Modulus", 1000.0),
                                     entry("Poisson's Ratio", 0.3))),
        entries("Parts", entries("plate", entry("Material", "m"))),
        entries("Boundaries",
                entries("ground", entry("Side Set", "plate_zmin"),
                        law("Coulomb Friction", entry("Friction Coefficient", "$mu"))),
                entries("weight", entry("Side Set", "plate_zmax"),
                        law("Prescribed Traction", entry("X", SHARE), entry("Z", -1.0)))),
        entries("Steps", entries("only")),
        entries("Responses", entries("way", entry("Type", "Mean Displacement"), entry("Side Set", "plate_zmax"),
                                     entry("Direction", "{1, 0, 0}"))))
    study = entries(
        "Harmos Study", entry("Scene", "plate.xml"),
        entries("Parameters", entries("mu", entry("Entry", "Values/mu"),
                                      entries("Distribution", entry("Type", "Uniform"), entry("Lower", LEAST),
                                              entry("Upper", MOST)))),
        entries("Design", entry("Type", "Chaos")),
        entries("Responses", entries("way", entry("Type", "Final"), entry("Response", "way"))))
    (WORK / "plate.xml").write_text(scene)
    path = WORK / "study.xml"
    path.write_text(study)
    return path


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    study = write()
    for design, changes, code, said in (
            ("Random", ["Count=12"], 4, "draws have no solution and are left out of all figures"),
            ("Latin Hypercube", ["Count=12"], 4, "draws have no solution and are left out of all figures"),
            ("Sobol", ["Count=12"], 4, "draws have no solution and are left out of all figures"),
            ("Chaos", ["Order=2"], 3, "expansions: NOT all that was asked for"),
            ("Collocation", ["Order=3"], 4, "moments: none, since 2 of the 4 points of the quadrature have no solution"),
            ("Adaptive Collocation", [], 4, "has no solution, without which it cannot go on")):
        words = [word for change in [f"Type={design}", *changes] for word in ("--set", f"Design/{change}")]
        done = subprocess.run([HARMOS, "study", str(study), "--output", str(WORK / "results"), "--restart", *words],
                              capture_output=True, text=True)
        text = done.stdout + done.stderr
        check(done.returncode == code, f"{design}: exit code {done.returncode} for {code}\n{text}")
        check(said in text, f"{design}: \"{said}\" is not said\n{text}")
        check(" no equilibrium" in text, f"{design}\n{text}")
    finish()


main()
