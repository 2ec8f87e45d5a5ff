"""Packages that only some functions need."""
import importlib
from typing import Any


def demand_package(name: str) -> Any:
    """A package that Harmos can do without elsewhere, imported here.

    Raises:
        ImportError: it is not installed; says what to install.
    """
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name:
            raise  # something that it needs itself
        raise ImportError(f"{name} is not installed, which this needs: python3 -m pip install {name}, or the package "
                          f"python3-{name.lower()} of Debian", name=name) from None
