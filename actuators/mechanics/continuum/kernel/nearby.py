"""Pairs of faces that are near each other and look at each other."""

import numpy as np
from numba import njit


@njit(cache=True)
def _apart(a: np.ndarray, b: np.ndarray) -> float:
    return np.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2)


@njit(cache=True)
def _common(faces: np.ndarray, a: int, b: int) -> bool:
    for n in faces[a]:
        for m in faces[b]:
            if n == m:
                return True
    return False


@njit(cache=True)
def _may_touch(
    a: int,
    b: int,
    middle: np.ndarray,
    normal: np.ndarray,
    radius: np.ndarray,
    level: float,
    far: float,
) -> bool:
    """Whether nothing but air was between two undeformed faces, or they were far apart."""
    distance = _apart(middle[a], middle[b])
    if distance - radius[a] - radius[b] > far:
        return True
    one = other = 0.0
    for i in range(3):
        one += (middle[b, i] - middle[a, i]) * normal[a, i]
        other += (middle[a, i] - middle[b, i]) * normal[b, i]
    return one > level * distance and other > level * distance


@njit(cache=True)
def near_pairs(
    order: np.ndarray,
    middle: np.ndarray,
    normal: np.ndarray,
    radius: np.ndarray,
    rest_middle: np.ndarray,
    rest_normal: np.ndarray,
    rest_radius: np.ndarray,
    faces: np.ndarray,
    reach: float,
    opposed: float,
    level: float,
    far: float,
) -> np.ndarray:
    """(k, 2) pairs a < b of ``faces`` (f, 9) whose enclosing spheres are closer than ``reach``,
    whose normals' product is below ``opposed``, and that may touch. ``order`` (f,): faces by where
    their spheres begin along X1."""
    found = np.empty((1024, 2), dtype=np.int64)
    count = 0
    for at in range(len(order)):
        one = order[at]
        end = middle[one, 0] + radius[one] + reach
        for further in range(at + 1, len(order)):
            other = order[further]
            if middle[other, 0] - radius[other] > end:
                break
            product = 0.0
            for i in range(3):
                product += normal[one, i] * normal[other, i]
            if product >= opposed:
                continue
            if _apart(middle[one], middle[other]) >= radius[one] + radius[other] + reach:
                continue
            if not _may_touch(one, other, rest_middle, rest_normal, rest_radius, level, far):
                continue
            if _common(faces, one, other):
                continue
            if count == len(found):
                more = np.empty((2 * count, 2), dtype=np.int64)
                more[:count] = found
                found = more
            found[count, 0], found[count, 1] = min(one, other), max(one, other)
            count += 1
    return found[:count].copy()
