"""The discrete problem of a scene: assembled stiffness, loads, and the points of its joints with their conditions.

    K u + W^t (a t) = F,    delta = W u,    t and delta obey the law of their point

u: displacements of all nodes; W: jump w2 - w1 in the frame of every point; t: traction on side 1 [stress]; a: area.
"""
from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt
from scipy import sparse

from ..scenes.mesh import Floats, Integers, Mesh
from ..scenes.scene import Joint, Scene, at_step
from .elements import elasticity, nodal_volumes, stiffness
from .laws import GLOBAL, Condition, Kind, conditions
from .mortar import Held
from .surfaces import frame_of, nodal_areas, surface_of

# Parts of a cell's edge that are not cut any more, in the plane, where few are cut, and in space.
FINEST = 64


@dataclasses.dataclass
class Problem:
    """Matrices and vectors of a scene.

    stiffness: K [dof, dof]. loads: F [step, dof]. jump: W [row, dof], rows point by point, dimension rows each. area:
    per row. kind: of Kind, per row. value: the number of each condition [step, row]. frame: [point, component, axis].
    place: [point, axis]. two_sided: per point, not so on a boundary. points: of each joint without loads, by name.
    spring: of each row, the stiffness of the nodes it joins [force/length]. normal: outward on side 1 [point, axis].
    uncertain: largest share of a join's area that its quadrature does not resolve. gap: of the geometry, per point.
    """
    dimension: int
    steps: int
    nodes: Floats
    parts: list[Integers]
    stiffness: sparse.csr_matrix
    loads: Floats
    jump: sparse.csr_matrix
    area: Floats
    kind: Integers
    value: Floats
    frame: Floats
    place: Floats
    two_sided: npt.NDArray[np.bool_]
    points: dict[str, slice]
    spring: Floats
    normal: Floats
    uncertain: float
    gap: Floats

    @property
    def contact_points(self) -> Integers:
        """Points with unilateral contact, with or without friction."""
        return np.flatnonzero(self.kind[::self.dimension] == Kind.CONTACT)

    @property
    def friction(self) -> Floats:
        """Coefficient [step, point] of the points with contact; 0 where there is no friction."""
        rows = self.contact_points * self.dimension + 1
        return np.where(self.kind[rows] == Kind.FRICTION, self.value[:, rows], 0.0)


def _assemble(scene: Scene) -> tuple[sparse.csr_matrix, Floats]:
    mesh, d = scene.mesh, scene.mesh.dimension
    rows, columns, entries = [], [], []
    loads = np.zeros((scene.steps, len(mesh.nodes), d))
    for block in mesh.blocks:
        part = next(p for p in scene.parts if p.name == block.name)
        material = elasticity(part.young, part.poisson, scene.kinematics)
        for nodes in block.nodes:
            dofs = (d * nodes[:, None] + np.arange(d)).ravel()
            rows.append(np.repeat(dofs, len(dofs)))
            columns.append(np.tile(dofs, len(dofs)))
            entries.append(stiffness(block.type, mesh.nodes[nodes], material, scene.thickness).ravel())
            if part.body_force:
                volumes = nodal_volumes(block.type, mesh.nodes[nodes], scene.thickness)
                for step in range(scene.steps):
                    force = [at_step(number, step) for number in part.body_force]
                    np.add.at(loads[step], nodes, np.outer(volumes, force))
    size = d * len(mesh.nodes)
    matrix = sparse.coo_matrix((np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), (size, size))
    return matrix.tocsr(), loads.reshape(scene.steps, size)


def _jump(trace1: sparse.csr_matrix, trace2: sparse.csr_matrix, frame: Floats) -> sparse.csr_matrix:
    """w2 - w1 in the frame of every point."""
    count, d, _ = frame.shape
    turn = sparse.bsr_matrix((frame, np.arange(count), np.arange(count + 1)), (count * d, count * d))
    return (turn @ sparse.kron(trace2 - trace1, sparse.identity(d))).tocsr()


def _springs(matrix: sparse.csr_matrix, d: int, *traces: sparse.csr_matrix) -> Floats:
    """The nodes of every point in series, by the mean diagonal of each, per row."""
    soft = 1 / matrix.diagonal().reshape(-1, d).mean(axis=1)
    return np.repeat(1 / sum(trace.power(2) @ soft for trace in traces), d)


def assemble(scene: Scene, finest: int = FINEST) -> Problem:
    """The discrete problem of a scene; finest: of the quadrature of joins, see join()."""
    mesh, d = scene.mesh, scene.mesh.dimension
    thickness = scene.thickness if d == 2 else 1.0
    matrix, loads = _assemble(scene)
    points: dict[str, slice] = {}
    trace1, trace2, area, frame, normal, place, two_sided, kind, value = [], [], [], [], [], [], [], [], []
    gap: list[Floats] = []
    begin, uncertain = 0, 0.0
    held = _held(scene, thickness)
    for joint in scene.joints:
        of_law = conditions(joint.law, d, scene.steps)
        if all(condition.kind == Kind.LOAD for condition in of_law):
            _load(joint, of_law, mesh, thickness, loads)
            continue
        carries_shear = of_law[1].kind in (Kind.TIED, Kind.SPRING, Kind.FRICTION)
        surface = surface_of(joint, mesh, thickness, finest, held if carries_shear else {})
        count = len(surface.area)
        points[joint.name] = slice(begin, begin + count)
        begin += count
        uncertain = max(uncertain, surface.uncertain)
        trace1.append(surface.trace1)
        trace2.append(sparse.csr_matrix(surface.trace1.shape) if surface.trace2 is None else surface.trace2)
        area.append(np.repeat(surface.area, d))
        frame.append(np.tile(np.eye(d), (count, 1, 1)) if joint.law.type in GLOBAL else surface.frame)
        normal.append(surface.frame[:, 0])
        place.append(surface.place)
        gap.append(surface.gap)
        two_sided.append(np.full(count, surface.trace2 is not None))
        kind.append(np.tile([int(condition.kind) for condition in of_law], count))
        of_step = np.tile(np.array([condition.values for condition in of_law]).T, (1, count))
        of_step[:, ::d] += np.where(kind[-1][::d] == Kind.CONTACT, surface.gap, 0.0)
        value.append(of_step)
    first, second, axes = sparse.vstack(trace1), sparse.vstack(trace2), np.concatenate(frame)
    return Problem(d, scene.steps, mesh.nodes, [np.unique(block.nodes) for block in mesh.blocks], matrix, loads,
                   _jump(first, second, axes), np.concatenate(area), np.concatenate(kind),
                   np.concatenate(value, axis=1), axes, np.concatenate(place), np.concatenate(two_sided), points,
                   _springs(matrix, d, first, second), np.concatenate(normal), uncertain, np.concatenate(gap))


def _held(scene: Scene, thickness: float) -> Held:
    """What boundaries hold, by node of the mesh."""
    held: Held = {}
    for joint in scene.joints:
        of_law = conditions(joint.law, scene.mesh.dimension, scene.steps)
        if joint.side2 is not None or all(condition.kind != Kind.TIED for condition in of_law):
            continue
        areas = nodal_areas(scene.mesh, joint.side1, thickness)
        for node, normal in zip(areas.nodes, areas.normal):
            frame = np.eye(len(normal)) if joint.law.type in GLOBAL else frame_of(normal)
            directions = [axis for axis, condition in zip(frame, of_law) if condition.kind == Kind.TIED]
            held.setdefault(int(node), []).extend(directions)
    return held


def _load(joint: Joint, of_law: list[Condition], mesh: Mesh, thickness: float, loads: Floats) -> None:
    """Adds the nodal forces of a boundary with a given traction to loads [step, dof]."""
    areas = nodal_areas(mesh, joint.side1, thickness)
    for step, load in enumerate(loads):
        traction = np.array([condition.values[step] for condition in of_law])
        force = np.outer(areas.share, traction) if joint.law.type in GLOBAL else areas.flux * traction[0]
        np.add.at(load.reshape(-1, mesh.dimension), areas.nodes, force)
