#!/usr/bin/python3
"""Holds all claims of a study of blocks that slide against one a hundred times as accurate or more: none is false.

claims.py HARMOS STUDY.xml WORK_DIR VARIANTS [ACCURACY...]

The study is varied: other friction coefficients, VARIANTS times. What is lost in the joint is a hundredth of what forces
do, so that its errors are large beside it; the error of a response is relative to its own size. Besides, each study is
resumed from parts of its journal, as after a kill, and solved one configuration after the other: no such study claims
anything false either.
"""
import json
import pathlib
import shutil
import subprocess
import sys

import numpy

from checks import check, finish

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
from harmos import read_study

HARMOS, STUDY, WORK, VARIANTS = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), int(sys.argv[4])
ACCURACIES = [float(accuracy) for accuracy in sys.argv[5:]] or [1e-3, 1e-4]
TIGHT = 1e-7
PARTS = 4  # of a journal, that a study is resumed from


def solve(directory, variant, accuracy, *changes):
    """The study in its file; it is resumed where there is a journal."""
    done = subprocess.run([HARMOS, "study", str(STUDY), "--output", str(directory), "--quiet",
                           "--set", "Parameters/mu/Count=30", "--set", f"Parameters/mu/From={0.3 + 7e-4 * variant}",
                           "--set", f"Parameters/mu/To={0.5 - 5e-4 * variant}", "--set", f"Accuracy={accuracy}",
                           *(word for change in changes for word in ("--set", change))],
                          check=False)
    # 3: an audit may find a larger error than was accepted, which is then put right.
    check(done.returncode in (0, 3), f"exit code {done.returncode} of {directory}")
    return read_study(directory / f"{STUDY.stem}.h5")


def judge(what, study, reference, accuracy):
    """The largest error of a response over the accuracy, and how many claims are false."""
    check(study.solved.all(), f"{what}: all are solved")
    errors = numpy.array([numpy.abs(study.responses[name] - values) / numpy.abs(values)
                          for name, values in reference.responses.items()]).max(axis=0)
    false = int((errors > accuracy).sum())
    worst = int(errors.argmax())
    check(false == 0, f"{what}: {false} of {errors.size} claims are false, configuration {study.id[worst]} by "
                      f"{errors[worst] / accuracy:.2f} of the accuracy, {study.error_estimate[worst]:.1e} claimed")
    return errors[worst] / accuracy, errors.size


def calibrations(directory):
    """How many configurations of all runs of a study have calibrated it."""
    records = [json.loads(line[9:]) for line in (directory / f"{STUDY.stem}.journal").read_bytes().splitlines()]
    return len({record["id"] for record in records if "ratios" in record and "audit" not in record})


shutil.rmtree(WORK, ignore_errors=True)
worst, claims = 0.0, 0
for variant in range(VARIANTS):
    reference = solve(WORK / f"{variant}_reference", variant, TIGHT)
    for accuracy in ACCURACIES:
        whole = WORK / f"{variant}_{accuracy:g}"
        alone = WORK / f"{variant}_{accuracy:g}_alone"
        studies = {str(whole): solve(whole, variant, accuracy),
                   str(alone): solve(alone, variant, accuracy, "Side by Side=1")}
        lines = (whole / f"{STUDY.stem}.journal").read_bytes().splitlines(keepends=True)
        for part in range(1, PARTS):
            # Most kinds of lines are among the first.
            kept = 2 + (len(lines) - 2) * part**2 // PARTS**2
            resumed = WORK / f"{variant}_{accuracy:g}_from_{kept}"
            resumed.mkdir(parents=True)
            (resumed / f"{STUDY.stem}.journal").write_bytes(b"".join(lines[:kept]))
            studies[str(resumed)] = solve(resumed, variant, accuracy)
            check(calibrations(resumed) <= calibrations(whole), f"{resumed} calibrates once")
        for what, study in studies.items():
            largest, count = judge(what, study, reference, accuracy)
            worst, claims = max(worst, largest), claims + count
print(f"{claims} claims, the largest error {worst:.2f} of the accuracy")
finish()
