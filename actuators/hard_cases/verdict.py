"""Whether an answer is what must come out: what must hold always, and what a case expects."""

import math
from collections.abc import Callable, Iterator
from typing import Any, cast

import numpy as np

from actuators.hard_cases.case import Budget, Case, Check, Scaling, Variation
from actuators.mechanics.response import Outcome, Response

SLACK = 1.5
"""Of the processor time: compiled code is loaded on first use, and results are recovered after the
last iteration."""
SCALES: dict[str, tuple[int, int]] = {
    # powers of length and modulus by which a quantity follows a change of units
    "_mm": (1, 0), "_per_m": (-1, 0), "_ml": (3, 0), "_kPa": (0, 1), "_N": (2, 1),
}  # fmt: skip

Document = dict[str, Any]
Compare = Callable[[Variation], Document]
"""The document of the answer to a changed question."""


def always(answer: Response, seconds: float, budget: Budget) -> Iterator[str]:
    """What is wrong with any answer: a sentence for each."""
    if (answer.advice is None) != (answer.outcome is Outcome.CONVERGED):
        yield f"{answer.outcome.value} with the advice {answer.advice!r}"
    if not answer.path:
        yield "the path is empty"
    for where, array in _arrays(answer):
        if not np.isfinite(array).all():
            yield f"{where} holds numbers that are not finite"
    if seconds > SLACK * budget.seconds:
        yield f"took {seconds:.3g} s of {budget.seconds:g} s"
    if answer.newton_iterations > budget.iterations + 2:  # those begun are finished
        yield f"took {answer.newton_iterations} iterations of {budget.iterations}"


def _arrays(answer: Response) -> Iterator[tuple[str, Any]]:
    for number, point in enumerate(answer.path):
        at = f"point {number} of the path"
        yield at, [*point.tip, *point.tip_displacement, point.bending_angle, point.pressure]
        rest = (point.tip_rotation, point.curvature, point.torsion, point.cavity_volume,
                point.max_principal_stretch, point.plate_force, point.cylinder_force,
                point.max_contact_pressure)  # fmt: skip
        yield at, [x for x in rest if x is not None]
    if answer.centreline is not None:
        yield "the centreline", answer.centreline.positions
        yield "the centreline's frames", answer.centreline.frames
    if answer.surface is not None:
        for name in ("displacement", "stretch", "stress", "contact_pressure"):
            array = getattr(answer.surface, name)
            if array is not None:
                yield f"the surface's {name}", array


def expected(case: Case, answer: Document, compare: Compare) -> Iterator[tuple[str, float | None]]:
    """What is not as the case expects (empty where it is), with the error where a check has one."""
    outcome = answer["outcome"]
    if outcome not in case.outcomes:
        allowed = " or ".join(case.outcomes)
        yield f"{outcome} instead of {allowed}: {answer['advice']}", None
        return
    if case.says and case.says not in " ".join([answer["advice"] or "", *answer["notes"]]):
        yield f"says nothing of {case.says!r}", None
    for check in case.checks:
        yield _judged(check, answer, compare)


def _judged(check: Check, answer: Document, compare: Compare) -> tuple[str, float | None]:
    found = read(answer, check.quantity, check.at)
    if found is None:
        return f"{check.quantity} is not known", None
    if check.above is not None and not float(found.min()) > check.above:
        return f"{check.quantity} is {_text(found)}, not above {check.above:g}", None
    if check.below is not None and not float(found.max()) < check.below:
        return f"{check.quantity} is {_text(found)}, not below {check.below:g}", None
    if check.value is None and check.like is None:
        return "", None
    wanted = _wanted(check, compare)
    if wanted is None:
        return f"{check.quantity} is not known of what it is compared with", None
    off = float(np.linalg.norm(found - wanted))
    if not check.absolute:
        size = float(np.linalg.norm(wanted))
        off = off / size if size > 0 else (0.0 if off == 0 else math.inf)
    if off <= check.tolerance:
        return "", off
    return (
        f"{check.quantity} is {_text(found)} instead of {_text(wanted)}, off by {off:.2g}; "
        f"allowed {check.tolerance:g}"
    ), off


def _wanted(check: Check, compare: Compare) -> np.ndarray | None:
    if check.like is None:
        return check.factor * np.atleast_1d(np.array(check.value, dtype=float))
    other = read(compare(check.like), check.quantity, check.at)
    if other is None:
        return None
    scale = 1.0
    if check.like.scaled is not None:
        scale = _units(check.quantity, check.like.scaled)
    return check.factor * other / scale


def _units(quantity: str, scaling: Scaling) -> float:
    for ending, (length, modulus) in SCALES.items():
        if quantity.endswith(ending):
            return scaling.length**length * scaling.modulus**modulus
    return 1.0


def read(answer: Document, quantity: str, at: int = -1) -> np.ndarray | None:
    """A quantity of an answer's document: of the path's point ``at``, or of the whole;
    ``path_points``, ``arc_mm``: how far the tip is along its way, are made from it."""
    path = cast("list[Document]", answer["path"])
    if quantity == "path_points":
        return np.array([float(len(path))])
    value = path[at].get(quantity) if path else None
    if value is None:
        value = answer.get(quantity)
    return None if value is None else np.atleast_1d(np.array(value, dtype=float))


def _text(x: np.ndarray) -> str:
    return ", ".join(f"{value:.6g}" for value in x)
