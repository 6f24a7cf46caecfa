"""Rungs 1 to 3: the answers while a slider moves, and as soon as it rests."""

import time
from dataclasses import replace
from typing import Any

import numpy as np

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.geometry.volumes import exact_volumes
from actuators.mechanics.cell.row import ChamberRow, chamber_row, pitch_starts
from actuators.mechanics.closed_form import bending_rates
from actuators.mechanics.effects.obeyed import marked, obeyed
from actuators.mechanics.energy_model import (
    Constant,
    check_constant,
    computed_constant,
    design_layers,
    published_constant,
    rod_strains,
)
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.rod import (
    RodPath,
    centreline,
    follow_pressures,
    path_points,
    rod_of,
    weightless,
)
from actuators.mechanics.rod.carried import follow_scene
from actuators.mechanics.rod.effects import (
    MEANINGLESS_STRAIN,
    closed_form_effects,
    is_plain,
    rod_effects,
    small_strain_limit,
    strain_notes,
)
from actuators.mechanics.scene import Scene
from actuators.quantities import percent, two_digits

STEPS = 20
"""Equal pressure steps where the scene leaves the choice to the rung."""

RUNGS = ("closed-form", "energy", "cell-rod")


def predict(
    design: Design,
    scene: Scene,
    *,
    rung: str = "energy",
    c: Any = "computed",
    steps: int | None = None,
) -> Response:
    """Answer at zero pressure and at every step of pressure or volume.

    ``rung``: ``"closed-form"``, ``"energy"`` or ``"cell-rod"``, whose new cells take some tenths of
    a second; the three-dimensional solver is another door. ``c`` (energy only): ``"computed"``
    takes each chamber's free response from its periodic cell; ``"published"`` and numbers scale the
    energy model instead, on a rod of the same stiffness.
    ``steps`` goes before the scene's own. Raises :class:`QuestionError` for a rung or constant that
    is none.
    """
    begun = time.perf_counter()
    constant = check_constant(c)
    count = steps if steps is not None else (scene.steps or STEPS)
    if not 1 <= count <= 1000:
        raise QuestionError(
            f"steps is {count}; it must lie between 1 and 1000.",
            field="steps", value=str(count), mend="Use 1 to 1000 steps.",
        )  # fmt: skip
    if rung not in RUNGS:
        raise QuestionError(
            f"rung is {rung!r}; the models of this door are {', '.join(RUNGS)}.",
            field="rung", value=repr(rung), mend=f"Use one of {', '.join(RUNGS)}.",
        )  # fmt: skip
    left, kept = obeyed(design, scene, rung)
    if rung == "cell-rod":
        # imported here: it calls the 3D solver's kernels, which the web process does without
        from actuators.mechanics.cell_rod.answer import answer

        return marked(answer(left, kept, count), design, scene)
    pressures = np.linspace(0.0, _end(kept, rung), count + 1)
    if rung == "energy":
        response = _energy(left, kept, pressures, constant, begun)
    else:
        response = _closed_form(left, kept, pressures, begun)
    return marked(response, design, scene)


def _end(scene: Scene, rung: str) -> float:
    """Pressure [Pa] at the end; refuses what this rung cannot carry, naming the one that can."""
    carried = ("outside_pressure", "tip_force") if rung == "energy" else ()
    beyond = {
        name: value
        for name, value in _beyond_pressure_and_weight(scene).items()
        if value and name not in carried
    }
    if scene.pressure_to is not None and scene.pressure_to < 0.0:
        beyond["pressure"] = f"{scene.pressure_to / 1e3:g} kPa (suction)"
    if beyond or scene.pressure_to is None:
        raise _beyond(rung, beyond)
    return scene.pressure_to


def _beyond_pressure_and_weight(scene: Scene) -> dict[str, str]:
    """Every other load as a designer writes it; empty where the scene has none."""
    volume, force, plate, cylinder = scene.volume_to, scene.tip_force, scene.plate, scene.cylinder
    outside = scene.outside_pressure
    return {
        "volume": "" if volume is None else f"{volume * 1e6:g} ml",
        "outside_pressure": f"{outside / 1e3:g} kPa" if outside else "",
        "tip_force": "" if force is None else f"({', '.join(f'{f:g}' for f in force)}) N",
        "plate": "" if plate is None else f"{plate.gap * 1e3:g} mm away",
        "cylinder": "" if cylinder is None else f"{cylinder.radius * 2e3:g} mm thick",
    }


def _beyond(rung: str, found: dict[str, str]) -> QuestionError:
    """Names all of them, and the first as the field to change."""
    instead = {"volume": "give a pressure", "pressure": "give a pressure above 0 kPa"}
    ways = [instead.get(name, f"leave {name} out") for name in found]
    mend = f"Use the rung cell-rod or fe, or {' and '.join(ways)}."
    listed = " and ".join(f"{name} is {value}" for name, value in found.items())
    name, value = next(iter(found.items()))
    known = ", weight, a tip force and outside pressure" if rung == "energy" else ""
    return QuestionError(
        f"{listed}, which the rung {rung} cannot carry: it knows pressure{known} only. "
        f"{mend}",
        field=name, value=value, mend=mend,
    )  # fmt: skip


def _energy(
    design: Design, scene: Scene, pressures: np.ndarray, constant: Constant, begun: float
) -> Response:
    row = chamber_row(design)
    asked, last = float(pressures[-1]), MEANINGLESS_STRAIN / max(row.largest_strain, 1e-300)
    if asked > last:
        pressures = np.linspace(0.0, last, len(pressures))
    solved = time.perf_counter()
    free, notes = _free_strains(design, row, constant)
    rod = rod_of(design, row, free)
    if is_plain(scene):
        path = follow_pressures(rod, pressures, scene.gravity)
    else:
        path = follow_scene(design, row, free, pressures, scene)
    outcome, advice = _outcome(path, pressures)
    if outcome is Outcome.CONVERGED and asked > last:
        outcome, advice = Outcome.STALLED, _beyond_meaning(row.largest_strain, asked)
    if len(path.positions) == 0:  # what there is without its loads is better than nothing
        path = replace(
            weightless(np.zeros((1, len(rod.length), 4)), rod.length), iterations=path.iterations
        )
    # without weight the strains are known: what gravity changes costs one more walk along the rod
    last = pressures[max(len(path.positions) - 1, 0)]
    floating = weightless((last * rod.free)[None], rod.length)
    volume = exact_volumes(design).cavity + row.cavity_compliance.sum() * pressures
    points = path_points(path, rod.length, rod.chambered, pressures, volume)
    ended = time.perf_counter()
    return Response(
        design=design,
        scene=scene,
        rung="energy",
        outcome=outcome,
        path=points,
        advice=advice,
        centreline=centreline(path, rod.length),
        wall_s=ended - begun,
        unknowns=row.unknowns,
        newton_iterations=path.iterations,
        effects=rod_effects(scene, path, floating, design.length, cost=ended - solved),
        notes=(*notes, *strain_notes(row.largest_strain, float(last))),
        trusted_to=small_strain_limit(row.largest_strain, float(last)),
        timings={"cell": solved - begun, "rod": ended - solved},
    )


def _free_strains(
    design: Design, row: ChamberRow, constant: Constant
) -> tuple[np.ndarray, tuple[str, ...]]:
    """Rod strains per pressure (n, 4) of every chamber, and what to say about them."""
    energy = rod_strains(design_layers(design))
    computed = computed_constant(row.free, energy)
    if constant == "computed":
        return row.free, (_about(computed),)
    value = published_constant(design) if constant == "published" else float(constant)
    origin = "published (G, Table 2)" if constant == "published" else "given"
    return value * energy, (f"c = {value:.3g}, {origin}. For comparison: {_about(computed)}",)


def _about(computed: float) -> str:
    """What to say about the constant that the periodic chamber gives."""
    if computed > 0:
        return f"c = {computed:.3g}, computed from the periodic chamber."
    return (
        "Computed from the periodic chamber; no c makes the energy model bend as it does, because "
        "with walls that stay flat this body bends the other way."
    )


def _outcome(path: RodPath, pressures: np.ndarray) -> tuple[Outcome, str | None]:
    if len(path.positions) == len(pressures):
        return Outcome.CONVERGED, None
    lost = pressures[len(path.positions)] / 1e3
    shown = "" if len(path.positions) else " Shown is the body without its loads."
    return Outcome.STALLED, (
        f"The rod found no equilibrium under its loads at {lost:.4g} kPa.{shown} Shorten the body, "
        "stiffen it or thicken its bottom layer, or leave gravity out."
    )


def _beyond_meaning(per_pressure: float, asked: float) -> str:
    trusted = two_digits((small_strain_limit(per_pressure, asked) or asked) / 1e3)
    return (
        f"At {asked / 1e3:g} kPa the strain would reach {percent(per_pressure * asked)}, of which "
        f"this linear model knows nothing: it is meant for less than {trusted} kPa. Ask for less, "
        "or use the rung cell-rod or fe, which find the limit pressure."
    )


def _closed_form(design: Design, scene: Scene, pressures: np.ndarray, begun: float) -> Response:
    rates = bending_rates(design)
    start, pitch = pitch_starts(design)
    row_end = min(start[-1] + pitch, design.length)
    borders = np.concatenate([np.maximum(start, 0.0), [row_end]])
    ends = (int(borders[0] > 0), int(row_end < design.length))
    borders = np.concatenate([[0.0] * ends[0], borders, [design.length] * ends[1]])
    turn = np.pad(rates * pitch, ends)
    chambered = np.pad(np.ones(len(rates), dtype=bool), ends)
    length = np.diff(borders)
    strains = np.zeros((len(pressures), len(length), 4))
    strains[:, :, 2] = np.outer(pressures, turn / length)
    path = weightless(strains, length)
    ended = time.perf_counter()
    return Response(
        design=design,
        scene=scene,
        rung="closed-form",
        outcome=Outcome.CONVERGED,
        path=path_points(path, length, chambered, pressures, None),
        centreline=centreline(path, length),
        wall_s=ended - begun,
        effects=closed_form_effects(scene),
        notes=(
            "Equivalent section in pure bending: no twist, no weight, no bulging of walls; an "
            "order of magnitude.",
        ),
        timings={"section": ended - begun},
    )
