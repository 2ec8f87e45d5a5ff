#!/usr/bin/python3
"""Exodus -> .msh -> Exodus: blocks, side sets and node sets come back, for all elements and kinds of .msh; so do they
through .vtu and .med, as far as these have sets. round_trips.py HARMOS WORK_DIR"""
import contextlib
import io
import pathlib
import shutil
import subprocess
import sys
import unittest
from collections.abc import Callable

import h5py
import meshio
import numpy

from boxes import PLANES, SOLIDS, boxes_mesh
from gmsh_writer import write_gmsh
from harmos.exchange.__main__ import main
from harmos.exchange.elements import GMSH, MESHIO, permutation
from harmos.exchange.exodus import read_exodus, write_exodus
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.gmsh_mesh import read_gmsh, session
from harmos.exchange.mesh import LONGEST_NAME, Mesh

harmos = sys.argv[1]
work = pathlib.Path(sys.argv[2])


def places(mesh: Mesh, nodes: numpy.ndarray) -> list[tuple[float, ...]]:
    return [tuple(at) for at in numpy.round(mesh.nodes[nodes], 9).tolist()]


def sides(mesh: Mesh, name: str) -> list[list[tuple[float, ...]]]:
    first, rows = mesh.first_elements(), mesh.side_sets[name]
    result = []
    for (element, side), number in zip(rows, mesh.block_of(rows[:, 0])):
        block = mesh.blocks[number]
        result.append(places(mesh, block.connectivity[element - first[number], list(block.type.sides[side])]))
    return sorted(sorted(each) for each in result)


class RoundTrips(unittest.TestCase):
    def setUp(self) -> None:
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)

    def demand_equal(self, given: Mesh, back: Mesh, sets: bool = True) -> None:
        self.assertEqual(len(given.nodes), len(back.nodes))
        self.assertEqual([block.name for block in given.blocks], [block.name for block in back.blocks])
        for one, other in zip(given.blocks, back.blocks):
            self.assertEqual(one.type.name, other.type.name)
            self.assertEqual(sorted(map(tuple, (places(given, row) for row in one.connectivity))),
                             sorted(map(tuple, (places(back, row) for row in other.connectivity))))
        if not sets:
            return
        self.assertLessEqual(set(given.side_sets), set(back.side_sets))
        for name in given.side_sets:
            self.assertEqual(sides(given, name), sides(back, name), name)
        self.assertEqual(set(given.node_sets), set(back.node_sets))
        for name in given.node_sets:
            self.assertEqual(sorted(places(given, given.node_sets[name])), sorted(places(back, back.node_sets[name])))

    def imported(self, path: pathlib.Path) -> Mesh:
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(main(["import", "--output", str(work / "imported"), str(path)]), 0)
        subprocess.run([harmos, "check", str(work / "imported" / f"{path.stem}.xml")], check=True,
                       stdout=subprocess.DEVNULL)
        return read_exodus(str(work / "imported" / f"{path.stem}.e"), Findings())

    def test_gmsh(self) -> None:
        kinds = [(2.2, False), (2.2, True), (4.1, False), (4.1, True)]
        for number, element in enumerate(SOLIDS + PLANES):
            mesh = boxes_mesh(harmos, work, element)
            mesh.node_sets["line"] = mesh.node_sets.get("line", numpy.arange(3))
            version, binary = kinds[number % 4] if element not in ("Hex20", "Wedge15") else kinds[3]
            path = work / f"{element}.msh"
            write_gmsh(path, mesh, version, binary)
            with self.subTest(element, version=version, binary=binary):
                self.demand_equal(mesh, self.imported(path))

    def test_unv(self) -> None:
        for element in ("Tet4", "Hex8", "Wedge6", "Tet10", "Hex20", "Wedge15"):
            mesh = boxes_mesh(harmos, work, element)
            path = work / f"{element}.unv"
            write_gmsh(path, mesh)
            with self.subTest(element):
                self.demand_equal(mesh, self.imported(path))
            # Salome writes groups so, and those of nodes as nodes.
            text = path.read_text().replace("\n  2477\n", "\n  2467\n")
            end = text.rindex("    -1\n")
            group = [9, 0, 0, 0, 0, 0, 0, 3], "top corners", [7, 1, 0, 0, 7, 2, 0, 0], [7, 3, 0, 0]
            more = "".join((each if isinstance(each, str) else "".join(f"{number:10d}" for number in each)) + "\n" for each in group)
            path.write_text(text[:end] + more + text[end:])
            mesh.node_sets["top_corners"] = numpy.arange(3)
            with self.subTest(element, kind="2467"):
                self.demand_equal(mesh, self.imported(path))

    def test_groups_of_elements_that_a_unv_does_not_hold(self) -> None:
        mesh = boxes_mesh(harmos, work, "Hex8")
        mesh.node_sets["line"] = numpy.arange(3)
        write_gmsh(work / "points.unv", mesh)  # which leaves out elements of a point, but not the group of them
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            self.assertEqual(main(["import", "--output", str(work / "points"), str(work / "points.unv")]), 0)
        self.assertIn("points.unv: group \"line\": 3 of its members are not in the file", said.getvalue())

    def test_wrong_unv(self) -> None:
        write_gmsh(work / "sound.unv", boxes_mesh(harmos, work, "Hex8"))
        lines = (work / "sound.unv").read_text().splitlines(keepends=True)
        at = lines.index("  2412\n") + 1
        for wrong, words in ((lines[:at], f"unv:{at - 1}: this data set does not end"),
                             ([*lines[:at], "1 2\n", *lines[at + 1:]], f"unv:{at + 2}: this is no line of data set 2412"),
                             ([*lines[:at + 1], lines[at + 1].replace(" 1", "99", 1), *lines[at + 2:]], "which is not there")):
            with self.subTest(words):
                (work / "wrong.unv").write_text("".join(wrong))
                said = io.StringIO()
                with contextlib.redirect_stderr(said):
                    self.assertEqual(main(["import", "--output", str(work / "wrong"), str(work / "wrong.unv")]), 2)
                self.assertIn(words, said.getvalue())
                self.assertFalse((work / "wrong").exists())

    def test_decks_without_sections(self) -> None:
        for element in ("Hex8", "Tet10", "Wedge6", "Wedge15", "Hex20", "Tri6", "Quad4"):
            mesh = boxes_mesh(harmos, work, element)
            mesh.node_sets.clear()
            write_gmsh(work / f"{element}.inp", mesh)
            back = self.imported(work / f"{element}.inp")
            with self.subTest(element):
                self.demand_equal(mesh, back)
                self.assertEqual(len(mesh.side_sets), len(back.side_sets))

    def test_sets_of_decks_without_sections(self) -> None:
        write_gmsh(work / "sets.inp", boxes_mesh(harmos, work, "Hex8"))
        text = (work / "sets.inp").read_text() + ("*ELSET,ELSET=All\nlower, upper\n*NSET,NSET=Corner\n1, 2\n"
                                                  "*ELEMENT,TYPE=R3D4,ELSET=Nowhere\n99901, 1, 2, 3, 1\n")
        (work / "sets.inp").write_text(text + "*SURFACE,NAME=Skin\nAll\n*STEP\n*STATIC\n*END STEP\n")
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            self.assertEqual(main(["import", "--output", str(work / "out"), str(work / "sets.inp")]), 0)
        back = read_exodus(str(work / "out" / "sets.e"), Findings())
        self.assertEqual(["lower", "upper"], [block.name for block in back.blocks])
        self.assertEqual(len(back.node_sets["Corner"]), 2)
        self.assertEqual(len(back.side_sets["Skin"]), 48)
        self.assertIn("only its mesh is taken", said.getvalue())
        self.assertIn("Nowhere: 1 of its flat elements are sides of no solid", said.getvalue())

    def test_mesh_file_takes_gmsh(self) -> None:
        mesh = boxes_mesh(harmos, work, "Tet10")
        write_gmsh(work / "direct.msh", mesh)
        (work / "imported").mkdir()
        scene = (work / "Tet10.xml").read_text()
        begin, end = scene.index('<ParameterList name="Mesh">'), scene.index('<ParameterList name="Materials">')
        (work / "direct.xml").write_text(f"""{scene[:begin]}<ParameterList name="Mesh">
          <Parameter name="Type" type="string" value="Exodus"/>
          <Parameter name="File" type="string" value="direct.msh"/></ParameterList>{scene[end:]}""")
        subprocess.run([harmos, "mesh", str(work / "direct.xml"), "--output", str(work / "back.e"), "--quiet"],
                       check=True)
        self.demand_equal(mesh, read_exodus(str(work / "back.e"), Findings()))

    def test_mesh_file_tells_what_is_otherwise(self) -> None:
        mesh = boxes_mesh(harmos, work, "Hex8")
        mesh.node_sets["line"] = numpy.arange(3)
        write_gmsh(work / "direct.msh", mesh)
        text = (work / "direct.msh").read_text(encoding="latin-1")
        name = next(iter(mesh.side_sets))
        self.assertIn('"line"', text)
        held = "".join(f"""<ParameterList name="foot of {block.name}">
            <Parameter name="Side Set" type="string" value="{block.name}_zmin"/><ParameterList name="Law">
            <Parameter name="Type" type="string" value="Symmetry"/></ParameterList></ParameterList>""" for block in mesh.blocks)
        (work / "direct.msh").write_text(text.replace('"line"', f'"{name}"'), encoding="latin-1")
        scene = (work / "Hex8.xml").read_text()
        begin, end = scene.index('<ParameterList name="Mesh">'), scene.index('<ParameterList name="Materials">')
        (work / "direct.xml").write_text(f"""{scene[:begin]}<ParameterList name="Mesh">
          <Parameter name="Type" type="string" value="Exodus"/>
          <Parameter name="File" type="string" value="direct.msh"/></ParameterList>{scene[end:]}""".replace(
            '<ParameterList name="Steps">', f"""<ParameterList name="Boundaries">{held}</ParameterList>
            <ParameterList name="Steps">"""))
        said = " ".join(subprocess.run([harmos, "check", str(work / "direct.xml")], check=False, capture_output=True,
                                       encoding="utf-8").stdout.split())
        self.assertIn(f'the nodes of group "{name}" are the node set {name}_2 here: a set of that name is there already', said)

    def test_vtk(self) -> None:
        of_name = {name: (kind, order) for kind, (name, order) in MESHIO.items()}
        for element in ("Hex20", "Hex27", "Tet10", "Quad9"):
            mesh = boxes_mesh(harmos, work, element)
            cells, parts = [], []
            for number, block in enumerate(mesh.blocks):
                kind, order = of_name[block.type.name]
                cells.append((kind, block.connectivity[:, numpy.argsort(permutation(block.type.name, order))]))
                parts.append(numpy.full(len(block.connectivity), number))
                block.name = f"part_{number}"
            for path in (work / f"{element}.vtu", work / f"{element}.vtk"):
                meshio.write(path, meshio.Mesh(mesh.nodes, cells, cell_data={"part": parts}))
                with self.subTest(path.name):
                    self.demand_equal(mesh, self.imported(path), sets=False)

    def test_med(self) -> None:
        mesh = boxes_mesh(harmos, work, "Hex8")
        bottom = [row[:4] for row in mesh.blocks[0].connectivity.tolist() if mesh.nodes[row[0], 2] == 0.0]
        cells = [("hexahedron", numpy.concatenate([block.connectivity for block in mesh.blocks])),
                 ("quad", numpy.array(bottom))]
        count = len(mesh.blocks[0].connectivity)
        families = [numpy.array([-1] * count + [-2] * count), numpy.full(len(bottom), -3)]
        source = meshio.Mesh(mesh.nodes, cells, cell_data={"cell_tags": families})
        source.cell_tags = {-1: ["lower"], -2: ["upper"], -3: ["fixed"]}
        meshio.write(work / "groups.med", source)
        back = self.imported(work / "groups.med")
        self.demand_equal(mesh, back, sets=False)
        self.assertEqual(len(back.side_sets["fixed"]), len(bottom))
        # Where no volume is in a group, Salome writes no families of volumes.
        with h5py.File(work / "groups.med", "r+") as file:
            (step,) = file["ENS_MAA/mesh"].values()
            del step["MAI/HE8/FAM"]
            file["FAS/mesh/ELEME"].create_group("without groups").attrs["NUM"] = -7
        back = self.imported(work / "groups.med")
        self.assertEqual([(block.name, len(block.connectivity)) for block in back.blocks], [("part", 2 * count)])
        self.assertEqual(len(back.side_sets["fixed"]), len(bottom))

    def test_elements_of_med(self) -> None:
        turned = {"Hex8": [0, 3, 2, 1, 4, 7, 6, 5], "Tet10": [0, 2, 1, 3, 6, 5, 4, 7, 9, 8], "Wedge15": []}
        for element, names in (("Hex8", ("hexahedron", "HE8")), ("Tet10", ("tetra10", "T10")), ("Wedge15", ("wedge15", "P15"))):
            mesh = boxes_mesh(harmos, work, element)
            kind, order = MESHIO[names[0]]
            rows = numpy.concatenate([block.connectivity for block in mesh.blocks])[:, numpy.argsort(permutation(kind, order))]
            if turned[element]:  # as Salome does
                rows = rows[:, turned[element]]
            with h5py.File(work / f"{element}.med", "w") as file:
                nodes = file.create_dataset("ENS_MAA/mesh/step/NOE/COO", data=mesh.nodes.T.reshape(-1))
                nodes.attrs["NBR"] = len(mesh.nodes)
                table = file.create_dataset(f"ENS_MAA/mesh/step/MAI/{names[1]}/NOD", data=rows.T.reshape(-1) + 1)
                table.attrs["NBR"] = len(rows)
                node_numbers, numbers = 9000 - 7 * numpy.arange(len(mesh.nodes)), 100 + 3 * numpy.arange(len(rows))
                file.create_dataset("ENS_MAA/mesh/step/NOE/NUM", data=node_numbers)
                file.create_dataset(f"ENS_MAA/mesh/step/MAI/{names[1]}/NUM", data=numbers)
            with self.subTest(element):
                back = self.imported(work / f"{element}.med")
                (block,) = back.blocks
                self.assertEqual(back.node_numbers.tolist(), node_numbers.tolist())
                self.assertEqual(block.numbers.tolist(), numbers.tolist())
                self.assertEqual(block.type.name, kind)
                for node, spot in enumerate(block.type.order):
                    middle = back.nodes[block.connectivity[:, sorted(spot)]].mean(axis=1)
                    self.assertLess(numpy.abs(back.nodes[block.connectivity[:, node]] - middle).max(), 1e-12)

    def test_long_names_stay_different(self) -> None:
        mesh = boxes_mesh(harmos, work, "Hex8")
        for number, block in enumerate(mesh.blocks):
            block.name = f"{'long_' * 12}{number}"
        write_exodus(str(work / "long.e"), mesh)
        back = self.imported(work / "long.e")
        self.assertTrue(all(len(name) <= LONGEST_NAME for name in back.side_sets))

    def test_gmsh_writes_elements_of_several_groups_several_times(self) -> None:
        def bring(version: float, more: "Callable[[], None]") -> tuple[Mesh, str]:
            with session():
                import gmsh
                low, high = gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1), gmsh.model.occ.addBox(0, 0, 1, 1, 1, 1)
                gmsh.model.occ.fragment([(3, low)], [(3, high)])
                gmsh.model.occ.synchronize()
                for entities, name in (([1, 2], "all"), ([1], "low"), ([2], "high" + "_of_them" * 10)):
                    gmsh.model.setPhysicalName(3, gmsh.model.addPhysicalGroup(3, entities), name)
                gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, [5]), "support" * 12)
                gmsh.option.setNumber("Mesh.MeshSizeMax", 0.6)
                gmsh.model.mesh.generate(3)
                count = sum(len(tags) for _, tag in gmsh.model.getEntities(3)
                            for tags in gmsh.model.mesh.getElements(3, tag)[1])
                more()
                gmsh.option.setNumber("Mesh.MshFileVersion", version)
                gmsh.write(str(work / "several.msh"))
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                self.assertEqual(main(["import", "--output", str(work / "out"), str(work / "several.msh")]), 0)
            checked = subprocess.run([harmos, "check", str(work / "out" / "several.xml")], capture_output=True, text=True)
            self.assertEqual(checked.returncode, 0, checked.stderr)
            back = read_exodus(str(work / "out" / "several.e"), Findings())
            self.assertEqual(int(back.first_elements()[-1]), count)
            return back, said.getvalue()

        def ghosts() -> None:
            import gmsh
            gmsh.option.setNumber("Mesh.PartitionCreateGhostCells", 1)
            gmsh.model.mesh.partition(2)

        self.assertIn("elements are there twice", bring(2.2, lambda: None)[1])
        bring(4.1, lambda: None)
        bring(4.1, ghosts)

    def test_format_1_of_gmsh(self) -> None:
        text = "$NOD\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$ENDNOD\n$ELM\n2\n1 2 8 1 3 1 2 3\n2 4 7 1 4 1 2 3 4\n$ENDELM\n"
        (work / "old.msh").write_text(text)
        mesh = read_gmsh(str(work / "old.msh"), Findings())
        self.assertEqual(([len(block.connectivity) for block in mesh.blocks], [len(rows) for rows in mesh.side_sets.values()]), ([1], [1]))
        (work / "old.msh").write_text(text.replace("$ENDELM\n", ""))
        with self.assertRaisesRegex(Refused, "old.msh:12: there is no \\$ENDELM; the file is truncated"):
            read_gmsh(str(work / "old.msh"), Findings())

    def test_partitions_keep_their_groups(self) -> None:
        # Two tetrahedra of two partitions, a face of each in a group, and a group whose faces are those of no entity.
        (work / "parted.msh").write_text("""$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
2 8 "left"
2 9 "right"
2 10 "nowhere"
3 7 "body"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 1 1 1
$EndNodes
$Elements
4
1 2 4 8 1 1 1 1 2 3
2 2 4 9 2 1 2 2 3 5
3 4 4 7 1 1 1 1 2 3 4
4 4 4 7 1 1 2 2 3 4 5
$EndElements
""")
        findings = Findings()
        mesh = read_gmsh(str(work / "parted.msh"), findings)
        self.assertEqual([(block.part, len(block.connectivity)) for block in mesh.blocks], [("body", 2)])
        self.assertEqual({name: len(rows) for name, rows in mesh.side_sets.items()}, {"left": 1, "right": 1})
        self.assertEqual(findings.found, ["physical group \"nowhere\" of the file holds no elements"])

    def test_orders_are_those_of_gmsh(self) -> None:
        with session():
            import gmsh
            for kind, (name, order) in GMSH.items():
                _, dimension, _, count, local, corners = gmsh.model.mesh.getElementProperties(kind)
                at = numpy.reshape(local, (count, dimension))
                self.assertEqual(len(order), count, name)
                for place, spot in zip(at, order):
                    numpy.testing.assert_allclose(place, at[sorted(spot)].mean(axis=0), atol=1e-12, err_msg=name)
                self.assertEqual(sum(len(spot) == 1 for spot in order), corners)


unittest.main(argv=[sys.argv[0]])
