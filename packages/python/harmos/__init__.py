"""Reads the studies and histories that Harmos writes; harmos.results says how."""
from harmos.results import Study, Surrogate, read_history, read_study
from harmos.stochastic import Basis, Expansion, Germ, ResponseStatistics, Statistics, Table

__all__ = ["Basis", "Expansion", "Germ", "ResponseStatistics", "Statistics", "Study", "Surrogate", "Table",
           "read_history", "read_study"]
