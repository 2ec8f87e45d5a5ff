"""Decks without sections, as mesh generators write them: a mesh whose element sets are parts and surfaces."""
import numpy

from harmos.arrays import Array
from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.contents import Contents, ElementTable
from harmos.exchange.deck.solids import Solids, is_solid
from harmos.exchange.deck.steps import OUTPUT
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Mesh, demand_sound, unused_name, without_loose_nodes
from harmos.exchange.sides import SideFinder, add_side_set


def is_bare(contents: Contents) -> bool:
    """Whether no section says what the elements are made of."""
    return not any(card.keyword == "SOLIDSECTION" for card in contents.model)


def read_bare(contents: Contents, findings: Findings, path: str) -> Mesh:
    """The mesh: element sets that share no solids become parts, those of flat elements and surfaces side sets, those of
    lines node sets, as node sets do. Physics is listed.

    Raises:
        Refused: the deck is damaged, or holds no solids.
    """
    physics = [card for card in contents.model if card.keyword not in ("HEADING", *OUTPUT)]
    physics += [step.card for step in contents.steps]
    if physics:
        more = f" and {len(physics) - 1} further cards" if len(physics) > 1 else ""
        findings.leave_out(physics[0].place, f"*{physics[0].keyword}{more}",
                           "the deck has no *SOLID SECTION, so that only its mesh is taken")
    family = "C3D" if any(table.kind.startswith("C3D") for table in contents.elements) else ""
    filling = [table for table in contents.elements
               if table.kind.startswith("C3D") or (not family and is_solid(table.kind)) or not table.nodes.shape[1]]
    others = [table for table in contents.elements if not any(table is each for each in filling)]
    on_cards = {table.set.upper() for table in contents.elements if table.set}
    _add_sections(contents, [table for table in filling if is_solid(table.kind)], on_cards, path)
    contents.elements = filling
    solids = Solids(contents, findings, path, False)
    _add_surfaces(contents, solids, findings)
    _add_flat_sets(contents, solids, others, on_cards, findings)
    _tell_sets_that_are_no_parts(contents, solids, on_cards, findings)
    for name, found in contents.node_sets.items():
        nodes = solids.nodes(numpy.unique(numpy.concatenate(found))) if found else numpy.zeros(0, dtype=numpy.int64)
        if len(nodes):
            solids.mesh.node_sets[_free(solids.mesh, contents.written(name))] = nodes
    loose = without_loose_nodes(solids.mesh)
    if loose:
        findings.found.append(f"{loose} nodes belong to no solid and have been left out")
    demand_sound(path, solids.mesh)
    return solids.mesh


def _free(mesh: Mesh, name: str) -> str:
    return unused_name(name, {**mesh.side_sets, **mesh.node_sets})


def _add_sections(contents: Contents, tables: list[ElementTable], on_cards: set[str], path: str) -> None:
    """A section for every group of solids: the smallest sets of their own first, then those that their cards name, then the
    rest."""
    whole = numpy.unique(numpy.concatenate([table.ids for table in tables] or [numpy.zeros(0, dtype=numpy.int64)]))
    left = whole
    sets = {name: numpy.intersect1d(numpy.concatenate(found), whole) for name, found in contents.element_sets.items() if found}
    own = sorted((name for name in sets if name not in on_cards), key=lambda name: len(sets[name]))
    for name in [*own, *(name for name in sets if name in on_cards)]:
        members = sets[name]
        if len(members) and numpy.isin(members, left).all() and (name in on_cards or _is_whole(members, tables)):
            contents.model.append(Card("SOLIDSECTION", {"ELSET": contents.written(name)}, path, 1, [], []))
            left = numpy.setdiff1d(left, members)
    if len(left):
        name = unused_name("PART" if len(left) == len(whole) else "OTHERS", contents.element_sets)
        contents.element_sets[name] = [left]
        contents.model.append(Card("SOLIDSECTION", {"ELSET": name.lower()}, path, 1, [], []))
    for table in tables:
        table.set = ""


def _is_whole(members: Array, tables: list[ElementTable]) -> bool:
    """Whether elements are all of some cards: a set of some elements within a card is a place in it, and no part."""
    return all(numpy.isin(table.ids, members).all() or not numpy.isin(table.ids, members).any() for table in tables)


def _add_surfaces(contents: Contents, solids: Solids, findings: Findings) -> None:
    for name, surface in contents.surfaces.items():
        rows = solids.surface(surface)
        if len(rows):
            add_side_set(solids.mesh, _free(solids.mesh, contents.written(name)), rows)
        else:
            findings.leave_out(surface.card.place, f"*SURFACE {contents.written(name)}", "no solid has a face on it")


def _add_flat_sets(contents: Contents, solids: Solids, tables: list[ElementTable], on_cards: set[str],
                   findings: Findings) -> None:
    """Side sets and node sets of elements that only mark faces and edges; sets that cards name count where no other does."""
    mesh = solids.mesh
    nodes_of: dict[int, Array] = {}
    for table in tables:
        nodes_of.update(zip(table.ids.tolist(), table.nodes))
    sets = {name: [each for each in numpy.unique(numpy.concatenate(found)).tolist() if each in nodes_of]
            for name, found in contents.element_sets.items() if found}
    named = {each for name, members in sets.items() if name not in on_cards for each in members}
    finder = SideFinder(mesh)
    for name, members in sets.items():
        if name in on_cards and named.intersection(members):
            continue
        rows, marked = [], []
        for element in members:
            at = _indices(contents, nodes_of[element])
            corners = _corners(len(at), mesh.dimension)
            if corners:
                rows.append([*at[corners], *[-1] * ((4 if mesh.dimension == 3 else 2) - len(corners))])
            else:
                marked.append(at)
        sides, lost = finder.find(numpy.array(rows, dtype=numpy.int64)) if rows else (numpy.zeros((0, 2), dtype=int), 0)
        if lost:
            findings.leave_out(contents.set_places.get(name, tables[0].card.file), f"*ELSET {contents.written(name)}",
                               f"{lost} of its flat elements are sides of no solid")
        if len(sides):
            add_side_set(mesh, _free(mesh, contents.written(name)), sides)
        if marked and name not in on_cards:
            nodes = numpy.unique(numpy.concatenate(marked))
            mesh.node_sets[_free(mesh, contents.written(name))] = nodes[numpy.isin(nodes, solids.used_nodes())]


def _tell_sets_that_are_no_parts(contents: Contents, solids: Solids, on_cards: set[str], findings: Findings) -> None:
    """Lists element sets whose solids belong to parts of other names."""
    mesh = solids.mesh
    names, part_of_block = list(mesh.parts()), numpy.asarray(mesh.part_of_block())
    own = {card.get("ELSET") for card in contents.model if card.keyword == "SOLIDSECTION"}
    for name, place in contents.set_places.items():
        found = contents.element_sets.get(name)
        elements = solids.elements(numpy.unique(numpy.concatenate(found))) if found else numpy.zeros(0, dtype=numpy.int64)
        parts = [names[part] for part in numpy.unique(part_of_block[mesh.block_of(elements)])] if len(elements) else []
        if name in own or not parts or (name in on_cards and len(parts) == 1):
            continue
        listed = ", ".join(parts[:4]) + (f" and {len(parts) - 4} more" if len(parts) > 4 else "")
        findings.leave_out(place, f"*ELSET {contents.written(name)}", f"{len(elements)} solids in it make no part of their own: they belong to "
                           f"{listed}")


def _indices(contents: Contents, ids: Array) -> Array:
    """Where nodes are in the mesh; -2 of those that are not there."""
    at = numpy.minimum(numpy.searchsorted(contents.node_ids, ids), len(contents.node_ids) - 1)
    result: Array = numpy.where(contents.node_ids[at] == ids, at, -2)
    return result


def _corners(nodes: int, dimension: int) -> list[int]:
    """Which nodes of a flat element are its corners by their number; none: it has not the shape of a side. Decks have the
    middle of a line between its ends."""
    if dimension == 2:
        return {2: [0, 1], 3: [0, 2]}.get(nodes, [])
    return {3: [0, 1, 2], 4: [0, 1, 2, 3], 6: [0, 1, 2], 8: [0, 1, 2, 3], 9: [0, 1, 2, 3]}.get(nodes, [])
