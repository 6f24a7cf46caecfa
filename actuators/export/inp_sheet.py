"""An embedded sheet in a deck: springs between neighbouring nodes along X1.

A spring of CalculiX and Abaqus (SPRINGA) acts along the line through its nodes wherever they move:
k/2 (l - l0)^2 is the sheet's energy K/2 (lambda - 1)^2 on a strip of width w, with k = K w / l0.
It bends freely and resists nothing across, as our sheet does.
"""

import numpy as np

from actuators.export.inp_lines import ELEMENTS
from actuators.meshing import HexMesh

_N_MM = 1e-3


def sheet_cards(mesh: HexMesh, element: str, first: int) -> list[str]:
    """Springs with element numbers from ``first`` on; no lines for a body without a sheet."""
    ends, stiffness = _springs(mesh, quadratic=len(ELEMENTS[element]) == 20)
    lines: list[str] = []
    # springs of one stiffness share a set: a few widths times a few lengths
    values, which = np.unique([f"{value:.6e}" for value in stiffness * _N_MM], return_inverse=True)
    number = first
    for group, value in enumerate(values):
        name = f"SHEET_{group + 1}"
        lines.append(f"*ELEMENT, TYPE=SPRINGA, ELSET={name}")
        for a, b in ends[which == group]:
            lines.append(f"{number}, {a + 1}, {b + 1}")
            number += 1
        lines += [f"*SPRING, ELSET={name}", "", value]
    if lines:
        lines.insert(0, "** embedded sheet: it cannot stretch along X1, and bends freely")
    return lines


def _springs(mesh: HexMesh, *, quadratic: bool) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (s, 2) at the ends of each spring, and k (s,) [N/m]."""
    faces = mesh.membrane_faces
    upper = np.where(faces.local == 5, 18, 0)[:, None]
    along = ((0, 1), (1, 2)) if quadratic else ((0, 2),)
    ends: list[np.ndarray] = []
    stiffness: list[np.ndarray] = []
    for near, far in along:
        for row, other in ((0, 6), (6, 0)):
            local = np.array([near + row, far + row, near + other, far + other]) + upper
            nodes = np.take_along_axis(mesh.elements[faces.element], local, axis=1)
            x = mesh.nodes[nodes]
            span, across = x[:, 1] - x[:, 0], 0.5 * (x[:, 2] - x[:, 0] + x[:, 3] - x[:, 1])
            length = np.linalg.norm(span, axis=1)
            # half of the strip between this row and the other one
            width = 0.5 * np.linalg.norm(np.cross(span, across), axis=1) / length
            ends.append(nodes[:, :2])
            stiffness.append(mesh.membrane_stiffness * width / length)
    pairs, where = np.unique(np.sort(np.concatenate(ends), axis=1), axis=0, return_inverse=True)
    total = np.zeros(len(pairs))
    np.add.at(total, where.ravel(), np.concatenate(stiffness))
    return pairs, total
