"""The instant model against 3D finite elements of the whole actuator."""

import numpy as np
import pytest

from actuators.design import Design, preset
from actuators.mechanics.cell.row import chamber_row
from actuators.mechanics.continuum.solve import solve
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene

SMALL = Scene(200.0, steps=1, gravity=None)  # 0.2 kPa: strains below 0.002


def interior_curvature(answer: Response, design: Design) -> float:
    """Curvature about X2 over the three pitches in the middle, far from clamp and free end [1/m],
    between sections one whole number of chambers apart, where periodic warping cancels."""
    line, row = answer.centreline, chamber_row(design)
    assert line is not None
    first = row.start[len(row.start) // 2 - 1]
    i, j = (np.abs(line.stations - x).argmin() for x in (first, first + 3 * row.pitch))
    turn = line.frames[-1, i].T @ line.frames[-1, j]
    return float((turn[0, 2] - turn[2, 0]) / 2 / (line.stations[j] - line.stations[i]))


def test_eleven_slab_chambers_bend_inside_as_the_cell() -> None:
    design = preset("slab-rectangle-high").design
    found = interior_curvature(solve(design, SMALL, accuracy=0.2), design)
    # 3 %, as the issue asks; 0.7 % measured
    assert interior_curvature(predict(design, SMALL), design) == pytest.approx(found, rel=0.03)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "tolerance"), [("oblique-90", 0.03), ("oblique-60", 0.05),
                                                 ("printed-14", 0.03),
                                                 ("bellows-11-2.0", 0.03)])  # fmt: skip
def test_gapped_chambers_bend_inside_as_the_cell(name: str, tolerance: float) -> None:
    """At 60 degrees the 3D mesh, without a plane of symmetry, stops coarser: it bends 4 % more than
    its own refinement does."""
    design = preset(name).design
    found = interior_curvature(solve(design, SMALL, accuracy=0.2), design)
    instant = interior_curvature(predict(design, SMALL), design)
    assert instant == pytest.approx(found, rel=tolerance)


def test_two_bellows_bend_in_3d() -> None:
    """Curved elements under pressure in the nonlinear solver: towards the bottom, and its cavity
    grows about as much as the cells' do (26 % less measured: in a row of two both are ends)."""
    design = preset("bellows-11-2.0").design.changed(chamber_count=2, length=27.5)
    found = solve(design, Scene(2e3, steps=1, gravity=None), accuracy=1.0)
    assert found.outcome is Outcome.CONVERGED
    grown, expected = (
        (answer.path[-1].cavity_volume or 0.0) - (answer.path[0].cavity_volume or 0.0)
        for answer in (found, predict(design, Scene(2e3, gravity=None)))
    )
    assert found.path[-1].tip_displacement[2] < 0
    assert grown == pytest.approx(expected, rel=0.35)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "tolerance"), [("oblique-90", 0.05), ("slab-triangle-low", 0.05),
                                                 ("printed-14", 0.05), ("bellows-11-2.0", 0.03),
                                                 ("slab-rectangle-low", 0.15)])  # fmt: skip
def test_tip_moves_as_in_3d_at_small_pressure(name: str, tolerance: float) -> None:
    """End effects included: about a tenth on slabs half as wide as long. On the long narrow bar the
    3D answer's own error (3.5 %) is the larger part."""
    design = preset(name).design
    solid = solve(design, SMALL, accuracy=0.035).path[-1].tip_displacement[2]
    instant = predict(design, SMALL).path[-1].tip_displacement[2]
    assert instant == pytest.approx(solid, rel=tolerance)


@pytest.mark.slow
def test_droop_of_the_slab_is_within_a_sixth_of_3d() -> None:
    """20.2 against 23.3 degrees: a wide short slab shears and turns at its clamp, a rod does
    not, and rubber softens in compression."""
    design = preset("slab-rectangle-low").design
    scene = Scene(200.0, steps=1)
    solid = solve(design, scene, accuracy=0.1).path[0].bending_angle
    assert predict(design, scene).path[0].bending_angle == pytest.approx(solid, rel=1 / 6)
