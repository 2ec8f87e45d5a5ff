#!/usr/bin/env python3
"""Harmos against CalculiX on one scene: whole processes, one thread, in pairs, at equal true error.

The deck of CalculiX is written from the scene. A run of Harmos includes the certificate and all result files; a second
one leaves out the error of the mesh, which CalculiX does not estimate. CPU
time is that of the process and its children; memory is the largest resident set. The error is the largest distance of
the load-displacement curve from the reference, relative to its largest value. CalculiX enforces contact by penalty:
with --search, the penalties given are tried from the softest on and the first one that is accurate enough is used.

  compare_with_calculix.py --harmos build/drivers/harmos --deck-writer build/tests/benchmarks/calculix_deck
"""
import argparse
import csv
import json
import os
import re
import statistics
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def run(command, directory, log, environment):
    """Runs a process; its exit code, CPU seconds, wall seconds and peak memory in MB."""
    start = time.monotonic()
    child = os.fork()
    if child == 0:
        os.chdir(directory)
        out = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o644)
        os.dup2(out, 1)
        os.dup2(out, 2)
        try:
            os.execvpe(command[0], command, environment)
        except OSError as error:
            os.write(2, f"{command[0]}: {error}\n".encode())
        os._exit(127)
    _, status, usage = os.wait4(child, 0)
    return (os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, time.monotonic() - start,
            usage.ru_maxrss / 1024)


def read_reference(path):
    with open(path) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {round(float(row["time"]), 6): float(row["u_load"]) for row in rows}


def error_of(curve, reference):
    missing = set(reference) - set(curve)
    if missing:
        return float("nan")
    size = max(abs(value) for value in reference.values())
    return max(abs(curve[t] - value) for t, value in reference.items()) / size


def harmos_curve(directory, scene):
    with open(os.path.join(directory, scene + "_history.csv")) as file:
        return {round(float(row["time"]), 6): float(row["u_load"]) for row in csv.DictReader(file)}


def calculix_curve(deck, dat):
    """The mean of u_load in the printed displacements, with the weights that stand in the deck's comments."""
    weights, direction = {}, None
    with open(deck) as file:
        for line in file:
            if line.startswith("** MEAN u_load"):
                direction = [float(word) for word in line.split()[3:]]
            elif line.startswith("** MEAN"):
                direction = None
            elif line.startswith("** WEIGHT") and direction:
                node, weight = line.split()[2:]
                weights[int(node)] = weights.get(int(node), 0.0) + float(weight)
                unit = direction
    length = sum(c * c for c in unit) ** 0.5
    curve, now = {}, None
    with open(dat) as file:
        for line in file:
            header = re.match(r" displacements .* for set MEAN_U_LOAD and time\s+(\S+)", line)
            if header:
                now = round(float(header.group(1)), 6)
                curve[now] = 0.0
            elif line.strip() and not re.match(r"\s+\d+(\s+[-+.\dE]+){3}$", line):
                now = None
            elif line.strip() and now is not None:
                node, *u = line.split()
                curve[now] += weights[int(node)] * sum(float(a) * b for a, b in zip(u, unit)) / length
    return curve


def run_calculix(arguments, penalty, directory, environment, reference):
    deck = os.path.join(directory, "deck.inp")
    writer = [arguments.deck_writer, arguments.scene, str(penalty), str(arguments.stick * penalty)]
    code, *_ = run(writer, directory, deck, environment)
    if code != 0:
        sys.exit(f"the deck could not be written; see {deck}")
    code, cpu, wall, memory = run([arguments.calculix, "deck"], directory, "calculix.log", environment)
    if code != 0:
        sys.exit(f"CalculiX failed; see {directory}/calculix.log")
    with open(os.path.join(directory, "deck.sta")) as file:
        iterations = sum(int(line.split()[3]) for line in file if re.match(r"\s*\d", line))
    error = error_of(calculix_curve(deck, os.path.join(directory, "deck.dat")), reference)
    return {"cpu": cpu, "wall": wall, "memory": memory, "error": error, "iterations": iterations}


def run_harmos(arguments, directory, environment, reference, mesh_error=True):
    command = [arguments.harmos, "run", arguments.scene, "--output", directory, "--quiet", "--set",
               f"Solver/Accuracy={arguments.accuracy}", "--set", f"Solver/Mesh Error={str(mesh_error).lower()}"]
    code, cpu, wall, memory = run(command, directory, "harmos.log", environment)
    scene = os.path.splitext(os.path.basename(arguments.scene))[0]
    if code != 0:
        sys.exit(f"Harmos failed; see {directory}/harmos.log and {directory}/{scene}_result.json")
    with open(os.path.join(directory, scene + "_result.json")) as file:
        result = json.load(file)
    return {"cpu": cpu, "wall": wall, "memory": memory,
            "error": error_of(harmos_curve(directory, scene), reference), "iterations": result["iterations"],
            "stages": result["linear_stages"], "estimate": result["error_estimate"], "status": result["status"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--deck-writer", required=True, help="tests/benchmarks/calculix_deck of the build")
    parser.add_argument("--calculix", default="ccx")
    parser.add_argument("--scene", default=os.path.join(ROOT, "xml", "bolted_joint.xml"))
    parser.add_argument("--reference", default=os.path.join(HERE, "bolted_joint_reference.csv"))
    parser.add_argument("--accuracy", type=float, default=1e-3, help="of both, largest true error")
    parser.add_argument("--penalty", type=float, nargs="+", default=[7e5], help="pressure per overclosure")
    parser.add_argument("--stick", type=float, default=0.1, help="stick slope per penalty")
    parser.add_argument("--search", action="store_true", help="take the softest penalty that is accurate enough")
    parser.add_argument("--runs", type=int, default=1, help="pairs of runs; medians are printed")
    parser.add_argument("--goal", type=float, default=100.0, help="exit code 1 when the CPU ratio is below")
    arguments = parser.parse_args()
    for name in ("harmos", "deck_writer", "scene"):
        setattr(arguments, name, os.path.abspath(getattr(arguments, name)))

    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    reference = read_reference(arguments.reference)
    penalty = arguments.penalty[0]
    with tempfile.TemporaryDirectory() as directory:
        if arguments.search:
            for penalty in sorted(arguments.penalty):
                result = run_calculix(arguments, penalty, directory, environment, reference)
                print(f"CalculiX, penalty {penalty:.3g}: true error {result['error']:.2e}, {result['iterations']} "
                      f"iterations, {result['cpu']:.1f} s CPU", flush=True)
                if result["error"] <= arguments.accuracy:
                    break
            else:
                sys.exit("no penalty is accurate enough")
        harmos, without, calculix = [], [], []
        for _ in range(arguments.runs):
            harmos.append(run_harmos(arguments, directory, environment, reference))
            without.append(run_harmos(arguments, directory, environment, reference, mesh_error=False))
            calculix.append(run_calculix(arguments, penalty, directory, environment, reference))

    def median(runs, key):
        return statistics.median(one[key] for one in runs)

    print(f"medians of {arguments.runs} pairs; penalty {penalty:.3g}, stick slope {arguments.stick * penalty:.3g}\n")
    print("| | CPU s | wall s | peak memory MB | true error of u_load | iterations |")
    print("|---|---|---|---|---|---|")
    stages = f" ({harmos[0]['stages']} linear stages in all)"
    for name, runs, note in (("Harmos", harmos, stages), ("Harmos, without mesh error", without, stages),
                             ("CalculiX", calculix, "")):
        print(f"| {name} | {median(runs, 'cpu'):.2f} | {median(runs, 'wall'):.2f} | {median(runs, 'memory'):.0f} | "
              f"{median(runs, 'error'):.2e} | {runs[0]['iterations']}{note} |")
    ratios = [c["cpu"] / h["cpu"] for h, c in zip(harmos, calculix)]
    ratio = statistics.median(ratios)
    print(f"\nHarmos: {harmos[0]['status']}, error estimate {harmos[0]['estimate']:.2e}")
    print(f"CPU ratio {ratio:.0f}; of each pair: " + ", ".join(f"{r:.0f}" for r in ratios))
    bare = statistics.median(c["cpu"] / h["cpu"] for h, c in zip(without, calculix))
    print(f"CPU ratio without mesh error {bare:.0f}")
    accurate = all(one["error"] <= arguments.accuracy for one in harmos + calculix)
    if not accurate:
        print("NOT at equal accuracy: a true error is above the accuracy asked for")
    return 0 if accurate and ratio >= arguments.goal else 1


if __name__ == "__main__":
    sys.exit(main())
