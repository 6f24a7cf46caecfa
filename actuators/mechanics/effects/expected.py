"""What is expected of a question with choices in it: every effect is judged beside those that are
left in, not beside what the scene switches off."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

from actuators.design import Design
from actuators.mechanics.choices import NAMES
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.effects.reach import narrowing
from actuators.mechanics.scene import Scene


class Expectations:
    """Forecasts of ``design`` in ``scene``, whose choices stay as they are."""

    def __init__(self, design: Design, scene: Scene) -> None:
        self.design, self.scene = design, scene
        self.of = cache(self._of)
        self._narrowing = cache(narrowing)

    def _of(self, name: str) -> Forecast:
        """The forecast that the effect ``name`` is judged by: with the effect itself, and without
        what else is switched off."""
        if name and self.scene.choice(name) != "off":
            return self.of("")
        return Forecast(self.design, self._beside(name))

    def _beside(self, name: str) -> Scene:
        off = {n for n, choice in self.scene.forced.items() if choice == "off" and n != name}
        return without(self.scene, {n: n not in off for n in NAMES})

    def of_load(self, name: str) -> tuple[float, bool]:
        """Change of the tip by a load of the scene, over the way that the tip has; and whether
        obstacles take some of that."""
        forecast = self.of(name)
        if name == "gravity":
            share = forecast.weight_share
        else:
            load = forecast.force if name == "tip_force" else forecast.outside
            share = forecast.share(load.tip)
        # one linear solution goes through obstacles
        if share == 0.0 or self.scene.choice("finite_strain") == "off":
            return share, False
        narrowed = self._narrowing(forecast)
        return share * narrowed, narrowed > 1.0


def without(scene: Scene, kept: Mapping[str, bool]) -> Scene:
    """The scene without the loads and obstacles that are not ``kept``, all else left to choose."""
    keep = {**dict.fromkeys(NAMES, True), **kept}
    return replace(
        scene,
        gravity=scene.gravity if keep["gravity"] else None,
        outside_pressure=scene.outside_pressure if keep["outside_pressure"] else 0.0,
        tip_force=scene.tip_force if keep["tip_force"] else None,
        plate=scene.plate if keep["plate_contact"] else None,
        cylinder=scene.cylinder if keep["cylinder_contact"] else None,
        effects=(),
        self_contact="auto",
    )
