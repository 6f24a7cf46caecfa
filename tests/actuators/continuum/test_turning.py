"""Corrections and predictions that turn sections: exact on arcs, the plain step to first order."""

from collections.abc import Callable

import numpy as np
import pytest

from actuators.design import preset
from actuators.geometry import build_body
from actuators.mechanics.continuum.turning import Turning
from actuators.meshing import HexMesh, mesh_body


def mesh(half: bool) -> HexMesh:
    body = build_body(preset("slab-rectangle-low").design)
    return mesh_body(body.half() if half else body)


def bent(nodes: np.ndarray, curvature: float, twist: float = 0.0) -> np.ndarray:
    """A rod's pure bending about X2, or a small twist of it about X1."""
    angle = curvature * nodes[:, 0]
    y = nodes[:, 1]
    z = nodes[:, 2] - twist * nodes[:, 0] * nodes[:, 1]
    y = y + twist * nodes[:, 0] * nodes[:, 2]
    x = np.sin(angle) / curvature + z * np.sin(angle)
    return np.stack([x, y, -(1 - np.cos(angle)) / curvature + z * np.cos(angle)], axis=-1)


@pytest.mark.parametrize("half", [False, True])
def test_a_bar_that_bends_on_is_predicted_along_its_arc(half: bool) -> None:
    m = mesh(half)
    before, last, wanted = (bent(m.nodes, curvature) for curvature in (5.0, 10.0, 20.0))
    found = Turning(m).extrapolated(before, last, 2.0)
    straight = last + 2.0 * (last - before)
    length = m.nodes[:, 0].max()
    assert np.abs(straight - wanted).max() > 0.2 * length
    # the sections are as far apart along X1 as the mesh is coarse
    assert np.abs(found - wanted).max() < 5e-4 * length


@pytest.mark.parametrize("half", [False, True])
def test_a_turning_correction_goes_along_its_arc(half: bool) -> None:
    m = mesh(half)
    start = bent(m.nodes, 10.0)
    rate = (bent(m.nodes, 10.0 + 1e-5) - bent(m.nodes, 10.0 - 1e-5)) / 2e-5
    found = Turning(m).moved(start, 10.0 * rate)
    assert np.abs(found - bent(m.nodes, 20.0)).max() < 5e-4 * m.nodes[:, 0].max()


def second_order(move: Callable[[np.ndarray], np.ndarray], step: np.ndarray) -> float:
    """How much the deviation from the plain step shrinks when the step is halved."""
    return float(np.abs(move(step) - step).max() / np.abs(move(step / 2) - step / 2).max())


@pytest.mark.parametrize("half", [False, True])
def test_any_small_step_is_taken_as_it_is_and_what_is_held_stays(half: bool) -> None:
    m = mesh(half)
    start = bent(m.nodes, 10.0, twist=0.0 if half else 3.0)
    step = 1e-5 * np.random.default_rng(0).standard_normal(m.nodes.shape)
    step[m.clamp_nodes] = 0.0
    step[m.symmetry_nodes, 1] = 0.0
    turning = Turning(m)
    assert second_order(lambda du: turning.moved(start, du) - start, step) == pytest.approx(
        4.0, rel=0.01
    )
    moved = turning.moved(start, step)
    assert moved[m.clamp_nodes] == pytest.approx(start[m.clamp_nodes], abs=1e-15)
    assert moved[m.symmetry_nodes, 1] == pytest.approx(start[m.symmetry_nodes, 1], abs=1e-15)


def test_between_two_states_the_way_leads_back() -> None:
    m = mesh(half=False)
    before, last = bent(m.nodes, 5.0, twist=1.0), bent(m.nodes, 15.0, twist=2.0)
    back = Turning(m).extrapolated(before, last, -1.0)
    assert np.abs(back - before).max() < 1e-9
