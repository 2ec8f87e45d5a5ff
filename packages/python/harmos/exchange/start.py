"""A first scene for a mesh that comes without physics: parts, interfaces where they touch, boundaries by their names."""
import dataclasses
import re

import numpy

from harmos.arrays import Array
from harmos.exchange.contact import Contact, contacts, face_measures
from harmos.exchange.edges import without_curved_edges
from harmos.exchange.findings import Findings, Refused
from harmos.exchange.mesh import Mesh, codes, ended_name, faces_of, outer_faces, unused_name
from harmos.exchange.preloads import LOADING, add_preloads
from harmos.exchange.scene import SceneList, number_text
from harmos.exchange.units import UnitSystem

HELD = re.compile(r"fix|held|hold|clamp|support|ground|encastre|wall|lager|einspann", re.IGNORECASE)
"""Names of sets that are taken for supports."""

MIRROR = re.compile(r"symm", re.IGNORECASE)
"""Names of sets that are taken for planes of symmetry."""

LOADED = re.compile(r"load|force|pull|push|traction|press|last|kraft", re.IGNORECASE)
"""Names of sets that are taken for loaded surfaces."""

ASK = "TO DECIDE: "
"""Begins the comments on what the scene assumes."""


@dataclasses.dataclass
class Choices:
    """What the person who imports has decided already.

    Attributes:
        held: names of sets that are held in all directions.
        loaded: names of side sets that get a traction, 0 until a number stands there.
        perfect: names of interfaces that are joined perfectly.
        preloads: forces of bolts, by the names of their parts.
    """
    held: list[str] = dataclasses.field(default_factory=list)
    loaded: list[str] = dataclasses.field(default_factory=list)
    perfect: list[str] = dataclasses.field(default_factory=list)
    preloads: dict[str, float] = dataclasses.field(default_factory=dict)

    def demand_known(self, path: str, mesh: Mesh, scene: SceneList) -> None:
        """Refuses names that are not there.

        Raises:
            Refused: some are not.
        """
        known = [("--hold", self.held, [*mesh.side_sets, *mesh.node_sets]), ("--load", self.loaded, [*mesh.side_sets]),
                 ("--perfect", self.perfect, scene.child("Interfaces").names())]
        wrong = [f"{option} {name}: there are {', '.join(there) or 'none'}." for option, names, there in known
                 for name in names if name not in there]
        wrong += [f"--load {name}: it is held as well; remove one of the options." for name in self.loaded
                  if name in self.held]
        if wrong:
            raise Refused(f"{path}: " + "\n  ".join(wrong))

    def demand_usable(self, path: str, unusable: dict[str, str]) -> None:
        """Refuses sets that can have no boundary, given with the reason.

        Raises:
            Refused: some are chosen.
        """
        wrong = [f"{option} {name}: it {unusable[name]}; choose another set." for option, names in (("--hold", self.held), ("--load", self.loaded))
                 for name in names if unusable.get(name)]
        if wrong:
            raise Refused(f"{path}: " + "\n  ".join(wrong))


def starting_scene(mesh: Mesh, mesh_file: str, title: str, units: UnitSystem, is_declared: bool, choices: Choices,
                   findings: Findings) -> SceneList:
    """A scene that `harmos check` accepts; may add side sets to the mesh. `units` are those of the placeholders, which
    the scene declares when they are known."""
    scene = SceneList("Harmos").set("Title", title)
    if is_declared:
        scene.set("Units", units.name)
    else:
        findings.undecided.append(f"units: numbers are taken for {units.name}; the option units of the import names others")
    scene.child("Values")
    scene.child("Mesh").set("Type", "Exodus").set("File", mesh_file)
    _add_material(scene, units, findings)
    _add_parts(scene, mesh)
    touched = _add_interfaces(scene, mesh, choices, findings)
    choices.demand_known(title, mesh, scene)
    _add_boundaries(scene, mesh, touched, choices, title, findings)
    add_preloads(scene, mesh, choices.preloads, findings)
    scene.child("Steps").child("load")
    return scene


def _add_material(scene: SceneList, units: UnitSystem, findings: Findings) -> None:
    material = scene.child("Materials").comment(ASK + f"steel is assumed, in {units.name}.").child("steel")
    material.set("Type", "Isotropic").set("Young's Modulus", 2.1e11 / units.stress).set("Poisson's Ratio", 0.3)
    findings.undecided.append("material: all parts are steel until you say otherwise")


def _add_parts(scene: SceneList, mesh: Mesh) -> None:
    parts = scene.child("Parts")
    for name, blocks in mesh.parts().items():
        part = parts.child(name)
        names = [mesh.blocks[block].name for block in blocks]
        if names != [name]:
            part.set("Blocks", names)
        part.set("Material", "steel")


def _add_interfaces(scene: SceneList, mesh: Mesh, choices: Choices, findings: Findings) -> set[str]:
    """The names of the parts that touch others."""
    touched: set[str] = set()
    interfaces = scene.child("Interfaces")
    unit = "length" if mesh.dimension == 2 else "area"
    for contact in contacts(mesh):
        name = unused_name(f"{contact.parts[0]}_to_{contact.parts[1]}", set(interfaces.names()))
        size = " and ".join(dict.fromkeys(f"{area:.4g}" for area in contact.areas))
        is_perfect = name in choices.perfect
        is_fitted = not is_perfect and contact.parts in mesh.fitted
        if is_fitted:
            contact = _at_edges(mesh, contact, name, findings)
        sides = _sides_of(mesh, contact)
        interfaces.comment(f"{contact.parts[0]} and {contact.parts[1]} touch: {unit} {size}.",
                           *([] if is_perfect else [ASK + "friction is assumed; Perfect joins them, remove the list where "
                                                    "they do not meet."]))
        interface = interfaces.child(name).set("Side 1", sides[0]).set("Side 2", sides[1])
        if is_fitted:
            interface.comment("Curved faces of both lie in each other in the drawing: gaps are those of facets.").set("Gap", "Closed")
        law = interface.child("Law")
        if is_perfect:
            law.set("Type", "Perfect")
        else:
            law.set("Type", "Coulomb Friction").set("Friction Coefficient", "$friction")
        findings.found.append(f"{contact.parts[0]} and {contact.parts[1]} touch, {unit} {size}: interface {name}")
        touched.update(contact.parts)
    if set(interfaces.names()) - set(choices.perfect):
        scene.child("Values").comment(ASK + "of all interfaces.").set("friction", 0.15)
        findings.undecided.append("interfaces: friction 0.15 is assumed wherever parts touch")
    return touched


def _at_edges(mesh: Mesh, contact: Contact, name: str, findings: Findings) -> Contact:
    """Without curved faces at edges of flat ones, and at the planes that cut bolts."""
    one, other = (without_curved_edges(mesh, rows, mesh.planes.get(part)) for part, rows in zip(contact.parts, contact.rows))
    left = sum(map(len, contact.rows)) - len(one) - len(other)
    if left:
        findings.found.append(f"{name}: {left} curved faces at the edge of flat ones, or at the cut of a bolt, are left out: what they and "
                              "the others hold there is the same motion")
    return dataclasses.replace(contact, rows=(one, other))


def _sides_of(mesh: Mesh, contact: Contact) -> list[str]:
    """The side sets of a contact: those of the mesh that hold the same faces, otherwise new ones."""
    names = []
    for own, other, rows in zip(contact.parts, reversed(contact.parts), contact.rows):
        wanted = set(map(tuple, rows.tolist()))
        same = [name for name, given in mesh.side_sets.items()
                if len(given) == len(rows) and set(map(tuple, given.tolist())) == wanted]
        name = same[0] if same else unused_name(f"{own}_on_{other}", {**mesh.side_sets, **mesh.node_sets})
        mesh.side_sets[name] = rows
        names.append(name)
    return names


def _add_boundaries(scene: SceneList, mesh: Mesh, touched: set[str], choices: Choices, title: str, findings: Findings) -> None:
    boundaries, responses = scene.child("Boundaries"), scene.child("Responses")
    joined = {str(item.value) for interface in scene.child("Interfaces").items if isinstance(interface, SceneList)
              for item in interface.items if not isinstance(item, SceneList) and hasattr(item, "value")}
    free = []
    unusable: dict[str, str] = {}  # why no set of a name is a boundary; empty where one is
    taken = set(scene.child("Interfaces").names())
    surface = outer_faces(mesh).rows()
    for kind, sets in (("Side Set", mesh.side_sets), ("Node Set", mesh.node_sets)):
        for name in sets:
            is_chosen = name in choices.held or (kind == "Side Set" and name in choices.loaded)
            if name in joined:
                unusable.setdefault(name, "is a side of an interface")
                continue
            what = _words(mesh, kind, name)
            if kind == "Side Set" and not _lies_on(surface, mesh.side_sets[name]):
                unusable[name] = "lies inside of a part in places"
                free.append(f"{what}, inside of a part in places")
                continue
            boundary_name = unused_name(name, taken)
            ask = "" if is_chosen else ASK
            if MIRROR.search(name) and kind == "Side Set" and not is_chosen:
                boundaries.comment(ASK + f"{what} is taken for a plane of symmetry.")
                boundaries.child(boundary_name).set(kind, name).child("Law").set("Type", "Symmetry")
            elif name in choices.held or (HELD.search(name) and not is_chosen):
                boundaries.comment(ask + f"{what} is {'held' if is_chosen else 'taken for a support'}.")
                law = boundaries.child(boundary_name).set(kind, name).child("Law").set("Type", "Prescribed Displacement")
                for axis in "XYZ"[:mesh.dimension]:
                    law.set(axis, 0.0)
                _add_reactions(responses, boundary_name, mesh.dimension)
            elif kind == "Side Set" and (is_chosen or LOADED.search(name)):
                boundaries.comment(ASK + f"{what} is {'loaded' if is_chosen else 'taken for a loaded surface'}; its "
                                   "tractions are 0.")
                law = boundaries.child(boundary_name).set(kind, name).child("Law").set("Type", "Prescribed Traction")
                for axis in "XYZ"[:mesh.dimension]:
                    law.set(axis, 0.0)
                    if choices.preloads:
                        law.set(f"{axis} History", LOADING)
                _add_mean_displacements(responses, name, mesh.dimension)
            else:
                free.append(what)
                continue
            unusable[name] = ""
            taken.add(boundary_name)
            touched |= _parts_of(mesh, kind, name)
            findings.found.append(f"boundary {boundary_name}, {'as asked for' if is_chosen else 'by the name of its set'}")
    if free:
        boundaries.comment("Sets that nothing refers to yet:", *free)
    _add_surfaces(boundaries, mesh, touched, taken, findings)
    if not choices.held or not choices.loaded:
        findings.undecided.append("boundaries: what holds and what loads the assembly")
    choices.demand_usable(title, unusable)


def _lies_on(surface: Array, rows: Array) -> bool:
    ours, theirs = codes(surface, rows)
    return bool(numpy.isin(theirs, ours).all())


def _add_reactions(responses: SceneList, boundary: str, dimension: int) -> None:
    for axis in "xyz"[:dimension]:
        direction = [float(axis == each) for each in "xyz"[:dimension]]
        responses.child(ended_name(f"reaction_{boundary}", f"_{axis}")).set("Type", "Interface Force").set("Interface", boundary).set(
            "Direction", direction)


def _add_mean_displacements(responses: SceneList, side_set: str, dimension: int) -> None:
    for axis in "xyz"[:dimension]:
        direction = [float(axis == each) for each in "xyz"[:dimension]]
        responses.child(ended_name(f"u_{side_set}", f"_{axis}")).set("Type", "Mean Displacement").set("Side Set", side_set).set(
            "Direction", direction)


def _add_surfaces(boundaries: SceneList, mesh: Mesh, touched: set[str], taken: set[str], findings: Findings) -> None:
    """A load of nothing on parts that nothing touches, for a scene needs something on each."""
    faces = outer_faces(mesh)
    part = numpy.asarray(mesh.part_of_block())[mesh.block_of(faces.element)]
    for number, name in enumerate(mesh.parts()):
        if name in touched:
            continue
        side_set = unused_name(f"{name}_surface", {**mesh.side_sets, **mesh.node_sets})
        mesh.side_sets[side_set] = faces.chosen(part == number).rows()
        boundary = unused_name(side_set, taken)
        taken.add(boundary)
        boundaries.comment(ASK + f"nothing touches {name}; this load of 0 on its whole surface stands for what does.")
        boundaries.child(boundary).set("Side Set", side_set).child("Law").set("Type", "Prescribed Traction")
        findings.undecided.append(f"part {name}: no other part touches it and no set names its support")


def _parts_of(mesh: Mesh, kind: str, name: str) -> set[str]:
    names, of_block = list(mesh.parts()), mesh.part_of_block()
    if kind == "Side Set":
        return {names[of_block[block]] for block in mesh.block_of(mesh.side_sets[name][:, 0])}
    return {names[of_block[number]] for number, block in enumerate(mesh.blocks)
            if numpy.isin(block.connectivity, mesh.node_sets[name]).any()}


def _words(mesh: Mesh, kind: str, name: str) -> str:
    """A set with its size and place."""
    if kind == "Node Set":
        nodes = mesh.node_sets[name]
        return f"{name}: {len(nodes)} nodes around ({_point(mesh.nodes[nodes].mean(axis=0), mesh.dimension)})"
    rows = mesh.side_sets[name]
    faces = faces_of(mesh)
    ours, theirs = codes(faces.rows(), rows)
    chosen = faces.chosen(numpy.isin(ours, theirs))
    _, centre, normal, area = face_measures(mesh, chosen)
    total = float(area.sum())
    mean = (normal * area[:, None]).sum(axis=0) / max(total, 1e-300)
    flat = f", normal ({_point(mean, mesh.dimension)})" if numpy.linalg.norm(mean) > 0.999 else ", not flat"
    middle = (centre * area[:, None]).sum(axis=0) / max(total, 1e-300)
    return (f"{name}: {len(rows)} faces, {'length' if mesh.dimension == 2 else 'area'} {total:.4g} around "
            f"({_point(middle, mesh.dimension)}){flat}")


def _point(at: Array, dimension: int) -> str:
    return ", ".join(number_text(float(f"{each:.4g}") + 0.0) for each in at[:dimension])
