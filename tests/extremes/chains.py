#!/usr/bin/env python3
"""Chains of cubes, glued face to face, clamped at one end and loaded by their weight: how round-off grows with them.

    python3 tests/extremes/chains.py --harmos build/drivers/harmos [50:bend:1e-8 100:axial:1e-6 ...]

A case is cubes:load:accuracy, the load `bend` (force per volume 1, 2, 3 along x, y, z), `axial` (1 along x) or `skew`
(1 along x, 1e-6 along y). With `:1e9` behind it every second cube is so many times as stiff; with `:x1e6` the chain
begins that far from the origin. Prints a row of docs/method/accuracy.md for each.

The truth is found with 50 digits by eliminating one face after the other, from the same elements. Fails when a response
is certified and errs by more than the accuracy asked for, or a run that is not certified does not name double precision.
"""

import argparse
import csv
import decimal
import json
import os
import subprocess
import sys
import tempfile

D = decimal.Decimal
decimal.getcontext().prec = 50
MODULUS, POISSON = 1000000, "0.3"
LOADS = {"bend": ("1", "2", "3"), "axial": ("1", "0", "0"), "skew": ("1", "0.000001", "0")}
CORNERS = [(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]  # the first four on the face towards the clamp


def stiffness():
    """24 x 24 matrix of a cube of edge 1 and modulus 1 with trilinear shape functions and 2^3 Gauss points."""
    nu = D(POISSON)
    lame, shear = nu / ((1 + nu) * (1 - 2 * nu)), 1 / (2 * (1 + nu))
    point = 1 / D(3).sqrt()
    matrix = [[D(0)] * 24 for _ in range(24)]
    for a in (-point, point):
        for b in (-point, point):
            for c in (-point, point):
                slopes = [(p * (1 + q * b) * (1 + r * c) / 4, q * (1 + p * a) * (1 + r * c) / 4,
                           r * (1 + p * a) * (1 + q * b) / 4) for p, q, r in CORNERS]
                for i, s in enumerate(slopes):
                    for j, t in enumerate(slopes):
                        product = sum(x * y for x, y in zip(s, t))
                        for k in range(3):
                            for m in range(3):
                                value = lame * s[k] * t[m] + shear * s[m] * t[k] + (shear * product if k == m else 0)
                                matrix[3 * i + k][3 * j + m] += value / 8
    return matrix


def solve(matrix, right):
    """X of matrix X = right, both lists of rows, by Gauss without pivots: matrices are positive definite."""
    n = len(matrix)
    rows = [list(matrix[i]) + list(right[i]) for i in range(n)]
    for i in range(n):
        pivot = 1 / rows[i][i]
        rows[i] = [x * pivot for x in rows[i]]
        for j in range(n):
            factor = rows[j][i]
            if j != i and factor != 0:
                rows[j] = [x - factor * y for x, y in zip(rows[j], rows[i])]
    return [row[n:] for row in rows]


def tip(cubes, load, contrast):
    """Mean displacement of the last face."""
    one = stiffness()
    near, far = range(12), range(12, 24)

    def block(rows, columns, cube):
        factor = MODULUS * (contrast if cube % 2 else 1)
        return [[factor * one[i][j] for j in columns] for i in rows]

    weight = [D(load[i % 3]) / 8 for i in range(12)]
    s, r = block(far, far, cubes - 1), list(weight)
    eliminated = []
    for cube in range(cubes - 1, 0, -1):
        # The face between this cube and the one before it, when its outer face follows.
        down = block(far, near, cube)
        solved = solve(s, [down[i] + [r[i]] for i in range(12)])
        eliminated.append(solved)
        up, here, before = block(near, far, cube), block(near, near, cube), block(far, far, cube - 1)
        product = [[sum(up[i][m] * solved[m][j] for m in range(12)) for j in range(13)] for i in range(12)]
        s = [[here[i][j] + before[i][j] - product[i][j] for j in range(12)] for i in range(12)]
        r = [2 * weight[i] - product[i][12] for i in range(12)]
    u = [row[0] for row in solve(s, [[value] for value in r])]
    for solved in reversed(eliminated):
        u = [row[12] - sum(row[j] * u[j] for j in range(12)) for row in solved]
    return [sum(u[3 * i + k] for i in range(4)) / 4 for k in range(3)]


def truth(cubes, load, contrast):
    values = {}
    for k, (axis, displacement) in enumerate(zip("XYZ", tip(cubes, load, contrast))):
        values["tip" + axis] = float(displacement)
        values["clamp" + axis] = float(-cubes * D(load[k]))
        values["middle" + axis] = float((cubes - cubes // 2) * D(load[k]))
    return values


def parameter(name, kind, value):
    return f'<Parameter name="{name}" type="{kind}" value="{value}"/>'


def sublist(name, *content):
    return f'<ParameterList name="{name}">' + "".join(content) + "</ParameterList>\n"


def scene(cubes, load, accuracy, contrast, origin):
    def cube(i):
        def corner(name, x, y):
            return parameter(name, "Array(double)", f"{{{origin + x!r},{origin + y!r},{y}}}")

        return sublist(f"p{i}", corner("Lower Corner", i, 0), corner("Upper Corner", i + 1, 1),
                       parameter("Cells", "Array(double)", "{1,1,1}"))

    def material(name, modulus):
        return sublist(name, parameter("Type", "string", "Isotropic"),
                       parameter("Young's Modulus", "double", float(modulus)),
                       parameter("Poisson's Ratio", "double", POISSON))

    def part(i):
        force = [parameter(axis, "double", value) for axis, value in zip("XYZ", load) if value != "0"]
        return sublist(f"p{i}", parameter("Material", "string", "stiff" if i % 2 else "soft"),
                       sublist("Body Force", *force))

    def joint(i):
        return sublist(f"i{i}", parameter("Part 1", "string", f"p{i}"), parameter("Part 2", "string", f"p{i + 1}"),
                       sublist("Law", parameter("Type", "string", "Perfect")))

    def response(name, kind, entry, place, axis):
        direction = ",".join(str(int(axis == other)) for other in "XYZ")
        return sublist(name + axis, parameter("Type", "string", kind), parameter(entry, "string", place),
                       parameter("Direction", "Array(double)", "{" + direction + "}"))

    hold = sublist("Law", parameter("Type", "string", "Prescribed Displacement"),
                   *(parameter(axis, "double", 0) for axis in "XYZ"))
    responses = [response(*what, axis) for axis in "XYZ" for what in
                 (("clamp", "Interface Force", "Interface", "clamp"),
                  ("middle", "Interface Force", "Interface", f"i{cubes // 2 - 1}"),
                  ("tip", "Mean Displacement", "Side Set", f"p{cubes - 1}_xmax"))]
    return sublist("Harmos",
                   sublist("Mesh", parameter("Type", "string", "Boxes"), sublist("Boxes", *map(cube, range(cubes)))),
                   sublist("Materials", material("soft", MODULUS), material("stiff", MODULUS * contrast)),
                   sublist("Parts", *map(part, range(cubes))),
                   sublist("Interfaces", *map(joint, range(cubes - 1))),
                   sublist("Boundaries", sublist("clamp", parameter("Side Set", "string", "p0_xmin"), hold)),
                   sublist("Steps", sublist("weight")),
                   sublist("Solver", parameter("Accuracy", "double", accuracy)),
                   sublist("Responses", *responses))


def run(harmos, case, folder):
    """One row of the table, and whether the run has kept its word."""
    cubes, name, accuracy, *more = case.split(":")
    cubes, load, contrast, origin = int(cubes), LOADS[name], 1, 0.0
    for word in more:
        if word.startswith("x"):
            origin = float(word[1:])
        else:
            contrast = int(float(word))
    path = os.path.join(folder, "chain.xml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene(cubes, load, accuracy, contrast, origin))
    ended = subprocess.run([harmos, "run", path, "--output", folder], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 3):
        return f"| {case} | exit code {ended.returncode}: {ended.stderr} |", False
    with open(os.path.join(folder, "chain_result.json"), encoding="utf-8") as file:
        record = json.load(file)
    if record["status"] == "failed":
        return f"| {case} | {record['reason']} | - | - | - | - |", "double precision" in record["reason"]
    with open(os.path.join(folder, "chain_history.csv"), encoding="utf-8") as file:
        rows = list(csv.reader(file))
    found = dict(zip(rows[0], map(float, rows[-1])))
    true = truth(cubes, load, contrast)
    errors = {key: abs(found[key] - value) / record["response_sizes"][key] for key, value in true.items()}
    worst = max(errors, key=errors.get)
    certified = ended.returncode == 0
    kept = errors[worst] <= float(accuracy) if certified else "double precision" in record["reason"]
    estimate = "-" if record["error_estimate"] is None else f"{record['error_estimate']:.1e}"
    row = (f"| {case} | {record['status']} | {record['linear_stages']} | {estimate} | "
           f"{record['round_off_estimate']:.1e} | {errors[worst]:.1e} ({worst}) |")
    return row + ("" if kept else f"  NOT KEPT: {record['reason']}"), kept


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True)
    parser.add_argument("cases", nargs="*", default=["50:bend:1e-8", "100:bend:1e-8", "50:axial:1e-8", "100:axial:1e-6"])
    arguments = parser.parse_args()
    print("| cubes:load:accuracy | status | linear stages | estimate | of it round-off, at most | true error |")
    print("|---|---|---|---|---|---|", flush=True)
    good = True
    for case in arguments.cases:
        with tempfile.TemporaryDirectory() as folder:
            row, kept = run(arguments.harmos, case, folder)
        print(row, flush=True)
        good = good and kept
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
