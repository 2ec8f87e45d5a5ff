"""How files are written: never over what is read, and never in part."""
import contextlib
import os
from collections.abc import Iterator


def demand_distinct(read: str | os.PathLike[str], written: str | os.PathLike[str]) -> None:
    """Refuses to write a file that is read, by whatever name or link.

    Raises:
        ValueError: they are one file.
    """
    if os.path.exists(read) and os.path.exists(written) and os.path.samefile(read, written):
        raise ValueError(f"the result {written} would replace the input {read}.\n"
                         "  Write into another folder or under another name (--output).")


def demand_no_folder(path: str | os.PathLike[str]) -> None:
    """Refuses to write a file where a folder is.

    Raises:
        ValueError: there is one.
    """
    if os.path.isdir(path):
        raise ValueError(f"the result {path} cannot be written: it is a folder.\n"
                         "  Write into another folder or under another name (--output).")


@contextlib.contextmanager
def writing(path: str | os.PathLike[str]) -> Iterator[None]:
    """Says of a failure inside of it which result it is about.

    Raises:
        OSError: it cannot be written.
    """
    try:
        yield
    except OSError as error:
        raise OSError(f"cannot write {os.fspath(path)}: {error.strerror or error}.\n"
                      "  Make room, or write into another folder (--output).") from error


def replace_file(path: str | os.PathLike[str], content: bytes) -> None:
    """Writes a file in one step, and makes its folder: until it is complete, an older one stays.

    Raises:
        OSError: it cannot be written.
    """
    partial = f"{os.fspath(path)}.partial.{os.getpid()}"
    try:
        with writing(path):
            os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
            with open(partial, "wb") as file:
                file.write(content)
            os.replace(partial, path)
    finally:
        if os.path.exists(partial):
            os.remove(partial)
