"""Changes that mend a refused design, in numbers that a designer would write."""

import math

from actuators.errors import Change


def up_to_tenths(length: float) -> float:
    """The next tenth of a millimetre [mm] that is no shorter than ``length`` [m]."""
    return math.ceil(length * 1e4 - 1e-6) / 10


def fitting(needed: float, length: float, chambers: int, pitch: float) -> tuple[Change, ...]:
    """Of a bar whose chambers, at this pitch, need more than its length [m]: a longer bar, or
    fewer chambers."""
    fewer = chambers - math.ceil((needed - length) / pitch - 1e-9)
    longer = Change("length_mm", up_to_tenths(needed))
    return (longer, Change("chamber_count", fewer)) if fewer >= 1 else (longer,)
