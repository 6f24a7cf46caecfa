"""What is in the way of a state that equilibrium allows."""

import numpy as np
import pytest

from actuators.design import preset
from actuators.geometry import build_body
from actuators.mechanics.continuum.cavity_gap import CavityWalls
from actuators.mechanics.continuum.state import State
from actuators.mechanics.continuum.unmodelled import CROSSED, EMPTIED, HALVED, MOUNTED, Unmodelled
from actuators.meshing import HexMesh, mesh_body
from tests.actuators.contact.pressed import box


def moved_to(mesh: HexMesh, positions: np.ndarray) -> State:
    return State(positions - mesh.nodes, np.zeros((len(mesh.elements), 4)))


@pytest.mark.parametrize(("turns", "in_the_way"), [(0.9, None), (0.99, MOUNTED), (1.02, MOUNTED)])
def test_a_strip_curled_round_into_its_own_clamp(turns: float, in_the_way: str | None) -> None:
    """What holds the clamp has at least its section."""
    length, thick = 200e-3, 2e-3
    mesh = mesh_body(box((length, 10e-3, thick)), uniform=(100, 1, 1))
    angle = 2 * np.pi * turns * mesh.nodes[:, 0] / length
    r = length / (2 * np.pi * turns) + mesh.nodes[:, 2]
    centre = -length / (2 * np.pi * turns)
    curled = np.stack([r * np.sin(angle), mesh.nodes[:, 1], centre + r * np.cos(angle)], axis=-1)
    look = Unmodelled(mesh, cavity_held=False)
    assert look.why(moved_to(mesh, curled)) == in_the_way


def test_walls_that_cross_are_seen_and_the_ends_of_a_channel_are_no_walls() -> None:
    mesh = mesh_body(build_body(preset("oblique-90").design.changed(chamber_count=3, length=38)))
    x, y, z = mesh.nodes.T
    turned = x / 10e-3  # by more than half a turn from end to end
    bent = np.stack([(10e-3 + z) * np.sin(turned), y, (10e-3 + z) * np.cos(turned)], axis=-1)
    assert CavityWalls(mesh).openness(bent - mesh.nodes) > 0.5
    inside_out = mesh.nodes * [1.0, 1.0, -1.0]
    assert Unmodelled(mesh, cavity_held=False).why(moved_to(mesh, inside_out)) == CROSSED
    assert Unmodelled(mesh, cavity_held=True).why(moved_to(mesh, inside_out)) == EMPTIED


@pytest.mark.parametrize("held", [True, False])
def test_side_walls_of_a_half_model_that_cross_the_middle_plane_are_seen(held: bool) -> None:
    mesh = mesh_body(build_body(preset("slab-rectangle-low").design).half())
    look = Unmodelled(mesh, cavity_held=held)
    for share, found in ((0.5, None), (-0.5, HALVED)):
        assert look.why(moved_to(mesh, mesh.nodes * [1.0, share, 1.0])) == found
