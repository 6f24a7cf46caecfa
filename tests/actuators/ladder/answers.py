"""Answers made up for tests: a tip that sinks in proportion to pressure."""

from collections.abc import Mapping
from typing import Any

from actuators.mechanics.ladder import Answer, Rung


def made_up(
    rung: Rung, *, slope: float = -1.0, to: float = 10.0, seconds: float = 1.0,
    outcome: str = "converged", estimates: Mapping[str, float] | None = None,
    limit: float | None = None, steps: int = 5, turn: float | None = None,
) -> Answer:  # fmt: skip
    """``slope`` of the tip [mm/kPa]; ``to`` [kPa]; ``estimates`` in percent; ``turn`` [deg/kPa]."""
    path = [
        {
            "pressure_kPa": to * k / steps,
            "tip_displacement_mm": [0.0, 0.0, slope * to * k / steps],
            "tip_rotation_deg": None if turn is None else turn * to * k / steps,
        }
        for k in range(steps + 1)
    ]
    document: dict[str, Any] = {
        "design": {"length_mm": 100.0},
        "scene": {"pressure_kPa": {"to": to}},
        "outcome": outcome,
        "advice": None,
        "path": path,
        "error_estimate_percent": (estimates or {}).get("tip"),
        "error_estimates_percent": dict(estimates or {}),
        "limit_pressure_kPa": limit,
        "wall_s": seconds,
    }
    return Answer.of_document(document, rung)
