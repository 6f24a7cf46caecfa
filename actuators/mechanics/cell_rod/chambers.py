"""The inflated chambers of a design over pressure: paths of a few cells, interpolated."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator

from actuators.mechanics.cell.inflated import CellPath

STRAINS = 4
EMPTIED = 0.1
"""Share of a cavity at rest below which walls inside it have met, which a cell does not hold
apart: its path is not followed further."""
_FINE = 2001


@dataclass(frozen=True, eq=False)
class Chambers:
    """n chambers at k pressures. ``free``: (k, n, 4) rod strains without resultants; ``stiffness``:
    (k, n, 4, 4) tangent; ``growth``: (k, n) of the cavity since no pressure [m3]; ``volume_rate``:
    (k, n, 4) its change with the strains [m3 per strain]; ``stretch``: (k,) largest in any chamber;
    ``contact``: (k,) largest pressure between walls [Pa], None where contact was left out."""

    free: np.ndarray
    stiffness: np.ndarray
    growth: np.ndarray
    volume_rate: np.ndarray
    stretch: np.ndarray
    contact: np.ndarray | None


def reached(paths: Sequence[CellPath], wanted: float) -> float:
    """The last pressure [Pa] up to ``wanted`` (suction: below 0) that every cell has."""
    ends = [float(path.pressure[_usable(path) - 1]) for path in paths]
    return min([wanted, *ends]) if wanted >= 0 else max([wanted, *ends])


def inflated(paths: Sequence[CellPath], weights: np.ndarray, pressures: np.ndarray) -> Chambers:
    """Chambers at ``pressures`` (k,) within what the paths reach; ``weights`` (n, cells)."""
    answers = [_at(path, pressures) for path in paths]

    def along(name: str) -> np.ndarray:
        return np.einsum("nc,ck...->kn...", weights, np.array([a[name] for a in answers]))

    contacts = [a["contact"] for a in answers if "contact" in a]
    return Chambers(
        free=along("strain"),
        stiffness=along("stiffness"),
        growth=along("growth"),
        volume_rate=along("volume_rate"),
        stretch=np.max([a["stretch"] for a in answers], axis=0),
        contact=np.max(contacts, axis=0) if contacts else None,
    )


def parting(
    chambers: Chambers, apart: Chambers, pressed: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """What loads that part touching walls do away with, at the pressures that are ``pressed``
    (k,): free strains (k, n, 4), and (k, n, 4) the resultants' share (see :mod:`..rod.chain`), 0
    elsewhere. ``apart``: the same chambers, whose walls run through each other.

    Walls that press on each other at one place with a force N give the strains a N; without N the
    compliance is greater by a multiple of a a^T. Of the two found, bending and torsion say by
    which.
    """
    parted = np.where(pressed[:, None, None], chambers.free - apart.free, 0.0)
    softer = np.linalg.inv(apart.stiffness) - np.linalg.inv(chambers.stiffness)
    turned = parted.copy()
    turned[..., 0] = 0.0
    size = (turned**2).sum(axis=-1)
    along = np.einsum("kna,knab,knb->kn", turned, softer, turned)
    real = (size > 0.0) & (along > 0.0)
    factor = np.where(real, along, 0.0) / np.where(real, size, 1.0) ** 2
    return np.where(real[..., None], parted, 0.0), factor[..., None] * parted


def is_sucked_empty(path: CellPath) -> bool:
    """Whether suction goes on to where the cavity's walls would run through each other."""
    return bool((path.volume < EMPTIED * path.volume[0]).any())


def _usable(path: CellPath) -> int:
    """Points up to the path's first turn of the pressure, or of the volume (where walls press and
    steps have become tiny, what they find may jump to and fro), or to where it is sucked empty."""
    step = np.diff(path.pressure)
    if len(step) == 0:
        return 1
    onward = np.sign(step[0])
    ended = (onward * step <= 0) | (onward * np.diff(path.volume) <= 0)
    ended |= path.volume[1:] < EMPTIED * path.volume[0]
    first = np.flatnonzero(ended)
    return int(first[0]) + 1 if len(first) else len(path.pressure)


def _at(path: CellPath, pressures: np.ndarray) -> dict[str, np.ndarray]:
    """Values of one cell. Its volume leads: towards a limit point it grows on while the pressure
    hardly does."""
    points = _usable(path)
    values = {
        "strain": path.strain[:points], "stiffness": path.stiffness[:points],
        "growth": path.volume[:points] - path.volume[0], "volume_rate": path.volume_rate[:points],
        "stretch": path.max_stretch[:points],
    }  # fmt: skip
    if path.contact_pressure is not None:
        values["contact"] = path.contact_pressure[:points]
    if points == 1:
        return {name: np.repeat(value, len(pressures), axis=0) for name, value in values.items()}
    sign = np.sign(path.pressure[points - 1] - path.pressure[0])
    lead, pressure = sign * values["growth"], sign * path.pressure[:points]
    per_growth = 1 / path.compliance[:points]
    fine = np.linspace(0.0, lead[-1], _FINE)
    pressed = np.maximum.accumulate(CubicHermiteSpline(lead, pressure, per_growth)(fine))
    where = np.interp(sign * pressures, pressed, fine)
    slope = sign * path.strain_rate[:points] * per_growth[:, None]
    found = {name: PchipInterpolator(lead, value)(where) for name, value in values.items()}
    found["strain"] = CubicHermiteSpline(lead, values["strain"], slope)(where)
    found["growth"] = sign * where
    return found
