#!/usr/bin/python3
"""Chains of blocks joined by random springs, by polynomial chaos: which local stage is chosen, what is forecast, what is
refused: springs.py HARMOS WORK_DIR

The displacement of the end of n springs is u = F sum of 1/k_i + F (n - 1)/E; with lognormal k_i of mean k and coefficient
of variation d, 1/k_i is lognormal with the mean (1 + d^2)/k and the same coefficient of variation.
"""
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

from checks import check, finish
from lists import box, entries, entry, guided, law

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
FORCE, MODULUS, STIFFNESS, SPREAD = 100.0, 1e4, 1000.0, 0.2


def write_chain(count):
    """The scene and the study of a chain of so many blocks and springs; the path of the study."""
    blocks = [f"b{i}" for i in range(count)]
    boxes = [box(name, i) for i, name in enumerate(blocks)]
    springs = [entries(f"i{i}", entry("Side 1", f"b{i - 1}_xmax"), entry("Side 2", f"b{i}_xmin"),
                       law("Linear Elastic", entry("Tangential Stiffness", 0.0), entry("Normal Stiffness", f"$k{i}")))
               for i in range(1, count)]
    ground = entries("ground", entry("Side Set", "b0_xmin"),
                     law("Elastic Foundation", entry("Normal Stiffness", "$k0")))
    load = entries("load", entry("Side Set", f"b{count - 1}_xmax"), law("Prescribed Traction", entry("X", FORCE)))
    scene = entries(
        "Harmos", entries("Values", *[entry(f"k{i}", STIFFNESS) for i in range(count)]),
        entries("Mesh", entry("Type", "Boxes"), entries("Boxes", *boxes)),
        entries("Materials", entries("m", entry("Type", "Isotropic"), entry("Young's Modulus", MODULUS),
                                     entry("Poisson's Ratio", 0.0))),
        entries("Parts", *[entries(name, entry("Material", "m")) for name in blocks]),
        *([entries("Interfaces", *springs)] if springs else []), entries("Boundaries", *guided(blocks), ground, load),
        entries("Steps", entries("only")),
        entries("Responses", entries("u", entry("Type", "Mean Displacement"), entry("Side Set", f"b{count - 1}_xmin"),
                                     entry("Direction", "{1, 0, 0}"))))
    lognormal = entries("Distribution", entry("Type", "Lognormal"), entry("Mean", STIFFNESS),
                        entry("Coefficient of Variation", SPREAD))
    study = entries(
        "Harmos Study", entry("Scene", f"chain{count}.xml"), entry("Accuracy", 1e-6),
        entries("Parameters", *[entries(f"k{i}", entry("Entry", f"Values/k{i}"), lognormal) for i in range(count)]),
        entries("Design", entry("Type", "Chaos"), entry("Order", 2), entry("Hold-Out Count", 0)),
        entries("Responses", entries("u", entry("Type", "Final"), entry("Response", "u"))))
    (WORK / f"chain{count}.xml").write_text(scene)
    path = WORK / f"chain{count}_study.xml"
    path.write_text(study)
    return path


def harmos(verb, study, *changes, limit=None):
    """Exit code, what is printed, and peak memory [MB]. `limit`: of the address space [byte]."""
    words = [HARMOS, verb, str(study)] + (["--output", str(WORK / "results"), "--restart"] if verb == "study" else [])
    words += [word for change in changes for word in ("--set", change)]
    restrict = limit and (lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    output = WORK / "output.txt"
    with open(output, "w") as file:
        process = subprocess.Popen(words, stdout=file, stderr=subprocess.STDOUT, preexec_fn=restrict)
        _, status, usage = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), output.read_text(), usage.ru_maxrss / 1024


def exact(count):
    inverse = (1.0 + SPREAD**2) / STIFFNESS
    return FORCE * (count * inverse + (count - 1) / MODULUS), FORCE * SPREAD * inverse * math.sqrt(count)


def solve(study, count, stage, changes=()):
    """The chosen local stage, the moments to what order 2 allows, and the forecast of the memory."""
    code, text, _ = harmos("check", study, *changes)
    check(code == 0, f"check ends with {code}\n{text}")
    check(f"{stage} local stage" in text, f"{study.stem} {changes}: not {stage}\n{text}")
    found = re.search(r"memory in all *([0-9.]+) MB", text)
    check(found, f"no forecast of the memory\n{text}")
    code, text, measured = harmos("study", study, *changes)
    check(code == 0 and f"{stage} local stage" in text, f"{study.stem} {changes}: {code}\n{text}")
    if found:
        check(0.5 < float(found[1]) / measured < 2, f"{study.stem} {changes}: {found[1]} MB, measured {measured:.0f} MB")
    row = re.search(r"^  u  +(\S+) +(\S+)", text, re.MULTILINE)
    mean, deviation = exact(count)
    check(row and abs(float(row[1]) - mean) < 2e-4 * mean, f"{study.stem}: mean of {text}, exact {mean}")
    check(row and abs(float(row[2]) - deviation) < 4e-3 * deviation, f"{study.stem}: std of {text}, exact {deviation}")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
# One lognormal spring costs next to nothing either way; five, of which Galerkin asks 59049 points, a hundred times.
solve(write_chain(1), 1, "Galerkin")
# Without responses there is nothing to summarise: the study ends all the same.
for design in "Chaos", "Collocation":
    mute = WORK / f"mute_{design}.xml"
    mute.write_text(re.sub('<ParameterList name="Responses">.*?</ParameterList>\s*</ParameterList>', "",
                           write_chain(1).read_text().replace('"Chaos"', f'"{design}"'), flags=re.DOTALL))
    check("Responses" not in mute.read_text(), mute.read_text())
    code, text, _ = harmos("study", mute)
    check(code == 0, f"{design} without responses: {code}\n{text}")
five = write_chain(5)
solve(five, 5, "pseudo-spectral")
# What is asked for is done; the forecast holds for it, too.
solve(five, 5, "Galerkin", ("Design/Local Stage=Galerkin", "Design/Points=6"))
# With eight, 9^8 points: it was tried, and ended by the machine.
eight = write_chain(8)
code, text, _ = harmos("check", eight)
check(code == 0 and "because Galerkin has too many points" in text, text)
code, text, _ = harmos("check", eight, "Design/Local Stage=Galerkin")
check(code == 2 and "more than 100000 points" in text, text)
# More than there is memory for is refused before anything is written.
for verb in "check", "study":
    code, text, _ = harmos(verb, eight, "Design/Order=3", limit=400 * 2**20)
    check(code == 2 and "GB are free" in text and "lower Order" in text, f"{verb} ends with {code}\n{text}")
shutil.rmtree(WORK / "results", ignore_errors=True)
harmos("study", eight, "Design/Order=3", limit=400 * 2**20)
check(not (WORK / "results").exists(), "a study that does not fit has written something")
finish()
