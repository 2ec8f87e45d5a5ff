"""What a study with random parameters has come to; harmos.read_study() reads it from the study's file.

    statistics = study.statistics                               None: no random parameters, or not ended
    statistics.responses["u_A_y"].standard_deviation
    expansion = statistics.expansion("u_A_y")
    expansion(E_1=550, E_2=900)                                 at values of the parameters
    expansion.evaluate(germs)                                   at germs, [point, variable]
    expansion.sample(100000, seed=1)                            random values of the response

Figures of a response have its unit, but for those that are shares or probabilities; germs have none.
"""
from collections.abc import Sequence

import h5py
import numpy
from numpy.typing import ArrayLike

from harmos.arrays import Floats, Integers

LAST_NODE = 4096
"""Number of the last node of a germ of an interpolation; the one in the middle belongs to the constant."""


class Statistics:
    """Moments, quantiles, densities and Sobol' indices of all responses.

    Attributes:
        method: in words.
        is_sample: whether the figures are those of the configurations, not of an expansion or interpolation.
        variables: names of the random parameters.
        distributions: of these in words.
        independent: whether they are; if not, germs and Sobol' indices are those of standard normal numbers.
        solved: configurations behind the figures.
        inadmissible: draws that the scene refuses.
        unsolved: other draws without a solution, left out of all figures.
        warnings: what makes the figures doubtful, in words.
        levels: probabilities of the quantiles, [level].
        responses: by name, in the order of the input.
        basis: of the expansions; None: no response has one.
        interpolant: piecewise linear functions of all responses; None: there is none.
        convergence: of the moments with the order; None: there is none.
        sweep: moments for several coefficients of variation; None: there is none.
    """

    def __init__(self, group: h5py.Group) -> None:
        """Reads the group `statistics` of a study."""
        self.method: str = group.attrs["method"]
        self.variables: list[str] = list(group.attrs["variables"])
        self.distributions: list[str] = list(group.attrs["distributions"])
        self.independent = bool(group.attrs["independent"])
        self.solved = int(group.attrs["solved"])
        self.inadmissible = int(group.attrs["inadmissible"])
        self.unsolved = int(group.attrs.get("unsolved", 0))
        self.warnings: list[str] = list(group.attrs.get("warnings", []))
        self.levels: Floats = group["levels"][()]
        names: list[str] = list(group["responses"].attrs["order"])
        self.responses = {name: ResponseStatistics(group["responses"][name]) for name in names}
        self.basis = Basis(group["basis"], self.variables, self.independent) if "basis" in group else None
        self.interpolant = (Interpolant(group["interpolant"], self.variables, names) if "interpolant" in group
                            else None)
        self.convergence = Convergence(group["convergence"], names) if "convergence" in group else None
        self.sweep = Sweep(group["sweep"], names) if "sweep" in group else None
        if "sample" in group.attrs:
            self.is_sample = bool(group.attrs["sample"])
        else:
            # A file from before Harmos said so: of all that has no convergence, only samples have an error of the mean.
            self.is_sample = self.convergence is None and any(not numpy.isnan(response.mean_error)
                                                              for response in self.responses.values())

    def expansion(self, response: str) -> "Expansion":
        """The expansion of a response.

        Raises:
            ValueError: there is none.
        """
        known = {name: each.coefficients for name, each in self.responses.items() if each.coefficients is not None}
        if self.basis is None or response not in known:
            raise ValueError(f"there is no expansion of {response}; there are: {list(known)}")
        return Expansion(self.basis, known[response])


class ResponseStatistics:
    """What is known of one response; NaN: not known, or undefined at zero variance.

    Attributes:
        mean: of the response.
        standard_deviation: of the response.
        skewness: of the response.
        kurtosis: of the response; 3 if it is normal.
        mean_error: standard error of a sample, or estimate of the whole error of an expansion or interpolation.
        standard_deviation_error: the same of the standard deviation.
        iteration_error: the part of both that the iteration left; NaN: of a sample, or of an older Harmos.
        truncation: share of the variance in the polynomials of the highest degree.
        hold_out_error: root mean square error at the configurations held out, over the standard deviation.
        coefficients: one per polynomial of the basis, [polynomial]; None without an expansion.
        quantiles: at the levels of the statistics, [level].
        values: of the response, at which the curves of probability are known, [point].
        density: of probability at the values, one over the unit of the response, [point].
        cumulative: probability of no more than the values, [point].
        sobol: main and total index by the variables' names joined by "*".
    """

    def __init__(self, group: h5py.Group) -> None:
        """Reads the group of a response."""
        self.mean: float = group.attrs["mean"]
        self.standard_deviation: float = group.attrs["standard_deviation"]
        self.skewness: float = group.attrs["skewness"]
        self.kurtosis: float = group.attrs["kurtosis"]
        self.mean_error: float = group.attrs["mean_error"]
        self.standard_deviation_error: float = group.attrs["standard_deviation_error"]
        self.iteration_error: float = group.attrs.get("iteration_error", numpy.nan)
        self.truncation: float = group.attrs["truncation"]
        self.hold_out_error: float = group.attrs["hold_out_error"]
        self.coefficients: Floats | None = group["coefficients"][()] if "coefficients" in group else None
        self.quantiles: Floats = group["quantiles"][()]
        self.values: Floats = group["values"][()]
        self.density: Floats = group["density"][()]
        self.cumulative: Floats = group["cumulative"][()]
        sets = group["sobol_sets"].asstr()[()] if len(group["sobol_sets"]) else []
        self.sobol: dict[str, tuple[float, float]] = dict(
            zip(sets, zip(group["sobol_main"][()], group["sobol_total"][()])))


class Table:
    """Mean and standard deviation of all responses, row by row.

    Attributes:
        mean: by response, [row].
        standard_deviation: by response, [row].
    """

    def __init__(self, group: h5py.Group, responses: Sequence[str]) -> None:
        """Reads the group of a table; `responses` names its columns."""
        self.mean: dict[str, Floats] = dict(zip(responses, group["mean"][()].T))
        self.standard_deviation: dict[str, Floats] = dict(zip(responses, group["standard_deviation"][()].T))


class Convergence(Table):
    """Moments by the order of the expansion.

    Attributes:
        size: the orders, [row].
    """

    def __init__(self, group: h5py.Group, responses: Sequence[str]) -> None:
        """Reads the group `convergence`."""
        super().__init__(group, responses)
        self.size: Integers = group["size"][()]


class Sweep(Table):
    """Moments by coefficients of variation.

    Attributes:
        names: of the coefficients of variation.
        coefficients: of variation, [row, name].
    """

    def __init__(self, group: h5py.Group, responses: Sequence[str]) -> None:
        """Reads the group `sweep`."""
        super().__init__(group, responses)
        self.names: list[str] = list(group.attrs["names"])
        self.coefficients: Floats = group["coefficients"][()]


class Germ:
    """One random number of known orthonormal polynomials: sqrt(b[i+1]) p[i+1] = (xi - a[i]) p[i] - sqrt(b[i]) p[i-1].

    Attributes:
        map: of the germ to the parameter: "affine" (shift + scale xi), "exponential" (exp of that) or "none" (unknown).
        shift: in the map; None: unknown.
        scale: in the map; None: unknown.
        a: of the recurrence, [degree].
        b: of the recurrence, [degree].
        law: of the germ, such as "Normal".
    """

    def __init__(self, group: h5py.Group) -> None:
        """Reads the group of a variable."""
        self.map: str = group.attrs["map"]
        self.shift: float | None = group.attrs.get("shift")
        self.scale: float | None = group.attrs.get("scale")
        self.a: Floats = group["recurrence_a"][()]
        self.b: Floats = group["recurrence_b"][()]
        self.law: str = group.attrs["germ"]
        self._levels: Floats = group["germ_levels"][()]
        self._quantiles: Floats = group["germ_quantiles"][()]

    def polynomials(self, xi: ArrayLike) -> Floats:
        """Values of all known polynomials, [point, degree]."""
        xi = numpy.asarray(xi, float)
        p = [numpy.ones_like(xi)]
        for i in range(len(self.a) - 1):
            lower = numpy.sqrt(self.b[i]) * p[i - 1] if i > 0 else 0.0
            p.append(((xi - self.a[i]) * p[i] - lower) / numpy.sqrt(self.b[i + 1]))
        return numpy.column_stack(p)

    def of(self, values: ArrayLike) -> Floats:
        """Germs of values of the parameter, in the shape of these.

        Raises:
            ValueError: the parameter depends on several germs.
        """
        values = numpy.asarray(values, float)
        if self.shift is None or self.scale is None:
            raise ValueError("correlated parameters do not tell their germs")
        if self.scale == 0.0:
            return numpy.zeros_like(values)
        germs: Floats = ((numpy.log(values) if self.map == "exponential" else values) - self.shift) / self.scale
        return germs

    def sample(self, count: int, generator: numpy.random.Generator) -> Floats:
        """Random values of the germ, [count]."""
        if self.law == "Normal":
            return generator.standard_normal(count)
        if self.law == "Uniform":
            return generator.uniform(-1.0, 1.0, count)
        if self.law == "Sample":
            return generator.choice(self._quantiles, count)
        return numpy.interp(generator.uniform(size=count), self._levels, self._quantiles)


class Basis:
    """Products of polynomials in independent germs, in graded lexicographic order.

    Attributes:
        order: highest total degree.
        degrees: of every polynomial in every germ, [polynomial, variable].
        independent: whether the parameters are; if not, none of them has a germ of its own.
        germs: by variable.
    """

    def __init__(self, group: h5py.Group, variables: Sequence[str], independent: bool) -> None:
        """Reads the group `basis`."""
        self.order = int(group.attrs["order"])
        self.degrees: Integers = group["degrees"][()]
        self.independent = independent
        self.germs = {name: Germ(group[name]) for name in variables}

    def evaluate(self, germs: ArrayLike) -> Floats:
        """Values of all polynomials, [point, polynomial], at germs, [point, variable]."""
        points = numpy.atleast_2d(germs)
        result = numpy.ones((len(points), len(self.degrees)))
        for i, germ in enumerate(self.germs.values()):
            result *= germ.polynomials(points[:, i])[:, self.degrees[:, i]]
        return result

    def germs_of(self, **values: ArrayLike) -> Floats:
        """Germs of values of all parameters (numbers or arrays of equal length), [point, variable].

        Raises:
            ValueError: a parameter is missing, unknown, or correlated with others.
        """
        if set(values) != set(self.germs):
            raise ValueError(f"give values of {', '.join(self.germs)}")
        hidden = [name for name, germ in self.germs.items() if germ.map == "none"]
        if hidden:
            raise ValueError(f"{', '.join(hidden)}: correlated parameters do not tell their germs; use evaluate(germs)")
        columns = [numpy.atleast_1d(germ.of(values[name])) for name, germ in self.germs.items()]
        return numpy.column_stack(numpy.broadcast_arrays(*columns))

    def sample(self, count: int, seed: int | None = None) -> Floats:
        """Random germs, [count, variable]; always the same with the same seed."""
        generator = numpy.random.default_rng(seed)
        return numpy.column_stack([germ.sample(count, generator) for germ in self.germs.values()])


class Interpolant:
    """All responses as piecewise linear functions of germs, with error bars: the same as `harmos predict` evaluates.

    Attributes:
        variables: names of the random parameters.
        responses: names.
    """

    def __init__(self, group: h5py.Group, variables: Sequence[str], responses: Sequence[str]) -> None:
        """Reads the group `interpolant`."""
        self.variables, self.responses = list(variables), list(responses)
        self._positions = [group["germs"][name]["positions"][()] for name in variables]
        self._sums = {which: (group[which]["nodes"][()], group[which]["factors"][()]) for which in ("values", "doubt")}
        self._calibrations: Floats = group["calibrations"][()]
        self._floors: Floats = group["floors"][()]

    def evaluate(self, germs: ArrayLike) -> dict[str, tuple[Floats, Floats]]:
        """Values of every response and their standard deviations, each [point], at germs, [point, variable]."""
        points = numpy.atleast_2d(germs)
        values = self._evaluate("values", points)
        deviations = self._calibrations * self._evaluate("doubt", points) + self._floors
        return {name: (values[:, r], deviations[:, r]) for r, name in enumerate(self.responses)}

    def _evaluate(self, which: str, points: Floats) -> Floats:
        nodes, factors = self._sums[which]
        if len(nodes) == 0:
            return numpy.zeros((len(points), len(self.responses)))
        hats = numpy.ones((len(points), len(nodes)))
        for i, positions in enumerate(self._positions):
            middle, step = LAST_NODE // 2, nodes[:, i] & -nodes[:, i]
            step = numpy.where(numpy.isin(nodes[:, i], (0, LAST_NODE)), middle, step)
            left, right = (positions[numpy.clip(nodes[:, i] + sign * step, 0, LAST_NODE)] for sign in (-1, 1))
            at, xi = positions[nodes[:, i]], numpy.clip(points[:, i, None], positions[0], positions[-1])
            rising = numpy.where(at > left, (xi - left) / numpy.where(at > left, at - left, 1.0), 1.0)
            falling = numpy.where(right > at, (right - xi) / numpy.where(right > at, right - at, 1.0), 1.0)
            hats *= numpy.where(nodes[:, i] == middle, 1.0, numpy.minimum(rising, falling).clip(0.0, 1.0))
        result: Floats = hats @ factors
        return result


class Expansion:
    """A response as a sum of coefficients times the polynomials of a basis.

    Attributes:
        basis: of the expansion.
        coefficients: one per polynomial, [polynomial].
    """

    def __init__(self, basis: Basis, coefficients: Floats) -> None:
        """Takes both as they are; statistics.expansion() knows them."""
        self.basis, self.coefficients = basis, coefficients

    def evaluate(self, germs: ArrayLike) -> Floats:
        """Values of the response, [point], at germs, [point, variable]."""
        return self.basis.evaluate(germs) @ self.coefficients

    def __call__(self, **values: ArrayLike) -> Floats:
        """Values of the response, [point], at values of all parameters (numbers or arrays of equal length).

        Raises:
            ValueError: a parameter is missing, unknown, or correlated with others.
        """
        return self.evaluate(self.basis.germs_of(**values))

    def sample(self, count: int, seed: int | None = None) -> Floats:
        """Random values of the response, [count]; nothing is solved."""
        return self.evaluate(self.basis.sample(count, seed))

    @property
    def mean(self) -> float:
        """Mean of the response."""
        mean: float = self.coefficients[0]
        return mean

    @property
    def standard_deviation(self) -> float:
        """Standard deviation of the response."""
        deviation: float = numpy.sqrt((self.coefficients[1:] ** 2).sum())
        return deviation
