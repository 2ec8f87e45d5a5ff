"""A study file like those that Harmos writes: two parameters on a grid of 3 x 2, one response, one curve."""
import pathlib
import zlib

import h5py
import numpy

from harmos.arrays import Floats

MU: Floats = numpy.repeat([0.1, 0.2, 0.3], 2)
LOAD: Floats = numpy.tile([10.0, 20.0], 3)


def ordered(group: h5py.Group, arrays: dict[str, Floats]) -> None:
    """Arrays of a group, and their order."""
    group.attrs["order"] = list(arrays)
    for name, values in arrays.items():
        group[name] = values


def seal(path: pathlib.Path) -> None:
    """Puts the checksum behind a file."""
    content = path.read_bytes()
    path.write_bytes(content + b"harmos:%08x\n" % zlib.crc32(content))


def write(path: pathlib.Path, version: int = 1, schema: str = "harmos-study") -> None:
    """The last configuration has no solution."""
    with h5py.File(path, "w") as file:
        file.attrs.update(schema=schema, schema_version=version, program_version="0.1.0")
        study = file.create_group("joint")
        study.attrs.update(title="A <joint>", scene="joint.xml", accuracy=1e-3, state="complete")
        ordered(study.create_group("parameters"), {"mu": MU, "load": LOAD, "twice": 2 * MU})
        for name, unit, formula in (("mu", "", ""), ("load", "N", ""), ("twice", "", "2 * mu")):
            study["parameters"][name].attrs.update(unit=unit, formula=formula, entries=[f"Values/{name}"],
                                                   phase="local stage")
        force = MU * LOAD
        force[-1] = numpy.nan
        ordered(study.create_group("responses"), {"F": force})
        ordered(study.create_group("curves"), {"force": numpy.column_stack([force / 2, force])})
        study["curve_errors/force"] = numpy.full(6, 1e-4)
        study["times"] = [1.0, 2.0]
        rows = study.create_group("configurations")
        rows["status"] = ["certified"] * 4 + ["calibrated", "no equilibrium"]
        rows["reason"] = [""] * 5 + ["too much"]
        rows["id"], rows["iterations"], rows["linear_stages"] = numpy.arange(1, 7), numpy.full(6, 9), numpy.full(6, 10)
        rows["error_estimate"], rows["cpu_seconds"] = numpy.full(6, 5e-4), numpy.full(6, 0.1)
        rows["starts"] = numpy.array([[0], [1], [1], [2], [3], [0]])
        study.create_group("notes").attrs["audit"] = "1 of 1"
        study.create_group("left_out").attrs["not too tight"] = 3
        study.create_group("input").attrs.update(study="<Study/>", scene="<Scene/>")
    seal(path)
