"""What rungs that have not been run will cost, from those that have."""
import math
from typing import TYPE_CHECKING

from harmos.trade.knobs import Role

if TYPE_CHECKING:
    from harmos.trade.ladder import Ladder, Rung, Settings

ACCURACY = 1.5
"""What an accuracy costs that has not been measured, over the one at which meshes are compared."""
FAMILY = 4.0
"""What the first mesh of a family costs, over the same one as given."""


def predicted_cost(ladder: "Ladder", settings: "Settings", what: str) -> float | None:
    """CPU or wall time of settings [s]: "cpu" or "wall"; None: nothing to go by."""
    family = list(settings)
    factor = 1.0
    for knob in ladder.indices(Role.SIDE, Role.CHOICE):
        family[knob] = ladder.base()[knob]
        factor *= _factor(ladder, knob, settings[knob], what)
    mesh = _mesh_cost(ladder, tuple(family), what)
    return None if mesh is None else factor * mesh


def predicted_memory(ladder: "Ladder", settings: "Settings") -> float:
    """Largest resident set that settings on the next mesh may need [byte]."""
    measured = ladder.meshes(settings)
    if len(measured) < 2:
        return 0.0
    growth = measured[-1].outcome.memory / measured[-2].outcome.memory
    return growth * measured[-1].outcome.memory


def _cost(rung: "Rung", what: str) -> float:
    return max(rung.outcome.cpu if what == "cpu" else rung.outcome.wall, 1e-3)


def _factor(ladder: "Ladder", knob: int, level: int, what: str) -> float:
    base = ladder.base()
    if level == base[knob]:
        return 1.0
    if ladder.knobs[knob].role is Role.CHOICE:
        pair = ladder.choice(knob, level)
        return _cost(pair[0], what) / _cost(pair[1], what) if pair else 1.0
    one, reference = ladder.rungs.get(ladder.turned(base, knob, level)), ladder.rungs.get(base)
    if one is not None and reference is not None and one.outcome.certified:
        return _cost(one, what) / _cost(reference, what)
    levels = ladder.knobs[knob].levels
    return ACCURACY if ladder.knobs[knob].name == "accuracy" else max(1.0, levels[base[knob]].size / levels[level].size)


def _mesh_cost(ladder: "Ladder", family: "Settings", what: str) -> float | None:
    if family in ladder.rungs and ladder.rungs[family].outcome.certified:
        return _cost(ladder.rungs[family], what)
    mesh = ladder.index("mesh")
    sizes = [level.size for level in ladder.knobs[mesh].levels]
    wanted = sizes[family[mesh]]
    measured = [rung for rung in ladder.meshes(family) if sizes[rung.settings[mesh]] > wanted]
    if measured:
        last = measured[-1]
        powers = [_power(meshes, sizes, mesh, what) for meshes in (measured, ladder.meshes(ladder.base())) if len(meshes) > 1]
        if len(measured) > 2:  # factors take over: what the power has grown by it goes on to grow by, to theirs at most
            before = _power(measured[:-1], sizes, mesh, what)
            powers.append(min(2 * powers[0] - before, ladder.dimension + 1.0))
        # At least the dimension: on coarse meshes what does not grow with them hides what does.
        power = max([float(ladder.dimension), *powers])
        return _cost(last, what) * math.exp(power * math.log(sizes[last.settings[mesh]] / wanted))
    given = ladder.rungs.get(ladder.turned(ladder.base(), mesh, family[mesh]))
    return FAMILY * _cost(given, what) if given and given.outcome.certified else None


def _power(measured: "list[Rung]", sizes: list[float], mesh: int, what: str) -> float:
    """With which power of the number of elements along an edge the cost has grown last."""
    coarse, fine = measured[-2:]
    return math.log(_cost(fine, what) / _cost(coarse, what)) / math.log(
        sizes[coarse.settings[mesh]] / sizes[fine.settings[mesh]])
