"""Interruptions that wait until something is complete."""
import contextlib
import signal
from collections.abc import Iterator

INTERRUPTIONS = (signal.SIGINT, signal.SIGTERM)
"""That end a trade."""


@contextlib.contextmanager
def held_interruptions() -> Iterator[None]:
    """Has them come at the end.

    What a handler raises while a process is forked may be dropped: then nothing would end the trade any more.
    """
    held: list[int] = []
    handlers = {each: signal.signal(each, lambda number, _: held.append(number)) for each in INTERRUPTIONS}
    try:
        yield
    finally:
        for each, handler in handlers.items():
            signal.signal(each, handler)
        for number in held[:1]:
            signal.raise_signal(number)
