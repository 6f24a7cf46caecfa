"""Two versions side by side."""

from actuators.errors import InputError
from backend.designs.question import read_design, read_scene
from backend.history import versions
from backend.history.changes import pairs
from backend.history.schemas import ComparedSide, Comparison
from backend.simulations.instant import answer_in_part
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
    left_out: list[str] = []
    try:
        response, loads = answer_in_part(read_design(version.design), read_scene(version.scene))
        left_out = [each.field for each in loads]
        instant = ResultDocument.model_validate(response.to_document())
    except InputError as error:
        reason = str(error)
    return ComparedSide(
        version=version,
        design=version.design,
        instant_result=instant,
        instant_error=reason,
        instant_left_out=left_out,
        fe_result=None if best is None else ResultDocument.model_validate(best.document),
    )
