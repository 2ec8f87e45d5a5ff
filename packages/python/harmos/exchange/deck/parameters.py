"""Which parameters of keywords an import reads or may pass over; all others are told."""
from harmos.exchange.deck.cards import Card
from harmos.exchange.findings import Findings

UNKNOWN = "the scene is as it would be without it"
"""What is told of a keyword or parameter of which Harmos does not know what it would change."""

_LOAD = "OP AMPLITUDE TIMEDELAY INPUT REGIONTYPE FOLLOWER"
_SET = "GENERATE ELSET INSTANCE INTERNAL UNSORTED INPUT"

_READ: dict[str, str] = {
    "NODE": "NSET SYSTEM INPUT", "ELEMENT": "TYPE ELSET INPUT", "NSET": f"NSET {_SET}", "ELSET": _SET,
    "SURFACE": "NAME TYPE INTERNAL INSTANCE COMBINE INPUT", "INSTANCE": "NAME PART",
    "MATERIAL": "NAME", "ELASTIC": "TYPE", "DENSITY": "", "EXPANSION": "TYPE ZERO",
    "SOLIDSECTION": "ELSET MATERIAL ORIENTATION CONTROLS OFFSET", "ORIENTATION": "NAME SYSTEM DEFINITION LOCALDIRECTIONS",
    "TIE": "NAME POSITIONTOLERANCE ADJUST TYPE CYCLICSYMMETRY NOROTATION NOTHICKNESS CONSTRAINTRATIO",
    "CONTACTPAIR": "INTERACTION TYPE ADJUST TIED SMALLSLIDING CPSET MECHANICALCONSTRAINT GEOMETRICCORRECTION EXTENSIONZONE HCRIT "
                   "NOTHICKNESS SMOOTH TRACKING SUPPLEMENTARYCONSTRAINTS SLIDINGTRANSITION",
    "SURFACEINTERACTION": "NAME", "FRICTION": "SLIPTOLERANCE ELASTICSLIP LAGRANGE",
    "SURFACEBEHAVIOR": "PRESSURE-OVERCLOSURE AUGMENTEDLAGRANGE PENALTY DIRECT", "PRE-TENSIONSECTION": "SURFACE NODE",
    "BOUNDARY": f"{_LOAD} FIXED TYPE USER SUBMODEL", "CLOAD": _LOAD, "DLOAD": _LOAD, "DSLOAD": f"{_LOAD} CONSTANTRESULTANT",
    "TEMPERATURE": f"{_LOAD} SUBMODEL USER FILE BSTEP LINTEMP", "INITIALCONDITIONS": "TYPE SUBMODEL USER FILE BSTEP INPUT",
    "COUPLING": "CONSTRAINTNAME REFNODE SURFACE", "KINEMATIC": "", "DISTRIBUTING": "WEIGHTINGMETHOD",
    "DISTRIBUTINGCOUPLING": "ELSET", "RIGIDBODY": "NSET ELSET REFNODE ROTNODE", "EQUATION": "INPUT REMOVE",
    "SPRING": "ELSET NONLINEAR", "TRANSFORM": "NSET TYPE",
    "STEP": "INC INCF NLGEOM PERTURBATION NAME AMPLITUDE UNSYMM CONVERTSDI EXTRAPOLATION SOLVER",
    "STATIC": "DIRECT SOLVER STABILIZE ALLSDTOL CONTINUE FACTOR EXPLICIT", "RESTART": "WRITE FREQUENCY OVERLAY NUMBERINTERVAL",
}
"""By keyword; keywords that are not here are read whole, or listed whole."""

_EFFECTS = {
    ("FRICTION", "ROUGH"): "surfaces that touch may slide here",
    ("FRICTION", "TAUMAX"): "the shear stress of friction has no upper limit",
    ("FRICTION", "ANISOTROPIC"): "the first coefficient counts in all directions",
    ("SURFACEBEHAVIOR", "NOSEPARATION"): "surfaces that have touched may open here",
    ("SOLIDSECTION", "COMPOSITE"): "layers: the elements have one material",
    ("SOLIDSECTION", "REFNODE"): "generalised plane strain: there is no strain across the plane",
    ("COUPLING", "INFLUENCERADIUS"): "the whole surface is coupled",
    ("COUPLING", "ORIENTATION"): "what acts on the reference node counts in global axes",
    ("SPRING", "ORIENTATION"): "the spring acts along global axes",
    ("STATIC", "RIKS"): "the whole load acts at the end of the step, whatever the load factor would be",
    ("RESTART", "READ"): "the deck goes on from the results of another one: the scene begins without load",
    **{(keyword, "LOADCASE"): "counts as of the one load case that a scene has" for keyword in ("BOUNDARY", "CLOAD", "DLOAD", "DSLOAD")},
    **{(keyword, "DEPENDENCIES"): "numbers that depend on field variables: the first ones are taken"
       for keyword in ("ELASTIC", "DENSITY", "EXPANSION", "FRICTION")},
}


def list_unread(cards: list[Card], findings: Findings) -> None:
    """Lists parameters that would change what a card means, and that nothing here reads."""
    for card in cards:
        if card.keyword not in _READ:
            continue
        for name in card.parameters:
            if name not in _READ[card.keyword].split():
                findings.leave_out(card.place, f"*{card.keyword}, {name}", _EFFECTS.get((card.keyword, name), UNKNOWN))
        if card.get("OP") not in ("", "NEW", "MOD"):
            findings.leave_out(card.place, f"*{card.keyword}, OP={card.get('OP')}", "it is neither NEW nor MOD, and counts as MOD: what acted "
                               "before goes on")
