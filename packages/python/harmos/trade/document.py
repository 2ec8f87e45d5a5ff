"""The XML of a scene or a study, read so that settings can be changed in it and the whole written again."""
import copy
import os
import pathlib
import xml.etree.ElementTree as xml
from collections.abc import Iterable
from dataclasses import dataclass

from harmos.outputs import replace_file


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
        self._overrides = _listed(value_of(self.study, "Scene Overrides")) if self.study is not None else []

    def value(self, path: str, otherwise: str) -> str:
        """The entry of the scene, as the study's overrides leave it; `otherwise` when there is none."""
        for override in self._overrides:
            name, _, text = override.partition("=")
            if name.strip() == path:
                return text.strip()
        value = value_of(self.scene, path)
        return otherwise if value is None else value

    def names(self, path: str) -> list[str]:
        """Names of the lists in a list of the scene, in their order."""
        found = find(self.scene, path)
        return [] if found is None else [one.get("name", "") for one in found if one.tag == "ParameterList"]

    def write(self, entries: Iterable[Entry], target: pathlib.Path, remark: str) -> list[pathlib.Path]:
        """Writes it with changes; entries that begin with "Study/" are the study's. The scene of a study is written beside.

        Args:
            entries: what changes.
            target: file of the scene, or of the study.
            remark: a comment at the head of it.

        Returns:
            The files, `target` first.
        """
        changes = list(entries)
        scene = copy.deepcopy(self.scene)
        for entry in changes:
            if not entry.path.startswith("Study/"):
                _set(scene, entry)
        if self.study is None:
            _write(scene, self.path.parent, target, remark)
            return [target]
        study = copy.deepcopy(self.study)
        for entry in changes:
            if entry.path.startswith("Study/"):
                _set(study, Entry(entry.path.removeprefix("Study/"), entry.kind, entry.value))
        changed = {entry.path for entry in changes}
        kept = [one for one in self._overrides if one.partition("=")[0].strip() not in changed]
        _set(study, Entry("Scene Overrides", "Array(string)", "{" + ", ".join(kept) + "}" if kept else None))
        scene_target = target.with_name(f"{target.stem}_scene.xml")
        _set(study, Entry("Scene", "string", scene_target.name))
        _write(scene, self.scene_path.parent, scene_target, remark)
        _write(study, self.path.parent, target, remark)
        return [target, scene_target]


def find(root: xml.Element, path: str) -> xml.Element | None:
    """The list or entry of that path, None when it is not there."""
    element: xml.Element | None = root
    for name in path.split("/"):
        if element is None:
            return None
        element = next((child for child in element if child.get("name") == name), None)
    return element


def value_of(root: xml.Element, path: str) -> str | None:
    """The value of the entry of that path, None when it is not there."""
    found = find(root, path)
    return None if found is None else found.get("value")


def _read(path: pathlib.Path) -> xml.Element:
    parser = xml.XMLParser(target=xml.TreeBuilder(insert_comments=True))
    try:
        return xml.parse(path, parser).getroot()
    except xml.ParseError as error:
        raise ValueError(f"{path} is not XML: {error}") from error


def _listed(value: str | None) -> list[str]:
    words = (value or "").strip().removeprefix("{").removesuffix("}").split(",")
    return [word.strip() for word in words if word.strip()]


def _set(root: xml.Element, entry: Entry) -> None:
    *lists, name = entry.path.split("/")
    element = root
    for each in lists:
        below = find(element, each)
        if below is None:
            below = xml.SubElement(element, "ParameterList", name=each)
        element = below
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


def _write(root: xml.Element, source: pathlib.Path, target: pathlib.Path, remark: str) -> None:
    def moved(file: str) -> str:
        return file if os.path.isabs(file) else os.path.relpath(source / file, target.parent)

    for one in root.iter("Parameter"):
        value = one.get("value", "")
        if one.get("name") == "File":
            one.set("value", moved(value))
        elif one.get("name") == "Plugins":
            one.set("value", "{" + ", ".join(moved(file) for file in _listed(value)) + "}")
    xml.indent(root)
    text = xml.tostring(root, encoding="unicode")
    replace_file(target, f"<!-- {remark.replace('--', '- -')} -->\n{text}\n".encode())
