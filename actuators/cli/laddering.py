"""The command that compares models: error against seconds, rung by rung."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import click

from actuators.cli.effects import effect_option, with_choices
from actuators.cli.ladder_table import print_ladder
from actuators.cli.past_jobs import STOPPED, cost_model, remember
from actuators.cli.reading import change_option, read_accuracy, read_design, read_scene
from actuators.cli.solving import Interruptible, show_progress
from actuators.cli.studio import answer, json_option
from actuators.design import PRESETS, Design
from actuators.errors import InputError, QuestionError
from actuators.mechanics.ladder import (
    Answer,
    Choice,
    Ladder,
    Limit,
    Point,
    Rung,
    as_it_went,
    ask_instant,
    build_ladder,
    ladder_rungs,
    read_rung,
)
from actuators.mechanics.ladder.points import Span
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene
from actuators.quantities import parse_quantity

BUDGET = "30s"


@click.command()
@click.argument("design")
@click.option("--pressure", metavar="QUANTITY", help="End of the pressure path, such as 30kPa.")
@click.option("--scene", "scene_file", metavar="FILE", help="Scene as a JSON file.")
@change_option
@click.option("--steps", type=int, help="Number of equal pressure steps.")
@click.option("--at-most", "limits", multiple=True, metavar="PERCENT|TIME", help="Choose a rung: "
              "the cheapest within 2%, the most accurate within 10s.")  # fmt: skip
@click.option("--run", "wanted", metavar="RUNG,...", help="Run these instead of what fits the "
              "budget: fe:5%,fe:2%, or none.")  # fmt: skip
@click.option("--budget", metavar="TIME", help=f"Seconds that finite elements may take in all "
              f"(default {BUDGET}; none with --run).")  # fmt: skip
@effect_option
@json_option
def ladder(
    design: str,
    pressure: str | None,
    scene_file: str | None,
    changes: tuple[str, ...],
    steps: int | None,
    limits: tuple[str, ...],
    wanted: str | None,
    budget: str | None,
    choices: tuple[str, ...],
    *,
    as_json: bool,
) -> None:
    """Show for DESIGN what each model costs in seconds and how far off it is.

    Instant models always run. Finite elements run while the predicted time fits the budget (with
    --at-most only the rung chosen), or as --run says.
    """
    chosen = read_design(design, changes)
    scene = with_choices(read_scene(pressure, scene_file, steps), choices)
    asked = [_read_limit(text) for text in limits]
    runs = None if wanted is None else _read_runs(wanted)
    seconds = None if budget is None and runs is not None else _read_budget(budget or BUDGET)
    session = Session(chosen, scene, seconds)
    session.ask_instant()
    with Interruptible() as interrupted:
        if runs is not None:
            for rung in runs:
                session.solve(rung, interrupted)
        elif asked:
            session.solve_choices(asked, interrupted)
        else:
            session.solve_what_fits(interrupted)
    built = session.ladder()
    taken = [session.choice(limit, built) for limit in asked]
    if session.spent and seconds is not None and not asked:
        taken.append(Limit(seconds=seconds).choose(built.points))
    if as_json:
        answer({**built.to_document(taken), "budget_s": seconds})
    else:
        print_ladder(built, taken, seconds, session.predicted)


@dataclass(eq=False)
class Session:
    """What has been asked so far. ``budget`` [s] for finite elements in all, None for no end."""

    design: Design
    scene: Scene
    budget: float | None
    answers: list[Answer] = field(default_factory=list)
    refusals: dict[Rung, str] = field(default_factory=dict)
    spent: dict[Rung, float] = field(default_factory=dict)
    chosen: dict[Limit, Point] = field(default_factory=dict)
    predicted: dict[Rung, Span] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._costs = cost_model()
        self._end: float | None = None
        self._is_loaded = False

    def ladder(self) -> Ladder:
        """The ladder as it is now."""
        return build_ladder(
            self.design, self.scene, self.answers, self.refusals, self._costs, self.spent
        )

    def ask_instant(self) -> None:
        """Every instant rung; from then on the budget is spent."""
        # the first answer of a process waits for compiled kernels, which is no cost of a model
        ask_instant(next(iter(PRESETS.values())).design, Scene(1e3, steps=1), Rung("energy"))
        for rung in ladder_rungs():
            if not rung.is_instant:
                continue
            click.echo(f"{rung.label}:", err=True)
            found = ask_instant(self.design, self.scene, rung)
            if isinstance(found, str):
                self.refusals[rung] = found
            else:
                self.answers.append(found)
        self._end = None if self.budget is None else time.perf_counter() + self.budget

    def solve_what_fits(self, interrupted: Callable[[], bool]) -> None:
        """Finite elements, cheapest first, while their predicted time fits the budget."""
        for rung in ladder_rungs():
            if not rung.is_instant and not self.spent and self._fits(rung):
                self.solve(rung, interrupted)

    def solve_choices(self, limits: list[Limit], interrupted: Callable[[], bool]) -> None:
        """The rungs chosen, as far as they fit the budget."""
        for limit in limits:
            point = limit.choose(self.ladder().points).point
            if point is None:
                continue
            self.chosen[limit] = point
            if not point.rung.is_instant and self._fits(point.rung):
                self.solve(point.rung, interrupted)

    def choice(self, limit: Limit, built: Ladder) -> Choice:
        """What keeps to the limit; where it has been acted upon, how that went."""
        before = self.chosen.get(limit)
        if before is None:
            return limit.choose(built.points)
        return as_it_went(limit, before, built.points, self.budget)

    def solve(self, rung: Rung, interrupted: Callable[[], bool]) -> None:
        """Run finite elements, and remember how long they took."""
        if interrupted() or rung.is_instant:
            return
        before = next((p for p in self.ladder().points if p.rung == rung), None)
        if before is not None and before.state == "predicted" and before.seconds is not None:
            self.predicted[rung] = before.seconds
        solve = self._solver()
        click.echo(f"{rung.label}:", err=True)
        try:
            response = solve(
                self.design, self.scene, accuracy=rung.accuracy or 0.05, time_budget=self._left(),
                progress=show_progress(), cancelled=interrupted,
            )  # fmt: skip
        except QuestionError as refusal:
            self.refusals[rung] = str(refusal)
            return
        remember(response, rung)
        if response.outcome in STOPPED:
            self.spent[rung] = response.wall_s
            return
        self.answers.append(Answer.of(response, rung))
        self._costs = cost_model()

    def _solver(self) -> Callable[..., Response]:
        """The 3D solver, with its kernels read in: loading is no cost of a rung."""
        from actuators.mechanics.continuum import solve, warm

        if not self._is_loaded:
            begun = time.perf_counter()
            click.echo("loading the solver", err=True)
            warm.exercise()
            if self._end is not None:
                self._end += time.perf_counter() - begun
            self._is_loaded = True
        return solve

    def _left(self) -> float | None:
        return None if self._end is None else max(self._end - time.perf_counter(), 0.1)

    def _fits(self, rung: Rung) -> bool:
        point = next(p for p in self.ladder().points if p.rung == rung)
        left = self._left()
        if point.state != "predicted" or point.same_as is not None or point.seconds is None:
            return False
        return left is None or point.seconds.value <= left


def _read_limit(text: str) -> Limit:
    """``2%`` or ``10s``."""
    if text.strip().endswith("%"):
        accuracy = parse_quantity(text, "fraction", field="at-most")
        if accuracy <= 0.0:
            raise _refuse_limit(text)
        return Limit(accuracy=accuracy)
    try:
        return Limit(seconds=_positive(text, "at-most"))
    except InputError as error:
        raise _refuse_limit(text) from error


def _refuse_limit(text: str) -> InputError:
    mend = "Write an error such as 2%, or a time such as 10s, above zero."
    return InputError(
        f"at-most is {text!r}; it must be an error or a time. {mend}",
        field="at-most", value=text, mend=mend,
    )  # fmt: skip


def _read_budget(text: str) -> float:
    return _positive(text, "budget")


def _positive(text: str, field: str) -> float:
    seconds = parse_quantity(text, "time", field=field)
    if seconds <= 0.0:
        raise InputError(
            f"{field} is {text!r}; it must be more than no time.",
            field=field, value=text, mend="Write for example 30s.",
        )  # fmt: skip
    return seconds


def _read_runs(text: str) -> list[Rung]:
    if text.strip() == "none":
        return []
    return [read_rung(part, read_accuracy) for part in text.split(",")]
