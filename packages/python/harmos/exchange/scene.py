"""Scenes of Harmos as text: lists, entries and comments."""
import dataclasses
from collections.abc import Sequence
from typing import Union
from xml.sax.saxutils import quoteattr

Value = Union[str, bool, int, float, Sequence[float], Sequence[str]]
"""What an entry may hold; "$name" refers to a number of the list Values."""


@dataclasses.dataclass
class Comment:
    """Words for the reader.

    Attributes:
        lines: of it.
    """
    lines: list[str]


@dataclasses.dataclass
class Entry:
    """A parameter.

    Attributes:
        name: of it.
        value: of it.
    """
    name: str
    value: Value


@dataclasses.dataclass
class SceneList:
    """A list of parameters, lists and comments.

    Attributes:
        name: of it.
        items: in their order.
    """
    name: str
    items: list["Comment | Entry | SceneList"] = dataclasses.field(default_factory=list)

    def set(self, name: str, value: Value) -> "SceneList":
        """Adds an entry; returns itself."""
        self.items.append(Entry(name, value))
        return self

    def comment(self, *lines: str) -> "SceneList":
        """Adds a comment; returns itself."""
        self.items.append(Comment(list(lines)))
        return self

    def child(self, name: str) -> "SceneList":
        """The list of this name in it, which is made when there is none."""
        for item in self.items:
            if isinstance(item, SceneList) and item.name == name:
                return item
        self.items.append(SceneList(name))
        added = self.items[-1]
        assert isinstance(added, SceneList)
        return added

    def names(self) -> list[str]:
        """Of the lists in it."""
        return [item.name for item in self.items if isinstance(item, SceneList)]

    def text(self, indent: str = "") -> str:
        """As XML; lists of the scene that hold nothing are left out."""
        inner = indent + "  "
        if not self.items:
            return f"{indent}<ParameterList name={quoteattr(self.name)}/>"
        lines = [f"{indent}<ParameterList name={quoteattr(self.name)}>"]
        for item in self.items:
            if isinstance(item, SceneList):
                if item.items or indent:
                    lines.append(item.text(inner))
            elif isinstance(item, Entry):
                kind, value = _typed(item.value)
                lines.append(f"{inner}<Parameter name={quoteattr(item.name)} type=\"{kind}\" value={quoteattr(value)}/>")
            elif item.lines:
                words = [line.replace("--", "- -").rstrip("-") for line in item.lines]
                body = f"\n{inner}     ".join(words)
                lines.append(f"{inner}<!-- {body} -->")
        return "\n".join(lines + [f"{indent}</ParameterList>"])


def number_text(value: float) -> str:
    """The shortest numeral that reads back as the same number, whole ones without a point."""
    return repr(int(value)) if float(value).is_integer() and abs(value) < 1e15 else repr(float(value))


def _typed(value: Value) -> tuple[str, str]:
    if isinstance(value, bool):
        return "bool", "true" if value else "false"
    if isinstance(value, str):
        return ("double" if value.startswith("$") else "string"), value
    if isinstance(value, int):
        return "int", str(value)
    if isinstance(value, float):
        return "double", number_text(value)
    if all(isinstance(each, str) for each in value):
        return "Array(string)", "{" + ", ".join(str(each) for each in value) + "}"
    return "Array(double)", "{" + ", ".join(number_text(float(each)) for each in value) + "}"
