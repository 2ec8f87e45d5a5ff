"""Reads files that may be damaged in a child process: HDF5 crashes or hangs on some, and only the child is lost."""
import os
import pickle
import resource
import signal
from collections.abc import Callable
from typing import TypeVar

Content = TypeVar("Content")
"""What is read."""

SECONDS, SECONDS_PER_BYTE = 30, 1e-6
"""Processor time that reading may take, whatever the size of the file, and with it."""

INTERRUPTIONS = (signal.SIGTERM, signal.SIGINT)
"""Of these the child ends without a word."""

BYTES, BYTES_PER_BYTE = 1e9, 100.0
"""Memory that reading may take beyond what the process has, in the same way."""


def read_foreign(path: str | os.PathLike[str], read: Callable[[], Content], effort: float = 1.0) -> Content:
    """What `read` returns, which must be fit for pickling; `path` is the file that it reads. `effort` multiplies the time
    and memory that it may take.

    Raises:
        OSError: as `read` does.
        ValueError: `read` raises anything else or never ends, or the child dies.
    """
    size = os.stat(path).st_size
    seconds, memory = int(effort * (SECONDS + SECONDS_PER_BYTE * size)), int(effort * (BYTES + BYTES_PER_BYTE * size))
    receiver, sender = os.pipe()
    # What a handler raises while Python calls what modules have registered for forks would be ignored.
    before = signal.pthread_sigmask(signal.SIG_BLOCK, INTERRUPTIONS)
    child = os.fork()
    if child == 0:
        os.close(receiver)
        _read_in_child(sender, path, seconds, memory, read)
    os.close(sender)
    with os.fdopen(receiver, "rb") as pipe:
        try:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
            answer = pipe.read()
        except BaseException:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            raise
    status = os.waitpid(child, 0)[1]
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        cause = "reading it does not end" if number == signal.SIGXCPU else f"reading it fails, {signal.strsignal(number)}"
        raise ValueError(f"{path} is damaged: {cause}")
    if not answer:
        raise ValueError(f"{path} is damaged: reading it ends the process")
    content = pickle.loads(answer)
    if isinstance(content, Exception):
        raise content
    return content  # type: ignore[no-any-return]


def _read_in_child(sender: int, path: str | os.PathLike[str], seconds: int, memory: int,
                   read: Callable[[], Content]) -> None:
    """Never returns."""
    status = 1
    try:
        for number in (signal.SIGSEGV, signal.SIGBUS, signal.SIGABRT, signal.SIGFPE, signal.SIGXCPU, *INTERRUPTIONS):
            signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, INTERRUPTIONS)
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, resource.getrlimit(resource.RLIMIT_CPU)[1]))
        with open("/proc/self/statm", encoding="ascii") as own:
            taken = int(own.read().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (taken + memory, resource.getrlimit(resource.RLIMIT_AS)[1]))
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.dup2(nowhere, 2)
        with os.fdopen(sender, "wb") as pipe:
            pipe.write(_content_or_error(path, read))
        status = 0
    finally:
        os._exit(status)


def _content_or_error(path: str | os.PathLike[str], read: Callable[[], Content]) -> bytes:
    try:
        return pickle.dumps(read())
    except Exception as error:  # whatever a damaged file makes of the reader
        named = isinstance(error, (OSError, ValueError)) and str(path) in str(error)
        return pickle.dumps(error if named else ValueError(f"{path} is damaged: {type(error).__name__}: {error}"))
