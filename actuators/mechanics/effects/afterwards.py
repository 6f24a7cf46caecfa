"""Loads that were left out by an estimate, looked at again on the shape that was found.

Beforehand the straight or the rod's own shape says how much a load moves the tip; the answer's own
shape may be another. On it the load's resultants in every piece of the rod, its linear compliance
and the lever to the tip give the small displacement that the load would add. It is an estimate as
well, good to about a third: the inflated chamber is more or less stiff than the linear one.
"""

from dataclasses import replace

import numpy as np

from actuators.mechanics.effects.decision import EffectPlan
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.response import Effect, Response
from actuators.quantities import about, percent

LOADS = ("gravity", "outside_pressure", "tip_force")


def checked(response: Response, plan: EffectPlan) -> Response:
    """The answer with what came of the loads that ``plan`` left out by their estimates: their
    effects say it, and a note where a load moves the tip by more than may be left out."""
    names = [
        name for name in LOADS
        if not (decision := plan.by_name[name]).on and decision.forced == "auto" and decision.change
    ]  # fmt: skip
    if not names or response.centreline is None or not response.path:
        return response
    forecast = Forecast(plan.design, plan.scene)
    found = {name: _share(forecast, response, name) for name in names}
    notes = [
        f"{name.replace('_', ' ').capitalize()} was left out by an estimate, but on the shape "
        f"found it would move the tip by {about(share)} of its way, more than the "
        f"{percent(plan.threshold)} that may be left out. Switch it on."
        for name, share in found.items()
        if share > plan.threshold
    ]
    return replace(
        response,
        effects=tuple(_told(effect, found) for effect in response.effects),
        notes=(*response.notes, *notes),
    )


def _told(effect: Effect, found: dict[str, float]) -> Effect:
    if effect.name not in found:
        return effect
    share = found[effect.name]
    return replace(
        effect,
        reason=f"{effect.reason}; checked afterwards on the shape found: {percent(share)}",
        estimated_change_percent=100.0 * share,
    )


def _share(forecast: Forecast, response: Response, name: str) -> float:
    """Displacement of the tip over its longest way: the larger of those at the path's beginning and
    end."""
    assert response.centreline is not None
    moved = [
        np.linalg.norm(_added(forecast, positions, frames, response, name))
        for positions, frames in (
            (response.centreline.positions[n], response.centreline.frames[n]) for n in (0, -1)
        )
    ]
    way = max(float(np.linalg.norm(point.tip_displacement)) for point in response.path)
    return float(max(moved)) / way if way > 0.0 else np.inf


def _added(
    forecast: Forecast, positions: np.ndarray, frames: np.ndarray, response: Response, name: str
) -> np.ndarray:
    """Small displacement (3,) of the tip [m] by one load on a shape, (s, 3) and (s, 3, 3)."""
    assert response.centreline is not None
    rod, stations = forecast.rod, response.centreline.stations
    middles = forecast.middles
    at = np.stack([np.interp(middles, stations, column) for column in positions.T], axis=-1)
    flat = frames.reshape(len(stations), 9).T
    turn = np.stack([np.interp(middles, stations, column) for column in flat], axis=-1)
    turn, tip = turn.reshape(-1, 3, 3), positions[-1]
    where, force = at, np.zeros_like(at)
    if name == "gravity":
        where = at + rod.mass_height[:, None] * turn[..., 2]
        force = rod.mass[:, None] * np.array(forecast.scene.gravity or (0.0, 0.0, 0.0))
    elif name == "outside_pressure":
        size = forecast.scene.outside_pressure * forecast.width * rod.length
        force = size[:, None] * turn[..., 2]
    else:
        where = (tip + forecast.height / 2 * frames[-1, :, 2])[None]
        force = np.array([forecast.scene.tip_force or (0.0, 0.0, 0.0)])
    beyond = np.ones((len(at), 1)) if name == "tip_force" else np.triu(np.ones((len(at),) * 2))
    arms = where[None] - at[:, None]
    moment = np.einsum("ij,ija->ia", beyond, np.cross(arms, force[None]))
    pull = beyond @ force
    resultant = np.concatenate(
        [np.einsum("sa,sa->s", turn[..., 0], pull)[:, None],
         np.einsum("sab,sa->sb", turn, moment)], axis=1,
    )  # fmt: skip
    strain = np.einsum("sij,sj->si", rod.compliance, resultant) * rod.length[:, None]
    rotation = np.einsum("sab,sb->sa", turn, strain[:, 1:])
    sheared = forecast.sideways * np.einsum("sa,sa->s", turn[..., 1], pull)
    moved = np.cross(rotation, tip - at) + strain[:, :1] * turn[..., 0]
    return (moved + sheared[:, None] * turn[..., 1]).sum(axis=0)
