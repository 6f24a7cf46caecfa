"""The tangent law of the inflated pitch as a piece of rod.

Unit resultants are put on the strains, with the cell held by its mean motion; the strains that
answer are its compliance. Bending about X3 answers alone, by the half turn's symmetry.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.screw import STRAINS
from actuators.mechanics.cell.helical.tangent import ODD_FREE, Factor, Tangent, Target, factorised


@dataclass(frozen=True, eq=False)
class PointLaw:
    """``stiffness``: (4, 4) resultants per strain [N, N m, N m2], without bending about X3 (see
    :func:`bending_about_x3`); ``volume_rate``: (4,) change of
    the whole pitch's cavity with the strains, at constant pressure [m3 per strain]."""

    stiffness: np.ndarray
    volume_rate: np.ndarray


def point_law(factor: Factor) -> PointLaw:
    """By the even factor just made near an equilibrium.

    Raises FactorizationError or LinAlgError where the tangent is singular.
    """
    stiffness, volume_rate = np.zeros((STRAINS, STRAINS)), np.zeros(STRAINS)
    compliance, growth = _answers(Tangent(factor, Target(factor.pressure, held=True)), factor)
    part = np.linalg.inv(compliance)
    stiffness[:3, :3] = (part + part.T) / 2
    volume_rate[:3] = part @ growth
    return PointLaw(stiffness, volume_rate)


def bending_about_x3(factor: Factor) -> float:
    """Stiffness [N m2] at the state of this even factor, whose free tangent is the last filled."""
    numbering = factor.system.numbering("odd")
    odd = factorised(factor.system, numbering, factor.state, factor.balance, factor.pressure)
    tangent = Tangent(odd, Target(factor.pressure, fixed=ODD_FREE, held=True))
    return float(1 / _answers(tangent, odd)[0][0, 0])


def _answers(tangent: Tangent, factor: Factor) -> tuple[np.ndarray, np.ndarray]:
    """Strains (s, s) and growth of the whole cavity (s,) per unit resultant of the whole rod."""
    numbering = factor.numbering
    count, border = numbering.count, numbering.border
    first = slice(count, count + len(numbering.strains))
    inner, outer = 2 * factor.column[:, -1], 2 * factor.corner[:border, -1]
    compliance, growth = [], []
    for unit in range(len(numbering.strains)):
        load = np.zeros(tangent.conditions)
        load[unit] = factor.system.domain.period / 2  # half a pitch
        solution = tangent.answer(load)
        compliance.append(solution[first])
        growth.append(inner @ solution[:count] + outer @ solution[count : count + border])
    return np.array(compliance).T, np.array(growth)
