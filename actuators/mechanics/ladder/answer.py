"""What one rung has answered, and how far two answers lie apart."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from actuators.mechanics.ladder.rungs import Rung
from actuators.mechanics.response import Outcome, Response

JUDGED = ("tip", "angle", "force", "limit_pressure")
"""Quantities that finite elements make as accurate as asked for."""
STILL = 1e-3
"""A tip that moves less than this part of the length is compared as if it moved that far."""
COMPLETE = (Outcome.CONVERGED, Outcome.LIMIT_POINT)


@dataclass(frozen=True, eq=False)
class Answer:
    """k points of one rung's path, in SI. ``pressure`` (k,) [Pa]; ``displacement`` (k, 3) [m] of
    the tip; ``turn`` (k,) [rad], ``volume`` (k,) [m3] and ``force`` (k,) [N], not a number where
    the rung does not know them. ``estimates``: its own, as fractions. ``length`` of the body
    [m]."""

    rung: Rung
    seconds: float
    outcome: Outcome
    advice: str | None
    pressure: np.ndarray
    displacement: np.ndarray
    turn: np.ndarray
    volume: np.ndarray
    force: np.ndarray
    limit_pressure: float | None
    estimates: Mapping[str, float]
    length: float
    by_volume: bool
    is_older: bool = False

    @staticmethod
    def of(response: Response, rung: Rung) -> "Answer":
        """From a response of this process."""
        return Answer.of_document(response.to_document(), rung)

    @staticmethod
    def of_document(document: Mapping[str, Any], rung: Rung, *, is_older: bool = False) -> "Answer":
        """From what ``predict --json`` prints and the store keeps; ``is_older``: computed by an
        older version of the science."""
        path: list[Mapping[str, Any]] = [p for p in document["path"] if _is_known(p)]
        estimates = dict(document.get("error_estimates_percent") or {})
        if document.get("error_estimate_percent") is not None:
            estimates["tip"] = document["error_estimate_percent"]
        limit = document.get("limit_pressure_kPa")

        def column(name: str, factor: float) -> np.ndarray:
            values = [p.get(name) for p in path]
            return np.array([np.nan if v is None else v * factor for v in values])

        return Answer(
            rung=rung,
            seconds=float(document.get("wall_s") or 0.0),
            outcome=Outcome(document["outcome"]),
            advice=document.get("advice"),
            pressure=column("pressure_kPa", 1e3),
            displacement=1e-3 * np.array([p["tip_displacement_mm"] for p in path]).reshape(-1, 3),
            turn=column("tip_rotation_deg", np.pi / 180),
            volume=column("cavity_volume_ml", 1e-6),
            force=np.fmax(column("plate_force_N", 1.0), column("cylinder_force_N", 1.0)),
            limit_pressure=None if limit is None else 1e3 * limit,
            estimates={
                name: 1e-2 * value for name, value in estimates.items() if value is not None
            },
            length=1e-3 * float(document["design"]["length_mm"]),
            by_volume="volume_ml" in document["scene"],
            is_older=is_older,
        )

    @property
    def is_complete(self) -> bool:
        """Whether it says where the path ends: at what was asked for, or at a limit point."""
        return self.outcome in COMPLETE and len(self.pressure) > 0

    @property
    def own_error(self) -> float | None:
        """Its own estimate of the tip's error, a fraction."""
        return self.estimates.get("tip")

    def satisfies(self, accuracy: float) -> bool:
        """Whether every judged estimate of its own is at most ``accuracy``."""
        judged = [self.estimates[name] for name in JUDGED if name in self.estimates]
        return self.is_complete and bool(judged) and max(judged) <= accuracy

    @property
    def measure(self) -> np.ndarray:
        """What grows along the path: the volume where one was asked for and is known, else the
        pressure's size, (k,)."""
        if self.by_volume and not np.isnan(self.volume).any():
            return np.abs(self.volume - self.volume[:1])
        return np.abs(self.pressure)


def _is_known(point: Mapping[str, Any]) -> bool:
    moved = [point["pressure_kPa"], *point["tip_displacement_mm"]]
    return all(value is not None for value in moved)


@dataclass(frozen=True)
class Difference:
    """How far an answer lies from another, as fractions of the other, at the last pressure [Pa]
    that both have: of the tip's displacement, the end's turn, the force on an obstacle, the limit
    pressure; None where one of the two does not know it."""

    pressure: float
    tip: float
    turn: float | None
    force: float | None
    limit_pressure: float | None


def difference(answer: Answer, best: Answer) -> Difference | None:
    """``answer`` against ``best``; None where they share no point beyond the start."""
    if len(answer.pressure) == 0 or len(best.pressure) == 0:
        return None
    end = min(float(answer.measure.max()), float(best.measure.max()))
    if end <= 0.0 and max(float(answer.measure.max()), float(best.measure.max())) > 0.0:
        return None
    moved, wanted = _at(answer, answer.displacement, end), _at(best, best.displacement, end)
    travel = max(float(np.linalg.norm(wanted)), STILL * best.length)
    angle = abs(float(_at(best, best.turn, end)))
    return Difference(
        pressure=float(_at(best, best.pressure, end)),
        tip=float(np.linalg.norm(moved - wanted)) / travel,
        turn=_share(_at(answer, answer.turn, end), _at(best, best.turn, end),
                    max(angle, travel / best.length)),
        force=_share(_at(answer, answer.force, end), _at(best, best.force, end)),
        limit_pressure=_share(answer.limit_pressure, best.limit_pressure),
    )  # fmt: skip


def _at(answer: Answer, values: np.ndarray, end: float) -> np.ndarray:
    """Values (k,) or (k, 3) where the path's measure comes to ``end``, linear between points."""
    measure = np.maximum.accumulate(answer.measure)
    columns = values.reshape(len(measure), -1).T
    found = np.array([np.interp(end, measure, column) for column in columns])
    return found if values.ndim > 1 else found[0]


def _share(value: Any, best: Any, size: float | None = None) -> float | None:
    if value is None or best is None or np.isnan(value) or np.isnan(best):
        return None
    size = abs(float(best)) if size is None else size
    return abs(float(value) - float(best)) / size if size > 0.0 else None
