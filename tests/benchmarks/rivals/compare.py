#!/usr/bin/python3
"""Harmos beside its rivals on the bolted joint: whole processes, one thread, in turns, on the same mesh.

  harmos          LATIN to the accuracy asked for, certificate and all result files included
  bare harmos     the same without the error of the mesh, which the others do not estimate either
  condensed       joint_rivals: condensed once to the contact jumps, semi-smooth Newton, GMRES with reused factors
  condensed tight the same to a residual of 1e-8; the others' errors are distances from it
  sparse          joint_rivals: semi-smooth Newton, one sparse factorisation by MUMPS per iteration
  getfem          getfem_joint.py, where python3-getfem is installed; its mesh, of harmos mesh, is free of charge
  calculix        with --calculix, on refinement 1

An error is the largest distance of the load-displacement curve, over its largest value; bolt forces and contact pressures
likewise where a program prints them. Every program must be within --accuracy before times are compared: else exit code 1.
CPU time and memory are medians, ratios to bare harmos medians of those of each turn. --study compares configurations of
xml/bolted_joint_study.xml per configuration, with the largest force of each: 27 that are far apart, or with --sample N
all of them, of which the rival solves N spread over the grid. To what it needs for one of these beyond the first it then
gets its share of the first, which condenses: as if it had solved all.

  rivals/compare.py --harmos build/drivers/harmos --build build --refinements 0.5 1 1.5 --runs 5 --study
"""
import argparse
import csv
import importlib.util
import io
import json
import os
import pathlib
import statistics
import sys
import tempfile
import types
import xml.etree.ElementTree as xml

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(HERE.parent))
import compare_with_calculix as pair  # noqa: E402

TIGHT = 1e-8
# What a residual leaves of errors: found by trying on refinement 0.5, the loosest of 10^-n that are accurate to 1e-3.
GETFEM_RESIDUAL = 1e-5
# Overrides of the grid of the study, 27 of its 1296 configurations.
COARSE = {"mu": 3, "preload_1": 3, "preload_2": 3}


def read_table(text):
    """Columns of CSV without comments, as numbers where they are."""
    rows = list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def word_after(text, word):
    """The number that follows a word in the comments of a program."""
    words = " ".join(line for line in text.splitlines() if line.startswith("#")).replace(",", " ").split()
    return int(words[words.index(word) + 1])


class Rivals:
    """The programs, run on one scene in a folder of their own."""

    def __init__(self, arguments, overrides, folder):
        self.arguments, self.overrides, self.folder = arguments, overrides, folder
        self.scene = str(ROOT / "xml" / "bolted_joint.xml")
        self.sets = [word for override in overrides for word in ("--set", override)]
        self.environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", CCX_NPROC_EQUATION_SOLVER="1")
        self.mesh = os.path.join(folder, "joint.e")

    def run(self, command):
        log = os.path.join(self.folder, "log")
        code, cpu, _, memory = pair.run([str(word) for word in command], self.folder, log, self.environment)
        text = pathlib.Path(log).read_text()
        if code != 0:
            sys.exit(f"{command[0]} ended with {code}:\n{text}")
        return cpu, memory, text

    def harmos(self, mesh_error):
        command = [self.arguments.harmos, "run", self.scene, "--output", self.folder, "--quiet", *self.sets]
        cpu, memory, _ = self.run([*command, "--set", f"Solver/Accuracy={self.arguments.accuracy}", "--set",
                                   f"Solver/Mesh Error={str(mesh_error).lower()}"])
        table = read_table(pathlib.Path(self.folder, "bolted_joint_history.csv").read_text())
        table = {name: values[1:] for name, values in table.items()}  # others print no unloaded state
        record = json.loads(pathlib.Path(self.folder, "bolted_joint_result.json").read_text())
        return cpu, memory, table, f"{record['linear_stages']} stages"

    def newton(self, method, residual, *more):
        program = os.path.join(self.arguments.build, "tests", "benchmarks", "joint_rivals")
        cpu, memory, text = self.run([program, method, self.scene, "--residual", residual, *self.sets, *more])
        note = f"{word_after(text, 'iterations')} iterations, {word_after(text, 'factorisations')} factors"
        return cpu, memory, read_table(text), note

    def getfem(self):
        if not os.path.exists(self.mesh):
            self.run([self.arguments.harmos, "mesh", self.scene, "--output", self.mesh, *self.sets])
        cpu, memory, text = self.run(["/usr/bin/python3", HERE / "getfem_joint.py", self.scene, self.mesh, "--residual",
                                      GETFEM_RESIDUAL])
        return cpu, memory, read_table(text), f"{word_after(text, 'iterations')} iterations"

    def calculix(self, reference):
        settings = types.SimpleNamespace(scene=self.scene, stick=0.1, calculix="ccx", deck_writer=os.path.join(
            self.arguments.build, "tests", "benchmarks", "calculix_deck"))
        curve = {round(time, 6): u for time, u in zip(reference["time"], reference["u_load"])}
        result = pair.run_calculix(settings, self.arguments.penalty, self.folder, self.environment, curve)
        return result["cpu"], result["memory"], result["error"], f"{result['iterations']} iterations"


def error_of(table, reference):
    """The largest of all columns that both have."""
    worst = 0.0
    for name in set(table) & set(reference) - {"time", "configuration", "reaction"}:
        size = max(map(abs, reference[name]))
        worst = max(worst, max(abs(a - b) for a, b in zip(table[name], reference[name], strict=True)) / size)
    return worst


def compare_runs(arguments, refinement):
    """Prints a table; whether all programs are accurate."""
    with tempfile.TemporaryDirectory() as folder:
        rivals = Rivals(arguments, [f"Mesh/Refinement={refinement:g}"], folder)
        programs = {"harmos": lambda: rivals.harmos(True), "bare harmos": lambda: rivals.harmos(False),
                    "condensed": lambda: rivals.newton("condensed", arguments.residual),
                    "condensed tight": lambda: rivals.newton("condensed", TIGHT)}
        if refinement <= arguments.slow_until:
            programs["sparse"] = lambda: rivals.newton("sparse", arguments.residual)
            if importlib.util.find_spec("getfem"):
                programs["getfem"] = rivals.getfem
            else:
                print("GetFEM is not installed: apt-get install python3-getfem")
        slow = ("sparse", "getfem")
        runs = {name: [] for name in programs}
        for turn in range(arguments.runs):
            for name, program in programs.items():
                if name not in slow or turn < arguments.slow_runs:
                    runs[name].append(program())
        reference = runs["condensed tight"][0][2]
        rows = {name: (all_runs, max(error_of(one[2], reference) for one in all_runs)) for name, all_runs in runs.items()}
        if arguments.calculix and refinement == 1:
            one = rivals.calculix(reference)
            rows["calculix"] = ([one], one[2])
        print(f"\nRefinement {refinement:g}:\n\n| | error | CPU s | ratio | peak memory MB | |\n|---|---|---|---|---|---|")
        for name, (all_runs, error) in rows.items():
            ratio = statistics.median(one[0] / harmos[0] for one, harmos in zip(all_runs, runs["bare harmos"]))
            cpu, memory = (statistics.median(one[i] for one in all_runs) for i in (0, 1))
            print(f"| {name} | {error:.1e} | {cpu:.2f} | {ratio:.1f} | {memory:.0f} | {all_runs[0][3]} |", flush=True)
        wrong = [name for name, (_, error) in rows.items() if not error <= arguments.accuracy]
        if wrong:
            print("NOT within the accuracy asked for: " + ", ".join(wrong))
        return not wrong


def levels(study, counts):
    """The configurations of the grid, with other counts where they are given, as overrides, in the order of Harmos."""
    result = [[]]
    for parameter in entry_of(study, "Parameters"):
        first, last = (float(entry_of(parameter, name).get("value")) for name in ("From", "To"))
        place = entry_of(parameter, "Entry").get("value")
        count = counts.get(parameter.get("name")) or int(entry_of(parameter, "Count").get("value"))
        values = [first + (last - first) * i / (count - 1) for i in range(count)]
        result = [[*one, f"{place}={value!r}"] for one in result for value in values]
    return result


def entry_of(parent, name):
    return next(child for child in parent if child.get("name") == name)


def compare_studies(arguments):
    path = ROOT / "xml" / "bolted_joint_study.xml"
    study = xml.parse(path).getroot()
    overrides = [one.strip() for one in entry_of(study, "Scene Overrides").get("value").strip("{}").split(",")]
    counts = {} if arguments.sample else COARSE
    configurations = levels(study, counts)
    every = max(1, len(configurations) // arguments.sample) if arguments.sample else 1
    chosen = range(0, len(configurations), every)
    with tempfile.TemporaryDirectory() as folder:
        rivals = Rivals(arguments, overrides, folder)

        def condensed(residual, numbers):
            table = os.path.join(folder, "configurations")
            pathlib.Path(table).write_text("".join(" ".join(configurations[number]) + "\n" for number in numbers))
            return rivals.newton("condensed", residual, "--configurations", table)

        def newton(residual):
            cpu, memory, columns, _ = condensed(residual, chosen)
            largest = [max(f for f, c in zip(columns["reaction"], columns["configuration"]) if c == place)
                       for place in range(len(chosen))]
            if len(chosen) == len(configurations):
                return cpu / len(chosen), memory, largest
            first = condensed(residual, chosen[:1])[0]
            return (cpu - first) / (len(chosen) - 1) + first / len(configurations), memory, largest

        def harmos(accuracy):
            command = [arguments.harmos, "study", path, "--output", folder, "--set", f"Accuracy={accuracy:g}"]
            for name, count in counts.items():
                command += ["--set", f"Parameters/{name}/Count={count}"]
            cpu, memory, _ = rivals.run(command)
            found = read_numbers(os.path.join(folder, "bolted_joint_study.csv"))
            for file in pathlib.Path(folder).glob("bolted_joint_study*"):
                file.unlink()
            return cpu / len(configurations), memory, [found[number] for number in chosen]

        exact = newton(TIGHT)
        programs = {"harmos, 1e-2": lambda: harmos(1e-2)}
        if not arguments.sample:
            programs["harmos, 1e-3"] = lambda: harmos(1e-3)
        programs[f"condensed, residual {arguments.residual:g}"] = lambda: newton(arguments.residual)
        runs = {name: [] for name in programs}
        for _ in range(arguments.study_runs):
            for name, program in programs.items():
                runs[name].append(program())
        runs[f"condensed, residual {TIGHT:g}"] = [exact]
        print(f"\nStudy, {len(configurations)} configurations, errors at {len(chosen)}:\n\n| | largest error of F_max | "
              "CPU s per configuration | peak memory MB |\n|---|---|---|---|")
        is_right = True
        for name, all_runs in runs.items():
            error = max(abs(a / b - 1) for one in all_runs for a, b in zip(one[2], exact[2], strict=True))
            cpu, memory = (statistics.median(one[i] for one in all_runs) for i in (0, 1))
            print(f"| {name} | {error:.1e} | {cpu:.3f} | {memory:.0f} |", flush=True)
            is_right = is_right and error <= 1e-2
        return is_right


def read_numbers(path):
    """F_max of all configurations."""
    with open(path) as file:
        return [float(row["F_max"]) for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--build", required=True, help="folder of the build, for tests/benchmarks/joint_rivals")
    parser.add_argument("--refinements", type=float, nargs="*", default=[0.5, 1.0], help="of the joint's mesh")
    parser.add_argument("--accuracy", type=float, default=1e-3, help="of all")
    parser.add_argument("--residual", type=float, default=1e-3, help="of Newton's method")
    parser.add_argument("--runs", type=int, default=3, help="turns; medians are printed")
    parser.add_argument("--slow-runs", type=int, default=1, help="turns of sparse and getfem")
    parser.add_argument("--slow-until", type=float, default=1.0, help="largest refinement for sparse and getfem")
    parser.add_argument("--calculix", action="store_true", help="run CalculiX, too; takes minutes")
    parser.add_argument("--penalty", type=float, default=7e5, help="of CalculiX, pressure per overclosure")
    parser.add_argument("--study", action="store_true", help="compare studies, too")
    parser.add_argument("--study-runs", type=int, default=1)
    parser.add_argument("--sample", type=int, default=0, help="with --study: all configurations, of which the rival "
                        "solves so many; 0: 27 of them")
    arguments = parser.parse_args()
    arguments.harmos, arguments.build = os.path.abspath(arguments.harmos), os.path.abspath(arguments.build)
    right = [compare_runs(arguments, refinement) for refinement in arguments.refinements]
    if arguments.study:
        right.append(compare_studies(arguments))
    return 0 if all(right) else 1


if __name__ == "__main__":
    sys.exit(main())
