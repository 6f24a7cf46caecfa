"""CalculiX (``ccx``) on a mesh of ours, by way of the exported deck.

A rigid plate is a block held at its corners; the underside and the free end press on it by
CalculiX's face-to-face penalty contact, as stiff as our law is.
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
from actuators.export.inp_contact import TENSION
from actuators.export.inp_lines import ELEMENTS, SIDES
from actuators.materials import Material
from actuators.mechanics.continuum.contact import ContactLaw
from actuators.mechanics.obstacles import Plate
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh

_MM, _MPA = 1e3, 1e-6


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
    plate: tuple[Plate, ContactLaw] | None = None,
) -> CalculixAnswer:
    """Write the deck, run it, read the end. ``increments``: the line of ``*STATIC`` (first, whole,
    least, largest), the deck's own if None. Raises RuntimeError where CalculiX gives up."""
    text = deck(mesh, materials, scene, element=element)
    if increments is not None:
        text = text.replace("0.1, 1., 1e-6, 0.25", increments)
    if plate is not None:
        text = with_plate(text, mesh, *plate, element=element)
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
    return CalculixAnswer(
        tip=np.array(_last(printed, "displacements")[1:]) / _MM,
        force=None if plate is None else float(np.linalg.norm(_last(printed, "total force"))),
        unknowns=3 * len(kept) - int(held),
        iterations=sum(int(row.split()[3]) for row in status[2:] if row.strip()),
        wall=wall,
        cpu=after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
    )


def with_plate(text: str, mesh: HexMesh, plate: Plate, law: ContactLaw, *, element: str) -> str:
    """The deck with a held block below its plane z = const and the contact pair."""
    if plate.normal != (0.0, 0.0, 1.0):
        raise ValueError("the plate of a deck lies below the body")
    top = (float(mesh.nodes[:, 2].min()) - plate.gap) * _MM
    low, high = mesh.nodes.min(axis=0) * _MM, mesh.nodes.max(axis=0) * _MM
    margin = 0.5 * (high[0] - low[0])
    first = len(mesh.nodes) + 1
    corners = [
        (x, y, z)
        for z in (top - margin, top)
        for x, y in (
            (low[0] - margin, low[1] - margin), (high[0] + margin, low[1] - margin),
            (high[0] + margin, high[1] + margin), (low[0] - margin, high[1] + margin),
        )
    ]  # fmt: skip
    stiffness = law.stiffness * _MPA / _MM
    numbers = range(first, first + 8)
    block = [
        "*NODE, NSET=NPLATE",
        *(f"{n}, {x:.9g}, {y:.9g}, {z:.9g}" for n, (x, y, z) in zip(numbers, corners, strict=True)),
        "*ELEMENT, TYPE=C3D8, ELSET=EPLATE",
        f"{len(mesh.elements) + 1}, {', '.join(map(str, numbers))}",
        "*MATERIAL, NAME=RIGID", "*ELASTIC", "210000., 0.3", "*DENSITY", "1e-9",
        "*SOLID SECTION, ELSET=EPLATE, MATERIAL=RIGID",
        "*BOUNDARY", "NPLATE, 1, 3",
        "*SURFACE, NAME=SLAVE, TYPE=ELEMENT",
        *_slaves(mesh),
        "*SURFACE, NAME=MASTER, TYPE=ELEMENT", f"{len(mesh.elements) + 1}, S2",
        "*SURFACE INTERACTION, NAME=PRESS",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness:.9g}, {TENSION:g}",
        "*CONTACT PAIR, INTERACTION=PRESS, TYPE=SURFACE TO SURFACE", "SLAVE, MASTER",
    ]  # fmt: skip
    before, inflation = text.split("** step 1:", 1)
    asked = "*NODE PRINT, NSET=NPLATE, TOTALS=ONLY\nRF\n*END STEP"
    return before + "\n".join(block) + "\n** step 1:" + inflation.replace("*END STEP", asked)


def _slaves(mesh: HexMesh) -> list[str]:
    """Faces of the underside, as element and side."""
    faces = mesh.outer_faces
    down = (faces.local == 4) & (mesh.box[faces.element, 2] == 0)
    return [
        f"{e + 1}, S{SIDES[side]}"
        for e, side in zip(faces.element[down], faces.local[down], strict=True)
    ]


def _last(printed: str, title: str) -> list[float]:
    """Numbers of the first row after the last heading that begins with ``title``."""
    body = printed[printed.rindex(f" {title}") :].splitlines()[1:]
    row = next(line for line in body if line.strip())
    return [float(x) for x in row.split()]
