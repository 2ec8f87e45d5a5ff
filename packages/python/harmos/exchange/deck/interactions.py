"""Surface interactions of a deck as laws of contact."""
import dataclasses
import math
from collections.abc import Callable

from harmos.exchange.deck.cards import Card
from harmos.exchange.findings import Findings, Refused, names_there
from harmos.exchange.scene import SceneList

_PROPERTIES = ("FRICTION", "SURFACEBEHAVIOR", "CONTACTDAMPING", "GAPCONDUCTANCE", "GAPHEATGENERATION")

_STEPS = 32
"""Points of the table of an exponential law within the distance in which the pressure falls to 1 %: straight lines between
them are off by 0.3 % at most."""

_REACH = 3
"""That table ends where the pressure is 100 to this power times that of touching surfaces; beyond, its last slope goes on."""


@dataclasses.dataclass
class Interaction:
    """A surface interaction.

    Attributes:
        card: it stands on.
        kind: HARD, LINEAR, EXPONENTIAL, TABULAR or TIED.
        numbers: of the pressure-overclosure, in their order.
        friction: coefficient [-].
        stick_slope: shear stress by slip while the surfaces stick [stress/length]; 0: they stick without slip.
    """
    card: Card
    kind: str = "HARD"
    numbers: list[float] = dataclasses.field(default_factory=list)
    friction: float = 0.0
    stick_slope: float = 0.0

    @property
    def may_open(self) -> bool:
        """Whether it is contact, which depends on the way of the loads."""
        return self.kind != "TIED"

    def rub(self, friction: float, stick_slope: float) -> None:
        """Takes what *FRICTION says."""
        self.friction, self.stick_slope = friction, stick_slope

    def close(self, kind: str, numbers: list[float]) -> None:
        """Takes what *SURFACE BEHAVIOR says."""
        self.kind, self.numbers = kind, numbers

    def write(self, law: SceneList) -> None:
        """Fills in the list Law of an interface."""
        writers: dict[str, Callable[[SceneList], None]] = {
            "HARD": self._write_hard, "LINEAR": self._write_linear, "TIED": self._write_tied}
        writers.get(self.kind, self._write_table)(law)

    def _write_hard(self, law: SceneList) -> None:
        if self.friction > 0.0:
            law.set("Type", "Coulomb Friction").set("Friction Coefficient", self.friction)
        else:
            law.set("Type", "Unilateral Contact")

    def _write_linear(self, law: SceneList) -> None:
        law.set("Type", "Compliant Contact").set("Normal Stiffness", self.numbers[0])
        self._write_friction(law)

    def _write_table(self, law: SceneList) -> None:
        if self.kind == "EXPONENTIAL":
            distance, pressure = self.numbers[:2]
            steps = range(-_STEPS, _REACH * _STEPS + 1)
            overclosures = [distance * step / _STEPS for step in steps]
            pressures = [0.0, *(pressure * 100.0 ** (step / _STEPS) for step in steps[1:])]
        else:
            overclosures, pressures = self.numbers[1::2], self.numbers[0::2]
        law.set("Type", "Tabulated Contact").set("Overclosures", overclosures).set("Pressures", pressures)
        self._write_friction(law)

    def _write_friction(self, law: SceneList) -> None:
        if self.friction > 0.0:
            law.set("Friction Coefficient", self.friction)
            if self.stick_slope > 0.0:
                law.set("Tangential Stiffness", self.stick_slope)

    def _write_tied(self, law: SceneList) -> None:
        law.set("Type", "Linear Elastic").set("Normal Stiffness", self.numbers[0])
        law.set("Tangential Stiffness", self.stick_slope or self.numbers[0])


class Interactions:
    """All surface interactions of a deck; what Harmos has not is listed."""

    def __init__(self, cards: list[Card], findings: Findings) -> None:
        """Reads those of the model; properties belong to the interaction that stands above them."""
        self._findings = findings
        self._all: dict[str, Interaction] = {}
        current: Interaction | None = None
        for card in cards:
            if card.keyword == "SURFACEINTERACTION":
                current = self._all[card.get("NAME")] = Interaction(card)
            elif card.keyword in _PROPERTIES and current is not None:
                self._take(card, current)
            else:
                current = None
        for interaction in self._all.values():
            if interaction.kind == "HARD" and interaction.stick_slope > 0.0:
                findings.leave_out(interaction.card.place, "*FRICTION, stick slope",
                                   "sticking is without slip; the deck lets surfaces slide by traction / slope")

    def find(self, card: Card) -> Interaction:
        """That of a contact pair.

        Raises:
            Refused: there is none of this name.
        """
        name = card.get("INTERACTION")
        if name not in self._all:
            raise Refused(f"{card.place}: there is no *SURFACE INTERACTION \"{name}\". {names_there(name, self._all)}")
        return self._all[name]

    def _take(self, card: Card, interaction: Interaction) -> None:
        if card.keyword == "FRICTION":
            numbers = [card.number(word, 0) for word in card.rows()[0]] if card.data else []
            if len(card.data) > 1 or len(numbers) > 2:
                self._findings.leave_out(card.place, "*FRICTION", "that depends on more than the pressure: the first numbers "
                                         "are taken")
            interaction.rub(*([*numbers, 0.0, 0.0])[:2])
        elif card.keyword == "SURFACEBEHAVIOR":
            self._take_behavior(card, interaction)
        else:
            self._findings.leave_out(card.place, f"*{card.keyword}", "this property of the contact")

    def _take_behavior(self, card: Card, interaction: Interaction) -> None:
        kind = card.get("PRESSURE-OVERCLOSURE") or "HARD"
        # CalculiX's LINEAR has two more numbers, which shape the tension of surfaces that are apart.
        numbers = [card.number(word, row) for row, words in enumerate(card.rows()) for word in words if word]
        if kind == "HARD":
            return
        if not _is_complete(kind, numbers):
            self._findings.leave_out(card.place, f"*SURFACE BEHAVIOR, {kind}", "of which Harmos does not know what it means: "
                                     "contact is hard")
            return
        interaction.close(kind, numbers)


def _is_complete(kind: str, numbers: list[float]) -> bool:
    """Whether the numbers of a pressure-overclosure say what its kind needs."""
    if kind in ("LINEAR", "TIED"):
        return bool(numbers) and numbers[0] > 0.0
    if kind == "EXPONENTIAL":
        return len(numbers) >= 2 and min(numbers[:2]) > 0.0 and math.isfinite(numbers[1] * 100.0 ** _REACH)
    pressures, overclosures = numbers[0::2], numbers[1::2]
    return (kind == "TABULAR" and len(numbers) >= 4 and len(numbers) % 2 == 0 and pressures[0] == 0.0
            and all(one <= next_one for one, next_one in zip(pressures, pressures[1:]))
            and all(one < next_one for one, next_one in zip(overclosures, overclosures[1:])))
