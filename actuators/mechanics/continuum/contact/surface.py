"""The outside of a mesh as contact sees it, and how hard it is."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.contact.points import (
    GAUSS_POINTS,
    OBSTACLE_POINTS,
    WALL_POINTS,
    FacePoints,
    contact_areas,
)
from actuators.meshing import HexMesh

TOLERANCE = 2e-4
"""Penetration [body sizes] at the contact pressure to be expected."""
ONSET = 0.5 * TOLERANCE
"""Distance [body sizes] at which contact pressure begins."""


@dataclass(frozen=True)
class ContactLaw:
    """Contact pressure over distance: ``stiffness`` [Pa/m] below -``onset`` [m], none above
    ``onset``, a parabola in between."""

    stiffness: float
    onset: float


def contact_law(
    mesh: HexMesh, materials: Sequence[Material], expected: float = math.inf
) -> ContactLaw:
    """So hard that the ``expected`` pressure [Pa], or the stiffest rubber's shear modulus if that
    is less, presses the surfaces :data:`TOLERANCE` of the body's size into each other."""
    size = float(np.ptp(mesh.nodes, axis=0).max())
    modulus = max(material.shear_modulus for material in materials)
    return ContactLaw(min(modulus, expected) / (TOLERANCE * size), ONSET * size)


@dataclass(frozen=True, eq=False)
class ContactSurface:
    """``faces`` (f, 9) nodes, right-handed about the outward normal; ``areas`` (f, q) [m2] of their
    ``points``, undeformed; ``nodes`` (n, 3) of the mesh, undeformed."""

    nodes: np.ndarray
    faces: np.ndarray
    areas: np.ndarray
    points: FacePoints = GAUSS_POINTS

    def nodal(self, positions: np.ndarray, gaps: np.ndarray, law: ContactLaw) -> np.ndarray:
        """(n,) contact pressure [Pa] of distances ``gaps`` (f, q), averaged to the nodes and
        referred to the area as it is now."""
        load = law_pressure(gaps, law) * self.areas
        now = contact_areas(positions, self.faces, self.points)
        total, share = np.zeros(len(positions)), np.zeros(len(positions))
        weight = np.abs(self.points.values)
        np.add.at(total, self.faces, load @ weight)
        np.add.at(share, self.faces, now @ weight)
        return np.divide(total, share, out=np.zeros_like(total), where=share > 0)


def law_pressure(gaps: np.ndarray, law: ContactLaw) -> np.ndarray:
    """Contact pressure [Pa] at distances ``gaps`` [m]."""
    soft = law.stiffness * (law.onset - np.minimum(gaps, law.onset)) ** 2 / (4 * law.onset)
    return np.where(gaps <= -law.onset, -law.stiffness * gaps, soft)


def outside(mesh: HexMesh, points: FacePoints = OBSTACLE_POINTS) -> ContactSurface:
    """The faces that can touch something: all outer ones but those on the clamp."""
    clamp = np.zeros(len(mesh.nodes), dtype=bool)
    clamp[mesh.clamp_nodes] = True
    faces = mesh.outer_faces.nodes
    faces = np.ascontiguousarray(faces[~clamp[faces].all(axis=1)], dtype=np.int64)
    return ContactSurface(mesh.nodes, faces, contact_areas(mesh.nodes, faces, points), points)


def inside(mesh: HexMesh) -> ContactSurface:
    """The walls of the cavity."""
    faces, points = np.ascontiguousarray(mesh.cavity_faces.nodes, dtype=np.int64), WALL_POINTS
    return ContactSurface(mesh.nodes, faces, contact_areas(mesh.nodes, faces, points), points)
