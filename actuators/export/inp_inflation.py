"""Inflation of a deck: to a pressure, or by the pressures that a solve found for a volume.

CalculiX has no cavity of given volume. Where the pressure only rises (or only falls, to suction) on
the way to a volume, prescribing it instead leads the same way.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from actuators.errors import QuestionError
from actuators.export.inp_lines import MPA
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene

_AMPLITUDE = "INFLATION"
_ROW = 4
"""Pairs in a line of ``*AMPLITUDE``."""


@dataclass(frozen=True)
class Inflation:
    """``pressure`` at the end [Pa]; ``shares`` of it over the step's time (0 to 1), none for a
    straight rise; ``heading``: what a deck says of it."""

    pressure: float
    heading: tuple[str, ...]
    shares: tuple[tuple[float, float], ...] = ()

    @property
    def load(self) -> str:
        """The keyword line of the pressures."""
        return f"*DLOAD, AMPLITUDE={_AMPLITUDE}" if self.shares else "*DLOAD"

    @property
    def amplitude(self) -> list[str]:
        """Lines that define how the pressure goes; none for a straight rise."""
        if not self.shares:
            return []
        rows = [self.shares[k : k + _ROW] for k in range(0, len(self.shares), _ROW)]
        return [
            f"*AMPLITUDE, NAME={_AMPLITUDE}",
            *(", ".join(f"{time:.6g}, {share:.6g}" for time, share in row) for row in rows),
        ]


def inflation_of(scene: Scene) -> Inflation:
    """Straight to the pressure of a scene. Raises :class:`QuestionError` where it prescribes a
    volume."""
    if scene.pressure_to is None:
        raise needs_a_solve()
    text = f"** Cavity pressure at the end: {scene.pressure_to * MPA:.9g} MPa."
    return Inflation(scene.pressure_to, (text,))


@dataclass(frozen=True, eq=False)
class SolvedPath:
    """What a solve found on its way to a cavity of ``asked`` [m3]: ``volume`` [m3] and ``pressure``
    [Pa], (k,) each; ``error``: estimated, of the tip, as a fraction."""

    asked: float
    volume: np.ndarray
    pressure: np.ndarray
    converged: bool
    error: float | None

    @classmethod
    def of(cls, response: Response) -> "SolvedPath":
        """The path of an answer."""
        return cls(
            response.scene.volume_to or 0.0,
            np.array([point.cavity_volume or 0.0 for point in response.path]),
            np.array([point.pressure for point in response.path]),
            response.outcome is Outcome.CONVERGED,
            response.error_estimate,
        )

    @classmethod
    def of_document(cls, document: Mapping[str, Any]) -> "SolvedPath":
        """The path of a stored answer (``Response.to_document``)."""
        percent = document["error_estimate_percent"]
        return cls(
            1e-6 * document["scene"]["volume_ml"]["to"],
            1e-6 * np.array([point["cavity_volume_ml"] for point in document["path"]]),
            1e3 * np.array([point["pressure_kPa"] for point in document["path"]]),
            document["outcome"] == Outcome.CONVERGED,
            None if percent is None else percent / 100,
        )


def needs_a_solve() -> QuestionError:
    """The refusal of a deck for a volume where nothing is to be solved."""
    mend = (
        "Run 3D FE and take the deck from the saved version, write it with the command line "
        "(pneustudio export --what inp), which solves first, or prescribe a pressure."
    )
    return QuestionError(
        "what is inp, and the scene prescribes a volume: CalculiX has no cavity of given volume, "
        f"and the pressures that lead to it must be solved for first. {mend}",
        field="volume_ml", value="inp", mend=mend,
    )  # fmt: skip


def inflation_found(path: SolvedPath) -> Inflation:
    """The pressures of a solved path over the volume. Raises :class:`QuestionError` where the path
    ended early, or where a pressure belongs to more than one volume."""
    volume, pressure = path.volume, path.pressure
    asked = f"{1e6 * path.asked:.4g} ml"
    if not len(pressure):
        raise _refused(f"the path to {asked} has no state", "Export vtu.")
    order = np.sign(volume[-1] - volume[0]) or 1.0
    onward = (order * np.diff(pressure) > 0) & (order * np.diff(volume) > 0)
    if not onward.all():
        last = int(np.argmin(onward))
        raise _refused(
            f"on the way to {asked} the pressure has an extreme of about "
            f"{pressure[last] / 1e3:.3g} kPa at {1e6 * volume[last]:.4g} ml, which no given "
            "pressure leads past",
            f"Ask for a volume before {1e6 * volume[last]:.4g} ml, or export vtu.",
        )
    if not path.converged or len(pressure) < 2:
        raise _refused(
            f"the path to {asked} ended at {1e6 * volume[-1]:.4g} ml",
            f"Ask for a volume before {1e6 * volume[-1]:.4g} ml, or export vtu, which says more.",
        )
    return Inflation(float(pressure[-1]), _said(path), _shares(volume, pressure))


def _shares(volume: np.ndarray, pressure: np.ndarray) -> tuple[tuple[float, float], ...]:
    times = (volume - volume[0]) / (volume[-1] - volume[0])
    shares = pressure / pressure[-1] + 0.0  # no -0 where suction begins
    return tuple(zip((times + 0.0).tolist(), shares.tolist(), strict=True))


def _said(path: SolvedPath) -> tuple[str, ...]:
    volume, pressure = path.volume, path.pressure
    errors = (
        "" if path.error is None else f" (its tip is off by an estimated {100 * path.error:.2g} %)"
    )
    return (
        f"** The scene prescribes a cavity of {1e6 * volume[-1]:.6g} ml, which this program does "
        "not have: the",
        f"** amplitude {_AMPLITUDE} raises the pressure as our own solve found it{errors}, to",
        f"** {pressure[-1] * MPA:.9g} MPa; the step's time is the share of the way from "
        f"{1e6 * volume[0]:.6g} ml. The volume",
        "** that the elements of this deck come to differs as they are stiffer or softer.",
    )


def _refused(why: str, mend: str) -> QuestionError:
    return QuestionError(
        f"what is inp, and the scene prescribes a volume: {why}. {mend}",
        field="volume_ml", value="inp", mend=mend,
    )  # fmt: skip
