#!/usr/bin/env python3
"""Where a part is better solved iteratively than factored: a block of growing size, pressed on a plate and pulled along
it with friction, whose operator is factored, cut by METIS, and solved by conjugate gradients with multigrid.

  iterative_parts.py [--harmos PROGRAM] [--cells 16 24 32] [--order 1] [--increments K] [--accuracy A] [--pieces UNKNOWNS]

The block's material has skew axes, so that no mirror plane cuts its operator. Prints the CPU time of whole processes and
of their phases, peak memory, linear stages, and the distance of the response from that of the factored block. A size that
cannot be factored is compared with its pieces. Exit code 1 when a run is not certified, or further off than the accuracy
asked for.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
              "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def box(name, bottom, top, cells):
    return f'''<ParameterList name="{name}">
  <Parameter name="Lower Corner" type="Array(double)" value="{{0, 0, {bottom}}}"/>
  <Parameter name="Upper Corner" type="Array(double)" value="{{1, 1, {top}}}"/>
  <Parameter name="Cells" type="Array(double)" value="{{{cells[0]}, {cells[1]}, {cells[2]}}}"/></ParameterList>'''


def number(name, value):
    return f'<Parameter name="{name}" type="double" value="{value}"/>'


def skew():
    """Entries of a material without mirror planes along the axes of the block."""
    moduli = "".join(number(f"Young's Modulus {axis}", value) for axis, value in ((1, 1.2e6), (2, 1e6), (3, 9e5)))
    others = "".join(number(f"Poisson's Ratio {axes}", 0.3) + number(f"Shear Modulus {axes}", value)
                     for axes, value in (("12", 4e5), ("23", 3.5e5), ("13", 3.8e5)))
    return (f'''<Parameter name="Type" type="string" value="Orthotropic"/>{moduli}{others}
  <Parameter name="Axis 1" type="Array(double)" value="{{3, 2, 1}}"/>
  <Parameter name="Axis 2" type="Array(double)" value="{{-1, 2, 1}}"/>''')


def scene(cells, increments, accuracy, entry, order=1, law="Coulomb Friction"):
    """A unit cube of cells^3 hexahedra on a plate of two layers; `entry`: of the list of the cube's part."""
    friction = number("Friction Coefficient", 0.3) if law == "Coulomb Friction" else ""
    return f'''<ParameterList name="Harmos">
<ParameterList name="Mesh"><Parameter name="Type" type="string" value="Boxes"/>
<Parameter name="Order" type="int" value="{order}"/><ParameterList name="Boxes">
{box("plate", -2 / cells, 0, (cells, cells, 2))}{box("block", 0, 1, (cells, cells, cells))}</ParameterList></ParameterList>
<ParameterList name="Materials"><ParameterList name="m"><Parameter name="Type" type="string" value="Isotropic"/>
  <Parameter name="Young's Modulus" type="double" value="1000000"/>
  <Parameter name="Poisson's Ratio" type="double" value="0.3"/></ParameterList>
  <ParameterList name="skew">{skew()}</ParameterList></ParameterList>
<ParameterList name="Parts">
  <ParameterList name="plate"><Parameter name="Material" type="string" value="m"/></ParameterList>
  <ParameterList name="block"><Parameter name="Material" type="string" value="skew"/>{entry}</ParameterList></ParameterList>
<ParameterList name="Interfaces"><ParameterList name="contact">
  <Parameter name="Part 1" type="string" value="plate"/><Parameter name="Part 2" type="string" value="block"/>
  <ParameterList name="Law"><Parameter name="Type" type="string" value="{law}"/>{friction}</ParameterList>
  </ParameterList></ParameterList>
<ParameterList name="Boundaries">
  <ParameterList name="held"><Parameter name="Side Set" type="string" value="plate_zmin"/>
    <ParameterList name="Law"><Parameter name="Type" type="string" value="Prescribed Displacement"/>
    <Parameter name="X" type="double" value="0"/><Parameter name="Y" type="double" value="0"/>
    <Parameter name="Z" type="double" value="0"/></ParameterList></ParameterList>
  <ParameterList name="pressed"><Parameter name="Side Set" type="string" value="block_zmax"/>
    <ParameterList name="Law"><Parameter name="Type" type="string" value="Prescribed Traction"/>
    <Parameter name="Z" type="double" value="-100"/><Parameter name="X" type="double" value="15"/>
    <Parameter name="X History" type="string" value="pull"/></ParameterList></ParameterList></ParameterList>
<ParameterList name="Steps"><ParameterList name="press"/><ParameterList name="pull">
  <Parameter name="Increments" type="int" value="{increments}"/></ParameterList></ParameterList>
<ParameterList name="Histories"><ParameterList name="pull"><Parameter name="Type" type="string" value="Ramp"/>
  <Parameter name="Start" type="double" value="1"/><Parameter name="End" type="double" value="2"/></ParameterList></ParameterList>
<ParameterList name="Solver"><Parameter name="Accuracy" type="double" value="{accuracy}"/>
  <Parameter name="Mesh Error" type="bool" value="false"/></ParameterList>
<ParameterList name="Responses"><ParameterList name="u"><Parameter name="Type" type="string" value="Mean Displacement"/>
  <Parameter name="Side Set" type="string" value="block_zmax"/>
  <Parameter name="Direction" type="Array(double)" value="{{1, 0, 0}}"/></ParameterList></ParameterList>
</ParameterList>'''


def record_of(harmos, text):
    """The record of a run; None: it was refused, as too large."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "block.xml"
        path.write_text(text)
        end = subprocess.run([harmos, "run", str(path), "--quiet", "--output", folder], capture_output=True, text=True,
                             check=False, env=dict(os.environ, **ONE_THREAD))
        if end.returncode != 0 and "too large" in end.stdout + end.stderr:
            return None
        if end.returncode != 0:
            sys.exit(end.stdout + end.stderr)
        record = json.loads((pathlib.Path(folder) / "block_result.json").read_text())
        last = (pathlib.Path(folder) / "block_history.csv").read_text().splitlines()[-1]
        record["u"] = float(last.split(",")[2])
        return record


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", default=str(root / "build" / "drivers" / "harmos"))
    parser.add_argument("--cells", type=int, nargs="*", default=[16, 24, 32])
    parser.add_argument("--order", type=int, default=1, help="of the elements")
    parser.add_argument("--increments", type=int, default=1)
    parser.add_argument("--accuracy", type=float, default=1e-3)
    parser.add_argument("--pieces", type=float, default=8e3, help="unknowns of a piece")
    arguments = parser.parse_args()
    harmos = os.path.abspath(arguments.harmos)
    print("| unknowns | block | CPU s | factor or multigrid | solves | MB | linear stages | off |\n"
          "|---|---|---|---|---|---|---|---|")
    worst = 0.0
    for cells in arguments.cells:
        unknowns = 3 * ((cells + 1) ** 3 + (3 * cells * (cells + 1) ** 2 if arguments.order == 2 else 0))
        pieces = max(2, round(unknowns / arguments.pieces))
        reference = None
        for words, entry in (("factored", '<Parameter name="Pieces" type="int" value="1"/>'
                                          '<Parameter name="Linear Solver" type="string" value="Direct"/>'),
                             (f"{pieces} pieces", f'<Parameter name="Pieces" type="int" value="{pieces}"/>'),
                             ("iterative", '<Parameter name="Pieces" type="int" value="1"/>'
                                           '<Parameter name="Linear Solver" type="string" value="Iterative"/>'),
                             ("as chosen", "")):
            record = record_of(harmos, scene(cells, arguments.increments, arguments.accuracy, entry, arguments.order))
            if record is None:
                print(f"| {unknowns} | {words} | too large | | | | | |", flush=True)
                continue
            reference = reference or record["u"]
            off = abs(record["u"] / reference - 1.0)
            worst = max(worst, off)
            phases = {name: record["phases"].get(name, {"cpu_seconds": 0.0})["cpu_seconds"]
                      for name in ("factor", "block solve")}
            chosen = re.search(r"into (\d+) pieces", record["cuts"])
            words += f": {chosen.group(1)} pieces" if chosen else ""
            print(f"| {unknowns} | {words} | {record['cpu_seconds']:.1f} | {phases['factor']:.1f} | "
                  f"{phases['block solve']:.1f} | {record['peak_memory_bytes'] / 1e6:.0f} | {record['linear_stages']} | "
                  f"{off:.0e} |", flush=True)
    return 0 if worst <= 2.0 * arguments.accuracy else 1


if __name__ == "__main__":
    sys.exit(main())
