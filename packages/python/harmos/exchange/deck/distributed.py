"""Pressures, weight and rotation of a deck."""
import numpy

from harmos.exchange.deck.acting import Acting
from harmos.exchange.deck.amplitudes import Amplitudes
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.curves import Course, Span
from harmos.exchange.deck.materials import Material
from harmos.exchange.findings import Refused, names_there

ALONG = 1e-3
"""Difference of the cosine with a global axis from 1 that counts as none: decks have few digits."""


class DistributedLoads:
    """Reads *DLOAD and *DSLOAD."""

    def __init__(self, acting: Acting, amplitudes: Amplitudes, materials: dict[str, Material]) -> None:
        """Adds to what acts."""
        self._acting, self._amplitudes, self._materials = acting, amplitudes, materials

    def read(self, card: Card, span: Span, at_once: bool) -> None:
        """A *DLOAD or *DSLOAD.

        Raises:
            Refused: a set, surface or amplitude is not there, or a line lacks numbers.
        """
        course = Course(span, self._amplitudes.of(card, span), at_once)
        acted: set[tuple[int, int]] = set()
        self._acting.loads.pressure_cards.append((card, acted))
        for row, words in enumerate(card.rows()):
            label = words[1].upper() if len(words) > 1 else ""
            if card.keyword == "DSLOAD" and label == "P":
                surface = self._acting.contents.surfaces.get(words[0].upper())
                if surface is None:
                    raise Refused(f"{card.place_of(row)}: *DSLOAD: there is no surface \"{words[0]}\". "
                                  f"{names_there(words[0], self._acting.contents.surfaces)}")
                sides = self._acting.solids.surface(surface)
            elif card.keyword == "DLOAD" and label == "GRAV":
                self._gravity(card, row, words, course)
                continue
            elif card.keyword == "DLOAD" and label == "CENTRIF":
                self._centrifugal(card, row, words, course)
                continue
            elif card.keyword == "DLOAD" and label[:1] == "P" and label[1:].isdecimal():
                ids = self._acting.elements(words[0], card, row)
                sides = self._acting.solids.sides(ids, label, card.place_of(row))
                if len(sides) < len(ids):
                    self._acting.findings.leave_out(card.place_of(row), f"*DLOAD {label}",
                                             f"on {len(ids) - len(sides)} elements that are no solids")
            else:
                self._acting.findings.leave_out(card.place_of(row), f"*{card.keyword} {label}", "this load is left out")
                continue
            value = card.number(words[2], row) if len(words) > 2 else 0.0
            for element, side in sides.tolist():
                course.add(self._acting.loads.pressures, (element, side), value)
                acted.add((element, side))

    def _gravity(self, card: Card, row: int, words: list[str], course: Course) -> None:
        numbers = [card.number(word, row) for word in words[2:6]]
        if len(numbers) < 4:
            raise Refused(f"{card.place_of(row)}: GRAV takes an acceleration and a direction.")
        direction = numpy.array(numbers[1:]) / max(float(numpy.linalg.norm(numbers[1:])), 1e-300)
        for part, density in self._loaded_parts(card, row, words):
            # As in CalculiX: of one direction, a later step replaces; others add up.
            course.add(self._acting.loads.body_forces, (part, tuple(float(x) for x in direction)), density * numbers[0])

    def _centrifugal(self, card: Card, row: int, words: list[str], course: Course) -> None:
        numbers = [card.number(word, row) for word in words[2:9]]
        if len(numbers) < 7 or numbers[0] < 0.0 or not any(numbers[4:7]):
            raise Refused(f"{card.place_of(row)}: CENTRIF takes the square of an angular velocity, a point and a direction.")
        axis = numpy.array(numbers[4:7]) / float(numpy.linalg.norm(numbers[4:7]))
        about = {"C3D": None, "CAX": 1}.get(self._acting.solids.family, 2)
        if about is not None and abs(abs(float(axis[about])) - 1.0) > ALONG:
            self._acting.findings.leave_out(card.place_of(row), "*DLOAD CENTRIF", f"turns about another axis than {'xyz'[about]}")
            return
        for part, _ in self._loaded_parts(card, row, words):
            key = part, tuple(numbers[1:4]), tuple(float(x) for x in axis)
            course.set(self._acting.loads.rotations, key, numbers[0])

    def _loaded_parts(self, card: Card, row: int, words: list[str]) -> list[tuple[str, float]]:
        """The parts on whose whole mass a line of *DLOAD acts, and their densities."""
        mesh = self._acting.solids.mesh
        loaded = self._acting.solids.elements(self._acting.elements(words[0], card, row))
        count = numpy.bincount(mesh.block_of(loaded), minlength=len(mesh.blocks)) if len(loaded) else numpy.zeros(
            len(mesh.blocks), dtype=int)
        result = []
        for part, blocks in mesh.parts().items():
            held = sum(int(count[block]) for block in blocks)
            if not held:
                continue
            if held < sum(len(mesh.blocks[block].connectivity) for block in blocks):
                self._acting.findings.leave_out(card.place_of(row), f"*DLOAD {words[1].upper()}", f"acts on a piece of part {part}: "
                                         "it is left out there; make that piece a section of its own")
                continue
            section = self._acting.solids.sections[self._acting.solids.section_of_part[part]]
            material = self._materials.get(section.material)
            density = material.density if material else 0.0
            if density == 0.0:
                self._acting.findings.leave_out(card.place_of(row), f"*DLOAD {words[1].upper()}",
                                         f"the material of part {part} has no density")
                continue
            result.append((part, density))
        return result
