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
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from scipy.linalg import cho_solve, cholesky, solve_triangular
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
NO_NEWS = -1.0
"""Standard deviations from what is expected, below which it is nothing new that a job takes longer
than so."""
_NEAR = {"coarse": 0.2, "strain": 0.7, "large strain": 0.7, "drained": 0.7, "steps": 1.0,
         "turn": 0.7, "closed": 0.7, "pressed": 0.3, "weight": 0.7, "force": 0.7}  # fmt: skip
_Covariance = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], np.ndarray]
_SAME = np.array([_NEAR.get(name, 0.1) for name in FEATURES])
"""Differences of features over which questions are neighbours: as a slider moves, or the
pressure."""


@dataclass(frozen=True, eq=False)
class PastJob:
    """A job that has run: what could be told of it, the ``seconds`` it took, the mesh it ended on
    (``level``, 0 the coarsest), and the largest judged estimates [fractions] on meshes where they
    are known, by level. ``stopped``: it had not come to its end by then, and ``level`` is the mesh
    that it had come to at least."""

    outlook: Outlook
    seconds: float
    level: int
    errors: Mapping[int, float]
    stopped: bool = False

    @staticmethod
    def of(
        outlook: Outlook, seconds: float, unknowns: int, estimates: Mapping[str, float | None],
        *, stopped: bool = False,
    ) -> "PastJob":  # fmt: skip
        """From what an answer says of itself: its ``unknowns`` and its estimated errors by
        quantity, as fractions; only the seconds of one that was ``stopped``."""
        if stopped:
            return PastJob(outlook, seconds, 0, {}, stopped=True)
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
        self.errors = _Errors(levels, self.spread).learning(record)
        self.away = np.zeros(0)
        self.times = _Process(self._covariance)
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
        self, before: "_Process", told: tuple[np.ndarray, np.ndarray, np.ndarray]
    ) -> tuple["_Process", np.ndarray]:
        """With more jobs (features, whether own, rest of ln t), and by how many standard deviations
        each differs from what all others say of it; those that differ most count less."""
        noise = np.full(len(told[0]), self.spread.noise**2)
        found = before.learning(*told, noise)
        away = found.left_out(len(noise))
        if (away > OUTLIER).any():
            found = before.learning(*told, noise * np.maximum(away / OUTLIER, 1.0) ** 2)
        return found, away

    def learning(self, jobs: Sequence[PastJob]) -> tuple["_Process", "_Errors", np.ndarray]:
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
        self, times: "_Process", errors: "_Errors", stopped: Sequence[PastJob], *, own: bool
    ) -> "_Process":
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
        above = np.array([_above(each) for each in at[news].tolist()]).reshape(-1, 2)
        middle = mean[news] + above[:, 0] * deviation[news]
        left = np.clip(above[:, 1], 1e-3, 0.99) * variance[news]  # of what lies above
        noise = 1.0 / (1.0 / left - 1.0 / variance[news])
        place = noise * (middle / left - mean[news] / variance[news])
        return times.learning(x[news], tag[news], place, noise)

    def _covariance(
        self, a: np.ndarray, a_own: np.ndarray, b: np.ndarray, b_own: np.ndarray
    ) -> np.ndarray:
        s = self.spread
        alike, near = _kernels(a, b, s.reach)
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


class _Process:
    """A Gaussian process of mean 0 and what has been observed of it, at places told by features
    (n, f) and a tag (n,). ``covariance``: (k, n) of such places with others."""

    def __init__(self, covariance: _Covariance) -> None:
        self._covariance = covariance
        self._x, self._tag = np.zeros((0, len(FEATURES))), np.zeros(0)
        self._y, self._lower = np.zeros(0), np.zeros((0, 0))
        self._weights = np.zeros(0)

    def learning(
        self, x: np.ndarray, tag: np.ndarray, y: np.ndarray, noise: np.ndarray
    ) -> "_Process":
        """With more observations (m,), of variance ``noise`` each. The factor of those before is
        kept, which makes few more of them cheap."""
        if not len(y):
            return self
        found, n = _Process(self._covariance), len(self._y)
        found._x, found._tag = np.concatenate([self._x, x]), np.concatenate([self._tag, tag])
        found._y = np.concatenate([self._y, y])
        found._lower = np.zeros((n + len(y),) * 2)
        across = self._covariance(self._x, self._tag, x, tag)
        left = solve_triangular(self._lower, across, lower=True) if n else across
        corner = self._covariance(x, tag, x, tag) + np.diag(noise) - left.T @ left
        found._lower[:n, :n], found._lower[n:, :n] = self._lower, left.T
        found._lower[n:, n:] = cholesky(corner, lower=True)
        found._weights = cho_solve((found._lower, True), found._y)
        return found

    def expected(self, x: np.ndarray, tag: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Mean and variance (k,) at places."""
        across = self._covariance(x, tag, self._x, self._tag)
        prior = np.array(
            [self._covariance(x[k : k + 1], tag[k : k + 1], x[k : k + 1], tag[k : k + 1])[0, 0]
             for k in range(len(x))]
        )  # fmt: skip
        if not len(self._y) or not len(x):
            return across @ self._weights, prior
        left = solve_triangular(self._lower, across.T, lower=True)
        return across @ self._weights, np.maximum(prior - (left**2).sum(axis=0), 0.0)

    def left_out(self, last: int) -> np.ndarray:
        """Size (last,) of the last so many residuals, when predicted from all others, in standard
        deviations."""
        corner = self._lower[-last:, -last:]
        inverse = solve_triangular(corner, np.eye(last), lower=True)
        return np.abs(self._weights[-last:]) / np.sqrt((inverse**2).sum(axis=0))

    def log_likelihood(self) -> float:
        """Of the observations."""
        size = 2.0 * float(np.log(np.diag(self._lower)).sum())
        return -0.5 * (float(self._y @ self._weights) + size + len(self._y) * math.log(2 * math.pi))


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

    def __init__(self, levels: Mapping[bool, LevelErrors], spread: Spread) -> None:
        self._levels, self._spread = levels, spread
        self._process = _Process(self._covariance)

    def learning(self, jobs: Sequence[PastJob]) -> "_Errors":
        """With more jobs that ended."""
        found = _Errors(self._levels, self._spread)
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


def _above(least: float) -> tuple[float, float]:
    """Mean and variance of a standard normal variable that is known to be above ``least``."""
    above = float(ndtr(-least))
    if above < 1e-6:
        return least, 0.0
    mean = math.exp(-0.5 * least**2) / math.sqrt(2.0 * math.pi) / above
    return mean, max(1.0 - mean * (mean - least), 0.0)
