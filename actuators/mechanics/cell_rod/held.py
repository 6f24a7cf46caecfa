"""What clamped ends do (:mod:`.grip`, :mod:`.root`) as part of a rod's laws and shape."""

from dataclasses import replace

import numpy as np

from actuators.mechanics.cell_rod.chambers import Chambers
from actuators.mechanics.cell_rod.grip import Grip
from actuators.mechanics.cell_rod.root import Root
from actuators.mechanics.rod.chain import Chain
from actuators.mechanics.rod.follow import Laws, LoadedPath
from actuators.mechanics.rod.pieces import Layout

BENDING, UPRIGHT = 2, 5


def hold(laws: Laws, layout: Layout, chambers: Chambers, grip: Grip) -> None:
    """Give the first piece what the clamp adds to its compliance, free turn and free shift, and the
    last one what pressure lifts the tip."""
    length = layout.length[0]
    inside = np.linalg.inv(chambers.stiffness[:, 0])[:, BENDING, BENDING]
    own = np.linalg.inv(laws.stiffness[:, 0])
    own[:, BENDING, BENDING] += grip.turn * inside / length
    # upwards is against the bending's sign: a force up turns, a moment shifts, by -b
    for a, b in ((BENDING, UPRIGHT), (UPRIGHT, BENDING)):
        own[:, a, b] -= grip.mixed * inside / length
    own[:, UPRIGHT, UPRIGHT] += grip.shift * inside / length
    laws.stiffness[:, 0] = np.linalg.inv(own)
    laws.bent[0] = 0.0
    pressed = chambers.free[:, 0, BENDING] / length
    laws.free[:, 0, BENDING] += pressed * grip.pressed_turn
    laws.free[:, 0, UPRIGHT] += pressed * grip.pressed_shift
    end = chambers.free[:, -1, BENDING] / layout.length[-1]
    laws.free[:, -1, UPRIGHT] += end * grip.pressed_lift


def give(laws: Laws, layout: Layout, chambers: Chambers, root: Root) -> None:
    """Let the solid end turn by what it gives way to the first chamber."""
    border = max(int(np.flatnonzero(layout.chambered)[0]) - 1, 0)
    length = layout.length[border]
    softer = np.linalg.inv(chambers.stiffness[:, 0])[:, BENDING, BENDING] / root.bent
    own = np.linalg.inv(laws.stiffness[:, border])
    own[:, 1:4, 1:4] += softer[:, None, None] * root.compliance / length
    laws.stiffness[:, border] = np.linalg.inv(own)
    inflated = chambers.free[:, 0, 1:4] @ root.free / max(root.free @ root.free, 1e-300)
    pressed = np.outer(inflated, root.pressed)
    laws.free[:, border, 1:4] += pressed / length


def turned(
    path: LoadedPath, chambers: Chambers, grip: Grip, layout: Layout, chain: Chain,
    pressures: np.ndarray,
) -> LoadedPath:  # fmt: skip
    """Shapes at ``pressures`` (k,) with the free end's own turn under pressure and loads."""
    found = len(path.positions)
    compliance = np.linalg.inv(chambers.stiffness[:found, 0])[:, BENDING, BENDING]
    frames, up = path.frames.copy(), path.frames[:, -1, :, 2]
    # the load that the end feels: per area of the underside, and on the end face
    down = -up
    area = float((chain.width * layout.length).sum())
    spread = (down @ chain.gravity) * float(chain.weight.sum()) / area - chain.outside
    loads = np.stack([spread, down @ chain.tip_force], axis=-1)
    turn = path.loads * compliance * (loads @ grip.tip) + grip.pressed_tip * pressures[:found]
    along = frames[:, -1, :, 0].copy()
    cosine, sine = np.cos(turn)[:, None], np.sin(turn)[:, None]
    frames[:, -1, :, 0] = cosine * along + sine * down
    frames[:, -1, :, 2] = cosine * up + sine * along
    return replace(path, frames=frames)
