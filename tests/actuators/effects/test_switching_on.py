"""Estimates that are wrong: what a run comes to need switches itself on, says when, and the answer
is that of a run that had it from the start."""

import numpy as np
import pytest

from actuators.design import Design, preset
from actuators.geometry import build_body
from actuators.mechanics.continuum import solve
from actuators.mechanics.continuum.facing_walls import FacingWalls
from actuators.mechanics.effects import contacts
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.response import Effect, Response
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body

BAR = preset("printed-14").design.changed(chamber_count=3, length=30)
SLAB = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)
TWO_WALLS = preset("oblique-90").design.changed(
    chamber_count=2, length=26, channel_width=0, half_gap=0.15
)


def effect(response: Response, name: str) -> Effect:
    return next(e for e in response.effects if e.name == name)


def answered(design: Design, scene: Scene) -> Response:
    return solve(design, scene, mesh="coarse")


@pytest.mark.parametrize(
    ("name", "design", "scene"),
    [
        ("self_contact", TWO_WALLS, Scene(8e3, gravity=None, steps=2)),
        ("self_contact", TWO_WALLS, Scene(8e3, gravity=None)),
        ("plate_contact", SLAB, Scene(6e3, steps=2, plate=Plate(1.9e-3))),
        ("plate_contact", SLAB, Scene(4e3, steps=1, plate=Plate(0.5e-3))),
        ("cylinder_contact", SLAB, Scene(6e3, cylinder=Cylinder(5e-3, (34e-3, 0, -6.6e-3)))),
    ],
)
def test_contact_that_becomes_necessary_switches_itself_on(
    monkeypatch: pytest.MonkeyPatch, name: str, design: Design, scene: Scene
) -> None:
    always = answered(design, scene.choosing(**{name: "on"}))  # pyright: ignore[reportArgumentType]
    monkeypatch.setattr(contacts, "CLOSED", np.inf)
    monkeypatch.setattr(contacts, "REACHED", np.inf)
    found = answered(design, scene)
    assert effect(found, name).on
    assert effect(found, name).forced == "auto"
    assert "switched on during the run at" in effect(found, name).reason
    assert found.path[-1].pressure == pytest.approx(scene.pressure_to)
    moved = np.linalg.norm(always.path[-1].tip_displacement)
    gap = np.linalg.norm(np.subtract(found.path[-1].tip, always.path[-1].tip))
    assert gap < 2e-3 * moved
    if scene.steps is not None:
        assert [p.pressure for p in found.path] == pytest.approx([p.pressure for p in always.path])
    for before, after in zip(found.path, found.path[1:], strict=False):
        assert before.pressure < after.pressure


def test_a_linear_answer_that_misses_too_much_is_solved_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = Scene(20e3, gravity=None, steps=1)
    true = answered(BAR, scene.choosing(finite_strain="on"))
    monkeypatch.setattr(Forecast, "finite_strain_share", 1e-6)
    found = answered(BAR, scene)
    assert effect(found, "finite_strain").on
    assert "linear run" in effect(found, "finite_strain").reason
    assert found.path[-1].tip == pytest.approx(true.path[-1].tip, rel=1e-6)


def test_a_law_taken_for_neo_hookean_by_mistake_is_put_right(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    soft = SLAB.changed(bottom_material="elastosil-m4601-sorotoki")
    scene = Scene(12e3, gravity=None, steps=1)
    true = solve(soft, scene.choosing(hyperelasticity="on"), accuracy=0.001, mesh="coarse")
    monkeypatch.setattr(Forecast, "hyperelastic_share", 1e-9)
    found = solve(soft, scene, accuracy=0.001, mesh="coarse")
    assert effect(found, "hyperelasticity").on
    assert "after a first run" in effect(found, "hyperelasticity").reason
    assert found.path[-1].tip == pytest.approx(true.path[-1].tip, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "gap_mm"),
    [
        ("oblique-90", 3.0),
        ("oblique-45", 3.0 / np.sqrt(2)),
        ("oblique-15", 3.0 * np.sin(np.pi / 12)),
        ("printed-14", 1.0),
        ("bellows-9-1.6", 0.4),
    ],
)
def test_walls_across_a_gap_are_as_far_apart_as_designed(name: str, gap_mm: float) -> None:
    design = preset(name).design
    if name.startswith("oblique"):
        gap_mm *= design.half_gap * 2e3 / 3.0  # type: ignore[attr-defined]
    body = build_body(design)
    mesh = mesh_body(body.half() if body.symmetric else body)
    walls = FacingWalls(mesh)
    # the gaps before the first and after the last block may be half as wide
    assert walls.at_rest.max() == pytest.approx(gap_mm * 1e-3, rel=1e-6)
    assert walls.at_rest.min() > 0.49e-3 * gap_mm
    # pushed along X1 by their place, walls come together by as much over each gap
    squeezed = np.zeros_like(mesh.nodes)
    squeezed[:, 0] = -0.01 * mesh.nodes[:, 0]
    assert walls.openness(squeezed) == pytest.approx(0.99, abs=0.01)
    assert walls.openness(0.01 * mesh.nodes) == pytest.approx(1.01, abs=1e-3)


def test_slabs_have_no_walls_that_face_each_other() -> None:
    walls = FacingWalls(mesh_body(build_body(SLAB)))
    assert walls.openness(np.zeros((1, 3))) == np.inf
