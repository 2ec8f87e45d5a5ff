"""Parameter lists in XML, for tests that write their scenes and studies."""


def entry(name, value):
    """A parameter; text in braces is an array of numbers, text that begins with $ a number of the list Values."""
    text = str(value)
    kind = {str: "string", float: "double", int: "int"}[type(value)]
    kind = "Array(double)" if text.startswith("{") else "double" if text.startswith("$") else kind
    return f'<Parameter name="{name}" type="{kind}" value="{text}"/>'


def entries(name, *content):
    """A list of parameters and lists."""
    return f'<ParameterList name="{name}">' + "\n".join(content) + "</ParameterList>\n"


def law(kind, *content):
    """The law of an interface or boundary."""
    return entries("Law", entry("Type", kind), *content)


def box(name, place):
    """A unit cube of one element, the one of this number along x."""
    return entries(name, entry("Lower Corner", f"{{{place}, 0, 0}}"), entry("Upper Corner", f"{{{place + 1}, 1, 1}}"),
                   entry("Cells", "{1, 1, 1}"))


def guided(names):
    """Boundaries that let cubes move along x only, but for Poisson's ratio."""
    return [entries(f"{name}_{axis}", entry("Side Set", f"{name}_{axis}min"), law("Symmetry"))
            for name in names for axis in "yz"]
