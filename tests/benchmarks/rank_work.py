#!/usr/bin/env python3
"""What each rank of a run works, without what it spends on waiting for the others.

Ranks that wait poll, so that neither their CPU time nor, on a machine that does other work, the wall time says how well a
run is shared out. Here `perf record` samples every rank, and samples in the libraries of MPI and in the kernel do not count
as work. The speed-up is the work of one rank over that of the busiest of several: a bound from above, for where the ranks
take turns in being the busiest one, the others wait.

  rank_work.py --harmos build/drivers/harmos --ranks 1 2 --set Mesh/Refinement=2

With --walls N also what the clock says, N times in turns on a machine that does nothing else: of one rank alone, of several
ranks, and of as many separate runs of one rank at the same time. These share caches, memory and clock rate like ranks do,
but nothing else: the time of one rank alone over theirs, times their number, is what a program could gain that shares
everything out and never waits.
"""
import argparse
import json
import os
import pathlib
import shlex
import statistics
import subprocess
import sys
import tempfile
import time

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


def command_of(arguments, folder):
    command = [arguments.harmos, "run", arguments.scene, "--quiet", "--output", str(folder)]
    for setting in arguments.set:
        command += ["--set", setting]
    return command


def run(arguments, ranks, folder):
    """Per rank: work, CPU seconds and peak memory [MB]; and the record of the run."""
    of_rank = f"{shlex.quote(str(folder))}/%s.$OMPI_COMM_WORLD_RANK"
    command = command_of(arguments, folder)
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


def walls(arguments, ranks, folder):
    """Wall seconds of one rank alone, of several, and of as many separate runs at the same time."""
    # Who yields to others, as above, is slower where there are none.
    environment = dict(os.environ, **{**SETTINGS, "OMPI_MCA_mpi_yield_when_idle": "0"})

    def take(runs, ranks_of_each):
        start = time.monotonic()
        started = [subprocess.Popen(["mpirun", "--bind-to", "none", "-n", str(ranks_of_each),
                                     *command_of(arguments, folder / str(i))], env=environment) for i in range(runs)]
        if any([process.wait() for process in started]):
            raise SystemExit(f"rank_work.py: a run of {ranks_of_each} failed; is there a free core for each rank?")
        return time.monotonic() - start

    return take(1, 1), take(1, ranks), take(ranks, 1)


def print_walls(arguments):
    several = [ranks for ranks in arguments.ranks if ranks > 1]
    if not several:
        raise SystemExit("rank_work.py: --walls compares several ranks with one; name some with --ranks")
    print("\n| ranks | one alone, s | ranks, s | as many runs at once, s | faster than one alone | than one of these |"
          " at best |\n|---|---|---|---|---|---|---|")
    for ranks in several:
        with tempfile.TemporaryDirectory() as folder:
            rows = [walls(arguments, ranks, pathlib.Path(folder)) for _ in range(arguments.walls)]
        alone, together, at_once = (statistics.median(column) for column in zip(*rows))
        gain, beside, best = (statistics.median(quotients) for quotients in zip(
            *((one / own, each / own, ranks * one / each) for one, own, each in rows)))
        print(f"| {ranks} | {alone:.2f} | {together:.2f} | {at_once:.2f} | {gain:.2f} | {beside:.2f} | {best:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--scene", default=str(ROOT / "xml" / "bolted_joint.xml"))
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--set", action="append", default=[], help="a value of the scene, as in harmos run")
    parser.add_argument("--walls", type=int, default=0, metavar="N", help="look at the clock as well, N times")
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
    if arguments.walls > 0:
        print_walls(arguments)
    return 0


if __name__ == "__main__":
    sys.exit(main())
