"""Stiffness and body forces of linear elements for isotropic elasticity, by textbook formulas."""
from __future__ import annotations

import itertools

import numpy as np

from ..scenes.mesh import Floats

_QUAD = ((-1, -1), (1, -1), (1, 1), (-1, 1))
_HEX = ((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))


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


def _product_rule(corners: tuple[tuple[int, ...], ...]) -> list[tuple[Floats, Floats, float]]:
    """Shape functions, their derivatives [corner, axis], and the weight at two Gauss points per axis."""
    signs = np.array(corners, dtype=float)
    dimension = signs.shape[1]
    rule = []
    for point in itertools.product((-1 / np.sqrt(3), 1 / np.sqrt(3)), repeat=dimension):
        factors = (1 + signs * np.array(point)) / 2
        slopes = np.empty_like(signs)
        for axis in range(dimension):
            others = np.delete(factors, axis, axis=1)
            slopes[:, axis] = signs[:, axis] / 2 * others.prod(axis=1)
        rule.append((factors.prod(axis=1), slopes, 1.0))
    return rule


def _simplex_rule(dimension: int) -> list[tuple[Floats, Floats, float]]:
    """One point is exact: the gradients are constant, and the shape functions linear."""
    slopes = np.vstack([-np.ones(dimension), np.eye(dimension)])
    volume = 0.5 if dimension == 2 else 1 / 6
    return [(np.full(dimension + 1, 1 / (dimension + 1)), slopes, volume)]


_RULES = {"TRI3": _simplex_rule(2), "QUAD4": _product_rule(_QUAD),
          "TET4": _simplex_rule(3), "HEX8": _product_rule(_HEX)}


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


def stiffness(kind: str, corners: Floats, material: Floats, thickness: float) -> Floats:
    """int B^t C B dV [force/length] of an element; corners: node x axis. Raises when it is turned inside out."""
    matrix = np.zeros((corners.size, corners.size))
    for _, slopes, weight in _RULES[kind]:
        jacobian = corners.T @ slopes
        determinant = float(np.linalg.det(jacobian))
        if determinant <= 0:
            raise ValueError("an element is turned inside out")
        strain = _strain(slopes @ np.linalg.inv(jacobian))
        matrix += weight * determinant * thickness * (strain.T @ material @ strain)
    return matrix


def nodal_volumes(kind: str, corners: Floats, thickness: float) -> Floats:
    """int N_a dV [volume] per node: a body force times this is the nodal force."""
    volumes = np.zeros(len(corners))
    for shape, slopes, weight in _RULES[kind]:
        volumes += weight * thickness * float(np.linalg.det(corners.T @ slopes)) * shape
    return volumes
