"""What an import tells: what it found, what a person has to decide, what it left out; and how it refuses."""
import contextlib
import dataclasses
import difflib
from collections.abc import Iterable, Iterator


class Refused(ValueError):
    """The file cannot be imported; the text says where, why, and what to do."""


class Refusals:
    """Collects what is wrong, so that all of it is told at once."""

    def __init__(self) -> None:
        """None yet."""
        self._texts: list[str] = []

    @contextlib.contextmanager
    def collect(self) -> Iterator[None]:
        """Takes note of a refusal inside of it, and goes on behind."""
        try:
            yield
        except Refused as error:
            if str(error) not in self._texts:
                self._texts.append(str(error))

    def raise_if_any(self) -> None:
        """Refuses with all of them.

        Raises:
            Refused: there are some.
        """
        if self._texts:
            raise Refused("\n".join(self._texts))


def names_there(wanted: str, known: Iterable[str]) -> str:
    """What to tell about a name that is not there: the nearest one, and which there are."""
    there = sorted(known)
    near = difflib.get_close_matches(wanted.upper(), [name.upper() for name in there], 1, 0.7)
    nearest = next((name for name in there if near and name.upper() == near[0]), "")
    listed = ", ".join(there[:12]) + (f" and {len(there) - 12} more" if len(there) > 12 else "")
    return (f"Did you mean \"{nearest}\"? " if nearest else "") + f"There are: {listed or 'none'}."


@dataclasses.dataclass(frozen=True)
class LeftOut:
    """Something in a file that Harmos has not.

    Attributes:
        place: FILE:LINE.
        keyword: as the file calls it.
        effect: what it would change.
    """
    place: str
    keyword: str
    effect: str

    def __str__(self) -> str:
        return f"{self.place}: {self.keyword}: {self.effect}"


@dataclasses.dataclass
class Findings:
    """What an import tells.

    Attributes:
        found: what the file holds and what was made of it.
        undecided: what the starting scene assumes and a person must decide.
        left_out: what Harmos has not, in the order of the file.
    """
    found: list[str] = dataclasses.field(default_factory=list)
    undecided: list[str] = dataclasses.field(default_factory=list)
    left_out: list[LeftOut] = dataclasses.field(default_factory=list)

    def leave_out(self, place: str, keyword: str, effect: str) -> None:
        """Adds an entry to left_out, once."""
        entry = LeftOut(place, keyword, effect)
        if entry not in self.left_out:
            self.left_out.append(entry)

    def text(self) -> list[str]:
        """Lines for a terminal or a comment; empty lists say nothing."""
        lines = [f"found: {each}" for each in self.found]
        lines += [f"to decide: {each}" for each in self.undecided]
        lines += [f"left out: {each}" for each in self.left_out]
        return lines
