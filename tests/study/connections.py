#!/usr/bin/python3
"""Every load and connection with a number that a study varies and that is random: connections.py HARMOS WORK_DIR

A bar of two unit cubes in a row, guided along x, is loaded or joined in every way there is, and each time one response is
held against its closed form: at two values of the number, and in mean and standard deviation when it is uniform between
them, by polynomial chaos, or by collocation where chaos is refused because bodies change.
"""
import csv
import math
import pathlib
import shutil
import subprocess
import sys

from checks import check, finish
from lists import box, entries, entry, guided, law

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
MODULUS, LENGTH, DENSITY, EXPANSION = 1000.0, 2.0, 0.01, 1e-4
TOLERANCE = 1e-4


def near(value, expected, what):
    check(abs(value - expected) <= TOLERANCE * abs(expected), f"{what}: {value!r} is not {expected!r}")


def on(name, side_set, *laws):
    return entries(name, entry("Side Set", side_set), law(*laws))


def held(name, side_set):
    return on(name, side_set, "Prescribed Displacement", entry("X", 0.0))


def force(interface, *more):
    return entries("r", entry("Type", "Interface Force"), entry("Interface", interface), entry("Direction", "{1, 0, 0}"),
                   *more)


def of(kind, name, *more):
    return entries("r", entry("Type", kind), entry("Interface", name), *more)


MOVED = entries("r", entry("Type", "Mean Displacement"), entry("Side Set", "b1_xmax"), entry("Direction", "{1, 0, 0}"))
FOOT, BOND = held("foot", "b0_xmin"), entries("bond", entry("Part 1", "b0"), entry("Part 2", "b1"), law("Perfect"))
BOTH = FOOT + held("head", "b1_xmax")


def pulled(*laws):
    return FOOT + on("load", "b1_xmax", *laws)


def walled(*laws):
    """A load, with all sides guided, which the others need not."""
    walls = [on(f"{cube}_{axis}max", f"{cube}_{axis}max", "Symmetry") for cube in ("b0", "b1") for axis in "yz"]
    return "".join(walls) + pulled(*laws)


def spring(*laws):
    """Instead of the bond between the cubes."""
    return entries("bond", entry("Side 1", "b0_xmax"), entry("Side 2", "b1_xmin"),
                   law("Face Spring", entry("Point", "{1, 0.5, 0.5}"), entry("Axis", "{1, 0, 0}"), *laws))


def cut(*laws):
    return entries("cut", entry("Part", "b1"), entry("Point", "{1.5, 0, 0}"), entry("Normal", "{1, 0, 0}"), law(*laws))


# The centre of the sphere is so far above the face, and from its corners; the axis of the cylinder likewise.
ABOVE = 0.75
TO_CORNER, TO_EDGE = math.hypot(ABOVE, math.sqrt(0.5)), math.hypot(ABOVE, 0.5)
DOWN = 0.02


def indented(radius, distance):
    """Force of the bar, whose face goes down with all its corners, each along the normal of the tool."""
    return -MODULUS / LENGTH * (DOWN - (distance - radius) * distance / ABOVE)


# name, boundaries, interfaces, rest of the scene, response, entry, lower and upper value, closed form
CASES = [
    ("pressure", pulled("Pressure", entry("Pressure", "$v")), BOND, "", MOVED, 5.0, 20.0, lambda v: -v * LENGTH / MODULUS),
    ("traction_by_formula", pulled("Prescribed Traction", entry("X", "$v"), entry("X Formula", "2 * y")), BOND, "",
     force("foot"), 5.0, 20.0, lambda v: -v),
    ("remote_force", pulled("Remote Force", entry("X", "$v")), BOND, "", force("foot"), 5.0, 20.0, lambda v: -v),
    ("remote_moment", pulled("Remote Force", entry("Moment Z", "$v")), BOND, "",
     of("Interface Moment", "load", entry("Centre", "{0, 0, 0}"), entry("Axis", "{0, 0, 1}")), 5.0, 20.0, lambda v: v),
    ("nodal_force", pulled("Nodal Force", entry("X", "$v")), BOND, "", MOVED, 5.0, 20.0, lambda v: 4.0 * v * LENGTH / MODULUS),
    ("remote_displacement", pulled("Remote Displacement", entry("X", "$v")), BOND, "", force("foot"), 0.01, 0.03,
     lambda v: -MODULUS * v / LENGTH),
    ("rigid_remote_displacement", pulled("Remote Displacement", entry("Kind", "Rigid"), entry("X", "$v")), BOND, "",
     force("foot"), 0.01, 0.03, lambda v: -MODULUS * v / LENGTH),
    ("cylindrical_traction", pulled("Cylindrical Traction", entry("Point", "{0, 9, 0}"), entry("Axis", "{1, 0, 0}"),
                                    entry("Axial", "$v")), BOND, "", MOVED, 5.0, 20.0, lambda v: v * LENGTH / MODULUS),
    ("cylindrical_displacement", pulled("Cylindrical Displacement", entry("Point", "{0, 9, 0}"), entry("Axis", "{1, 0, 0}"),
                                        entry("Axial", "$v")), BOND, "", force("foot"), 0.01, 0.03,
     lambda v: -MODULUS * v / LENGTH),
    ("pretension", BOTH, BOND + cut("Pretension", entry("Force", "$v")), "", of("Bolt Force", "cut"), 5.0, 20.0, lambda v: v),
    ("pretension_overlap", BOTH, BOND + cut("Pretension", entry("Force", "$v")), "", of("Overlap", "cut"), 5.0, 20.0,
     lambda v: v * LENGTH / MODULUS),
    ("preload_jump", BOTH, BOND + cut("Preload Jump", entry("Jump", "$v")), "", of("Bolt Force", "cut"), 0.01, 0.03,
     lambda v: v * MODULUS / LENGTH),
    ("face_spring", pulled("Prescribed Traction", entry("X", 10.0)), spring(entry("Axial Stiffness", "$v")), "", MOVED,
     400.0, 500.0, lambda v: 10.0 * (LENGTH / MODULUS + 1.0 / v)),
    ("bolt_law", BOTH, spring(entry("Axial Stiffness", 500.0), entry("Force", "$v"), entry("Locked From", 1.0)), "",
     force("bond"), 5.0, 20.0, lambda v: v),
    ("rigid_plane", pulled("Rigid Plane", entry("Point", "{2, 0, 0}"), entry("Normal", "{-1, 0, 0}"), entry("X", "$v")), BOND,
     "", force("load"), -0.03, -0.01, lambda v: MODULUS * v / LENGTH),
    ("rigid_cylinder", walled("Rigid Cylinder", entry("Point", f"{{{LENGTH + ABOVE}, 0.5, 0}}"), entry("Radius", "$v"),
                              entry("X", -DOWN)), BOND, "", force("load"), TO_EDGE - 0.01, TO_EDGE - 0.001,
     lambda v: indented(v, TO_EDGE)),
    ("rigid_sphere", walled("Rigid Sphere", entry("Centre", f"{{{LENGTH + ABOVE}, 0.5, 0.5}}"), entry("Radius", "$v"),
                            entry("X", -DOWN)), BOND, "", force("load"), TO_CORNER - 0.01, TO_CORNER - 0.001,
     lambda v: indented(v, TO_CORNER)),
    ("thermal_strain", BOTH, BOND, entries("Temperatures", entries("t", entry("Type", "Prescribed"), entry("Temperature", "$v"))),
     force("foot"), 10.0, 40.0, lambda v: MODULUS * EXPANSION * v),
    ("gravity", FOOT, BOND, entries("Loads", entries("g", entry("Type", "Gravity"), entry("X", "$v"))), force("foot"), 5.0, 20.0,
     lambda v: -DENSITY * v * LENGTH),
    ("acceleration", FOOT, BOND, entries("Loads", entries("g", entry("Type", "Acceleration"), entry("X", "$v"))), force("foot"),
     5.0, 20.0, lambda v: DENSITY * v * LENGTH),
    ("rotation", FOOT, BOND, entries("Loads", entries("w", entry("Type", "Rotation"), entry("Point", "{0, 0.5, 0.5}"),
                                                      entry("Axis", "{0, 0, 1}"), entry("Angular Velocity", "$v"))),
     force("foot"), 5.0, 20.0, lambda v: -0.5 * DENSITY * v**2 * LENGTH**2),
]


def scene(boundaries, interfaces, rest, response, value):
    guides = "".join(guided(["b0", "b1"]))
    # The second cube has two elements, so that a plane can cut it.
    cells = box("b1", 1).replace('name="Cells" type="Array(double)" value="{1, 1, 1}"',
                                 'name="Cells" type="Array(double)" value="{2, 1, 1}"')
    return entries(
        "Harmos", entries("Values", entry("v", value)),
        entries("Mesh", entry("Type", "Boxes"), entries("Boxes", box("b0", 0), cells)),
        entries("Materials", entries("m", entry("Type", "Isotropic"), entry("Young's Modulus", MODULUS),
                                     entry("Poisson's Ratio", 0.0), entry("Density", DENSITY),
                                     entry("Thermal Expansion", EXPANSION))),
        entries("Parts", *[entries(name, entry("Material", "m")) for name in ("b0", "b1")]),
        entries("Interfaces", interfaces), entries("Boundaries", guides, boundaries), rest,
        entries("Steps", entries("only")), entries("Responses", response))


def study(name, design, parameter):
    return entries("Harmos Study", entry("Scene", f"{name}.xml"), entry("Accuracy", 1e-6),
                   entries("Parameters", entries("v", entry("Entry", "Values/v"), *parameter)), entries("Design", *design),
                   entries("Responses", entries("r", entry("Type", "Final"), entry("Response", "r"))))


def solved(path, code=0):
    """What a study prints; its results lie in a folder of its name."""
    done = subprocess.run([HARMOS, "study", str(path), "--output", str(path.with_suffix(""))], capture_output=True, text=True)
    check(done.returncode == code, f"{path.stem}: exit code {done.returncode}, not {code}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def rows(folder, which):
    with open(folder / f"{folder.name}{which}.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def uniform(lower, upper):
    return [entries("Distribution", entry("Type", "Uniform"), entry("Lower", lower), entry("Upper", upper))]


def moments_of(form, lower, upper, count=2000):
    """By the midpoint rule."""
    values = [form(lower + (upper - lower) * (i + 0.5) / count) for i in range(count)]
    mean = sum(values) / count
    return mean, math.sqrt(sum((value - mean) ** 2 for value in values) / count)


def varied(name, boundaries, interfaces, rest, response, lower, upper, form):
    (WORK / f"{name}.xml").write_text(scene(boundaries, interfaces, rest, response, lower))
    path = WORK / f"{name}_grid.xml"
    path.write_text(study(name, [entry("Type", "Grid")], [entry("From", lower), entry("To", upper), entry("Count", 2)]))
    solved(path)
    for value, row in zip((lower, upper), rows(path.with_suffix(""), "")):
        near(float(row["r"]), form(value), f"{name} at {value:g}")
    is_of_bodies = bool(rest)
    design = [entry("Type", "Collocation")] if is_of_bodies else [entry("Type", "Chaos"), entry("Order", 4)]
    path = WORK / f"{name}_random.xml"
    path.write_text(study(name, design, uniform(lower, upper)))
    solved(path)
    found, expected = rows(path.with_suffix(""), "_moments")[0], moments_of(form, lower, upper)
    near(float(found["mean"]), expected[0], f"mean of {name}")
    near(float(found["std"]), expected[1], f"deviation of {name}")


def refused():
    """A radius with which the tool would lie in the part: found before anything is written."""
    name, boundaries, interfaces, rest, response, *_ = next(case for case in CASES if case[0] == "rigid_sphere")
    (WORK / f"{name}.xml").write_text(scene(boundaries, interfaces, rest, response, TO_CORNER - 0.05))
    path = WORK / "deep_random.xml"
    path.write_text(study(name, [entry("Type", "Chaos"), entry("Order", 2)], uniform(TO_CORNER - 0.01, TO_CORNER + 0.01)))
    said = solved(path, 2)
    check("deep in the tool at the start" in said and "which the scene refuses" in said, said)
    check(not path.with_suffix("").exists(), "a refused study has written something")


def inadmissible():
    """One value with which the tool would lie in the part is the result of its configuration, be it the first or not."""
    name, boundaries, interfaces, rest, response, _, upper, form = next(case for case in CASES if case[0] == "rigid_sphere")
    (WORK / f"{name}.xml").write_text(scene(boundaries, interfaces, rest, response, upper))
    for label, first, last in (("first", TO_CORNER + 0.02, upper), ("last", upper, TO_CORNER + 0.02)):
        path = WORK / f"deep_{label}.xml"
        path.write_text(study(name, [entry("Type", "Grid")], [entry("From", first), entry("To", last), entry("Count", 2)]))
        solved(path, 3)
        found = {row["status"]: row["r"] for row in rows(path.with_suffix(""), "")}
        check(set(found) == {"certified", "inadmissible"}, f"{label}: {found}")
        near(float(found["certified"]), form(upper), f"beside an inadmissible configuration, {label}")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
only = sys.argv[3:]
for case in CASES:
    if not only or case[0] in only:
        varied(*case)
if not only:
    refused()
    inadmissible()
finish()
