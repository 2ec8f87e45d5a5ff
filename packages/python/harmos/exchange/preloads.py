"""Bolts that are tightened by a force before the loads act, in a starting scene."""
from collections.abc import Iterable

import numpy

from harmos.exchange.contact import face_measures
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Mesh, codes, outer_faces, unused_name
from harmos.exchange.scene import Entry, SceneList, number_text

LOADING = "loading"
"""The history of what acts after tightening."""


def add_preloads(scene: SceneList, mesh: Mesh, forces: dict[str, float], findings: Findings) -> None:
    """Adds a Pretension for each of some parts, by their names, at the plane across it that the mesh has; forces [force] are
    reached in a load step of their own, behind which the bolts are locked."""
    if not forces:
        return
    taken = {*scene.child("Interfaces").names(), *scene.child("Boundaries").names()}
    for bolt, force in forces.items():
        plane = mesh.planes[bolt]
        name = unused_name(f"preload_{bolt}", taken)
        taken.add(name)
        interface = scene.child("Interfaces").comment(f"{bolt} is cut across its axis here, and drawn together there.").child(name)
        interface.set("Part", bolt).set("Point", list(plane.point)).set("Normal", list(plane.normal))
        interface.child("Law").set("Type", "Pretension").set("Force", force).set("Locked From", 1.0)
        responses = scene.child("Responses")
        responses.child(f"force_{bolt}").set("Type", "Bolt Force").set("Interface", name)
        findings.found.append(f"{bolt} is tightened to {force:g} at {_text(plane.point)}: interface {name}")
        for sense in _free_ends(scene, mesh, bolt):
            findings.undecided.append(f"{bolt}: nothing holds it beyond its cut, along {_text([sense * each for each in plane.normal])}: "
                                      "its head or thread touches no part there, and without that no preload is in equilibrium")
    if LOADING in scene.child("Boundaries").text():
        scene.child("Histories").child(LOADING).set("Type", "Table").set("Times", [0.0, 1.0, 2.0]).set("Values", [0.0, 0.0, 1.0])
    scene.child("Steps").comment("Bolts are tightened first; then they are locked, and the loads rise.").child("tighten")


def _free_ends(scene: SceneList, mesh: Mesh, bolt: str) -> list[float]:
    """On which sides of its plane no interface or boundary has a face of a part: 1 along the normal, -1 against it."""
    used = {str(item.value) for kind in ("Interfaces", "Boundaries") for each in scene.child(kind).items if isinstance(each, SceneList)
            for item in each.items if isinstance(item, Entry) and item.name in ("Side 1", "Side 2", "Side Set")}
    rows = numpy.concatenate([numpy.zeros((0, 2), dtype=numpy.int64), *(mesh.side_sets[name] for name in used)])
    rows = rows[numpy.isin(mesh.block_of(rows[:, 0]), mesh.parts()[bolt])]
    faces = outer_faces(mesh)
    _, centre, _, _ = face_measures(mesh, faces.chosen(numpy.isin(*codes(faces.rows(), rows))))
    along = (centre - numpy.array(mesh.planes[bolt].point)) @ numpy.array(mesh.planes[bolt].normal)
    return [sense for sense in (1.0, -1.0) if not (sense * along > 0.0).any()]


def _text(vector: Iterable[float]) -> str:
    return "(" + ", ".join(number_text(float(f"{each:.4g}") + 0.0) for each in vector) + ")"
