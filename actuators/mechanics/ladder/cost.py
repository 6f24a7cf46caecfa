"""How long a finite-element job will take: on which mesh it will end, and how long that takes.

Bayesian regression twice over. Of the estimated errors e_k on the k-th mesh,

    ln e_k = (mean of the record) + deviation (g(x) + h(x)) + noise,

says with which probability a job ends on each mesh. Of the seconds t of a job that ends there,

    ln t = m + ln W_k + x . b + g(x) + h(x) + noise,

W_k the work that the meshes up to there tell (:func:`.question.work_by_level`), x the features of
:mod:`.question`; b has a normal prior about 0 (ridge regression); g is a Gaussian process that
remembers what is alike (a job like one that has run takes about as long); h is what a question
shares with its neighbours alone, as a slider moves, and no feature tells (how its contact goes); m
is one number per machine, wide open until this machine's first jobs have ended. What is known
before any job has run here are the jobs of the package's own record (:mod:`.record`), as data of
another machine. All of it is Gaussian conditionals: exact, and quick at some hundred jobs.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.special import ndtr

from actuators.mechanics.ladder.question import FEATURES, LevelErrors, Outlook

WITHIN = 1.2816
"""Standard deviations on either side that hold 80 % of a normal distribution."""
FACTOR = 1.5
"""The seconds told are those that most likely come within this factor of what a job takes."""
OUTLIER = 3.0
"""Standard deviations beyond which a job (a machine that slept) is believed less."""
ENOUGH = 20
"""Jobs that tell how wide ranges must be."""
MOST_JOBS = 300
"""Latest jobs of a machine that are learnt from."""
JUDGED = ("tip", "angle", "force", "limit_pressure")
"""Estimates that decide whether a job ends on a mesh (``continuum.estimates``)."""
SMALLEST_ERROR = 1e-4
_NEAR = {"coarse": 0.2, "strain": 0.7, "large strain": 0.7, "steps": 1.0, "turn": 0.7,
         "closed": 0.7, "pressed": 0.3, "weight": 0.7, "force": 0.7}  # fmt: skip
_SAME = np.array([_NEAR.get(name, 0.1) for name in FEATURES])
"""Differences of features over which questions are neighbours: as a slider moves, or the
pressure."""


@dataclass(frozen=True, eq=False)
class PastJob:
    """A job that has run: what could be told of it, the ``seconds`` it took, the mesh it ended on
    (``level``, 0 the coarsest), and the largest judged estimates [fractions] on meshes where they
    are known, by level."""

    outlook: Outlook
    seconds: float
    level: int
    errors: Mapping[int, float]

    @staticmethod
    def of(
        outlook: Outlook, seconds: float, unknowns: int, estimates: Mapping[str, float | None]
    ) -> "PastJob":
        """From what an answer says of itself: its ``unknowns`` and its estimated errors by
        quantity, as fractions."""
        level = outlook.level_of(unknowns)
        known = [e for name in JUDGED if (e := estimates.get(name)) is not None]
        return PastJob(outlook, seconds, level, {level: max(known)} if known else {})

    @property
    def is_timed(self) -> bool:
        """Whether its seconds mean anything."""
        return self.seconds > 0.0 and math.isfinite(self.seconds)


@dataclass(frozen=True)
class Spread:
    """Standard deviations. Of ln t: of the weights ``b`` (per unit of a feature), of the memory
    ``g`` and its ``reach`` (distance in features), of what neighbours share (``peculiar``, h), of
    the noise between two runs of one question, of one machine against another. Of errors, as parts
    of their whole variance: ``error_alike`` g, ``error_near`` h, the rest is noise;
    ``error_levels``: correlation from one mesh to the next."""

    weight: float = 0.05
    memory: float = 0.75
    reach: float = 2.0
    peculiar: float = 0.3
    noise: float = 0.14
    machine: float = 1.0
    error_alike: float = 0.3
    error_near: float = 0.65
    error_levels: float = 0.7


@dataclass(frozen=True)
class TimeEstimate:
    """Seconds expected, and the range that holds 80 % of such jobs. ``learned_from``: how many jobs
    of this machine."""

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
    """Prediction from the jobs of the package's ``record`` and the ``own`` ones of this machine.
    ``levels``: errors on the meshes of massive bodies (False) and of those whose chambers stand
    apart (True)."""

    def __init__(
        self,
        record: Sequence[PastJob],
        own: Sequence[PastJob],
        levels: Mapping[bool, LevelErrors],
        spread: Spread | None = None,
    ) -> None:
        self._spread = spread or Spread()
        latest = [job for job in own if job.is_timed][-MOST_JOBS:]
        self.learned_from = len(latest)
        jobs = [*record, *latest]
        self._errors = _Errors(jobs, levels, self._spread)
        self._x = np.array([job.outlook.features for job in jobs]).reshape(-1, len(FEATURES))
        self._is_own = np.arange(len(jobs)) >= len(record)
        rest = np.array([math.log(job.seconds) - job.outlook.work[job.level] for job in jobs])
        self._level = float(rest.mean()) if len(jobs) else 0.0
        self._rest = rest - self._level
        noise = np.full(len(jobs), self._spread.noise**2)
        together = self._covariance(self._x, self._is_own, self._x, self._is_own)
        self._factor = _factorise(together, noise)
        self._wider = 1.0
        if self._factor is not None:
            away = _left_out(self._factor, self._rest)
            if len(jobs) >= ENOUGH:  # a range is as wide as four of five of these jobs needed it
                self._wider = float(np.clip(np.quantile(away, 0.8) / WITHIN, 1.0, OUTLIER))
            if (away > OUTLIER).any():
                noise = noise * np.maximum(away / OUTLIER, 1.0) ** 2
                self._factor = _factorise(together, noise)

    def predict(self, question: Outlook) -> TimeEstimate:
        """Time on this machine of one question."""
        x, own = question.features[None], np.ones(1, dtype=bool)
        mean, variance = self._level, float(self._covariance(x, own, x, own)[0, 0])
        if self._factor is not None:
            cross = self._covariance(x, own, self._x, self._is_own)[0]
            solved = cho_solve(self._factor, np.stack([self._rest, cross], axis=1))
            mean += float(cross @ solved[:, 0])
            variance -= float(cross @ solved[:, 1])
        deviation = self._wider * math.sqrt(max(variance, 0.0) + self._spread.noise**2)
        chances = self._errors.ends_on(question)
        seconds, low, high = _of_mixture(chances, mean + np.array(question.work), deviation)
        return TimeEstimate(seconds, low, high, self.learned_from)

    def log_likelihood(self) -> float:
        """Of the jobs learnt from, given :class:`Spread`: what the spreads are chosen by."""
        if self._factor is None:
            return 0.0
        fit = float(self._rest @ cho_solve(self._factor, self._rest))
        size = 2.0 * float(np.log(np.diag(self._factor[0])).sum())
        return -0.5 * (fit + size + len(self._rest) * math.log(2 * math.pi))

    def _covariance(
        self, a: np.ndarray, a_own: np.ndarray, b: np.ndarray, b_own: np.ndarray
    ) -> np.ndarray:
        s = self._spread
        alike, near = _kernels(a, b, s.reach)
        linear = s.weight**2 * (a @ b.T)
        machines = s.machine**2 * (a_own[:, None] & b_own[None])
        return linear + s.memory**2 * alike + s.peculiar**2 * near + machines


def _left_out(factor: tuple[np.ndarray, bool], rest: np.ndarray) -> np.ndarray:
    """Size of every residual (n,) when predicted from all others, in standard deviations."""
    inverse = cho_solve(factor, np.eye(len(rest)))
    return np.abs(inverse @ rest) / np.sqrt(np.diag(inverse))


def _factorise(together: np.ndarray, noise: np.ndarray) -> tuple[np.ndarray, bool] | None:
    """Factor of a covariance with noise (n,) on its diagonal; None of nothing."""
    if not len(noise):
        return None
    factor, lower = cho_factor(together + np.diag(noise))
    return factor, bool(lower)


def _kernels(a: np.ndarray, b: np.ndarray, reach: float) -> tuple[np.ndarray, np.ndarray]:
    """How alike (n, f) and (m, f) features are, and how near as neighbours: (n, m) each, 1 for the
    same."""
    alike = np.exp(-0.5 * _apart(a, b) / reach**2)
    near = np.exp(-0.5 * _apart(a / _SAME, b / _SAME))
    return alike, near


def _apart(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Squared distances (n, m) of (n, f) from (m, f)."""
    squares = (a**2).sum(axis=1)[:, None] + (b**2).sum(axis=1) - 2.0 * (a @ b.T)
    return np.maximum(squares, 0.0)


def _of_mixture(
    chances: np.ndarray, means: np.ndarray, deviation: float
) -> tuple[float, float, float]:
    """Of ln t distributed normally about each of ``means`` (n,) with a probability (n,): the
    seconds with the most probability within :data:`FACTOR` of them, and the 80 % range."""
    there = means[chances > 1e-6]
    grid = np.linspace(there.min() - 4 * deviation, there.max() + 4 * deviation, 801)

    def below(logs: np.ndarray) -> np.ndarray:
        return ndtr((logs[:, None] - means) / deviation) @ chances

    total = below(grid)
    low, middle, high = (float(np.interp(q, total, grid)) for q in (0.1, 0.5, 0.9))
    hit = below(grid + math.log(FACTOR)) - below(grid - math.log(FACTOR))
    best = grid[hit >= hit.max() - 1e-3]
    told = float(best[np.argmin(np.abs(best - middle))])
    return math.exp(told), math.exp(min(low, told)), math.exp(max(high, told))


class _Errors:
    """What past jobs say of the estimated errors of a question, mesh by mesh: deviations of their
    logarithms from the record's mean, in its standard deviations."""

    def __init__(
        self, jobs: Sequence[PastJob], levels: Mapping[bool, LevelErrors], spread: Spread
    ) -> None:
        self._levels, self._spread = levels, spread
        seen = [(job.outlook, *each) for job in jobs for each in self._of(job)]
        self._x = np.array([o.features for o, *_ in seen]).reshape(-1, len(FEATURES))
        self._on = np.array([level for _, level, *_ in seen])
        self._away = np.array([away for _, _, away, _ in seen])
        noise = np.array([self._noise + unsure for _, _, _, unsure in seen])
        self._factor = _factorise(self._covariance(self._x, self._on, self._x, self._on), noise)

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
                found.append((level, *_above(least)))
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
        alike, near = _kernels(a, b, self._spread.reach)
        levels = self._spread.error_levels ** np.abs(a_on[:, None] - b_on[None])
        return levels * (self._spread.error_alike * alike + self._spread.error_near * near)

    def ends_on(self, question: Outlook) -> np.ndarray:
        """Probability (n,) that a job ends on each of its n meshes."""
        chances = np.zeros(len(question.sizes))
        if question.accuracy is None or question.first == len(chances) - 1:
            chances[-1] = 1.0
            return chances
        on = np.arange(question.first, len(chances) - 1)
        mean = np.zeros(len(on))
        variance = np.full(len(on), self._spread.error_alike + self._spread.error_near)
        if self._factor is not None:
            x = np.repeat(question.features[None], len(on), axis=0)
            cross = self._covariance(x, on, self._x, self._on)
            mean = cross @ cho_solve(self._factor, self._away)
            variance = variance - np.einsum("kn,nk->k", cross, cho_solve(self._factor, cross.T))
        deviation = np.sqrt(np.maximum(variance, 0.0) + self._noise)
        reached = 1.0
        for k, level in enumerate(on.tolist()):
            asked = self._deviation(question, level, math.log(question.accuracy))
            ends = float(ndtr((asked - mean[k]) / deviation[k]))
            chances[level], reached = reached * ends, reached * (1.0 - ends)
        chances[-1] += reached
        return chances


def _above(least: float) -> tuple[float, float]:
    """Mean and variance of a standard normal variable that is known to be above ``least``."""
    above = float(ndtr(-least))
    if above < 1e-6:
        return least, 0.0
    mean = math.exp(-0.5 * least**2) / math.sqrt(2.0 * math.pi) / above
    return mean, max(1.0 - mean * (mean - least), 0.0)
