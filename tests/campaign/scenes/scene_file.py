"""Writes a scene as the files that Harmos reads: scene.xml and mesh.e."""
from __future__ import annotations

import pathlib
import xml.etree.ElementTree as xml

from .exodus import write_exodus
from .scene import Joint, Law, Number, Response, Scene, Varying


class _Histories:
    """Names the factors that numbers are multiplied with."""

    def __init__(self, parent: xml.Element) -> None:
        self._list = sublist(parent, "Histories")
        self._names: dict[tuple[float, ...], str] = {}

    def name(self, factors: tuple[float, ...]) -> str:
        if factors not in self._names:
            name = self._names[factors] = f"history{len(self._names)}"
            table = sublist(self._list, name)
            entry(table, "Type", "Table")
            entry(table, "Times", tuple(float(t) for t in range(1, len(factors) + 1)))
            entry(table, "Values", factors)
        return self._names[factors]


def sublist(parent: xml.Element, name: str) -> xml.Element:
    """A list in a list."""
    return xml.SubElement(parent, "ParameterList", name=name)


def entry(parent: xml.Element, name: str, value: str | int | float | tuple[float, ...]) -> None:
    """An entry of a list, of the type of its value."""
    if isinstance(value, tuple):
        kind, text = "Array(double)", "{" + ", ".join(repr(float(x)) for x in value) + "}"
    elif isinstance(value, float):
        kind, text = "double", repr(float(value))
    else:
        kind, text = "int" if isinstance(value, int) else "string", str(value)
    xml.SubElement(parent, "Parameter", name=name, type=kind, value=text)


def _number(parent: xml.Element, name: str, number: Number, histories: _Histories) -> None:
    if isinstance(number, Varying):
        entry(parent, name, number.value)
        entry(parent, name + " History", histories.name(number.factors))
    else:
        entry(parent, name, float(number))


def _law(parent: xml.Element, law: Law, histories: _Histories) -> None:
    element = sublist(parent, "Law")
    entry(element, "Type", law.type)
    for name, number in law.parameters.items():
        _number(element, name, number, histories)
    for name, word in law.words.items():
        entry(element, name, word)


def _joint(parent: xml.Element, joint: Joint, histories: _Histories) -> None:
    element = sublist(parent, joint.name)
    if joint.side2 is None:
        entry(element, "Side Set", joint.side1)
    else:
        entry(element, "Side 1", joint.side1)
        entry(element, "Side 2", joint.side2)
    if joint.points_on is not None:
        entry(element, "Points On", f"Side {joint.points_on}")
    if joint.reach is not None:
        entry(element, "Search Distance", joint.reach)
    _law(element, joint.law, histories)


def _response(parent: xml.Element, response: Response) -> None:
    element = sublist(parent, response.name)
    entry(element, "Type", response.type)
    if response.type == "Mean Displacement":
        entry(element, "Side Set", response.target)
    elif response.type in ("Maximum", "Dissipation"):
        xml.SubElement(element, "Parameter", name="Interfaces", type="Array(string)", value="{" + response.target + "}")
    else:
        entry(element, "Interface", response.target)
    if response.field:
        entry(element, "Field", response.field)
    for name, components in response.vectors.items():
        entry(element, name, components)


def scene_element(scene: Scene) -> xml.Element:
    """The list "Harmos" of a scene whose mesh is mesh.e beside it."""
    root = xml.Element("ParameterList", name="Harmos")
    mesh = sublist(root, "Mesh")
    entry(mesh, "Type", "Exodus")
    entry(mesh, "File", "mesh.e")
    model = sublist(root, "Model")
    entry(model, "Kinematics", scene.kinematics)
    if scene.kinematics != "3-D":
        entry(model, "Thickness", float(scene.thickness))
    histories = _Histories(root)
    materials, parts = sublist(root, "Materials"), sublist(root, "Parts")
    for part in scene.parts:
        material = sublist(materials, part.name)
        entry(material, "Type", "Isotropic")
        entry(material, "Young's Modulus", float(part.young))
        entry(material, "Poisson's Ratio", float(part.poisson))
        element = sublist(parts, part.name)
        entry(element, "Material", part.name)
        if part.name in scene.pieces:
            entry(element, "Pieces", scene.pieces[part.name])
        if part.body_force:
            force = sublist(element, "Body Force")
            for axis, number in zip("XYZ", part.body_force):
                _number(force, axis, number, histories)
    interfaces, boundaries = sublist(root, "Interfaces"), sublist(root, "Boundaries")
    for joint in scene.joints:
        _joint(boundaries if joint.side2 is None else interfaces, joint, histories)
    step = sublist(sublist(root, "Steps"), "all")
    entry(step, "Duration", float(scene.steps))
    entry(step, "Increments", scene.steps)
    entry(sublist(root, "Solver"), "Accuracy", float(scene.accuracy))
    responses = sublist(root, "Responses")
    for response in scene.responses:
        _response(responses, response)
    return root


def write_scene(scene: Scene, folder: pathlib.Path) -> pathlib.Path:
    """Writes scene.xml and mesh.e into a folder, which is made; returns the path of the scene."""
    folder.mkdir(parents=True, exist_ok=True)
    write_exodus(scene.mesh, folder / "mesh.e")
    root = scene_element(scene)
    xml.indent(root)
    path = folder / "scene.xml"
    path.write_text('<?xml version="1.0"?>\n' + xml.tostring(root, encoding="unicode") + "\n")
    return path
