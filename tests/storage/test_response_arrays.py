"""Arrays of a response survive their packing."""

import numpy as np
import pytest

from actuators.design import preset
from actuators.mechanics.response import Centreline, Outcome, PathPoint, Response, SurfaceFields
from actuators.mechanics.scene import Scene
from storage.response_arrays import pack, unpack


def response(*, surface: bool, contact: bool = False) -> Response:
    rng = np.random.default_rng(7)
    k, s, n, m = 3, 11, 200, 396
    centreline = Centreline(
        np.linspace(0, 0.1, s), rng.normal(size=(k, s, 3)), rng.normal(size=(k, s, 3, 3))
    )
    fields = SurfaceFields(
        vertices=rng.uniform(0, 0.1, (n, 3)).astype(np.float32),
        triangles=rng.integers(0, n, (m, 3)),
        displacement=rng.normal(size=(k, n, 3)).astype(np.float32),
        stretch=rng.uniform(1, 2, (k, n)).astype(np.float32),
        stress=rng.uniform(0, 1e5, (k, n)).astype(np.float32),
        contact_pressure=rng.uniform(0, 1e4, (k, n)).astype(np.float32) if contact else None,
    )
    zero = (0.0, 0.0, 0.0)
    path = tuple(PathPoint(p, zero, zero, None, 0.0, None, None) for p in (0.0, 1e4, 2e4))
    return Response(
        preset("slab-rectangle-low").design, Scene(2e4), "fe", Outcome.CONVERGED, path,
        centreline=centreline, surface=fields if surface else None,
    )  # fmt: skip


def test_arrays_come_back_at_single_precision() -> None:
    given = response(surface=True)
    back = unpack(pack(given))
    assert back.pressures.tolist() == [0.0, 1e4, 2e4]
    assert back.centreline is not None
    assert back.surface is not None
    assert given.centreline is not None
    assert given.surface is not None
    # one part in 2^24 is the rounding of float32
    np.testing.assert_allclose(back.centreline.frames, given.centreline.frames, rtol=2**-24)
    np.testing.assert_array_equal(back.surface.displacement, given.surface.displacement)
    np.testing.assert_array_equal(back.surface.triangles, given.surface.triangles)
    assert back.surface.triangles.dtype == np.int32


def test_a_rung_without_a_surface_packs_its_centreline() -> None:
    back = unpack(pack(response(surface=False)))
    assert back.surface is None
    assert back.centreline is not None


def test_equal_arrays_make_equal_bytes() -> None:
    assert pack(response(surface=True)) == pack(response(surface=True))


def test_pickled_arrays_are_refused() -> None:
    import io

    target = io.BytesIO()
    np.savez(target, pressures=np.array([{"not": "an array"}], dtype=object))
    with pytest.raises(ValueError, match="allow_pickle"):
        unpack(target.getvalue())


def test_contact_pressures_are_kept_where_there_are_any() -> None:
    given = response(surface=True, contact=True).surface
    assert given is not None
    back = unpack(pack(response(surface=True, contact=True))).surface
    assert back is not None
    assert back.contact_pressure is not None
    np.testing.assert_array_equal(back.contact_pressure, given.contact_pressure)
    without = unpack(pack(response(surface=True))).surface
    assert without is not None
    assert without.contact_pressure is None
