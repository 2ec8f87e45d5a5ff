"""Scenes and studies built or changed in code. What they may hold is what `harmos doc` says; harmos.check() and every
run validate them, with the messages of the program.

    scene = harmos.Scene("two_blocks", {
        "Mesh": {"Type": "Exodus", "File": "blocks.e"},
        "Materials": {"steel": {"Type": "Isotropic", "Young's Modulus": 210e3, "Poisson's Ratio": 0.3}},
        "Parts": {"lower": {"Material": "steel"}, "upper": {"Material": "steel"}},
        ...})
    scene["Materials/steel/Young's Modulus"] = 200e3
    other = harmos.read_scene("xml/bolted_joint.xml")
    other["Values/mu"], "Solver/Accuracy" in other
"""
import os
import pathlib
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Union

from harmos.exchange.scene import Entry, SceneList, number_text

Value = Union[str, bool, int, float, "os.PathLike[str]", Sequence[float], Sequence[str], Sequence["os.PathLike[str]"]]
"""What an entry may hold; "$name" refers to a number of the list Values. Numbers and arrays may be those of numpy."""
Lists = Mapping[str, Any]
"""Entries and lists by name, in their order; a list is a mapping again."""
FILES = ("File", "Scene", "Plugins")
"""How the names of entries end that name files."""
TYPES: dict[str, Callable[[str], Any]] = {"bool": lambda text: text.strip() == "true", "int": int, "double": lambda text: _number(text), "string": str,
         "Array(double)": lambda text: [_number(each) for each in _items(text)],
         "Array(int)": lambda text: [int(each) for each in _items(text)],
         "Array(string)": lambda text: _items(text)}
"""How the text of an entry is read, by the type that XML gives it."""


class Input:
    """A list of entries and lists, as a scene or a study is one, addressed by paths: input["Solver/Accuracy"].

    A path names lists and at last an entry or a list, with "/" between them; a list is returned as nested
    dictionaries, a copy.

    Attributes:
        name: of the file that is written, without folder and ending; results are named after it.
        folder: in which files that the input names are looked for.
        title: of the outermost list.
    """

    title = "Harmos"

    def __init__(self, name: str, content: Lists | None = None, folder: str | os.PathLike[str] = ".") -> None:
        """`content`: entries and lists, copied. Nothing is checked before harmos.check() or a run.

        Raises:
            ValueError: the name is empty or has a "/", and is none of a file therefore.
        """
        if not name or "/" in name or "\0" in name:
            raise ValueError(f"the name of a scene or a study is that of its file, without folder: not {name!r}")
        self.name = name
        self.folder = pathlib.Path(folder)
        self._lists: dict[str, Any] = _copy(content or {})

    def __getitem__(self, path: str) -> Any:
        """The value of an entry, or a copy of a list.

        Raises:
            KeyError: there is none of this path.
        """
        here: Any = self._lists
        for name in path.split("/"):
            if not isinstance(here, dict) or name not in here:
                raise KeyError(path)
            here = here[name]
        return _copy(here) if isinstance(here, dict) else here

    def __setitem__(self, path: str, value: "Value | Lists") -> None:
        """Sets an entry or a whole list; lists on the way there are made."""
        *lists, name = path.split("/")
        here = self._lists
        for each in lists:
            here = here.setdefault(each, {})
            if not isinstance(here, dict):
                raise KeyError(f"{path}: {each} is an entry, not a list")
        here[name] = _copy(value) if isinstance(value, Mapping) else value

    def __delitem__(self, path: str) -> None:
        """Removes an entry or a list.

        Raises:
            KeyError: there is none of this path.
        """
        *lists, name = path.split("/")
        here: Any = self._lists
        for each in lists:
            here = here[each]
        del here[name]

    def __contains__(self, path: str) -> bool:
        """Whether there is an entry or a list of this path."""
        try:
            self[path]
        except KeyError:
            return False
        return True

    def __iter__(self) -> Iterator[str]:
        """Names of the outermost entries and lists."""
        return iter(self._lists)

    def xml(self) -> str:
        """As the program reads it.

        Raises:
            TypeError: an entry holds what no entry may, such as None; the message names it.
        """
        return _as_list(self.title, self._lists).text() + "\n"

    def write(self, path: str | os.PathLike[str] | None = None) -> pathlib.Path:
        """Writes the file, NAME.xml in the folder where `path` is not given; returns its path. Elsewhere than in the
        folder, files that the input names and that are there are named by absolute paths."""
        target = pathlib.Path(path) if path is not None else self.folder / f"{self.name}.xml"
        moves = target.parent.absolute() != self.folder.absolute()
        lists = self._with_absolute_files(self._lists) if moves else self._lists
        target.write_text(_as_list(self.title, lists).text() + "\n", encoding="utf-8")
        return target

    def _with_absolute_files(self, lists: Lists) -> dict[str, Any]:
        result: dict[str, Any] = {}
        for name, value in lists.items():
            if isinstance(value, Mapping):
                result[name] = self._with_absolute_files(value)
            elif name.endswith(FILES) and isinstance(value, (list, tuple)):
                result[name] = [self._absolute(each) for each in value]
            else:
                result[name] = self._absolute(value) if name.endswith(FILES) else value
        return result

    def _absolute(self, value: Any) -> Any:
        is_here = isinstance(value, (str, os.PathLike)) and (self.folder / value).is_file()
        return str((self.folder / value).absolute()) if is_here else value


class Scene(Input):
    """The input of one computation; see Input."""


class StudyInput(Input):
    """The input of a study of a scene, whose file its entry Scene names; see Input.

    Attributes:
        title: of the outermost list.
    """

    title = "Harmos Study"


def read_scene(path: str | os.PathLike[str]) -> Scene:
    """A scene in a file, to be changed; comments are lost.

    Raises:
        OSError: it cannot be read.
        ValueError: it is not well-formed, or holds what no parameter list may.
    """
    return Scene(pathlib.Path(path).stem, _read(path), pathlib.Path(path).parent)


def read_study_input(path: str | os.PathLike[str]) -> StudyInput:
    """The same of a study."""
    return StudyInput(pathlib.Path(path).stem, _read(path), pathlib.Path(path).parent)


def value_text(value: Value) -> str:
    """As XML and the option --set have it: true, 0.2, {1, 2.5}.

    Raises:
        TypeError: it is nothing that an entry may hold.
    """
    plain = _plain(value)
    if isinstance(plain, bool):
        return "true" if plain else "false"
    if isinstance(plain, str):
        return plain
    if isinstance(plain, (int, float)):
        return number_text(plain)
    items = [each if isinstance(each, str) else number_text(each) for each in plain]
    return "{" + ", ".join(items) + "}"


def _copy(lists: Lists) -> dict[str, Any]:
    return {name: _copy(value) if isinstance(value, Mapping) else value for name, value in lists.items()}


def _as_list(name: str, lists: Lists, path: str = "") -> SceneList:
    result = SceneList(name)
    for each, value in lists.items():
        if isinstance(value, Mapping):
            result.items.append(_as_list(each, value, f"{path}{each}/"))
            continue
        try:
            result.items.append(Entry(each, _plain(value)))
        except TypeError as error:
            raise TypeError(f"{path}{each}: {error}") from None
    return result


def _plain(value: Any) -> Any:
    """Numbers and arrays of numpy as those of Python, paths as text.

    Raises:
        TypeError: it is nothing that an entry may hold.
    """
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        items = [_plain(each) for each in value]
        if all(isinstance(each, str) for each in items):
            return items
        if all(isinstance(each, (int, float)) and not isinstance(each, bool) for each in items):
            return items
    raise TypeError(f"{value!r} is neither text nor a number, nor a list of either")


def _read(path: str | os.PathLike[str]) -> dict[str, Any]:
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise ValueError(f"{path}: {error}") from None
    return _lists_of(root, str(path))


def _lists_of(node: ElementTree.Element, path: str) -> dict[str, Any]:
    result: dict[str, Any] = {}
    for child in node:
        name = child.get("name", "")
        if child.tag == "ParameterList":
            result[name] = _lists_of(child, path)
            continue
        kind, text = child.get("type", ""), child.get("value", "")
        if child.tag != "Parameter" or kind not in TYPES:
            raise ValueError(f"{path}: <{child.tag}> \"{name}\" of type \"{kind}\" is no entry of a parameter list")
        result[name] = text if text.strip().startswith("$") else _value(kind, text, f"{path}: {name}")
    return result


def _value(kind: str, text: str, where: str) -> Value:
    try:
        value: Value = TYPES[kind](text)
        return value
    except ValueError:
        raise ValueError(f"{where}: \"{text}\" is no {kind}") from None


def _number(text: str) -> float:
    return float(text)


def _items(text: str) -> list[str]:
    inside = text.strip().removeprefix("{").removesuffix("}").strip()
    return [each.strip() for each in inside.split(",")] if inside else []
