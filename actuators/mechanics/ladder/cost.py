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

Jobs that were stopped teach too, for those that take long are stopped most: of each is known that t
is longer. Where that is news, it becomes an observation with the mean and variance that turn what
the jobs that ended say of it into what is left of that above its seconds (one step of expectation
propagation).
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from scipy.special import ndtr

from actuators.mechanics.ladder.ends import Errors
from actuators.mechanics.ladder.past import PastJob, Spread
from actuators.mechanics.ladder.process import GaussianProcess, above, kernels
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
NO_NEWS = -1.0
"""Standard deviations from what is expected, below which it is nothing new that a job takes longer
than so."""


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


class Known:
    """What the package's ``record`` says, ready for jobs of a machine to be added. ``levels``:
    errors on the meshes of massive bodies (False) and of those whose chambers stand apart (True).
    """

    def __init__(
        self,
        record: Sequence[PastJob],
        levels: Mapping[bool, LevelErrors],
        spread: Spread | None = None,
    ) -> None:
        self.spread, self.levels = spread or Spread(), levels
        ended = [job for job in record if not job.stopped]
        rest = _rest(ended)
        self.usual = float(rest.mean()) if ended else 0.0
        self.errors = Errors(levels, self.spread).learning(record)
        self.away = np.zeros(0)
        self.times = GaussianProcess(self._covariance)
        if ended:
            told = (_features(ended), np.zeros(len(ended)), rest - self.usual)
            self.times, self.away = self._learnt(self.times, told)
        self.times = self.learning_stopped(
            self.times, self.errors, [job for job in record if job.stopped], own=False
        )

    @property
    def count(self) -> int:
        """Jobs that ended."""
        return len(self.away)

    def _learnt(
        self, before: GaussianProcess, told: tuple[np.ndarray, np.ndarray, np.ndarray]
    ) -> tuple[GaussianProcess, np.ndarray]:
        """With more jobs (features, whether own, rest of ln t), and by how many standard deviations
        each differs from what all others say of it; those that differ most count less."""
        noise = np.full(len(told[0]), self.spread.noise**2)
        found = before.learning(*told, noise)
        away = found.left_out(len(noise))
        if (away > OUTLIER).any():
            found = before.learning(*told, noise * np.maximum(away / OUTLIER, 1.0) ** 2)
        return found, away

    def learning(self, jobs: Sequence[PastJob]) -> tuple[GaussianProcess, Errors, np.ndarray]:
        """With a machine's own jobs: of their seconds, of their errors; and how far all jobs that
        ended are from what the others say."""
        ended = [job for job in jobs if not job.stopped]
        errors, times, away = self.errors.learning(jobs), self.times, self.away
        if ended:
            told = (_features(ended), np.ones(len(ended)), _rest(ended) - self.usual)
            times, more = self._learnt(times, told)
            away = np.concatenate([away, more])
        stopped = [job for job in jobs if job.stopped]
        return self.learning_stopped(times, errors, stopped, own=True), errors, away

    def learning_stopped(
        self, times: GaussianProcess, errors: Errors, stopped: Sequence[PastJob], *, own: bool
    ) -> GaussianProcess:
        """With what is news about jobs that were stopped."""
        if not stopped:
            return times
        x, tag = _features(stopped), np.full(len(stopped), float(own))
        mean, variance = times.expected(x, tag)
        variance = variance + self.spread.noise**2
        deviation = np.sqrt(variance)
        least = np.log([job.seconds for job in stopped]) - self.usual - mean
        chances = errors.ends_on([job.outlook for job in stopped])
        at = np.zeros(len(stopped))
        for k, job in enumerate(stopped):
            # it may have been on its way to any of its meshes: the one that explains it best
            by_mesh = (least[k] - np.array(job.outlook.work)) / deviation[k]
            at[k] = by_mesh[np.argmax(chances[k] * ndtr(-by_mesh))]
        news = np.flatnonzero(at >= NO_NEWS)
        beyond = np.array([above(each) for each in at[news].tolist()]).reshape(-1, 2)
        middle = mean[news] + beyond[:, 0] * deviation[news]
        left = np.clip(beyond[:, 1], 1e-3, 0.99) * variance[news]  # of what lies above
        noise = 1.0 / (1.0 / left - 1.0 / variance[news])
        place = noise * (middle / left - mean[news] / variance[news])
        return times.learning(x[news], tag[news], place, noise)

    def _covariance(
        self, a: np.ndarray, a_own: np.ndarray, b: np.ndarray, b_own: np.ndarray
    ) -> np.ndarray:
        s = self.spread
        alike, near = kernels(a, b, s.reach)
        linear = s.weight**2 * (a @ b.T)
        machines = s.machine**2 * (a_own[:, None] * b_own[None])
        return linear + s.memory**2 * alike + s.peculiar**2 * near + machines

    def log_likelihood(self) -> float:
        """Of the record's jobs, given :class:`Spread`: what the spreads are chosen by."""
        return self.times.log_likelihood()


def _features(jobs: Sequence[PastJob]) -> np.ndarray:
    return np.array([job.outlook.features for job in jobs]).reshape(-1, len(FEATURES))


def _rest(jobs: Sequence[PastJob]) -> np.ndarray:
    """(n,) ln t beyond the work that the meshes tell."""
    return np.array([math.log(job.seconds) - job.outlook.work[job.level] for job in jobs])


class CostModel:
    """Prediction from what is ``known`` and the ``own`` jobs of this machine."""

    def __init__(self, known: Known, own: Sequence[PastJob]) -> None:
        latest = [job for job in own if job.is_timed][-MOST_JOBS:]
        self.learned_from = sum(not job.stopped for job in latest)
        self._known = known
        self._times, self._errors, away = known.learning(latest)
        self._wider = 1.0
        if len(away) >= ENOUGH:  # a range is as wide as four of five of these jobs needed it
            self._wider = float(np.clip(np.quantile(away, 0.8) / WITHIN, 1.0, OUTLIER))

    def predict(self, question: Outlook) -> TimeEstimate:
        """Time on this machine of one question."""
        mean, variance = self._times.expected(question.features[None], np.ones(1))
        deviation = self._wider * math.sqrt(float(variance[0]) + self._known.spread.noise**2)
        (chances,) = self._errors.ends_on([question])
        middles = self._known.usual + float(mean[0]) + np.array(question.work)
        seconds, low, high = _of_mixture(chances, middles, deviation)
        return TimeEstimate(seconds, low, high, self.learned_from)


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
