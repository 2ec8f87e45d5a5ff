"""Puts the results of a trade in the place of those of an earlier one, all or none."""
import os
import pathlib
import signal
from collections.abc import Iterable

from harmos.trade.interruption import INTERRUPTIONS


def publish(made: pathlib.Path, folder: pathlib.Path, old: Iterable[pathlib.Path]) -> None:
    """Moves all files of one folder into another and removes old ones; interruptions are ignored meanwhile.

    Raises:
        OSError: a file cannot be moved.
    """
    handlers = {each: signal.signal(each, signal.SIG_IGN) for each in INTERRUPTIONS}
    try:
        for file in sorted(made.iterdir()):
            os.replace(file, folder / file.name)
        for file in old:
            file.unlink()
    finally:
        for each, handler in handlers.items():
            signal.signal(each, handler)
