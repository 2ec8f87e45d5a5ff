"""Structured arrays as tables of pandas; pandas is imported when one is made."""
from typing import Any

from harmos.arrays import Records
from harmos.optional import demand_package


def frame_of(records: Records, index: str) -> Any:
    """A DataFrame with the columns of a structured array, one of which becomes its index.

    Raises:
        ImportError: pandas is not installed.
    """
    pandas = demand_package("pandas")
    return pandas.DataFrame({name: records[name] for name in records.dtype.names or ()}).set_index(index)
