"""The path found so far, as an answer: what is kept of a computation that is lost."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from actuators.design import preset
from actuators.mechanics.continuum import part
from actuators.mechanics.continuum.progress import Monitor
from actuators.mechanics.continuum.solve import solve_with_states
from actuators.mechanics.effects import contacts
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Plate, Scene

SLAB = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)
Make = Callable[[], Response]


def parts(scene: Scene, every: int = 1) -> tuple[list[Response], Response]:
    """What is offered on the way, of so many states one; and the whole answer."""
    found: list[Response] = []
    offered = 0

    def take(make: Make) -> None:
        nonlocal offered
        offered += 1
        if offered % every == 0:
            found.append(make())

    solution = solve_with_states(SLAB, scene, Monitor(found=take), mesh="coarse")
    return found, solution.response


def test_a_part_is_what_the_whole_answer_has_there() -> None:
    found, whole = parts(Scene(4e3), every=2)
    last = found[-1]
    assert last.path[0].pressure == 0.0
    at = whole.path.index(last.path[-1])
    assert last.surface is not None
    assert whole.surface is not None
    assert last.centreline is not None
    assert whole.centreline is not None
    assert len(last.surface.displacement) == len(last.centreline.positions) == len(last.path)
    np.testing.assert_array_equal(last.surface.vertices, whole.surface.vertices)
    np.testing.assert_array_equal(last.surface.displacement[-1], whole.surface.displacement[at])
    np.testing.assert_array_equal(last.surface.stress[-1], whole.surface.stress[at])
    for earlier, later in pairwise(found):
        assert len(later.path) == len(earlier.path) + 1
        assert later.path[: len(earlier.path)] == earlier.path
    assert {e.name for e in last.effects} == {e.name for e in whole.effects}


def test_of_many_states_the_first_and_the_latest_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(part, "MOST_POINTS", 4)
    found, whole = parts(Scene(4e3, steps=8))
    assert max(len(each.path) for each in found) == 4
    for each in found[1:]:
        pressures = [point.pressure for point in each.path]
        assert pressures[0] == 0.0
        assert pressures == sorted(set(pressures))
    assert found[-1].path[-1] == whole.path[-1]


def test_where_contact_is_switched_on_the_part_goes_back_with_the_path(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(contacts, "REACHED", np.inf)  # no estimate sees it beforehand
    found, whole = parts(Scene(6e3, steps=2, plate=Plate(1.9e-3)))
    assert any("switched on during the run" in e.reason for e in whole.effects)
    assert whole.path[-1].plate_force
    for each in found[1:]:
        pressures = [point.pressure for point in each.path]
        assert pressures == sorted(set(pressures)), "states of the path without the plate"
    last = found[-1]
    assert last.path[-1] == whole.path[-1]
    assert last.surface is not None
    assert last.surface.contact_pressure is not None
    assert len(last.surface.contact_pressure) == len(last.path)
