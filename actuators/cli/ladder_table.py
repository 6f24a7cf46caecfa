"""A ladder as text."""

from collections.abc import Mapping, Sequence

import click

from actuators.cli.tables import table
from actuators.mechanics.ladder import Choice, Ladder, Point, Rung
from actuators.mechanics.ladder.points import Span
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene
from actuators.quantities import kilopascals, percent, two_digits

HEADINGS = (
    "rung",
    "seconds",
    "error/%",
    "compared at/kPa",
    "tip moves by/mm",
    "ends at/kPa",
    "how it stands",
)


def print_ladder(
    built: Ladder,
    choices: Sequence[Choice],
    budget: float | None,
    predicted: Mapping[Rung, Span] | None = None,
) -> None:
    """Table, then what must be read beside it. ``predicted``: seconds as they were, before each
    run of this command."""
    before = predicted or {}
    click.echo(table(HEADINGS, [_row(point, before.get(point.rung)) for point in built.points]))
    if built.scene.forced:
        click.echo(f"\nBy hand: {', '.join(_by_hand(built.scene))}.")
    best = built.best
    if best is not None:
        lost = ", which may be anywhere there by its own estimate" if best.may_be_anywhere else ""
        click.echo(
            f"\nBest answer so far: {best.rung.label}{lost}. Errors are fractions of "
            "the tip's whole way from the straight body, its sag under weight included, at the "
            "pressure compared at."
        )
        if best.outcome is Outcome.LIMIT_POINT:
            click.echo(f"It ends at a limit point: {_end(best)} kPa is its answer to how far the "
                       "pressure can go, and nothing is known beyond.")  # fmt: skip
    learned = built.learned_from
    click.echo(
        "~: predicted, from "
        + jobs_in_words(learned)
        + " and the package's record; a range holds four of five."
        + (" Beside the seconds of a run stands what was predicted before it." if before else "")
    )
    if budget is not None:
        click.echo(f"Finite elements were given {budget:g} s in all (--budget, --run).")
    for choice in choices:
        click.echo(f"Chosen for {choice.why}")
    for point in built.points:
        for sentence in (point.reason, point.advice):
            if sentence:
                click.echo(f"  {point.rung.label}: {sentence}")
    for point in {p.rung.name: p for p in built.points}.values():
        if point.state != "refused" and point.rung.leaves_out:
            click.echo(f"  {point.rung.name} leaves out: {', '.join(point.rung.leaves_out)}.")


def _by_hand(scene: Scene) -> list[str]:
    return [f"{name.replace('_', ' ')} {choice}" for name, choice in scene.forced.items()]


def jobs_in_words(learned: int) -> str:
    """In words, how many a prediction rests on."""
    if not learned:
        return "no job of this machine yet"
    return f"{learned} past job{'s' if learned > 1 else ''} of this machine"


def _row(point: Point, before: Span | None) -> list[str]:
    return [point.rung.label, _seconds(point, before), _error(point), _compared(point), _tip(point),
            _end(point), _standing(point)]  # fmt: skip


def _seconds(point: Point, before: Span | None) -> str:
    if point.seconds is None or point.same_as is not None:
        return "-"
    if point.state != "measured":
        return _expected(point.seconds)
    took = f"{point.seconds.value:.2g}"
    return took if before is None else f"{took}, {_expected(before)} predicted"


def _expected(seconds: Span) -> str:
    low, high = two_digits(seconds.low), two_digits(seconds.high)
    return f"~{two_digits(seconds.value)} ({low} to {high})"


def _error(point: Point) -> str:
    if point.error is None:
        return "-"
    value, low, high = map(_digits, (point.error.value, point.error.low, point.error.high))
    if point.error_kind == "against best":
        return f"{value} ({low} to {high})" if low != high else value
    if not high[0].isdigit():
        return high
    if point.error_kind == "typical":
        return f"typically {value}, mostly below {high}"
    return f"at most {high}"


def _digits(share: float) -> str:
    return percent(share).removesuffix(" %")


def _compared(point: Point) -> str:
    if point.apart is not None:
        return kilopascals(point.apart.pressure)
    return "-" if point.error is None else _end(point)


def _tip(point: Point) -> str:
    if point.tip is None:
        return "-"
    return ", ".join(f"{1e3 * x + 0.0:.2f}" for x in point.tip)


def _end(point: Point) -> str:
    return "-" if point.pressure is None else kilopascals(point.pressure)


def _standing(point: Point) -> str:
    if point.same_as is not None:
        return f"as {point.same_as.label}, which is this accurate"
    if point.stopped_after is not None:
        return f"stopped after {two_digits(point.stopped_after)} s"
    if point.state != "measured" or point.outcome is None:
        return point.state
    words = point.outcome.value.replace("_", " ")
    if point.is_best:
        is_limit = point.outcome is Outcome.LIMIT_POINT
        return f"{words}, best" + (" up to there" if is_limit else "")
    return words + (", contradicted" if point.is_contradicted else "")
