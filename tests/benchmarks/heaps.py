"""Scenes of boxes that stand side by side and on each other, in the plane or in space, all joined by one law.

The lowest row is held below; the highest one is pressed from above in the first load step, and pushed sideways in the
others.
"""
import itertools

FRICTION = {"Type": "Coulomb Friction", "Friction Coefficient": 0.4}


def _parameter(name, value):
    kind = "string" if isinstance(value, str) else "int" if isinstance(value, int) else "double"
    return f'<Parameter name="{name}" type="{kind}" value="{value}"/>'


def _array(name, values):
    return f'<Parameter name="{name}" type="Array(double)" value="{{{", ".join(map(str, values))}}}"/>'


def _list(name, *entries):
    return f'<ParameterList name="{name}">{"".join(entries)}</ParameterList>\n'


def _law(law):
    return _list("Law", *itertools.starmap(_parameter, law.items()))


def scene(counts, cells, steps, law=None, size=None, **mesh):
    """`counts`, `cells`: boxes along every axis, the last one upwards, and cells of a box; `size`: of a box, 1 in every
    direction unless given; `mesh`: entries of the mesh, such as Order=2."""
    axes = "xyz"[:len(counts)]
    size = size or (1,) * len(counts)
    up = axes[-1]
    boxes = list(itertools.product(*map(range, counts)))
    name = {box: "b" + "_".join(map(str, box)) for box in boxes}
    corners = {box: [[(i + end) * length for i, length in zip(box, size)] for end in (0, 1)] for box in boxes}
    grid = [_list(name[box], _array("Lower Corner", corners[box][0]), _array("Upper Corner", corners[box][1]),
                  _array("Cells", cells)) for box in boxes]
    parts = [_list(name[box], _parameter("Material", "m")) for box in boxes]
    held = {"Type": "Prescribed Displacement", **{axis.upper(): 0.0 for axis in axes}}
    pressed = {"Type": "Prescribed Traction", "X": 0.5, "X History": "push", up.upper(): -10.0, f"{up.upper()} History": "press"}
    boundaries = [_list(f"held {name[box]}", _parameter("Side Set", f"{name[box]}_{up}min"), _law(held))
                  for box in boxes if box[-1] == 0]
    boundaries += [_list(f"pressed {name[box]}", _parameter("Side Set", f"{name[box]}_{up}max"), _law(pressed))
                   for box in boxes if box[-1] == counts[-1] - 1]
    top = f"{name[boxes[-1]]}_{up}max"
    return _list(
        "Harmos",
        _list("Mesh", _parameter("Type", "Boxes"), _list("Boxes", *grid), *itertools.starmap(_parameter, mesh.items())),
        _list("Materials", _list("m", _parameter("Type", "Isotropic"), _parameter("Young's Modulus", 20000.0),
                                 _parameter("Poisson's Ratio", 0.3))),
        _list("Parts", *parts),
        _list("Interfaces", _list("joint", _parameter("Part 1", "*"), _parameter("Part 2", "*"), _law(law or FRICTION))),
        _list("Boundaries", *boundaries),
        _list("Steps", _list("press"), *([_list("push", _parameter("Increments", steps - 1))] if steps > 1 else [])),
        _list("Histories", _list("press", _parameter("Type", "Ramp"), _parameter("Start", 0.0), _parameter("End", 1.0)),
              _list("push", _parameter("Type", "Ramp"), _parameter("Start", 1.0), _parameter("End", 2.0))),
        _list("Responses", _list("u", _parameter("Type", "Mean Displacement"), _parameter("Side Set", top),
                                 _array("Direction", [1] + [0] * (len(counts) - 1)))))
