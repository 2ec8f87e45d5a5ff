"""Stiffness and body forces of elements for isotropic elasticity, by textbook formulas."""
from __future__ import annotations

import numpy as np

from ..scenes.mesh import Floats
from .shapes import rule_of, shape_of

def elasticity(young: float, poisson: float, kinematics: str) -> Floats:
    """Stress from strain [stress], with shear angles: (xx, yy, xy), in space (xx, yy, zz, xy, yz, zx)."""
    shear = young / (2 * (1 + poisson))
    if kinematics == "Plane Stress":
        factor = young / (1 - poisson**2)
        return np.array([[factor, factor * poisson, 0], [factor * poisson, factor, 0], [0, 0, shear]])
    lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    if kinematics == "Plane Strain":
        return np.array([[lame + 2 * shear, lame, 0], [lame, lame + 2 * shear, 0], [0, 0, shear]])
    matrix = np.diag([2 * shear] * 3 + [shear] * 3)
    matrix[:3, :3] += lame
    return matrix


def _strain(gradient: Floats) -> Floats:
    """Strains from nodal displacements, whose order is node by node."""
    nodes, dimension = gradient.shape
    if dimension == 2:
        matrix = np.zeros((3, 2 * nodes))
        matrix[0, 0::2] = matrix[2, 1::2] = gradient[:, 0]
        matrix[1, 1::2] = matrix[2, 0::2] = gradient[:, 1]
        return matrix
    matrix = np.zeros((6, 3 * nodes))
    for row, axis in enumerate(range(3)):
        matrix[row, axis::3] = gradient[:, axis]
    for row, (i, j) in enumerate(((0, 1), (1, 2), (2, 0)), 3):
        matrix[row, i::3] = gradient[:, j]
        matrix[row, j::3] = gradient[:, i]
    return matrix


def stiffness(kind: str, nodes: Floats, material: Floats, thickness: float) -> Floats:
    """int B^t C B dV [force/length] of an element; nodes: node x axis. Raises when it is turned inside out."""
    matrix = np.zeros((nodes.size, nodes.size))
    places, weights = rule_of(kind)
    for slopes, weight in zip(shape_of(kind).slopes(places), weights):
        jacobian = nodes.T @ slopes
        determinant = float(np.linalg.det(jacobian))
        if determinant <= 0:
            raise ValueError("an element is turned inside out")
        strain = _strain(slopes @ np.linalg.inv(jacobian))
        matrix += weight * determinant * thickness * (strain.T @ material @ strain)
    return matrix


def nodal_volumes(kind: str, nodes: Floats, thickness: float) -> Floats:
    """int N_a dV [volume] per node: a body force times this is the nodal force."""
    places, weights = rule_of(kind)
    shape = shape_of(kind)
    volumes = np.zeros(len(nodes))
    for values, slopes, weight in zip(shape.values(places), shape.slopes(places), weights):
        volumes += weight * thickness * float(np.linalg.det(nodes.T @ slopes)) * values
    return volumes
