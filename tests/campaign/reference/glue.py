"""Cohesive zones on the assembled problem: the law, what balance a state lacks, and Newton's method from it.

    K u + W^t a (t - p n) = 0,    t = (1 - d) K delta,    p >= 0, delta_n >= 0, p delta_n = 0

W, a: see problem.py; d: damage; p: pressure of contact, n the normal. The opening is <delta_n>; lambda its length
together with the slip. Where lambda passes the onset, d follows the softening curve of the energy that Benzeggagh and
Kenane (1996) give to the share of shear, and it never falls (Turon, Camanho, Costa, Davila 2006).
"""
from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt
from scipy import optimize, sparse
from scipy.sparse.linalg import spsolve

from ..scenes.mesh import Floats, Integers
from ..scenes.scene import Law, Scene, at_step
from .problem import Problem, assemble

_DIFFERENCE = 1e-7  # of the onset, for derivatives
_TOLERANCE = 1e-9  # of residuals, over the forces and the onsets
_MOST_STEPS = 40


@dataclasses.dataclass(frozen=True)
class Glue:
    """Numbers of the law, each per point. stiffness: K [stress/length]. strength: normal, shear [stress]. energy: mode I
    and II [force/length]. exponent: of the mix. exponential: the shape of the softening."""
    stiffness: Floats
    strength: tuple[Floats, Floats]
    energy: tuple[Floats, Floats]
    exponent: Floats
    exponential: npt.NDArray[np.bool_]

    @property
    def onset(self) -> Floats:
        """The smaller of both jumps at which damage begins [length]."""
        return np.asarray(np.minimum(*self.strength) / self.stiffness)

    def damage(self, jump: Floats, old: Floats) -> Floats:
        """Per point, of its jump [point, component] after damage has been `old`."""
        opening, slip = np.maximum(jump[:, 0], 0), np.linalg.norm(jump[:, 1:], axis=1)
        length = np.maximum(np.hypot(opening, slip), 1e-300)
        mix = ((slip / length)**2)**self.exponent
        strength = np.sqrt(self.strength[0]**2 * (1 - mix) + self.strength[1]**2 * mix)
        onset = strength / self.stiffness
        tail = 2 * (self.energy[0] + (self.energy[1] - self.energy[0]) * mix) / strength - onset
        beyond = np.maximum(length - onset, 0) / tail
        share = np.where(self.exponential, np.exp(-2 * beyond), np.maximum(1 - beyond, 0))
        return np.asarray(np.where(length > onset, np.maximum(old, 1 - share * onset / length), old))

    def traction(self, jump: Floats, old: Floats) -> Floats:
        """On side 1 [point, component], without contact."""
        felt = np.column_stack([np.maximum(jump[:, 0], 0), jump[:, 1:]])
        return np.asarray(((1 - self.damage(jump, old)) * self.stiffness)[:, None] * felt)

    def tangent(self, jump: Floats, old: Floats) -> Floats:
        """Derivatives of the traction by the jump [point, component, component], by differences."""
        columns = []
        for axis in range(jump.shape[1]):
            step = np.zeros(jump.shape)
            step[:, axis] = _DIFFERENCE * self.onset
            difference = self.traction(jump + step, old) - self.traction(jump - step, old)
            columns.append(difference / (2 * _DIFFERENCE * self.onset)[:, None])
        return np.stack(columns, axis=2)


class GluedProblem:
    """A scene of Cohesive Zone and Prescribed Displacement."""

    def __init__(self, scene: Scene) -> None:
        joints = [joint for joint in scene.joints if joint.law.type == "Cohesive Zone"]
        stand_in = dataclasses.replace(scene, joints=[
            dataclasses.replace(joint, law=Law("Perfect")) if joint in joints else joint for joint in scene.joints])
        problem = assemble(stand_in)
        self.dimension = d = problem.dimension
        points = np.concatenate([np.arange(len(problem.place))[problem.points[joint.name]] for joint in joints])
        owner = np.repeat(np.arange(len(joints)), [_count(problem, joint.name) for joint in joints])
        rows = (d * points[:, None] + np.arange(d)).ravel()
        self.stiffness = problem.stiffness
        self.jump, self.area = problem.jump[rows], problem.area[rows].reshape(-1, d)[:, 0]
        self.glue = _glue([joint.law for joint in joints], owner)
        self.given = self._given(problem, np.setdiff1d(np.arange(problem.jump.shape[0]), rows))
        self.free: Integers = np.setdiff1d(np.arange(self.stiffness.shape[0]), list(self.given))
        smallest = float(np.min(self.glue.strength))
        self._least_force = 1e-2 * smallest * float(np.linalg.norm(self.area))

    @staticmethod
    def _given(problem: Problem, rows: Integers) -> dict[int, Floats]:
        """Displacements that boundaries prescribe [step], by degree of freedom: W u = value, one entry in each row."""
        held = problem.jump[rows].tocsr()
        held.eliminate_zeros()
        return {int(held.indices[held.indptr[i]]): problem.value[:, row] / held.data[held.indptr[i]]
                for i, row in enumerate(rows)}

    def prescribe(self, displacement: Floats, step: int) -> Floats:
        """A state with what its boundaries prescribe."""
        result = displacement.copy()
        for dof, values in self.given.items():
            result[dof] = values[step]
        return result

    def jumps(self, displacement: Floats) -> Floats:
        """[point, component]."""
        return np.asarray((self.jump @ displacement).reshape(-1, self.dimension))

    def _forces(self, displacement: Floats, old: Floats) -> Floats:
        traction = self.glue.traction(self.jumps(displacement), old)
        return np.asarray(self.stiffness @ displacement + self.jump.T @ (self.area[:, None] * traction).ravel())

    def lacking(self, displacement: Floats, old: Floats, near: float) -> tuple[float, Floats]:
        """The force that a state lacks to balance, with the forces of contact that fit best at points that are open by no
        more than `near` [length], and these [point]."""
        forces = self._forces(displacement, old)[self.free]
        closed = np.flatnonzero(self.jumps(displacement)[:, 0] <= near)
        contact = np.zeros(len(self.area))
        left = float(np.linalg.norm(forces))
        if len(closed) > 0:
            normals = self.jump[closed * self.dimension][:, self.free].T.toarray()
            contact[closed], left = optimize.nnls(normals, forces)
        return left, contact

    def force(self, displacement: Floats) -> float:
        """What acts in a state, at least a hundredth of what the weakest glue could bear."""
        return max(float(np.linalg.norm(self.stiffness @ displacement)), self._least_force)

    def solve(self, start: Floats, old: Floats, step: int, near: float = 0.0) -> Floats | None:
        """The equilibrium of a load step that Newton's method comes to from a state, `near` as for lacking(); none where
        it does not."""
        d = self.dimension
        u = self.prescribe(start, step)
        contact = self.lacking(start, old, near)[1]
        for _ in range(_MOST_STEPS):
            jumps = self.jumps(u)
            # Contact is where p > r delta_n, r about the springs of the joint.
            pressing = np.flatnonzero(contact > self.area * self.glue.stiffness * jumps[:, 0])
            contact[np.setdiff1d(np.arange(len(contact)), pressing)] = 0
            normal = self.jump[pressing * d]
            left = (self._forces(u, old) - self.jump[::d].T @ contact)[self.free]
            size = self.force(u)
            inside = max(abs(jumps[pressing, 0]) / self.glue.onset[pressing], default=0.0)
            if np.linalg.norm(left) <= _TOLERANCE * size and inside <= _TOLERANCE:
                return u
            blocks = self.area[:, None, None] * self.glue.tangent(jumps, old)
            springs = sparse.bsr_matrix((blocks, np.arange(len(blocks)), np.arange(len(blocks) + 1)))
            matrix = (self.stiffness + self.jump.T @ springs @ self.jump).tocsr()[self.free][:, self.free]
            border = normal[:, self.free]
            whole = sparse.bmat([[matrix, -border.T], [-border, None]], format="csc") if len(pressing) else matrix.tocsc()
            way = spsolve(whole, -np.concatenate([left, -jumps[pressing, 0]]))
            if not np.isfinite(way).all():
                return None
            u[self.free] += way[:len(self.free)]
            contact[pressing] += way[len(self.free):]
        return None


def _count(problem: Problem, name: str) -> int:
    return int(problem.points[name].stop - problem.points[name].start)


def _glue(laws: list[Law], owner: Integers) -> Glue:
    def given(name: str) -> Floats:
        return np.array([at_step(law.parameters[name], 0) for law in laws])[owner]

    return Glue(given("Stiffness"), (given("Normal Strength"), given("Shear Strength")),
                (given("Mode I Fracture Energy"), given("Mode II Fracture Energy")), given("Mixed Mode Exponent"),
                np.array([law.words["Softening"] == "Exponential" for law in laws])[owner])
