"""Materials of a deck."""
import dataclasses

import numpy

from harmos.exchange.deck.cards import Card
from harmos.exchange.findings import Findings, Refusals, Refused
from harmos.exchange.scene import SceneList

_EFFECTS = {
    "PLASTIC": "plastic flow: parts stay elastic, stresses above the yield stress are too high",
    "HYPERELASTIC": "rubber elasticity", "HYPERFOAM": "foam elasticity",
    "CREEP": "creep: nothing flows with time",
    "DAMPING": "damping, without effect in statics", "CONDUCTIVITY": "heat conduction, without effect in statics",
    "SPECIFICHEAT": "heat capacity, without effect in statics",
}


_KINDS = ("ISO", "ISOTROPIC", "ENGINEERINGCONSTANTS", "ENGINEERING CONSTANTS", "ORTHO", "ORTHOTROPIC")
"""Of elasticity, that Harmos has."""

SMALLEST_RATIO, LARGEST_RATIO, LEAST_ENERGY = -0.999, 0.4999999, 1e-7
"""What a scene takes: Poisson's ratios of isotropic materials, and the determinant of the energy of orthotropic ones."""


@dataclasses.dataclass
class Material:
    """A material.

    Attributes:
        card: it stands on.
        name: in the scene.
        entries: of the scene; empty: it is not linear elastic.
        elastic: FILE:LINE of the numbers that they come from.
        density: mass per volume; 0: not given.
        expansion: entries of the scene for strains of temperatures; empty: there are none.
    """
    card: Card
    name: str
    entries: dict[str, float]
    elastic: str = ""
    density: float = 0.0
    expansion: dict[str, float] = dataclasses.field(default_factory=dict)


def has_axes(material: Material) -> bool:
    """Whether it differs from direction to direction, so that orientations count."""
    return bool(material.entries) and "Young's Modulus" not in material.entries


def read_materials(cards: list[Card], findings: Findings) -> dict[str, Material]:
    """All materials by their name in capitals; cards that belong to them follow them."""
    result: dict[str, Material] = {}
    refusals = Refusals()
    for card in cards:
        with refusals.collect():
            _take(card, result, findings)
    refusals.raise_if_any()
    return result


def _take(card: Card, result: dict[str, Material], findings: Findings) -> None:
    if card.keyword == "MATERIAL":
        name = card.get("NAME")
        if name in result:
            raise Refused(f"{card.place}: the material \"{name}\" is also at {result[name].card.place}; rename one.")
        result[name] = Material(card, card.parameters.get("NAME", "material"), {})
    elif result:
        current = list(result.values())[-1]
        if card.keyword == "ELASTIC":
            current.entries, current.elastic = _elastic(card, findings), card.place
        elif card.keyword == "DENSITY" and card.data:
            current.density = card.number(card.rows()[0][0], 0)
        elif card.keyword == "EXPANSION":
            current.expansion = _expansion(card, findings)
        elif card.keyword in _EFFECTS:
            findings.leave_out(card.place, f"*{card.keyword}", _EFFECTS[card.keyword])


def _elastic(card: Card, findings: Findings) -> dict[str, float]:
    kind = card.get("TYPE") or "ISO"
    numbers = card.flat()
    own = 2 if kind in ("ISO", "ISOTROPIC") else 9
    if kind in _KINDS and (len(card.data) > 1 if own == 2 else len(numbers) > own + 1):
        findings.leave_out(card.place, "*ELASTIC", "moduli that depend on temperature: the first ones are taken")
    if kind in ("ISO", "ISOTROPIC"):
        if len(numbers) < 2:
            raise Refused(f"{card.place}: *ELASTIC takes Young's modulus and Poisson's ratio.")
        return {"Young's Modulus": float(numbers[0]), "Poisson's Ratio": float(numbers[1])}
    if kind in ("ENGINEERINGCONSTANTS", "ENGINEERING CONSTANTS") and len(numbers) >= 9:
        names = ["Young's Modulus 1", "Young's Modulus 2", "Young's Modulus 3", "Poisson's Ratio 12",
                 "Poisson's Ratio 13", "Poisson's Ratio 23", "Shear Modulus 12", "Shear Modulus 13", "Shear Modulus 23"]
        return dict(zip(names, (float(number) for number in numbers)))
    if kind in ("ORTHO", "ORTHOTROPIC") and len(numbers) >= 9:
        a, b, c, d, e, f = (float(number) for number in numbers[:6])
        stiffness = numpy.array([[a, b, d], [b, c, e], [d, e, f]])
        if not numpy.linalg.eigvalsh(stiffness).min() > 0.0:
            findings.leave_out(card.place, f"*ELASTIC, TYPE={kind}", "this elasticity has no stiffness in some direction; the "
                               "material has to be given anew")
            return {}
        compliance = numpy.linalg.inv(stiffness)
        young = 1.0 / numpy.diag(compliance)
        return {"Young's Modulus 1": float(young[0]), "Young's Modulus 2": float(young[1]),
                "Young's Modulus 3": float(young[2]), "Poisson's Ratio 12": float(-compliance[1, 0] * young[0]),
                "Poisson's Ratio 23": float(-compliance[2, 1] * young[1]),
                "Poisson's Ratio 13": float(-compliance[2, 0] * young[0]), "Shear Modulus 12": float(numbers[6]),
                "Shear Modulus 13": float(numbers[7]), "Shear Modulus 23": float(numbers[8])}
    findings.leave_out(card.place, f"*ELASTIC, TYPE={kind}", "this elasticity; the material has to be given anew")
    return {}


def _demand_possible(place: str, entries: dict[str, float]) -> None:
    """Refuses elasticity that the scene would be refused for: without stiffness, or with no energy in some strain."""
    for name, value in entries.items():
        if "Modulus" in name and not value > 0.0:
            raise Refused(f"{place}: *ELASTIC: {name} = {value:g} is out of range: above 0.")
    if "Young's Modulus" in entries:
        ratio = entries["Poisson's Ratio"]
        if not SMALLEST_RATIO <= ratio <= LARGEST_RATIO:
            raise Refused(f"{place}: *ELASTIC: Poisson's Ratio = {ratio:.9g} is out of range: at least {SMALLEST_RATIO} and at most {LARGEST_RATIO}."
                          "\n  Take the largest one, and the part's Formulation B-Bar, for a material that keeps its volume.")
        return
    energy = numpy.eye(3)
    for one, other in ((0, 1), (0, 2), (1, 2)):
        share = entries[f"Young's Modulus {other + 1}"] / entries[f"Young's Modulus {one + 1}"]
        energy[one, other] = energy[other, one] = -entries[f"Poisson's Ratio {one + 1}{other + 1}"] * share**0.5
    if not (numpy.abs(energy - numpy.eye(3)).max() < 1.0 and numpy.linalg.det(energy) > LEAST_ENERGY):
        raise Refused(f"{place}: *ELASTIC: these Poisson's ratios leave no energy, or next to none, in some strain: reduce them.")


def _expansion(card: Card, findings: Findings) -> dict[str, float]:
    kind = card.get("TYPE") or "ISO"
    numbers = [float(number) for number in card.flat()]
    if len(card.data) > 1:
        findings.leave_out(card.place, "*EXPANSION", "expansion that depends on temperature: the first line is taken")
    if kind == "ISO" and numbers:
        return {"Thermal Expansion": numbers[0]}
    if kind in ("ORTHO", "ORTHOTROPIC") and len(numbers) >= 3:
        return {f"Thermal Expansion {axis}": number for axis, number in zip("123", numbers)}
    findings.leave_out(card.place, f"*EXPANSION, TYPE={kind}", "this thermal strain: temperatures change nothing")
    return {}


def write_material(material: Material, name: str, axes: "tuple[list[float], list[float]] | None", scene: SceneList,
                   findings: Findings) -> None:
    """Adds a material to the scene; steel in mm and N where the deck has no elasticity that Harmos has.

    Raises:
        Refused: no material has this elasticity.
    """
    materials = scene.child("Materials")
    entries = material.entries
    if entries:
        _demand_possible(material.elastic, entries)
    else:
        materials.comment(f"TO DECIDE: {material.card.place} has no linear elasticity; steel in mm and N stands here.")
        findings.undecided.append(f"material {name}: the deck has no linear elasticity for it, steel in mm and N is assumed")
        entries = {"Young's Modulus": 210000.0, "Poisson's Ratio": 0.3}
    kind = "Isotropic" if "Young's Modulus" in entries else "Orthotropic"
    target = materials.child(name).set("Type", kind)
    for entry, value in entries.items():
        target.set(entry, value)
    if kind == "Orthotropic" and axes is not None:
        target.set("Axis 1", axes[0]).set("Axis 2", axes[1])
