#!/usr/bin/env python3
"""Harmos beside CalculiX at equal total error, the error of the mesh and of the solver together, on the bolted joint.

Both are held against a mesh that is much finer. Every mesh is solved once by each program, whole processes, one thread;
the error is the largest distance of the load-displacement curve from the fine one, over its largest value. The load of the
scene is lowered, see LOAD. CalculiX has surface-to-surface contact by penalty (the one it takes fewest iterations with
among --penalty whose error is within a tenth of the least) and reduced integration of hexahedra of second degree (C3D20R).
For each run of CalculiX the ratio is that of its CPU time to that of the cheapest run of Harmos whose error is not larger.

  total_error.py --harmos build/drivers/harmos --deck-writer build/tests/benchmarks/calculix_deck
"""
import argparse
import os
import pathlib
import sys
import tempfile
import types
import xml.etree.ElementTree as xml

import compare_with_calculix as pair

# Little more than half of the load at sliding: at that of the scene, 95 %, CalculiX does not converge with C3D20R.
LOAD = {"Values/traction": "2.0", "Steps/load/Increments": "4"}
# CalculiX's names of the generator's elements, whose nodes follow the circles.
CALCULIX = {"Hex8": "C3D8", "Hex20": "C3D20R"}


def scene_of(source, mesh, folder):
    """The scene with another mesh, as a file."""
    tree = xml.parse(source)
    entry = next(element for element in tree.getroot() if element.get("name") == "Mesh")
    xml.SubElement(entry, "Parameter", name="Refinement", type="double", value=str(mesh[0]))
    xml.SubElement(entry, "Parameter", name="Element", type="string", value=mesh[1])
    for name, value in LOAD.items():
        place = tree.getroot()
        for word in name.split("/"):
            place = next(element for element in place if element.get("name") == word)
        place.set("value", value)
    path = os.path.join(folder, pathlib.Path(source).name)
    tree.write(path)
    return path


def mesh_of(text):
    """Refinement and element, such as 0.5:Hex20."""
    refinement, element = text.split(":")
    if element not in CALCULIX:
        raise argparse.ArgumentTypeError(f"{element} is none of {', '.join(CALCULIX)}")
    return float(refinement), element


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--deck-writer", required=True, help="tests/benchmarks/calculix_deck of the build")
    parser.add_argument("--calculix", default="ccx")
    parser.add_argument("--scene", default=os.path.join(pair.ROOT, "xml", "bolted_joint.xml"))
    parser.add_argument("--accuracy", type=float, default=1e-3, help="of the solver of Harmos")
    parser.add_argument("--penalty", type=float, nargs="+", default=[5e4], help="pressure per overclosure")
    parser.add_argument("--stick", type=float, default=0.1, help="stick slope per penalty")
    parser.add_argument("--fine", type=mesh_of, default=mesh_of("1:Hex20"), help="mesh of the reference")
    parser.add_argument("--meshes", type=mesh_of, nargs="+",
                        default=[mesh_of(text) for text in ("0.25:Hex8", "0.5:Hex8", "1:Hex8", "1.5:Hex8", "0.25:Hex20", "0.5:Hex20")])
    parser.add_argument("--rivals", type=mesh_of, nargs="+",
                        default=[mesh_of(text) for text in ("0.25:Hex8", "0.5:Hex8", "0.25:Hex20")], help="for CalculiX")
    arguments = parser.parse_args()
    for name in ("harmos", "deck_writer", "scene"):
        setattr(arguments, name, os.path.abspath(getattr(arguments, name)))
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

    def settings(mesh, folder):
        return types.SimpleNamespace(**{**vars(arguments), "scene": scene_of(arguments.scene, mesh, folder)})

    with tempfile.TemporaryDirectory() as folder:
        pair.run_harmos(settings(arguments.fine, folder), folder, environment, {0.0: 0.0, 1.0: 1.0})
        curve = pair.harmos_curve(folder, pathlib.Path(arguments.scene).stem)
        reference = {time: value for time, value in curve.items() if time > 0}  # CalculiX prints no unloaded state
    print("| program | mesh | total error of u_load | CPU s | peak memory MB | ratio |\n|---|---|---|---|---|---|")
    runs = []
    for mesh in arguments.meshes:
        with tempfile.TemporaryDirectory() as folder:
            result = pair.run_harmos(settings(mesh, folder), folder, environment, reference)
        runs.append(result)
        print(f"| Harmos | refinement {mesh[0]:g}, {mesh[1]} | {100 * result['error']:.2f} % | {result['cpu']:.1f} | "
              f"{result['memory']:.0f} | |", flush=True)
    for mesh in arguments.rivals:
        tried = []
        for penalty in arguments.penalty:
            with tempfile.TemporaryDirectory() as folder:
                tried.append((penalty, pair.run_calculix(settings(mesh, folder), penalty, folder, environment, reference)))
        if any(result["error"] != result["error"] for _, result in tried):
            sys.exit(f"CalculiX did not solve all load steps on refinement {mesh[0]:g}, {CALCULIX[mesh[1]]}")
        least = min(result["error"] for _, result in tried)
        penalty, result = min((one for one in tried if one[1]["error"] <= 1.1 * least), key=lambda one: one[1]["cpu"])
        rivals = [run["cpu"] for run in runs if run["error"] <= result["error"]]
        ratio = f"{result['cpu'] / min(rivals):.0f}" if rivals else "none"
        print(f"| CalculiX, penalty {penalty:.0e} | refinement {mesh[0]:g}, {CALCULIX[mesh[1]]} | {100 * result['error']:.2f} % | "
              f"{result['cpu']:.1f} | {result['memory']:.0f} | {ratio} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
