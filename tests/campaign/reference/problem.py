"""The discrete problem of a scene: assembled stiffness, loads, and the points of its joints with their conditions.

    K u + W^t (a t) = F,    delta = W u,    t and delta obey the law of their point

u: displacements of all nodes; W: jump w2 - w1 in the frame of every point; t: traction on side 1 [stress]; a: area.
"""
from __future__ import annotations

import dataclasses

import numpy as np
from scipy import sparse

from ..scenes.mesh import Floats, Integers
from ..scenes.scene import Scene, at_step
from .elements import elasticity, nodal_volumes, stiffness
from .laws import GLOBAL, Kind, conditions
from .surfaces import surface_of


@dataclasses.dataclass
class Problem:
    """Matrices and vectors of a scene.

    stiffness: K [dof, dof]. loads: F [step, dof]. jump: W [row, dof], rows point by point, dimension rows each. area:
    per row. kind: of Kind, per row. value: the number of each condition [step, row]. frame: [point, component, axis].
    node1, node2: per point, node2 is -1 on a boundary. points: of each joint without loads, by name. spring: of
    each row, the stiffness of the nodes it joins [force/length]. normal: outward on side 1 [point, axis].
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
    node1: Integers
    node2: Integers
    points: dict[str, slice]
    spring: Floats
    normal: Floats

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


def _jump(node1: Integers, node2: Integers, frame: Floats, size: int) -> sparse.csr_matrix:
    """w2 - w1 in the frame of every point."""
    count, d, _ = frame.shape
    row = np.arange(count * d).reshape(count, d, 1) + np.zeros((1, 1, d), dtype=np.int64)
    matrix = sparse.csr_matrix((count * d, size))
    for nodes, sign in ((node1, -1.0), (node2, 1.0)):
        held = nodes >= 0
        column = d * nodes[:, None, None] + np.arange(d) + np.zeros((1, d, 1), dtype=np.int64)
        matrix = matrix + sparse.csr_matrix((sign * frame[held].ravel(), (row[held].ravel(), column[held].ravel())),
                                            (count * d, size))
    return matrix.tocsr()


def _node_springs(matrix: sparse.csr_matrix, d: int, node1: Integers, node2: Integers) -> Floats:
    """Two nodes in series, by the mean diagonal of each, per row."""
    diagonal = matrix.diagonal().reshape(-1, d).mean(axis=1)
    softness = 1 / diagonal[node1] + np.where(node2 >= 0, 1 / diagonal[node2], 0.0)
    return np.repeat(1 / softness, d)


def assemble(scene: Scene) -> Problem:
    """The discrete problem of a scene."""
    mesh, d = scene.mesh, scene.mesh.dimension
    thickness = scene.thickness if d == 2 else 1.0
    matrix, loads = _assemble(scene)
    points: dict[str, slice] = {}
    node1, node2, area, frame, normal, kind, value = [], [], [], [], [], [], []
    begin = 0
    for joint in scene.joints:
        surface = surface_of(joint, mesh, thickness)
        count = len(surface.node1)
        of_law = conditions(joint.law, d, scene.steps)
        axes = np.tile(np.eye(d), (count, 1, 1)) if joint.law.type in GLOBAL else surface.frame
        if all(condition.kind == Kind.LOAD for condition in of_law):
            for step in range(scene.steps):
                traction = np.array([condition.values[step] for condition in of_law])
                force = np.einsum("pci,c->pi", axes, traction) * surface.area[:, None]
                np.add.at(loads[step].reshape(-1, d), surface.node1, force)
            continue
        points[joint.name] = slice(begin, begin + count)
        begin += count
        node1.append(surface.node1)
        node2.append(surface.node2)
        area.append(np.repeat(surface.area, d))
        frame.append(axes)
        normal.append(surface.frame[:, 0])
        kind.append(np.tile([int(condition.kind) for condition in of_law], count))
        value.append(np.tile(np.array([condition.values for condition in of_law]).T, (1, count)))
    first, second, axes = np.concatenate(node1), np.concatenate(node2), np.concatenate(frame)
    return Problem(d, scene.steps, mesh.nodes, [np.unique(block.nodes) for block in mesh.blocks], matrix, loads,
                   _jump(first, second, axes, matrix.shape[0]), np.concatenate(area), np.concatenate(kind),
                   np.concatenate(value, axis=1), axes, first, second, points, _node_springs(matrix, d, first, second),
                   np.concatenate(normal))
