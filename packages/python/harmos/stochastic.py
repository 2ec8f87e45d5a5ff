"""What a study with random parameters has come to; harmos.read_study() reads it from the study's file.

    statistics = study.statistics                               None: no random parameters, or not ended
    statistics.responses["u_A_y"].standard_deviation
    expansion = statistics.expansion("u_A_y")
    expansion(E_1=550, E_2=900)                                 at values of the parameters
    expansion.evaluate(germs)                                   at germs, [point, variable]
    expansion.sample(100000, seed=1)                            random values of the response
"""
import numpy


class Statistics:
    """Moments, quantiles, densities and Sobol' indices of all responses.

    method, distributions    in words
    is_sample                whether the figures are those of the configurations, not of an expansion or interpolation
    variables                names of the random parameters
    independent              whether they are; if not, germs and Sobol' indices are those of standard normal numbers
    solved, inadmissible     configurations behind the figures; draws that the scene refuses
    levels                   probabilities of the quantiles
    responses                dictionary by name, see ResponseStatistics
    basis                    see Basis; None: no response has an expansion
    convergence, sweep       see Table; None: there is none
    """

    def __init__(self, group):
        for key in ("method", "solved", "inadmissible"):
            setattr(self, key, group.attrs[key])
        self.distributions = list(group.attrs["distributions"])
        self.variables = list(group.attrs["variables"])
        self.independent = bool(group.attrs["independent"])
        self.levels = group["levels"][()]
        names = list(group["responses"].attrs["order"])
        self.responses = {name: ResponseStatistics(group["responses"][name]) for name in names}
        self.basis = Basis(group["basis"], self.variables, self.independent) if "basis" in group else None
        self.convergence = Table(group["convergence"], names) if "convergence" in group else None
        self.sweep = Table(group["sweep"], names) if "sweep" in group else None
        if "sample" in group.attrs:
            self.is_sample = bool(group.attrs["sample"])
        else:
            # A file from before Harmos said so: of all that has no convergence, only samples have an error of the mean.
            self.is_sample = self.convergence is None and any(not numpy.isnan(response.mean_error)
                                                              for response in self.responses.values())

    def expansion(self, response):
        """The expansion of a response; ValueError when there is none."""
        known = [name for name, each in self.responses.items() if each.coefficients is not None]
        if response not in known:
            raise ValueError(f"there is no expansion of {response}; there are: {known}")
        return Expansion(self.basis, self.responses[response].coefficients)


class ResponseStatistics:
    """mean, standard_deviation, skewness, kurtosis and their errors; NaN: not known, or undefined at zero variance.

    mean_error, standard_deviation_error    of samples standard errors, of expansions what the iteration left
    truncation           share of the variance in the polynomials of the highest degree
    hold_out_error       root mean square error at the configurations held out, over the standard deviation
    coefficients         one per polynomial of the basis, None without an expansion
    quantiles            at the levels of the statistics
    values, density, cumulative    curves of probability
    sobol                dictionary: (main, total) by the variables' names joined by "*"
    """

    def __init__(self, group):
        for key in ("mean", "standard_deviation", "skewness", "kurtosis", "mean_error", "standard_deviation_error",
                    "truncation", "hold_out_error"):
            setattr(self, key, group.attrs[key])
        self.coefficients = group["coefficients"][()] if "coefficients" in group else None
        for key in ("quantiles", "values", "density", "cumulative"):
            setattr(self, key, group[key][()])
        sets = group["sobol_sets"].asstr()[()] if len(group["sobol_sets"]) else []
        self.sobol = dict(zip(sets, zip(group["sobol_main"][()], group["sobol_total"][()])))


class Table:
    """Moments by order or size (`size`), or by coefficients of variation (`names`, `coefficients` [row, name]).

    mean, standard_deviation    dictionaries of arrays by response
    """

    def __init__(self, group, responses):
        self.size = group["size"][()] if "size" in group else None
        self.names = list(group.attrs["names"]) if "names" in group.attrs else []
        self.coefficients = group["coefficients"][()] if "coefficients" in group else None
        self.mean = dict(zip(responses, group["mean"][()].T))
        self.standard_deviation = dict(zip(responses, group["standard_deviation"][()].T))


class Germ:
    """One random number of known orthonormal polynomials: sqrt(b[i+1]) p[i+1] = (xi - a[i]) p[i] - sqrt(b[i]) p[i-1].

    map, shift, scale    value of the parameter: shift + scale xi (affine), exp of that (exponential), or unknown (none)
    """

    def __init__(self, group):
        self.map = group.attrs["map"]
        self.shift, self.scale = group.attrs.get("shift"), group.attrs.get("scale")
        self.a, self.b = group["recurrence_a"][()], group["recurrence_b"][()]
        self.law = group.attrs["germ"]
        self._levels, self._quantiles = group["germ_levels"][()], group["germ_quantiles"][()]

    def polynomials(self, xi):
        """Values of all known polynomials, [point, degree]."""
        xi = numpy.asarray(xi, float)
        p = [numpy.ones_like(xi)]
        for i in range(len(self.a) - 1):
            lower = numpy.sqrt(self.b[i]) * p[i - 1] if i > 0 else 0.0
            p.append(((xi - self.a[i]) * p[i] - lower) / numpy.sqrt(self.b[i + 1]))
        return numpy.column_stack(p)

    def of(self, values):
        """Germs of values of the parameter."""
        values = numpy.asarray(values, float)
        if self.scale == 0.0:
            return numpy.zeros_like(values)
        return ((numpy.log(values) if self.map == "exponential" else values) - self.shift) / self.scale

    def sample(self, count, generator):
        if self.law == "Normal":
            return generator.standard_normal(count)
        if self.law == "Uniform":
            return generator.uniform(-1.0, 1.0, count)
        if self.law == "Sample":
            return generator.choice(self._quantiles, count)
        return numpy.interp(generator.uniform(size=count), self._levels, self._quantiles)


class Basis:
    """Products of polynomials in independent germs, in graded lexicographic order.

    order, degrees       highest total degree; degree of every polynomial in every germ
    germs                dictionary by variable, see Germ
    """

    def __init__(self, group, variables, independent):
        self.order, self.degrees, self.independent = group.attrs["order"], group["degrees"][()], independent
        self.germs = {name: Germ(group[name]) for name in variables}

    def evaluate(self, germs):
        """Values of all polynomials at germs, [point, polynomial]."""
        germs = numpy.atleast_2d(germs)
        result = numpy.ones((len(germs), len(self.degrees)))
        for i, germ in enumerate(self.germs.values()):
            result *= germ.polynomials(germs[:, i])[:, self.degrees[:, i]]
        return result

    def germs_of(self, **values):
        """Germs of values of all parameters (numbers or arrays of equal length), [point, variable]."""
        if set(values) != set(self.germs):
            raise ValueError(f"give values of {', '.join(self.germs)}")
        hidden = [name for name, germ in self.germs.items() if germ.map == "none"]
        if hidden:
            raise ValueError(f"{', '.join(hidden)}: correlated parameters do not tell their germs; use evaluate(germs)")
        columns = [numpy.atleast_1d(germ.of(values[name])) for name, germ in self.germs.items()]
        return numpy.column_stack(numpy.broadcast_arrays(*columns))

    def sample(self, count, seed=None):
        """Random germs, [point, variable]."""
        generator = numpy.random.default_rng(seed)
        return numpy.column_stack([germ.sample(count, generator) for germ in self.germs.values()])


class Expansion:
    """A response as a sum of coefficients times the polynomials of a basis."""

    def __init__(self, basis, coefficients):
        self.basis, self.coefficients = basis, coefficients

    def evaluate(self, germs):
        """At germs, [point, variable]."""
        return self.basis.evaluate(germs) @ self.coefficients

    def __call__(self, **values):
        """At values of all parameters."""
        return self.evaluate(self.basis.germs_of(**values))

    def sample(self, count, seed=None):
        """Random values of the response; nothing is solved."""
        return self.evaluate(self.basis.sample(count, seed))

    @property
    def mean(self):
        return self.coefficients[0]

    @property
    def standard_deviation(self):
        return numpy.sqrt((self.coefficients[1:] ** 2).sum())
