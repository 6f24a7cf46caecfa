"""CalculiX (``ccx``) on a mesh of ours, by way of the exported deck.

A rigid plate is the deck's: a block with its corners held, pressed on by CalculiX's face-to-face
penalty contact, as stiff as our law is.
"""

import resource
import subprocess
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from actuators.export.inp import deck
from actuators.export.inp_lines import ELEMENTS, MM
from actuators.materials import Material
from actuators.mechanics.continuum.contact import ContactLaw
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh


@dataclass(frozen=True)
class CalculixAnswer:
    """``tip`` (3,) [m]; ``force`` on the plate [N], of the mesh's part, None without one;
    ``iterations`` of all increments; ``wall``, ``cpu`` [s]."""

    tip: np.ndarray
    force: float | None
    unknowns: int
    iterations: int
    wall: float
    cpu: float


def run_calculix(
    mesh: HexMesh,
    materials: Sequence[Material],
    scene: Scene,
    *,
    element: str = "C3D20R",
    increments: str | None = None,
    law: ContactLaw | None = None,
) -> CalculixAnswer:
    """Write the deck, run it, read the end. ``increments``: the line of ``*STATIC`` (first, whole,
    least, largest), the deck's own if None; ``law``: of contact, the deck's own if None. Raises
    RuntimeError where CalculiX gives up."""
    text = deck(mesh, materials, scene, element=element, law=law)
    if increments is not None:
        text = text.replace("0.1, 1., 1e-6, 0.25", increments)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "model.inp").write_text(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        wall = time.perf_counter()
        done = subprocess.run(["ccx", "model"], cwd=folder, capture_output=True, check=False)
        wall = time.perf_counter() - wall
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        printed = Path(folder, "model.dat").read_text()
        status = Path(folder, "model.sta").read_text().split("\n")
    if done.returncode != 0 or b"Job finished" not in done.stdout:
        raise RuntimeError(f"CalculiX gave up: {done.stdout[-200:].decode(errors='replace')}")
    kept = np.unique(mesh.elements[:, ELEMENTS[element]])
    held = 3 * np.isin(mesh.clamp_nodes, kept).sum() + np.isin(mesh.symmetry_nodes, kept).sum()
    force = None
    if scene.plate is not None or scene.cylinder is not None:
        force = float(np.linalg.norm(_last(printed, "total force")))
    return CalculixAnswer(
        tip=np.array(_last(printed, "displacements")[1:]) / MM,
        force=force,
        unknowns=3 * len(kept) - int(held),
        iterations=sum(int(row.split()[3]) for row in status[2:] if row.strip()),
        wall=wall,
        cpu=after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
    )


def _last(printed: str, title: str) -> list[float]:
    """Numbers of the first row after the last heading that begins with ``title``."""
    body = printed[printed.rindex(f" {title}") :].splitlines()[1:]
    row = next(line for line in body if line.strip())
    return [float(x) for x in row.split()]
