"""For every effect one scene that needs it and one that does not: the decision is right in both by
finite elements with and without it, and what is off executes nothing of it.

Coarsest meshes of small bodies: both sides of every comparison have the same mesh error.
"""

from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest

from actuators.design import Design, preset
from actuators.mechanics.choices import Choice
from actuators.mechanics.continuum import level, refinement, solve, tracer
from actuators.mechanics.continuum.contact.obstacle import Obstacle
from actuators.mechanics.continuum.contact.search import PairSearch
from actuators.mechanics.continuum.outer_loads import OuterLoads
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.response import Effect, Response
from actuators.mechanics.scene import Scene

ACCURACY = 0.05
BAR = preset("printed-14").design.changed(chamber_count=3, length=30)
SLAB = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)
TWO_WALLS = preset("oblique-90").design.changed(
    chamber_count=2, length=26, channel_width=0, half_gap=0.15
)
MOON = (0.0, 0.0, -1.62)


def effect(response: Response, name: str) -> Effect:
    return next(e for e in response.effects if e.name == name)


def answered(design: Design, scene: Scene, **choices: Choice) -> Response:
    return solve(design, scene.choosing(**choices), accuracy=ACCURACY, mesh="coarse")


def apart(one: Response, other: Response) -> float:
    """Distance of the last tips over the way of the second."""
    a, b = one.path[-1], other.path[-1]
    assert a.pressure == pytest.approx(b.pressure)
    way = np.linalg.norm(b.tip_displacement)
    return float(np.linalg.norm(np.subtract(a.tip, b.tip)) / way)


FLOATING: dict[str, Any] = {"gravity": None, "steps": 1}
PAIRS: dict[str, tuple[tuple[Design, Scene], tuple[Design, Scene]]] = {
    "gravity": ((SLAB, Scene(1e3, steps=1)), (BAR, Scene(20e3, steps=1, gravity=MOON))),
    "finite_strain": ((BAR, Scene(60e3, **FLOATING)), (BAR, Scene(1e3, **FLOATING))),
    "outside_pressure": (
        (BAR, Scene(1e3, outside_pressure=500.0, **FLOATING)),
        (BAR, Scene(1e3, outside_pressure=0.2, **FLOATING)),
    ),
    "tip_force": (
        (BAR, Scene(1e3, tip_force=(0.0, 0.0, -0.02), **FLOATING)),
        (BAR, Scene(1e3, tip_force=(0.0, 0.0, -2e-5), **FLOATING)),
    ),
    "self_contact": ((TWO_WALLS, Scene(8e3, **FLOATING)), (TWO_WALLS, Scene(3e2, **FLOATING))),
    "plate_contact": (
        (SLAB, Scene(4e3, steps=1, plate=Plate(0.5e-3))),
        (SLAB, Scene(4e3, steps=1, plate=Plate(20e-3))),
    ),
    "cylinder_contact": (
        (SLAB, Scene(4e3, steps=1, cylinder=Cylinder(5e-3, (30e-3, 0.0, -5.5e-3)))),
        (SLAB, Scene(4e3, steps=1, cylinder=Cylinder(5e-3, (30e-3, 0.0, 40e-3)))),
    ),
    "inextensible_layer": (
        (BAR, Scene(1e3, **FLOATING)),
        (BAR.changed(layer="none"), Scene(1e3, **FLOATING)),
    ),
}


@pytest.mark.parametrize("name", PAIRS)
def test_an_effect_that_matters_is_on(name: str) -> None:
    """Left out, it would change the tip by more than a quarter of the accuracy: what the plan may
    leave out at most is a half, and its estimates are good to a factor of two."""
    design, scene = PAIRS[name][0]
    chosen = answered(design, scene)
    assert effect(chosen, name).on
    assert effect(chosen, name).forced == "auto"
    off: dict[str, Choice] = {name: "off"}
    without = answered(design, scene, **off)
    assert not effect(without, name).on
    assert effect(without, name).forced == "off"
    assert apart(without, chosen) > ACCURACY / 4
    assert any("left out by choice" in note for note in without.notes)


@pytest.mark.parametrize("name", [n for n in PAIRS if n != "inextensible_layer"])
def test_an_effect_that_does_not_matter_is_off(name: str) -> None:
    design, scene = PAIRS[name][1]
    chosen = answered(design, scene)
    assert not effect(chosen, name).on
    assert effect(chosen, name).reason
    choices: dict[str, Choice] = {name: "on"}
    if name == "self_contact":
        choices["finite_strain"] = "on"
    held = answered(design, scene, **choices)
    assert effect(held, name).on
    assert effect(held, name).forced == "on"
    assert apart(chosen, held) < ACCURACY
    assert not any("left out by choice" in note for note in chosen.notes)


def test_a_load_is_judged_by_the_way_that_a_plate_leaves() -> None:
    """Sideways weight moves a bar's tip by 2 um of its free way of 0.9 mm, and by as much where a
    plate holds it after 0.05 mm: a twelfth of that, by finite elements with and without it."""
    held, free = (
        Scene(20e3, steps=1, gravity=(0.0, 9.81, 0.0), plate=Plate(gap)) for gap in (5e-5, 20e-3)
    )
    chosen, left_out = answered(BAR, held), answered(BAR, held, gravity="off")
    assert effect(chosen, "gravity").on
    assert "obstacles leave it" in effect(chosen, "gravity").reason
    assert apart(left_out, chosen) > ACCURACY / 4
    chosen, put_in = answered(BAR, free), answered(BAR, free, gravity="on")
    assert not effect(chosen, "gravity").on
    assert apart(chosen, put_in) < ACCURACY / 4


def test_sideways_weight_shears_a_bar_as_far_as_finite_elements_say() -> None:
    """On a sheet that keeps its length the bar hardly bends sideways: it shears. To a third, which
    is what estimates are good for."""
    linear: dict[str, Choice] = {"finite_strain": "off", "gravity": "on"}
    heavy = answered(BAR, Scene(1e3, steps=1, gravity=(0.0, 9.81, 0.0)), **linear)
    found = Forecast(BAR, Scene(1e3, gravity=(0.0, 9.81, 0.0))).weight
    assert found.tip[1] == pytest.approx(heavy.path[-1].tip[1], rel=1 / 3)
    assert found.sheared[1] > 0.8 * found.tip[1]


def test_an_effect_without_its_body_is_off() -> None:
    design, scene = PAIRS["inextensible_layer"][1]
    assert not effect(answered(design, scene), "inextensible_layer").on


@contextmanager
def counted(monkeypatch: pytest.MonkeyPatch, owner: Any, name: str) -> Generator[list[int]]:
    """How often ``owner.name`` is called."""
    calls: list[int] = []
    original: Callable[..., Any] = getattr(owner, name)

    def counting(*given: Any, **more: Any) -> Any:
        calls.append(1)
        return original(*given, **more)

    with monkeypatch.context() as patch:
        patch.setattr(owner, name, counting)
        yield calls


@pytest.mark.parametrize(
    ("name", "owner", "function"),
    [
        ("gravity", level, "with_weight"),
        ("self_contact", PairSearch, "near"),
        ("plate_contact", Obstacle, "add"),
        ("cylinder_contact", Obstacle, "add"),
        ("tip_force", OuterLoads, "add_residual"),
        ("outside_pressure", OuterLoads, "add_residual"),
    ],
)
def test_what_is_off_executes_nothing_of_it(
    monkeypatch: pytest.MonkeyPatch, name: str, owner: Any, function: str
) -> None:
    (needing, there), (other, not_there) = PAIRS[name]
    with counted(monkeypatch, owner, function) as calls:
        answered(needing, there)
    assert calls
    with counted(monkeypatch, owner, function) as calls:
        answered(other, not_there)
    assert not calls


def test_one_linear_solution_takes_one_factorisation_and_no_newton(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    design, scene = PAIRS["finite_strain"][1]
    with (
        counted(monkeypatch, tracer, "solve_equilibrium") as along,
        counted(monkeypatch, refinement, "solve_equilibrium") as finer,
    ):
        found = answered(design, scene)
        assert (along, finer) == ([], [])
        assert found.newton_iterations == 1
        answered(design, scene, finite_strain="on")
        assert along


def test_a_law_close_to_neo_hookean_is_computed_as_such() -> None:
    """At 3 % of strain Ecoflex and its neo-Hookean law are one; at 60 % they are not."""
    weak, strong = Scene(300.0, **FLOATING), Scene(8e3, **FLOATING)
    assert not effect(answered(SLAB, weak), "hyperelasticity").on
    both = answered(SLAB, weak, finite_strain="on", hyperelasticity="on")
    plain = answered(SLAB, weak, finite_strain="on", hyperelasticity="off")
    assert apart(plain, both) < ACCURACY / 10
    chosen = solve(SLAB, strong, accuracy=0.005, mesh="coarse")
    assert effect(chosen, "hyperelasticity").on
    without = answered(SLAB, strong, hyperelasticity="off")
    assert apart(without, chosen) > 0.005 / 4


def test_half_a_body_answers_like_the_whole() -> None:
    scene = Scene(2e3, steps=1)
    half, whole = answered(SLAB, scene), answered(SLAB, scene, symmetry="off")
    assert effect(half, "symmetry").on
    assert not effect(whole, "symmetry").on
    assert whole.unknowns > 1.5 * half.unknowns
    assert apart(half, whole) < 1e-4
    tilted = answered(SLAB, Scene(2e3, steps=1, gravity=(0.0, 3.0, -9.0)))
    assert not effect(tilted, "symmetry").on


def test_a_volume_is_controlled_and_a_pressure_is_not() -> None:
    by_pressure = answered(SLAB, Scene(1e3, steps=1))
    volume = by_pressure.path[-1].cavity_volume
    assert volume is not None
    by_volume = answered(SLAB, Scene(volume_to=volume, steps=1))
    assert effect(by_volume, "volume_control").on
    assert not effect(by_pressure, "volume_control").on
    assert by_volume.path[-1].pressure == pytest.approx(1e3, rel=1e-3)


def test_a_linear_answer_to_a_volume_has_that_volume() -> None:
    rest = answered(BAR, Scene(1e3, **FLOATING))
    wanted = rest.path[-1].cavity_volume
    assert wanted is not None
    found = answered(BAR, Scene(volume_to=wanted, gravity=None, steps=1))
    assert not effect(found, "finite_strain").on
    assert found.path[-1].pressure == pytest.approx(1e3, rel=1e-6)
    assert found.path[-1].tip == pytest.approx(rest.path[-1].tip, rel=1e-9)
