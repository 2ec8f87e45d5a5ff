"""What goes wrong when the program `harmos` runs, as exceptions with its exit code and its messages."""
import re
from typing import Any


class NotFound(FileNotFoundError):
    """The program, or what starts several ranks of it, is not where it was looked for."""


class HarmosError(Exception):
    """The program ended with another exit code than 0.

    Attributes:
        exit_code: of the program, as docs/guide/exit-codes.md has them; negative: ended by that signal.
        messages: its errors, one by one, each with place, cause and remedy.
        result: of a run that has written something: harmos.result.Result, else None.
        study: of a study that has written something: harmos.Study, else None.
    """

    def __init__(self, exit_code: int, messages: list[str], written: Any = None) -> None:
        """`written`: a Result or a Study, or None."""
        super().__init__("\n".join(messages) or f"harmos ended with exit code {exit_code} and said nothing")
        self.exit_code = exit_code
        self.messages = messages
        is_study = type(written).__name__ == "Study"
        self.result: Any = None if is_study else written
        self.study: Any = written if is_study else None


class InputError(HarmosError):
    """A scene, a study or a command is wrong (exit code 2): nothing was run or written."""


class NotConverged(HarmosError):
    """The accuracy that was asked for was not reached (exit code 3)."""


class NoEquilibrium(HarmosError):
    """No equilibrium exists under the loads, or no path leads to it (exit code 4)."""


class Interrupted(HarmosError):
    """It was asked to stop (exit code 130); what was complete is written."""


KINDS = {2: InputError, 3: NotConverged, 4: NoEquilibrium, 130: Interrupted}
"""Exceptions by exit code; HarmosError for all others."""


def error_for(exit_code: int, text: str, written: Any = None) -> HarmosError:
    """The exception of an exit code, with the messages that `text` holds: each begins a line and is continued by
    indented ones."""
    messages = [part.strip() for part in re.split(r"\n(?=\S)", text.strip()) if part.strip()]
    if len(messages) > 1 and re.match(r"\d+ errors?; ", messages[-1]):
        del messages[-1]  # how many there are
    return KINDS.get(exit_code, HarmosError)(exit_code, messages, written)
