"""Twelve slabs: six planforms, two top silicones."""

from collections.abc import Mapping

from actuators.design import preset
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from benchmarks.validation.data import Answer
from benchmarks.validation.markdown import number, percent, table
from benchmarks.validation.plots import figure, picture
from benchmarks.validation.studies import SLABS, TOPS


def slabs_section(answers: Mapping[str, Answer]) -> str:
    rows: list[list[str]] = []
    with figure("slabs", 2) as axes:
        for top, ax in zip(TOPS, axes, strict=True):
            for name in SLABS:
                found = answers.get(f"{name}-{top}")
                if found is None:
                    continue
                p = found.column("pressure_kPa")
                angle = found.column("bending_angle_deg")
                ax.plot(p, angle, "o-", ms=2.5, lw=1, label=name.removeprefix("slab-"))
                last = found.path[-1]
                at = min(8.0, float(p[-1]))
                instant = predict(preset(name).design.changed(top_material=top),
                                  Scene(at * 1e3, steps=1)).path[-1]  # fmt: skip
                rows.append([
                    name.removeprefix("slab-"), top.removeprefix("ecoflex-"), number(angle[0]),
                    number(found.at(at, "bending_angle_deg")),
                    number(float(instant.bending_angle) * 57.29578),
                    f"{found.outcome.replace('_', ' ')}, {number(p[-1])}", number(angle[-1]),
                    number(last.get("max_principal_stretch")), percent(found.error_percent),
                ])  # fmt: skip
            ax.set(xlabel="pressure, kPa", ylabel="bending angle, degrees",
                   title=top)  # fmt: skip
    return "\n".join([
        picture("slabs", "Bending angle of the slabs over pressure, up to their limit points"),
        table(["slab", "Ecoflex", "droop, deg", "angle at 8 kPa, deg", "instant model",
               "path ended, kPa", "angle there", "largest stretch", "error estimate"], rows),
    ])  # fmt: skip
