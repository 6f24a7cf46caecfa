"""The wavy skin of printed bellows: one pitch of it, seen from the side, in closed form."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Wave:
    """A skin of constant ``thickness`` over the ``floor``, all in m.

    From the middle of a valley: a quarter circle of radius gap/2 on the air's side, a straight
    wall, a quarter circle around the crown of the bellows, and back. Under the valleys the cavity
    is ``channel`` high; the crown's top stands at ``height``.
    """

    pitch: float
    gap: float
    thickness: float
    floor: float
    channel: float
    height: float

    @property
    def valley(self) -> float:
        """Radius of the valley on the cavity's side [m]; half the gap on the other."""
        return self.gap / 2 + self.thickness

    @property
    def crown(self) -> float:
        """Radius of the crown on the cavity's side [m]; thicker by the wall outside."""
        return self.pitch / 2 - self.valley

    @property
    def crown_outside(self) -> float:
        """Radius of the crown outside [m]."""
        return self.crown + self.thickness

    @property
    def valley_centre(self) -> float:
        """Height of the valley circle's centre [m]."""
        return self.floor + self.channel + self.valley

    @property
    def crown_centre(self) -> float:
        """Height of the crown circle's centre [m]."""
        return self.height - self.crown_outside

    @property
    def straight(self) -> float:
        """Height of the straight walls [m]; the design is impossible unless positive."""
        return self.crown_centre - self.valley_centre

    def air_below(self, z: np.ndarray) -> np.ndarray:
        """Area of the cavity's profile below the heights ``z``, over one pitch [m2]."""
        under = self._under_circles(z, self.valley, self.crown)
        return under - self.pitch * np.minimum(np.maximum(z, 0.0), self.floor)

    def body_below(self, z: np.ndarray) -> np.ndarray:
        """Area under the skin's outside below the heights ``z``, over one pitch [m2]: floor, air
        and skin together."""
        return self._under_circles(z, self.gap / 2, self.crown_outside)

    def _under_circles(self, z: np.ndarray, valley: float, crown: float) -> np.ndarray:
        """Area under a curve of valley circles, straight walls and crown circles."""
        low, high = self.valley_centre, self.crown_centre
        in_valley = np.clip(z, low - valley, low) - low
        in_crown = np.clip(z, high, high + crown) - high
        return (
            self.pitch * np.clip(z, 0.0, low)
            - 2 * (_half_disc(in_valley, valley) + np.pi * valley**2 / 4)
            + 2 * crown * (np.clip(z, low, high) - low)
            + 2 * _half_disc(in_crown, crown)
        )


def _half_disc(s: np.ndarray, radius: float) -> np.ndarray:
    """Integral of sqrt(radius^2 - s^2) from 0 to ``s``."""
    bounded = np.clip(s / radius, -1.0, 1.0)
    root = np.sqrt(1.0 - bounded**2)
    return radius**2 * (bounded * root + np.arcsin(bounded)) / 2
