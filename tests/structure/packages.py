#!/usr/bin/env python3
"""Prints which package includes which, and fails where the files contradict the rows of harmos_package().

  packages.py [--root DIR] [--dot]

A row is what follows USES in the package's CMakeLists.txt; the order is the list HARMOS_PACKAGES. With --dot only the
graph, for Graphviz. Exit code 1 when something is wrong.
"""
import argparse
import collections
import pathlib
import re
import sys

KEYWORDS = {"USES", "PUBLIC", "PRIVATE", "SOURCES"}
OF_NO_PACKAGE = {"version.hpp"}  # made by CMake
INCLUDE = re.compile(r'^\s*#\s*include\s*<harmos/([^>]+)>', re.MULTILINE)


def arguments(path, command):
    """The words of the first call of a CMake command in a file."""
    text = re.sub(r"#.*", "", path.read_text())
    call = re.search(re.escape(command) + r"([^)]*)\)", text)
    return call.group(1).split() if call else []


def row_of(path):
    row, inside = [], False
    for word in arguments(path, "harmos_package(")[1:]:
        if word in KEYWORDS:
            inside = word == "USES"
        elif inside:
            row.append(word)
    return row


def sources(*folders):
    return sorted(path for folder in folders for suffix in ("*.hpp", "*.cpp") for path in folder.rglob(suffix))


def includes(path):
    return [each for each in INCLUDE.findall(path.read_text()) if each not in OF_NO_PACKAGE]


def closure(start, following):
    seen, queue = set(start), list(start)
    while queue:
        for each in following(queue.pop()):
            if each not in seen:
                seen.add(each)
                queue.append(each)
    return seen


def circles(edges):
    """For every node that lies on circles a shortest one, each circle once."""
    found = {}
    for start in sorted(edges):
        before = {start: None}
        queue = collections.deque([start])
        while queue:
            node = queue.popleft()
            if start in edges[node]:
                circle = []
                while node is not None:
                    circle.insert(0, node)
                    node = before[node]
                found.setdefault(frozenset(circle), circle)
                break
            for each in sorted(edges[node]):
                if each not in before:
                    before[each] = node
                    queue.append(each)
    return found.values()


class Packages:
    def __init__(self, root):
        folder = self.folder = root / "packages"
        self.order = arguments(folder / "CMakeLists.txt", "set(HARMOS_PACKAGES")
        self.rows = {each: row_of(folder / each / "CMakeLists.txt") for each in self.order}
        # All files by the name under which they are included, `base/Error.hpp`.
        self.files = {str(path.relative_to(folder)): includes(path) for path in sources(folder)}
        self.outside = {str(path.relative_to(root)): includes(path)
                        for path in sources(root / "tests", root / "drivers")}

    def of(self, package):
        return {name: included for name, included in self.files.items() if name.startswith(package + "/")}

    def direct(self, package):
        return collections.Counter(each.split("/")[0] for included in self.of(package).values() for each in included
                                   if each.split("/")[0] != package)

    def seen(self, package):
        """The packages whose headers the package includes, directly or through other headers."""
        start = {each for included in self.of(package).values() for each in included}
        return {each.split("/")[0] for each in closure(start, lambda name: self.files.get(name, []))} - {package}

    def errors(self):
        for package in self.order:
            row = self.rows[package]
            before = self.order[:self.order.index(package)]
            for each in row:
                if each not in before:
                    yield f"{package}: its row names {each}, which is not above it in HARMOS_PACKAGES"
            for each in sorted(set(row) - self.seen(package)):
                yield f"{package}: its row names {each}, but no file needs it"
            for name, included in self.of(package).items():
                yield from self.include_errors(package, name, included)
        for name in sorted(set(self.files)):
            if name.split("/")[0] not in self.order:
                yield f"packages/{name}: its folder is not in HARMOS_PACKAGES"
        for circle in circles(self.nodes()):
            yield "circle: " + " -> ".join(circle + circle[:1])
        yield from self.hidden_headers()

    def include_errors(self, package, name, included):
        for each in included:
            other = each.split("/")[0]
            is_generated = (self.folder / f"{each}.in").exists()
            if each not in self.files and not is_generated:
                yield f"packages/{name}: there is no <harmos/{each}>"
            elif other != package and other not in self.rows[package]:
                yield f"packages/{name}: includes <harmos/{each}>, but the row of {package} does not name {other}"
            if "/detail/" in each and other != package:
                yield f"packages/{name}: includes <harmos/{each}>, a detail of {other}"
            elif "/detail/" in each and name.endswith(".hpp") and "/detail/" not in name:
                yield f"packages/{name}: a public header includes <harmos/{each}>"

    def nodes(self):
        """Edges between pairs of .hpp and .cpp, wherever in the package they lie."""
        def node(name):
            path = pathlib.PurePath(name)
            return f"{path.parts[0]}/{path.stem}"
        edges = {node(name): set() for name in self.files}
        for name, included in self.files.items():
            edges[node(name)].update(node(each) for each in included if each in self.files and node(each) != node(name))
        return edges

    def hidden_headers(self):
        def is_public(name):
            return name.endswith(".hpp") and name in self.files and "/detail/" not in name
        used = {each for included in self.outside.values() for each in included}
        used |= {each for name, included in self.files.items() for each in included
                 if each.split("/")[0] != name.split("/")[0]}
        reached = closure(set(filter(is_public, used)), lambda name: filter(is_public, self.files[name]))
        for name in sorted(set(filter(is_public, self.files)) - reached):
            yield f"packages/{name}: only {name.split('/')[0]} itself includes it, it belongs into detail/"

    def text(self):
        for package in self.order:
            direct = self.direct(package)
            listed = ", ".join(f"{each} {direct[each]}" for each in self.order if direct[each])
            through = [each for each in self.rows[package] if not direct[each]]
            yield f"{package}: {listed or 'nothing'}" + (f"; only through headers: {', '.join(through)}" if through else "")

    def dot(self):
        yield "digraph packages {"
        for package in self.order:
            yield f"  {package};"
            for each, count in sorted(self.direct(package).items()):
                yield f'  {package} -> {each} [label="{count}"];'
        yield "}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--dot", action="store_true", help="print the graph for Graphviz, check nothing")
    options = parser.parse_args()
    packages = Packages(options.root)
    if not packages.order:
        sys.exit("packages/CMakeLists.txt has no list HARMOS_PACKAGES")
    print("\n".join(packages.dot() if options.dot else packages.text()))
    errors = [] if options.dot else list(packages.errors())
    for each in errors:
        print("FAILED:", each)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
