"""Meshes of all elements that Harmos has, made by the program itself."""
import pathlib
import subprocess

from harmos.exchange.exodus import read_exodus
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Mesh

SOLIDS = ["Hex8", "Wedge6", "Tet4", "Pyramid5", "Hex20", "Hex27", "Wedge15", "Tet10"]
PLANES = ["Quad4", "Tri3", "Quad8", "Quad9", "Tri6"]


def boxes_mesh(harmos: str, folder: pathlib.Path, element: str) -> Mesh:
    """Two boxes on each other, `lower` and `upper`, which share no nodes."""
    dimension = 2 if element in PLANES else 3
    scene = folder / f"{element}.xml"
    boxes = "".join(f"""
      <ParameterList name="{name}">
        <Parameter name="Lower Corner" type="Array(double)" value="{{{corner(0, low, dimension)}}}"/>
        <Parameter name="Upper Corner" type="Array(double)" value="{{{corner(1, high, dimension)}}}"/>
        <Parameter name="Cells" type="Array(double)" value="{{{corner(2, 2, dimension)}}}"/>
        <Parameter name="Element" type="string" value="{element}"/>
      </ParameterList>""" for name, low, high in (("lower", 0, 1), ("upper", 1, 2)))
    scene.write_text(f"""<ParameterList name="Harmos">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Boxes"/>
    <ParameterList name="Boxes">{boxes}</ParameterList></ParameterList>
  <ParameterList name="Materials"><ParameterList name="steel">
    <Parameter name="Type" type="string" value="Isotropic"/>
    <Parameter name="Young's Modulus" type="double" value="210000"/>
    <Parameter name="Poisson's Ratio" type="double" value="0.3"/></ParameterList></ParameterList>
  <ParameterList name="Parts">
    <ParameterList name="lower"><Parameter name="Material" type="string" value="steel"/></ParameterList>
    <ParameterList name="upper"><Parameter name="Material" type="string" value="steel"/></ParameterList>
  </ParameterList>
  <ParameterList name="Steps"><ParameterList name="load"/></ParameterList>
</ParameterList>""")
    mesh = folder / f"{element}.e"
    subprocess.run([harmos, "mesh", str(scene), "--output", str(mesh), "--quiet"], check=True)
    return read_exodus(str(mesh), Findings())


def corner(others: float, last: float, dimension: int) -> str:
    """Coordinates of a corner of a box."""
    return ", ".join([str(others)] * (dimension - 1) + [str(last)])
