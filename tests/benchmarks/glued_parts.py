#!/usr/bin/env python3
"""What gluing costs beside one direct solve: an elastic block, held at one end and pulled sideways, as one part, which is
factored as a whole by the same library, and as that many slabs joined by perfect interfaces, or pieces cut by METIS.

  glued_parts.py [--harmos PROGRAM] [--cells N] [--accuracy A] [--runs R] [PARTS ...]

Prints medians of the CPU time of whole processes and of their phases, peak memory, linear stages, and the distance of the
response from that of the one part. Exit code 1 when a run is not certified, or further off than the accuracy asked for.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
              "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def scene(slabs, cells, pieces, accuracy):
    """A block 2 x 1 x 1 of 2 cells x cells x cells hexahedra."""
    boxes, parts = "", ""
    for i in range(slabs):
        first, last = 2 * cells * i // slabs, 2 * cells * (i + 1) // slabs
        boxes += f'''<ParameterList name="b{i}">
  <Parameter name="Lower Corner" type="Array(double)" value="{{{first / cells}, 0, 0}}"/>
  <Parameter name="Upper Corner" type="Array(double)" value="{{{last / cells}, 1, 1}}"/>
  <Parameter name="Cells" type="Array(double)" value="{{{last - first}, {cells}, {cells}}}"/></ParameterList>'''
        parts += f'''<ParameterList name="b{i}"><Parameter name="Material" type="string" value="m"/>
  <Parameter name="Pieces" type="int" value="{pieces}"/></ParameterList>'''
    glue = '''<ParameterList name="Interfaces"><ParameterList name="glue"><Parameter name="Part 1" type="string" value="*"/>
  <Parameter name="Part 2" type="string" value="*"/>
  <ParameterList name="Law"><Parameter name="Type" type="string" value="Perfect"/></ParameterList></ParameterList></ParameterList>'''
    return f'''<ParameterList name="Harmos">
<ParameterList name="Mesh"><Parameter name="Type" type="string" value="Boxes"/>
  <ParameterList name="Boxes">{boxes}</ParameterList></ParameterList>
<ParameterList name="Materials"><ParameterList name="m"><Parameter name="Type" type="string" value="Isotropic"/>
  <Parameter name="Young's Modulus" type="double" value="1000000"/>
  <Parameter name="Poisson's Ratio" type="double" value="0.3"/></ParameterList></ParameterList>
<ParameterList name="Parts">{parts}</ParameterList>
{glue if slabs > 1 else ""}
<ParameterList name="Boundaries"><ParameterList name="held"><Parameter name="Side Set" type="string" value="b0_xmin"/>
  <ParameterList name="Law"><Parameter name="Type" type="string" value="Prescribed Displacement"/>
  <Parameter name="X" type="double" value="0"/><Parameter name="Y" type="double" value="0"/>
  <Parameter name="Z" type="double" value="0"/></ParameterList></ParameterList>
<ParameterList name="pull"><Parameter name="Side Set" type="string" value="b{slabs - 1}_xmax"/>
  <ParameterList name="Law"><Parameter name="Type" type="string" value="Prescribed Traction"/>
  <Parameter name="Z" type="double" value="1"/></ParameterList></ParameterList></ParameterList>
<ParameterList name="Steps"><ParameterList name="load"/></ParameterList>
<ParameterList name="Solver"><Parameter name="Accuracy" type="double" value="{accuracy}"/></ParameterList>
<ParameterList name="Responses"><ParameterList name="u"><Parameter name="Type" type="string" value="Mean Displacement"/>
  <Parameter name="Side Set" type="string" value="b{slabs - 1}_xmax"/>
  <Parameter name="Direction" type="Array(double)" value="{{0, 0, 1}}"/></ParameterList></ParameterList>
</ParameterList>'''


def records_of(harmos, slabs, pieces, arguments):
    """The records of a few runs of one scene."""
    records = []
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "block.xml"
        path.write_text(scene(slabs, arguments.cells, pieces, arguments.accuracy))
        for _ in range(arguments.runs):
            end = subprocess.run([harmos, "run", str(path), "--quiet", "--output", folder], capture_output=True, text=True,
                                 check=False, env=dict(os.environ, **ONE_THREAD))
            record = pathlib.Path(folder) / "block_result.json"
            if end.returncode != 0 or not record.exists():
                sys.exit(end.stdout + end.stderr)
            records.append(json.loads(record.read_text()))
            last = (pathlib.Path(folder) / "block_history.csv").read_text().splitlines()[-1]
            records[-1]["u"] = float(last.split(",")[2])
    return records


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", default=str(root / "build" / "drivers" / "harmos"))
    parser.add_argument("--cells", type=int, default=16, help="along the shorter edges")
    parser.add_argument("--accuracy", type=float, default=1e-3)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("parts", nargs="*", type=int)
    arguments = parser.parse_args()
    harmos = os.path.abspath(arguments.harmos)
    counts = arguments.parts or [2, 4, 8]
    print("| block | CPU s | ratio | MB | linear stages | off | phases |\n|---|---|---|---|---|---|---|")
    whole = None
    worst = 0.0
    for words, slabs, pieces in ([("one part", 1, 1)] + [(f"{n} slabs", n, 1) for n in counts] +
                                 [(f"{n} pieces", 1, n) for n in counts]):
        records = records_of(harmos, slabs, pieces, arguments)

        def median(value):
            return statistics.median(value(record) for record in records)

        cpu, u = median(lambda r: r["cpu_seconds"]), records[0]["u"]
        whole = whole or (cpu, u)
        off = abs(u / whole[1] - 1.0)
        worst = max(worst, off)
        phases = "; ".join(f"{name} {median(lambda r: r['phases'].get(name, {'cpu_seconds': 0.0})['cpu_seconds']):.2f}"
                           for name in ("assemble", "factor", "block solve", "macro", "local", "certificate"))
        print(f"| {words} | {cpu:.2f} | {cpu / whole[0]:.2f} | {median(lambda r: r['peak_memory_bytes']) / 1e6:.0f} | "
              f"{records[0]['linear_stages']} | {off:.1e} | {phases} |", flush=True)
    return 0 if worst <= arguments.accuracy else 1


if __name__ == "__main__":
    sys.exit(main())
