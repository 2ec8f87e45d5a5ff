"""The sense in which elements are numbered: those that a file numbers in the other one are turned, sets keep their faces."""
import numpy

from harmos.arrays import Array
from harmos.exchange.findings import Findings
from harmos.exchange.mesh import Block, Mesh


def oriented(mesh: Mesh, findings: Findings) -> Array:
    """Turns elements that are numbered in the other sense, with the sides of side sets, and tells how many. Which ones were turned,
    a flag per element."""
    turned = numpy.concatenate([_sense(mesh, block) < 0 for block in mesh.blocks])
    for first, block in zip(mesh.first_elements(), mesh.blocks):
        inside_out = turned[first:first + len(block.connectivity)]
        block.connectivity[inside_out] = block.connectivity[inside_out][:, block.type.mirrored()]
    if turned.any():
        mesh.side_sets = {name: turned_sides(mesh, turned, rows) for name, rows in mesh.side_sets.items()}
        findings.found.append(f"{int(turned.sum())} elements were numbered in the other sense and have been turned")
    return turned


def turned_sides(mesh: Mesh, turned: Array, rows: Array) -> Array:
    """A side set whose sides are numbered as before elements were turned, numbered as they are now."""
    result = rows.copy()
    blocks = numpy.where(turned[rows[:, 0]], mesh.block_of(rows[:, 0]), -1)
    for number, block in enumerate(mesh.blocks):
        own = blocks == number
        result[own, 1] = numpy.array(block.type.mirrored_sides())[rows[own, 1]]
    return result


def _sense(mesh: Mesh, block: Block) -> Array:
    """A number per element whose sign tells the sense in which its corners are numbered."""
    corner = mesh.nodes[block.connectivity[:, :block.type.corners]]
    if mesh.dimension == 2:
        first, last = corner[:, 1] - corner[:, 0], corner[:, -1] - corner[:, 0]
        result: Array = first[:, 0] * last[:, 1] - first[:, 1] * last[:, 0]
        return result
    centre = corner.mean(axis=1)
    volume = numpy.zeros(len(corner))
    for side in block.type.sides:
        at = corner[:, side]
        middle = at.mean(axis=1)
        for i in range(len(side)):
            one, other = at[:, i] - centre, at[:, (i + 1) % len(side)] - centre
            volume += numpy.einsum("ij,ij->i", numpy.cross(one, other), middle - centre)
    return volume
