"""The XML of a scene or a study, read so that settings can be changed in it and the whole written again."""
import copy
import os
import pathlib
import re
import xml.etree.ElementTree as xml
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from harmos.outputs import replace_file


_NAME = re.compile(r"\$([^,{}]*[^,{}\s])")
"""The name of one of the Values, alone or in an array."""


@dataclass(frozen=True)
class Entry:
    """One change of an input.

    Attributes:
        path: names of the lists and of the entry, with slashes between.
        kind: type of the entry as XML has it, such as double.
        value: as text; None: the entry is taken out.
    """

    path: str
    kind: str
    value: str | None


class Document:
    """A scene, or a study with the scene that it is of.

    Attributes:
        path: of its file.
        study: root of the study's XML; None: it is a scene.
        scene: root of the scene's XML.
        scene_path: of the scene's file.
        overrides: changes of the scene that the study makes, as for --set.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Reads the file, and the scene of a study.

        Raises:
            OSError: one of them cannot be read.
            ValueError: one of them is not XML.
        """
        self.path = self.scene_path = pathlib.Path(path)
        root = _read(self.path)
        self.study = root if root.get("name") == "Harmos Study" else None
        if self.study is not None:
            name = value_of(self.study, "Scene")
            if name is None:
                raise ValueError(f"{path}: the study names no scene")
            self.scene_path = self.path.parent / name
            root = _read(self.scene_path)
        self.scene = root
        self.overrides = _listed(value_of(self.study, "Scene Overrides")) if self.study is not None else []

    def value(self, path: str, otherwise: str) -> str:
        """The entry of the scene, as the study's overrides leave it and without names of Values; `otherwise`: there is none."""
        value = self._written(path)
        return otherwise if value is None else _NAME.sub(
            lambda name: self._written(f"Values/{name.group(1)}") or name.group(0), value)

    def is_varied(self, path: str) -> bool:
        """Whether a parameter of the study sets the entry of the scene, or a number of Values that it names."""
        parameters = find(self.study, "Parameters") if self.study is not None else None
        varied = {value_of(one, "Entry") for one in parameters} if parameters is not None else set()
        names = _NAME.findall(self._written(path) or "")
        return not varied.isdisjoint({path, *(f"Values/{name}" for name in names)})

    def _written(self, path: str) -> str | None:
        for override in self.overrides:
            name, _, text = override.partition("=")
            if name.strip() == path:
                return text.strip()
        return value_of(self.scene, path)

    def inputs(self) -> list[pathlib.Path]:
        """All files that are read: its own, that of the scene, and those which an entry or an override names."""
        files = [self.path, self.scene_path]
        roots = [(self.scene, self.scene_path), *([(self.study, self.path)] if self.study is not None else [])]
        for root, path in roots:
            files += [path.parent / file for _, named in _naming(root) for file in named]
        overriding = (one.partition("=") for one in self.overrides)
        return files + [self.scene_path.parent / text.strip() for path, _, text in overriding if _names_file(path)]

    def names(self, path: str) -> list[str]:
        """Names of the lists in a list of the scene, in their order."""
        found = find(self.scene, path)
        return [] if found is None else [one.get("name", "") for one in found if one.tag == "ParameterList"]

    def write(self, entries: Iterable[Entry], target: pathlib.Path, remark: str,
              home: pathlib.Path | None = None) -> list[pathlib.Path]:
        """Writes it with changes; entries that begin with "Study/" are the study's. The scene of a study is written beside.

        Args:
            entries: what changes.
            target: file of the scene, or of the study.
            remark: a comment at the head of it.
            home: folder that `target` will be moved into; None: it stays.

        Returns:
            The files, `target` first.
        """
        changes = list(entries)
        home = home or target.parent
        scene = copy.deepcopy(self.scene)
        for entry in changes:
            if not entry.path.startswith("Study/"):
                _set(scene, entry)
        if self.study is None:
            _write(scene, self.path.parent, target, home, remark)
            return [target]
        study = copy.deepcopy(self.study)
        for entry in changes:
            if entry.path.startswith("Study/"):
                _set(study, Entry(entry.path.removeprefix("Study/"), entry.kind, entry.value))
        changed = {entry.path for entry in changes}
        kept = [_moved_override(one, self.scene_path.parent, home) for one in self.overrides
                if one.partition("=")[0].strip() not in changed]
        _set(study, Entry("Scene Overrides", "Array(string)", "{" + ", ".join(kept) + "}" if kept else None))
        scene_target = scene_beside(target)
        _set(study, Entry("Scene", "string", scene_target.name))
        _write(scene, self.scene_path.parent, scene_target, home, remark)
        _write(study, self.path.parent, target, home, remark)
        return [target, scene_target]


def scene_beside(study: pathlib.Path) -> pathlib.Path:
    """Where the scene of a study is written."""
    return study.with_name(f"{study.stem}_scene.xml")


def find(root: xml.Element, path: str) -> xml.Element | None:
    """The list or entry of that path, None when it is not there. Names may have slashes in them."""
    for child in root:
        name = child.get("name", "")
        if name == path:
            return child
        if path.startswith(f"{name}/") and (found := find(child, path.removeprefix(f"{name}/"))) is not None:
            return found
    return None


def value_of(root: xml.Element, path: str) -> str | None:
    """The value of the entry of that path, None when it is not there."""
    found = find(root, path)
    return None if found is None else found.get("value")


def _read(path: pathlib.Path) -> xml.Element:
    if path.is_dir():
        raise ValueError(f"{path} is a folder.\n  Give the file of a scene or of a study.")
    parser = xml.XMLParser(target=xml.TreeBuilder(insert_comments=True))
    try:
        return xml.parse(path, parser).getroot()
    except xml.ParseError as error:
        raise ValueError(f"{path} is not XML: {error}") from error


def _listed(value: str | None) -> list[str]:
    words = (value or "").strip().removeprefix("{").removesuffix("}").split(",")
    return [word.strip() for word in words if word.strip()]


def _set(root: xml.Element, entry: Entry) -> None:
    within = {child.get("name", ""): child for child in root if entry.path.startswith(f"{child.get('name', '')}/")}
    if within:  # names may have slashes in them: the longest is meant
        name = max(within, key=len)
        return _set(within[name], replace(entry, path=entry.path.removeprefix(f"{name}/")))
    *lists, name = entry.path.split("/")
    element = root
    for each in lists:
        element = xml.SubElement(element, "ParameterList", name=each)
    old = find(element, name)
    if entry.value is None:
        if old is not None:
            element.remove(old)
        return
    if old is None:
        old = xml.Element("Parameter", name=name)
        element.insert(0, old)
    old.set("type", entry.kind)
    old.set("value", entry.value)


def _moved(file: str, source: pathlib.Path, home: pathlib.Path) -> str:
    """A path that counts from one folder, as it counts from another; links are followed, since ".." of one is not its own."""
    return file if os.path.isabs(file) else os.path.relpath(os.path.realpath(source / file), os.path.realpath(home))


def _moved_override(override: str, source: pathlib.Path, home: pathlib.Path) -> str:
    path, _, text = override.partition("=")
    return f"{path}={_moved(text.strip(), source, home)}" if _names_file(path) else override


def _names_file(path: str) -> bool:
    return path.strip().split("/")[-1] == "File"


def _naming(root: xml.Element) -> Iterator[tuple[xml.Element, list[str]]]:
    """The entries of an input that name files, each with these."""
    for one in root.iter("Parameter"):
        if one.get("name") == "File":
            yield one, [one.get("value", "")]
        elif one.get("name") == "Plugins":
            yield one, _listed(one.get("value"))


def _write(root: xml.Element, source: pathlib.Path, target: pathlib.Path, home: pathlib.Path, remark: str) -> None:
    for one, files in _naming(root):
        moved = ", ".join(_moved(file, source, home) for file in files)
        one.set("value", f"{{{moved}}}" if one.get("name") == "Plugins" else moved)
    xml.indent(root)
    text = xml.tostring(root, encoding="unicode")
    replace_file(target, f"<!-- {remark.replace('--', '- -')} -->\n{text}\n".encode())
