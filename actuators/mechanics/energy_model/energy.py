"""Energy model of one chamber (G, 1 to 11, corrected as in docs/theory.md).

Strains in a principal frame at phi from the axis, i = 1 along it and 2 across, z from the
underside:

    eps_11 = e1 + k1 z,  eps_22 = e2 + k2 z,  eps_33 = e3 + k3 z,  no shear.

The strain energy W = E/(2(1 + nu)) (J2 + nu/(1 - 2 nu) J1^2), J1 = tr eps, J2 = eps:eps (G's (3)
is a misprint) does not depend on phi: the rubber is isotropic. Only the work of pressure does, on
the walls that face across the chambers (angle theta),

    c p int_air eps_mm dV,  eps_mm = eps_11 sin^2(theta - phi) + eps_22 cos^2(theta - phi),

and its derivative to phi is proportional to sin 2(theta - phi): phi = theta is stationary, the
minimum, and what is left is linear in (e, k): 6 x 6, or 4 x 4 where nu = 1/2 eliminates eps_33. No
iteration; a test minimises over all seven unknowns and arrives at the same numbers.

The constant c multiplies the work of pressure. With c = 1 the model misses the bulging of the
chamber walls as plates, which is what bends most actuators; see :mod:`.constant`.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.energy_model.layers import Layers


@dataclass(frozen=True, eq=False)
class Moments:
    """Sums over the layers of a chamber. ``stiffness``: (..., 2, 2) int mu (1, z, z^2) dV [J, J m,
    J m2] as a matrix over (e, k); ``air``: (..., 2) int (1, z) dV over the chamber [m3, m4]."""

    stiffness: np.ndarray
    air: np.ndarray


def moments(layers: Layers) -> Moments:
    """Moments of every chamber of the batch."""
    z = layers.height
    power = [(z[..., 1:] ** n - z[..., :-1] ** n) / n for n in (1, 2, 3)]
    weight = layers.shear_modulus * layers.rubber
    zeroth, first, second = (np.sum(weight * p, axis=-1) for p in power)
    rows = [np.stack([zeroth, first], axis=-1), np.stack([first, second], axis=-1)]
    air = np.stack([np.sum(layers.air * p, axis=-1) for p in power[:2]], axis=-1)
    return Moments(np.stack(rows, axis=-2), air)


def plate_strains(layers: Layers) -> np.ndarray:
    """Incompressible answer with c = 1: (e1, e2, k1, k2) per pressure, (..., 4) [1/Pa, 1/(Pa m)].

    With eps_33 = -(eps_11 + eps_22) the energy is mu (2 eps_11^2 + 2 eps_22^2 + 2 eps_11 eps_22):
    the 4 x 4 matrix is [[4, 2], [2, 4]] times the moments, and pressure loads index 2 alone, so
    that the answer is (-1/6, 1/3) times one 2 x 2 solve; k1/k2 = -1/2 always.
    """
    m = moments(layers)
    if layers.sheet is not None and layers.sheet_height is not None:
        return _held_by_a_sheet(m, layers.sheet, layers.sheet_height)
    profile = np.linalg.solve(m.stiffness, m.air[..., None])[..., 0]
    return np.stack(
        [-profile[..., 0] / 6, profile[..., 0] / 3, -profile[..., 1] / 6, profile[..., 1] / 3],
        axis=-1,
    )


def _held_by_a_sheet(m: Moments, sheet: np.ndarray, height: np.ndarray) -> np.ndarray:
    """As :func:`plate_strains`, with the energy of a sheet, K/2 (e2 + k2 z)^2, added: it lies
    across the chambers (theta = 90 degrees), so that index 2 is the axis."""
    arm = np.stack([np.ones_like(height), height], axis=-1)
    matrix = np.einsum("ij,...ab->...iajb", np.array([[4.0, 2.0], [2.0, 4.0]]), m.stiffness)
    matrix[..., 1, :, 1, :] += sheet[..., None, None] * arm[..., :, None] * arm[..., None, :]
    load = np.stack([np.zeros_like(m.air), m.air], axis=-2)
    batch = m.air.shape[:-1]
    found = np.linalg.solve(matrix.reshape(*batch, 4, 4), load.reshape(*batch, 4, 1))[..., 0]
    return found[..., [0, 2, 1, 3]]


def plate_strains_compressible(layers: Layers, poisson: float) -> np.ndarray:
    """Answer with c = 1 for nu < 1/2: (e1, e2, e3, k1, k2, k3) per pressure, (..., 6); the 6 x 6
    system. Approaches :func:`plate_strains` as nu approaches 1/2."""
    m = moments(layers)
    tensor = 2 * (np.eye(3) + poisson / (1 - 2 * poisson) * np.ones((3, 3)))
    matrix = np.einsum("ij,...ab->...aibj", tensor, m.stiffness)
    matrix = matrix.reshape(*m.air.shape[:-1], 6, 6)
    load = np.einsum("...a,i->...ai", m.air, np.array([0.0, 1.0, 0.0]))
    load = load.reshape(*m.air.shape[:-1], 6, 1)
    return np.linalg.solve(matrix, load)[..., 0]


def rod_strains(layers: Layers) -> np.ndarray:
    """Energy model with c = 1 as rod strains per pressure, (..., 4) [1/Pa, 1/(Pa m)]: stretch,
    torsion, bending about X2, bending about X3 (none).

    Bending k1 cos^2 + k2 sin^2 and torsion (k2 - k1) sin cos of the frame at phi = theta.
    """
    plate = plate_strains(layers)
    s, c = np.sin(layers.theta), np.cos(layers.theta)
    return np.stack(
        [
            plate[..., 0] * c**2 + plate[..., 1] * s**2,
            (plate[..., 3] - plate[..., 2]) * s * c,
            plate[..., 2] * c**2 + plate[..., 3] * s**2,
            np.zeros_like(s),
        ],
        axis=-1,
    )
