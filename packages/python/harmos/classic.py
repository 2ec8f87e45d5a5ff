"""How long a classic netCDF file must be: the libraries read the missing end of a truncated one as zeros, silently.

Source: NetCDF Classic Format Specification (Unidata); packages/files/CompleteSize.cpp has the same for meshes.
"""
import os
from typing import BinaryIO

_BYTES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8, 7: 1, 8: 2, 9: 4, 10: 8, 11: 8}
"""Of a value, by the number of its type."""


class _Header:
    """Reads the header from after its first three bytes."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._version = self._number(1)

    def _number(self, width: int) -> int:
        word = self._file.read(width)
        if len(word) < width:
            raise ValueError("its header is cut off")
        return int.from_bytes(word, "big")

    def _count(self) -> int:
        return self._number(8 if self._version == 5 else 4)

    def _skip(self, size: int) -> None:
        self._file.seek((size + 3) // 4 * 4, os.SEEK_CUR)

    def _list(self) -> range:
        self._number(4)  # the kind of list
        return range(self._count())

    def _skip_attributes(self) -> None:
        for _ in self._list():
            self._skip(self._count())
            kind = self._number(4)
            self._skip(_BYTES.get(kind, 0) * self._count())

    def end(self) -> int:
        """The least size of the file; of the last time step without what aligns its end."""
        steps = self._count()
        lengths = []
        for _ in self._list():
            self._skip(self._count())
            lengths.append(self._count())
        self._skip_attributes()
        end, record = 0, 0
        first: int | None = None
        for _ in self._list():
            self._skip(self._count())
            dimensions = [self._count() for _ in range(self._count())]
            self._skip_attributes()
            size = _BYTES.get(self._number(4), 0)
            self._count()  # the size of all, wrong where it does not fit
            begin = self._number(4 if self._version == 1 else 8)
            of = [lengths[each] if each < len(lengths) else 0 for each in dimensions]
            is_record = bool(of) and of[0] == 0
            for length in of[is_record:]:
                size *= length
            if is_record:
                first = begin if first is None else min(first, begin)
                record += (size + 3) // 4 * 4
            else:
                end = max(end, begin + size)
        streaming = 2 ** (64 if self._version == 5 else 32) - 1
        if first is None or steps in (0, streaming):
            return end
        return max(end, first + steps * record - 3)


def demand_complete(path: str | os.PathLike[str]) -> None:
    """Looks at classic files only; those of HDF5 know their size themselves.

    Raises:
        OSError: the file cannot be read.
        ValueError: it is shorter than its own header says.
    """
    with open(path, "rb") as file:
        if file.read(3) != b"CDF":
            return
        try:
            least = _Header(file).end()
        except ValueError as error:
            raise ValueError(f"{os.fspath(path)} is damaged: {error}") from error
    size = os.stat(path).st_size
    if size < least:
        raise ValueError(f"{os.fspath(path)} is cut off: it has {size} of {least} bytes")
