"""Turns a lattice into a scene: parts, joints, supports, loads and responses."""
from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .draw import Draw
from .lattice import Contact, Lattice, Map
from .mesh import Floats
from .scene import Joint, Law, Part, Response, Scene, Varying, vector
from .separate import Separate

MOST_RESPONSES = 9


def rotation(draw: Draw, dimension: int) -> Floats:
    """A random rotation of space."""
    if dimension == 2:
        angle = draw.between(0, 2 * np.pi)
        return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    matrix, _ = np.linalg.qr(draw.random.standard_normal((3, 3)))
    return np.asarray(matrix * np.sign(np.linalg.det(matrix)))


class Builder:
    """Collects what belongs to a scene; directions are those of the lattice, the scene may be turned as a whole."""

    def __init__(self, draw: Draw, lattice: Lattice | Separate, carry: Map = lambda x: x) -> None:
        self.draw = draw
        self.lattice = lattice
        self.dimension = lattice.dimension
        self.turn = rotation(draw, self.dimension) if draw.chance(0.3) else np.eye(self.dimension)
        self.mesh = lattice.build(self._types(), lambda x: carry(x) @ self.turn.T)
        self.parts = {name: Part(name, draw.young(), draw.poisson()) for name in lattice.parts}
        self.joints: list[Joint] = []
        self.responses: list[Response] = []

    def _types(self) -> dict[str, str]:
        if self.dimension == 3:
            kind = self.draw.one("HEX8", "HEX8", "TET4")
            return {part: kind for part in self.lattice.parts}
        if self.draw.chance(0.5):
            return {part: "QUAD4" for part in self.lattice.parts}
        return {part: self.draw.one("QUAD4", "TRI3") for part in self.lattice.parts}

    def join(self, law_of: Callable[[Contact], Law]) -> None:
        """Joins all parts where they touch."""
        for contact in self.lattice.contacts():
            name = contact.side1.removesuffix("_1")
            self.joints.append(Joint(name, contact.side1, contact.side2, law_of(contact)))

    def support(self, name: str, part: str, axis: int, end: int, law: Law, *ranges: tuple[int, int]) -> None:
        """A boundary on outer faces, see Lattice.outer."""
        self.joints.append(Joint(name, self.lattice.outer(name, part, axis, end, *ranges), None, law))

    def clamp(self, name: str, part: str, axis: int, end: int, *ranges: tuple[int, int]) -> None:
        """No displacement."""
        law = Law("Prescribed Displacement", {a: 0.0 for a in "XYZ"[:self.dimension]})
        self.support(name, part, axis, end, law, *ranges)

    def move(self, name: str, part: str, axis: int, end: int, histories: Floats, *ranges: tuple[int, int]) -> None:
        """Displacement [step, axis of the lattice]."""
        self.support(name, part, axis, end, self._vector_law("Prescribed Displacement", histories), *ranges)

    def pull(self, name: str, part: str, axis: int, end: int, histories: Floats, *ranges: tuple[int, int]) -> None:
        """Traction [step, axis of the lattice]."""
        self.support(name, part, axis, end, self._vector_law("Prescribed Traction", histories), *ranges)

    def press(self, name: str, part: str, axis: int, end: int, history: Floats, *ranges: tuple[int, int]) -> None:
        """Pressure [step] on flat faces."""
        size = float(abs(history).max())
        pressure = Varying(size, vector((history / size).tolist()))
        self.support(name, part, axis, end, Law("Pressure", {"Pressure": pressure}), *ranges)

    def weigh(self, histories: Floats, parts: Sequence[str] = ()) -> None:
        """Body force [step, axis of the lattice] of the parts, none named: of all."""
        numbers = self._components(histories)
        for name in parts or list(self.parts):
            part = self.parts[name]
            self.parts[name] = Part(name, part.young, part.poisson, numbers)

    def _components(self, histories: Floats) -> tuple[Varying | float, ...]:
        turned = histories @ self.turn.T
        sizes = abs(turned).max(axis=0)
        return tuple(Varying(float(size), vector(column / size)) if size > 0 else 0.0
                     for size, column in zip(sizes, turned.T))

    def _vector_law(self, kind: str, histories: Floats) -> Law:
        return Law(kind, dict(zip("XYZ", self._components(histories))))

    def _direction(self) -> tuple[float, ...]:
        direction = self.draw.random.standard_normal(self.dimension)
        return vector((direction / np.linalg.norm(direction)).tolist())

    def _responses_of(self, joint: Joint) -> list[Response]:
        if joint.law.type in ("Prescribed Traction", "Pressure"):
            return [Response("u_" + joint.name, "Mean Displacement", joint.side1, {"Direction": self._direction()})]
        result = [Response("F_" + joint.name, "Interface Force", joint.name, {"Direction": self._direction()})]
        match self.draw.count(0, 5):
            case 0:
                result.append(Response("N_" + joint.name, "Bolt Force", joint.name))
            case 1:
                vectors = {"Centre": vector(self.mesh.nodes.mean(axis=0))}
                if self.dimension == 3:
                    vectors["Axis"] = self._direction()
                result.append(Response("M_" + joint.name, "Interface Moment", joint.name, vectors))
            case 2 if joint.law.type in ("Coulomb Friction", "Unilateral Contact"):
                field = self.draw.one("Contact Pressure", "Opening", "Slip", "Tangential Traction", "Normal Traction")
                result.append(Response("max_" + joint.name, "Maximum", joint.name, {}, field))
            case 3 if joint.law.type in ("Coulomb Friction", "Cohesive Zone"):
                result.append(Response("D_" + joint.name, "Dissipation", joint.name))
            case 4:
                result.append(Response("u_" + joint.name, "Mean Displacement", joint.side1,
                                       {"Direction": self._direction()}))
        return result

    def finish(self) -> Scene:
        """The scene, with responses of its joints and an accuracy."""
        candidates = [response for joint in self.joints for response in self._responses_of(joint)]
        if len(candidates) > MOST_RESPONSES:
            keep = sorted(self.draw.random.choice(len(candidates), MOST_RESPONSES, replace=False))
            candidates = [candidates[i] for i in keep]
        kinematics = "3-D" if self.dimension == 3 else self.draw.one("Plane Strain", "Plane Strain", "Plane Stress")
        thickness = 1.0 if self.dimension == 3 else self.draw.length * self.draw.magnitude(-1, 0)
        accuracy = float(self.draw.random.choice([1e-2, 1e-2, 3e-3, 1e-3, 1e-3, 1e-4, 1e-5]))
        pieces = {}
        if self.draw.chance(0.1):
            largest = max(self.mesh.blocks, key=lambda block: len(block.nodes))
            if len(largest.nodes) >= 12:
                pieces[largest.name] = 2
        return Scene(self.mesh, kinematics, thickness, list(self.parts.values()), self.joints, self.draw.steps,
                     accuracy, candidates, pieces)
