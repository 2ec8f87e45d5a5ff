"""What an import tells: what it found, what a person has to decide, what it left out; and how it refuses."""
import dataclasses


class Refused(ValueError):
    """The file cannot be imported; the text says where, why, and what to do."""


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
