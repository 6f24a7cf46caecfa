"""What a scene does to a rod: weight, forces, and bodies to press against."""

import numpy as np

from actuators.design import Design
from actuators.mechanics.rod.chain import Chain, Obstacles, no_obstacles
from actuators.mechanics.rod.pieces import Layout, end_height, outline
from actuators.mechanics.scene import Scene

DEPTH = 5e-5
"""How far the force to be expected presses an obstacle's surface in, in lengths of the body: a
twentieth of what the 3D solver's error estimate resolves."""
SPREAD = 1 / 8
"""Share of the length over which that force is expected."""


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
    if scene.plate is None and scene.cylinder is None:
        return no_obstacles(pieces)
    across, above, share = _touching_points(design, layout)
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


def _touching_points(design: Design, layout: Layout) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Edges and middle of underside and top at every border, and the length that each stands
    for: (s + 1, 6) each, by Simpson's rule across."""
    width, height = outline(design, layout.stations)
    ends = np.pad(layout.length / 2, 1)
    along = ends[:-1] + ends[1:]
    across = width[:, None] / 2 * np.array([-1.0, 0.0, 1.0, -1.0, 0.0, 1.0])
    above = np.broadcast_to([0.0, 0.0, 0.0, height, height, height], across.shape)
    weight = np.array([1.0, 4.0, 1.0, 1.0, 4.0, 1.0]) / 6
    return across, np.ascontiguousarray(above), along[:, None] * weight
