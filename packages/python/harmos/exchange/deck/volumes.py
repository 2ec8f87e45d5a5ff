"""Loads on the volume of parts: rotation and temperatures of a deck as lists of a scene."""
import collections
import math

import numpy

from harmos.exchange.deck.curves import UNLOADED, Histories, Points
from harmos.exchange.deck.loads import Loads
from harmos.exchange.deck.materials import Material
from harmos.exchange.deck.solids import Solids
from harmos.exchange.findings import Findings
from harmos.exchange.scene import SceneList


class VolumeWriter:
    """Writes the lists Loads and Temperatures of a scene, and what materials need for them."""

    def __init__(self, solids: Solids, materials: dict[str, Material], names: dict[str, str], scene: SceneList,
                 histories: Histories, findings: Findings) -> None:
        """Adds to this scene; `names`: of the material in it, by part."""
        self._solids, self._materials, self._names = solids, materials, names
        self._scene, self._histories, self._findings = scene, histories, findings
        self._given: set[tuple[str, str]] = set()

    def write(self, loads: Loads) -> None:
        """All of them."""
        self._rotations(loads)
        self._temperatures(loads.temperatures)

    def _material(self, part: str) -> "Material | None":
        return self._materials.get(self._solids.sections[self._solids.section_of_part[part]].material)

    def _give(self, part: str, entry: str, value: float) -> None:
        """Sets an entry of the material of a part, once."""
        if (self._names[part], entry) not in self._given:
            self._given.add((self._names[part], entry))
            self._scene.child("Materials").child(self._names[part]).set(entry, value)

    def _rotations(self, loads: Loads) -> None:
        groups: dict[tuple[tuple[float, ...], tuple[float, ...], Points], list[str]] = collections.defaultdict(list)
        for (part, point, axis), points in loads.rotations.items():
            groups[point, axis, points].append(part)
        for number, ((point, axis, points), parts) in enumerate(groups.items(), 1):
            rotation = self._scene.child("Loads").child(f"rotation_{number}").set("Type", "Rotation").set("Parts", parts)
            if self._solids.family == "C3D":
                rotation.set("Point", list(point)).set("Axis", list(axis))
            elif self._solids.family != "CAX":
                rotation.set("Point", list(point[:2]))
            self._histories.set(rotation, "Angular Velocity", _rooted(points, loads.steps))
            for part in parts:
                material = self._material(part)
                assert material is not None, "parts without density do not turn"
                self._give(part, "Density", material.density)

    def _temperatures(self, temperatures: dict[int, Points]) -> None:
        mesh = self._solids.mesh
        groups: dict[Points, list[str]] = collections.defaultdict(list)
        for part, blocks in mesh.parts().items():
            material = self._material(part)
            if material is None or not _strains(material):
                if material is not None and material.expansion:
                    self._findings.leave_out(material.card.place, "*EXPANSION, TYPE=ORTHO", "of an isotropic material")
                continue
            nodes = numpy.unique(numpy.concatenate([mesh.blocks[block].connectivity.reshape(-1) for block in blocks]))
            curves = {temperatures.get(node, UNLOADED) for node in nodes.tolist()}
            if len(curves) > 1:
                self._findings.leave_out(material.card.place, "*TEMPERATURE", f"of part {part}, whose nodes have different "
                                         "ones: write them as a nodal variable and use the type Nodal Variable")
                continue
            curve = curves.pop()
            if len(curve) > 1:
                groups[curve].append(part)
        for number, (points, parts) in enumerate(groups.items(), 1):
            temperature = self._scene.child("Temperatures").child(f"temperature_{number}")
            temperature.set("Type", "Prescribed").set("Parts", parts).set("Reference", points[0][1])
            self._histories.set(temperature, "Temperature", points)
            for part in parts:
                material = self._material(part)
                assert material is not None, "parts that do not expand are left out"
                for entry, value in _strains(material).items():
                    self._give(part, entry, value)


def _strains(material: Material) -> dict[str, float]:
    """The entries for thermal strains that a material of this kind has in a scene."""
    is_isotropic = "Young's Modulus" in material.entries or not material.entries
    if is_isotropic:
        return {entry: value for entry, value in material.expansion.items() if entry == "Thermal Expansion"}
    value = material.expansion.get("Thermal Expansion")
    return material.expansion if value is None else {f"Thermal Expansion {axis}": value for axis in "123"}


def _rooted(points: Points, steps: list[tuple[str, float, int]]) -> Points:
    """The square root of a curve, at the ends of all load steps, where alone it counts."""
    times = [time for time, _ in points]
    values = [value for _, value in points]
    result = [(0.0, math.sqrt(max(values[0], 0.0)))]
    begin = 0.0
    for _, duration, increments in steps:
        for increment in range(1, increments + 1):
            time = begin + duration * increment / increments
            result.append((time, math.sqrt(max(float(numpy.interp(time, times, values)), 0.0))))
        begin += duration
    return tuple(result)
