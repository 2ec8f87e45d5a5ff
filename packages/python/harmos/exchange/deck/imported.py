"""A deck of Abaqus or CalculiX as a mesh and a scene."""
import dataclasses
import pathlib

import numpy

from harmos.exchange.deck.bare import is_bare, read_bare
from harmos.exchange.deck.cards import Card, read_cards
from harmos.exchange.deck.contents import Contents
from harmos.exchange.deck.couplings import Couplings
from harmos.exchange.deck.curves import Histories
from harmos.exchange.deck.equations import Equations
from harmos.exchange.deck.joints import Joints
from harmos.exchange.deck.load_writer import LoadWriter
from harmos.exchange.deck.materials import Material, has_axes, read_materials, write_material
from harmos.exchange.deck.orientations import Orientations
from harmos.exchange.deck.parameters import UNKNOWN, list_unread
from harmos.exchange.deck.solids import KINEMATICS, Solids
from harmos.exchange.deck.springs import Springs
from harmos.exchange.deck.steps import OUTPUT, LoadReader
from harmos.exchange.deck.volumes import VolumeWriter
from harmos.exchange.findings import Findings, Refused, names_there
from harmos.exchange.mesh import Mesh, clean_name, outer_faces, unused_name, without_loose_nodes
from harmos.exchange.scene import SceneList

_KNOWN = {"HEADING", "NODE", "ELEMENT", "NSET", "ELSET", "SURFACE", "MATERIAL", "ELASTIC", "DENSITY", "SOLIDSECTION",
          "ORIENTATION", "TIE", "CONTACTPAIR", "SURFACEINTERACTION", "FRICTION", "SURFACEBEHAVIOR", "PRE-TENSIONSECTION",
          "BOUNDARY", "COUPLING", "KINEMATIC", "DISTRIBUTING", "DISTRIBUTINGCOUPLING", "RIGIDBODY", "EQUATION", "SPRING", "AMPLITUDE", "TRANSFORM", "PREPRINT", "PLASTIC",
          "CREEP", "EXPANSION", "CONDUCTIVITY",
          "SPECIFICHEAT", "HYPERELASTIC", "HYPERFOAM", "DAMPING", "CONTACTDAMPING", "GAPCONDUCTANCE", *OUTPUT}

_EFFECTS = {
    "INITIALCONDITIONS": "initial temperatures, stresses or velocities are left out",
    "BEAMSECTION": "beams are left out", "SHELLSECTION": "shells are left out",
    "DASHPOT": "dashpots are left out", "MASS": "masses are left out", "GAP": "gap elements are left out",
    **dict.fromkeys(("NGEN", "NFILL", "NCOPY"), "the nodes that it would make are missing"),
    **dict.fromkeys(("ELGEN", "ELCOPY"), "the elements that it would make are missing"),
    "MEMBRANESECTION": "membranes are left out", "BEAMGENERALSECTION": "beams are left out",
}


_CONSTRAINTS = {
    "PLANE": "its nodes need not stay in one plane", "STRAIGHT": "its nodes need not stay on one line",
    "BEAM": "its nodes are not held at their distance by a rigid beam", "LINK": "its nodes are not held at their distance",
    "PIN": "its nodes need not move alike", "TIE": "its nodes need not move alike",
    "MEANROT": "the mean rotation of its nodes is free, and what acts on its last node is left out",
    "DIST": "the distance of its nodes may grow", "CYCLIC": "its nodes need not move alike, turned about the axis",
    "SLIDER": "its nodes need not stay on one line",
}
"""What types of *MPC would change."""


@dataclasses.dataclass
class ImportedDeck:
    """A deck.

    Attributes:
        mesh: of its solids.
        scene: what it says about them; its mesh is in the file that was named. None: it says nothing but the mesh.
    """
    mesh: Mesh
    scene: "SceneList | None"


def import_deck(path: str, mesh_file: str, units: str, findings: Findings) -> ImportedDeck:
    """Reads a deck; what Harmos has not is listed in the findings.

    Raises:
        Refused: the deck is damaged, contradicts itself, or holds no solids.
    """
    cards = read_cards(path)
    contents = Contents(cards, findings)
    if is_bare(contents):
        return ImportedDeck(read_bare(contents, findings, path), None)
    list_unread(cards, findings)
    for card in contents.model:
        if card.keyword not in _KNOWN and (card.keyword, card.get("TYPE")) != ("INITIALCONDITIONS", "TEMPERATURE"):
            if card.keyword == "MPC":
                _list_constraints(card, findings)
            else:
                findings.leave_out(card.place, f"*{card.keyword}", _EFFECTS.get(card.keyword, UNKNOWN))
    materials = read_materials(contents.model, findings)
    solids = Solids(contents, findings, path)
    scene = SceneList("Harmos").set("Title", _title(contents, path))
    if units:
        scene.set("Units", units)
    thickness = _write_model(scene, solids, findings)
    scene.child("Mesh").set("Type", "Exodus").set("File", mesh_file)
    names = _write_parts(scene, contents, solids, materials, findings)
    couplings = Couplings(contents, solids, findings)
    equations = Equations(contents, solids, findings)
    springs = Springs(contents, couplings, findings)
    loads = LoadReader(contents, solids, materials, couplings, equations.nodes(), springs.ground, findings).read()
    ties = equations.apply(loads.held, couplings)
    histories = Histories(scene)
    joints = Joints(contents, solids, scene, findings)
    joints.write(histories, loads.preloads, ties)
    writer = LoadWriter(solids, scene, histories, thickness, findings)
    writer.write(loads)
    coupled = couplings.write(scene, histories)
    VolumeWriter(solids, materials, names, scene, histories, findings).write(loads)
    _write_steps(scene, loads.steps, joints.has_contact or bool(scene.child("Histories").items), findings)
    _hold_what_nothing_touches(scene, solids,
                               writer.touched | coupled | {part for pair in joints.joined for part in pair}, findings)
    mesh = solids.mesh
    for sets in (mesh.side_sets, mesh.node_sets):
        for name in [name for name, entries in sets.items() if not len(entries)]:
            del sets[name]
    loose = without_loose_nodes(mesh)
    findings.found.insert(0, mesh.text())
    if loose:
        findings.found.append(f"{loose} nodes belong to no solid and have been left out")
    asked = [card.place for card in [*contents.model, *(card for step in contents.steps for card in step.cards)]
             if card.keyword in OUTPUT]
    if asked:
        findings.found.append(f"{len(asked)} requests of output or control, the first at {asked[0]}: results hold all fields")
    return ImportedDeck(mesh, scene)


def _list_constraints(card: Card, findings: Findings) -> None:
    """Each type of a *MPC card once, with what it would change."""
    kinds: dict[str, int] = {}
    for row, words in enumerate(card.rows()):
        if words[0] and not words[0].lstrip("+-").isdecimal():
            kinds.setdefault(words[0].upper(), row)
    for kind, row in kinds.items():
        findings.leave_out(card.place_of(row), f"*MPC {kind}", _CONSTRAINTS.get(kind, "nodes that it ties move as they like"))
    if not kinds:
        findings.leave_out(card.place, "*MPC", "nodes that it ties move as they like")


def _title(contents: Contents, path: str) -> str:
    for card in contents.model:
        if card.keyword == "HEADING" and card.data:
            return "".join(letter if letter.isprintable() else " " for letter in card.data[0]).strip()[:79]
    return pathlib.Path(path).stem


def _write_model(scene: SceneList, solids: Solids, findings: Findings) -> float:
    """The thickness of plane elements."""
    if solids.family == "C3D":
        return 1.0
    model = scene.child("Model").set("Kinematics", KINEMATICS[solids.family])
    if solids.family == "CAX":
        return 1.0
    given = sorted({section.thickness for section in solids.sections} - {0.0})
    if len(given) > 1:
        findings.leave_out(solids.sections[-1].card.place, "*SOLID SECTION, thickness",
                           f"a scene has one thickness, here {given[0]:g} of {', '.join(f'{each:g}' for each in given)}")
    thickness = given[0] if given else 1.0
    model.set("Thickness", thickness)
    return thickness


def _write_parts(scene: SceneList, contents: Contents, solids: Solids, materials: dict[str, Material],
                 findings: Findings) -> dict[str, str]:
    """The name of the material of each part."""
    orientations = Orientations(contents.model, findings)
    names: dict[tuple[str, str], str] = {}
    for part, blocks in solids.mesh.parts().items():
        section = solids.sections[solids.section_of_part[part]]
        key = section.material, section.orientation
        if key not in names:
            if section.material and section.material not in materials:
                raise Refused(f"{section.card.place}: there is no *MATERIAL \"{section.card.parameters['MATERIAL']}\". "
                              f"{names_there(section.material, materials)}")
            material = materials.get(section.material) or Material(section.card, "material", {})
            names[key] = unused_name(material.name, set(names.values()))
            axes = orientations.axes(section.orientation, section.card) if has_axes(material) else None
            write_material(material, names[key], axes, scene, findings)
        entry = scene.child("Parts").child(part)
        own = [solids.mesh.blocks[block].name for block in blocks]
        if own != [part]:
            entry.set("Blocks", own)
        entry.set("Material", names[key])
        if solids.modes_of_part[part]:
            entry.set("Formulation", "Incompatible Modes")
    return {part: names[solids.sections[number].material, solids.sections[number].orientation]
            for part, number in solids.section_of_part.items()}


def _write_steps(scene: SceneList, steps: list[tuple[str, float, int]], is_followed: bool, findings: Findings) -> None:
    if not steps:
        findings.undecided.append("loads: the deck has no static step")
        scene.child("Steps").child("load")
    for name, duration, increments in steps:
        step = scene.child("Steps").child(name)
        if duration != 1.0:
            step.set("Duration", duration)
        if increments > 1 and is_followed:
            step.set("Increments", increments)


def _hold_what_nothing_touches(scene: SceneList, solids: Solids, touched: set[str], findings: Findings) -> None:
    """A load of nothing on parts that nothing touches, for a scene needs something on each."""
    mesh = solids.mesh
    faces = outer_faces(mesh)
    part = numpy.asarray(mesh.part_of_block())[mesh.block_of(faces.element)]
    for number, name in enumerate(mesh.parts()):
        if name in touched:
            continue
        side_set = unused_name(f"{clean_name(name)}_surface", {**mesh.side_sets, **mesh.node_sets})
        off_axis = (mesh.nodes[faces.corners, 0] > 0.0).any(axis=1) | (solids.family != "CAX")
        mesh.side_sets[side_set] = faces.chosen((part == number) & off_axis).rows()
        boundaries = scene.child("Boundaries").comment(
            f"TO DECIDE: nothing holds {name}; this load of 0 on its whole surface stands for what does.")
        boundary = boundaries.child(unused_name(side_set, set(boundaries.names())))
        boundary.set("Side Set", side_set).child("Law").set("Type", "Prescribed Traction")
        findings.undecided.append(f"part {name}: nothing holds or loads it")
