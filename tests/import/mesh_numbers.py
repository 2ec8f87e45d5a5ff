#!/usr/bin/python3
"""Messages and result files know elements and nodes by the numbers of the user's mesh file. mesh_numbers.py HARMOS WORK_DIR"""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import netCDF4
import numpy

from boxes import boxes_mesh
from gmsh_writer import write_gmsh
from harmos.exchange.exodus import read_exodus, write_exodus
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Mesh

harmos = sys.argv[1]
work = pathlib.Path(sys.argv[2])

SCENE = """<ParameterList name="Harmos">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Exodus"/>
    <Parameter name="File" type="string" value="{file}"/>{mesh}</ParameterList>
  <ParameterList name="Model">{model}</ParameterList>
  <ParameterList name="Materials"><ParameterList name="steel">
    <Parameter name="Type" type="string" value="Isotropic"/>
    <Parameter name="Young's Modulus" type="double" value="1000"/>
    <Parameter name="Poisson's Ratio" type="double" value="0.3"/></ParameterList></ParameterList>
  <ParameterList name="Parts">
    <ParameterList name="upper"><Parameter name="Material" type="string" value="steel"/></ParameterList>
    <ParameterList name="lower"><Parameter name="Material" type="string" value="steel"/></ParameterList>
  </ParameterList>
  <ParameterList name="Interfaces"><ParameterList name="seal">
    <Parameter name="Part 1" type="string" value="lower"/><Parameter name="Part 2" type="string" value="upper"/>
    <ParameterList name="Law"><Parameter name="Type" type="string" value="Perfect"/></ParameterList></ParameterList></ParameterList>
  <ParameterList name="Boundaries"><ParameterList name="held"><Parameter name="Side Set" type="string" value="lower_{axis}min"/>
    <ParameterList name="Law"><Parameter name="Type" type="string" value="Prescribed Displacement"/>{fixed}</ParameterList></ParameterList>
  </ParameterList>
  <ParameterList name="Steps"><ParameterList name="load"/></ParameterList>
</ParameterList>"""
REFINE = '<Parameter name="Refine" type="int" value="1"/>'
RAISE = '<Parameter name="Order" type="int" value="2"/>'


def numbered(element: str) -> Mesh:
    """Two boxes of 2 x 2 x 2 cells, with numbers that have gaps and do not ascend."""
    mesh = boxes_mesh(harmos, work, element)
    mesh.node_numbers = 5000 - 7 * numpy.arange(len(mesh.nodes))
    for number, block in enumerate(mesh.blocks):
        block.numbers = 1017 * (number + 1) + 3 * numpy.arange(len(block.connectivity))[::-1]
    return mesh


def scene(name: str, mesh: str = "", model: str = "", dimension: int = 3) -> pathlib.Path:
    """A scene on a mesh file of the folder."""
    fixed = "".join(f'<Parameter name="{axis}" type="double" value="0"/>' for axis in "XYZ"[:dimension])
    path = work / "scene.xml"
    path.write_text(SCENE.format(file=name, mesh=mesh, model=model, axis="xyz"[dimension - 1], fixed=fixed))
    return path


class MeshNumbers(unittest.TestCase):
    def setUp(self) -> None:
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)

    def demand_refused(self, path: pathlib.Path, *words: str) -> str:
        """Exit code 2, a message with these words, which it returns, and nothing written."""
        result = subprocess.run([harmos, "run", str(path), "--output", str(work / "out")], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 2, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertFalse((work / "out").exists())
        return result.stderr

    def test_elements_inside_out_and_folded(self) -> None:
        mesh = numbered("Hex20")
        block = mesh.blocks[1]
        row, number = block.connectivity[0].copy(), block.numbers[0]
        block.connectivity[0] = row[[4, 5, 6, 7, 0, 1, 2, 3, 16, 17, 18, 19, 12, 13, 14, 15, 8, 9, 10, 11]]
        write_exodus(work / "mesh.e", mesh)
        self.demand_refused(scene("mesh.e"), f"part \"upper\", element {number} of \"mesh.e\" (block \"upper\"): the element is turned")
        self.demand_refused(scene("mesh.e", REFINE), f"part \"upper\", a child of element {number} of \"mesh.e\" (block \"upper\")")
        block.connectivity[0] = row
        mesh.nodes[row[8]] = mesh.nodes[row[0]]
        middle = mesh.node_numbers[row[8]]
        write_exodus(work / "mesh.e", mesh)
        self.demand_refused(scene("mesh.e"), f"element {number} of \"mesh.e\" (block \"upper\"): the element is folded: node {middle} of \"mesh.e\" at (",
                            "0.25 away from the middle of its edge, 0.5 of the length of the edge")

    def test_copies_faces_without_area_and_missing_faces(self) -> None:
        mesh = numbered("Hex8")
        block = mesh.blocks[0]
        saved = block.connectivity.copy()
        block.connectivity[2] = block.connectivity[5]
        write_exodus(work / "mesh.e", mesh)
        named = [f"element {block.numbers[each]} of \"mesh.e\" (block \"lower\")" for each in (2, 5)]
        self.demand_refused(scene("mesh.e"), f"{named[0]} and {named[1]} have the same nodes")
        block.connectivity = saved
        mesh.side_sets["upper_zmax"][2, 1] = 6
        element = mesh.side_sets["upper_zmax"][2, 0] - 8
        write_exodus(work / "mesh.e", mesh)
        self.demand_refused(scene("mesh.e"), f"\"upper_zmax\" refers to side 7 of HEX8 element {mesh.blocks[1].numbers[element]} of \"mesh.e\" (block "
                            "\"upper\"), there are 6")
        mesh = numbered("Hex8")
        below = mesh.nodes[:, 2] == 0.0
        mesh.nodes[below, 1] = 0.5
        write_exodus(work / "mesh.e", mesh)
        result = self.demand_refused(scene("mesh.e"), "Boundary \"held\": the faces around node ", "have no area")
        number = int(result.split("around node ")[1].split()[0])
        self.assertIn(number, mesh.node_numbers[below])

    def test_nodes_at_negative_radius_and_of_no_part(self) -> None:
        mesh = numbered("Quad8")
        mesh.nodes[7, 0] = -0.25
        write_exodus(work / "mesh.e", mesh)
        axial = '<Parameter name="Kinematics" type="string" value="Axisymmetric"/>'
        self.demand_refused(scene("mesh.e", "", axial, 2), f"the farthest node {mesh.node_numbers[7]} of \"mesh.e\" at (-0.25, ")

    def test_other_formats(self) -> None:
        mesh = numbered("Hex8")
        mesh.blocks[1].connectivity[3] = mesh.blocks[1].connectivity[5][[1, 0, 2, 3, 4, 5, 6, 7]]  # folded, and a copy
        number = mesh.blocks[1].numbers[3]
        mesh.side_sets = {}
        for name in ("mesh.msh", "mesh.unv"):
            write_gmsh(work / name, mesh)
            self.demand_refused(scene(name), str(number))

    def results(self, path: pathlib.Path, ranks: int = 1) -> "tuple[netCDF4.Dataset, dict[str, numpy.ndarray]]":
        """The file of parts, and its maps."""
        shutil.rmtree(work / "out", ignore_errors=True)
        command = [harmos, "run", str(path), "--output", str(work / "out"), "--quiet"]
        subprocess.run(["mpirun", "--oversubscribe", "-np", str(ranks), *command] if ranks > 1 else command, check=True, env=os.environ)
        file = netCDF4.Dataset(work / "out" / "scene.e")
        self.addCleanup(file.close)
        return file, {name: file.variables[name][:] for name in ("node_num_map", "elem_num_map") if name in file.variables}

    def test_results(self) -> None:
        mesh = numbered("Hex8")
        write_exodus(work / "mesh.e", mesh)
        for ranks in (1, 2):
            file, maps = self.results(scene("mesh.e"), ranks)
            # Parts, and so blocks of the results, are in the order of the scene.
            self.assertEqual(maps["elem_num_map"].tolist(), [*mesh.blocks[1].numbers, *mesh.blocks[0].numbers])
            at = {number: tuple(place) for number, place in zip(mesh.node_numbers, mesh.nodes)}
            found = zip(*(file.variables["coord" + axis][:] for axis in "xyz"))
            self.assertEqual([at[number] for number in maps["node_num_map"]], [tuple(place) for place in found])
        _, maps = self.results(scene("mesh.e", RAISE))
        self.assertEqual(list(maps), ["elem_num_map"])
        _, maps = self.results(scene("mesh.e", REFINE))
        self.assertEqual(maps, {})
        subprocess.run([harmos, "mesh", str(scene("mesh.e")), "--output", str(work / "again.e"), "--quiet"], check=True)
        again = read_exodus(str(work / "again.e"), Findings())
        self.assertEqual(again.element_numbers().tolist(), mesh.element_numbers().tolist())
        self.assertEqual(again.node_numbers.tolist(), mesh.node_numbers.tolist())

    def test_decks(self) -> None:
        mesh = numbered("Hex8")
        lines = ["*NODE", *(f"{number}, {x}, {y}, {z}" for number, (x, y, z) in zip(mesh.node_numbers, mesh.nodes))]
        for block in mesh.blocks:
            lines.append(f"*ELEMENT, TYPE=C3D8, ELSET={block.name}")
            lines += [f"{number}, {', '.join(str(mesh.node_numbers[node]) for node in row)}" for number, row in zip(block.numbers, block.connectivity)]
        (work / "mesh.inp").write_text("\n".join(lines) + "\n")
        # What a converted deck lacks is side sets: the scene is refused for that, its mesh is not.
        subprocess.run([harmos, "mesh", str(scene("mesh.inp")), "--output", str(work / "made.e"), "--quiet"], check=True)
        made = read_exodus(str(work / "made.e"), Findings())
        at = {number: tuple(place) for number, place in zip(mesh.node_numbers, mesh.nodes)}
        self.assertEqual([at[number] for number in made.node_numbers], [tuple(place) for place in made.nodes])
        self.assertEqual(sorted(made.element_numbers()), sorted(mesh.element_numbers()))
        nodes = {number: sorted(mesh.node_numbers[row]) for block in mesh.blocks for number, row in zip(block.numbers, block.connectivity)}
        for block in made.blocks:
            for number, row in zip(block.numbers, block.connectivity):
                self.assertEqual(sorted(made.node_numbers[row]), nodes[number])

        cube = "".join(f"{n}, {n - 1 & 1}, {n - 1 >> 1 & 1}, {n - 1 >> 2}\n" for n in range(1, 9))
        (work / "two.inp").write_text(f"""*PART, NAME=P
*NODE
{cube}*ELEMENT, TYPE=C3D8, ELSET=E
17, 1,2,4,3,5,6,8,7
*SOLID SECTION, ELSET=E, MATERIAL=M
*END PART
*ASSEMBLY, NAME=A
*INSTANCE, NAME=A-1, PART=P
*END INSTANCE
*INSTANCE, NAME=A-2, PART=P
0, 0, 1
*END INSTANCE
*END ASSEMBLY
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
""")
        said = subprocess.run([harmos, "import", str(work / "two.inp"), "--output", str(work / "two")], check=True, capture_output=True, text=True)
        self.assertIn("instances of the deck have elements of the same numbers: those of each but the first have 100, 200 and so on added", said.stdout)
        two = read_exodus(str(work / "two" / "two.e"), Findings())
        self.assertEqual(two.element_numbers().tolist(), [17, 117])
        self.assertEqual(two.node_numbers.tolist(), [*range(1, 9), *range(11, 19)])


unittest.main(argv=sys.argv[:1])
