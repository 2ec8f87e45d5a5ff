"""Runs Harmos on an input with changes, in a process of its own whose CPU time and memory are measured."""
import ctypes
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time
from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from harmos.arrays import Floats
from harmos.trade.budget import Allowance
from harmos.trade.document import Document, Entry
from harmos.trade.interruption import held_interruptions
from harmos.trade.outcome import read_floors, read_outcome, read_reason
from harmos.trade.responses import reported_response

POLL = 0.02
"""Seconds between looks at a running process."""
PDEATHSIG = 1
"""Of prctl(): the signal that a process gets when its parent dies."""


def die_with_parent() -> None:
    """Has this process end with the one that has started it, however that ends."""
    ctypes.CDLL(None).prctl(PDEATHSIG, signal.SIGTERM)


@dataclass
class Outcome:
    """What a run has come to.

    Attributes:
        status: as Harmos says it, or why there is none.
        certified: whether the answer is as accurate as was asked for.
        values: of every response, [value]: at the ends of the load steps, or of the configurations; empty: no answer.
        estimates: what the certificate states of the iteration's error, in the unit of the response; NaN: nothing.
        sizes: what errors of a response are relative to.
        mesh: what Harmos itself estimates that the mesh does to a response, in its unit; those that have an estimate.
        design: what a design that refines itself leaves of a response's moments, in its unit; those that have such an error.
        cpu: of the whole process [s].
        wall: from its start to its end [s].
        memory: its largest resident set [byte].
        refused: whether Harmos does not take the input.
        stopped: whether it was ended before it had an answer.
        no_equilibrium: why a scene has no equilibrium; empty: it is not said to have none.
    """

    status: str
    certified: bool = False
    values: dict[str, Floats] = field(default_factory=dict)
    estimates: dict[str, float] = field(default_factory=dict)
    sizes: dict[str, float] = field(default_factory=dict)
    mesh: dict[str, float] = field(default_factory=dict)
    design: dict[str, float] = field(default_factory=dict)
    cpu: float = 0.0
    wall: float = 0.0
    memory: int = 0
    refused: bool = False
    stopped: bool = False
    no_equilibrium: str = ""


def check(program: str, path: pathlib.Path) -> tuple[bool, str]:
    """Whether Harmos takes a file, and what it says of it."""
    end = subprocess.run([program, "check", str(path)], env=_environment(), capture_output=True, text=True, check=False)
    return end.returncode == 0, end.stdout if end.returncode == 0 else end.stderr


class Runner:
    """Runs one input with changes, each time in a folder of its own that is removed afterwards."""

    def __init__(self, program: str, document: Document, folder: pathlib.Path) -> None:
        """Works in `folder`, which it makes."""
        self._program, self._document, self._folder = program, document, folder
        self._floors: dict[str, float] | None = None
        folder.mkdir(parents=True, exist_ok=True)

    def accepts(self, entries: Iterable[Entry]) -> bool:
        """Whether Harmos takes the input with these changes."""
        path = self._folder / f"{self._document.path.stem}.xml"
        self._document.write(entries, path, "a trial of harmos trade")
        return check(self._program, path)[0]

    def run(self, entries: Iterable[Entry], allowance: Allowance, memory: float) -> Outcome:
        """Solves the input with these changes, ends it after what it is allowed or with so many bytes."""
        path = self._folder / f"{self._document.path.stem}.xml"
        self._document.write(entries, path, "a trial of harmos trade")
        return self.run_file(path, allowance, memory)

    def run_file(self, path: pathlib.Path, allowance: Allowance, memory: float) -> Outcome:
        """Solves the input in a file; see run()."""
        results = self._folder / "results"
        begin = time.monotonic()
        verb = "run" if self._document.study is None else "study"
        code, stopped, usage = self._solve([verb, str(path)], results, allowance, memory)
        wall = time.monotonic() - begin
        outcome = Outcome(stopped, stopped=True) if stopped else self._read(results / path.stem, code)
        if self._document.study is not None and outcome.certified:
            if self._floors is None:
                self._floors = self._floors_of(path, results, allowance, memory)
            floors = {name: self._floors.get(reported_response(self._document, name), 0.0) for name in outcome.sizes}
            outcome = replace(outcome, sizes={name: max(size, floors[name]) for name, size in outcome.sizes.items()})
        shutil.rmtree(results, ignore_errors=True)
        return replace(outcome, cpu=usage.ru_utime + usage.ru_stime, wall=wall, memory=usage.ru_maxrss * 1024)

    def _solve(self, words: list[str], results: pathlib.Path, allowance: Allowance,
               memory: float) -> tuple[int, str, resource.struct_rusage]:
        """Runs the program into a new folder; see _watched()."""
        shutil.rmtree(results, ignore_errors=True)
        return _watched([self._program, *words, "--quiet", "--output", str(results)], _environment(),
                        self._folder / "messages", allowance, memory)

    def _floors_of(self, study: pathlib.Path, results: pathlib.Path, allowance: Allowance,
                   memory: float) -> dict[str, float]:
        """What responses count as nothing below, which a study does not say, from one run of its scene; empty: no answer."""
        written = Document(study)
        overrides = [word for one in written.overrides for word in ("--set", one)]
        self._solve(["run", str(written.scene_path), *overrides], results, allowance, memory)
        try:
            return read_floors(self._document, results / written.scene_path.stem)
        except (OSError, ValueError, KeyError):
            return {}

    def _read(self, base: pathlib.Path, exit_code: int) -> Outcome:
        if exit_code not in (0, 3, 4):
            words = (self._folder / "messages").read_text(errors="replace").strip().splitlines()
            if exit_code == 2:
                said = re.sub(rf"^{re.escape(str(self._folder))}.*?\.xml(:\d+)?: ", "", words[0]) if words else ""
                return Outcome(f"refused: {said}" if said else "refused", refused=True)
            return Outcome(f"failed, exit code {exit_code}")
        try:
            lacks_equilibrium = exit_code == 4 and self._document.study is None  # of a study some configurations may
            return Outcome(*read_outcome(self._document, base), no_equilibrium=read_reason(base) if lacks_equilibrium else "")
        except (OSError, ValueError, KeyError) as error:
            return Outcome(f"no answer: {error}")


def _environment() -> dict[str, str]:
    """That of this process without the marks of mpirun: a run that found them would take itself for one of its processes."""
    is_launched = "OMPI_COMM_WORLD_SIZE" in os.environ
    return {name: value for name, value in os.environ.items()
            if not (is_launched and re.match("(OMPI|PMIX|ORTE|OPAL)_(?!ALLOW)", name))}


def _watched(command: list[str], environment: dict[str, str], messages: pathlib.Path, allowance: Allowance,
             memory: float) -> tuple[int, str, resource.struct_rusage]:
    """Exit code, why it was stopped (empty: it was not) and what a command has used that may take so much."""
    begin = time.monotonic()
    process: subprocess.Popen[bytes] | None = None
    stopped = ""
    try:
        with open(messages, "wb") as file, held_interruptions():
            process = subprocess.Popen(command, env=environment, stdout=file, stderr=file, preexec_fn=die_with_parent)
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = os.waitstatus_to_exitcode(status)  # so that Popen waits for it no more
                return process.returncode, stopped, usage
            taken = time.monotonic() - begin
            if not stopped and taken > allowance.seconds:
                stopped = allowance.words(taken)
            elif not stopped and _peak(process.pid) > memory:
                stopped = allowance.words(taken, "out of memory")
            if stopped:
                os.kill(process.pid, signal.SIGKILL)
            time.sleep(POLL)
    finally:
        if process is not None and process.returncode is None:  # interrupted: nothing may write any more where its folder is removed
            process.kill()
            process.wait()


def _peak(process: int) -> float:
    try:
        with open(f"/proc/{process}/status") as file:
            words = re.search(r"VmHWM:\s*(\d+) kB", file.read())
    except OSError:
        return 0.0
    return 1024.0 * float(words.group(1)) if words else 0.0
