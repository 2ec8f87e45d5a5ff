"""Bolts that are tightened by a force before the loads act, in a starting scene."""
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Mesh, unused_name
from harmos.exchange.scene import SceneList, number_text

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
        at = ", ".join(number_text(float(f"{each:.4g}") + 0.0) for each in plane.point)
        findings.found.append(f"{bolt} is tightened to {force:g} at ({at}): interface {name}")
    if LOADING in scene.child("Boundaries").text():
        scene.child("Histories").child(LOADING).set("Type", "Table").set("Times", [0.0, 1.0, 2.0]).set("Values", [0.0, 0.0, 1.0])
    scene.child("Steps").comment("Bolts are tightened first; then they are locked, and the loads rise.").child("tighten")
