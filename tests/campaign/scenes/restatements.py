"""Restatements of a scene: the same problem in other words, whose responses are known multiples of the scene's own."""
from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping

import numpy as np

from .mesh import Block, Integers, Mesh, Side
from .scene import Joint, Law, Number, Part, Response, Scene, Varying

# Responses that act from side 1 on side 2 change their sign with the sides.
_ONE_SIDED = ("Interface Force", "Interface Moment")
# Exponents of length and stress.
_LAW_DIMENSIONS: dict[str, tuple[int, int]] = {
    "Gap": (1, 0), "Jump": (1, 0), "X": (1, 0), "Y": (1, 0), "Z": (1, 0), "Friction Coefficient": (0, 0),
    "Pressure": (0, 1), "Normal Stiffness": (-1, 1), "Tangential Stiffness": (-1, 1)}
_TRACTION_DIMENSIONS = {"X": (0, 1), "Y": (0, 1), "Z": (0, 1)}
_RESPONSE_DIMENSIONS = {"Mean Displacement": (1, 0), "Interface Force": (2, 1), "Bolt Force": (2, 1),
                        "Interface Moment": (3, 1), "Dissipation": (3, 1)}
_FIELD_DIMENSIONS = {"Opening": (1, 0), "Slip": (1, 0)}


@dataclasses.dataclass(frozen=True)
class Restatement:
    """factors: of every response, by which the scene's own value is multiplied. arguments: of the program."""
    scene: Scene
    factors: Mapping[str, float]
    arguments: tuple[str, ...] = ()


def _same(scene: Scene) -> dict[str, float]:
    return {response.name: 1.0 for response in scene.responses}


def swapped(scene: Scene, _: np.random.Generator) -> Restatement:
    """The two sides of every interface change places."""
    def swap(joint: Joint) -> Joint:
        if joint.side2 is None:
            return joint
        points_on = None if joint.points_on is None else 3 - joint.points_on
        return dataclasses.replace(joint, side1=joint.side2, side2=joint.side1, points_on=points_on)

    two_sided = {joint.name for joint in scene.joints if joint.side2 is not None}
    factors = {response.name: -1.0 if response.type in _ONE_SIDED and response.target in two_sided else 1.0
               for response in scene.responses}
    return Restatement(dataclasses.replace(scene, joints=[swap(joint) for joint in scene.joints]), factors)


def _turned_in_itself(kind: str, nodes: Integers) -> Integers:
    """The same elements, numbered from the next corner; only of kinds whose sides then only move on by one."""
    order = {"TRI3": (1, 2, 0), "QUAD4": (1, 2, 3, 0), "HEX8": (1, 2, 3, 0, 5, 6, 7, 4)}.get(kind)
    return nodes if order is None else nodes[:, order]


def _side_in_turned(kind: str, side: int) -> int:
    corners = {"TRI3": 3, "QUAD4": 4, "HEX8": 4}.get(kind)
    return side if corners is None or side >= corners else (side - 1) % corners


def renumbered(scene: Scene, random: np.random.Generator) -> Restatement:
    """Nodes, elements, sides, blocks, parts and joints in another order; elements begin at another corner."""
    mesh = scene.mesh
    place = random.permutation(len(mesh.nodes))
    nodes = np.empty_like(mesh.nodes)
    nodes[place] = mesh.nodes
    first = np.cumsum([0] + [len(block.nodes) for block in mesh.blocks])
    blocks: list[Block] = []
    moved: dict[int, tuple[int, str]] = {}
    count = 0
    for index in random.permutation(len(mesh.blocks)):
        block = mesh.blocks[index]
        order = random.permutation(len(block.nodes))
        for new, old in enumerate(order):
            moved[int(first[index] + old)] = (count + new, block.type)
        blocks.append(Block(block.name, block.type, _turned_in_itself(block.type, place[block.nodes[order]])))
        count += len(order)

    def side(old: Side) -> Side:
        element, kind = moved[old.element]
        return Side(element, _side_in_turned(kind, old.side))

    sets = {name: [side(sides[i]) for i in random.permutation(len(sides))] for name, sides in mesh.side_sets.items()}
    names = list(sets)
    random.shuffle(names)
    return Restatement(dataclasses.replace(scene, mesh=Mesh(nodes, blocks, {name: sets[name] for name in names}),
                                    parts=[scene.parts[i] for i in random.permutation(len(scene.parts))],
                                    joints=[scene.joints[i] for i in random.permutation(len(scene.joints))]),
                _same(scene))


def _scaled(number: Number, factor: float) -> Number:
    if isinstance(number, Varying):
        return Varying(number.value * factor, number.factors)
    return number * factor


def _in_units(scene: Scene, length: float, stress: float) -> Restatement:
    def factor(dimensions: tuple[int, int]) -> float:
        return float(length ** dimensions[0] * stress ** dimensions[1])

    def law(of: Law) -> Law:
        known = dict(_LAW_DIMENSIONS)
        if "Traction" in of.type:
            known |= _TRACTION_DIMENSIONS
        return Law(of.type, {name: _scaled(value, factor(known[name])) for name, value in of.parameters.items()})

    def response(of: Response) -> Response:
        vectors = {name: tuple(length * x for x in value) if name == "Centre" else value
                   for name, value in of.vectors.items()}
        return dataclasses.replace(of, vectors=vectors)

    def dimensions(of: Response) -> tuple[int, int]:
        return _FIELD_DIMENSIONS.get(of.field, (0, 1)) if of.type == "Maximum" else _RESPONSE_DIMENSIONS[of.type]

    scene_in_units = dataclasses.replace(
        scene, mesh=dataclasses.replace(scene.mesh, nodes=scene.mesh.nodes * length),
        thickness=scene.thickness * length,
        parts=[Part(part.name, part.young * stress, part.poisson,
                    tuple(_scaled(force, stress / length) for force in part.body_force)) for part in scene.parts],
        joints=[dataclasses.replace(joint, law=law(joint.law), reach=None if joint.reach is None else joint.reach * length)
                for joint in scene.joints],
        responses=[response(of) for of in scene.responses])
    return Restatement(scene_in_units, {of.name: factor(dimensions(of)) for of in scene.responses})


def in_metres(scene: Scene, _: np.random.Generator) -> Restatement:
    """Metre and pascal for millimetre and megapascal."""
    return _in_units(scene, 1e-3, 1e6)


def in_odd_units(scene: Scene, random: np.random.Generator) -> Restatement:
    """Units of length and stress that are no powers of ten."""
    return _in_units(scene, float(np.exp(random.uniform(-6, 6))), float(np.exp(random.uniform(-12, 12))))


def turned(scene: Scene, _: np.random.Generator) -> Restatement:
    """Axes change their names: x is y, y is z, z is x; in the plane a quarter turn."""
    plane = scene.mesh.dimension == 2

    def turn(vector: tuple[Number, ...]) -> tuple[Number, ...]:
        if plane:
            return (_scaled(vector[1], -1.0), vector[0])
        return (vector[2], vector[0], vector[1])

    def law(of: Law) -> Law:
        axes = "XYZ"[:scene.mesh.dimension]
        if not set(of.parameters) & set(axes):
            return of
        components = turn(tuple(of.parameters.get(axis, 0.0) for axis in axes))
        kept = {axis: value for axis, value in zip(axes, components)}
        given = turn(tuple(float(axis in of.parameters) for axis in axes))
        others = {name: value for name, value in of.parameters.items() if name not in axes}
        return Law(of.type, others | {axis: kept[axis] for axis, is_given in zip(axes, given) if is_given})

    def response(of: Response) -> Response:
        return dataclasses.replace(of, vectors={name: value if plane and name == "Axis" else turn(value)
                                                for name, value in of.vectors.items()})

    nodes = scene.mesh.nodes
    moved = np.column_stack((-nodes[:, 1], nodes[:, 0])) if plane else nodes[:, (2, 0, 1)]
    return Restatement(dataclasses.replace(
        scene, mesh=dataclasses.replace(scene.mesh, nodes=moved),
        parts=[dataclasses.replace(part, body_force=turn(part.body_force) if part.body_force else ())
               for part in scene.parts],
        joints=[dataclasses.replace(joint, law=law(joint.law)) for joint in scene.joints],
        responses=[response(of) for of in scene.responses]), _same(scene))


def moved_away(scene: Scene, random: np.random.Generator) -> Restatement:
    """At a place a thousand times its size away."""
    nodes = scene.mesh.nodes
    extent = float(np.linalg.norm(nodes.max(axis=0) - nodes.min(axis=0)))
    shift = random.normal(size=scene.mesh.dimension)
    shift *= 1e3 * extent / np.linalg.norm(shift)

    def response(of: Response) -> Response:
        vectors = {name: tuple(float(x) for x in np.array(value) + shift) if name == "Centre" else value
                   for name, value in of.vectors.items()}
        return dataclasses.replace(of, vectors=vectors)

    return Restatement(dataclasses.replace(scene, mesh=dataclasses.replace(scene.mesh, nodes=nodes + shift),
                                    responses=[response(of) for of in scene.responses]), _same(scene))


def searched_otherwise(scene: Scene, random: np.random.Generator) -> Restatement:
    """Another scale of the search direction."""
    scale = float(np.exp(random.choice([-1, 1]) * np.log(10)))
    return Restatement(scene, _same(scene), ("--set", f"Solver/Search Direction/Scale={scale!r}"))


def cut(scene: Scene, random: np.random.Generator) -> Restatement:
    """One part in two or three pieces."""
    part = scene.parts[random.integers(len(scene.parts))].name
    return Restatement(dataclasses.replace(scene, pieces=scene.pieces | {part: int(random.integers(2, 4))}), _same(scene))


RESTATEMENTS: dict[str, Callable[[Scene, np.random.Generator], Restatement]] = {
    "swapped": swapped, "renumbered": renumbered, "in metres": in_metres, "in odd units": in_odd_units,
    "turned": turned, "moved away": moved_away, "searched otherwise": searched_otherwise, "cut": cut}
