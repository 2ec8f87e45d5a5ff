#!/usr/bin/env python3
"""What accuracy costs for a few inputs, as `harmos trade` prints it.

  accuracy_guide.py [--harmos PROGRAM] [--budget TIME] [--output DIR] [--write docs/guide/accuracy.md] [NAME ...]

With --write the part of that page below its marker is replaced. DIR gets the pages, tables and settings. Exit code 1 when
one of them was not measured at all.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
INPUTS = {"Bolted joint": ("xml/bolted_joint.xml",),
          "Bolted joint, forces of its bolts": ("xml/bolted_joint.xml", "--responses", "bolt_force_1,bolt_force_2"),
          "Glued assembly": ("xml/glued_assembly.xml",),
          "Lap joint of tetrahedra": ("tests/benchmarks/lap_joint.xml",),
          "Study of preloads": ("tests/benchmarks/bolted_joint_preloads.xml",)}
TARGETS = "5%,1%,0.1%"
MARKER = "<!-- written by tests/benchmarks/accuracy_guide.py -->\n"


def measured(harmos, words, budget, folder):
    """What the verb prints, without the names of files, as Markdown; None when it has measured nothing."""
    end = subprocess.run([harmos, "trade", str(ROOT / words[0]), *words[1:], "--budget", budget, "--targets", TARGETS,
                          "--output", folder, "--quiet"],
                         stdout=subprocess.PIPE, text=True, check=False)
    lines = [line.rsplit("; ", 1)[0] if line.startswith("within") and line.endswith(".xml") else line
             for line in end.stdout.splitlines() if not line.startswith(folder)]
    return "".join(f"    {line}\n" for line in lines) if end.returncode in (0, 3) else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", default=str(ROOT / "build" / "drivers" / "harmos"))
    parser.add_argument("--budget", default="10min", help="of each of them")
    parser.add_argument("--output")
    parser.add_argument("--write", type=pathlib.Path)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(INPUTS))
    arguments = parser.parse_args()
    chosen = arguments.names or list(INPUTS)
    with tempfile.TemporaryDirectory() as temporary:
        parts = {}
        for name in chosen:
            parts[name] = measured(arguments.harmos, INPUTS[name], arguments.budget, arguments.output or temporary)
            print(f"{name}\n{parts[name]}", flush=True)
    if arguments.write:
        head, marker, _ = arguments.write.read_text().partition(MARKER)
        body = "".join(f"\n### {name}\n\n`{' '.join(INPUTS[name])}`, within a budget of {arguments.budget}:\n\n{text}"
                       for name, text in parts.items())
        arguments.write.write_text(head + marker + body)
    return 1 if None in parts.values() else 0


if __name__ == "__main__":
    sys.exit(main())
