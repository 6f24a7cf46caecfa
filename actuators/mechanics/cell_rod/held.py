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
    """Give the first piece what the clamp adds to its compliance and free turn."""
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
    laws.free[:, 0, BENDING] += chambers.free[:, 0, BENDING] * grip.pressed_turn / length


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


def shifted(
    path: LoadedPath, chambers: Chambers, grip: Grip, layout: Layout, chain: Chain,
    pressures: np.ndarray,
) -> LoadedPath:  # fmt: skip
    """Shapes at ``pressures`` (k,) with what pressure shifts the inside's line at the clamp, and
    with the free end's own place and turn under pressure and loads."""
    found = len(path.positions)
    curvature = chambers.free[:found, [0, -1], BENDING]
    compliance = np.linalg.inv(chambers.stiffness[:found, 0])[:, BENDING, BENDING]
    frames, positions = path.frames.copy(), path.positions.copy()
    up = path.frames[..., 2].copy()
    # the load that the end feels: per area of the underside, and on the end face
    down = -up[:, -1]
    area = float((chain.width * layout.length).sum())
    spread = (down @ chain.gravity) * float(chain.weight.sum()) / area - chain.outside
    loads = np.stack([spread, down @ chain.tip_force], axis=-1)
    turn = compliance * (loads @ grip.tip) + grip.pressed_tip * pressures[:found]
    positions[:, 1:] += (grip.pressed_shift * curvature[:, 0])[:, None, None] * up[:, :1]
    positions[:, -1] += (grip.pressed_lift * curvature[:, 1])[:, None] * up[:, -1]
    along = frames[:, -1, :, 0].copy()
    cosine, sine = np.cos(turn)[:, None], np.sin(turn)[:, None]
    frames[:, -1, :, 0] = cosine * along + sine * down
    frames[:, -1, :, 2] = cosine * up[:, -1] + sine * along
    return replace(path, positions=positions, frames=frames)
