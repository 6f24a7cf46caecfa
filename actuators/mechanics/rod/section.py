"""Solid sections: a rectangle of two bonded layers, as at the ends of an actuator."""

import math

import numpy as np


def layered_section(
    width: float, thickness: np.ndarray, youngs: np.ndarray, shear: np.ndarray
) -> np.ndarray:
    """Rod stiffness (4, 4) about the middle of the underside [N, N m, N m2], in the order stretch,
    torsion, bending about X2, bending about X3.

    ``thickness``, ``youngs``, ``shear``: (layers,) from the underside up [m, Pa, Pa]. Bending is
    the beam theory of a bonded section; torsion is Saint-Venant's series for a rectangle with the
    layers' mean shear modulus (exact for one material, otherwise an estimate: a short end piece
    hardly twists).
    """
    top = np.cumsum(thickness)
    bottom = top - thickness
    e = youngs * width
    axial = float((e * (top - bottom)).sum())
    first = float((e * (top**2 - bottom**2) / 2).sum())
    second = float((e * (top**3 - bottom**3) / 3).sum())
    height = float(top[-1])
    mean_shear = float((shear * thickness).sum()) / height
    return np.array(
        [
            [axial, 0, first, 0],
            [0, mean_shear * torsion_constant(width, height), 0, 0],
            [first, 0, second, 0],
            [0, 0, 0, axial * width**2 / 12],
        ]
    )


def sheet_section(width: float, stiffness: float, height: float) -> np.ndarray:
    """What a sheet that resists stretch along the axis adds to the section (4, 4): ``stiffness``
    [N/m] over the whole width, at this height."""
    axial = stiffness * width
    section = np.zeros((4, 4))
    section[np.ix_((0, 2), (0, 2))] = axial * np.array([[1, height], [height, height**2]])
    section[3, 3] = axial * width**2 / 12
    return section


def torsion_constant(a: float, b: float) -> float:
    """Saint-Venant torsion constant of an a by b rectangle [m4]; four terms of the series are
    exact to 1e-5 for every aspect ratio."""
    long, short = max(a, b), min(a, b)
    series = sum(math.tanh(n * math.pi * long / (2 * short)) / n**5 for n in (1, 3, 5, 7))
    return long * short**3 * (1 - 192 * short / (math.pi**5 * long) * series) / 3
