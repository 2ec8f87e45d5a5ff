#!/usr/bin/python3
"""A response with a kink: polynomial chaos of several orders and adaptive interpolation against the exact law.

The force of two bars with a normal gap g between them, pushed by U = 0.15 mm, is N = 75000 max(0, U - g). Prints errors
relative to the standard deviation of N: of mean, standard deviation and quantiles (largest of 1 % .. 99 %), and the
share of these quantiles that are below 0, which contact excludes.

  random_gap.py --harmos build/drivers/harmos [--picture FILE.png] [--check]
"""
import argparse
import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "packages" / "python"))
from harmos import read_study

PUSH, MEAN, DEVIATION, STIFFNESS = 0.15, 0.12, 0.04, 75000.0
LEVELS = numpy.arange(1, 100) / 100
NORMAL = statistics.NormalDist()
ORDERS = (1, 2, 3, 5, 8, 12, 16)
SAMPLES = 200000


def exact():
    """Mean, standard deviation, quantiles of N."""
    m, s = PUSH - MEAN, DEVIATION
    closed, peak = NORMAL.cdf(m / s), NORMAL.pdf(m / s)
    mean = m * closed + s * peak
    square = (m * m + s * s) * closed + m * s * peak
    quantiles = [max(0.0, m + s * NORMAL.inv_cdf(level)) for level in LEVELS]
    return STIFFNESS * mean, STIFFNESS * numpy.sqrt(square - mean * mean), STIFFNESS * numpy.array(quantiles)


def solve(harmos, folder, *changes):
    levels = "{" + ", ".join(f"{level:g}" for level in LEVELS) + "}"
    options = [word for change in (*changes, "Design/Hold-Out Count=0", f"Statistics/Quantiles={levels}",
                                   f"Statistics/Samples={SAMPLES}", "Statistics/Seed=5") for word in ("--set", change)]
    subprocess.run([harmos, "study", str(ROOT / "xml" / "random_gap.xml"), "--output", folder, "--restart", "--quiet",
                    *options], check=True)
    return read_study(pathlib.Path(folder) / "random_gap.h5")


def figures(study):
    """Errors of mean, standard deviation and quantiles, and P(N < 0)."""
    mean, deviation, quantiles = exact()
    response = study.statistics.responses["N"]
    pull = (response.quantiles < -1e-3 * deviation).mean()
    return (abs(response.mean - mean) / deviation, abs(response.standard_deviation - deviation) / deviation,
            numpy.abs(response.quantiles - quantiles).max() / deviation, pull)


def draw(path, expansions, adaptive):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    gaps = numpy.linspace(MEAN - 3 * DEVIATION, MEAN + 3 * DEVIATION, 400)
    left.plot(gaps, STIFFNESS * numpy.maximum(0, PUSH - gaps), color="black", linewidth=1, label="exact")
    right.plot(exact()[2], LEVELS, color="black", linewidth=1, label="exact")
    for (order, study), colour in zip(expansions.items(), ("#d95f02", "#7570b3")):
        left.plot(gaps, study.statistics.expansion("N")(gap=gaps), color=colour, linewidth=1,
                  label=f"chaos, order {order}")
        right.plot(study.statistics.responses["N"].quantiles, LEVELS, color=colour, linewidth=1,
                   label=f"chaos, order {order}")
    shown = numpy.abs(adaptive.parameters["gap"] - MEAN) <= 3 * DEVIATION
    left.plot(adaptive.parameters["gap"][shown], adaptive.responses["N"][shown], "o", color="#1b9e77", markersize=4,
              label="adaptive, solved")
    right.plot(adaptive.statistics.responses["N"].quantiles, LEVELS, "o", color="#1b9e77", markersize=2.5,
               label="adaptive")
    left.set_xlabel("gap [mm]")
    left.set_ylabel("contact force [N]")
    right.set_xlabel("contact force [N]")
    right.set_ylabel("probability")
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--harmos", required=True, help="the program")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file to draw")
    parser.add_argument("--check", action="store_true", help="fail unless chaos is wrong and the interpolation right")
    arguments = parser.parse_args()

    print(f"{'method':24}{'solved':>8}{'mean':>10}{'std':>10}{'quantiles':>11}{'P(N < 0)':>10}")
    expansions, errors = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        for order in ORDERS:
            study = solve(arguments.harmos, folder, "Design/Type=Chaos", f"Design/Order={order}")
            expansions[order], errors[order] = study, figures(study)
            print_row(f"chaos, order {order}", f"{order + 1}", errors[order])
        for tolerance in (1e-2, 1e-3):
            adaptive = solve(arguments.harmos, folder, f"Design/Tolerance={tolerance:g}")
            ours = figures(adaptive)
            print_row(f"adaptive, {tolerance:g}", adaptive.statistics.solved, ours)
    if arguments.picture:
        draw(arguments.picture, {order: expansions[order] for order in (3, 12)}, adaptive)
    if not arguments.check:
        return 0
    isWrong = all(error[2] > 0.05 and error[3] > 0.02 for error in errors.values())
    isRight = ours[0] < 2e-3 and ours[1] < 2e-3 and ours[2] < 0.02 and ours[3] == 0
    return 0 if isWrong and isRight else 1


def print_row(method, solved, errors):
    print(f"{method:24}{solved:>8}" + "".join(f"{100 * error:>8.2f} %" for error in errors[:2]) +
          f"{100 * errors[2]:>9.2f} %{100 * errors[3]:>8.1f} %")


if __name__ == "__main__":
    sys.exit(main())
