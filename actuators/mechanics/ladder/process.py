"""Gaussian processes over questions: what is known of some, told of others."""

import math
from collections.abc import Callable

import numpy as np
from scipy.linalg import cho_solve, cholesky, solve_triangular
from scipy.special import ndtr

from actuators.mechanics.ladder.question import FEATURES

_NEAR = {"coarse": 0.2, "strain": 0.7, "large strain": 0.7, "drained": 0.7, "steps": 1.0,
         "turn": 0.7, "closed": 0.7, "pressed": 0.3, "weight": 0.7, "force": 0.7}  # fmt: skip
Covariance = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], np.ndarray]
_SAME = np.array([_NEAR.get(name, 0.1) for name in FEATURES])
"""Differences of features over which questions are neighbours: as a slider moves, or the
pressure."""


class GaussianProcess:
    """A Gaussian process of mean 0 and what has been observed of it, at places told by features
    (n, f) and a tag (n,). ``covariance``: (k, n) of such places with others."""

    def __init__(self, covariance: Covariance) -> None:
        self._covariance = covariance
        self._x, self._tag = np.zeros((0, len(FEATURES))), np.zeros(0)
        self._y, self._lower = np.zeros(0), np.zeros((0, 0))
        self._weights = np.zeros(0)

    def learning(
        self, x: np.ndarray, tag: np.ndarray, y: np.ndarray, noise: np.ndarray
    ) -> "GaussianProcess":
        """With more observations (m,), of variance ``noise`` each. The factor of those before is
        kept, which makes few more of them cheap."""
        if not len(y):
            return self
        found, n = GaussianProcess(self._covariance), len(self._y)
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


def kernels(a: np.ndarray, b: np.ndarray, reach: float) -> tuple[np.ndarray, np.ndarray]:
    """How alike (n, f) and (m, f) features are, and how near as neighbours: (n, m) each, 1 for the
    same."""
    alike = np.exp(-0.5 * _apart(a, b) / reach**2)
    near = np.exp(-0.5 * _apart(a / _SAME, b / _SAME))
    return alike, near


def _apart(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Squared distances (n, m) of (n, f) from (m, f)."""
    squares = (a**2).sum(axis=1)[:, None] + (b**2).sum(axis=1) - 2.0 * (a @ b.T)
    return np.maximum(squares, 0.0)


def above(least: float) -> tuple[float, float]:
    """Mean and variance of a standard normal variable that is known to be above ``least``."""
    left = float(ndtr(-least))
    if left < 1e-6:
        return least, 0.0
    mean = math.exp(-0.5 * least**2) / math.sqrt(2.0 * math.pi) / left
    return mean, max(1.0 - mean * (mean - least), 0.0)
