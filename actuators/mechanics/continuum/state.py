"""A state of the discrete problem, and how far it is from equilibrium."""

from dataclasses import dataclass, field

import numpy as np

from actuators.mechanics.continuum.contact import Touch
from actuators.mechanics.continuum.kernel.membrane import SHEET_POINTS


@dataclass(frozen=True, eq=False)
class State:
    """``displacement`` (n, 3) [m]; ``pressure`` (m, 4) [Pa], element-wise value and slopes;
    ``sheet`` (f, 6) [N/m], forces of embedded sheets, empty for none."""

    displacement: np.ndarray
    pressure: np.ndarray
    sheet: np.ndarray = field(default_factory=lambda: np.zeros((0, SHEET_POINTS)))

    def moved(self, factor: float, step: "State") -> "State":
        """self + factor * step."""
        sheet = factor * step.sheet
        return State(
            self.displacement + factor * step.displacement,
            self.pressure + factor * step.pressure,
            self.sheet + sheet if len(self.sheet) else sheet,
        )


@dataclass(frozen=True, eq=False)
class Balance:
    """Out-of-balance forces: ``residual`` (n, 3) [N], ``inner`` (m, 4) [m3], ``sheet`` (f, 6):
    stretch of a sheet less what its force accounts for; ``admissible`` is
    False where an element is turned inside out, or surfaces are too far inside each other to
    know where they met. ``touches``: what each interaction found."""

    residual: np.ndarray
    inner: np.ndarray
    sheet: np.ndarray
    admissible: bool
    touches: tuple[Touch, ...] = ()
