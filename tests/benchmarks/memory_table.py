#!/usr/bin/env python3
"""What `harmos check` says of the memory of a run, beside its peak.

  memory_table.py --harmos PROGRAM [--few] [--check]

Runs every scene in a process of its own and prints the resident set at its peak, the estimate, and their ratio. Exit code 1
with --check when a ratio is beyond FACTOR. --few: those of a few seconds only. The scenes of OUTLIERS are shown, not held to it.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import many_parts

ROOT = pathlib.Path(__file__).resolve().parents[2]
FACTOR = 1.5
JOINT, GLUED = ROOT / "xml" / "bolted_joint.xml", ROOT / "xml" / "glued_assembly.xml"
LAP = ROOT / "tests" / "benchmarks" / "lap_joint.xml"
PLATES = ("cover_bottom", "centre", "cover_top")
SCENES = {"gap": (ROOT / "xml" / "gap.xml",), "bimetal strip": (ROOT / "xml" / "bimetal_strip.xml",),
          "bolted joint, refinement 0.5": (JOINT, "Mesh/Refinement=0.5"), "bolted joint": (JOINT,),
          "bolted joint, plates in 4 pieces": (JOINT, *(f"Parts/{plate}/Pieces=4" for plate in PLATES)),
          "glued assembly, cells of 1": (GLUED, "Mesh/Cell Size=1"), "glued assembly": (GLUED,), "lap joint": (LAP,),
          "lap joint, quadratic": (LAP, "Mesh/Order=2"), "chain of 300": ("chain",)}
LARGE = {"glued assembly, cells of 1/4": (GLUED, "Mesh/Cell Size=0.25"),
         "glued assembly, quadratic": (GLUED, "Mesh/Order=2"), "lap joint, split": (LAP, "Mesh/Refine=1"),
         "bolted joint, 44 steps": (JOINT, "Steps/load/Increments=43"),
         "bolted joint, refinement 2": (JOINT, "Mesh/Refinement=2")}
OUTLIERS = {"bolted joint, Hex20, refinement 0.5": (JOINT, "Mesh/Refinement=0.5", "Mesh/Element=Hex20"),
            "bolted joint, consistent mass": (JOINT, "Solver/Interface Mass=Consistent")}


def peak_of(command):
    """Resident set of a command at its peak [MB]."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}")
    return usage.ru_maxrss * 1024 / 1e6


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True)
    parser.add_argument("--few", action="store_true")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    scenes = SCENES if arguments.few else {**SCENES, **LARGE, **OUTLIERS}
    beyond = []
    print("| scene | peak MB | estimate MB | ratio |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        chain = pathlib.Path(folder) / "chain.xml"
        chain.write_text(many_parts.scene(300, 3, "0.001"))
        for name, (scene, *changes) in scenes.items():
            path = str(chain if scene == "chain" else scene)
            words = [path, *(word for change in changes for word in ("--set", change))]
            said = subprocess.run([arguments.harmos, "check", *words], capture_output=True, text=True, check=True).stdout
            estimate = float(re.search(r"whole process at its peak +([0-9.]+) MB", said).group(1))
            peak = peak_of([arguments.harmos, "run", *words, "--quiet", "--output", folder])
            print(f"| {name} | {peak:.0f} | {estimate:.0f} | {estimate / peak:.2f} |", flush=True)
            if not 1 / FACTOR <= estimate / peak <= FACTOR and name not in OUTLIERS:
                beyond.append(name)
    print(f"beyond a factor of {FACTOR}: {', '.join(beyond) or 'none'}")
    return 1 if beyond and arguments.check else 0


if __name__ == "__main__":
    sys.exit(main())
