"""Laws of interfaces written in Python: a class per law in a file that a scene names among its Plugins.

    import numpy
    from harmos.laws import Law, number

    class Glue(Law):
        \"\"\"Glue: t = k delta.\"\"\"
        name = "My Glue"
        parameters = (number("Stiffness", "k.", unit="stress/length", at_least=0.0),)

        def __init__(self, p):
            self.stiffness = p["Stiffness"]

        def traction(self, jump, old, at):
            return self.stiffness * jump

harmos.laws.law says what a law gives and sees, harmos.laws.declaration declares its parameters, harmos.laws.intersection
finds where its graph meets a line, and harmos.laws.conformance tests it.
"""
from harmos.laws.conformance import conform
from harmos.laws.declaration import Entry, Output, flag, integer, number, numbers, text
from harmos.laws.law import Law, Parameters, Schedule, Status, Step, Where
from harmos.laws.intersection import NoIntersection, resolvent

__all__ = ["Entry", "Law", "NoIntersection", "Output", "Parameters", "Schedule", "Status", "Step", "Where", "conform",
           "flag", "integer", "number", "numbers", "resolvent", "text"]
