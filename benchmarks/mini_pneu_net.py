"""The mini pneu-net: one problem for several finite-element engines.

Bar 80 x 20 x 14 mm; bottom layer 3.5 mm, mu = 0.16 MPa; top layer mu = 0.04 MPa with five chambers
8 x 16 x 8.5 mm, walls of 6 mm between them, roof 2 mm. Neo-Hooke, kappa/mu = 1000, clamped at
X1 = 0, pressure 12 kPa and gravity (1070 kg/m3, -X3). The half X2 >= 0 is computed.
"""

import numpy as np

from actuators.geometry import CAVITY, Body, Region
from actuators.materials import Material, NeoHooke

PRESSURE = 12e3
GRAVITY = (0.0, 0.0, -9.81)
REFERENCE_TIP = 35.10e-3
"""Downward displacement of the tip [m], +- 0.02 mm: extrapolated from Q3 on a doubly graded mesh
with 202,000 unknowns (35.063)."""
MATERIALS = (
    Material("bottom", "bottom", NeoHooke(0.16e6), 1070.0, "benchmark"),
    Material("top", "top", NeoHooke(0.04e6), 1070.0, "benchmark"),
)


def mini_pneu_net() -> Body:
    """The whole bar; ``.half()`` is what is computed."""
    x = np.concatenate([[0.0], 8.0 + np.cumsum([0.0, *[8.0, 6.0] * 4, 8.0]), [80.0]])
    fill = np.ones((11, 4, 3), dtype=np.int8)
    fill[:, :, 0] = 0
    fill[1::2, 1:3, 1] = CAVITY
    return Body(
        lines=(
            x * 1e-3,
            np.array([-10.0, -8.0, 0.0, 8.0, 10.0]) * 1e-3,
            np.array([0.0, 3.5, 12.0, 14.0]) * 1e-3,
        ),
        fill=fill,
        regions=(Region("bottom layer", "bottom"), Region("top layer", "top")),
        place=lambda lattice: np.array(lattice, dtype=float),
        symmetric=True,
    )
