"""The numbers of an input whose errors are counted."""
import xml.etree.ElementTree as xml

from harmos.trade.document import Document, find, value_of

EXPANDED = ("Chaos", "Collocation")
"""Designs whose mean and standard deviation are compared: their configurations are no result, and change with the order."""
MOVING = "Adaptive"
"""The design whose points follow from the results."""


def demand_comparable(document: Document) -> None:
    """Refuses what has no numbers that could be compared between runs.

    Raises:
        ValueError: there are no responses, or those of every run are of other configurations.
    """
    if not _names(document):
        raise ValueError(f"{document.path} has no Responses, of which errors are counted.\n"
                         "  Add those that matter, such as a Mean Displacement or an Interface Force.")
    if _design(document) == MOVING:
        raise ValueError(f"{document.path}: a design {MOVING} chooses its configurations by the results: every run has others, "
                         "and errors of its responses cannot be measured.\n"
                         "  Trade its scene, or a study whose points are given, such as those of a design Sobol.")


def demand_moments(document: Document) -> None:
    """Has a study of an expansion report the responses of the scene at the end, where it has none of its own."""
    if document.study is None or _design(document) not in EXPANDED or _names_of(document.study):
        return
    reported = find(document.study, "Responses")
    if reported is None:
        reported = xml.SubElement(document.study, "ParameterList", name="Responses")
    for name in document.names("Responses"):
        one = xml.SubElement(reported, "ParameterList", name=name)
        for entry, value in (("Type", "Final"), ("Response", name)):
            xml.SubElement(one, "Parameter", name=entry, type="string", value=value)


def chosen_responses(text: str, document: Document) -> list[str]:
    """The names of responses in a text with commas between.

    Raises:
        ValueError: one of them is not there.
    """
    chosen = [word.strip() for word in text.split(",") if word.strip()]
    known = _names(document)
    for name in chosen:
        if name not in known:
            raise ValueError(f"--responses: there is no response \"{name}\"; there are {', '.join(known)}.")
    return chosen


def reported_response(document: Document, name: str) -> str:
    """The response of the scene of which a number of a study is made, such as "force_max, mean"."""
    own = name.partition(", ")[0]
    return (value_of(document.study, f"Responses/{own}/Response") if document.study is not None else None) or own


def _design(document: Document) -> str:
    return (value_of(document.study, "Design/Type") if document.study is not None else None) or ""


def _names(document: Document) -> list[str]:
    own = _names_of(document.study) if document.study is not None else []
    return own or document.names("Responses")


def _names_of(study: xml.Element) -> list[str]:
    own = find(study, "Responses")
    return [one.get("name", "") for one in own if one.tag == "ParameterList"] if own is not None else []
