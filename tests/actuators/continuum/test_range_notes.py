"""Notes on numbers that a reader must not take as they are."""

from dataclasses import replace

import numpy as np
import pytest

from actuators.materials import material
from actuators.mechanics.continuum.findings import contact_notes, range_notes
from actuators.mechanics.crossing import first_below
from actuators.mechanics.response import PathPoint


def test_leaving_the_stable_range_is_said_once() -> None:
    rubber = material("ninjaflex-mooney-rivlin-5")
    assert range_notes([rubber, rubber], [1.3, 1.4]) == []
    notes = range_notes([rubber, rubber], [1.6, 1.6])
    assert len(notes) == 1
    assert "stretched to 1.60" in notes[0]
    assert "equibiaxial tension up to 1.48" in notes[0]


def test_leaving_the_tested_range_comes_before_the_stable_one() -> None:
    notes = range_notes([material("ecoflex-00-30")], [6.5])
    assert ["tested range" in note for note in notes] == [True, False]
    assert range_notes([material("ecoflex-00-30")], [3.9]) == []


def test_a_law_that_is_stable_everywhere_says_nothing() -> None:
    assert range_notes([material("ecoflex-00-30-neo-hooke")], [9.0]) == []


def test_a_contact_pressure_carries_its_caveat() -> None:
    free = PathPoint(1e3, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0)
    assert contact_notes([free, replace(free, max_contact_pressure=0.0)]) == []
    (note,) = contact_notes([free, replace(free, max_contact_pressure=5e3)])
    assert note.startswith("The contact pressure has no error estimate")


def test_walls_meet_where_they_do_whatever_the_points_of_the_path() -> None:
    for count in (3, 5, 21):
        pressures = np.linspace(0.0, -4e3, count)
        assert first_below(pressures, 1.0 + pressures / 2.5e3) == pytest.approx(-2.5e3)
    assert first_below(np.array([0.0, -1e3]), np.array([1.0, 0.5])) is None
    assert first_below(np.array([0.0, -1e3]), np.array([-0.1, -0.5])) == 0.0
