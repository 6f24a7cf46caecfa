"""Running one case: its question, the questions it is compared with, the verdict."""

import json
import os
import subprocess
import sys
import time
import warnings
from dataclasses import dataclass, field
from typing import Any

from actuators.errors import InputError, QuestionError
from actuators.hard_cases.asking import ask
from actuators.hard_cases.case import Case, Variation
from actuators.hard_cases.question import question
from actuators.hard_cases.verdict import always, expected
from actuators.mechanics.cell.cache import forget_cells
from actuators.mechanics.cell.inflated_cache import forget_paths
from actuators.mechanics.response import Outcome, Response


@dataclass(frozen=True, eq=False)
class Result:
    """What came out of a case. ``outcome``: an :class:`Outcome`'s value or ``refused``; ``error``:
    the largest of its checks', None where none has one; ``seconds`` of processor time of its own
    question, without what it is compared with; ``failures``: a sentence for each
    thing that is not as it must be."""

    case: Case
    outcome: str
    advice: str = ""
    error: float | None = None
    iterations: int = 0
    unknowns: int = 0
    seconds: float = 0.0
    failures: tuple[str, ...] = ()
    answer: Response | None = field(default=None, repr=False)

    @property
    def passed(self) -> bool:
        """Whether all came out as it must."""
        return not self.failures

    def to_document(self) -> dict[str, Any]:
        """For ``pneustudio hard-cases --json``."""
        case = self.case
        return {
            "topic": case.topic, "name": case.name, "rung": case.rung, "hard": case.hard,
            "slow": case.slow, "passed": self.passed, "outcome": self.outcome,
            "advice": self.advice or None, "error": self.error, "iterations": self.iterations,
            "unknowns": self.unknowns, "seconds": round(self.seconds, 4),
            "failures": list(self.failures),
        }  # fmt: skip


def run_case(case: Case) -> Result:
    """Ask the case's question and judge the answer; a warning is a failure."""
    if any(check.like for check in case.checks):
        _forget()
    begun = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            answer = ask(question(case), case.budget)
        except InputError as refused:
            return _refused(case, refused, time.process_time() - begun)
        except Warning as warning:
            return Result(case, "warned", failures=(f"warned: {warning}",))
        seconds = time.process_time() - begun
        return _judged(case, answer, seconds)


def _refused(case: Case, refused: InputError, seconds: float) -> Result:
    failures: list[str] = []
    if not case.refused:
        failures.append(f"refused: {refused}")
    elif refused.field != case.refused:
        failures.append(f"refused {refused.field} instead of {case.refused}: {refused}")
    if not refused.mend:
        failures.append(f"refused without a mend: {refused}")
    return Result(case, "refused", str(refused), seconds=seconds, failures=tuple(failures))


def _judged(case: Case, answer: Response, seconds: float) -> Result:
    failures = list(always(answer, seconds, case.budget))
    if case.refused:
        failures.append(f"answered, where {case.refused} was to be refused")
    document = answer.to_document()
    errors: list[float] = []
    try:
        for sentence, off in expected(case, document, lambda like: _other(case, like)):
            failures += [sentence] if sentence else []
            errors += [off] if off is not None else []
    except (InputError, Warning) as broken:
        failures.append(f"the question to compare with: {broken}")
    return Result(
        case, answer.outcome.value, answer.advice or "", max(errors, default=None),
        answer.newton_iterations, answer.unknowns, seconds, tuple(failures), answer,
    )  # fmt: skip


def _other(case: Case, like: Variation) -> dict[str, Any]:
    if like.threads is not None:
        return _in_another_process(case, like.threads)
    _forget()
    other = ask(question(case, like), case.budget)
    allowed = case.outcomes if like.outcome is None else (Outcome(like.outcome),)
    if other.outcome not in allowed:
        raise QuestionError(f"it ended as {other.outcome.value}: {other.advice}", field="like")
    return other.to_document()


def _forget() -> None:
    """Cells are kept under rounded positions: what is compared with a neighbour must be solved."""
    forget_cells()
    forget_paths()


def _in_another_process(case: Case, threads: int) -> dict[str, Any]:
    """The same question where every library runs this many threads: they are told at the start."""
    names = ("NUMBA_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS")
    found = subprocess.run(
        [sys.executable, "-m", "actuators.hard_cases.apart", case.name, case.rung],
        env={**os.environ, **dict.fromkeys(names, str(threads))}, capture_output=True, text=True,
        check=True,
    )  # fmt: skip
    return json.loads(found.stdout)
