"""Memory is looked at before a mesh is built that would not fit."""

import pytest

from actuators.design import preset
from actuators.errors import QuestionError
from actuators.mechanics.continuum.memory import memory_free, memory_in_use, memory_needed
from actuators.mechanics.continuum.progress import Budget, Monitor
from actuators.mechanics.continuum.solve import solve_with_states
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene

SHORT = preset("slab-rectangle-low").design.changed(chamber_count=1, length=25, width=30)
SCENE = Scene(pressure_to=1e3, gravity=None)


def test_what_is_known_of_this_machine_is_plausible() -> None:
    assert 1e7 < memory_in_use() < 1e12
    assert memory_free() > 1e7
    assert memory_needed(322_000) == pytest.approx(4.6e9, rel=0.1)


@pytest.mark.parametrize("effects", [{}, {"finite_strain": "off"}])
def test_a_finer_mesh_that_does_not_fit_is_not_built(
    monkeypatch: pytest.MonkeyPatch, effects: dict[str, str]
) -> None:
    room = iter([1e9, 1e3, 1e3])
    monkeypatch.setattr(Monitor, "room", lambda self: next(room))
    scene = Scene.from_document({"pressure_kPa": {"to": 1}, "gravity_m_s2": None,
                                 "effects": effects})  # fmt: skip
    found = solve_with_states(SHORT, scene, Monitor(), accuracy=1e-3).response
    assert found.outcome is Outcome.CONVERGED
    assert found.path[-1].pressure == pytest.approx(1e3)
    assert "coarsest mesh" in " ".join(found.notes)


def test_a_body_that_does_not_fit_at_all_is_refused_before_anything_is_built() -> None:
    budget = Budget(memory=memory_in_use() + 1e6)
    with pytest.raises(QuestionError, match="MiB") as refused:
        solve_with_states(SHORT, SCENE, Monitor(budget=budget), mesh="coarse")
    assert refused.value.field == "memory"
    assert refused.value.mend
