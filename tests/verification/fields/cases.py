"""Runs the cases of a test, each in a folder of its own."""
import argparse
import pathlib
import tempfile
from collections.abc import Callable
from typing import Any


def run_cases(cases: type, make: Callable[[str, pathlib.Path], Any]) -> int:
    """Runs the cases whose name contains what `--only` says, all without; the exit code: 0 where all hold.

    Args:
        cases: a class whose public methods are the cases; each yields (what, found, largest that is allowed), or raises
            RuntimeError where a run ends otherwise.
        make: of the program's path (`--harmos`) and an empty folder, an object of that class.
    """
    parser = argparse.ArgumentParser()
    parser.add_argument("--harmos", type=pathlib.Path, required=True)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    names = [name for name in vars(cases) if not name.startswith("_") and arguments.only in name]
    failures = int(not names)
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            case = getattr(make(str(arguments.harmos.resolve()), pathlib.Path(folder)), name)
            try:
                for what, found, limit in case():
                    failures += int(not found <= limit)
                    print(f"{'ok  ' if found <= limit else 'FAIL'} {name}: {what} {found:.2g}")
            except RuntimeError as error:
                failures += 1
                print(f"FAIL {name}: {error}")
    return min(failures, 1)
