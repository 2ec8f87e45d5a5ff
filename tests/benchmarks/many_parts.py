#!/usr/bin/env python3
"""Where the time goes with many parts: chains of blocks glued face to face by one interface, the first one held.

  many_parts.py [--harmos PROGRAM] [--cells N] [--accuracy A] [PARTS ...]

Prints a row for each count of parts: nodes, CPU time of the whole process, of its phases, per part, peak memory, and CPU
time of writing and reading its mesh alone (`harmos mesh`, and `harmos check` of that file). Exit code 1 when a run ends
otherwise than certified, or, with --growth G, CPU time per part grows by more than that factor from the first to the last.
"""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile


def scene(parts, cells, accuracy, mesh_file=None):
    """A chain of cubes of edge 1 along x, loaded by its weight along the chain."""
    blocks = "".join(f'''<ParameterList name="b{i}">
  <Parameter name="Lower Corner" type="Array(double)" value="{{{i}, 0, 0}}"/>
  <Parameter name="Upper Corner" type="Array(double)" value="{{{i + 1}, 1, 1}}"/>
  <Parameter name="Cells" type="Array(double)" value="{{{cells}, {cells}, {cells}}}"/></ParameterList>
''' for i in range(parts))
    mesh = (f'<Parameter name="Type" type="string" value="Exodus"/><Parameter name="File" type="string" value="{mesh_file}"/>'
            if mesh_file else
            f'<Parameter name="Type" type="string" value="Boxes"/><ParameterList name="Boxes">{blocks}</ParameterList>')
    bodies = "".join(f'''<ParameterList name="b{i}"><Parameter name="Material" type="string" value="m"/>
  <ParameterList name="Body Force"><Parameter name="X" type="double" value="1"/></ParameterList></ParameterList>
''' for i in range(parts))
    return f'''<ParameterList name="Harmos">
<ParameterList name="Mesh">{mesh}</ParameterList>
<ParameterList name="Materials"><ParameterList name="m"><Parameter name="Type" type="string" value="Isotropic"/>
  <Parameter name="Young's Modulus" type="double" value="1000000"/>
  <Parameter name="Poisson's Ratio" type="double" value="0.3"/></ParameterList></ParameterList>
<ParameterList name="Parts">{bodies}</ParameterList>
<ParameterList name="Interfaces"><ParameterList name="glue"><Parameter name="Part 1" type="string" value="*"/>
  <Parameter name="Part 2" type="string" value="*"/>
  <ParameterList name="Law"><Parameter name="Type" type="string" value="Perfect"/></ParameterList></ParameterList></ParameterList>
<ParameterList name="Boundaries"><ParameterList name="held"><Parameter name="Side Set" type="string" value="b0_xmin"/>
  <ParameterList name="Law"><Parameter name="Type" type="string" value="Prescribed Displacement"/>
  <Parameter name="X" type="double" value="0"/><Parameter name="Y" type="double" value="0"/>
  <Parameter name="Z" type="double" value="0"/></ParameterList></ParameterList></ParameterList>
<ParameterList name="Steps"><ParameterList name="load"/></ParameterList>
<ParameterList name="Solver"><Parameter name="Accuracy" type="double" value="{accuracy}"/></ParameterList>
<ParameterList name="Responses"><ParameterList name="u"><Parameter name="Type" type="string" value="Mean Displacement"/>
  <Parameter name="Side Set" type="string" value="b{parts - 1}_xmax"/>
  <Parameter name="Direction" type="Array(double)" value="{{1, 0, 0}}"/></ParameterList></ParameterList>
</ParameterList>'''


def cpu_of(command):
    """CPU time of a command [s], its exit code and what it has printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    end = subprocess.run(command, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, end.returncode, end.stdout + end.stderr


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", default=str(root / "build" / "drivers" / "harmos"))
    parser.add_argument("--cells", type=int, default=2, help="along every edge of a part")
    parser.add_argument("--accuracy", default="0.001")
    parser.add_argument("--growth", type=float, default=float("inf"))
    parser.add_argument("parts", nargs="*", type=int)
    arguments = parser.parse_args()
    harmos = os.path.abspath(arguments.harmos)
    counts = arguments.parts or [100, 200, 400, 1000]
    per_part, failures = [], []
    print("| parts | nodes | status | CPU s | CPU ms per part | MB | mesh written s | mesh read s | phases |\n"
          "|---|---|---|---|---|---|---|---|---|")
    for parts in counts:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "chain.xml"
            path.write_text(scene(parts, arguments.cells, arguments.accuracy))
            written, code, words = cpu_of([harmos, "mesh", str(path), "--output", f"{folder}/mesh.e"])
            if code != 0:
                sys.exit(words)
            generated, _, _ = cpu_of([harmos, "check", str(path)])
            file_path = pathlib.Path(folder) / "file.xml"
            file_path.write_text(scene(parts, arguments.cells, arguments.accuracy, f"{folder}/mesh.e"))
            read, code, words = cpu_of([harmos, "check", str(file_path)])
            if code != 0:
                sys.exit(words)
            cpu, code, words = cpu_of([harmos, "run", str(path), "--quiet", "--output", folder])
            record = json.loads((pathlib.Path(folder) / "chain_result.json").read_text())
            phases = "; ".join(f"{name} {phase['cpu_seconds']:.1f}" for name, phase in record["phases"].items()
                               if phase["cpu_seconds"] > 0.03 * record["cpu_seconds"])
            per_part.append(cpu / parts)
            print(f"| {parts} | {parts * (arguments.cells + 1) ** 3} | {record['status']} | {cpu:.1f} | {1000 * cpu / parts:.1f} | "
                  f"{record['peak_memory_bytes'] / 1e6:.0f} | {written:.2f} | {read - generated:+.2f} | {phases} |", flush=True)
            if code != 0:
                failures.append(f"{parts} parts: {record['status']}: {record['reason']}")
    if per_part[-1] > arguments.growth * per_part[0]:
        failures.append(f"CPU time per part grows by {per_part[-1] / per_part[0]:.2f}")
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
