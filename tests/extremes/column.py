"""Scenes of two or more blocks on rollers whose answers are known in closed form, for extremes.py."""
from xml.sax.saxutils import quoteattr


def parameter(name, value):
    kind, text = "string", str(value)
    if isinstance(value, bool):
        kind, text = "bool", text.lower()
    elif isinstance(value, int):
        kind = "int"
    elif isinstance(value, float):
        kind, text = "double", repr(value)
    elif isinstance(value, (list, tuple)):
        kind, text = "Array(double)", "{" + ", ".join(repr(float(x)) for x in value) + "}"
    return f'<Parameter name="{name}" type="{kind}" value={quoteattr(text)}/>'


def xml(name, content):
    """A parameter list as XML."""
    body = "".join(xml(key, value) if isinstance(value, dict) else parameter(key, value) for key, value in content.items())
    return f'<ParameterList name="{name}">{body}</ParameterList>\n'


FRICTION = {"Type": "Coulomb Friction", "Friction Coefficient": 0.3}


def column(law=None, moduli=(1000.0, 1000.0), pressure=1.0, height=1.0, width=1.0, poisson=0.3, cells=None, shear=0.0,
           steps=None, solver=None, held=True, sides=True, displaced=None, element="Hex8"):
    """Blocks on top of each other along z, pressed from above; all joints obey `law`.

    On rollers at the planes x = 0 and y = 0 (`sides`) and below (`held`) stress is uniaxial, whatever Poisson's ratio:
    the top moves by -pressure sum(height / E) + what the joints give way. `shear` pulls the top along x, `displaced`
    prescribes its displacement along z in the place of the pressure. The responses are `top` along z, `slide` along x,
    `force` of the lowest joint along z and `drag` along x.
    """
    cells = cells or [[2, 2, 2]] * len(moduli)
    names = [f"b{i}" for i in range(len(moduli))]
    top = f"{names[-1]}_zmax"
    boundaries = {}
    if held:
        boundaries["held"] = {"Side Set": "b0_zmin", "Law": {"Type": "Prescribed Displacement", "Z": 0.0}}
    if sides:
        for name in names:
            for axis in "xy":
                boundaries[f"{name}_{axis}"] = {"Side Set": f"{name}_{axis}min",
                                                "Law": {"Type": "Prescribed Displacement", axis.upper(): 0.0}}
    if displaced is not None:
        boundaries["top"] = {"Side Set": top, "Law": {"Type": "Prescribed Displacement", "Z": float(displaced)}}
    else:
        boundaries["top"] = {"Side Set": top, "Law": {"Type": "Prescribed Traction", "Z": -float(pressure), "X": float(shear)}}
    return {
        "Mesh": {"Type": "Boxes", "Boxes": {
            name: {"Lower Corner": [0, 0, i * height], "Upper Corner": [width, width, (i + 1) * height], "Cells": cells[i],
                   "Element": element} for i, name in enumerate(names)}},
        "Materials": {name: {"Type": "Isotropic", "Young's Modulus": float(modulus), "Poisson's Ratio": float(poisson)}
                      for name, modulus in zip(names, moduli)},
        "Parts": {name: {"Material": name} for name in names},
        "Interfaces": {f"j{i}": {"Side 1": f"b{i}_zmax", "Side 2": f"b{i + 1}_zmin", "Law": dict(law or FRICTION)}
                       for i in range(len(names) - 1)},
        "Boundaries": boundaries,
        "Steps": steps or {"load": {}},
        "Solver": {"Accuracy": 1e-6, **(solver or {})},
        "Responses": {"top": {"Type": "Mean Displacement", "Side Set": top, "Direction": [0, 0, 1]},
                      "slide": {"Type": "Mean Displacement", "Side Set": top, "Direction": [1, 0, 0]},
                      "force": {"Type": "Interface Force", "Interface": "j0", "Direction": [0, 0, 1]},
                      "drag": {"Type": "Interface Force", "Interface": "j0", "Direction": [1, 0, 0]}}}
