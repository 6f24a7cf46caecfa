"""How long a finite-element job will take: Bayesian regression in the logarithm of seconds.

    ln t = m + (work feature) + x . b + g(x) + h(x) + noise

x are the features of :mod:`.question`; b has a normal prior about 0 (ridge regression); g is a
Gaussian process that remembers what is alike (a job like one that has run takes about as long); h
is what is peculiar to one question and features do not tell (how its contact goes): nearly the
same where nothing but accuracy or pressure differs, so that a question timed before dominates its
own prediction; m is one number per machine, wide open until this machine's first jobs have ended.
What is known before any job has run here are the jobs of the package's own record
(:mod:`.record`), as data of another machine. All of it is one Gaussian conditional: exact, and
quick at some hundred jobs.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from actuators.mechanics.ladder.question import FEATURES

WITHIN = 1.2816
"""Standard deviations on either side that hold 80 % of a normal distribution."""
OUTLIER = 3.0
"""Standard deviations beyond which a job (a machine that slept) is believed less."""
ENOUGH = 20
"""Jobs that tell how wide ranges must be."""
MOST_JOBS = 300
"""Latest jobs of a machine that are learnt from."""
_WORK = FEATURES.index("work")
_VARIED = {"work": 2.5, "strain": 1.5, "large strain": 1.0, "steps": 1.0}
_SAME = np.array([_VARIED.get(name, 0.03) for name in FEATURES])
"""Differences of features over which a question is still the same one: accuracy changes the work
alone, pressure the strain alone; bodies differ in the unknowns of their coarsest mesh."""


@dataclass(frozen=True, eq=False)
class Timings:
    """n jobs that have run: ``features`` (n, f) as of :func:`.question.features`, ``seconds``
    (n,)."""

    features: np.ndarray
    seconds: np.ndarray

    @staticmethod
    def of(jobs: Sequence[tuple[np.ndarray, float]]) -> "Timings":
        """From pairs of features and seconds; jobs of no duration are left out."""
        kept = [(x, t) for x, t in jobs if t > 0.0 and math.isfinite(t)]
        if not kept:
            return Timings(np.empty((0, len(FEATURES))), np.empty(0))
        return Timings(np.array([x for x, _ in kept]), np.array([t for _, t in kept]))


@dataclass(frozen=True)
class Spread:
    """Standard deviations, all of ln t: of the weights ``b`` (per unit of a feature), of the memory
    ``g`` and its ``reach`` (distance in features), of what a question shares with itself alone
    (``peculiar``, h), of the noise between two runs of one question, of one machine against
    another."""

    weight: float = 0.15
    memory: float = 0.3
    reach: float = 1.0
    peculiar: float = 0.4
    noise: float = 0.1
    machine: float = 1.0


@dataclass(frozen=True)
class TimeEstimate:
    """Seconds expected (the median), and the range that holds 80 % of such jobs. ``learned_from``:
    how many jobs of this machine."""

    seconds: float
    low: float
    high: float
    learned_from: int

    def longer_than(self, spent: float) -> "TimeEstimate":
        """The same, knowing that ``spent`` seconds are not enough: the upper part of the lognormal
        distribution, its median and the range that holds 80 % of it."""
        if spent <= 0.0:
            return self
        deviation = max(math.log(self.high / self.seconds) / WITHIN, 1e-3)
        logs = NormalDist(math.log(self.seconds), deviation)
        below = min(logs.cdf(math.log(spent)), 1.0 - 1e-9)

        def part(share: float) -> float:
            return math.exp(logs.inv_cdf(below + share * (1.0 - below)))

        return TimeEstimate(part(0.5), part(0.1), part(0.9), self.learned_from)


class CostModel:
    """Prediction from the package's ``record`` and the ``own`` jobs of this machine."""

    def __init__(self, record: Timings, own: Timings, spread: Spread | None = None) -> None:
        self._spread = spread or Spread()
        latest = Timings(own.features[-MOST_JOBS:], own.seconds[-MOST_JOBS:])
        self.learned_from = len(latest.seconds)
        self._x = np.concatenate([record.features, latest.features])
        self._is_own = np.arange(len(self._x)) >= len(record.seconds)
        t = np.concatenate([record.seconds, latest.seconds])
        self._level = float(np.mean(np.log(t) - self._x[:, _WORK])) if len(t) else 0.0
        self._rest = np.log(t) - self._mean(self._x)
        noise = np.full(len(t), self._spread.noise**2)
        self._factor = self._factorise(noise)
        self._wider = 1.0
        if self._factor is not None:
            away = self._left_out(noise)
            if len(t) >= ENOUGH:  # a range is as wide as four of five of these jobs needed it
                self._wider = float(np.clip(np.quantile(away, 0.8) / WITHIN, 1.0, OUTLIER))
            noise = noise * np.maximum(away / OUTLIER, 1.0) ** 2
            self._factor = self._factorise(noise)

    def predict(self, features: np.ndarray) -> TimeEstimate:
        """Time on this machine of one question with ``features`` (f,)."""
        x = features[None]
        mean, variance = float(self._mean(x)[0]), self._own_variance(x)
        if self._factor is not None:
            cross = self._covariance(x, np.ones(1, dtype=bool), self._x, self._is_own)[0]
            solved = cho_solve(self._factor, np.stack([self._rest, cross], axis=1))
            mean += float(cross @ solved[:, 0])
            variance -= float(cross @ solved[:, 1])
        deviation = self._wider * math.sqrt(max(variance, 0.0) + self._spread.noise**2)
        return TimeEstimate(
            math.exp(mean),
            math.exp(mean - WITHIN * deviation),
            math.exp(mean + WITHIN * deviation),
            self.learned_from,
        )

    def log_likelihood(self) -> float:
        """Of the jobs learnt from, given :class:`Spread`: what the spreads are chosen by."""
        if self._factor is None:
            return 0.0
        fit = float(self._rest @ cho_solve(self._factor, self._rest))
        size = 2.0 * float(np.log(np.diag(self._factor[0])).sum())
        return -0.5 * (fit + size + len(self._rest) * math.log(2 * math.pi))

    def _mean(self, x: np.ndarray) -> np.ndarray:
        return self._level + x[:, _WORK]

    def _own_variance(self, x: np.ndarray) -> float:
        own = np.ones(1, dtype=bool)
        return float(self._covariance(x, own, x, own)[0, 0])

    def _covariance(
        self, a: np.ndarray, a_own: np.ndarray, b: np.ndarray, b_own: np.ndarray
    ) -> np.ndarray:
        s = self._spread
        apart = ((a[:, None] - b[None]) ** 2).sum(axis=-1)
        linear = s.weight**2 * (a @ b.T)
        alike = s.memory**2 * np.exp(-0.5 * apart / s.reach**2)
        near = ((a[:, None] - b[None]) ** 2 / _SAME**2).sum(axis=-1)
        same = s.peculiar**2 * np.exp(-0.5 * near)
        return linear + alike + same + s.machine**2 * (a_own[:, None] & b_own[None])

    def _factorise(self, noise: np.ndarray) -> tuple[np.ndarray, bool] | None:
        if not len(noise):
            return None
        covariance = self._covariance(self._x, self._is_own, self._x, self._is_own)
        factor, lower = cho_factor(covariance + np.diag(noise))
        return factor, bool(lower)

    def _left_out(self, noise: np.ndarray) -> np.ndarray:
        """Size of every job's residual when predicted from all others, in standard deviations."""
        assert self._factor is not None
        inverse = cho_solve(self._factor, np.eye(len(noise)))
        variance = 1.0 / np.diag(inverse)
        return np.abs(inverse @ self._rest) * np.sqrt(variance)
