"""How files are written: never over what is read, and never in part."""
import os


def demand_distinct(read: str | os.PathLike[str], written: str | os.PathLike[str]) -> None:
    """Refuses to write a file that is read, by whatever name or link.

    Raises:
        ValueError: they are one file.
    """
    if os.path.exists(read) and os.path.exists(written) and os.path.samefile(read, written):
        raise ValueError(f"the result {written} would replace the input {read}.\n"
                         "  Write under another name. Nothing was written.")


def replace_file(path: str | os.PathLike[str], content: bytes) -> None:
    """Writes a file in one step: until it is complete, an older one stays."""
    partial = f"{os.fspath(path)}.partial.{os.getpid()}"
    try:
        with open(partial, "wb") as file:
            file.write(content)
        os.replace(partial, path)
    finally:
        if os.path.exists(partial):
            os.remove(partial)
