"""Random scenes against an independent reference.

    cd tests
    python3 -m campaign run --harmos ../build/drivers/harmos --classes matching --scenes 330    30 scenes of each class
    python3 -m campaign run --harmos ../build/drivers/harmos --classes apart --scenes 150       meshes that do not match
    python3 -m campaign run --harmos ../build/drivers/harmos --only rings --first 100 --scenes 20
    python3 -m campaign run --harmos ../build/drivers/harmos --accuracy 0.03 --scenes 64    as rough as can be asked for
    python3 -m campaign restate --harmos ../build/drivers/harmos --scenes 80    the same problems in other words
    python3 -m campaign study --harmos ../build/drivers/harmos --scenes 80    numbers of laws vary: each against a run
    python3 -m campaign study --harmos ../build/drivers/harmos --scenes 15 --configurations 49    of each, so that estimates are calibrated
    python3 -m campaign crack --harmos ../build/drivers/harmos --scenes 300    glue that fails: cohesive zones
    python3 -m campaign show rings 3 --output DIR                               writes the scene and prints the answer
    python3 -m campaign try rings 3 --harmos ../build/drivers/harmos            one scene, with all responses

A scene is made of its class and seed alone. Exit code 1: the goals are missed.
"""
from __future__ import annotations

import argparse
import pathlib
import sys
import tempfile
from collections.abc import Iterable, Iterator

from .reference.solver import Answer, solve
from .scenes.classes import APART, CLASSES, MATCHING, make_scene
from .scenes.restatements import RESTATEMENTS
from .scenes.scene import Scene
from .scenes.scene_file import write_scene
from .trial.campaign import Trial, report, try_scene
from .trial.cracks import CrackTrial, crack_report, try_crack
from .trial.program import run_harmos
from .trial.restatements import Pair, restatement_report, try_restatements
from .trial.studies import StudyTrial, study_report, try_study
from .trial.verdict import judge, true_errors

GROUPS: dict[str, Iterable[str]] = {"all": CLASSES, "matching": MATCHING, "apart": APART}


def _print_answer(scene: Scene, answer: Answer) -> None:
    print(f"{len(scene.mesh.nodes)} nodes, {scene.steps} steps, accuracy {scene.accuracy:g}: {answer.outcome.value}"
          + ("" if answer.failed_step is None else f" at step {answer.failed_step + 1}"))
    print("share of the loads that statics leaves unbalanced:",
          " ".join(f"{balance.outer:.1e}" for balance in answer.balances))
    for name, values in answer.values.items():
        print(f"  {name:24} spread {answer.spread[name]:.0e}  " + " ".join(f"{value:.9e}" for value in values))


def _show(options: argparse.Namespace) -> bool:
    scene = make_scene(options.name, options.seed, options.accuracy)
    print(write_scene(scene, options.output))
    _print_answer(scene, solve(scene))
    return True


def _try(options: argparse.Namespace) -> bool:
    scene = make_scene(options.name, options.seed, options.accuracy)
    path = write_scene(scene, options.output)
    run = run_harmos(options.harmos, path, options.limit, *[a for text in options.set for a in ("--set", text)])
    answer = solve(scene)
    _print_answer(scene, answer)
    print(f"{path}: {run.ending.name}, {run.reason}, {run.stages} linear stages")
    for name, error in true_errors(run, answer).items():
        values = " ".join(f"{value:.9e}" for value in run.values.get(name, []))
        print(f"  {name:24} error {error:.1e}, estimate {run.estimates.get(name, 0.0):.1e}  {values}")
    judgement = judge(scene, run, answer)
    print(f"{judgement.verdict.value}; {judgement.detail}")
    return True


def _chosen(options: argparse.Namespace) -> Iterator[tuple[str, int]]:
    names = options.only or list(GROUPS[options.classes])
    for index in range(options.scenes):
        yield names[index % len(names)], options.first + index // len(names)


def _trials(options: argparse.Namespace) -> Iterator[Trial]:
    for name, seed in _chosen(options):
        trial = try_scene(name, seed, options.harmos, options.output, options.limit, options.accuracy)
        print(f"{name} {seed}: {trial.nodes} nodes, {trial.judgement.verdict.value}, {trial.stages} stages, "
              f"{trial.harmos_seconds:.1f} s, reference {trial.reference_seconds:.1f} s; {trial.judgement.detail}",
              file=sys.stderr, flush=True)
        yield trial


def _run(options: argparse.Namespace) -> bool:
    trials: list[Trial] = []
    is_whole = True
    try:
        for trial in _trials(options):
            trials.append(trial)
    except KeyboardInterrupt:
        is_whole = False
        print("interrupted: what there is so far", file=sys.stderr)
    text, met = report(trials)
    print(text)
    return met and is_whole


def _restate(options: argparse.Namespace) -> bool:
    pairs: list[Pair] = []
    for name, seed in _chosen(options):
        new = try_restatements(name, seed, options.harmos, options.output, options.limit,
                               options.kind or list(RESTATEMENTS))
        said = (f"{pair.restatement} {pair.endings[1].name.lower()} {pair.error:.2f} {pair.excess:.2f}" for pair in new)
        print(f"{name} {seed}: " + ", ".join(said), file=sys.stderr, flush=True)
        pairs += new
    text, met = restatement_report(pairs)
    print(text)
    return met


def _study(options: argparse.Namespace) -> bool:
    trials: list[StudyTrial] = []
    for name, seed in _chosen(options):
        trial = try_study(name, seed, options.harmos, options.output, options.limit,
                          options.configurations)
        if trial is None:
            continue
        print(f"{name} {seed}: " + ", ".join(f"{one.verdict.value} {one.error:.2f}" for one in trial.judgements),
              file=sys.stderr, flush=True)
        trials.append(trial)
    text, met = study_report(trials)
    print(text)
    return met


def _crack(options: argparse.Namespace) -> bool:
    trials: list[CrackTrial] = []
    for seed in range(options.first, options.first + options.scenes):
        trial = try_crack(seed, options.harmos, options.output, options.limit)
        print(f"glued {seed}: {trial.judgement.verdict.value}, {trial.stages} stages", file=sys.stderr, flush=True)
        trials.append(trial)
    text, met = crack_report(trials)
    print(text)
    return met


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="campaign", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(required=True)
    for verb, function in (("run", _run), ("restate", _restate), ("study", _study), ("crack", _crack), ("show", _show), ("try", _try)):
        command = verbs.add_parser(verb)
        command.set_defaults(function=function)
        command.add_argument("--output", type=pathlib.Path, default=None, help="folder of scenes; default: a new one")
        if verb != "show":
            command.add_argument("--harmos", type=pathlib.Path, required=True, help="the program")
            command.add_argument("--limit", type=float, default=60.0, help="seconds per run")
        if verb in ("run", "show", "try"):
            command.add_argument("--accuracy", type=float, help="asked for; default: drawn with the scene")
        if verb in ("run", "restate", "study", "crack"):
            command.add_argument("--scenes", type=int, default=330)
            command.add_argument("--first", type=int, default=0, help="seed to begin with")
        if verb in ("run", "restate", "study"):
            command.add_argument("--classes", choices=list(GROUPS), default="all",
                                 help="matching: parts on one grid; apart: parts meshed one by one, all elements")
            command.add_argument("--only", action="append", choices=list(CLASSES), help="a class; may be repeated")
            if verb == "restate":
                command.add_argument("--kind", action="append", choices=list(RESTATEMENTS),
                                     help="of restatement; may be repeated")
            if verb == "study":
                command.add_argument("--configurations", type=int, default=0, help="of a study, about; default: 4 to 9")
        if verb in ("show", "try"):
            command.add_argument("name", choices=list(CLASSES))
            command.add_argument("seed", type=int)
        if verb == "try":
            command.add_argument("--set", action="append", default=[], help="as harmos run understands it")
    return parser.parse_args()


def main() -> int:
    """Exit code."""
    options = _options()
    if "harmos" in options:
        options.harmos = options.harmos.resolve()
    if options.output is None:
        options.output = pathlib.Path(tempfile.mkdtemp(prefix="campaign_"))
    return 0 if options.function(options) else 1


if __name__ == "__main__":
    sys.exit(main())
