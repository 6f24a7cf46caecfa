"""Which rung to take: the cheapest that is accurate enough, or the most accurate that is quick
enough. An answer that is there already costs nothing more."""

from collections.abc import Sequence
from dataclasses import dataclass

from actuators.mechanics.ladder.points import Point, Span
from actuators.quantities import percent

MISPREDICTED = 1.5
"""Seconds that differ from the expected ones by more than this factor are told."""


@dataclass(frozen=True)
class Choice:
    """The ``point`` chosen, None where none will do, and why in a sentence."""

    point: Point | None
    why: str


@dataclass(frozen=True)
class Limit:
    """What is asked of a rung: an error of at most ``accuracy`` (a fraction), else ``seconds``."""

    accuracy: float | None = None
    seconds: float | None = None

    @property
    def label(self) -> str:
        """As people read it: ``at most 2 %``."""
        if self.accuracy is not None:
            return f"at most {100 * self.accuracy:g} %"
        return f"at most {self.seconds or 0.0:g} s"

    def choose(self, points: Sequence[Point]) -> Choice:
        """The rung that keeps to it."""
        if self.accuracy is not None:
            return at_most_error(points, self.accuracy)
        return at_most_seconds(points, self.seconds or 0.0)


def at_most_error(points: Sequence[Point], accuracy: float) -> Choice:
    """The cheapest rung expected to be within ``accuracy`` (a fraction). A measured error counts
    with its band, a typical one as what four of five designs stay below."""
    good = [p for p in points if _worst(p) is not None and (_worst(p) or 0.0) <= accuracy]
    chosen = min(good, key=lambda p: (*_cost(p), _worst_or_much(p)), default=None)
    asked = Limit(accuracy=accuracy).label
    if chosen is not None:
        return Choice(chosen, f"{asked}: {_sentence(chosen)}")
    best = min((p for p in points if _worst(p) is not None), key=_worst_or_much, default=None)
    if best is None:
        return Choice(None, f"{asked}: no rung can say how accurate it is here.")
    return Choice(
        None, f"{asked}: no rung is expected to reach it; the most accurate is {_sentence(best)}"
    )


def at_most_seconds(points: Sequence[Point], seconds: float) -> Choice:
    """The most accurate rung expected to take at most ``seconds``; where errors are equal, the
    cheaper one. One that was stopped before must be expected to end within them almost surely."""
    quick = [p for p in points if _needed(p, is_sure=True) <= seconds and _worst(p) is not None]
    chosen = min(quick, key=lambda p: (_worst_or_much(p), *_cost(p)), default=None)
    asked = Limit(seconds=seconds).label
    if chosen is not None:
        return Choice(chosen, f"{asked}: {_sentence(chosen)}")
    known = [p for p in points if p.seconds is not None and p.state == "predicted"]
    quickest = min(known, key=_needed, default=None)
    if quickest is None:
        return Choice(None, f"{asked}: no rung can answer this question.")
    return Choice(
        None, f"{asked}: no rung is expected to be so quick; the quickest is {_sentence(quickest)}"
    )


def as_it_went(
    limit: Limit, chosen: Point, points: Sequence[Point], budget: float | None
) -> Choice:
    """A choice that has been acted upon: what became of the point ``chosen`` before, given
    ``points`` as they are now. ``budget`` [s]: what there was in all, None for no end."""
    now = next(p for p in points if p.rung == chosen.rung)
    if chosen.is_answer or chosen.same_as is not None or now.same_as is not None:
        told = f"{limit.label}: {_sentence(now)}"
        verdict = _verdict(Limit(accuracy=limit.accuracy), now)  # its seconds are spent already
        return Choice(now, told + verdict + _by_now(limit, now, points))
    head = f"{limit.label}: {now.rung.label}"
    if now.is_answer:
        ran = f"{head}, which ran for it ({_error(now)}{_told_seconds(chosen, now)})."
        return Choice(now, ran + _verdict(limit, now) + _by_now(limit, now, points))
    if now.stopped_after is not None:
        what = f" was chosen and stopped after {_short(now.stopped_after)} s; it takes longer"
    elif now.state == "measured":
        what = " was chosen and ran, but its path is cut short"
    elif now.state == "refused":
        what = " was chosen, but refuses this question"
    else:
        why = "it does not fit what was left of the budget (--budget)"
        return Choice(now, f"{limit.label}: {_sentence(now)} It has not run: {why}.")
    others = [p for p in points if p.rung != now.rung]
    within = Limit(seconds=budget if limit.seconds is None else limit.seconds)
    left = within.choose(others).point if within.seconds is not None else None
    instead = "" if left is None else f" Within {within.seconds:g} s: {_sentence(left)}"
    return Choice(left, f"{head}{what}.{instead}")


def _told_seconds(before: Point, now: Point) -> str:
    took = _taken(now)
    text = f", took {_short(took)} s"
    if before.seconds is None or took <= 0.0:
        return text
    expected = before.seconds.value
    if max(took / expected, expected / took) > MISPREDICTED:
        text += f" where {_expected(before.seconds)} were expected"
    return text


def _expected(seconds: Span) -> str:
    """Seconds of a run to come: "about 53 s (8 to 340)"."""
    low, high = _short(seconds.low), _short(seconds.high)
    return f"about {_short(seconds.value)} s" + (f" ({low} to {high})" if low != high else "")


def _verdict(limit: Limit, now: Point) -> str:
    if limit.accuracy is not None and _worst_or_much(now) > limit.accuracy:
        return f" That is not within {100 * limit.accuracy:g} %."
    if limit.seconds is not None and now.is_answer and _taken(now) > limit.seconds:
        return f" That is more than {limit.seconds:g} s."
    return ""


def _by_now(limit: Limit, now: Point, points: Sequence[Point]) -> str:
    """Another rung that the limit would be met by, from what has been learned since."""
    other = limit.choose(points).point
    if other is None or other.rung == now.rung:
        return ""
    return f" From what has run by now it would be {_sentence(other)}"


def _needed(point: Point, *, is_sure: bool = False) -> float:
    """Seconds still to be spent for the answer."""
    if point.is_answer:
        return 0.0
    if point.state != "predicted" or point.seconds is None:
        return float("inf")
    if point.same_as is not None:
        return 0.0
    is_doubtful = is_sure and point.stopped_after is not None
    return point.seconds.high if is_doubtful else point.seconds.value


def _cost(point: Point) -> tuple[float, bool, float]:
    """For the cheapest first; an answer goes before the rungs that would only repeat it."""
    return _needed(point), not point.is_answer, _taken(point)


def _taken(point: Point) -> float:
    """Seconds of the rung itself, whether or not they have been spent."""
    return float("inf") if point.seconds is None else point.seconds.value


def _worst(point: Point) -> float | None:
    """The error to be reckoned with; None where it is unknown or there is no whole answer."""
    if point.error is None or not (point.is_answer or point.state == "predicted"):
        return None
    return None if point.is_contradicted else point.error.high


def _worst_or_much(point: Point) -> float:
    worst = _worst(point)
    return float("inf") if worst is None else worst


def _short(seconds: float) -> str:
    return f"{float(f'{seconds:.2g}'):g}"


def _error(point: Point) -> str:
    if point.error is None:
        return "error unknown"
    worst = percent(point.error.high)
    return f"error up to {worst}" if worst[0].isdigit() else f"error {worst}"


def _sentence(point: Point) -> str:
    error = _error(point)
    seconds = "" if point.seconds is None else f"took {_short(point.seconds.value)} s, "
    there = f"is there already and costs nothing more ({seconds}{error})."
    if point.is_answer:
        return f"{point.rung.label}, whose answer {there}"
    if point.same_as is not None:
        return f"{point.rung.label}, for which the answer of {point.same_as.label} {there}"
    expected = "" if point.seconds is None else f", {_expected(point.seconds)}"
    return f"{point.rung.label} ({error}{expected})."
