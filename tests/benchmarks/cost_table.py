#!/usr/bin/env python3
"""What `harmos check` says of memory and CPU time of a run or a study, beside what they take.

  cost_table.py --harmos PROGRAM [--few] [--check] [--write PAGE.md]

Runs every scene in a process of its own, on one thread, and prints the resident set at its peak and its CPU time, what was
said of them, and the ratios. Exit code 1 with --check when a ratio of memory is beyond FACTOR (times hang on the machine and
on what else it does). --few: those of a few seconds only.
--write: puts the table between the two lines of a page that name this script. What stands in OUTLIERS is shown, not held to
it.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import heaps
import many_parts

ROOT = pathlib.Path(__file__).resolve().parents[2]
FACTOR = 1.5
XML = ROOT / "xml"
JOINT, GLUED = XML / "bolted_joint.xml", XML / "glued_assembly.xml"
JOINT_STUDY = XML / "bolted_joint_study.xml"
LAP = ROOT / "tests" / "benchmarks" / "lap_joint.xml"
RESPONSES = '<ParameterList name="Responses">'
VON_MISES = '<Parameter name="Type" type="string" value="Von Mises Stress"/>'
PLATES = ("cover_bottom", "centre", "cover_top")


def grid(count):
    """The study of the joint with so many values of each of its three parameters."""
    return (JOINT_STUDY, *(f"Parameters/{name}/Count={count}" for name in ("mu", "preload_1", "preload_2")))


def stressed():
    """The joint with the largest von Mises stress besides."""
    before, after = JOINT.read_text().split(RESPONSES)
    return f'{before}{RESPONSES}<ParameterList name="stress">{VON_MISES}</ParameterList>{after}'


# Scenes that are made here: what writes them.
MADE = {"stressed joint": stressed, "chain": lambda: many_parts.scene(300, 3, "0.001"),
        **{f"heap of {n ** 3}": lambda n=n: heaps.scene((n, n, n), (2, 2, 2), 5) for n in (3, 4, 5)},
        "heap in the plane": lambda: heaps.scene((5, 5), (3, 3), 8),
        "two blocks in the plane": lambda: heaps.scene((1, 2), (300, 40), 5, size=(300, 40)),
        **{f"plates, {steps} steps": lambda steps=steps: heaps.scene((1, 1, 2), (40, 40, 2), steps, size=(40, 40, 2))
           for steps in (10, 64)}}
SCENES = {"gap": (XML / "gap.xml",), "bimetal strip": (XML / "bimetal_strip.xml",),
          "bolted joint, refinement 0.5": (JOINT, "Mesh/Refinement=0.5"), "bolted joint": (JOINT,),
          "bolted joint, plates in 4 pieces": (JOINT, *(f"Parts/{plate}/Pieces=4" for plate in PLATES)),
          "glued assembly, cells of 1": (GLUED, "Mesh/Cell Size=1"), "glued assembly": (GLUED,), "lap joint": (LAP,),
          "lap joint, quadratic": (LAP, "Mesh/Order=2"), "chain of 300": ("chain",),
          "study of rough glue": (XML / "rough_glue_study.xml",),
          **{name: (name,) for name in ("heap of 27", "heap in the plane", "two blocks in the plane", "plates, 10 steps")}}
LARGE = {"glued assembly, cells of 1/4": (GLUED, "Mesh/Cell Size=0.25"),
         "glued assembly, quadratic": (GLUED, "Mesh/Order=2"), "lap joint, split": (LAP, "Mesh/Refine=1"),
         "bolted joint, 44 steps": (JOINT, "Steps/load/Increments=43"),
         "bolted joint, refinement 2": (JOINT, "Mesh/Refinement=2"),
         "bolted joint, Hex20, refinement 0.5": (JOINT, "Mesh/Refinement=0.5", "Mesh/Element=Hex20"),
         **{name: (name,) for name in ("heap of 64", "heap of 125", "plates, 64 steps")},
         "bolted joint, its derivatives": (JOINT, "Output/Derivatives={Values/mu, Values/preload_1}"),
         "study of the joint, 8": grid(2), "study of the joint, 27": grid(3), "study of the joint, 64": grid(4),
         "study of the joint, 12": (ROOT / "tests" / "benchmarks" / "bolted_joint_preloads.xml",),
         "stressed joint": ("stressed joint",), "study of the stressed joint, 27": (*grid(3), "Scene=stressed joint"),
         "bolted joint to 1e-8": (JOINT, "Solver/Accuracy=1e-8"), "study of the joint, 27, to 1e-5": (*grid(3), "Accuracy=1e-5"),
         "chaos of the glued assembly": (XML / "glued_assembly_chaos.xml",)}
OUTLIERS = {"bolted joint, consistent mass": (JOINT, "Solver/Interface Mass=Consistent"),
            "random gap, an adaptive design": (XML / "random_gap.xml",)}
STUDIES = {"study of the joint, 8", "study of the joint, 12", "study of the joint, 27", "study of the joint, 64",
           "study of the stressed joint, 27", "study of the joint, 27, to 1e-5", "random gap, an adaptive design", "study of rough glue", "chaos of the glued assembly"}
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
MARKS = "<!-- cost_table.py begins -->", "<!-- cost_table.py ends -->"


def taken_by(command):
    """Resident set at its peak [MB] and CPU time [s] of a command."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          env={**os.environ, **ONE_THREAD}) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}")
    return usage.ru_maxrss * 1024 / 1e6, usage.ru_utime + usage.ru_stime


def said_of(harmos, words, is_study):
    """Memory [MB] and CPU time [s] that `harmos check` foresees."""
    text = subprocess.run([harmos, "check", *words], capture_output=True, text=True, check=True).stdout
    expansions = re.search(r"memory in all +([0-9.]+) MB", text)
    memory = expansions or re.search(r"whole process at its peak +([0-9.]+) MB", text)
    seconds = re.search(rf"  {'study' if is_study else 'run'} of .*?stages +([0-9.]+) s", text)
    return float(memory.group(1)), float(seconds.group(1))


def made(scene, folder):
    """The path of a scene, which is written into the folder where it is one of MADE."""
    if scene not in MADE:
        return str(scene)
    path = pathlib.Path(folder) / f"{scene.replace(' ', '_').replace(',', '')}.xml"
    path.write_text(MADE[scene]())
    return str(path)


def of_made(change, folder):
    """A change of a study, whose scene may be one of MADE."""
    entry, value = change.split("=", 1)
    return f"{entry}={made(value, folder)}" if entry == "Scene" else change


def row(harmos, name, words, folder):
    """A row of the table, and its ratios."""
    is_study = name in STUDIES
    said = said_of(harmos, words, is_study)
    taken = taken_by([harmos, "study" if is_study else "run", *words, "--quiet", "--output",
                      str(pathlib.Path(folder) / name.replace(" ", "_"))])
    ratios = [a / b for a, b in zip(said, taken)]
    text = (f"| {name} | {taken[0]:.0f} | {said[0]:.0f} | {ratios[0]:.2f} | {taken[1]:.2f} | {said[1]:.2f} | "
            f"{ratios[1]:.2f} |")
    return text, ratios


def write(page, table):
    """Puts the table between the marks of a page."""
    text = page.read_text()
    before, rest = text.split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    page.write_text(f"{before}{MARKS[0]}\n{table}\n{MARKS[1]}{after}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True)
    parser.add_argument("--few", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", type=pathlib.Path)
    arguments = parser.parse_args()
    scenes = SCENES if arguments.few else {**SCENES, **LARGE, **OUTLIERS}
    beyond = {"memory": [], "CPU time": []}
    lines = ["| scene | peak MB | said MB | ratio | CPU s | said s | ratio |", "|---|---|---|---|---|---|---|"]
    print("\n".join(lines))
    with tempfile.TemporaryDirectory() as folder:
        for name, (scene, *changes) in scenes.items():
            words = [made(scene, folder), *(word for change in changes for word in ("--set", of_made(change, folder)))]
            text, ratios = row(arguments.harmos, name, words, folder)
            print(text, flush=True)
            lines.append(text)
            for what, ratio in zip(beyond, ratios):
                if not 1 / FACTOR <= ratio <= FACTOR and name not in OUTLIERS:
                    beyond[what].append(name)
    for what, names in beyond.items():
        print(f"{what} beyond a factor of {FACTOR}: {', '.join(names) or 'none'}")
    if arguments.write:
        write(arguments.write, "\n".join(lines))
    return 1 if beyond["memory"] and arguments.check else 0


if __name__ == "__main__":
    sys.exit(main())
