"""Chambers over pressure, read off the paths of their cells."""

import numpy as np
import pytest

from actuators.mechanics.cell.inflated import CellPath
from actuators.mechanics.cell_rod.chambers import inflated, reached


def path(pressure: list[float], volume: list[float]) -> CellPath:
    """A cell that only bends, by as much as its cavity has grown."""
    count = len(pressure)
    strain = np.zeros((count, 4))
    strain[:, 2] = np.array(volume) - volume[0]
    return CellPath(
        period=1.0,
        pressure=np.array(pressure), strain=strain,
        strain_rate=np.tile([0.0, 0.0, 1.0, 0.0], (count, 1)),
        stiffness=np.tile(np.eye(4), (count, 1, 1)),
        volume=np.array(volume), volume_rate=np.zeros((count, 4)), compliance=np.ones(count),
        max_stretch=np.ones(count), region_stretch=np.ones((count, 1)),
    )  # fmt: skip


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_cell_is_read_up_to_where_its_volume_jumps_to_and_fro(sign: float) -> None:
    """Where walls press and steps have become tiny, found points may alternate between two."""
    jumpy = path([sign * p for p in (0.0, 1.0, 2.0, 2.1, 2.2)],
                 [5 + sign * v for v in (0.0, 1.0, 2.0, 1.9, 2.1)])  # fmt: skip
    assert reached([jumpy], sign * 9.0) == sign * 2.0
    chambers = inflated([jumpy], np.ones((1, 1)), sign * np.array([0.0, 0.5, 1.5, 2.0]))
    assert chambers.free[:, 0, 2] == pytest.approx(sign * np.array([0.0, 0.5, 1.5, 2.0]), abs=2e-3)
    assert chambers.growth[:, 0] == pytest.approx(chambers.free[:, 0, 2], abs=1e-12)
