"""The ladder over HTTP: instant rungs answered now, finite elements from the store or predicted."""

from collections.abc import Collection
from dataclasses import dataclass, field

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.mechanics.ladder import (
    Answer,
    Rung,
    ask_instant,
    at_most_error,
    at_most_seconds,
    build_ladder,
    expected_time,
    ladder_rungs,
)
from actuators.mechanics.scene import Scene
from backend.designs.question import read_design, read_scene
from backend.simulations.aside import Kept
from backend.simulations.ladder_schemas import LadderAnswer, LadderRequest, Range
from backend.simulations.past_jobs import cost_model
from storage import JobRow, ResultRow, Store
from storage.question import BROKEN_OFF, OPEN_OUTCOMES, science_version

BESIDE = Rung("cell-rod")
"""The rung that a helper process answers."""


@dataclass(eq=False)
class _Known:
    """What is there about one question, by rung. ``jobs``: under way. ``parts``: what runs had
    found that were cancelled or ran out of time; ``cancelled``: that had not found a point yet."""

    answers: list[Answer] = field(default_factory=list)
    refusals: dict[Rung, str] = field(default_factory=dict)
    spent: dict[Rung, float] = field(default_factory=dict)
    jobs: dict[Rung, str] = field(default_factory=dict)
    parts: dict[Rung, Answer] = field(default_factory=dict)
    cancelled: set[Rung] = field(default_factory=set)


def ladder(store: Store, body: LadderRequest, aside: Kept | None) -> LadderAnswer:
    """Points of every rung, and the rungs chosen for the limits of the request. ``aside``: what the
    helper process found by the rung ``cell-rod``, if it was asked."""
    design, scene = read_design(body.design), read_scene(body.scene)
    known = _Known()
    _ask_instant(design, scene, body.run, known)
    _take(aside, known)
    _read_results(store, design, scene, known)
    _read_jobs(store, design, scene, known)
    built = build_ladder(
        design, scene, known.answers, known.refusals, cost_model(store), known.spent
    )
    choices = [at_most_error(built.points, p / 100) for p in body.at_most_percent]
    choices += [at_most_seconds(built.points, s) for s in body.at_most_s]
    document = built.to_document(choices)
    for point, entry in zip(built.points, document["points"], strict=True):
        entry["job_id"] = known.jobs.get(point.rung)
        part = known.parts.get(point.rung)
        if part is not None and point.state == "predicted":
            entry["outcome"] = part.outcome.value
            if len(part.pressure):
                entry["ends_at_kPa"] = 1e-3 * float(part.pressure[-1])
        elif point.rung in known.cancelled and point.state == "predicted":
            entry["outcome"] = "cancelled"
    return LadderAnswer.model_validate(document)


def expected_seconds(store: Store, job_id: str) -> Range | None:
    """Seconds that a job is expected to take, as the ladder of its question has them; None once it
    has ended. Raises NotFoundError."""
    job = store.get_job(job_id)
    if not job.active:
        return None
    design = read_design(store.get_version(job.version_id).document)
    scene = read_scene(job.scene)
    known, costs, rung = _Known(), cost_model(store), _rung(job)
    _read_results(store, design, scene, known)
    _read_jobs(store, design, scene, known)
    built = build_ladder(design, scene, known.answers, known.refusals, costs, known.spent)
    told = [p.seconds for p in built.points if p.rung == rung and p.state == "predicted"
            and p.same_as is None and p.seconds is not None]  # fmt: skip
    if told:
        return Range.model_validate(told[0].to_document())
    # one mesh is not on the ladder, and what an older version answered is asked anew
    time = expected_time(design, scene, rung, costs)
    return Range(value=time.seconds, low=time.low, high=time.high)


def _ask_instant(design: Design, scene: Scene, wanted: Collection[str], known: _Known) -> None:
    for rung in ladder_rungs():
        if not rung.is_instant or rung == BESIDE or rung.name not in wanted:
            continue
        found = ask_instant(design, scene, rung)
        if isinstance(found, str):
            known.refusals[rung] = found
        else:
            known.answers.append(found)


def _take(aside: Kept | None, known: _Known) -> None:
    if aside is None:
        return
    if aside.prediction is not None:
        known.answers.append(Answer.of_document(aside.prediction.result.model_dump(), BESIDE))
    elif isinstance(aside.refusal, QuestionError):
        known.refusals[BESIDE] = str(aside.refusal)
    else:
        aside.given()


def _read_results(store: Store, design: Design, scene: Scene, known: _Known) -> None:
    """Stored answers of rungs not asked just now; of each the one of this version, else the
    newest. One cut short leaves its rung predicted; a mesh that was asked for stands by itself.
    Of a job that broke off, its own words say more than the part it had found."""
    rows = store.results_of(design.to_document(), scene.to_document())
    rows = [row for row in rows if row.outcome not in BROKEN_OFF]
    rows.sort(key=lambda row: row.science_version != science_version())  # stable: newest first
    seen = {answer.rung for answer in known.answers} | set(known.refusals)
    for row in rows:
        rung = _rung(row)
        if rung in seen:
            continue
        seen.add(rung)
        is_older = row.science_version != science_version()
        answer = Answer.of_document(row.document, rung, is_older=is_older)
        if row.outcome in OPEN_OUTCOMES and rung.mesh is None:
            known.spent[rung] = answer.seconds
            known.parts[rung] = answer
        else:
            known.answers.append(answer)


def _read_jobs(store: Store, design: Design, scene: Scene, known: _Known) -> None:
    """Jobs under way, the words of those that failed with this version, and the time spent on those
    that were cancelled before they found anything. The newest of a rung counts."""
    rows = store.list_jobs(content=(design.digest, scene.digest), limit=100)
    answered = {answer.rung for answer in known.answers} | set(known.parts)
    for row in rows:
        rung = _rung(row)
        if row.active:
            known.jobs.setdefault(rung, row.id)
        elif row.science_version != science_version() or rung in answered:
            continue
        elif row.state == "failed" and row.error and rung not in known.cancelled:
            known.refusals.setdefault(rung, _in_words(row.error, row.advice))
        elif row.state == "cancelled" and row.started_at and rung not in known.refusals:
            known.cancelled.add(rung)
            known.spent[rung] = max(known.spent.get(rung, 0.0), row.elapsed_s() or 0.0)


def _in_words(error: str, advice: str | None) -> str:
    """Messages of refusals hold their mend already."""
    return error if not advice or advice.rstrip(".") in error else f"{error} {advice}"


def _rung(row: ResultRow | JobRow) -> Rung:
    if row.rung != "fe":
        return Rung(row.rung)
    return Rung("fe", mesh=row.mesh) if row.mesh is not None else Rung("fe", row.accuracy)
