"""What the compiled rod is given: pieces with their law, what loads them, what they can meet.

Rod strains are e = (stretch, torsion, bending about X2, bending about X3, shear along X2, shear
along X3), their resultants S = (force along X1, moments about X1, X2, X3, forces along X2, X3). A
law holds at one pressure. With d = e - e_free, C the inverse of D and g the column of D for bending
about X2, whose stiffness falls as it bends (under a moment M alone d_2 = k, C_22 M = k - q),

    S = D d - q(k) g,      q = a k^2/2 + b k^3,      k + (C_22 D_22 - 1) q = C_22 g . d.

Beyond a range of k, in which what was measured may be believed and the law is stable, q grows on as
it does at the range's end.

Where walls of neighbouring chambers press on each other without resultants, loads can part them:
beyond the plane release . S = 1 the law goes on with the free strains e_free - parted and the
compliance D^-1 + parted release^T, so that it is continuous.
"""

from typing import NamedTuple

import numpy as np


class Chain(NamedTuple):
    """s pieces from the clamp on. ``length``: (s,) [m]; ``weight``: (s,) [N] in the direction
    ``gravity`` (3,), at ``height`` (s,) above the underside [m]; ``width``: (s,) [m] of the
    underside, which ``outside`` presses [Pa], staying normal to it; ``tip_force``: (3,) [N], dead,
    at the height ``tip_height`` [m] of the end face."""

    length: np.ndarray
    weight: np.ndarray
    height: np.ndarray
    gravity: np.ndarray
    width: np.ndarray
    outside: float
    tip_force: np.ndarray
    tip_height: float

    def scaled(self, share: float) -> "Chain":
        """This share of all loads."""
        return self._replace(
            weight=self.weight * share, outside=self.outside * share,
            tip_force=self.tip_force * share,
        )  # fmt: skip


class Law(NamedTuple):
    """``free``: (s, 6) strains without resultants; ``stiffness``: D (s, 6, 6); ``compliance``: its
    inverse, which measures what an equation lacks as a turn; ``bent``: (s, 4) a, b and the range of
    k; ``parted``,
    ``release``: (s, 6), 0 where there is nothing to part; ``apart``: D (s, 6, 6) beyond."""

    free: np.ndarray
    stiffness: np.ndarray
    compliance: np.ndarray
    bent: np.ndarray
    parted: np.ndarray
    release: np.ndarray
    apart: np.ndarray


class Obstacles(NamedTuple):
    """Frictionless rigid bodies against the points (``across``, ``above``) (s + 1, m) [m] of every
    border's section, which stand for ``share`` (s + 1, m) [m] of the rod's length.

    ``kind``: (o,) 0 plate, 1 cylinder; ``place``: (o, 3) a point of the plate or of the cylinder's
    axis; ``direction``: (o, 3) the plate's normal or the axis; ``radius``: (o,) [m]. The force per
    length and depth is ``stiffness`` [Pa]; it sets in over ``2 softness`` [m] below the surface.
    """

    across: np.ndarray
    above: np.ndarray
    share: np.ndarray
    kind: np.ndarray
    place: np.ndarray
    direction: np.ndarray
    radius: np.ndarray
    stiffness: float
    softness: float

    def softened(self, factor: float) -> "Obstacles":
        """Softer by this factor, and felt from farther off."""
        return self._replace(
            stiffness=self.stiffness / factor, softness=self.softness * factor**0.5
        )


def no_obstacles(pieces: int) -> Obstacles:
    """Nothing to meet."""
    none, far = np.zeros((pieces + 1, 0)), np.zeros((0, 3))
    kind = np.zeros(0, dtype=np.int64)
    return Obstacles(none, none, none, kind, far, far, np.zeros(0), 1.0, 1.0)
