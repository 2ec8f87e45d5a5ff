"""What the arrays of this package hold, for annotations."""
from typing import Any

import numpy
from numpy.typing import NDArray

Floats = NDArray[numpy.float64]
"""Numbers in double precision; NaN: not known."""
Integers = NDArray[numpy.integer[Any]]
"""Ids and counts."""
Mask = NDArray[numpy.bool_]
"""Which rows are meant."""
Texts = NDArray[numpy.str_]
"""Words such as the status of configurations."""
Records = NDArray[numpy.void]
"""Rows with named columns, a structured array."""
Array = NDArray[Any]
"""Numbers of a kind that the words say."""
