"""What measuring may use: time and memory."""
import re
import time
from dataclasses import dataclass


@dataclass
class Budget:
    """What measuring may use.

    Attributes:
        seconds: of wall time, from now on.
        memory: resident, of one run [byte].
    """

    seconds: float
    memory: float

    def __post_init__(self) -> None:
        """Starts the clock."""
        self._begin = time.monotonic()

    def left(self) -> float:
        """Seconds that are left."""
        return self.seconds - self.spent()

    def spent(self) -> float:
        """Seconds that are gone."""
        return time.monotonic() - self._begin


def free_memory() -> float:
    """What the machine can give without swapping [byte]: files that it has read and keeps count as free."""
    with open("/proc/meminfo") as file:
        found = re.search(r"^MemAvailable:\s*(\d+) kB", file.read(), re.M)
    return 1024.0 * float(found.group(1)) if found else float("inf")
