#!/usr/bin/env python3
"""The block of block.xml under one law of joints after the other, against closed forms.

  joint_laws.py --harmos build/drivers/harmos [--only LAW]

Exit code 1: a run is not certified, or a force, a loss of energy, a height or a field differs from its closed form.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import netCDF4
import numpy

SCENE = pathlib.Path(__file__).resolve().parent / "block.xml"
AREA, AMPLITUDE, PRESSURE = 10.0, 0.05, 10.0
OUT, END = 5, 25  # load steps at which the block is out for the first and the second time
RELATIVE = 1e-4  # of the largest value; the block is not quite rigid


class Run:
    """A law in the place of that of the ground."""

    def __init__(self, harmos, law, settings=(), way=None):
        text = SCENE.read_text()
        entries = "".join(entry(name, value) for name, value in law.items())
        text = re.sub(r'(value="block_ymin"/>\s*<ParameterList name="Law">).*?(</ParameterList>)',
                      lambda match: match[1] + entries + match[2], text, count=1, flags=re.DOTALL)
        if way:
            for name, numbers in zip(("Times", "Values"), way):
                text = re.sub(f'<Parameter name="{name}" type="Array.*?/>', entry(name, numbers), text, count=1)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "block.xml").write_text(text)
            words = [word for setting in settings for word in ("--set", setting)]
            done = subprocess.run([harmos, "run", str(folder / "block.xml"), "--quiet", "--output", name, *words],
                                  capture_output=True, text=True, check=False)
            self.message = done.stdout + done.stderr
            self.is_certified = done.returncode == 0
            if not self.is_certified:
                return
            self.record = json.loads((folder / "block_result.json").read_text())
            header, *rows = (folder / "block_history.csv").read_text().split()
            columns = numpy.array([[float(number) for number in row.split(",")] for row in rows]).T
            self.values = dict(zip(header.split(","), columns))
            with netCDF4.Dataset(folder / "block_interfaces.e") as file:
                file.set_auto_mask(False)
                names = [row.tobytes().split(b"\0")[0].decode() for row in file["name_nod_var"][:]]
                self.fields = {n: file[f"vals_nod_var{i + 1}"][:] for i, n in enumerate(names)}

    def __getitem__(self, response):
        return self.values[response]


def entry(name, value):
    kinds = {bool: "bool", int: "int", float: "double", str: "string", list: "Array(double)"}
    text = "{" + ", ".join(map(str, value)) + "}" if isinstance(value, list) else str(value).lower() \
        if isinstance(value, bool) else str(value)
    return f'<Parameter name="{name}" type="{kinds[type(value)]}" value="{text}"/>'


class Cases:
    """Each yields (what, found, expected, tolerance)."""

    def __init__(self, harmos):
        self.harmos = harmos

    def run(self, law, *settings, way=None):
        run = Run(self.harmos, law, settings, way)
        if not run.is_certified:
            raise RuntimeError(run.message)
        return run

    def slider(self, run, stiffness, limit):
        """A Jenkins element between -A and A."""
        yield "force", run["force"][OUT], limit * AREA, RELATIVE * limit * AREA
        loss = 4 * limit * (AMPLITUDE - (limit / stiffness if stiffness else 0.0)) * AREA
        yield "loss of a cycle", run["lost"][END] - run["lost"][OUT], loss, RELATIVE * loss

    def jenkins(self):
        run = self.run({"Type": "Jenkins", "Tangential Stiffness": 100.0, "Slip Limit": 2.0})
        yield from self.slider(run, 100.0, 2.0)
        way = 5 * AMPLITUDE - 5 * 2.0 / 100.0
        yield "field accumulated_slip", run.fields["accumulated_slip"][END].max(), way, RELATIVE * way
        stored = run.record["last_step"]["interfaces"]["ground"]["stored_energy"]
        yield "stored energy", stored, 0.5 * 4.0 / 100.0 * AREA, RELATIVE

    def compliant_contact(self):
        run = self.run({"Type": "Compliant Contact", "Normal Stiffness": 1e4, "Friction Coefficient": 0.3,
                        "Tangential Stiffness": 100.0})
        yield from self.slider(run, 100.0, 0.3 * PRESSURE)
        yield "height", run["height"][END], -1e-3, 1e-6

    def tabulated_contact(self):
        run = self.run({"Type": "Tabulated Contact", "Overclosures": [-0.01, 0.0, 0.01], "Pressures": [0.0, 5.0, 20.0],
                        "Friction Coefficient": 0.2})
        yield from self.slider(run, 0.0, 0.2 * PRESSURE)
        yield "height", run["height"][END], -0.01 / 3, 1e-6

    def tresca_friction(self):
        yield from self.slider(self.run({"Type": "Tresca Friction", "Shear Limit": 2.0}), 0.0, 2.0)

    def adhesive_friction(self):
        law = {"Type": "Adhesive Friction", "Adhesion": 4.0, "Range": 0.01, "Cohesion": 0.4, "Friction Coefficient": 0.1}
        yield from self.slider(self.run(law), 0.0, 0.4 + 0.1 * PRESSURE)
        yield from self.slider(self.run(law, "Values/pressure=1"), 0.0, 0.4 + 0.1)

    def orthotropic_friction(self):
        law = {"Type": "Orthotropic Friction", "Friction Coefficient 1": 0.2, "Friction Coefficient 2": 0.5}
        yield from self.slider(self.run({**law, "Axis": [1.0, 0.0]}), 0.0, 0.2 * PRESSURE)

    def tangential_plasticity(self):
        stiffness, limit, hardening = 100.0, 2.0, 25.0
        run = self.run({"Type": "Tangential Plasticity", "Tangential Stiffness": stiffness, "Yield Stress": limit,
                        "Kinematic Hardening": hardening})
        there = limit + stiffness * hardening / (stiffness + hardening) * (AMPLITUDE - limit / stiffness)
        yield "force", run["force"][OUT], there * AREA, RELATIVE * there * AREA
        # A parallelogram: the slip goes to and fro by 2 (A - there / k).
        loss = 4 * limit * (AMPLITUDE - there / stiffness) * AREA
        yield "loss of a cycle", run["lost"][END] - run["lost"][OUT], loss, RELATIVE * loss

    def parallel_iwan(self):
        stiffnesses, limits = [100.0, 50.0, 20.0], [0.5, 1.0, 2.0]
        run = self.run({"Type": "Parallel Iwan", "Stiffnesses": stiffnesses, "Slip Limits": limits})
        backbone = lambda u: sum(min(k * u, limit) for k, limit in zip(stiffnesses, limits))
        for step in range(1, OUT + 1):
            expected = backbone(AMPLITUDE * step / OUT) * AREA
            yield f"force at step {step}", run["force"][step], expected, RELATIVE * 50.0
        for step in range(OUT, OUT + 11):  # Masing
            u = AMPLITUDE * (1 - 0.2 * (step - OUT))
            expected = (backbone(AMPLITUDE) - 2 * backbone(0.5 * (AMPLITUDE - u))) * AREA
            yield f"force at step {step}", run["force"][step], expected, RELATIVE * 50.0

    def four_parameter_iwan(self):
        strength, stiffness, chi, beta = 4.0, 50.0, -0.5, 0.2
        run = self.run({"Type": "Four-Parameter Iwan", "Slip Limit": strength, "Tangential Stiffness": stiffness,
                        "Exponent": chi, "Ratio": beta})
        part = (chi + 1) / (chi + 2)
        reach = strength * (1 + beta) / (stiffness * (beta + part))
        density = strength * (chi + 1) / (reach ** (chi + 2) * (beta + part))
        loss = 4 * density * AMPLITUDE ** (chi + 3) / ((chi + 2) * (chi + 3)) * AREA
        yield "loss of a cycle", run["lost"][END] - run["lost"][OUT], loss, 0.02 * loss

    def bouc_wen(self):
        stiffness, limit, ratio, exponent, shape, per_step = 200.0, 2.0, 0.1, 1.5, 0.7, 20
        run = self.run({"Type": "Bouc-Wen", "Tangential Stiffness": stiffness, "Slip Limit": limit,
                        "Residual Stiffness Ratio": ratio, "Exponent": exponent, "Unloading Shape": shape},
                       f"Steps/out/Increments={OUT * per_step}", f"Steps/loop/Increments={(END - OUT) * per_step}")
        hysteretic = (1 - ratio) * stiffness
        bound = limit / hysteretic
        # dz/du of Wen, explicit in steps that are far shorter than those of the scene.
        z, u, lost, dissipated, pieces = 0.0, 0.0, {}, 0.0, 20000
        for step, (end, length) in enumerate([(AMPLITUDE, 1), (-AMPLITUDE, 2), (AMPLITUDE, 2)]):
            du = (end - u) / (pieces * length)
            slope = lambda z: 1 - (abs(z) / bound) ** exponent * (shape * math.copysign(1, z * du) + 1 - shape)
            for _ in range(pieces * length):
                middle = z + 0.5 * du * slope(z)
                dissipated += hysteretic * middle * (1 - slope(middle)) * du
                z += du * slope(middle)
            u = end
            force = (ratio * stiffness * u + hysteretic * z) * AREA
            found = (5, 15, 25)[step] * per_step
            yield f"force at load step {found}", run["force"][found], force, 0.01 * limit * AREA
            lost[found] = dissipated * AREA
        loss = lost[END * per_step] - lost[OUT * per_step]
        yield "loss of a cycle", run["lost"][END * per_step] - run["lost"][OUT * per_step], loss, 0.01 * loss

    def maxwell_glue(self):
        stiffness, viscosity = 40.0, 8.0
        run = self.run({"Type": "Maxwell Glue", "Normal Stiffness": 1e6, "Normal Viscosity": 1e9,
                        "Tangential Stiffness": stiffness, "Tangential Viscosity": viscosity},
                       "Values/pressure=0", way=([0, 0.2, 5], [0, 1, 1]))
        first = stiffness * AMPLITUDE * AREA
        for step in range(1, END + 1):
            expected = first / (1 + 0.2 * stiffness / viscosity) ** step
            yield f"force at step {step}", run["force"][step], expected, RELATIVE * first

    def kelvin_glue(self):
        stiffness, viscosity = 40.0, 8.0
        run = self.run({"Type": "Kelvin Glue", "Normal Stiffness": 1e6, "Normal Viscosity": 1.0,
                        "Tangential Stiffness": stiffness, "Tangential Viscosity": viscosity},
                       "Values/pressure=0", way=([0, 1, 5], [0, 1, 1]))
        for step in range(1, END + 1):
            velocity = AMPLITUDE if step <= OUT else 0.0
            expected = (stiffness * AMPLITUDE * min(1, step / OUT) + viscosity * velocity) * AREA
            yield f"force at step {step}", run["force"][step], expected, RELATIVE * stiffness * AMPLITUDE * AREA

    def archard_wear(self):
        wear, cycles = 1e-3, 4.0
        run = self.run({"Type": "Archard Wear", "Wear Coefficient": wear, "Cycles": cycles,
                        "Friction Coefficient": 0.2}, way=([0, 5], [0, 5]))
        yield "force", run["force"][END], 0.2 * PRESSURE * AREA, RELATIVE * 20.0
        depth = wear * cycles * PRESSURE * AMPLITUDE * 0.2
        for step in range(1, END + 1):
            expected = depth * step if step > 1 else 0.0  # that of the first one is worn off in the second
            yield f"height at step {step}", run["height"][step], -expected, RELATIVE * END * depth
            worn = run.fields["wear"][step].max()
            yield f"field wear at step {step}", worn, expected, 1e-3 * END * depth
        yield "field wear_lag at step 1", run.fields["wear_lag"][1].max(), depth, 0.2 * depth
        yield "field wear_lag at the end", run.fields["wear_lag"][END].max(), 0.0, 1e-3 * depth

    def rate_dependent_friction(self):
        rest, moving, scale = 0.3, 0.1, 0.05
        run = self.run({"Type": "Rate-Dependent Friction", "Static Coefficient": rest, "Kinetic Coefficient": moving,
                        "Velocity": scale}, way=([0, 5], [0, 5]))
        for step in range(1, END + 1):
            speed = 0.0 if step == 1 else AMPLITUDE
            expected = (moving + (rest - moving) * math.exp(-speed / scale)) * PRESSURE * AREA
            yield f"force at step {step}", run["force"][step], expected, 1e-3 * rest * PRESSURE * AREA
        # Friction that rises does not lag.
        run = self.run({"Type": "Rate-Dependent Friction", "Static Coefficient": moving, "Kinetic Coefficient": rest,
                        "Velocity": scale}, way=([0, 5], [0, 5]))
        for step in range(1, END + 1):
            expected = (rest + (moving - rest) * math.exp(-AMPLITUDE / scale)) * PRESSURE * AREA
            yield f"force at step {step}", run["force"][step], expected, 1e-3 * rest * PRESSURE * AREA


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--only", help="one of the laws, as the functions of Cases are called")
    arguments = parser.parse_args()
    cases = Cases(arguments.harmos)
    names = [n for n in vars(Cases) if not n.startswith("_") and n not in ("run", "slider")]
    is_good = True
    for name in [arguments.only] if arguments.only else names:
        try:
            for what, found, expected, tolerance in getattr(cases, name)():
                if not abs(found - expected) <= tolerance:
                    print(f"{name}: {what} is {found:.9g}, {expected:.9g} was expected within {tolerance:.2g}")
                    is_good = False
        except RuntimeError as error:
            print(f"{name}: {error}")
            is_good = False
        else:
            print(f"{name}: checked")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
