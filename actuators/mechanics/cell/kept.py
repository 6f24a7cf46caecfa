"""Answers kept by what they answer: the last ones asked for, in this process."""

from collections import OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

import numpy as np

from actuators.geometry import Body
from actuators.materials import Material

_RESOLUTION = 32
"""Binary digits that positions are told apart by, of the cell's size: what arithmetic leaves behind
is no new cell, and no dimension is as small."""
T = TypeVar("T")


class Kept(Generic[T]):
    """At most ``most`` answers; the one not asked for longest goes first. Threads may share it."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._answers: OrderedDict[Hashable, T] = OrderedDict()
        self._lock = Lock()

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """The answer kept for ``key``, or else what ``make`` gives, which is kept then."""
        with self._lock:
            if key in self._answers:
                self._answers.move_to_end(key)
                return self._answers[key]
        made = make()
        with self._lock:
            self._answers[key] = made
            while len(self._answers) > self._most:
                self._answers.popitem(last=False)
        return made

    def forget(self) -> None:
        """Empty it (benchmarks time a new answer with it)."""
        with self._lock:
            self._answers.clear()


def linear_key(body: Body, materials: tuple[Material, ...]) -> Hashable:
    """What a cell's answer at small strain depends on: positions, filling, sheets, moduli."""
    return _shape_key(body), tuple((m.shear_modulus, m.finite_bulk_modulus) for m in materials)


def nonlinear_key(body: Body, materials: tuple[Material, ...]) -> Hashable:
    """What a cell's answer at finite strain depends on: positions, filling, sheets, laws."""
    return _shape_key(body), repr([(m.law, m.bulk_to_shear) for m in materials])


def _shape_key(body: Body) -> Hashable:
    lines = body.lines
    if body.curved:  # arcs are told apart by the middles of their blocks
        x = lines[0]
        lines = (np.concatenate([x, (x[:-1] + x[1:]) / 2]), *lines[1:])
    corners = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1)
    placed = body.place(corners)
    # a cell of micrometres has as many digits as one of metres; which they are is part of the key
    scale = int(np.frexp(np.abs(placed).max())[1])
    position = np.rint(np.ldexp(placed, _RESOLUTION - scale)).astype(np.int64)
    sheets = tuple((s.plane, s.stiffness) for s in body.membranes)
    return scale, position.tobytes(), body.fill.shape, body.fill.tobytes(), sheets
