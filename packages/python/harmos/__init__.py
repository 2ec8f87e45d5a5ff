"""Reads the studies and histories that Harmos writes; harmos.results and harmos.stochastic say how."""
from harmos.results import Study, Surrogate, SurrogateModel, read_history, read_study
from harmos.stochastic import Basis, Convergence, Expansion, Germ, ResponseStatistics, Statistics, Sweep, Table

__all__ = ["Basis", "Convergence", "Expansion", "Germ", "ResponseStatistics", "Statistics", "Study", "Surrogate",
           "SurrogateModel", "Sweep", "Table", "read_history", "read_study"]
