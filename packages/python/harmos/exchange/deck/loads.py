"""What acts on the parts of a deck, over the time of all steps."""
import dataclasses

from harmos.exchange.deck.cards import Card
from harmos.exchange.deck.curves import UNLOADED, Points, summed
from harmos.exchange.deck.transforms import Axes

Turn = tuple[str, tuple[float, ...], tuple[float, ...]]
"""A part that turns, a point of the axis, and its direction."""

NO_SHARE = 1e-12
"""Component of a unit vector that counts as none."""


@dataclasses.dataclass
class Preload:
    """What tightens a bolt.

    Attributes:
        points: curve of the displacement or of the force.
        is_force: which of them.
        locked: time from which the bolt keeps what the force has drawn together; None: it never does.
    """
    points: Points = UNLOADED
    is_force: bool = False
    locked: "float | None" = None


@dataclasses.dataclass
class Loads:
    """What acts, over time.

    Attributes:
        held: curve of a displacement, by node (index in the mesh) and component from 0, of nodes in `axes` along those.
        axes: of nodes whose held components are no global ones.
        forces: curve of a force, by node and component from 0, in global axes.
        turned_forces: the same in axes of the node, with the direction of each.
        pressures: curve of a pressure, by element and side.
        body_forces: curves of the acceleration times density [force/volume], by part and direction, of length 1.
        rotations: curve of the squared angular velocity, by part, point and axis.
        temperatures: curve of the temperature, by node; the first value is that without strain.
        force_cards: cards of forces, with nodes and global components that each acts on.
        pressure_cards: cards of pressures, with elements and sides that each acts on.
        preloads: of bolts, by the id of the reference node.
        steps: name, duration and increments.
    """
    held: dict[tuple[int, int], Points] = dataclasses.field(default_factory=dict)
    axes: dict[int, Axes] = dataclasses.field(default_factory=dict)
    forces: dict[tuple[int, int], Points] = dataclasses.field(default_factory=dict)
    turned_forces: dict[tuple[int, int, tuple[float, ...]], Points] = dataclasses.field(default_factory=dict)
    pressures: dict[tuple[int, int], Points] = dataclasses.field(default_factory=dict)
    body_forces: dict[tuple[str, tuple[float, ...]], Points] = dataclasses.field(default_factory=dict)
    rotations: dict[Turn, Points] = dataclasses.field(default_factory=dict)
    temperatures: dict[int, Points] = dataclasses.field(default_factory=dict)
    force_cards: list[tuple[Card, set[tuple[int, int]]]] = dataclasses.field(default_factory=list)
    pressure_cards: list[tuple[Card, set[tuple[int, int]]]] = dataclasses.field(default_factory=list)
    preloads: dict[int, Preload] = dataclasses.field(default_factory=dict)
    steps: list[tuple[str, float, int]] = dataclasses.field(default_factory=list)

    def global_forces(self) -> dict[tuple[int, int], Points]:
        """Curves of all forces, by node and component from 0 in global axes."""
        shares: dict[tuple[int, int], list[tuple[Points, float]]] = {key: [(points, 1.0)] for key, points in self.forces.items()}
        for (node, _, direction), points in self.turned_forces.items():
            for along, share in enumerate(direction):
                if abs(share) > NO_SHARE:
                    shares.setdefault((node, along), []).append((points, share))
        return {key: summed(listed) if len(listed) > 1 or listed[0][1] != 1.0 else listed[0][0] for key, listed in shares.items()}
