"""What measuring may use: time and memory."""
import re
import time
from dataclasses import dataclass

PATIENCE = 5.0
"""What a run may take over its predicted time.

Predictions have been right within a factor of 3, and a factor too small would end the very run that the reference waits
for; one that has taken five times as long mostly does not converge, and what it takes is lost to all others.
"""
LEAST = 0.02
"""Share of the budget that any run may take: short ones hold the start of the program, which nothing predicts."""
FIRST = 0.12
"""Share of the budget that a run may take for which nothing predicts a time.

It is on the coarsest mesh. The next one takes at least four times as long, and without that there is no reference.
"""


@dataclass(frozen=True)
class Allowance:
    """The time that one run may take.

    Attributes:
        seconds: of wall time.
        predicted: time that it was expected to take [s]; None: nothing was.
        reason: why it gets no more.
    """

    seconds: float
    predicted: float | None
    reason: str

    def words(self, taken: float, reason: str = "") -> str:
        """The status of a run that was stopped after so many seconds, for another reason where there is one."""
        expected = "nothing predicted" if self.predicted is None else f"predicted {seconds_in_words(self.predicted)}"
        return f"stopped after {seconds_in_words(taken)}, {expected}: {reason or self.reason}"


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

    def allowance(self, predicted: float | None, kept: float = 0.0) -> Allowance:
        """What a run may take that should take so many seconds, where so many are kept for others."""
        remaining = max(self.left() - kept, 1.0)
        if predicted is None:
            wanted, reason = FIRST * self.seconds, f"more than {100 * FIRST:g} % of the budget, no time for a second mesh"
        else:
            wanted, reason = PATIENCE * predicted, f"more than {PATIENCE:g} times as long"
        if wanted < LEAST * self.seconds:
            wanted, reason = LEAST * self.seconds, f"more than {100 * LEAST:g} % of the budget"
        if wanted < remaining:
            return Allowance(wanted, predicted, reason)
        return Allowance(remaining, predicted, "no more of the budget is left" if kept == 0.0 else
                         "the rest of the budget is for running what is recommended")


def free_memory() -> float:
    """What the machine can give without swapping [byte]: files that it has read and keeps count as free."""
    with open("/proc/meminfo") as file:
        found = re.search(r"^MemAvailable:\s*(\d+) kB", file.read(), re.M)
    return 1024.0 * float(found.group(1)) if found else float("inf")


def seconds_in_words(time_taken: float) -> str:
    """With two digits at least."""
    return f"{time_taken:.0f} s" if time_taken >= 9.95 else f"{time_taken:.2g} s"
