"""Universal files of I-DEAS (.unv), as Salome, NX, Gmsh and others write them: nodes, elements and groups.

The format: University of Cincinnati, Structural Dynamics Research Laboratory, "Universal File Formats", data sets 2411, 2412 and 2467.
"""
import collections
import pathlib
from collections.abc import Container, Iterator

import numpy

from harmos.exchange.findings import Findings, Refused
from harmos.exchange.foreign_mesh import Cells, Source, mesh_of
from harmos.exchange.mesh import Mesh

_NODES, _ELEMENTS = ("781", "2411"), ("2412",)

_GROUPS = {"752": 2, "2417": 2, "2429": 2, "2430": 2, "2432": 2, "2435": 4, "2452": 4, "2467": 4, "2477": 4}
"""Data sets of groups, and how many numbers a member has in them: kind and label come first."""

_BEAMS = (11, 21, 22, 23, 24)
"""Elements with a further line."""

_RING_3, _RING_4 = [0, 2, 4, 1, 3, 5], [0, 2, 4, 6, 1, 3, 5, 7]
"""Corners and middles of edges that a file names in turns, as meshio has them: the corners first."""

_TYPES: dict[int, tuple[str, list[int]]] = {
    **dict.fromkeys((11, 21, 22), ("line", [0, 1])), **dict.fromkeys((23, 24), ("line3", [0, 2, 1])),
    **dict.fromkeys((41, 51, 61, 74, 81, 91), ("triangle", [0, 1, 2])),
    **dict.fromkeys((42, 52, 62, 72, 82, 92), ("triangle6", _RING_3)),
    **dict.fromkeys((44, 54, 64, 71, 84, 94), ("quad", [0, 1, 2, 3])),
    **dict.fromkeys((45, 55, 65, 75, 85, 95), ("quad8", _RING_4)),
    111: ("tetra", [0, 1, 2, 3]), 118: ("tetra10", [0, 2, 4, 9, 1, 3, 5, 6, 7, 8]),
    112: ("wedge", [0, 1, 2, 3, 4, 5]), 113: ("wedge15", [0, 2, 4, 9, 11, 13, 1, 3, 5, 10, 12, 14, 6, 7, 8]),
    115: ("hexahedron", list(range(8))),
    116: ("hexahedron20", [0, 2, 4, 6, 12, 14, 16, 18, 1, 3, 5, 7, 13, 15, 17, 19, 8, 9, 10, 11]),
}
"""Types of meshio by the numbers of the format, and where the nodes of theirs stand in a file."""


def read_universal(path: str, findings: Findings) -> Mesh:
    """Reads a mesh; groups of elements become blocks and side sets, those of nodes node sets.

    Raises:
        Refused: the file is damaged, or has elements that Harmos has not.
    """
    content = _Content(path)
    for name, count in content.missing().items():
        findings.leave_out(path, f"group \"{name}\"", f"{count} of its members are not in the file")
    return mesh_of(path, content.source(), findings)


class _Content:
    """What a file holds, by the numbers that it gives to nodes and elements."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._lines = pathlib.Path(path).read_bytes().decode("latin-1").splitlines()
        self._at = 0
        self._places: dict[int, list[float]] = {}
        self._elements: dict[int, tuple[str, list[int]]] = {}
        self._members: dict[int, dict[int, set[str]]] = {7: {}, 8: {}}
        for name, begin, end in self._data_sets():
            try:
                if name in _NODES:
                    self._read_nodes(begin, end)
                elif name in _ELEMENTS:
                    self._read_elements(begin, end)
                elif name in _GROUPS:
                    self._read_groups(begin, end, _GROUPS[name])
            except (ValueError, IndexError):
                raise Refused(f"{path}:{self._at + 1}: this is no line of data set {name}; the file is truncated or damaged.") from None
        if not self._places:
            raise Refused(f"{path}: it holds no nodes (data set 2411); it is no universal file, or damaged.")

    def _data_sets(self) -> Iterator[tuple[str, int, int]]:
        """Name, first line and the line behind the last one."""
        marks = [number for number, line in enumerate(self._lines) if line.strip() == "-1" and line.startswith("    -1")]
        if len(marks) % 2:
            raise Refused(f"{self._path}:{marks[-1] + 1}: this data set does not end; the file is truncated.")
        for begin, end in zip(marks[::2], marks[1::2]):
            yield self._lines[begin + 1].strip(), begin + 2, end

    def _words(self, end: int) -> list[str]:
        """Those of the next line."""
        if self._at >= end:
            raise IndexError
        words = self._lines[self._at].split()
        self._at += 1
        return words

    def _read_nodes(self, begin: int, end: int) -> None:
        self._at = begin
        while self._at < end:
            label = int(self._words(end)[0])
            self._places[label] = [float(word.upper().replace("D", "E")) for word in self._words(end)[:3]]
            if len(self._places[label]) != 3:
                raise ValueError

    def _read_elements(self, begin: int, end: int) -> None:
        self._at = begin
        while self._at < end:
            label, kind, *_, count = [int(word) for word in self._words(end)]
            if kind in _BEAMS:
                self._words(end)
            nodes: list[int] = []
            while len(nodes) < count:
                nodes += [int(word) for word in self._words(end)]
            name, order = _TYPES.get(kind, ("vertex" if count == 1 else f"type_{kind}", list(range(count))))
            self._elements[label] = name, [nodes[position] for position in order]

    def _read_groups(self, begin: int, end: int, width: int) -> None:
        self._at = begin
        while self._at < end:
            count = int(self._words(end)[7])
            name = " ".join(self._words(end))
            while count > 0:
                words = self._words(end)
                if len(words) < width:
                    raise ValueError
                for kind, label in zip(words[::width], words[1::width]):
                    count -= 1
                    if int(kind) in self._members:
                        self._members[int(kind)].setdefault(int(label), set()).add(name)

    def missing(self) -> dict[str, int]:
        """How many members of groups are nowhere, by the names of the groups that have such."""
        there: dict[int, Container[int]] = {7: self._places, 8: self._elements}
        return collections.Counter(name for kind, members in self._members.items() for label, names in members.items()
                                   if label not in there[kind] for name in names)

    def source(self) -> Source:
        """With a family of each combination of groups, as MED has them."""
        number = {label: position for position, label in enumerate(self._places)}
        families: dict[frozenset[str], int] = {frozenset(): 0}

        def family(kind: int, label: int) -> int:
            return families.setdefault(frozenset(self._members[kind].get(label, ())), -len(families))

        tables: dict[str, tuple[list[list[int]], list[int], list[int]]] = {}
        for label, (name, nodes) in self._elements.items():
            missing = [node for node in nodes if node not in number]
            if missing:
                raise Refused(f"{self._path}: element {label} refers to node {missing[0]}, which is not there; the file is damaged.")
            rows, of, labels = tables.setdefault(name, ([], [], []))
            rows.append([number[node] for node in nodes])
            of.append(family(8, label))
            labels.append(label)
        if not tables:
            raise Refused(f"{self._path}: it holds no elements (data set 2412).")
        points = numpy.array([family(7, label) for label in self._places])
        names = {index: sorted(groups) for groups, index in families.items()}
        return Source(numpy.array(list(self._places.values())), [Cells(name, numpy.array(rows), numpy.array(labels)) for name, (rows, _, labels) in tables.items()],
                      {"cell_tags": [numpy.array(of) for _, of, _ in tables.values()]}, {"point_tags": points}, cell_tags=names,
                      point_tags={index: names[index] for index in set(points.tolist())},
                      point_numbers=numpy.array(list(self._places)))
