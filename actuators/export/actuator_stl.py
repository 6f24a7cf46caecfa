"""The actuator as binary STL in mm: rubber with its closed cavity, to print or to look at."""

import numpy as np

from actuators.design import BellowsDesign, Design, SlabDesign
from actuators.geometry import build_body
from actuators.geometry.surface import Surface, body_surface

CHORD_ERROR = 0.01e-3
"""How far an arc may bulge past its chords [m]."""

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def actuator_stl(design: Design) -> dict[str, bytes]:
    """``actuator.stl``."""
    max_edge = np.inf
    if isinstance(design, SlabDesign) and design.planform == "ellipse":
        max_edge = np.sqrt(8 * design.side_radius * CHORD_ERROR)
    parts = (1, 1, 1)
    if isinstance(design, BellowsDesign):
        chord = np.arccos(1 - CHORD_ERROR / design.wave.crown_outside)
        parts = (int(np.ceil(np.pi / 4 / chord)), 1, 1)  # of a quarter circle
    surface = body_surface(build_body(design), max_edge=max_edge, parts=parts)
    return {"actuator.stl": encode(surface, f"{design.title} {design.digest[:12]}")}


def encode(surface: Surface, title: str) -> bytes:
    """Binary STL in mm. The header must not begin with "solid", which marks the text form."""
    corners = surface.vertices[surface.triangles] * 1e3
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    records = np.zeros(len(corners), dtype=_RECORD)
    records["normal"] = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    records["corners"] = corners
    header = f"STL in mm, Pneustudio, {title}".encode("ascii", "replace")[:80].ljust(80)
    return header + np.uint32(len(corners)).astype("<u4").tobytes() + records.tobytes()
