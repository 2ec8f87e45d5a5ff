"""The folder in which a trade runs, hidden in its results."""
import contextlib
import fcntl
import pathlib
import shutil
import tempfile
import time
from collections.abc import Iterator

_PREFIX, _OWNER = ".trade_", "owner.lock"
_YOUNG = 60.0
"""Seconds for which a folder without an owner may be one that is being made."""


@contextlib.contextmanager
def workspace(results: pathlib.Path) -> Iterator[pathlib.Path]:
    """A new folder in `results`, removed at the end; those of trades that were killed are removed at the beginning.

    Raises:
        OSError: it cannot be made.
    """
    for left in results.glob(_PREFIX + "*"):
        _remove_unless_owned(left)
    with tempfile.TemporaryDirectory(prefix=_PREFIX, dir=results) as work:
        with open(pathlib.Path(work) / _OWNER, "wb") as owner:
            fcntl.flock(owner, fcntl.LOCK_EX)  # ends with the process, however that ends
            yield pathlib.Path(work).resolve()


def _remove_unless_owned(folder: pathlib.Path) -> None:
    try:
        with open(folder / _OWNER, "rb") as owner:
            fcntl.flock(owner, fcntl.LOCK_EX | fcntl.LOCK_NB)
            shutil.rmtree(folder, ignore_errors=True)
    except FileNotFoundError:
        if folder.is_dir() and time.time() - folder.stat().st_mtime > _YOUNG:
            shutil.rmtree(folder, ignore_errors=True)
    except OSError:
        return  # another trade runs there
