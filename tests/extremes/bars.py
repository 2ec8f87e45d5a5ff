"""Bars and blocks in a row on joints and springs that are far softer than they are, for extremes.py."""


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


def pressed_blocks(laws, springs, shear, accuracy, pressure=1e-3, hold=None):
    """Plane blocks of 2 x 1 and modulus 1 in a row, pressed along x against what holds the first one: rigid, if not `hold`.

    `laws` between them; `springs` across below some of them, by their number; the last one bears a traction `shear` across at
    its top. Responses: `below<number>`, mean displacements across where springs are; `slip<number>`, that of the right side of
    a joint; `across`, the force of what holds the first block, and `held`, its mean displacement there.
    """
    names = [f"b{i}" for i in range(len(laws) + 1)]
    rigid = {"Type": "Prescribed Displacement", "X": 0.0, "Y": 0.0}

    def displacement(side, direction=(0, 1)):
        return {"Type": "Mean Displacement", "Side Set": side, "Direction": list(direction)}

    return {
        "Model": {"Kinematics": "Plane Strain"},
        "Mesh": {"Type": "Boxes", "Boxes": {
            name: {"Lower Corner": [2.0 * i, 0.0], "Upper Corner": [2.0 * i + 2.0, 1.0], "Cells": [5, 3]}
            for i, name in enumerate(names)}},
        "Materials": {"m": {"Type": "Isotropic", "Young's Modulus": 1.0, "Poisson's Ratio": 0.3}},
        "Parts": {name: {"Material": "m"} for name in names},
        "Interfaces": {f"j{i}": {"Side 1": f"b{i}_xmax", "Side 2": f"b{i + 1}_xmin", "Law": law} for i, law in enumerate(laws)},
        "Boundaries": {
            "hold": {"Side Set": "b0_xmin", "Law": hold or rigid},
            "press": {"Side Set": f"{names[-1]}_xmax", "Law": {"Type": "Prescribed Traction", "X": -pressure}},
            "shear": {"Side Set": f"{names[-1]}_ymax", "Law": {"Type": "Prescribed Traction", "Y": shear}},
            **{f"s{i}": {"Side Set": f"b{i}_ymin", "Law": {"Type": "Elastic Foundation", "Normal Stiffness": stiffness,
                                                           "Tangential Stiffness": 0.0}} for i, stiffness in springs.items()}},
        "Steps": {"load": {}},
        "Solver": {"Accuracy": accuracy},
        "Responses": {
            **{f"below{i}": displacement(f"b{i}_ymin") for i in springs},
            **{f"slip{i}": displacement(f"b{i + 1}_xmin") for i in range(len(laws))},
            "held": displacement("b0_xmin"),
            "across": {"Type": "Interface Force", "Interface": "hold", "Direction": [0, 1]}}}
