"""The door to the sparse direct solver: MKL Pardiso, or SuperLU where there is no MKL.

The tangent is symmetric and, on the way to an answer, indefinite: LDL^T with single pivots
(``mtype=-2``); Cholesky would fail.
"""

import ctypes
import sys
import warnings
from abc import ABC, abstractmethod
from functools import lru_cache
from typing import Any

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spla


class FactorizationError(Exception):
    """The matrix could not be factorised."""


class SymmetricSolver(ABC):
    """Factor of a symmetric matrix given by its upper triangle; the pattern stays until another is
    adopted."""

    @abstractmethod
    def adopt(self, indptr: np.ndarray, indices: np.ndarray) -> None:
        """Take another pattern of the same size (upper triangle, sorted columns)."""

    @abstractmethod
    def factorize(self, values: np.ndarray) -> None:
        """Numerical factorisation of the matrix with these entries."""

    @abstractmethod
    def solve(self, right_side: np.ndarray) -> np.ndarray:
        """Solution for (n,) or (n, k). Raises FactorizationError where there is no factor."""

    @property
    @abstractmethod
    def factorised(self) -> bool:
        """Whether there is a factor, of the last entries that had one."""

    @property
    @abstractmethod
    def entries(self) -> int:
        """Number of entries in the pattern."""

    @property
    @abstractmethod
    def negative_eigenvalues(self) -> int | None:
        """Number of negative eigenvalues of the factorised matrix, None where unknown."""


def open_solver(indptr: np.ndarray, indices: np.ndarray) -> SymmetricSolver:
    """The best solver this machine has for this pattern (upper triangle, sorted columns)."""
    try:
        return PardisoSolver(indptr, indices)
    except ImportError:
        warnings.warn(
            "MKL Pardiso is not available: SuperLU takes over, several times slower. "
            "Install pypardiso where it is offered (x86-64).",
            stacklevel=2,
        )
        return SuperLuSolver(indptr, indices)


@lru_cache(maxsize=1)
def _pardiso() -> Any:
    """MKL's entry point. pypardiso finds and loads the library, walking through the whole
    environment each time it is asked; its own calls copy the pattern every time."""
    from pypardiso import PyPardisoSolver

    return PyPardisoSolver(mtype=-2).libmkl.pardiso  # type: ignore[union-attr]


def _integers(array: np.ndarray) -> Any:
    """Pointer to the data; the array must outlive it."""
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_int32))


def _numbers(array: np.ndarray) -> ctypes.c_void_p:
    """Pointer to the data; the array must outlive it."""
    return ctypes.c_void_p(array.ctypes.data)


class PardisoSolver(SymmetricSolver):
    """MKL Pardiso; the symbolic analysis is done once and kept."""

    def __init__(self, indptr: np.ndarray, indices: np.ndarray) -> None:
        self._call = _pardiso()
        self._handle = np.zeros(64, dtype=np.int64)
        self._perm = np.zeros(1, dtype=np.int32)
        self._iparm = np.zeros(64, dtype=np.int32)
        for number, value in _IPARM.items():
            self._iparm[number - 1] = value
        self._kept = (
            self._handle.ctypes.data_as(ctypes.POINTER(ctypes.c_int64)),
            _integers(self._perm),
            _integers(self._iparm),
        )
        self._analysed = False
        self.adopt(indptr, indices)

    def adopt(self, indptr: np.ndarray, indices: np.ndarray) -> None:
        self.release()
        self._size = len(indptr) - 1
        self._ia = (indptr + 1).astype(np.int32)
        self._ja = (indices + 1).astype(np.int32)
        self._pattern = _integers(self._ia), _integers(self._ja)
        self._values = np.zeros(len(indices))
        self._factorised = False

    def factorize(self, values: np.ndarray) -> None:
        self._values, self._factorised = values, False
        nothing = np.zeros(1)
        if not self._analysed:
            self._run(11, nothing, nothing, 1)
            self._analysed = True
        self._run(22, nothing, nothing, 1)
        self._factorised = True

    @property
    def factorised(self) -> bool:
        return self._factorised

    def solve(self, right_side: np.ndarray) -> np.ndarray:
        if not self._factorised:  # the library would end the process
            raise FactorizationError("factorize comes before solve")
        b = np.asfortranarray(right_side)
        x = np.empty_like(b, order="F")
        self._run(33, b, x, 1 if b.ndim == 1 else b.shape[1])
        return x

    @property
    def entries(self) -> int:
        return len(self._ja)

    @property
    def negative_eigenvalues(self) -> int | None:
        return int(self._iparm[22])

    def release(self) -> None:
        """Give the library's memory back; a later factorisation analyses anew."""
        nothing = np.zeros(1)
        if self._analysed:
            self._run(-1, nothing, nothing, 1)
            self._analysed = self._factorised = False

    def __del__(self) -> None:
        if not sys.is_finalizing():
            self.release()

    def _run(self, phase: int, b: np.ndarray, x: np.ndarray, columns: int) -> None:
        def integer(value: int) -> Any:
            return ctypes.byref(ctypes.c_int32(value))

        error = ctypes.c_int32(0)
        handle, perm, iparm = self._kept
        self._call(
            handle, integer(1), integer(1), integer(-2), integer(phase), integer(self._size),
            _numbers(self._values), *self._pattern, perm, integer(columns), iparm, integer(0),
            _numbers(b), _numbers(x), ctypes.byref(error),
        )  # fmt: skip
        if error.value != 0:
            raise FactorizationError(f"Pardiso ended with error {error.value} in phase {phase}")


# 1-based, as MKL's manual counts
_IPARM = {
    1: 1,  # values below are ours
    2: 2,  # nested dissection
    8: 0,  # iterative refinement (two steps) only after a pivot was perturbed
    10: 8,  # pivots below 1e-8 |A| are perturbed
    11: 0,  # no scaling
    13: 0,  # no matching
    18: -1,
    # single pivots: on indefinite tangents up to and past a limit point residuals are as small as
    # with Bunch-Kaufman's pairs, and a factorisation takes a third less
    21: 0,
    24: 0,  # classic parallel factorisation, which reports the inertia
    25: 0,
    27: 0,
    35: 0,
}


class SuperLuSolver(SymmetricSolver):
    """scipy's LU of the full matrix."""

    def __init__(self, indptr: np.ndarray, indices: np.ndarray) -> None:
        self.adopt(indptr, indices)

    def adopt(self, indptr: np.ndarray, indices: np.ndarray) -> None:
        size = len(indptr) - 1
        self._upper = sp.csr_matrix((np.zeros(len(indices)), indices, indptr), shape=(size, size))
        self._factor: spla.SuperLU | None = None

    def factorize(self, values: np.ndarray) -> None:
        upper = self._upper.copy()
        upper.data[:] = values
        full = (upper + sp.triu(upper, 1).T).tocsc()
        try:
            self._factor = spla.splu(
                full, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}
            )
        except RuntimeError as error:
            raise FactorizationError(str(error)) from error

    @property
    def factorised(self) -> bool:
        return self._factor is not None

    def solve(self, right_side: np.ndarray) -> np.ndarray:
        if self._factor is None:
            raise FactorizationError("factorize comes before solve")
        return self._factor.solve(right_side)

    @property
    def entries(self) -> int:
        return int(self._upper.nnz)

    @property
    def negative_eigenvalues(self) -> int | None:
        return None
