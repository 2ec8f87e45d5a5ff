"""Cards of a deck: keywords with parameters and the lines of data below them, includes followed."""
import codecs
import dataclasses
import os
import pathlib
import re

import numpy

from harmos.arrays import Array
from harmos.exchange.findings import Refused

LARGEST_ID = 2**31 - 1
"""Of nodes and elements: more than Abaqus and CalculiX take."""

LISTS = ("NODE", "ELEMENT", "NSET", "ELSET", "SURFACE", "AMPLITUDE", "EQUATION", "BOUNDARY", "CLOAD", "DLOAD", "DSLOAD")
"""Keywords whose lines may stand in a file of their own; INPUT of others names results."""

SWITCHES = ("ALLSDTOL", "CONSTANTRESULTANT", "CONTINUE", "CYCLICSYMMETRY", "DIRECT", "EXPLICIT", "FIXED", "FOLLOWER", "GENERATE", "INTERNAL",
            "LAGRANGE", "NLGEOM", "NONLINEAR", "NOROTATION", "NOTHICKNESS", "PERTURBATION", "ROUGH", "SMALLSLIDING", "STABILIZE", "TIED",
            "UNSORTED", "USER")
"""Parameters without a value, that may begin the second line of a keyword."""


@dataclasses.dataclass
class Card:
    """A keyword with what stands below it.

    Attributes:
        keyword: in capitals, without asterisk and blanks.
        parameters: values by name in capitals; those of switches are empty.
        file: that it stands in.
        line: of the keyword, counted from 1.
        data: lines below it, or in the file that its INPUT names, without comments and empty ones.
        first: lines of the data in the file, as many.
        data_file: that the data stand in; empty: that of the keyword.
    """
    keyword: str
    parameters: dict[str, str]
    file: str
    line: int
    data: list[str]
    first: list[int]
    data_file: str = ""

    @property
    def place(self) -> str:
        """FILE:LINE of the keyword."""
        return f"{self.file}:{self.line}"

    def place_of(self, row: int) -> str:
        """FILE:LINE of a line of data; of the keyword when there is none."""
        return f"{self.data_file or self.file}:{self.first[row]}" if row < len(self.first) else self.place

    def get(self, name: str) -> str:
        """The value of a parameter in capitals; empty when it is not given."""
        return self.parameters.get(name, "").upper()

    def rows(self) -> list[list[str]]:
        """The words of each line of data."""
        return [[_bare(word) for word in line.split(",")] for line in self.data]

    def number(self, word: str, row: int) -> float:
        """A number of a line of data; an empty word is 0.

        Raises:
            Refused: it is no finite number.
        """
        try:
            value = float(word.upper().replace("D", "E")) if word else 0.0
        except ValueError:
            value = float("nan")
        if not numpy.isfinite(value):
            raise Refused(f"{self.place_of(row)}: *{self.keyword}: \"{word}\" is no number.")
        return value

    def table(self, width: int, least: int = 1) -> Array:
        """All numbers, a row per line, 0 where a line is short.

        Raises:
            Refused: a word is no number, or a line has fewer than `least`.
        """
        if self.data and all(line.count(",") == width - 1 for line in self.data):
            flat = _numbers(",".join(self.data))
            if flat is not None and len(flat) == width * len(self.data):
                return flat.reshape(-1, width)
        result = numpy.zeros((len(self.data), width))
        for row, words in enumerate(self.rows()):
            given = [word for word in words[:width]]
            if len([word for word in given if word]) < least:
                raise Refused(f"{self.place_of(row)}: *{self.keyword}: {least} numbers are wanted in this line.")
            result[row, :len(given)] = [self.number(word, row) for word in given]
        return result

    def ids(self, numbers: Array) -> Array:
        """Numbers of nodes or elements as whole ones.

        Raises:
            Refused: one of them is none, or below 0, or larger than LARGEST_ID.
        """
        wrong = numpy.flatnonzero((numbers != numpy.floor(numbers)) | (numbers < 0) | (numbers > LARGEST_ID))
        if len(wrong):
            row = int(wrong[0]) if len(numbers) == len(self.data) else len(self.first)
            raise Refused(f"{self.place_of(row)}: *{self.keyword}: {numbers[wrong[0]]:.12g} is no number of a node or an element.")
        return numbers.astype(numpy.int64)

    def flat(self) -> Array:
        """All numbers of all lines in a row, lines that end in a comma continued.

        Raises:
            Refused: a word is no number.
        """
        flat = _numbers(",".join(line.rstrip().rstrip(",") for line in self.data))
        words = sum(line.rstrip().rstrip(",").count(",") + 1 for line in self.data)
        if flat is not None and len(flat) == words:
            return flat
        return numpy.array([self.number(word, row) for row, given in enumerate(self.rows()) for word in given if word])


def _numbers(text: str) -> "Array | None":
    """The numbers between commas, or nothing when some are none: numpy reads a million in a second."""
    try:
        result = numpy.array(text.split(","), dtype=numpy.float64)
    except ValueError:
        return None
    return result if numpy.isfinite(result).all() else None


def _bare(word: str) -> str:
    """A word without blanks and quotes around it."""
    return word.strip().strip("\"").strip()


def read_cards(path: str) -> list[Card]:
    """All cards of a deck and of the files that it includes.

    Raises:
        Refused: files are missing, or include themselves; data stand above the first keyword.
    """
    return _read(path, [], path, os.path.dirname(path))


def _lines(path: str, asked: str) -> list[str]:
    """Lines of a file of text, blanks before asterisks left out."""
    try:
        content = pathlib.Path(path).read_bytes()
    except OSError as error:
        raise Refused(f"{asked}: cannot read \"{path}\": {error.strerror}.") from None
    is_wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    if b"\0" in content[:100000] and not is_wide:
        raise Refused(f"{path}: this is no deck: it holds bytes that are no text.")
    try:
        text = content.decode("utf-16" if is_wide else "utf-8-sig")
    except UnicodeDecodeError:
        if is_wide:
            raise Refused(f"{path}: this is no deck: it begins as UTF-16, and does not go on so.") from None
        text = content.decode("latin-1")
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    return re.sub(r"^[ \t]+(?=\*)", "", text, flags=re.MULTILINE).split("\n")


def _found(name: str, folder: str, path: str) -> str:
    """A file that `path` names: as Abaqus and CalculiX look for it, seen from the folder of the deck, else from that of the file."""
    beside = os.path.join(folder, name)
    return beside if os.path.exists(beside) else os.path.join(os.path.dirname(path), name)


def _read(path: str, open_files: list[str], asked: str, folder: str) -> list[Card]:
    real = os.path.realpath(path)
    if real in open_files:
        raise Refused(f"{asked}: the file \"{path}\" includes itself, by way of "
                      f"{' and '.join(pathlib.Path(each).name for each in open_files)}.")
    lines = _lines(path, asked)
    starts = [number for number, line in enumerate(lines) if line[:1] == "*" and line[:2] != "**"]
    for number, line in enumerate(lines[:starts[0]] if starts else lines):
        if line.strip() and not line.startswith("**"):
            raise Refused(f"{path}:{number + 1}: this stands above the first keyword; a deck begins with one, such as "
                          "*HEADING or *NODE.")
    if not starts:
        raise Refused(f"{path}: this is no deck: no line begins with a keyword such as *NODE.")
    cards: list[Card] = []
    for start, end in zip(starts, [*starts[1:], len(lines)]):
        heading, below = lines[start].rstrip(), start + 1
        while heading.endswith(",") and below < end and _holds_parameters(lines[below]):
            heading += lines[below].strip()
            below += 1
        card = _card(path, start + 1, heading, lines, below, end)
        name = card.parameters.get("INPUT", "").strip("'")
        if card.keyword == "INCLUDE" and not name:
            raise Refused(f"{card.place}: *INCLUDE without INPUT=FILE.")
        other = _found(name, folder, path)
        if card.keyword == "INCLUDE":
            cards += _read(other, [*open_files, real], card.place, folder)
            continue
        if name and card.keyword in LISTS:
            _take_data(card, other)
        cards.append(card)
    return cards


def _holds_parameters(line: str) -> bool:
    """Whether a line below a keyword that ends in a comma goes on with it, as Abaqus has it: many such commas stand before data."""
    first = "".join(line.split(",")[0].split()).upper()
    return "=" in first or first in SWITCHES


def _take_data(card: Card, path: str) -> None:
    """The lines that stand in a file of their own, instead of below the keyword."""
    if card.data:
        raise Refused(f"{card.place}: *{card.keyword} has an INPUT file and lines of its own; put them on two cards.")
    lines = _lines(path, card.place)
    below = [number for number, line in enumerate(lines) if line[:1] == "*" and line[:2] != "**"]
    if below:
        raise Refused(f"{path}:{below[0] + 1}: a keyword, in a file of data that {card.place} names; take *INCLUDE for such files.")
    card.data, card.first = _data(lines, 0, len(lines))
    card.data_file = path


def _data(lines: list[str], below: int, end: int) -> tuple[list[str], list[int]]:
    """Lines without comments and empty ones, and their numbers."""
    first = [number + 1 for number in range(below, end)
             if lines[number][:2] != "**" and lines[number].strip()]
    return lines[below:end] if len(first) == end - below else [lines[number - 1] for number in first], first


def _card(path: str, line: int, heading: str, lines: list[str], below: int, end: int) -> Card:
    words = heading[1:].split(",")
    parameters = {}
    for word in words[1:]:
        name, _, value = word.partition("=")
        if name.strip():
            parameters["".join(name.split()).upper()] = _bare(value)
    return Card("".join(words[0].split()).upper(), parameters, path, line, *_data(lines, below, end))
