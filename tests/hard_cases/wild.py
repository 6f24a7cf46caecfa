"""Hypothesis strategies for designs and scenes anywhere within the limits, far from any preset."""

import math
from typing import Any

from hypothesis import strategies as st

from actuators.design import PRESETS, Design, DesignError
from actuators.design.parameter import Parameter
from actuators.materials import CATALOGUE
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.scene import Scene

MOST_CHANGES = 8
PRESSURES = (0.0, 1.0, 30.0, 1e3, 5e3, 2e4, 1e5, 1e6, 1e7)


def _value(draw: st.DrawFn, p: Parameter) -> Any:
    """A value within the limits in border units, over its decades."""
    if p.kind == "material":
        key = draw(st.sampled_from(sorted(CATALOGUE)))
        change = draw(st.sampled_from(["", "", "@incompressible", "@stiffness=1e-3",
                                       "@stiffness=1e3", "@nu=0.49"]))  # fmt: skip
        return key + change
    if p.kind == "choice":
        return draw(st.sampled_from(p.choices))
    assert p.lower is not None
    assert p.upper is not None
    if p.kind == "count":
        return draw(st.integers(int(p.lower), int(p.upper)))
    share = draw(st.sampled_from([0.0, 1.0]) | st.floats(0.0, 1.0))
    least = max(p.lower, 1e-3)
    value = math.exp(math.log(least) + share * math.log(p.upper / least))
    return float(f"{min(max(value, p.lower), p.upper):.6g}")


@st.composite
def wild_designs(draw: st.DrawFn, most_chambers: int = 60) -> Design:
    """A preset, changed parameter by parameter; a change that cannot be built is dropped."""
    design = PRESETS[draw(st.sampled_from(sorted(PRESETS)))].design
    if most_chambers < 60:
        count = draw(st.integers(1, most_chambers))
        design = _shortened(design, count)
    names = [p for p in design.parameters() if p.name != "chamber_count" or most_chambers == 60]
    for p in draw(st.lists(st.sampled_from(names), max_size=MOST_CHANGES)):
        try:
            design = design.changed(**{p.name: _value(draw, p)})
        except DesignError:
            continue
    return design


def _shortened(design: Design, count: int) -> Design:
    """With fewer chambers, and as long as those need."""
    document = design.to_document()
    before: int = document["chamber_count"]
    share = max(count / before, 0.12)
    for length in (share, 2 * share, 3 * share, 4 * share, 1.0):
        try:
            return design.changed(
                chamber_count=count, length=round(length * document["length_mm"], 3)
            )
        except DesignError:
            continue
    return design


def gravities() -> st.SearchStrategy[tuple[float, float, float] | None]:
    """Down, up, along, across, none at all, very much."""
    return st.sampled_from([None, (0.0, 0.0, -9.81), (0.0, 0.0, 9.81), (9.81, 0.0, 0.0),
                            (-9.81, 0.0, 0.0), (0.0, 9.81, 0.0), (0.0, 0.0, -981.0)])  # fmt: skip


def plain_scenes() -> st.SearchStrategy[Scene]:
    """Pressure and weight."""
    return st.builds(Scene, pressure_to=st.sampled_from(PRESSURES), gravity=gravities())


@st.composite
def full_scenes(draw: st.DrawFn) -> Scene:
    """Everything that a scene may hold."""
    end: dict[str, float] = draw(
        st.sampled_from(PRESSURES).map(lambda p: {"pressure_to": p})
        | st.sampled_from([-100e3, -5e3, -100.0]).map(lambda p: {"pressure_to": p})
        | st.sampled_from([1e-7, 1e-6, 1e-5, 1e-4]).map(lambda v: {"volume_to": v})
    )
    return Scene(
        **end,
        gravity=draw(gravities()),
        tip_force=draw(st.sampled_from([None, None, (0.0, 0.0, -0.05), (-1.0, 0.5, 0.0)])),
        outside_pressure=draw(st.sampled_from([0.0, 0.0, 100.0, -100.0, 5e3])),
        plate=draw(st.sampled_from([None, None, Plate(0.0), Plate(2e-3),
                                    Plate(1e-3, (0.0, 0.0, -1.0)), Plate(1e-3, (-1.0, 0.0, 1.0))])),
        cylinder=draw(st.sampled_from([None, None, Cylinder(5e-3, (0.02, 0.0, -0.00501))])),
    )  # fmt: skip
