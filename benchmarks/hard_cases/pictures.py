"""Pictures of deformed bodies: their surfaces, painted from back to front, coloured by stretch."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from actuators.mechanics.response import Response

FOLDER = Path("docs/pictures/hard_cases")
VIEW = np.array([[0.80, 0.60, 0.0], [-0.21, 0.28, 0.94], [0.56, -0.75, 0.35]])
"""Rows: to the right, up, towards the eye."""
LIGHT = np.array([0.3, -0.6, 0.75])


def draw(name: str, answer: Response) -> Path | None:
    """Save the last state of an answer as ``name``.png; None where it has no surface."""
    surface = answer.surface
    if surface is None or not answer.path:
        return None
    x = 1e3 * (surface.vertices + surface.displacement[-1]).astype(float)
    corners = x[surface.triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normal, axis=1)
    # towards the eye only: what looks away is hidden behind it
    seen = (normal @ VIEW[2] > 0) & (size > 0)
    corners, normal = corners[seen], normal[seen] / size[seen, None]
    stretch = surface.stretch[-1][surface.triangles[seen]].mean(axis=1)
    order = np.argsort((corners @ VIEW[2]).mean(axis=1))
    flat = corners @ VIEW[:2].T
    top = max(float(stretch.max()), 1.05)
    colour = plt.get_cmap("viridis")((stretch - 1) / (top - 1))
    shade = 0.55 + 0.45 * np.clip(normal @ (LIGHT / np.linalg.norm(LIGHT)), 0, 1)
    colour[:, :3] *= shade[:, None]
    figure, ax = plt.subplots(figsize=(3.4, 2.6), dpi=80)
    # edges in the colour of their faces: without them the page shows through between triangles
    faces = PolyCollection(list(flat[order]), facecolors=colour[order], edgecolors=colour[order])
    faces.set_linewidth(0.4)
    ax.add_collection(faces)
    low, high = flat.reshape(-1, 2).min(axis=0), flat.reshape(-1, 2).max(axis=0)
    margin = 0.04 * (high - low).max()
    ax.set_xlim(low[0] - margin, high[0] + margin)
    ax.set_ylim(low[1] - margin, high[1] + margin)
    ax.set_aspect("equal")
    ax.axis("off")
    largest = float(surface.stretch[-1].max())
    ax.set_title(f"{answer.path[-1].pressure / 1e3:.3g} kPa, stretch to {largest:.2g}", fontsize=8)
    figure.tight_layout(pad=0.3)
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"{name}.png"
    figure.savefig(path, metadata={"Software": None})
    plt.close(figure)
    return path
