"""Random numbers with the distributions of the campaign."""
from __future__ import annotations

import numpy as np

from .mesh import Floats
from .scene import Law, Number, Varying


class Draw:
    """A seeded source of materials, laws and histories for one scene.

    steps: load steps of the scene. length: size of the scene. base: lowest Young's modulus. contrast: decades above it.
    strain: typical one. load: typical traction [stress]. overlaps: joints may interfere. perfect: they may be Perfect.
    Where joints meet each other or a clamped face, both together would contradict each other at a node.
    """

    def __init__(self, seed: tuple[int, ...]) -> None:
        self.random = np.random.default_rng(seed)
        self.steps = int(self.random.choice([1, 2, 3, 4, 6]))
        self.length = float(10 ** self.random.uniform(-2, 2))
        self.base = float(10 ** self.random.uniform(0, 5))
        self.contrast = float(self.random.choice([0.0, 0.5, 1.5, 3.0]))
        self.strain = float(10 ** self.random.uniform(-5, -3))
        self.load = self.base * self.strain
        self.overlaps = True
        self.perfect = True

    def crossing(self) -> None:
        """Joints meet: they may interfere or be perfect, not both."""
        self.overlaps = self.chance(0.5)
        self.perfect = not self.overlaps

    def chance(self, probability: float) -> bool:
        """True that often."""
        return bool(self.random.random() < probability)

    def between(self, low: float, high: float) -> float:
        """Uniform."""
        return float(self.random.uniform(low, high))

    def magnitude(self, low: float, high: float) -> float:
        """Ten to a uniform exponent."""
        return float(10 ** self.random.uniform(low, high))

    def count(self, low: int, high: int) -> int:
        """low <= count <= high."""
        return int(self.random.integers(low, high + 1))

    def one(self, *choices: str) -> str:
        """One of them."""
        return choices[int(self.random.integers(len(choices)))]

    def young(self) -> float:
        """Young's modulus of a part, from the base value up to 10^contrast times it."""
        return self.base * self.magnitude(0, self.contrast)

    def poisson(self) -> float:
        """Ratios without and with transverse strain."""
        return float(self.random.choice([0.0, 0.2, 0.3, 0.4]))

    def steady(self) -> Floats:
        """A history that is never below a third of its end, one factor per step."""
        return np.asarray(np.clip(1 + 0.3 * self.random.standard_normal(self.steps), 0.35, 2.0))

    def changing(self) -> Floats:
        """A history that grows, goes to and fro, or jumps about, with either sign."""
        if self.steps == 1:
            return np.ones(1)
        place = np.arange(1, self.steps + 1) / self.steps
        kind = self.count(0, 2)
        if kind == 0:
            return place
        if kind == 1:
            return np.asarray(np.sin(2 * np.pi * place * self.between(0.5, 1.2)) + 1e-3)
        return self.random.uniform(-1, 1, self.steps)

    def number(self, value: float) -> Number:
        """Mostly the value itself, sometimes with a history."""
        if self.chance(0.85) or self.steps == 1:
            return value
        return Varying(value, tuple(float(f) for f in self.steady()))

    def gap(self) -> Number:
        """Mostly none, else of the size of the strains: open or interfering."""
        if self.chance(0.6):
            return 0.0
        sign = -1.0 if self.overlaps and self.chance(0.3) else 1.0
        return self.number(sign * self.strain * self.length * self.magnitude(-1.5, 0.3))

    def friction(self) -> float:
        """Coefficient, sometimes 0."""
        return 0.0 if self.chance(0.05) else self.between(0.05, 0.9)

    def stiffness(self, low: float, high: float) -> float:
        """Of springs per area, from 10^low to 10^high times modulus over size."""
        return self.base / self.length * self.magnitude(low, high)

    def contact(self, rough: float = 0.7) -> Law:
        """Contact; rough: how often it has friction."""
        if not self.chance(rough):
            return Law("Unilateral Contact", {"Gap": self.gap()})
        return Law("Coulomb Friction", {"Friction Coefficient": self.number(self.friction()), "Gap": self.gap()})

    def bond(self) -> Law:
        """A joint that does not open."""
        kind = self.count(0, 4)
        if kind == 0 and self.perfect:
            return Law("Perfect")
        if kind == 1 and self.perfect and self.overlaps:
            jump = self.strain * self.length * self.between(-0.5, 1.0)
            return Law("Preload Jump", {"Jump": self.number(jump)})
        return Law("Linear Elastic", {"Normal Stiffness": self.number(self.stiffness(-1, 3)),
                                      "Tangential Stiffness": self.number(self.stiffness(-1, 3))})

    def law(self, bonded: float = 0.35, rough: float = 0.7) -> Law:
        """Of an interface; bonded: how often it is a bond; rough: how often a contact has friction."""
        return self.bond() if self.chance(bonded) else self.contact(rough)

    def foundation(self, low: float, high: float) -> Law:
        """Springs to the ground."""
        return Law("Elastic Foundation", {"Normal Stiffness": self.stiffness(low, high),
                                          "Tangential Stiffness": self.stiffness(low, high)})
