"""Runs Harmos, builds its scenes, and reads what it writes; the modules named here say how.

harmos.program runs scenes and studies, harmos.scenes builds them, harmos.result, harmos.exodus_fields, harmos.results
and harmos.stochastic read what comes of them. harmos.laws is for laws in Python.
"""
from harmos import laws
from harmos.errors import HarmosError, InputError, Interrupted, NoEquilibrium, NotConverged, NotFound
from harmos.exodus_fields import Fields, read_fields
from harmos.program import check, find_program, run, run_study, version
from harmos.result import Result, read_result
from harmos.results import Study, Surrogate, SurrogateModel, read_history, read_study
from harmos.scenes import Input, Scene, StudyInput, read_scene, read_study_input
from harmos.stochastic import Basis, Convergence, Expansion, Germ, ResponseStatistics, Statistics, Sweep, Table

__all__ = ["Basis", "Convergence", "Expansion", "Fields", "Germ", "HarmosError", "Input", "InputError", "Interrupted",
           "NoEquilibrium", "NotConverged", "NotFound", "ResponseStatistics", "Result", "Scene", "Statistics", "Study",
           "StudyInput", "Surrogate", "SurrogateModel", "Sweep", "Table", "check", "find_program", "laws", "read_fields",
           "read_history", "read_result", "read_scene", "read_study", "read_study_input", "run", "run_study", "version"]
