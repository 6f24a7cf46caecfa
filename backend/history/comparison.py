"""Two versions side by side."""

from actuators.errors import InputError
from backend.designs.question import read_design, read_scene
from backend.history import versions
from backend.history.changes import pairs
from backend.history.schemas import ComparedSide, Comparison
from backend.simulations.instant import answer
from backend.simulations.schemas import ResultDocument
from storage import Store


def compare(store: Store, left: str, right: str) -> Comparison:
    """Parameters in pairs; the instant answer and the best finite-element answer of each."""
    one, other = store.get_version(left), store.get_version(right)
    return Comparison(
        parameters=pairs(one, other),
        left=_side(store, left),
        right=_side(store, right),
    )


def _side(store: Store, version_id: str) -> ComparedSide:
    version = versions.detail(store, version_id)
    best = store.best_result(version.design, version.scene, "fe")
    instant: ResultDocument | None = None
    reason: str | None = None
    try:
        response = answer(read_design(version.design), read_scene(version.scene))
        instant = ResultDocument.model_validate(response.to_document())
    except InputError as error:
        reason = str(error)
    return ComparedSide(
        version=version,
        design=version.design,
        instant_result=instant,
        instant_error=reason,
        fe_result=None if best is None else ResultDocument.model_validate(best.document),
    )
