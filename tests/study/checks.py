"""Checks of tests that go on after a failure."""
import sys

_failures: list[str] = []


def check(holds, what):
    """Takes note of what does not hold."""
    if not holds:
        print("FAILED:", what)
        _failures.append(what)


def finish():
    """Ends the test: with exit code 1 when a check has failed."""
    if not _failures:
        print("all as promised")
    sys.exit(1 if _failures else 0)
