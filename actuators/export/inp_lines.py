"""Lines of an input deck: units, rows of numbers, sides of elements."""

from collections.abc import Iterable, Mapping

import numpy as np

from actuators.meshing import Faces, HexMesh

MM, MPA = 1e3, 1e-6
SIDES = (6, 4, 3, 5, 1, 2)
"""Abaqus's number of our faces x-, x+, y-, y+, z-, z+."""
_CORNERS = (0, 2, 8, 6, 18, 20, 26, 24)
_EDGES = (1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15)
ELEMENTS: Mapping[str, tuple[int, ...]] = {
    "C3D20R": (*_CORNERS, *_EDGES),
    "C3D20": (*_CORNERS, *_EDGES),
    "C3D8": _CORNERS,
}
"""Element types and the local nodes (i + 3 j + 9 k) they keep, in Abaqus's order."""


def rows(values: Iterable[object], width: int) -> list[str]:
    """Lines of ``width`` entries; a line that goes on ends in a comma where it must."""
    texts = [str(value) for value in values]
    lines = [texts[k : k + width] for k in range(0, len(texts), width)]
    return [", ".join(row) + ("," if width > 1 else "") for row in lines[:-1]] + [
        ", ".join(row) for row in lines[-1:]
    ]


def node_rows(numbers: Iterable[int], positions: np.ndarray) -> list[str]:
    """``number, x, y, z`` of ``positions`` (n, 3) [m]."""
    return [
        f"{n}, {x:.9g}, {y:.9g}, {z:.9g}"
        for n, (x, y, z) in zip(numbers, positions * MM, strict=True)
    ]


def surface(name: str, faces: Faces) -> list[str]:
    """A surface of sides of elements."""
    sides = [
        f"{element + 1}, S{SIDES[local]}"
        for element, local in zip(faces.element, faces.local, strict=True)
    ]
    return [f"*SURFACE, NAME={name}, TYPE=ELEMENT", *sides]


def chosen_faces(faces: Faces, which: np.ndarray) -> Faces:
    """Those of ``faces`` that ``which`` (mask or indices) names."""
    return Faces(faces.element[which], faces.local[which], faces.nodes[which])


def middles(mesh: HexMesh, faces: Faces) -> tuple[np.ndarray, np.ndarray]:
    """(f, 3) middles and unit outward normals of faces, undeformed."""
    corner = mesh.nodes[faces.nodes]
    normal = np.cross(corner[:, 5] - corner[:, 3], corner[:, 7] - corner[:, 1])
    return corner[:, 4], normal / np.linalg.norm(normal, axis=1, keepdims=True)
