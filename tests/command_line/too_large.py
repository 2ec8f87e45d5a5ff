#!/usr/bin/python3
"""A part that is too large to be factored in the memory that there is, as a user meets it: a run chooses to solve it
iteratively, says so, certifies what it finds, and stays within the memory; where not even that fits, it is refused.

too_large.py HARMOS WORK_DIR
"""
import json
import pathlib
import re
import resource
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "benchmarks"))
import iterative_parts

CELLS = 27
"""Of the block in each direction: 65 856 unknowns, the least of a part that is not simply factored."""
ROOM, NO_ROOM = 1.2e9, 0.6e9
"""Address space of the program [byte], with its libraries. A run that factors takes 1.06 GB resident."""

harmos, work = sys.argv[1], pathlib.Path(sys.argv[2])
work.mkdir(parents=True, exist_ok=True)
path = work / "block.xml"
# Glued, which takes few iterations; more accurately than parts are cut.
path.write_text(iterative_parts.scene(CELLS, 1, 9e-6, "", law="Perfect"))
failures = 0


def demand(holds: bool, what: str) -> None:
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def harmos_within(limit: float, verb: str, *words: str) -> subprocess.CompletedProcess[str]:
    """A verb with so much address space."""
    return subprocess.run([harmos, verb, str(path), *words], text=True, capture_output=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (int(limit), int(limit))))


check = harmos_within(ROOM, "check")
demand(check.returncode == 0 and 'solve "block" iteratively' in check.stdout, f"check: {check.stdout}{check.stderr}")
said = float(re.search(r"whole process at its peak +([0-9.]+) MB", check.stdout).group(1))
run = harmos_within(ROOM, "run", "--output", str(work / "results"))
demand(run.returncode == 0, f"run: exit code {run.returncode}, {run.stdout}{run.stderr}")
demand('solve "block" iteratively' in run.stdout, f"run: {run.stdout}")
record = json.loads((work / "results" / "block_result.json").read_text())
taken = record["peak_memory_bytes"] / 1e6
print(f"{record['cpu_seconds']:.1f} CPU s, {taken:.0f} MB for {said:.0f} said")
demand(record["status"] == "certified", f"status {record['status']}")
demand(1 / 1.5 <= said / taken <= 1.5, f"{taken} MB for {said} said")
refused = harmos_within(NO_ROOM, "run", "--output", str(work / "none"))
demand(refused.returncode == 2 and "Linear Solver" in refused.stderr, f"{refused.returncode}: {refused.stderr}")
demand(not (work / "none").exists(), "nothing is written")
sys.exit(failures > 0)
