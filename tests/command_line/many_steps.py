#!/usr/bin/python3
"""What a load step takes in memory where there are many of them: no more than so many fields of the interfaces.

many_steps.py HARMOS SCENES WORK_DIR: SCENES is the folder of the worked scenes.
"""
import os
import pathlib
import re
import subprocess
import sys

MOST = 11.5
"""Fields, a number for each interface unknown. A run keeps about eleven: alpha, its image and those of a correction, both
fields of both stages, forces and displacements of the parts there, loads; no field that can be computed from these."""
FEW, MANY = 201, 501

harmos, scenes, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
words = [str(scenes / "bolted_joint.xml"), "--set", "Mesh/Refinement=0.5"]


def peak(steps: int) -> float:
    """Resident set at the peak of a run [byte]."""
    command = [harmos, "run", *words, "--set", f"Steps/load/Increments={steps}", "--quiet", "--output", str(work)]
    with subprocess.Popen(command) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}")
    return 1024.0 * usage.ru_maxrss


text = subprocess.run([harmos, "check", *words], capture_output=True, text=True, check=True).stdout
unknowns = int(re.search(r"and (\d+) interface unknowns", text).group(1))
fields = (peak(MANY) - peak(FEW)) / (MANY - FEW) / (8.0 * unknowns)
print(f"{fields:.2f} fields for each load step")
sys.exit(fields > MOST)
