"""Measures what accuracy costs for a scene or a study; `harmos trade` calls it.

python3 -m harmos.trade INPUT.xml --program HARMOS [--output DIR] [--budget 10min] [--memory 8GB] [--targets 1%,0.1%] [--responses A,B]
"""
import argparse
import itertools
import math
import os
import pathlib
import re
import sys

from harmos.outputs import demand_distinct, demand_no_folder, replace_file, writing
from harmos.report.writing import Pictures, percent
from harmos.trade.budget import Budget, free_memory
from harmos.trade.document import Document, scene_beside
from harmos.trade.judging import Judge
from harmos.trade.knobs import Knob, dimension_of, elements_of, knobs_of
from harmos.trade.ladder import Ladder, Rung
from harmos.trade.page import MEGABYTE, page
from harmos.trade.promises import MADE, Promise, candidates, keep, settings_files, settings_name
from harmos.trade.publishing import publish
from harmos.trade.responses import chosen_responses, demand_comparable, demand_moments
from harmos.trade.running import Runner, check, die_with_parent
from harmos.trade.tables import all_rungs, pareto, write_csv, write_hdf5
from harmos.trade.workspace import workspace

ENOUGH = 1 / 3
"""Uncertainty of the reference, over the least target, at which no finer mesh is needed for it."""
TIMES = {"s": 1.0, "min": 60.0, "h": 3600.0}
"""Units of a budget of time in seconds."""
ENDINGS = (".csv", ".h5", ".html")
"""Of the results."""
SIZES = {"MB": 1e6, "GB": 1e9}
"""Units of a budget of memory in bytes."""
FREE = 0.8
"""Share of the free memory that a run may take."""


def main(words: list[str] | None = None) -> int:
    """Does what the words say, those of the command line if there are none; returns the exit code: 2 for bad words or an input that Harmos refuses, 3 when a target is not kept, 130 when the program that has started it has ended."""
    parser = argparse.ArgumentParser(prog="harmos trade", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("input")
    parser.add_argument("--program", required=True)
    parser.add_argument("--output", default="results")
    parser.add_argument("--budget", default="10min")
    parser.add_argument("--memory", default="")
    parser.add_argument("--targets", default="1%,0.1%,0.01%")
    parser.add_argument("--responses", default="")
    parser.add_argument("--quiet", action="store_true")
    arguments = parser.parse_args(words)
    parent = os.getppid()
    try:
        seconds = _measured(arguments.budget, TIMES, "--budget", "10min")
        memory = _measured(arguments.memory, SIZES, "--memory", "8GB") if arguments.memory else FREE * free_memory()
        budget = Budget(seconds, memory)  # counts from here: large inputs take long to look at
        targets = sorted((_target(word) for word in arguments.targets.split(",")), reverse=True)
        document = Document(arguments.input)
        demand_comparable(document)
        demand_moments(document)
        responses = chosen_responses(arguments.responses, document)
        folder = pathlib.Path(arguments.output)
        results = _results(document, folder, targets)
        for file in results:
            demand_no_folder(file)
        for written, read in itertools.product({*results, *settings_files(document, folder)}, document.inputs()):
            demand_distinct(read, written)
        is_valid, said = check(arguments.program, document.path)
        if not is_valid:
            print(said, end="", file=sys.stderr)
            return 2
        with writing(folder):
            folder.mkdir(parents=True, exist_ok=True)
        die_with_parent()
        if os.getppid() != parent:  # it has died before that was asked for
            return 130
    except (OSError, ValueError) as error:
        print(f"harmos trade: {error}\nNothing was written.", file=sys.stderr)
        return 2
    try:
        with workspace(folder) as work:
            runner = Runner(arguments.program, document, work)
            knobs = knobs_of(document, runner.accepts, elements_of(document.names("Parts"), said))
            return _trade(document, runner, knobs, folder, work, budget, targets, responses, arguments.quiet)
    except (OSError, ValueError) as error:
        print(f"harmos trade: {error}", file=sys.stderr)
        return 1 if isinstance(error, OSError) else 2


def _base(document: Document, folder: pathlib.Path) -> pathlib.Path:
    """What the names of all results but the settings begin with."""
    return folder / f"{document.path.stem}_trade"


def _results(document: Document, folder: pathlib.Path, targets: list[float]) -> list[pathlib.Path]:
    """All files that may be written."""
    settings = [folder / settings_name(document, target) for target in targets]
    scenes = [scene_beside(file) for file in settings] if document.study is not None else []
    return [*(pathlib.Path(f"{_base(document, folder)}{ending}") for ending in ENDINGS), *settings, *scenes]


def _trade(document: Document, runner: Runner, knobs: list[Knob], folder: pathlib.Path, work: pathlib.Path, budget: Budget,
           targets: list[float], responses: list[str], is_quiet: bool) -> int:
    def report(rung: Rung) -> None:
        if not is_quiet:
            predicted = f", expected {rung.predicted:.2f}" if rung.predicted == rung.predicted else ""
            print(f"[{budget.spent():.0f} of {budget.seconds:.0f} s] {ladder.words(rung.settings)}: {rung.outcome.status}, "
                  f"{rung.outcome.cpu:.2f} CPU s{predicted}, {rung.outcome.memory / MEGABYTE:.0f} MB", file=sys.stderr,
                  flush=True)

    ladder = Ladder(knobs, dimension_of(document), runner, budget, report)
    ladder.explore(targets[-1], lambda: _is_enough(targets, ladder, Judge(ladder, responses)),
                   lambda family: Judge(ladder, responses).is_beaten(family))
    judge = Judge(ladder, responses)
    promises = [keep(target, ladder, judge, runner, document, folder, work) for target in targets]
    rungs = all_rungs(ladder)
    made = work / MADE
    made.mkdir(exist_ok=True)
    base = _base(document, made)
    write_csv(f"{base}.csv", ladder, judge, rungs)
    write_hdf5(f"{base}.h5", ladder, judge, rungs)
    text = page(f"What accuracy costs: {document.path.stem}", ladder, judge, rungs, promises, Pictures())
    replace_file(f"{base}.html", text.encode())
    publish(made, folder, settings_files(document, folder) - {file for promise in promises for file in promise.files})
    _print(ladder, judge, rungs, promises)
    base = _base(document, folder)
    print(f"{base}.html\n{base}.csv\n{base}.h5", flush=True)
    return 0 if all(promise.rung is not None for promise in promises) else 3


def _is_enough(targets: list[float], ladder: Ladder, judge: Judge) -> bool:
    """Whether no finer mesh is needed for the least target that finer meshes can help, and with that for any: neither for the reference nor for settings."""
    reachable = [target for target in targets if not judge.is_out_of_reach(target)]
    return not reachable or (judge.doubt() <= ENOUGH * min(reachable) and bool(candidates(min(reachable), ladder, judge)))


def _print(ladder: Ladder, judge: Judge, rungs: list[Rung], promises: list[Promise]) -> None:
    print(f"{'response':28s} {'goes to':>14s} {'relative to':>12s} {'known to':>10s}  limit of the meshes")
    for name, one in judge.references.items():
        print(f"{name:28s} {one.largest():14.7g} {one.size:12.5g} {percent(one.doubt()):>10s}  {one.space.word}")
    if not judge.references:
        print("Nothing is certified: there is no reference.")
    best = pareto(rungs, judge, "cpu")
    if best:
        print(f"{'error':>9s} {'at most':>9s} {'CPU s':>9s} {'MB':>7s}  settings that none beats in error and CPU time")
    for rung in best:
        print(f"{percent(judge.worst(rung)):>9s} {percent(judge.promised(rung)):>9s} {rung.outcome.cpu:9.2f} {rung.outcome.memory / MEGABYTE:7.0f}  "
              f"{ladder.words(rung.settings)}")
    for promise in promises:
        target = f"within {100 * promise.target:g} %"
        if promise.rung is None:
            print(f"{target}: no settings; {promise.reason}")
        else:
            cost = promise.rung.outcome
            print(f"{target}: {cost.cpu:.2f} CPU s, {cost.memory / MEGABYTE:.0f} MB, run afresh at most "
                  f"{percent(promise.error)} off; {promise.files[0]}")


def _measured(text: str, units: dict[str, float], option: str, example: str) -> float:
    found = re.fullmatch(r"\s*([0-9.]+(?:e[0-9]+)?)\s*([A-Za-z]+)\s*", text)
    size = _number(found.group(1)) * units.get(found.group(2), math.nan) if found else math.nan
    if not 0 < size < math.inf:
        raise ValueError(f"{option} is a number above 0 with one of the units {', '.join(units)}, such as {example}; "
                         f"it is \"{text}\".")
    return size


def _number(text: str) -> float:
    """NaN: it is none."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def _target(text: str) -> float:
    found = re.fullmatch(r"\s*([0-9.]+(?:e-?[0-9]+)?)\s*%\s*", text)
    if not found or not 1e-6 <= _number(found.group(1)) <= 100:
        raise ValueError(f"--targets are errors from 0.000001 % to 100 % with commas between, such as 1%,0.1%; one is "
                         f"\"{text}\".")
    return float(found.group(1)) / 100


if __name__ == "__main__":
    sys.exit(main())
