"""Responses of a solved history, and the sizes by which Harmos measures their errors."""
from __future__ import annotations

import numpy as np

from ..scenes.mesh import Floats
from ..scenes.scene import Response, Scene
from .laws import DISSIPATIVE
from .problem import Problem
from .surfaces import nodal_areas

SMALL = 1e-3  # of the largest of its kind: what is smaller is measured by this
CANCELLATION = 1e-7  # of the search direction times displacement, for forces and tractions
SEARCH_DIRECTION = 0.15  # of the stiffness of nodes in series, as docs/method says


class History:
    """Fields of all load steps: displacement [step, dof], force a t [step, row], and what follows from them."""

    def __init__(self, scene: Scene, problem: Problem, displacement: Floats, force: Floats) -> None:
        self.scene = scene
        self.problem = problem
        self.displacement = displacement
        self.force = force
        self.jump = displacement @ problem.jump.T

    def _rows(self, joint: str) -> slice:
        points = self.problem.points[joint]
        return slice(points.start * self.problem.dimension, points.stop * self.problem.dimension)

    def _local(self, field: Floats, joint: str) -> Floats:
        """[step, point, component]"""
        return np.asarray(field[:, self._rows(joint)].reshape(self.problem.steps, -1, self.problem.dimension))

    def _global_force(self, joint: str) -> Floats:
        frame = self.problem.frame[self.problem.points[joint]]
        return np.asarray(np.einsum("spc,pci->spi", self._local(self.force, joint), frame))

    def response(self, response: Response) -> Floats:
        """One value per load step."""
        return np.asarray(self._EVALUATE[response.type](self, response), dtype=float)

    def _mean_displacement(self, response: Response) -> Floats:
        areas = nodal_areas(self.scene.mesh, response.target, self.scene.thickness)
        direction = _unit(response.vectors["Direction"])
        moved = self.displacement.reshape(self.problem.steps, -1, self.problem.dimension)[:, areas.nodes]
        return np.asarray(moved @ direction @ (areas.share / areas.share.sum()))

    def _interface_force(self, response: Response) -> Floats:
        return np.asarray(self._global_force(response.target).sum(axis=1) @ _unit(response.vectors["Direction"]))

    def _bolt_force(self, response: Response) -> Floats:
        normal = self.problem.normal[self.problem.points[response.target]]
        return np.asarray(np.einsum("spi,pi->s", self._global_force(response.target), normal))

    def _interface_moment(self, response: Response) -> Floats:
        arm = self.problem.place[self.problem.points[response.target]] - np.array(response.vectors["Centre"])
        force = self._global_force(response.target)
        if self.problem.dimension == 2:
            return np.asarray(force[:, :, 1] @ arm[:, 0] - force[:, :, 0] @ arm[:, 1])
        return np.asarray(np.cross(arm[None], force).sum(axis=1) @ _unit(response.vectors["Axis"]))

    def _maximum(self, response: Response) -> Floats:
        rows = self._rows(response.target)
        stress = (self.force / self.problem.area)[:, rows].reshape(self.problem.steps, -1, self.problem.dimension)
        jump = self._local(self.jump, response.target)
        opening = jump[:, :, 0] + self.problem.gap[self.problem.points[response.target]]
        field = {"Contact Pressure": -stress[:, :, 0], "Normal Traction": abs(stress[:, :, 0]),
                 "Tangential Traction": np.linalg.norm(stress[:, :, 1:], axis=2), "Opening": opening,
                 "Slip": np.linalg.norm(jump[:, :, 1:], axis=2)}[response.field]
        return np.asarray(np.maximum(0.0, field.max(axis=1)))

    def _dissipation(self, response: Response) -> Floats:
        if self.scene.joint(response.target).law.type not in DISSIPATIVE:
            return np.zeros(self.problem.steps)
        jump = self._local(self.jump, response.target)
        slip = np.diff(jump[:, :, 1:], axis=0, prepend=0.0)
        return np.asarray(np.cumsum((slip * self._local(self.force, response.target)[:, :, 1:]).sum(axis=(1, 2))))

    _EVALUATE = {"Mean Displacement": _mean_displacement, "Interface Force": _interface_force,
                 "Bolt Force": _bolt_force, "Interface Moment": _interface_moment, "Maximum": _maximum,
                 "Dissipation": _dissipation}

    def floor(self, response: Response) -> float:
        """The least size by which an error of this response is measured, see NaturalSizes."""
        p = self.problem
        # Twice, for Harmos counts how far loads would move bodies that nothing but the search direction holds, too.
        node = 2 * np.linalg.norm(self.displacement.reshape(p.steps, -1, p.dimension), axis=2).max(initial=0.0)
        sides = np.where(np.repeat(p.two_sided, p.dimension), 2, 1)
        forces = (sides * abs(self.force)).sum(axis=1).max(initial=0.0)
        springs = (sides * SEARCH_DIRECTION * p.spring * abs(self.jump)).sum(axis=1).max(initial=0.0)
        stress = (abs(self.force) / p.area).max(initial=0.0)
        force = max(SMALL * forces, CANCELLATION * springs)
        extent = float(np.linalg.norm(p.nodes.max(axis=0) - p.nodes.min(axis=0)))
        match response.type:
            case "Mean Displacement":
                return float(SMALL * node)
            case "Interface Moment":
                return float(force * extent)
            case "Dissipation":
                return float(SMALL * force * node)
            case "Maximum":
                return float(SMALL * node if response.field in ("Opening", "Slip") else SMALL * stress)
        return float(force)

    def size(self, response: Response) -> float:
        """What an error of this response is relative to."""
        return float(max(abs(self.response(response)).max(), self.floor(response)))


def _unit(vector: tuple[float, ...]) -> Floats:
    array = np.array(vector)
    return np.asarray(array / np.linalg.norm(array))
