#!/usr/bin/python3
"""The bolted joint by GetFEM: its elements, its contact with friction (Alart-Curnier, augmented), its Newton's method.

  harmos mesh SCENE.xml --output MESH.e
  getfem_joint.py SCENE.xml MESH.e [--residual 1e-6] [--set ENTRY=VALUE]...

prints CSV: mean displacement of the loaded face at every load step, and the sum of all contact pressures; then, as a
comment, the iterations of Newton's method. MESH.e is that of the scene. Parts are shifted away from each other in GetFEM's
mesh, which would otherwise join nodes that coincide.
"""
import argparse
import sys

import getfem
import numpy as np

from joint_scene import JointMesh, JointScene

# Nodes of Exodus' hexahedron in the order of GetFEM's.
ORDER = [0, 1, 3, 2, 4, 5, 7, 6]


class JointModel:
    """GetFEM's model of a joint."""

    def __init__(self, scene, mesh):
        self.scene, self.mesh = scene, mesh
        apart = 10 * np.ptp(mesh.nodes, axis=0).max()
        shift = np.zeros_like(mesh.nodes)
        for number, block in enumerate(mesh.blocks):
            shift[np.unique(block), 0] = number * apart
        solid = getfem.Mesh("empty", 3)
        for block in mesh.blocks:
            points = (mesh.nodes + shift)[block[:, ORDER]]
            solid.add_convex(getfem.GeoTrans("GT_QK(3,1)"), np.transpose(points, (2, 1, 0)))
        field = getfem.MeshFem(solid, 3)
        field.set_fem(getfem.Fem("FEM_QK(3,1)"))
        places = field.basic_dof_nodes()[:, ::3].T
        if len(places) != len(mesh.nodes):
            raise SystemExit("GetFEM has joined nodes of the mesh")
        ours, theirs = (np.lexsort(np.round(x, 6).T) for x in (mesh.nodes + shift, places))
        self.dof = np.empty(len(places), dtype=int)  # the first degree of freedom of a node
        self.dof[ours] = 3 * theirs
        self.dofs = 3 * len(places)

        young, poisson = scene.young, scene.poisson
        model = self.model = getfem.Model("real")
        model.add_fem_variable("u", field)
        model.add_initialized_data("lambda", young * poisson / (1 + poisson) / (1 - 2 * poisson))
        model.add_initialized_data("mu", young / 2 / (1 + poisson))
        self.kept = [solid, field]  # GetFEM frees what Python forgets
        gauss = getfem.MeshIm(solid, getfem.Integ("IM_GAUSS_PARALLELEPIPED(3,3)"))
        model.add_isotropic_linearized_elasticity_brick(gauss, "u", "lambda", "mu")
        self.kept.append(gauss)
        self.constrain()
        self.touch()
        self.right = model.add_explicit_rhs("u", np.zeros(self.dofs))
        self.iterations = 0

    def matrix(self, rows):
        """A sparse matrix from rows of (node, vector): sum of vector . u."""
        result = getfem.Spmat("empty", len(rows), self.dofs)
        for number, row in enumerate(rows):
            for node, vector in row:
                for component in np.flatnonzero(vector):
                    result.add(number, int(self.dof[node] + component), float(vector[component]))
        return result

    def constrain(self):
        rows, values = [], []
        for name, components in self.scene.held.items():
            if any(components):
                raise SystemExit("displacements other than 0 are not what this program prescribes")
            held = np.eye(3)[[component is not None for component in components]]
            for node in self.mesh.set_nodes(name):
                rows += [[(node, axis)] for axis in held]
        values += [0.0] * len(rows)
        for sides, jump in self.scene.preloads:
            normal = self.mesh.normal(sides[0])
            for first, second in zip(*self.mesh.pairs(*sides)):
                rows += [[(second, axis), (first, -axis)] for axis in np.eye(3)]
                values += list(-jump * normal)
        self.model.add_variable("hold", len(rows))
        self.model.add_constraint_with_multipliers("u", "hold", self.matrix(rows), np.array(values))

    def touch(self):
        normal_rows, tangent_rows, friction = [], [], []
        for sides, coefficient in self.scene.contacts:
            normal = self.mesh.normal(sides[0])
            tangents = np.linalg.svd(normal[None])[2][1:]
            for first, second in zip(*self.mesh.pairs(*sides)):
                normal_rows.append([(first, normal), (second, -normal)])
                tangent_rows += [[(first, axis), (second, -axis)] for axis in tangents]
                friction.append(coefficient)
        model = self.model
        model.add_variable("pressure", len(normal_rows))
        model.add_variable("shear", len(tangent_rows))
        model.set_variable("pressure", -np.ones(len(normal_rows)))  # contacts begin closed, else parts are loose
        size = np.ptp(self.mesh.nodes, axis=0).max() / len(self.mesh.nodes) ** (1 / 3)
        model.add_initialized_data("r", self.scene.young * size)
        model.add_initialized_data("friction", np.array(friction))
        model.add_initialized_data("gap", np.zeros(len(friction)))
        model.add_initialized_data("alpha", np.ones(len(friction)))
        model.add_initialized_data("rate", 1.0)
        model.add_initialized_data("before", np.zeros(self.dofs))
        model.add_basic_contact_brick("u", "pressure", "shear", "r", self.matrix(normal_rows), self.matrix(tangent_rows),
                                      "friction", "gap", "alpha", 1, "rate", "before")

    def solve(self, share, residual):
        """A load step with this share of the tractions; the displacements of all nodes."""
        force = np.zeros(self.dofs)
        for name, traction in self.scene.tractions.items():
            weights = self.mesh.weights(name)
            for component in range(3):
                force[self.dof + component] += share * traction[component] * weights
        self.model.set_private_rhs(self.right, force)
        iterations, converged = self.model.solve("max_res", residual, "max_iter", 100, "lsolver", "mumps")
        self.iterations += iterations
        if not converged:
            raise SystemExit("GetFEM has not converged")
        u = self.model.variable("u")
        self.model.set_variable("before", -u)  # friction opposes rate u + before
        return np.stack([u[self.dof + component] for component in range(3)], axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("mesh")
    parser.add_argument("--residual", type=float, default=1e-6, help="of Newton's method, as GetFEM measures it")
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    getfem.util("trace level", 0)
    scene, mesh = JointScene(arguments.scene, arguments.set), JointMesh(arguments.mesh)
    joint = JointModel(scene, mesh)
    (loaded,) = scene.tractions
    weights = mesh.weights(loaded) / mesh.weights(loaded).sum()
    print("time,u_load,pressure_force")
    for step in range(scene.increments + 1):
        u = joint.solve(step / scene.increments, arguments.residual)
        pressure = -joint.model.variable("pressure").sum()
        print(f"{1 + step / scene.increments:g},{weights @ u[:, 0]:.12g},{pressure:.12g}", flush=True)
    print(f"# iterations {joint.iterations}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
