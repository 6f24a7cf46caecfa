"""The ladder of one design in one scene, from what has been answered and what jobs have taken."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.mechanics import predict as instant
from actuators.mechanics.cell.row import chamber_row, row_cells
from actuators.mechanics.ladder.answer import Answer
from actuators.mechanics.ladder.choice import Choice
from actuators.mechanics.ladder.cost import CostModel, TimeEstimate
from actuators.mechanics.ladder.points import (
    Point,
    Span,
    best_answer,
    measured_point,
    predicted_point,
)
from actuators.mechanics.ladder.question import cell_strain, outlook
from actuators.mechanics.ladder.rungs import Rung, ladder_rungs
from actuators.mechanics.ladder.typical import typical_at
from actuators.mechanics.scene import Scene

INSTANT_SECONDS: Mapping[str, TimeEstimate] = {
    "closed-form": TimeEstimate(0.001, 0.0003, 0.01, 0),
    "energy": TimeEstimate(0.02, 0.002, 0.06, 0),
}
"""Seconds of instant rungs that have not run (docs/performance.md); they are mostly run at once."""
NEW_CELL_S = {"slab": 0.4, "oblique": 2.2, "printed": 1.3, "bellows": 0.9}
"""Of cell-rod whose chambers are new, with what its body takes (docs/cell_rod.md)."""
FURTHER_CELL_S = 0.25
"""Of every further chamber where the planform tapers."""
KEPT_CELL_S = 0.02
"""Of cell-rod where its chambers are known."""
SLOWER = 3.0
"""Times as long as usual, where four of five answers are there."""


@dataclass(frozen=True, eq=False)
class Ladder:
    """Every rung's point, cheapest rung first; further answers (on a mesh that was asked for) last.
    ``strain``: the largest one that the linear cell expects; ``learned_from``: jobs of this machine
    that the predicted seconds rest on, beside the package's record."""

    design: Design
    scene: Scene
    points: tuple[Point, ...]
    strain: float
    learned_from: int

    @property
    def best(self) -> Point | None:
        """The best answer so far."""
        return next((p for p in self.points if p.is_best), None)

    def to_document(self, choices: Sequence[Choice] = ()) -> dict[str, Any]:
        """Border form, with the ``choices`` made on it."""
        return {
            "design": self.design.to_document(),
            "scene": self.scene.to_document(),
            "points": [p.to_document() for p in self.points],
            "best": None if self.best is None else self.best.rung.label,
            "expected_strain_percent": 100 * self.strain,
            "learned_from_jobs": self.learned_from,
            "choices": [
                {"rung": None if c.point is None else c.point.rung.label, "why": c.why}
                for c in choices
            ],
        }


def ask_instant(design: Design, scene: Scene, rung: Rung) -> Answer | str:
    """Answer of an instant rung, or its own words on why it cannot carry the scene."""
    try:
        return Answer.of(instant.predict(design, scene, rung=rung.name), rung)
    except QuestionError as refusal:
        return str(refusal)


def build_ladder(
    design: Design,
    scene: Scene,
    answers: Sequence[Answer],
    refusals: Mapping[Rung, str],
    costs: CostModel,
    spent: Mapping[Rung, float] | None = None,
) -> Ladder:
    """Points of all rungs: measured where there is an answer, refused where the rung said so, else
    predicted. ``answers``: at most one per rung; those of rungs not on the ladder are added.
    ``spent``: seconds after which a rung was stopped without an answer: it takes longer."""
    strain, suction = cell_strain(chamber_row(design), scene)
    rungs = ladder_rungs()
    everyone = [*rungs, *(a.rung for a in answers if a.rung not in rungs)]
    typical = {
        rung: found
        for rung in everyone
        if (
            found := typical_at(
                rung.name, design, strain, suction=suction, obstacle=scene.has_obstacle
            )
        )
        is not None
    }
    best = best_answer(answers, typical)
    there = {answer.rung: answer for answer in answers}
    points: list[Point] = []
    for rung in everyone:
        if rung in there:
            points.append(measured_point(there[rung], best, typical))
        elif rung in refusals:
            points.append(Point(rung, "refused", reason=refusals[rung]))
        else:
            time = expected_time(design, scene, rung, costs)
            time = time.longer_than(_least(rung, answers, spent or {}))
            point = predicted_point(rung, time, typical.get(rung))
            point = replace(
                point, reason=_stopped(rung, spent or {}), stopped_after=(spent or {}).get(rung)
            )
            points.append(_answered_already(point, answers))
    return Ladder(design, scene, tuple(points), strain, costs.learned_from)


def expected_time(design: Design, scene: Scene, rung: Rung, costs: CostModel) -> TimeEstimate:
    """Seconds that a rung is expected to take."""
    if rung.name == "cell-rod":
        usual = NEW_CELL_S[design.family] + FURTHER_CELL_S * (len(row_cells(design)[0]) - 1)
        return TimeEstimate(usual, KEPT_CELL_S, SLOWER * usual, 0)
    if rung.is_instant:
        return INSTANT_SECONDS[rung.name]
    return costs.predict(outlook(design, scene, accuracy=rung.accuracy, mesh=rung.mesh))


def _least(rung: Rung, answers: Sequence[Answer], spent: Mapping[Rung, float]) -> float:
    """Seconds that a rung needs at least: what less accuracy has taken, or was stopped at."""
    if rung.accuracy is None:
        return spent.get(rung, 0.0)
    took = {a.rung: a.seconds for a in answers} | dict(spent)
    coarser = [t for r, t in took.items() if r.accuracy is not None and r.accuracy >= rung.accuracy]
    return max(coarser, default=0.0)


def _stopped(rung: Rung, spent: Mapping[Rung, float]) -> str | None:
    if rung not in spent:
        return None
    return f"was stopped after {spent[rung]:.2g} s without an answer. Allow more time."


def _answered_already(point: Point, answers: Sequence[Answer]) -> Point:
    """A job that was asked for less and ended within this accuracy would be repeated."""
    accuracy = point.rung.accuracy
    if accuracy is None:
        return point
    alike = [a for a in answers if a.rung.accuracy is not None and a.satisfies(accuracy)]
    if not alike:
        return point
    same = min(alike, key=lambda a: a.seconds)
    seconds = Span(same.seconds, same.seconds, same.seconds)
    own = same.own_error if same.own_error is not None else accuracy
    return replace(
        point, same_as=same.rung, seconds=seconds, error=Span(own, 0.0, own),
        error_kind="own estimate",
    )  # fmt: skip
