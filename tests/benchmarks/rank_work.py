#!/usr/bin/env python3
"""What each rank of a run works, without what it spends on waiting for the others.

Ranks that wait poll, so that neither their CPU time nor, on a machine that does other work, the wall time says how well a
run is shared out. Here `perf record` samples every rank, and samples in the libraries of MPI and in the kernel do not count
as work. The speed-up is the work of one rank over that of the busiest of several: a bound from above, for where the ranks
take turns in being the busiest one, the others wait.

  rank_work.py --harmos build/drivers/harmos --ranks 1 2 --set Mesh/Refinement=2
"""
import argparse
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SETTINGS = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
RATE = 199
"""Samples per second of CPU time."""
WAITING = ("libmpi", "libopen-", "libpmix", "libevent", "mca_", "[kernel", "[vdso]", "[unknown]")


def work_of(samples):
    """CPU seconds beside MPI and kernel, and of all."""
    text = subprocess.run(["perf", "script", "-i", str(samples), "-F", "ip,sym,dso"], check=True, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    libraries = [line.rsplit("(", 1)[-1].rsplit("/", 1)[-1] for line in text.splitlines() if "(" in line]
    work = sum(not library.startswith(WAITING) for library in libraries)
    return work / RATE, len(libraries) / RATE


def run(arguments, ranks, folder):
    """Per rank: work, CPU seconds and peak memory [MB]; and the record of the run."""
    of_rank = f"{shlex.quote(str(folder))}/%s.$OMPI_COMM_WORLD_RANK"
    command = [arguments.harmos, "run", arguments.scene, "--quiet", "--output", str(folder)]
    for setting in arguments.set:
        command += ["--set", setting]
    sampled = (f"exec perf record -q -F {RATE} -e cpu-clock -o {of_rank % 'samples'} "
               f"/usr/bin/time -o {of_rank % 'memory'} -f %M {shlex.join(command)}")
    subprocess.run(["mpirun", "--oversubscribe", "-n", str(ranks), "sh", "-c", sampled], check=True,
                   env=dict(os.environ, **SETTINGS))
    lines = []
    for rank in range(ranks):
        memory = float((folder / f"memory.{rank}").read_text().split()[-1]) / 1024
        lines.append((*work_of(folder / f"samples.{rank}"), memory))
    name = pathlib.Path(arguments.scene).stem
    return lines, json.loads((folder / f"{name}_result.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--scene", default=str(ROOT / "xml" / "bolted_joint.xml"))
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--set", action="append", default=[], help="a value of the scene, as in harmos run")
    arguments = parser.parse_args()
    arguments.harmos = os.path.abspath(arguments.harmos)
    alone = None
    print("| ranks | work of each, CPU s | CPU s of each | MB of each | linear stages | speed-up |")
    print("|---|---|---|---|---|---|")
    for ranks in arguments.ranks:
        with tempfile.TemporaryDirectory() as folder:
            lines, record = run(arguments, ranks, pathlib.Path(folder))
        work, cpu, memory = zip(*lines)
        alone = alone if alone is not None or ranks > 1 else work[0]
        gain = "" if alone is None else f"{alone / max(work):.2f}"
        print(f"| {ranks} | {', '.join(f'{x:.1f}' for x in work)} | {', '.join(f'{x:.1f}' for x in cpu)} | "
              f"{', '.join(f'{x:.0f}' for x in memory)} | {record['linear_stages']} | {gain} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
