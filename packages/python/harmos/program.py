"""Runs the program `harmos` from Python: scenes and studies in files, or built in code with harmos.scenes.

    import harmos
    result = harmos.run("xml/bolted_joint.xml", "results", changes={"Values/mu": 0.2})
    result.status, result.history["reaction"], result.fields().at_nodes("disp_x")
    study = harmos.run_study("xml/bolted_joint_study.xml", "results")
    study.frame()

What goes wrong is an exception with the exit code and the messages of the program: HarmosError and those below it.
"""
import operator
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Mapping, Sequence

from harmos.errors import Interrupted, NotFound, error_for
from harmos.result import Result
from harmos.results import Study, read_study
from harmos.scenes import Input, Value, value_text

VARIABLE = "HARMOS_PROGRAM"
"""The environment variable that names the program."""
PLACES = ("bin/harmos", "drivers/harmos")
"""Where the program is, seen from the folder that share/harmos/python is in: installed, and in a build tree."""
LAUNCHER = "mpirun"
"""What starts several ranks."""


def find_program() -> str:
    """The path of the program: of the environment variable HARMOS_PROGRAM, else beside this package where it came with
    the program, else on PATH.

    Raises:
        NotFound: it is nowhere; the message says where it was looked for.
    """
    named = os.environ.get(VARIABLE)
    if named:
        if not os.access(named, os.X_OK):
            raise NotFound(f"{VARIABLE} is \"{named}\", which is no program. Give the path of harmos, or unset it.")
        return named
    here = pathlib.Path(__file__).absolute().parents[1]  # where it was imported from: links lead away from the program
    beside = [here.parents[2] / place for place in PLACES] if here.parts[-3:] == ("share", "harmos", "python") else []
    for place in beside:
        if os.access(place, os.X_OK):
            return str(place)
    found = shutil.which("harmos")
    if found:
        return found
    looked = ", ".join([f"the variable {VARIABLE}", *map(str, beside), "the folders of PATH"])
    raise NotFound(f"the program harmos was not found; looked for in {looked}. Set {VARIABLE} to its path.")


def version() -> str:
    """Of the program, such as "0.1.0"."""
    return _output(["--version"]).split()[-1]


def check(source: "Input | str | os.PathLike[str]", changes: Mapping[str, Value] | None = None) -> str:
    """Validates a scene or a study; what the program says of its size and cost, and its warnings.

    Args:
        source: a file, or an input built in code.
        changes: other values of entries, by path: {"Solver/Accuracy": 1e-5}.

    Raises:
        InputError: it is wrong; the messages are those of the program.
    """
    with tempfile.TemporaryDirectory(prefix="harmos-") as folder:
        return _output(["check", str(_file(source, folder)), *_options(changes)])


def run(scene: "Input | str | os.PathLike[str]", output: str | os.PathLike[str] = "results",
        changes: Mapping[str, Value] | None = None, ranks: int = 1) -> Result:
    """Solves a scene, writes its files into `output` and reads them.

    Args:
        scene: a file, or a scene built in code, which is written into `output` first.
        output: folder of the results.
        changes: other values of entries, by path: {"Values/mu": 0.2}.
        ranks: processes that solve it together; more than one are started by mpirun.

    Raises:
        TypeError, ValueError: `ranks` are no number of processes, or an entry of the scene holds what no entry may.
        InputError: the scene is wrong; nothing was written.
        NotConverged, NoEquilibrium, Interrupted: as they say; `result` of the error is what was written.
        HarmosError: anything else.
    """
    path = _file(scene, output)
    words = ["run", str(path), "--output", os.fspath(output), "--quiet", *_options(changes)]
    record = pathlib.Path(output) / f"{path.stem}_result.json"
    before = _stamp(record)
    code, errors = _start(words, ranks)
    # What an earlier run has left is no result of this one.
    result = Result(record) if code != 2 and code != 1 and _stamp(record) not in (None, before) else None
    if code != 0 or result is None:
        raise error_for(code, errors, result)
    return result


def run_study(study: "Input | str | os.PathLike[str]", output: str | os.PathLike[str] = "results",
              changes: Mapping[str, Value] | None = None, ranks: int = 1, ranks_per_configuration: int = 1,
              restart: bool = False, points: str | os.PathLike[str] | None = None) -> Study:
    """Solves a study, or what is left of it, and reads its file.

    Args:
        study: a file, or a study built in code, which is written into `output` first.
        output: folder of the results.
        changes: other values of entries, by path; with Scene/ before it those of the scene.
        ranks: processes; more than one are started by mpirun.
        ranks_per_configuration: of these, so many solve one configuration together.
        restart: forgets the results of an earlier run.
        points: a table whose rows are solved instead of the study's design.

    Raises:
        TypeError, ValueError: `ranks` are no number of processes, or an entry of the study holds what no entry may.
        InputError: the study is wrong; nothing was written.
        NotConverged, NoEquilibrium, Interrupted: as they say; `study` of the error is what was written.
        HarmosError: anything else.
    """
    path = _file(study, output)
    words = ["study", str(path), "--output", os.fspath(output), "--quiet", *_options(changes)]
    if ranks_per_configuration > 1:
        words += ["--ranks-per-configuration", str(ranks_per_configuration)]
    if restart:
        words.append("--restart")
    if points is not None:
        words += ["--points", os.fspath(points)]
    code, errors = _start(words, ranks)
    file = pathlib.Path(output) / f"{path.stem}.h5"
    found = read_study(file) if code != 2 and code != 1 and file.exists() else None
    if code != 0 or found is None:
        raise error_for(code, errors, found)
    return found


def _file(source: "Input | str | os.PathLike[str]", folder: str | os.PathLike[str]) -> pathlib.Path:
    """The file of an input; of one that was built in code it is written into the folder."""
    if not isinstance(source, Input):
        return pathlib.Path(source)
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    return source.write(pathlib.Path(folder) / f"{source.name}.xml")


def _stamp(path: pathlib.Path) -> tuple[int, int] | None:
    """Which file it is, and when it was written; files are replaced and never written anew in place. None: there is none."""
    try:
        found = path.stat()
    except FileNotFoundError:
        return None
    return found.st_ino, found.st_mtime_ns


def _options(changes: Mapping[str, Value] | None) -> list[str]:
    words = []
    for path, value in (changes or {}).items():
        words += ["--set", f"{path}={value_text(value)}"]
    return words


def _start(words: Sequence[str], ranks: int) -> tuple[int, str]:
    """Exit code and messages; Ctrl-C goes to the program, which ends with what is complete."""
    if operator.index(ranks) < 1:
        raise ValueError(f"ranks are processes, one at least: not {ranks}")
    program = [find_program()]
    if ranks > 1:
        if not shutil.which(LAUNCHER):
            raise NotFound(f"{ranks} ranks are started by {LAUNCHER}, which is not on PATH.")
        program = [LAUNCHER, "-np", str(ranks), *program]
    process = subprocess.Popen([*program, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                               errors="replace")
    try:
        errors = process.communicate()[1]
    except KeyboardInterrupt:
        process.send_signal(signal.SIGINT)
        raise Interrupted(130, [process.communicate()[1].strip() or "interrupted"]) from None
    return process.returncode, errors


def _output(words: Sequence[str]) -> str:
    """What the program prints; its error otherwise."""
    done = subprocess.run([find_program(), *words], capture_output=True, text=True, errors="replace", check=False)
    if done.returncode != 0:
        raise error_for(done.returncode, done.stderr or done.stdout)
    return done.stdout
