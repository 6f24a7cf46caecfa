"""Where a path ends, and where it stops on the way."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from actuators.mechanics.continuum.newton import Equilibrium, Target
from actuators.mechanics.scene import Scene


@dataclass(frozen=True)
class Goal:
    """End of a path: a ``value`` of the cavity's pressure [Pa], or of the mesh's own part of its
    volume [m3] (``by_volume``). ``steps``: equal steps to report, None to keep every one found;
    ``stops``: the values to report, where they are not equal steps."""

    value: float
    by_volume: bool = False
    steps: int | None = None
    stops: tuple[float, ...] | None = None

    @staticmethod
    def of(scene: Scene, *, is_half: bool) -> "Goal":
        """Goal of a scene on a mesh of the whole body or of its half."""
        if scene.volume_to is not None:
            part = 0.5 if is_half else 1.0
            return Goal(part * scene.volume_to, by_volume=True, steps=scene.steps)
        return Goal(scene.pressure_to or 0.0, steps=scene.steps)

    @staticmethod
    def pressure(to: float, stops: Sequence[float] | None = None) -> "Goal":
        """A pressure, with the pressures to stop at (the last one ``to``)."""
        return Goal(to, stops=None if stops is None else tuple(stops))

    def measure(self, found: Equilibrium) -> float:
        """What of a state is to reach the value."""
        return found.volume if self.by_volume else found.pressure

    def target(self, value: float, guess: float = 0.0) -> Target:
        """What Newton's method is to hold; ``guess``: pressure to start from."""
        return Target(guess, volume=value) if self.by_volume else Target(value)

    def left(self, first: Equilibrium, last: Equilibrium) -> list[float] | None:
        """Values still to stop at beyond ``last`` on a path that began with ``first``."""
        begin, sign = self.measure(first), self.sign(first)
        if self.stops is not None:
            stops: Sequence[float] = self.stops
        elif self.steps is not None:
            span = self.value - begin
            stops = [begin + span * (i + 1) / self.steps for i in range(self.steps)]
        else:
            return None
        return [stop for stop in stops if sign * (stop - self.measure(last)) > 0]

    def sign(self, first: Equilibrium) -> float:
        """1 where the measure rises from ``first`` to the value, -1 where it falls."""
        return math.copysign(1.0, self.value - self.measure(first))

    def share(self, first: Equilibrium, found: Equilibrium) -> float:
        """Part of the way that is done, 0 to 1."""
        span = self.value - self.measure(first)
        share = (self.measure(found) - self.measure(first)) / span if span else 1.0
        return min(max(share, 0.0), 1.0)
