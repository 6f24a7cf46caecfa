"""Cook's membrane: thin-element trouble in shear, nearly incompressible and linear."""

import numpy as np
import pytest

from benchmarks.verification.cook import (
    LINEAR_REFERENCE,
    NEO_HOOKE_REFERENCE,
    linear_corner,
    neo_hooke_corner,
)

PUBLISHED_LINEAR = (32.20, 32.27, 32.28)
"""code_aster, CalculiX, Elmer (reference/fe_benchmarks.csv)."""
PUBLISHED_NEO_HOOKE = 6.891
"""OpenGeoSys, 30 elements a side, from below."""


def test_nearly_incompressible_panel_approaches_another_codes_answer_from_below() -> None:
    found = np.array([neo_hooke_corner(n) for n in (4, 8, 16)])
    errors = 1 - found / NEO_HOOKE_REFERENCE
    assert (np.diff(errors) < 0).all()
    assert 0 < errors[-1] < 1e-3
    assert PUBLISHED_NEO_HOOKE < found[-1] < 1.01 * PUBLISHED_NEO_HOOKE


def test_linear_panel_agrees_with_four_codes() -> None:
    found = linear_corner(16)
    assert found == pytest.approx(LINEAR_REFERENCE, rel=1e-3)
    for other in PUBLISHED_LINEAR:
        assert found == pytest.approx(other, rel=4e-3)
