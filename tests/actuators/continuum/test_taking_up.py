"""Where a path is cut to go on with contact switched on."""

from dataclasses import replace

import numpy as np
import pytest

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.state import State
from actuators.mechanics.continuum.tracer import Path
from actuators.mechanics.continuum.watched import joined, until

NOWHERE = State(np.zeros((0, 3)), np.zeros((0, 4)))


def states(*volumes: float) -> list[Equilibrium]:
    return [Equilibrium(NOWHERE, -1e3 * k, v, 1, 0) for k, v in enumerate(volumes)]


def test_what_was_found_before_the_volume_turned_back_is_kept() -> None:
    found = states(10.0, 8.0, 7.0, 6.8, 6.9, 7.2, 7.1)
    path = Path(found, limit=found[2], by_volume=True, by_arc=3)
    kept = until(path, found[-1], found[-3:-1])
    assert kept.points == found[:-1]
    assert kept.limit is found[2]
    assert kept.by_arc == 2, "one of the last three is gone"
    rest = Path(states(7.1, 6.0), by_volume=True)
    whole = joined(kept, rest)
    assert whole.points == [*found[:-1], *rest.points]
    assert whole.by_arc == 4, "all from the first of them on"
    assert whole.limit is found[2]


def test_a_maximum_found_with_the_touching_state_is_looked_for_again() -> None:
    found = states(10.0, 8.0, 7.5, 7.0)
    path = Path(found, limit=found[2], by_volume=True)
    kept = until(path, found[3], found[:2])
    assert kept.points == found[:2]
    assert kept.limit is None


def test_of_a_path_told_at_some_volumes_only_all_is_before_the_touching_state() -> None:
    found = states(10.0, 8.0, 6.0)
    between = states(5.6, 5.5, 5.4)
    top = replace(between[0])
    path = Path(found, limit=top, by_volume=True, leaps=[(found[1], found[2])])
    kept = until(path, between[2], between[:2])
    assert kept.points == found
    assert kept.limit is top
    assert kept.leaps == path.leaps
    assert joined(kept, Path(between)).leaps == path.leaps


@pytest.mark.parametrize("count", [1, 2])
def test_a_path_that_touches_at_once_keeps_its_start(count: int) -> None:
    found = states(*np.linspace(10.0, 9.0, count + 1))
    kept = until(Path(found), found[-1], found[:count])
    assert kept.points == found[:count]
