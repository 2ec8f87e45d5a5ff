"""What laws in Python return, checked."""
from typing import Any

import numpy

from harmos.arrays import Floats


def shaped(given: Any, shape: tuple[int, ...], what: str) -> Floats:
    """As an array of double precision.

    Raises:
        TypeError: it holds no real numbers; `what` names who gave it.
        ValueError: its shape is another one.
    """
    array = numpy.asarray(given)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{what} gives {type(given).__name__} of {array.dtype}, and must give real numbers")
    if array.shape != shape:
        raise ValueError(f"{what} gives an array of shape {array.shape}, and must give {shape}")
    return numpy.ascontiguousarray(array, dtype=float)
