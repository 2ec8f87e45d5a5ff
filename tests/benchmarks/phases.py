#!/usr/bin/env python3
"""Share of every phase in a run of Harmos, from the record of the run.

The local stage should take at most 3 % of the CPU time, and a linear stage (with the macro problem) at most 1.5 times
the bare block solve. What the record does not attribute to a phase is the start of the process, of MPI and of Kokkos.

  phases.py --harmos build/drivers/harmos [--runs N]
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
              "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--scene", default=os.path.join(ROOT, "xml", "bolted_joint.xml"))
    parser.add_argument("--runs", type=int, default=5, help="medians are printed")
    arguments = parser.parse_args()

    records = []
    scene = os.path.splitext(os.path.basename(arguments.scene))[0]
    with tempfile.TemporaryDirectory() as directory:
        for _ in range(arguments.runs):
            subprocess.run([arguments.harmos, "run", arguments.scene, "--quiet", "--output", directory], check=True,
                           env=dict(os.environ, **ONE_THREAD))
            with open(os.path.join(directory, scene + "_result.json")) as file:
                records.append(json.load(file))

    def cpu(phase):
        return statistics.median(record["phases"][phase]["cpu_seconds"] for record in records)

    total = statistics.median(record["cpu_seconds"] for record in records)
    stages = records[0]["linear_stages"]
    names = list(records[0]["phases"])
    print(f"median of {arguments.runs} runs: {total:.2f} s CPU, {records[0]['iterations']} iterations, {stages} linear "
          f"stages, {records[0]['status']}\n")
    print("| phase | CPU s | share |\n|---|---|---|")
    for name in names:
        print(f"| {name} | {cpu(name):.3f} | {100 * cpu(name) / total:.1f} % |")
    rest = total - sum(cpu(name) for name in names)
    print(f"| not in a phase | {rest:.3f} | {100 * rest / total:.1f} % |")

    local = statistics.median(r["phases"]["local"]["cpu_seconds"] / r["cpu_seconds"] for r in records)
    linear = statistics.median(
        sum(r["phases"].get(name, {"cpu_seconds": 0.0})["cpu_seconds"] for name in ("linear", "macro", "block solve")) /
        r["phases"]["block solve"]["cpu_seconds"] for r in records)
    print(f"\nlocal stage {100 * local:.1f} % of the whole (at most 3 %)")
    print(f"linear stage / bare block solve {linear:.2f} (at most 1.5); {1e3 * cpu('block solve') / stages:.1f} ms of "
          "block solves per linear stage")
    return 0 if local <= 0.03 and linear <= 1.5 else 1


if __name__ == "__main__":
    sys.exit(main())
