#!/usr/bin/python3
"""Solves the glued assembly with random glue by the command line, every way there is, and compares with references.

chaos.py HARMOS STUDY.xml WORK_DIR [monte_carlo]

STUDY is xml/glued_assembly_chaos.xml. References: an independent prototype's direct solutions of the same mesh (normal:
Galerkin on orthonormal Hermite polynomials). With `monte_carlo`, instead of all that: 10 000 draws and the expansion.
"""
import csv
import io
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy

from checks import check, finish

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
from harmos import read_study

HARMOS, STUDY, WORK = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
NAME = STUDY.stem
LOGNORMAL = [f"Parameters/E_{i}/Distribution/Type=Lognormal" for i in (1, 2)]
NO_SWEEP = ["Sweep/d_1/Values={0.2}", "Sweep/d_2/Values={0.2}"]


def near(value, expected, tolerance, what):
    check(abs(value - expected) <= tolerance, f"{what}: {value!r} is not {expected!r} to {tolerance:g}")


def run(folder, changes, code=0, study=STUDY, words=("--restart",)):
    """What `harmos study` prints with these changes of the study."""
    options = [word for change in changes for word in ("--set", change)]
    done = subprocess.run([HARMOS, "study", str(study), "--output", str(WORK / folder), *words, *options],
                          capture_output=True, text=True)
    check(done.returncode == code, f"{folder}: exit code {done.returncode}, not {code}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def results(folder):
    return read_study(WORK / folder / f"{NAME}.h5")


def table(folder, which):
    with open(WORK / folder / f"{NAME}_{which}.csv", newline="") as file:
        return list(csv.DictReader(file))


def moments_are(folder, references, tolerance):
    """Mean and standard deviation to a share of the standard deviation; skewness and kurtosis, where given."""
    rows = {row["response"]: row for row in table(folder, "moments")}
    for name, (mean, deviation, *others) in references.items():
        near(float(rows[name]["mean"]), mean, tolerance * deviation, f"{folder}: mean of {name}")
        near(float(rows[name]["std"]), deviation, tolerance * deviation, f"{folder}: std of {name}")
        for which, expected in zip(("skewness", "kurtosis"), others):
            near(float(rows[name][which]), expected, tolerance * abs(expected), f"{folder}: {which} of {name}")


def sobol_is(folder, references, tolerance):
    rows = {(row["response"], row["variables"]): float(row["main"]) for row in table(folder, "sobol")}
    for key, expected in references.items():
        near(rows[key], expected, tolerance, f"{folder}: Sobol' index {key}")


NORMAL_MOMENTS = {"u_A_x": (-2.0976499, 0.0301836, -0.9351555, 4.8429719),
                  "u_A_y": (0.3371276, 0.0070239, 1.1256079, 5.4753599)}
NORMAL_COEFFICIENTS = {(0, 0): 0.3371276, (1, 0): -6.193249e-3, (0, 1): -2.592768e-3, (2, 0): 1.639562e-3,
                       (0, 2): 1.041099e-3, (3, 0): -5.392831e-4, (0, 3): -4.406357e-4}
NORMAL_SWEEP = {0.2: 6.727391e-3, 0.3: 13.820518e-3, 0.4: 66.612424e-3}
LOGNORMAL_MOMENTS = {"u_A_y": (0.336874291, 0.006079107, 0.346159375, 3.256657337),
                     "u_A_x": (-2.097056445, 0.027329686, -0.177448694, 3.105853282)}
LOGNORMAL_SWEEP = {0.2: 5.927806e-3, 0.4: 12.633409e-3}


def sweep_is(folder, references, tolerance):
    rows = {(float(row["d_1"]), float(row["d_2"])): float(row["u_A_y_std"]) for row in table(folder, "sweep")}
    for d, deviation in references.items():
        near(rows[d, d], deviation, tolerance * deviation, f"{folder}: std of u_A_y at ({d}, {d})")


def normal_glue():
    printed = run("normal", ["Sweep/d_1/Values={0.2, 0.3, 0.4}", "Sweep/d_2/Values={0.2, 0.3, 0.4}"])
    for text in ("P(E_1 <= 0) = 2.867e-07", "P(E_2 <= 0) = 3.167e-05",
                 "values up to 0.4, of 0.4; WARNING: at the outermost of 4 Gauss points only 6.62"):
        check(text in printed, f"normal: not printed: {text}\n{printed}")
    # The references have five to seven digits.
    deviation = NORMAL_MOMENTS["u_A_y"][1]
    rows = {(int(row["E_1"]), int(row["E_2"])): float(row["coefficient"])
            for row in table("normal", "coefficients") if row["response"] == "u_A_y"}
    check(not results("normal").statistics.is_sample, "figures of an expansion are not those of a sample")
    check(list(rows) == [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)],
          f"order of coefficients: {list(rows)}")
    for degrees, value in rows.items():
        if degrees in NORMAL_COEFFICIENTS:
            near(value, NORMAL_COEFFICIENTS[degrees], 1e-5 * deviation, f"coefficient {degrees} of u_A_y")
        else:
            near(value, 0.0, 2e-7, f"coefficient {degrees} of u_A_y")
    moments_are("normal", NORMAL_MOMENTS, 1e-5)
    sobol_is("normal", {("u_A_y", "E_1"): 0.837836, ("u_A_y", "E_2"): 0.162164}, 1e-6)
    sweep_is("normal", NORMAL_SWEEP, 1e-5)


def resumed():
    before = table("normal", "coefficients")
    lines = (WORK / "normal" / f"{NAME}.journal").read_text().splitlines()
    printed = run("normal", ["Sweep/d_1/Values={0.2, 0.3, 0.4}", "Sweep/d_2/Values={0.2, 0.3, 0.4}"], words=())
    check("5 of them are known from an earlier run" in printed, f"resumed: {printed}")
    now = (WORK / "normal" / f"{NAME}.journal").read_text().splitlines()
    solved = [sum('"id"' in line for line in each) for each in (lines, now)]
    check(solved[0] == solved[1], f"solved again: {solved}")
    check(before == table("normal", "coefficients"), "resumed: other coefficients")
    printed = run("normal", NO_SWEEP, 2, words=())
    check("Sweep / d_1 / Values" in printed, f"a changed sweep is taken for the same study: {printed}")


def from_python():
    study = results("normal")
    statistics = study.statistics
    values = {"E_1": 550.0, "E_2": 900.0}
    for name, response in statistics.responses.items():
        expansion = statistics.expansion(name)
        near(expansion.mean, response.mean, 1e-12, f"{name}: mean from coefficients")
        near(expansion.standard_deviation, response.standard_deviation, 1e-12, f"{name}: std from coefficients")
        sample = expansion.sample(200000, seed=1)
        near(sample.mean(), response.mean, 0.01 * response.standard_deviation, f"{name}: mean of a sample")
        near(sample.std(), response.standard_deviation, 0.02 * response.standard_deviation, f"{name}: std of a sample")
        # The configurations held out give the error in the table.
        predicted = expansion(**{variable: study.parameters[variable] for variable in statistics.variables})
        error = numpy.sqrt(((predicted - study.responses[name]) ** 2).mean()) / response.standard_deviation
        near(error, response.hold_out_error, 1e-3 * response.hold_out_error + 1e-6, f"{name}: hold-out error")
        solved = study.responses[name][0]
        near(predicted[0], solved, 5 * response.hold_out_error * response.standard_deviation, f"{name}: held out")
    command = [HARMOS, "predict", str(WORK / "normal" / f"{NAME}.h5")]
    printed = subprocess.run(command + ["--at", "E_1=550", "--at", "E_2=900"], capture_output=True, text=True).stdout
    row = next(csv.DictReader(io.StringIO(printed)))
    for name, response in statistics.responses.items():
        near(float(row[name]), statistics.expansion(name)(**values)[0], 1e-12 * abs(response.mean), f"predict {name}")
        near(float(row[f"{name}_deviation"]) / (response.hold_out_error * response.standard_deviation), 2.5706 / 1.96, 1e-3,
             f"predict {name}_deviation")
    check(row["extrapolated"] == "0", printed)
    far = subprocess.run(command + ["--at", "E_1=900", "--at", "E_2=900"], capture_output=True, text=True).stdout
    check(far.endswith(",1\n"), f"beyond the outermost Gauss point: {far}")


def lognormal_glue():
    run("lognormal", LOGNORMAL + ["Design/Order=6", "Design/Hold-Out Count=0", "Sweep/d_1/Values={0.2, 0.4}",
                                  "Sweep/d_2/Values={0.2, 0.4}"])
    moments_are("lognormal", LOGNORMAL_MOMENTS, 1e-4)
    sobol_is("lognormal", {("u_A_y", "E_1"): 0.870854, ("u_A_y", "E_2"): 0.129146}, 1e-5)
    sweep_is("lognormal", LOGNORMAL_SWEEP, 1e-4)
    check(len(results("lognormal").id) == 0, "no configuration is held out")
    done = subprocess.run([HARMOS, "report", str(WORK / "lognormal" / f"{NAME}.h5")], capture_output=True, text=True)
    check(done.returncode == 0, f"report without configurations: {done.stderr}")


def guards():
    printed = run("refused", NO_SWEEP + ["Parameters/E_1/Distribution/Coefficient of Variation=0.45"], 2)
    check("a coefficient of variation well below 0.428" in printed, f"remedy: {printed}")
    check(not (WORK / "refused").exists(), "a refused study leaves files")
    printed = run("refused", ["Sweep/d_1/Values={0.2, 0.45}"], 2)
    check("Sweep / d_1 / Values" in printed, f"sweep beyond the guard: {printed}")
    # A lognormal parameter needs more Gauss points, but none at which the other one would be negative.
    run("mixed", NO_SWEEP + LOGNORMAL[:1] + ["Design/Hold-Out Count=0"])
    near(float(table("mixed", "moments")[2]["std"]), 2.23917, 1e-4, "mixed: std of F_N_max_I, which is E_1's alone")
    printed = run("wide", NO_SWEEP + ["Parameters/E_1/Distribution/Coefficient of Variation=0.36",
                                      "Design/Hold-Out Count=0"])
    check("WARNING: at the outermost of 4 Gauss points only 15.96 % of the mean is left" in printed, printed)
    run("constant", NO_SWEEP + [f"Parameters/E_{i}/Distribution/Coefficient of Variation=0" for i in (1, 2)] +
        ["Design/Hold-Out Count=0"])
    check(all(row["main"] == row["total"] == "n/a" for row in table("constant", "sobol")), "Sobol' at zero variance")
    check(all(row["std"] == "0" and row["skewness"] == "n/a" for row in table("constant", "moments")),
          "moments at zero variance")
    near(float(table("constant", "moments")[1]["mean"]), 0.33549566, 1e-8, "u_A_y at the means")


def order_by_tolerance():
    printed = run("tolerance", NO_SWEEP + LOGNORMAL + ["Design/Tolerance=1e-3", "Design/Order=8",
                                                       "Design/Hold-Out Count=0"])
    statistics = results("tolerance").statistics
    check("order 4: standard deviations changed by" in printed and statistics.basis.order == 4, printed)
    moments_are("tolerance", {name: each[:2] for name, each in LOGNORMAL_MOMENTS.items()}, 1e-4)
    near(statistics.convergence.standard_deviation["u_A_y"][-1], 0.006079107, 1e-8, "last of the convergence")
    printed = run("tolerance", NO_SWEEP + LOGNORMAL + ["Design/Tolerance=1e-9", "Design/Order=3"], 3)
    check("still change by more than the tolerance" in printed, printed)


def other_methods():
    run("random", ["Design/Type=Random", "Design/Count=200", "Accuracy=1e-3",
                   "Parameters/E_1/Distribution/Coefficient of Variation=0.5"], 3)
    study = results("random")
    refused = (study.status == "inadmissible").sum()
    check(refused == (study.parameters["E_1"] < 0).sum() > 0, f"{refused} inadmissible draws")
    check(study.statistics.inadmissible == refused and study.statistics.solved == 200 - refused, "counted draws")
    check(study.statistics.is_sample, "figures of random configurations are those of a sample")
    run("adaptive", LOGNORMAL + ["Design/Type=Adaptive Collocation", "Accuracy=1e-5"])
    moments_are("adaptive", {name: each[:2] for name, each in LOGNORMAL_MOMENTS.items()}, 1e-3)
    moments_are("adaptive", LOGNORMAL_MOMENTS, 0.1)  # of a sample of the interpolation
    check(not results("adaptive").statistics.is_sample, "figures of an interpolation are not those of a sample")
    sobol_is("adaptive", {("u_A_y", "E_1"): 0.870854, ("u_A_y", "E_2"): 0.129146}, 0.02)
    run("sparse", LOGNORMAL + ["Design/Type=Collocation", "Design/Points In=Sparse", "Design/Order=4"])
    moments_are("sparse", LOGNORMAL_MOMENTS, 2e-4)
    for name in ("random", "adaptive"):
        done = subprocess.run([HARMOS, "report", str(WORK / name / f"{NAME}.h5")], capture_output=True, text=True)
        check(done.returncode == 0, f"report of {name}: {done.stderr}")


def with_distribution(name, entries, correlation=None):
    """The study with another distribution of E_1, without sweep, coarse."""
    tree = ElementTree.parse(STUDY)
    root = tree.getroot()
    find = {each.get("name"): each for each in root}
    root.remove(find["Sweep"])
    find["Scene"].set("value", str(STUDY.parent / "glued_assembly.xml"))
    parameter = next(each for each in find["Parameters"] if each.get("name") == "E_1")
    old = next(each for each in parameter if each.get("name") == "Distribution")
    if entries:
        old[:] = [ElementTree.Element("Parameter", {"name": key, "type": kind, "value": value})
                  for key, kind, value in entries]
    if correlation:
        pairs = ElementTree.SubElement(ElementTree.SubElement(root, "ParameterList", {"name": "Correlations"}),
                                       "ParameterList", {"name": "both"})
        ElementTree.SubElement(pairs, "Parameter", {"name": "Parameters", "type": "Array(string)",
                                                    "value": "{E_1, E_2}"})
        ElementTree.SubElement(pairs, "Parameter", {"name": "Coefficient", "type": "double", "value": correlation})
    path = WORK / f"{name}.xml"
    tree.write(path)
    return path


def number(name, value):
    return name, "double", str(value)


def kind(value):
    return "Type", "string", value


def distributions():
    spread = [number("Mean", 500), number("Coefficient of Variation", 0.2)]
    draws = numpy.random.default_rng(3).gamma(25, 20, 200)
    (WORK / "draws.csv").write_text("E_1\n" + "\n".join(map(repr, map(float, draws))) + "\n")
    for name, entries, mean, deviation in (
            ("uniform", [kind("Uniform"), *spread], 500, 100),
            ("bounds", [kind("Uniform"), number("Lower", 300), number("Upper", 600)], 450, 300 / numpy.sqrt(12)),
            ("beta", [kind("Beta"), number("Lower", 200), number("Upper", 800), number("Alpha", 2), number("Beta", 3)],
             440, 120),
            ("truncated", [kind("Truncated Normal"), *spread, number("Lower", 400), number("Upper", 600)], 500, None),
            ("sample", [kind("Sample"), ("File", "string", "draws.csv")], draws.mean(), draws.std())):
        study = with_distribution(name, entries)
        printed = run(name, ["Scene/Mesh/Cell Size=1", "Accuracy=1e-5"], study=study)
        check("P(E_1 <= 0) = 0" in printed, f"{name}: {printed}")
        statistics = read_study(WORK / name / f"{name}.h5").statistics
        germ = statistics.basis.germs["E_1"]
        # The figures of the parameter itself, from germs drawn in Python.
        drawn = germ.shift + germ.scale * germ.sample(100000, numpy.random.default_rng(1))
        near(drawn.mean(), mean, 0.02 * drawn.std(), f"{name}: mean of E_1")
        if deviation:
            near(drawn.std(), deviation, 0.02 * deviation, f"{name}: std of E_1")
        # Each expansion is right where it was checked, and the sample of it agrees with its coefficients.
        for response, each in statistics.responses.items():
            check(each.hold_out_error < 0.1, f"{name}: hold-out error of {response} {each.hold_out_error}")
            sample = statistics.expansion(response).sample(100000, seed=2)
            near(sample.std(), each.standard_deviation, 0.03 * each.standard_deviation, f"{name}: sample of {response}")
    study = with_distribution("correlated", None, "0.5")
    run("correlated", ["Scene/Mesh/Cell Size=1", "Accuracy=1e-5"], study=study)
    path = WORK / "correlated" / "correlated.h5"
    statistics = read_study(path).statistics
    check(not statistics.independent, "correlated parameters")
    # Correlated germs add up: more variance than with independent ones, all else equal.
    run("independent", ["Scene/Mesh/Cell Size=1", "Accuracy=1e-5"], study=with_distribution("independent", None))
    alone = read_study(WORK / "independent" / "independent.h5").statistics
    main = alone.responses["u_A_y"].sobol
    expected = numpy.sqrt(1 + 2 * 0.5 * numpy.sqrt(main["E_1"][0] * main["E_2"][0]))
    ratio = statistics.responses["u_A_y"].standard_deviation / alone.responses["u_A_y"].standard_deviation
    near(ratio, expected, 0.05, "correlated: ratio of standard deviations")
    # Together the germs reach further than each alone, to a corner of four by four points.
    printed = run("together", ["Parameters/E_2/Distribution/Coefficient of Variation=0.32"], 2, study=study)
    check("Correlations / both: an expansion of order 3 needs E_1 = 266.6, E_2 = -20.44" in printed,
          f"corner of correlated germs: {printed}")
    check(not (WORK / "together").exists(), "a refused study leaves files")
    done = subprocess.run([HARMOS, "predict", str(path), "--at", "E_1=550", "--at", "E_2=900"], capture_output=True,
                          text=True)
    check(done.returncode == 2 and "Evaluate them in germs from Python" in done.stderr, f"correlated: {done.stderr}")
    near(statistics.expansion("u_A_y").evaluate([[0, 0]])[0], alone.expansion("u_A_y").evaluate([[0, 0]])[0],
         1e-3 * alone.responses["u_A_y"].standard_deviation, "correlated: at the means")


def random_history():
    """A bar in two pieces is pulled by 0.1 at a rate that is random: its end moves by 0.1 / T, T uniform in 1.5 .. 2.5."""
    run("bar", [], study=pathlib.Path(__file__).resolve().parent / "pulled_bar_study.xml")
    reaction = read_study(WORK / "bar" / "pulled_bar_study.h5").statistics.responses["R"]
    mean, square = 25 * numpy.log(2.5 / 1.5), 25**2 * (1 / 1.5 - 1 / 2.5)
    # An expansion of order 3 leaves 3e-5 of the standard deviation out.
    near(reaction.mean, mean, 1e-4, "random history: mean")
    near(reaction.standard_deviation, numpy.sqrt(square - mean**2), 1e-3, "random history: std")


def distance(x, y):
    """Of Kolmogorov and Smirnov, between two samples."""
    both = numpy.sort(numpy.concatenate([x, y]))
    cumulative = [numpy.searchsorted(numpy.sort(each), both, side="right") / len(each) for each in (x, y)]
    return numpy.abs(cumulative[0] - cumulative[1]).max()


def monte_carlo():
    """The same draws by Monte Carlo and by the expansion: what differs is truncation alone, no noise of sampling."""
    run("expansion", NO_SWEEP)
    run("monte_carlo", ["Design/Type=Random", "Design/Count=10000", "Accuracy=1e-4"])
    study, statistics = results("monte_carlo"), results("expansion").statistics
    check(study.solved.all(), f"{(~study.solved).sum()} draws without a solution")
    points = {name: study.parameters[name] for name in statistics.variables}
    rows = {"u_A_y": (0.337148, 0.0071), "F_N_max_I": (28.743568, 2.27341), "F_T_max_I": (19.363325, 1.825949)}
    for name in study.responses:
        values = study.responses[name]
        apart = distance(values, statistics.expansion(name)(**points))
        largest = 0.009 if name.startswith("u_") else 0.0012
        print(f"{name}: mean {values.mean():.8g}, std {values.std():.8g}, distance {apart:.5f}")
        check(apart <= largest, f"{name}: Kolmogorov-Smirnov distance {apart}, not below {largest}")
        near(statistics.responses[name].mean, values.mean(), 4 * values.std() / 100, f"mean of {name}")
        if name in rows:  # another sample of the same size
            mean, deviation = rows[name]
            near(values.mean(), mean, 4 * numpy.sqrt(2) * deviation / 100, f"Monte Carlo: mean of {name}")
            # The displacement under a normal stiffness has no variance: that of a sample is whatever its extremes are.
            if not name.startswith("u_"):
                near(values.std(), deviation, 0.05 * deviation, f"Monte Carlo: std of {name}")
                near(statistics.responses[name].standard_deviation, values.std(), 0.03 * deviation, f"std of {name}")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
everything = (monte_carlo,) if sys.argv[4:] == ["monte_carlo"] else (
    normal_glue, resumed, from_python, lognormal_glue, guards, order_by_tolerance, other_methods, distributions,
    random_history)
for part in everything:
    part()
finish()
