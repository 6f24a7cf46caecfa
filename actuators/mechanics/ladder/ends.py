"""On which mesh a job ends: estimated errors of past jobs, mesh by mesh."""

import math
from collections.abc import Mapping, Sequence

import numpy as np
from scipy.special import ndtr

from actuators.mechanics.ladder.past import PastJob, Spread
from actuators.mechanics.ladder.process import GaussianProcess, above, kernels
from actuators.mechanics.ladder.question import FEATURES, LevelErrors, Outlook

SMALLEST_ERROR = 1e-4


class Errors:
    """What past jobs say of the estimated errors of a question, mesh by mesh: deviations of their
    logarithms from the record's mean, in its standard deviations."""

    def __init__(self, levels: Mapping[bool, LevelErrors], spread: Spread) -> None:
        self._levels, self._spread = levels, spread
        self._process = GaussianProcess(self._covariance)

    def learning(self, jobs: Sequence[PastJob]) -> "Errors":
        """With more jobs that ended."""
        found = Errors(self._levels, self._spread)
        seen = [(job.outlook, *each) for job in jobs for each in self._of(job)]
        x = np.array([o.features for o, *_ in seen]).reshape(-1, len(FEATURES))
        on, away, unsure = np.array([each[1:] for each in seen], dtype=float).reshape(-1, 3).T
        found._process = self._process.learning(x, on, away, self._noise + unsure)
        return found

    def _of(self, job: PastJob) -> list[tuple[int, float, float]]:
        """(level, deviation, variance about it) of every finer mesh that a job has been on. Where
        it went on and did not say how large the error was, that was above the accuracy: what is
        expected of such."""
        found: list[tuple[int, float, float]] = []
        for level in range(1, job.level + 1):
            error = job.errors.get(level)
            if error is not None:
                logs = math.log(max(error, SMALLEST_ERROR))
                found.append((level, self._deviation(job.outlook, level, logs), 0.0))
            elif level < job.level and job.outlook.accuracy is not None:
                least = self._deviation(job.outlook, level, math.log(job.outlook.accuracy))
                found.append((level, *above(least)))
        return found

    def _deviation(self, question: Outlook, level: int, logs: float) -> float:
        mean, scale = self._levels[question.stands_apart].on(level)
        return (logs - mean) / scale

    @property
    def _noise(self) -> float:
        return max(1.0 - self._spread.error_alike - self._spread.error_near, 0.02)

    def _covariance(
        self, a: np.ndarray, a_on: np.ndarray, b: np.ndarray, b_on: np.ndarray
    ) -> np.ndarray:
        alike, near = kernels(a, b, self._spread.reach)
        levels = self._spread.error_levels ** np.abs(a_on[:, None] - b_on[None])
        return levels * (self._spread.error_alike * alike + self._spread.error_near * near)

    def ends_on(self, questions: Sequence[Outlook]) -> list[np.ndarray]:
        """Probability (n,) that a job ends on each of its n meshes."""
        lasts = [len(question.sizes) - 1 for question in questions]
        between = [
            list(range(last if question.accuracy is None else question.first, last))
            for question, last in zip(questions, lasts, strict=True)
        ]
        places = [question.features for question, on in zip(questions, between, strict=True)
                  for _ in on]  # fmt: skip
        levels = np.array([level for on in between for level in on], dtype=float)
        x = np.array(places).reshape(-1, len(FEATURES))
        mean, variance = self._process.expected(x, levels)
        deviation = np.sqrt(variance + self._noise)
        found: list[np.ndarray] = []
        k = 0
        for question, on, last in zip(questions, between, lasts, strict=True):
            chances, reached = np.zeros(last + 1), 1.0
            for level in on:
                asked = self._deviation(question, level, math.log(question.accuracy or 1.0))
                ends = float(ndtr((asked - mean[k]) / deviation[k]))
                chances[level], reached = reached * ends, reached * (1.0 - ends)
                k += 1
            chances[last] += reached
            found.append(chances)
        return found
