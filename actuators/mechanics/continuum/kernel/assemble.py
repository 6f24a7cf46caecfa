"""All elements of a mesh: residual and condensed tangent, in parallel and reproducibly.

Elements of one colour share no node, so that threads may add to the same arrays; the order of
additions does not depend on the number of threads.
"""

from typing import Any

import numpy as np
from numba import njit, prange

from actuators.mechanics.continuum.kernel.cavity import add_face_hessian, face_volume
from actuators.mechanics.continuum.kernel.condense import (
    CENTRE,
    INNER,
    OUTER,
    condense_element,
)
from actuators.mechanics.continuum.kernel.element import integrate_element
from actuators.mechanics.continuum.kernel.membrane import add_membrane
from actuators.mechanics.continuum.kernel.tensor import BLOCK, BLOCKS, PLACE


@njit(cache=True)
def _add_pressure(
    x: np.ndarray,
    u: np.ndarray,
    pressure: float,
    local_faces: np.ndarray,
    face_nodes: np.ndarray,
    want_tangent: bool,
    r: np.ndarray,
    k: np.ndarray,
) -> None:
    """Work of the cavity pressure on one element: r -= p dV/du, k -= p d2V/du2."""
    at, gradient = np.empty((9, 3)), np.empty((9, 3))
    for side in local_faces:
        for n in range(9):
            for i in range(3):
                at[n, i] = x[face_nodes[side, n], i] + u[face_nodes[side, n], i]
                gradient[n, i] = 0.0
        face_volume(at, gradient)
        for n in range(9):
            for i in range(3):
                r[face_nodes[side, n], i] -= pressure * gradient[n, i]
        if want_tangent:
            hessian = np.zeros((9, 3, 9, 3))
            add_face_hessian(at, -pressure, hessian)
            for n in range(9):
                for m in range(9):
                    for i in range(3):
                        for j in range(i, 3):
                            place = PLACE[face_nodes[side, n], face_nodes[side, m]]
                            k[place, BLOCK[i, j]] += hessian[n, i, m, j]


@njit(cache=True, parallel=True)
def assemble(
    nodes: np.ndarray,
    displacement: np.ndarray,
    element_pressure: np.ndarray,
    elements: np.ndarray,
    region: np.ndarray,
    codes: Any,
    counts: Any,
    coefficients: np.ndarray,
    compliance: np.ndarray,
    body_force: np.ndarray,
    cavity_pressure: float,
    face_start: np.ndarray,
    face_local: np.ndarray,
    face_nodes: np.ndarray,
    sheet_start: np.ndarray,
    sheet_local: np.ndarray,
    sheet_stiffness: np.ndarray,
    sheet_force: np.ndarray,
    colour_start: np.ndarray,
    colour_order: np.ndarray,
    scatter: np.ndarray,
    want_tangent: bool,
    sheets_flat: bool,
    residual: np.ndarray,
    inner_residual: np.ndarray,
    values: np.ndarray,
    recover: np.ndarray,
    inner_inverse: np.ndarray,
    least: np.ndarray,
    sheet_gap: np.ndarray,
    sheet_area: np.ndarray,
    sheet_gradient: np.ndarray,
) -> None:
    """Fill residuals (n, 3), (m, 4), matrix ``values`` and the data of the condensation.

    ``compliance`` (regions, 2): 1/kappa in the equations, and in the tangent. ``face_*``: sides of
    each element on the cavity, ``sheet_*``: on embedded sheets; ``sheets_flat``: see
    :func:`add_membrane`.
    ``scatter`` (m, 3081): place of each entry of an element's upper triangle in ``values``, or -1.
    ``least`` (m,): the least J of each element; not positive where the state is inadmissible.
    """
    residual[:] = 0.0
    if want_tangent:
        values[:] = 0.0
    for colour in range(len(colour_start) - 1):
        for at in prange(colour_start[colour], colour_start[colour + 1]):
            e = colour_order[at]
            x, u = np.empty((27, 3)), np.empty((27, 3))
            for n in range(27):
                for i in range(3):
                    x[n, i] = nodes[elements[e, n], i]
                    u[n, i] = displacement[elements[e, n], i]
            r, rq = np.empty((27, 3)), np.empty(4)
            k = np.empty((729, BLOCKS))
            b, mass = np.empty((27, 3, 4)), np.empty((4, 4))
            s = region[e]
            least[e] = integrate_element(
                x, u, element_pressure[e], codes[s], coefficients[s], counts[s],
                compliance[s], body_force[s], want_tangent, r, rq, k, b, mass,
            )  # fmt: skip
            if least[e] <= 0.0:
                continue
            _add_pressure(
                x, u, cavity_pressure, face_local[face_start[e] : face_start[e + 1]], face_nodes,
                want_tangent, r, k,
            )  # fmt: skip
            for sheet in range(sheet_start[e], sheet_start[e + 1]):
                add_membrane(
                    x, u, sheet_stiffness[sheet], sheet_force[sheet],
                    face_nodes[sheet_local[sheet]], want_tangent, sheets_flat, r, k,
                    sheet_gap[sheet], sheet_area[sheet], sheet_gradient[sheet],
                )  # fmt: skip
            for n in range(27):
                for i in range(3):
                    residual[elements[e, n], i] += r[n, i]
            for m in range(4):
                inner_residual[e, m] = rq[m]
            if want_tangent:
                stiffness = np.empty((OUTER, OUTER))
                if not condense_element(k, b, mass, stiffness, recover[e], inner_inverse[e]):
                    least[e] = -1.0
                    continue
                t = 0
                for i in range(OUTER):
                    for j in range(i, OUTER):
                        place = scatter[e, t]
                        if place >= 0:
                            values[place] += stiffness[i, j]
                        t += 1


__all__ = ["CENTRE", "INNER", "OUTER", "assemble"]
