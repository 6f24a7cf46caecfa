"""Error against seconds: what each rung has cost, or would."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from actuators.mechanics.ladder.answer import Answer, Difference, difference
from actuators.mechanics.ladder.cost import TimeEstimate
from actuators.mechanics.ladder.rungs import Rung
from actuators.mechanics.response import Outcome
from actuators.quantities import kilopascals

State = Literal["measured", "predicted", "refused"]
ErrorKind = Literal["against best", "own estimate", "typical", "asked for"]


@dataclass(frozen=True)
class Span:
    """A value with the range it is expected in."""

    value: float
    low: float
    high: float

    def to_document(self, factor: float = 1.0) -> dict[str, float]:
        """All three, scaled."""
        return {"value": factor * self.value, "low": factor * self.low, "high": factor * self.high}


@dataclass(frozen=True)
class Point:
    """One rung of the ladder for one design in one scene.

    ``seconds``: measured or predicted, None where refused. ``error``: fraction of the tip's
    displacement, of the kind that ``error_kind`` names; None where nothing is known. ``apart``:
    every difference from the best answer. ``reason``: why the rung cannot carry the scene, or what
    else must be read. ``same_as``: the rung whose answer this one would be, because that answer is
    accurate enough already. ``stopped_after``: seconds [s] after which it was stopped without an
    answer. ``is_contradicted``: it and the best answer differ about a limit point before the end of
    the path. ``tip``: displacement [m] at ``pressure`` [Pa], the end of its path.
    """

    rung: Rung
    state: State
    seconds: Span | None = None
    error: Span | None = None
    error_kind: ErrorKind | None = None
    error_source: str | None = None
    apart: Difference | None = None
    is_best: bool = False
    outcome: Outcome | None = None
    advice: str | None = None
    reason: str | None = None
    stopped_after: float | None = None
    is_contradicted: bool = False
    same_as: Rung | None = None
    tip: tuple[float, float, float] | None = None
    pressure: float | None = None
    is_older: bool = False

    @property
    def is_answer(self) -> bool:
        """Whether it holds an answer to the whole question."""
        whole = (Outcome.CONVERGED, Outcome.LIMIT_POINT)
        return self.state == "measured" and self.outcome in whole

    @property
    def may_be_anywhere(self) -> bool:
        """Whether nothing better judges it than an estimate of its own that says so."""
        own = self.error.high if self.error and self.error_kind == "own estimate" else None
        return _is_anywhere(own)

    def to_document(self) -> dict[str, Any]:
        """Border form: percent, mm, kPa."""
        apart = self.apart
        return {
            "rung": self.rung.name,
            "accuracy_percent": _times(self.rung.accuracy, 100),
            "mesh": self.rung.mesh,
            "label": self.rung.label,
            "state": self.state,
            "seconds": None if self.seconds is None else self.seconds.to_document(),
            "error_percent": None if self.error is None else self.error.to_document(100),
            "error_kind": self.error_kind,
            "error_source": self.error_source,
            "apart_percent": None if apart is None else {
                "tip": 100 * apart.tip, "turn": _times(apart.turn, 100),
                "force": _times(apart.force, 100),
                "limit_pressure": _times(apart.limit_pressure, 100),
            },
            "compared_at_kPa": None if apart is None else 1e-3 * apart.pressure,
            "is_best": self.is_best,
            "outcome": None if self.outcome is None else self.outcome.value,
            "advice": self.advice,
            "reason": self.reason,
            "same_as": None if self.same_as is None else self.same_as.label,
            "tip_displacement_mm": None if self.tip is None else [1e3 * x for x in self.tip],
            "ends_at_kPa": _times(self.pressure, 1e-3),
            "leaves_out": list(self.rung.leaves_out),
            "is_older": self.is_older,
        }  # fmt: skip


def _times(value: float | None, factor: float) -> float | None:
    return None if value is None else factor * value


@dataclass(frozen=True)
class Typical:
    """What a rung's error typically is, a fraction: half of all cases lie below ``half``, four of
    five below ``most``. ``source``: who measured it, on what."""

    half: float
    most: float
    source: str


def best_answer(answers: Sequence[Answer], typical: Mapping[Rung, Typical]) -> Answer | None:
    """The complete answer with the smallest estimate of its own; where none has one, that of the
    rung with the smallest typical error. Where answers disagree about a limit point before the end
    of the path, the highest rung decides which of them stand: where no other ends as it does, or
    only one that may be anywhere, it is the best one even without an estimate (finite elements on
    one mesh)."""
    complete = [a for a in answers if a.is_complete]
    estimated = [a for a in complete if a.own_error is not None]
    known = estimated or [a for a in complete if a.rung in typical]

    def error(answer: Answer) -> float:
        return math.inf if (band := _band(answer, typical)) is None else band

    deciding = min(complete, key=lambda a: (-_height(a.rung), error(a)), default=None)
    if deciding is None or not known:
        return None

    alike = [
        a for a in known
        if a.outcome == deciding.outcome
        and (_height(a.rung) == _height(deciding.rung) or not _is_anywhere(a.own_error))
    ]  # fmt: skip
    return min(alike, key=error, default=deciding)


def _is_anywhere(own_error: float | None) -> bool:
    """Whether an estimate says no more than that: it is all of the tip's way."""
    return own_error is not None and own_error >= 1.0


def _band(answer: Answer, typical: Mapping[Rung, Typical]) -> float | None:
    """What an answer is off by, by its own estimate or as is typical of its rung."""
    if answer.own_error is not None:
        return answer.own_error
    usual = typical.get(answer.rung)
    return None if usual is None else usual.most


def measured_point(answer: Answer, best: Answer | None, typical: Mapping[Rung, Typical]) -> Point:
    """A rung that has run. Its error is its distance from the best answer, give or take that
    answer's own error; the best one's is its own estimate, or what is typical of its rung."""
    last = answer.displacement[-1].tolist() if len(answer.pressure) else None
    point = Point(
        rung=answer.rung,
        state="measured",
        seconds=Span(answer.seconds, answer.seconds, answer.seconds),
        outcome=answer.outcome,
        advice=answer.advice,
        tip=None if last is None else (last[0], last[1], last[2]),
        pressure=float(answer.pressure[-1]) if len(answer.pressure) else None,
        is_older=answer.is_older,
    )
    usual = typical.get(answer.rung)
    if best is None or answer is best:
        return replace(_by_itself(point, answer, usual), is_best=best is not None)
    if _height(answer.rung) > _height(best.rung):
        return _by_itself(point, answer, usual)  # nothing can be measured by what is less accurate
    band, apart = _band(best, typical), difference(answer, best)
    contradiction = _contradiction(answer, best)
    if contradiction is not None:
        point = replace(point, is_contradicted=True, reason=contradiction)
    if apart is None or band is None:
        return _by_itself(point, answer, usual)
    if contradiction is not None:
        told = f"{contradiction} Its error is told at the last pressure that both have."
        point = replace(point, reason=told)
    error = Span(apart.tip, max(apart.tip - band, 0.0), apart.tip + band)
    return replace(
        point, error=error, error_kind="against best", error_source=best.rung.label, apart=apart
    )


def _contradiction(answer: Answer, best: Answer) -> str | None:
    """Where two complete answers differ about a limit point before the end of the path."""
    if best.outcome is Outcome.LIMIT_POINT and answer.outcome is Outcome.CONVERGED:
        where = f"{kilopascals(_limit(best))} kPa, where {best.rung.label} finds a limit point"
        return f"goes on beyond {where}: its end is no answer."
    if best.outcome is Outcome.CONVERGED and answer.outcome is Outcome.LIMIT_POINT:
        where = f"{kilopascals(_limit(answer))} kPa, where {best.rung.label} finds none"
        return f"ends at a limit point at {where}: it is no answer beyond."
    return None


def _limit(answer: Answer) -> float:
    """Pressure [Pa] of the limit point where the path ends."""
    known = answer.limit_pressure
    return known if known is not None else float(answer.pressure[-1])


def _height(rung: Rung) -> int:
    """Place on the ladder; finite elements of every accuracy share theirs."""
    return ("closed-form", "energy", "cell-rod", "fe").index(rung.name)


def _by_itself(point: Point, answer: Answer, typical: Typical | None) -> Point:
    if answer.own_error is not None:
        error = Span(answer.own_error, 0.0, answer.own_error)
        return replace(point, error=error, error_kind="own estimate")
    if typical is None:
        return point
    return replace(
        point, error=Span(typical.half, 0.0, typical.most), error_kind="typical",
        error_source=typical.source,
    )  # fmt: skip


def predicted_point(rung: Rung, time: TimeEstimate, typical: Typical | None) -> Point:
    """A rung that has not run. Finite elements end with an estimated error of at most what is asked
    for, the others with what is typical of them."""
    point = Point(rung, "predicted", seconds=Span(time.seconds, time.low, time.high))
    if rung.accuracy is not None:
        return replace(point, error=Span(rung.accuracy, 0.0, rung.accuracy), error_kind="asked for")
    if typical is None:
        return point
    return replace(
        point, error=Span(typical.half, 0.0, typical.most), error_kind="typical",
        error_source=typical.source,
    )  # fmt: skip
