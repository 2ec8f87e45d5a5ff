#!/usr/bin/env python3
"""CPU time per configuration of a whole study of Harmos against one run of CalculiX on the same joint, one thread each.

The study is the whole process: mesh, factors, calibration, audits, files. The run of CalculiX is that of
compare_with_calculix.py, which needs minutes; --calculix-seconds takes its CPU time from an earlier run instead. Exit
code 1 when the ratio is below --goal or a configuration has no solution.

  study_throughput.py --harmos build/drivers/harmos --deck-writer build/tests/benchmarks/calculix_deck
"""
import argparse
import csv
import glob
import os
import sys
import tempfile

from compare_with_calculix import HERE, ROOT, read_reference, run, run_calculix

SOLVED = ("certified", "calibrated")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--study", default=os.path.join(ROOT, "xml", "bolted_joint_study.xml"))
    parser.add_argument("--set", action="append", default=[], help="handed to the study, such as Accuracy=1e-3")
    parser.add_argument("--calculix-seconds", type=float, help="CPU time of a run of CalculiX; else it is run")
    parser.add_argument("--deck-writer", help="tests/benchmarks/calculix_deck of the build")
    parser.add_argument("--calculix", default="ccx")
    parser.add_argument("--scene", default=os.path.join(ROOT, "xml", "bolted_joint.xml"))
    parser.add_argument("--reference", default=os.path.join(HERE, "bolted_joint_reference.csv"))
    parser.add_argument("--penalty", type=float, default=7e5, help="pressure per overclosure")
    parser.add_argument("--stick", type=float, default=0.1, help="stick slope per penalty")
    parser.add_argument("--goal", type=float, default=1000.0)
    arguments = parser.parse_args()
    if arguments.calculix_seconds is None and not arguments.deck_writer:
        parser.error("give --calculix-seconds, or --deck-writer to run CalculiX")
    for name in ("harmos", "deck_writer", "scene", "study"):
        if getattr(arguments, name):
            setattr(arguments, name, os.path.abspath(getattr(arguments, name)))

    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    with tempfile.TemporaryDirectory() as directory:
        command = [arguments.harmos, "study", arguments.study, "--output", directory]
        for change in arguments.set:
            command += ["--set", change]
        log = os.path.join(directory, "harmos.log")
        code, seconds, wall, _ = run(command, directory, log, environment)
        if code != 0:
            with open(log) as file:
                sys.exit("Harmos failed:\n" + file.read())
        name = os.path.splitext(os.path.basename(arguments.study))[0]
        (table,) = glob.glob(os.path.join(directory, name + ".csv"))
        with open(table) as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        calculix = arguments.calculix_seconds
        if calculix is None:
            calculix = run_calculix(arguments, arguments.penalty, directory, environment,
                                    read_reference(arguments.reference))["cpu"]
    solved = sum(row["status"] in SOLVED for row in rows)
    ratio = calculix * len(rows) / seconds
    print(f"{len(rows)} configurations, {solved} solved: {seconds:.0f} s CPU, {wall:.0f} s wall, "
          f"{seconds / len(rows):.3f} s CPU per configuration")
    print(f"one run of CalculiX: {calculix:.0f} s CPU; ratio {ratio:.0f}")
    return 0 if solved == len(rows) and ratio >= arguments.goal else 1


if __name__ == "__main__":
    sys.exit(main())
