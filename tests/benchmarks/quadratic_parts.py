#!/usr/bin/env python3
"""What quadratic parts cost beside linear ones of equally many degrees of freedom: assembly, factor, memory.

A block under tension, held at one face, of hexahedra and of tetrahedra. Quadratic elements have more neighbours per node,
so that the matrix has more entries and its factor is fuller.

  quadratic_parts.py --harmos build/drivers/harmos [--cells N] [--runs N]
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENE = os.path.join(ROOT, "tests", "verification", "perfect", "beam.xml")
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
              "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def nodes(element, cells):
    """Nodes of a block of `cells` in each direction."""
    n = cells
    corners, edges = (n + 1) ** 3, 3 * n * (n + 1) ** 2
    return {"Hex8": corners, "Tet4": corners, "Hex20": corners + edges, "Hex27": (2 * n + 1) ** 3,
            "Tet10": (2 * n + 1) ** 3}[element]


def run(harmos, element, cells, directory):
    sizes = "{%d, %d, %d}" % (cells, cells, cells)
    subprocess.run([harmos, "run", SCENE, "--quiet", "--output", directory, "--set", f"Mesh/Boxes/beam/Element={element}",
                    "--set", f"Mesh/Boxes/beam/Cells={sizes}", "--set", "Mesh/Boxes/beam/Upper Corner={20, 20, 20}"],
                   check=True, env=dict(os.environ, **ONE_THREAD))
    with open(os.path.join(directory, "beam_result.json")) as file:
        return json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--cells", type=int, default=20, help="of the linear block, in each direction")
    parser.add_argument("--runs", type=int, default=3, help="medians are printed")
    arguments = parser.parse_args()

    wanted = nodes("Hex8", arguments.cells)
    print("| element | cells | unknowns | assemble CPU s | factor CPU s | peak memory MB | assemble | factor | memory |")
    print("|---|---|---|---|---|---|---|---|---|")
    reference = {}
    for element in ("Hex8", "Hex20", "Hex27", "Tet4", "Tet10"):
        cells = min(range(1, arguments.cells + 1), key=lambda n: abs(nodes(element, n) - wanted))
        with tempfile.TemporaryDirectory() as directory:
            records = [run(arguments.harmos, element, cells, directory) for _ in range(arguments.runs)]

        def median(value):
            return statistics.median(value(record) for record in records)

        figures = [median(lambda r: r["phases"]["assemble"]["cpu_seconds"]),
                   median(lambda r: r["phases"]["factor"]["cpu_seconds"]), median(lambda r: r["peak_memory_bytes"] / 1e6)]
        linear = reference.setdefault(element[:3], figures)
        ratios = " | ".join(f"{mine / other:.2f}" for mine, other in zip(figures, linear))
        print(f"| {element} | {cells}^3 | {3 * nodes(element, cells)} | {figures[0]:.2f} | {figures[1]:.2f} | "
              f"{figures[2]:.0f} | {ratios} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
