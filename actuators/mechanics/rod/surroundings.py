"""What a scene does to a rod: weight, forces, and bodies to press against."""

import numpy as np

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.mechanics.obstacles import Cylinder
from actuators.mechanics.rod.chain import Chain, Obstacles, no_obstacles
from actuators.mechanics.rod.pieces import FINEST, Layout, end_height, outline
from actuators.mechanics.scene import Scene

DEPTH = 5e-5
"""How far the force to be expected presses an obstacle's surface in, in lengths of the body: a
twentieth of what the 3D solver's error estimate resolves."""
SPREAD = 1 / 8
"""Share of the length over which that force is expected."""
UNSEEN = 2e-4
"""How far a cylinder may enter between two points of the rod [lengths of the body]."""
MOST_PIECES, MOST_ACROSS = 320, 33
"""Pieces, and points across, that are looked at for that."""
BESIDE_CLAMP = 1.0
"""Of the body's height: so near its clamp it hardly moves, and the rod, which tells what the clamp
does in a piece without length, says nothing of where its surface is."""
ACROSS = 1 - 1e-9
"""Part of a cylinder's axis along X2 from which it lies straight across the body."""


def chain_of(design: Design, layout: Layout, scene: Scene) -> Chain:
    """Loads of the scene on the pieces."""
    pull = np.zeros(3) if scene.gravity is None else np.array(scene.gravity, dtype=float)
    size = float(np.linalg.norm(pull))
    middle = layout.stations[:-1] + layout.length / 2
    tip = np.zeros(3) if scene.tip_force is None else np.array(scene.tip_force, dtype=float)
    return Chain(
        length=layout.length,
        weight=layout.mass * size,
        height=layout.mass_height,
        gravity=pull / size if size > 0 else np.array([0.0, 0.0, -1.0]),
        width=outline(design, middle)[0],
        outside=float(scene.outside_pressure),
        tip_force=tip,
        tip_height=end_height(design) / 2,
    )


def obstacles_of(design: Design, layout: Layout, scene: Scene, moment: float) -> Obstacles:
    """The scene's plate and cylinder, in this order. ``moment``: the largest with which the body
    presses [N m]; with weight and tip force it says how hard the surfaces must be."""
    pieces = len(layout.length)
    if not scene.has_obstacle:
        return no_obstacles(pieces)
    across, above, share = _touching_points(design, layout, scene.cylinder)
    kinds: list[tuple[int, np.ndarray, np.ndarray, float]] = []
    if scene.plate is not None:
        normal = np.array(scene.plate.normal, dtype=float)
        at = np.stack(
            [np.broadcast_to(layout.stations[:, None], across.shape), across, above], axis=-1
        )
        kinds.append((0, normal * ((at @ normal).min() - scene.plate.gap), normal, 0.0))
    if scene.cylinder is not None:
        bar = scene.cylinder
        kinds.append((1, np.array(bar.centre), np.array(bar.axis), bar.radius))
    gravity = np.linalg.norm(scene.gravity or (0.0, 0.0, 0.0))
    load = gravity * layout.mass.sum() + np.linalg.norm(scene.tip_force or (0.0, 0.0, 0.0))
    width = outline(design, layout.stations)[0].max()
    load += abs(scene.outside_pressure) * width * design.length
    load += 3 * abs(moment) / design.length  # of a cantilever held at its tip: 3/2, and more
    length = design.length
    return Obstacles(
        across=across,
        above=above,
        share=share,
        kind=np.array([k for k, *_ in kinds], dtype=np.int64),
        place=np.array([p for _, p, _, _ in kinds], dtype=float),
        direction=np.array([d for _, _, d, _ in kinds], dtype=float),
        radius=np.array([r for *_, r in kinds], dtype=float),
        # nothing presses where nothing acts, however hard the surfaces are
        stiffness=(float(load) or 1.0) / (SPREAD * length) / (DEPTH * length),
        softness=DEPTH * length / 2,
    )


def finest_of(design: Design, scene: Scene) -> int:
    """Least number of pieces with which no cylinder of the scene slips in between their borders."""
    if scene.cylinder is None:
        return FINEST
    wanted = np.ceil(design.length / _apart(design, scene.cylinder))
    return int(np.clip(wanted, FINEST, MOST_PIECES))


def refuse_needles(design: Design, scene: Scene) -> None:
    """Raises :class:`QuestionError` for a cylinder so thin beside a body so long that it could slip
    between the rod's points even so."""
    if scene.cylinder is None:
        return
    apart = design.length / MOST_PIECES / 2  # twice as far as it should be is borne
    thinnest = apart**2 / (8 * UNSEEN * design.length)
    if scene.cylinder.radius < thinnest:
        raise QuestionError(
            f"The cylinder's radius is {scene.cylinder.radius * 1e3:.3g} mm: beside a body of "
            f"{design.length * 1e3:.4g} mm it would slip between the places where the rod feels "
            "for it.",
            field="cylinder", value=f"{scene.cylinder.radius * 1e3:.3g} mm",
            mend=f"Take a radius of {thinnest * 1e3:.2g} mm or more, or use the rung fe.",
        )  # fmt: skip


def _apart(design: Design, cylinder: Cylinder) -> float:
    """How far apart two points on a straight line may be [m], for a cylinder that touches between
    them to have entered by :data:`UNSEEN` when it reaches one."""
    return float(np.sqrt(8 * cylinder.radius * UNSEEN * design.length))


def _touching_points(
    design: Design, layout: Layout, cylinder: Cylinder | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points across underside and top at every border, and the length that each stands for: (s + 1,
    m) each, by Simpson's rule. Edges and middles meet a plate and a bar across the body; bars that
    lie otherwise are met by as many as it takes, on the sides too."""
    width, height = outline(design, layout.stations)
    ends = np.pad(layout.length / 2, 1)
    along = ends[:-1] + ends[1:]
    count, beside = 3, 0
    if cylinder is not None and abs(cylinder.axis[1]) < ACROSS:
        apart = _apart(design, cylinder)
        count = int(np.clip(2 * np.ceil(width.max() / apart / 2) + 1, 3, MOST_ACROSS))
        beside = int(np.clip(np.ceil(height / apart) - 1, 0, MOST_ACROSS))
    line = np.linspace(-1.0, 1.0, count)
    simpson = np.where(np.arange(count) % 2 == 1, 4.0, 2.0)
    simpson[[0, -1]] = 1.0
    simpson /= simpson.sum()
    side = np.repeat([-1.0, 1.0], beside)
    level = np.tile(np.arange(1, beside + 1) / (beside + 1), 2)
    across = width[:, None] / 2 * np.concatenate([line, line, side])
    up = height * np.concatenate([np.zeros(count), np.ones(count), level])
    share = np.concatenate([simpson, simpson, np.full(2 * beside, 1 / max(beside, 1))])
    along = np.where(layout.stations < BESIDE_CLAMP * height, 0.0, along)
    return across, np.ascontiguousarray(np.broadcast_to(up, across.shape)), along[:, None] * share
