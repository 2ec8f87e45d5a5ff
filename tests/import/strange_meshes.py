#!/usr/bin/python3
"""Exodus files as other programs write them: each is read right, or refused with the reason. strange_meshes.py HARMOS WORK_DIR"""
import csv
import pathlib
import shutil
import subprocess
import sys
import unittest
from collections.abc import Callable

import netCDF4
import numpy

harmos = sys.argv[1]
work = pathlib.Path(sys.argv[2])


class Blocks:
    """Two blocks of 2 x 2 x 2 hexahedra on each other, `lower` and `upper`, and how the file says so."""

    def __init__(self) -> None:
        box = numpy.array([(x / 2, y / 2, z / 2) for z in range(3) for y in range(3) for x in range(3)])
        cell = numpy.array([0, 1, 4, 3, 9, 10, 13, 12])
        cells = numpy.array([cell + x + 3 * y + 9 * z for z in range(2) for y in range(2) for x in range(2)]) + 1
        self.nodes = numpy.concatenate([box, box + [0, 0, 1]])
        self.blocks = [("lower", 10, "HEX8", cells), ("upper", 20, "HEX8", cells + 27)]
        self.side_sets = [("bottom", 1, [1, 2, 3, 4], [5] * 4), ("top", 2, [13, 14, 15, 16], [6] * 4)]
        self.node_sets = [("floor", 1, list(range(1, 10)))]
        self.format, self.real, self.whole, self.name_length = "NETCDF3_64BIT_OFFSET", "f8", "i4", 32
        self.temperature = False
        self.maps: dict[str, numpy.ndarray] = {}

    def write(self, path: pathlib.Path) -> None:
        with netCDF4.Dataset(path, "w", format=self.format) as file:
            file.setncatts({"api_version": numpy.float32(8.11), "version": numpy.float32(8.11), "title": "strange",
                            "floating_point_word_size": numpy.int32(self.real[1]), "file_size": numpy.int32(1),
                            "maximum_name_length": numpy.int32(self.name_length)})
            for name, size in (("len_string", 33), ("len_line", 81), ("four", 4), ("len_name", self.name_length + 1), ("num_dim", 3),
                               ("num_nodes", len(self.nodes)), ("num_elem", sum(len(rows) for *_, rows in self.blocks)),
                               ("num_el_blk", len(self.blocks)), ("num_side_sets", len(self.side_sets)), ("num_node_sets", len(self.node_sets))):
                file.createDimension(name, size)
            file.createDimension("time_step", None)
            file.createVariable("time_whole", self.real, ("time_step",))
            for axis, values in zip("xyz", self.nodes.T):
                file.createVariable("coord" + axis, self.real, ("num_nodes",))[:] = values
            for short, dimension, entities in (("eb", "num_el_blk", self.blocks), ("ss", "num_side_sets", self.side_sets),
                                               ("ns", "num_node_sets", self.node_sets)):
                file.createVariable(short + "_status", self.whole, (dimension,))[:] = [1 if len(each[-1]) else 0 for each in entities]
                ids = file.createVariable(short + "_prop1", self.whole, (dimension,))
                ids.setncattr("name", "ID")
                ids[:] = [each[1] for each in entities]
                self._names(file, short + "_names", dimension, [each[0] for each in entities])
            for number, (_, _, kind, rows) in enumerate(self.blocks, 1):
                if len(rows):
                    self._table(file, f"connect{number}", rows, f"num_el_in_blk{number}", f"num_nod_per_el{number}").setncattr("elem_type", kind)
            for number, (_, _, elements, sides) in enumerate(self.side_sets, 1):
                self._table(file, f"elem_ss{number}", numpy.array(elements), f"num_side_ss{number}")
                self._table(file, f"side_ss{number}", numpy.array(sides), f"num_side_ss{number}")
            for number, (_, _, nodes) in enumerate(self.node_sets, 1):
                self._table(file, f"node_ns{number}", numpy.array(nodes), f"num_nod_ns{number}")
            for name, numbers in self.maps.items():
                self._table(file, name, numbers, f"num_of_{name}")
            if self.temperature:
                file.variables["time_whole"][:] = [0.0, 1.0]
                file.createDimension("num_nod_var", 1)
                self._names(file, "name_nod_var", "num_nod_var", ["T"])
                file.createVariable("vals_nod_var1", self.real, ("time_step", "num_nodes"))[:] = numpy.ones((2, len(self.nodes)))

    def _names(self, file: netCDF4.Dataset, variable: str, dimension: str, names: list[str]) -> None:
        table = numpy.array([list(name.ljust(self.name_length + 1, "\0")) for name in names], dtype="S1")
        file.createVariable(variable, "S1", (dimension, "len_name"))[:] = table

    def _table(self, file: netCDF4.Dataset, variable: str, values: numpy.ndarray, *dimensions: str) -> netCDF4.Variable:
        for name, size in zip(dimensions, values.shape):
            if name not in file.dimensions:
                file.createDimension(name, size)
        table = file.createVariable(variable, self.whole, dimensions)
        table[:] = values
        return table

    def named(self, blocks: tuple[str, str], sets: tuple[str, str]) -> None:
        self.blocks = [(name, *rest) for name, (_, *rest) in zip(blocks, self.blocks)]
        self.side_sets = [(name, *rest) for name, (_, *rest) in zip(sets, self.side_sets)]

    def typed(self, kind: str) -> None:
        self.blocks = [(name, number, kind, rows) for name, number, _, rows in self.blocks]


def parameter(name: str, kind: str, value: str) -> str:
    return f'<Parameter name="{name}" type="{kind}" value="{value}"/>'


def parameters(name: str, *content: str) -> str:
    return f'<ParameterList name="{name}">{"".join(content)}</ParameterList>'


def scene(blocks: tuple[str, str] = ("lower", "upper"), sets: tuple[str, str] = ("bottom", "top"), mesh: str = "", more: str = "",
          held: str = "") -> str:
    """The blocks, of modulus 1000 and no contraction, on each other, pressed by 1."""
    parts = [parameters(part, parameter("Blocks", "Array(string)", f"{{{block}}}"), parameter("Material", "string", "steel"))
             for part, block in zip(("one", "other"), blocks)]
    return parameters(
        "Harmos", parameters("Mesh", parameter("Type", "string", "Exodus"), parameter("File", "string", "mesh.e"), mesh),
        parameters("Materials", parameters("steel", parameter("Type", "string", "Isotropic"), parameter("Young's Modulus", "double", "1000"),
                                           parameter("Poisson's Ratio", "double", "0"), parameter("Thermal Expansion", "double", "1e-3"))),
        parameters("Parts", *parts), more,
        parameters("Interfaces", parameters("joint", parameter("Part 1", "string", "one"), parameter("Part 2", "string", "other"),
                                            parameters("Law", parameter("Type", "string", "Perfect")))),
        parameters("Boundaries",
                   parameters("held", held or parameter("Side Set", "string", sets[0]),
                              parameters("Law", parameter("Type", "string", "Prescribed Displacement"),
                                         *(parameter(axis, "double", "0") for axis in "XYZ"))),
                   parameters("load", parameter("Side Set", "string", sets[1]),
                              parameters("Law", parameter("Type", "string", "Prescribed Traction"), parameter("Z", "double", "-1")))),
        parameters("Steps", parameters("load")), parameters("Solver", parameter("Accuracy", "double", "1e-6")),
        parameters("Responses", parameters("top", parameter("Type", "string", "Mean Displacement"), parameter("Side Set", "string", sets[1]),
                                           parameter("Direction", "Array(double)", "{0, 0, 1}"))))


class StrangeMeshes(unittest.TestCase):
    def run_on(self, change: Callable[[Blocks], object], text: str = "") -> subprocess.CompletedProcess[str]:
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        blocks = Blocks()
        change(blocks)
        blocks.write(work / "mesh.e")
        (work / "scene.xml").write_text(text or scene())
        return subprocess.run([harmos, "run", str(work / "scene.xml"), "--output", str(work / "out"), "--quiet"], capture_output=True,
                              text=True, check=False)

    def demand_right(self, change: Callable[[Blocks], object], text: str = "", top: float = -2e-3) -> None:
        result = self.run_on(change, text)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(work / "out" / "scene_history.csv", encoding="utf-8") as file:
            self.assertAlmostEqual(float(list(csv.DictReader(file))[-1]["top"]), top, 7)

    def demand_refused(self, change: Callable[[Blocks], object], words: str, text: str = "") -> None:
        result = self.run_on(change, text)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(words, result.stderr)
        self.assertFalse((work / "out").exists())

    def test_types(self) -> None:
        for kind in ("hex8", "HEX", "hex", "Hexahedron", "HEX8 "):
            with self.subTest(kind):
                self.demand_right(lambda blocks: blocks.typed(kind))
        self.demand_refused(lambda blocks: blocks.typed("BRICK"), "\"lower\" BRICK (8 nodes)")

    def test_numbers_in_other_sizes(self) -> None:
        warm = parameters("Temperatures", parameters("warm", parameter("Type", "string", "Nodal Variable"), parameter("Variable", "string", "T")))
        for kind in ("NETCDF3_CLASSIC", "NETCDF3_64BIT_DATA", "NETCDF4", "NETCDF4_CLASSIC"):
            for real in ("f4", "f8"):
                def change(blocks: Blocks) -> None:
                    blocks.format, blocks.real, blocks.temperature = kind, real, True
                    if kind == "NETCDF4":
                        blocks.whole = "i8"
                        blocks.blocks = [(name, number + 2**40, *rest) for name, number, *rest in blocks.blocks]
                        blocks.side_sets = [(name, number + 2**41, *rest) for name, number, *rest in blocks.side_sets]
                with self.subTest(kind, real=real):
                    self.demand_right(change)
                    self.demand_right(change, scene(more=warm), 0.0)

    def test_names(self) -> None:
        for names, sets in ((("lower plate", "upper plate"), ("the bottom", "  the top ")), (("l" * 80, "u" * 80), ("b" * 80, "t" * 80)),
                            (("", ""), ("", "")), (("Plate", "plate"), ("a{b,c}", "a/b"))):
            def change(blocks: Blocks) -> None:
                blocks.name_length = 80
                blocks.named(names, sets)
            wanted = [(name.strip() or unnamed, of.strip() or unset) for name, of, unnamed, unset in
                      zip(names, sets, ("block_10", "block_20"), ("sideset_1", "sideset_2"))]
            with self.subTest(names):
                self.demand_right(change, scene((wanted[0][0], wanted[1][0]), (wanted[0][1], wanted[1][1])))

    def test_entries_that_are_there_twice_or_not_at_all(self) -> None:
        none = numpy.zeros((0, 8), dtype=int)
        for at in (0, 1, 2):
            self.demand_right(lambda blocks: blocks.blocks.insert(at, ("none", 7, "HEX8", none)))
        twice = [1, 2, 3, 4, 2, 2]
        self.demand_right(lambda blocks: blocks.side_sets.__setitem__(0, ("bottom", 1, twice, [5] * 6)))
        self.demand_right(lambda blocks: blocks.node_sets.__setitem__(0, ("floor", 1, [*range(1, 10), 3, 3])),
                          scene(held=parameter("Node Set", "string", "floor")))
        self.demand_refused(lambda blocks: blocks.side_sets.append(("top", 3, [1], [1])), "two side sets are named \"top\"; rename one")

    def test_sets_of_one_name(self) -> None:
        def change(blocks: Blocks) -> None:
            blocks.node_sets = [("bottom", 1, list(range(1, 10))), ("top", 2, [54])]
        self.demand_right(change)
        # What the verb `mesh` writes of it is the same mesh.
        result = subprocess.run([harmos, "mesh", str(work / "scene.xml"), "--output", str(work / "again.e")], capture_output=True,
                                text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("2 side sets, 2 node sets", result.stdout)
        for held in ("Side Set", "Node Set"):
            (work / "again.xml").write_text(scene(held=parameter(held, "string", "bottom")).replace("mesh.e", "again.e"))
            command = [harmos, "run", str(work / "again.xml"), "--output", str(work / "out"), "--quiet"]
            result = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, 0, result.stderr)
            with open(work / "out" / "again_history.csv", encoding="utf-8") as file:
                self.assertAlmostEqual(float(list(csv.DictReader(file))[-1]["top"]), -2e-3, 7)

    def test_shells_beside_solids(self) -> None:
        def change(blocks: Blocks) -> None:
            blocks.blocks.append(("skin", 30, "SHELL4", blocks.blocks[1][3][4:, 4:]))
            blocks.side_sets.append(("of_skin", 3, [17, 18], [1, 5]))
        self.demand_refused(change, "\"skin\" SHELL4 (4 nodes)")
        unused = parameter("Unused Blocks", "Array(string)", "{skin}")
        self.demand_right(change, scene(mesh=unused))
        self.demand_refused(change, "side set \"of_skin\" is empty; faces of the unused blocks \"skin\" are left out",
                            scene(sets=("bottom", "of_skin"), mesh=unused))

    def test_sets_that_no_boundary_can_have(self) -> None:
        def change(blocks: Blocks) -> None:
            blocks.side_sets += [("inner", 3, [1, 3], [2, 2]), ("joint", 4, [5, 6, 7, 8], [6] * 4)]
            blocks.node_sets.append(("inner", 2, [1, 2]))
        self.run_on(change)
        for option, name, words in (("--load", "inner", "it lies inside of a part in places"), ("--hold", "joint", "it is a side of an interface"),
                                    ("--load", "joint", "it is a side of an interface"), ("--hold", "inner", ""), ("--load", "top", "")):
            command = [harmos, "import", str(work / "mesh.e"), "--output", str(work / "imported"), option, name]
            result = subprocess.run(command, capture_output=True, text=True, check=False)
            with self.subTest(option, name=name):
                self.assertEqual(result.returncode, 2 if words else 0, result.stderr)
                self.assertIn(f"{option} {name}: {words}" if words else "as asked for", result.stderr if words else result.stdout)
                self.assertEqual((work / "imported").exists(), not words)
            shutil.rmtree(work / "imported", ignore_errors=True)

    def test_maps_that_are_none(self) -> None:
        for numbers in (numpy.arange(1, 100001), numpy.arange(1, 4), numpy.zeros(16, dtype=int), -numpy.arange(1, 17)):
            for name in ("elem_num_map", "node_num_map"):
                with self.subTest(name, length=len(numbers)):
                    self.demand_right(lambda blocks: blocks.maps.update({name: numbers}))
                    command = [harmos, "import", str(work / "mesh.e"), "--output", str(work / "imported")]
                    result = subprocess.run(command, capture_output=True, text=True, check=False)
                    self.assertEqual(result.returncode, 0, result.stderr)

    def test_coordinates(self) -> None:
        def moved(blocks: Blocks, place: float) -> None:
            blocks.nodes[7, 1] = place
        for place, words in ((numpy.nan, "node 8 of \"mesh.e\" has a coordinate that is not a number"),
                             (numpy.inf, "node 8 of \"mesh.e\" has a coordinate that is not a number"),
                             (1e200, "node 8 of \"mesh.e\" has a coordinate beyond 1e100")):
            self.demand_refused(lambda blocks: moved(blocks, place), words)
        self.demand_refused(lambda blocks: moved(blocks, -30.0), "of \"mesh.e\" (block \"lower\"): the element is turned")


unittest.main(argv=sys.argv[:1])
