"""The printed pneu-net: ours beside the thesis's two FE runs and its experiment."""

from collections.abc import Mapping

import numpy as np

from actuators.design import preset
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from benchmarks.validation.data import Answer
from benchmarks.validation.markdown import number, percent, table
from benchmarks.validation.plots import figure, picture
from benchmarks.validation.published import PRINTED_EXPERIMENT, PRINTED_LINEAR, PRINTED_YEOH

BOTTOMS, SIDES = (1.5, 2.0, 2.5), (1.0, 1.3, 1.6)
"""Bottom and side walls [mm]: the two unknown dimensions that move the answer most."""


def printed_section(answers: Mapping[str, Answer]) -> str:
    ours = {"linear": answers.get("printed-14-linear"), "Yeoh": answers.get("printed-14-yeoh")}
    theirs = {"linear": PRINTED_LINEAR, "Yeoh": PRINTED_YEOH}
    with figure("printed", 2) as (down, path):
        for name, colour in (("linear", "tab:blue"), ("Yeoh", "tab:orange")):
            found = ours[name]
            if found is not None:
                moved = found.column("tip_displacement_mm")
                down.plot(found.column("pressure_kPa"), moved[:, 2], "o-", ms=2.5, color=colour,
                          label=f"3D FE, {name}")  # fmt: skip
                path.plot(moved[:, 0], moved[:, 2], "o-", ms=2.5, color=colour)
            x, y = np.array(list(theirs[name].values())).T
            down.plot(list(theirs[name]), y, "s--", ms=3, lw=0.8, color=colour,
                      label=f"thesis, FE, {name}")  # fmt: skip
            path.plot(x, y, "s--", ms=3, lw=0.8, color=colour)
        mean = np.array(list(PRINTED_EXPERIMENT.values()))
        down.plot(list(PRINTED_EXPERIMENT), mean[:, 1], "k^", ms=4, label="thesis, experiment")
        path.plot(mean[:, 0], mean[:, 1], "k^", ms=4)
        down.set(xlabel="pressure, kPa", ylabel="tip across, mm")
        path.set(xlabel="tip along, mm", ylabel="tip across, mm", aspect="equal")
    rows = [
        [f"{p}", *(_ours(ours["linear"], p)), *_pair(PRINTED_LINEAR.get(p)),
         *(_ours(ours["Yeoh"], p)), *_pair(PRINTED_YEOH.get(p)), *_pair(PRINTED_EXPERIMENT.get(p))]
        for p in (10, 30, 50, 70, 100, 150, 200, 250)
    ]  # fmt: skip
    heads = ["kPa", "ours, linear: dx", "dy", "thesis, linear: dx", "dy", "ours, Yeoh: dx", "dy",
             "thesis, Yeoh: dx", "dy", "experiment: dx", "dy"]  # fmt: skip
    errors = ", ".join(
        f"{name} {percent(found.error_percent)} ({found.outcome} at "
        f"{number(float(found.column('pressure_kPa')[-1]))} kPa)"
        for name, found in ours.items()
        if found is not None
    )
    return "\n".join([
        picture("printed", "Tip of the printed pneu-net: ours, the thesis's FE and experiment"),
        table(heads, rows),
        f"\nDisplacements in mm; our error estimates: {errors}.\n",
        "How much two unknown dimensions move the answer, as initial curvature in 1/(m kPa) by the "
        f"instant model. The thesis's linear FE gives {number(_rate_of(PRINTED_LINEAR))}, its "
        f"experiment {number(_rate_of(PRINTED_EXPERIMENT))}; 20 % of any other assumed dimension "
        "moves ours by 0.3 to 14 %.\n",
        table(["bottom", *(f"side walls {s:g} mm" for s in SIDES)],
              [[f"{b:g} mm", *(number(_rate(b, s)) for s in SIDES)] for b in BOTTOMS]),
    ])  # fmt: skip


def _rate(bottom: float, side: float) -> float:
    design = preset("printed-14").design.changed(
        bottom_thickness=bottom, side_wall=side, material="ninjaflex-linear"
    )
    return float(predict(design, Scene(1e3, steps=1, gravity=None)).path[-1].curvature or 0.0)


def _curvature(dx: float, dy: float, length: float = 0.103) -> float:
    """Of the arc through the tip: its chord turns by half of what the arc turns."""
    return 2 * float(np.arctan2(-dy, length * 1e3 + dx)) / length


def _rate_of(published: Mapping[int, tuple[float, ...]]) -> float:
    """Curvature per pressure at 10 kPa."""
    return _curvature(*published[10][:2]) / 10


def _ours(found: Answer | None, pressure: float) -> tuple[str, str]:
    if found is None or pressure > found.column("pressure_kPa")[-1] + 1e-6:
        return ("–", "–")
    known = found.column("pressure_kPa")
    moved = found.column("tip_displacement_mm")
    return tuple(number(float(np.interp(pressure, known, moved[:, k]))) for k in (0, 2))  # type: ignore[return-value]


def _pair(values: tuple[float, ...] | None) -> tuple[str, str]:
    return ("–", "–") if values is None else (number(values[0]), number(values[1]))
