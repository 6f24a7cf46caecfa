"""What a designer must read about an answer of cell and rod."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from actuators.materials import material
from actuators.mechanics.cell.inflated import CellPath
from actuators.mechanics.cell.row import row_cells
from actuators.mechanics.cell_rod.chambers import is_sucked_empty
from actuators.mechanics.cell_rod.pressed import force_estimate, is_against_the_clamp
from actuators.mechanics.cell_rod.trust import (
    BEYOND_TRUST,
    NEAR_THE_LIMIT,
    trusted_to,
    unlike,
)
from actuators.mechanics.response import Effect, Outcome, PathPoint
from actuators.mechanics.rod.effects import is_plain, weight_change
from actuators.mechanics.rod.pieces import end_height
from actuators.mechanics.rod.solve import weightless
from actuators.mechanics.scene import Scene
from actuators.quantities import kilopascals, two_digits

if TYPE_CHECKING:
    from actuators.mechanics.cell_rod.answer import Question, Solved

BENDING = 2
AT_THE_LIMIT = 0.99
"""Share of the chambers' limit from which on the loads have no part in it."""
UNMET = 1e-5
"""Share of a prescribed volume that is not met of which a reader must know."""
SHOWN = 0.03
"""Strain by loads that a reader of the largest stretch must know of."""


def advice_of(
    paths: Sequence[CellPath], scene: Scene, pressures: np.ndarray, found: int, *,
    loads: float, short: bool, crushed: float = 0.0,
) -> tuple[Outcome, str | None]:  # fmt: skip
    """How the path ended, and what to do about it. ``pressures`` (k,), of which the first
    ``found`` were; ``loads``: share of weight and outer loads borne before any inflation;
    ``crushed``: strain by what loads bend the body, if that is more than can be told."""
    limits = [p.limit_pressure for p in paths if p.limit_pressure is not None]
    gives_way = (
        found < len(pressures)
        and len(limits) > 0
        and abs(pressures[found]) > NEAR_THE_LIMIT * min(map(abs, limits))
    )
    if crushed > 0.0 and not gives_way:  # near its limit a chamber has no stiffness to bear loads
        return Outcome.STALLED, (
            f"The scene's loads bend the body so sharply (its top would be strained by "
            f"{crushed:.0%}) that its chambers are crushed or folded, which no rod tells. Lower "
            f"{_named_loads(scene)}, make the body stiffer, or use the rung fe."
        )
    if loads < 1.0:
        return Outcome.STALLED, (
            f"The rod found no equilibrium under {_named_loads(scene)}, before any inflation. "
            f"Shown is the body under {loads:.0%} of that. Lower these loads, make the body "
            "stiffer, or use the rung fe."
        )
    if found < len(pressures):
        lost = pressures[found] / 1e3
        if gives_way and abs(pressures[found]) >= AT_THE_LIMIT * min(map(abs, limits)):
            return Outcome.LIMIT_POINT, _beyond_the_limit(min(limits, key=abs), scene)
        if gives_way:
            return Outcome.LIMIT_POINT, (
                f"Under the scene's loads the body gives way at {lost:.4g} kPa, before its "
                f"chambers alone would, at {min(limits, key=abs) / 1e3:.4g} kPa: there their "
                "pressure has its extreme. Stay below, lower the loads, thicken the roof or take a "
                "stiffer top material."
            )
        return Outcome.STALLED, (
            f"The rod found no equilibrium under the scene's loads at {lost:.4g} kPa. Reduce the "
            "loads, stiffen the body, or use the rung fe."
        )
    if not short:
        return Outcome.CONVERGED, None
    if limits:
        return Outcome.LIMIT_POINT, _beyond_the_limit(min(limits, key=abs), scene)
    end = pressures[-1] / 1e3
    found_to = f"The periodic chamber was found {'up' if end >= 0.0 else 'down'} to {end:.4g} kPa"
    wrinkled = [p.wrinkles_from for p in paths if p.wrinkles_from is not None]
    if wrinkled:
        return Outcome.STALLED, (
            f"{found_to} only: its embedded layer is pressed together so hard from "
            f"{min(wrinkled, key=abs) / 1e3:.3g} kPa on that shapes with and without wrinkles lie "
            "side by side. That is no limit of the pressure. Use the rung fe beyond, or take a "
            "stiffer rubber."
        )
    if any(map(is_sucked_empty, paths)):
        return Outcome.STALLED, (
            f"{found_to} only: it is sucked empty there, and the walls inside it press on each "
            "other. Ask for less suction, or use the rung fe, which holds them apart."
        )
    return Outcome.STALLED, f"{found_to} only. Use the rung fe beyond."


def _beyond_the_limit(limit: float, scene: Scene) -> str:
    """Advice where the chamber's pressure has its maximum, of suction its minimum [Pa]."""
    beyond, kept, extreme, change = (
        ("above", "below", "maximum", "balloon")
        if limit >= 0.0
        else ("below", "above", "minimum", "collapse")
    )
    if scene.pressure_to is None:
        return (
            f"No equilibrium {beyond} {kilopascals(limit)} kPa: there the chamber's pressure has "
            f"its {extreme}. Use the rung fe to go on: beyond it chambers {change} unequally."
        )
    return (
        f"No equilibrium {beyond} {kilopascals(limit)} kPa ({kilopascals(scene.pressure_to)} kPa "
        f"were asked for): there the chamber's pressure has its {extreme}, and beyond it the "
        f"chambers would {change}. Stay {kept} it, thicken the roof or take a stiffer top material."
    )


def _named_loads(scene: Scene) -> str:
    loads = ["its own weight"] if any(scene.gravity or ()) else []
    if scene.outside_pressure != 0.0:
        loads.append(f"{kilopascals(scene.outside_pressure)} kPa outside")
    if scene.tip_force is not None:
        loads.append(f"{float(np.linalg.norm(scene.tip_force)):.3g} N on the tip")
    return " and ".join(loads) or "no load"


def cell_rod_effects(question: Question, solved: Solved) -> tuple[Effect, ...]:
    """Which effects the answer holds."""
    scene = question.scene
    contact = solved.chambers.contact
    walls = _walls(contact, question.paths)
    return (
        _gravity(question, solved),
        Effect("large_rotation", True, "the rod's segments are exact pieces of helix"),
        Effect("finite_strain", True, "the chamber is inflated by nonlinear finite elements"),
        Effect("self_contact", contact is not None, walls),
        *(
            Effect(f"{name}_contact", True, _pressed(question, solved, n, name))
            for n, name in enumerate(_obstacles(scene))
        ),
        *(
            Effect(name, True, "a load of the rod")
            for name, there in (
                ("outside_pressure", scene.outside_pressure != 0.0),
                ("tip_force", scene.tip_force is not None),
            )
            if there
        ),
        Effect("shear", True, "floor and roof bend between the walls under transverse force"),
        _ends(question),
    )  # fmt: skip


def cell_rod_notes(question: Question, solved: Solved) -> tuple[str, ...]:
    """Findings of the cells, and of the rod's obstacles."""
    notes = list(dict.fromkeys(note for path in question.paths for note in path.notes))
    last = float(solved.pressures[len(solved.path.strains) - 1])
    notes += _stretched_far(question, last)
    reached = solved.pressures[: len(solved.path.strains)]
    trusted = trusted_to(question.design, question.paths, reached)
    if trusted is not None:
        notes.append(unlike(question, trusted))
    if solved.missed > UNMET:
        notes.append(
            f"The volumes asked for are met to {100 * solved.missed:.2g} % only: under its loads "
            "the body may jump from one shape to another there, with no pressure in between."
        )
    if len(solved.path.strains):
        strain = float(bent_strains(question, solved).max())
        if strain > SHOWN:
            notes.append(
                "The largest stretch is that of the chamber under pressure alone: what loads bend "
                f"it by, about {100 * strain:.0f} % at its top, is not in it."
            )
    pressed = force_estimate(question, solved)
    contact = solved.chambers.contact
    if pressed is not None and contact is not None and (contact > 0.0).any():
        notes.append(
            "The contact pressure is that of neighbouring walls: what the body presses on an "
            "obstacle with is not in it, and in 3D it is."
        )
    if pressed is not None and is_against_the_clamp(question):
        notes.append(
            "An obstacle touches the body beside its clamp, where the rod feels none: in 3D the "
            f"force on it was larger by up to {two_digits(100 * pressed)} %. Use the rung fe for "
            "it."
        )
    depth = solved.path.penetration.max(initial=0.0)
    if depth > 2e-3 * question.design.length:
        notes.append(f"The rod enters an obstacle by up to {depth * 1e3:.2g} mm.")
    return tuple(notes)


def mostly_sag(points: Sequence[PathPoint], expected: float) -> list[str]:
    """That the ``expected`` error, a part of the tip's way, may exceed what inflation does."""
    from actuators.mechanics.continuum.findings import sag_notes  # loads the 3D solver's kernels

    return sag_notes(points, expected) if expected < BEYOND_TRUST else []


def bent_strains(question: Question, solved: Solved) -> np.ndarray:
    """Strain (k,) at the body's top by what loads bend its chambers, largest along it."""
    strains = solved.path.strains
    free = question.layout.free(solved.chambers.free[: len(strains)])
    bent = np.abs(strains[..., BENDING] - free[..., BENDING])[:, question.layout.chambered]
    return bent.max(axis=1, initial=0.0) * end_height(question.design)


def _stretched_far(question: Question, pressure: float) -> list[str]:
    """Notes on materials that ``pressure`` [Pa] stretches beyond what was tested, or is stable."""
    from actuators.mechanics.continuum.findings import range_notes  # loads the 3D solver's kernels

    notes: list[str] = []
    for cell, path in zip(row_cells(question.design)[0], question.paths, strict=True):
        largest = [
            float(np.interp(abs(pressure), np.abs(path.pressure), stretch))
            for stretch in path.region_stretch.T
        ]
        notes += range_notes([material(region.material) for region in cell.regions], largest)
    return list(dict.fromkeys(notes))


def _gravity(question: Question, solved: Solved) -> Effect:
    gravity = question.scene.gravity
    if gravity is None or not any(gravity):
        return Effect("gravity", False, "the scene has none")
    reason = "the scene has it; the rod bears its own weight"
    found = len(solved.path.positions)
    if found == 0:
        return Effect("gravity", True, reason)
    layout = question.layout
    floating = weightless(layout.free(solved.chambers.free[found - 1])[None], layout.length)
    change = 100 * weight_change(
        solved.path, floating.positions[0, -1], float(layout.length.sum()),
        alone=is_plain(question.scene),
    )  # fmt: skip
    return Effect("gravity", True, reason, estimated_change_percent=change)


def _ends(question: Question) -> Effect:
    if question.root is not None:
        return Effect(
            "end_effects", True,
            "one linear solve of a few chambers says what the solid end at the clamp gives way",
        )  # fmt: skip
    if question.grip is None:
        return Effect(
            "end_effects", False,
            "every chamber answers as one in a long row, also near clamp and free end",
        )  # fmt: skip
    return Effect(
        "end_effects", True,
        "one linear solve of the body says what the clamp keeps from bending across the width",
    )  # fmt: skip


def _walls(contact: np.ndarray | None, paths: Sequence[CellPath]) -> str:
    if contact is None:
        return "no walls of neighbouring chambers face each other"
    begins = [p.touching_from for p in paths if p.touching_from is not None]
    if not begins or not (contact > 0).any():
        return "looked for in the periodic chamber, and no walls meet"
    return (
        f"walls of neighbouring chambers meet from about {min(begins, key=abs) / 1e3:.2g} kPa on, "
        "with up to "
        f"{contact.max() / 1e3:.3g} kPa"
    )


def _obstacles(scene: Scene) -> list[str]:
    return [name for name in ("plate", "cylinder") if getattr(scene, name) is not None]


def _pressed(question: Question, solved: Solved, number: int, name: str) -> str:
    force = np.linalg.norm(solved.path.obstacle_force[:, number], axis=-1)
    touching = np.flatnonzero(force > 0)
    if len(touching) == 0:
        return f"the {name} is not reached"
    first = solved.pressures[touching[0]] / 1e3
    return f"the {name} is pressed from about {first:.3g} kPa on, with up to {force.max():.3g} N"
