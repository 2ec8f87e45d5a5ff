"""Slender bars in a row on joints that are far softer than they are, for extremes.py."""


def bars(cells, size, materials, joints, traction, pieces, accuracy):
    """Bars along x with square or plane cells of the same size, one end clamped, the other under a traction along x.

    `materials`: Young's modulus and Poisson's ratio of each bar; `joints`: normal and tangential stiffness between them. The
    bars are their own mirror images about their axis, so that nothing moves across: `across`; `end` moves along x, and the
    clamp bears the force `force`.
    """
    dimension = len(cells)
    corner = [0.0] * (dimension - 1)
    length = cells[0] * size
    axes = "XYZ"[:dimension]
    names = [f"bar{i}" for i in range(len(materials))]
    unit = [[float(i == j) for j in range(dimension)] for i in range(dimension)]
    return {
        "Model": {"Kinematics": "Plane Strain"} if dimension == 2 else {},
        "Mesh": {"Type": "Boxes", "Boxes": {
            name: {"Lower Corner": [i * length, *corner], "Upper Corner": [(i + 1) * length, *(c * size for c in cells[1:])],
                   "Cells": cells} for i, name in enumerate(names)}},
        "Materials": {name: {"Type": "Isotropic", "Young's Modulus": float(modulus), "Poisson's Ratio": float(poisson)}
                      for name, (modulus, poisson) in zip(names, materials)},
        "Parts": {name: {"Material": name, "Pieces": count} for name, count in zip(names, pieces)},
        "Interfaces": {f"j{i}": {"Side 1": f"{names[i]}_xmax", "Side 2": f"{names[i + 1]}_xmin",
                                 "Law": {"Type": "Linear Elastic", "Normal Stiffness": normal, "Tangential Stiffness": tangential}}
                       for i, (normal, tangential) in enumerate(joints)},
        "Boundaries": {
            "clamp": {"Side Set": f"{names[0]}_xmin", "Law": {"Type": "Prescribed Displacement", **{axis: 0.0 for axis in axes}}},
            "load": {"Side Set": f"{names[-1]}_xmax", "Law": {"Type": "Prescribed Traction", "X": traction}}},
        "Steps": {"load": {}},
        "Solver": {"Accuracy": accuracy},
        "Responses": {
            "end": {"Type": "Mean Displacement", "Side Set": f"{names[-1]}_xmax", "Direction": unit[0]},
            "across": {"Type": "Mean Displacement", "Side Set": f"{names[-1]}_xmax", "Direction": unit[-1]},
            "force": {"Type": "Interface Force", "Interface": "clamp", "Direction": unit[0]}}}
