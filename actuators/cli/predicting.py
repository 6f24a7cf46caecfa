"""The command that answers: how DESIGN moves under pressure."""

from collections.abc import Callable
from typing import Any

import click

from actuators.cli.effects import effect_option, print_effects, with_choices
from actuators.cli.reading import change_option, check_mesh, read_accuracy, read_design, read_scene
from actuators.cli.solving import Interruptible, show_progress
from actuators.cli.studio import answer, exit_code, json_option, strict_option
from actuators.cli.tables import table
from actuators.design import Design
from actuators.errors import QuestionError
from actuators.mechanics.response import PathPoint, Response
from actuators.mechanics.scene import Scene
from actuators.quantities import parse_number, percent

RUNGS = ("closed-form", "energy", "cell-rod", "fe")


@click.command()
@click.argument("design")
@click.option("--pressure", metavar="QUANTITY", help="End of the pressure path, such as 30kPa.")
@click.option("--scene", "scene_file", metavar="FILE", help="Scene as a JSON file.")
@click.option("--rung", default="energy", show_default=True, metavar="|".join(RUNGS), help="Model.")
@click.option("--accuracy", metavar="PERCENT", help="Wanted accuracy, such as 2% (rung fe).")
@click.option("--mesh", metavar="NAME|I,J,K", help="Mesh instead of an accuracy: coarse, medium, "
              "fine, finest, or thin layers along X1, X2, X3 (rung fe).")  # fmt: skip
@change_option
@click.option("--steps", type=int, help="Number of equal pressure steps.")
@click.option("--c", "constant", metavar="computed|published|VALUE", help="Constant of the energy "
              "rung (default computed).")  # fmt: skip
@effect_option
@strict_option
@json_option
def predict(
    design: str,
    pressure: str | None,
    scene_file: str | None,
    rung: str,
    accuracy: str | None,
    mesh: str | None,
    changes: tuple[str, ...],
    steps: int | None,
    constant: str | None,
    choices: tuple[str, ...],
    *,
    strict: bool,
    as_json: bool,
) -> int:
    """Predict how DESIGN (a preset or a JSON file) bends and twists under pressure.

    Exit code 0 on an answer, also where its path ended early (with --strict: 3), 2 on bad input.
    """
    chosen = read_design(design, changes)
    scene = with_choices(read_scene(pressure, scene_file, steps), choices)
    response = _ask(chosen, scene, rung, accuracy, mesh, constant)
    if as_json:
        answer(response.to_document())
    else:
        _print(response)
    return exit_code(response.outcome, strict=strict)


def _ask(
    design: Design,
    scene: Scene,
    rung: str,
    accuracy: str | None,
    mesh: str | None,
    constant: str | None,
) -> Response:
    if rung not in RUNGS:
        raise QuestionError(
            f"rung is {rung!r}; it must be one of {', '.join(RUNGS)}.",
            field="rung", value=rung, mend=f"Use one of {', '.join(RUNGS)}.",
        )  # fmt: skip
    for field, given in (("accuracy", accuracy), ("mesh", mesh)):
        if given is not None and rung != "fe":
            raise QuestionError(
                f"{field} is {given!r}, but the rung {rung} has no {field} to choose. "
                "Leave it out, or use --rung fe.",
                field=field, value=given, mend="Leave it out, or use --rung fe.",
            )  # fmt: skip
    if accuracy is not None and mesh is not None:
        raise QuestionError(
            f"accuracy is {accuracy!r}, but the mesh is chosen already ({mesh}). Leave out one of "
            "--accuracy and --mesh.",
            field="accuracy", value=accuracy, mend="Leave out one of --accuracy and --mesh.",
        )  # fmt: skip
    check_mesh(mesh, design)
    if constant is not None and rung != "energy":
        raise QuestionError(
            f"c is {constant!r}, but only the energy rung has this constant. "
            "Leave it out, or use --rung energy.",
            field="c", value=constant, mend="Leave it out, or use --rung energy.",
        )  # fmt: skip
    if rung == "fe":
        return _solve(design, scene, accuracy, mesh)
    from actuators.mechanics.predict import predict

    return predict(design, scene, rung=rung, c=_constant(constant))


def _constant(text: str | None) -> Any:
    if text in (None, "computed"):
        return "computed"
    if text == "published":
        return "published"
    return parse_number(str(text), field="c")


def _solve(design: Design, scene: Scene, accuracy: str | None, mesh: str | None) -> Response:
    wanted: dict[str, Any] = {} if mesh is None else {"mesh": mesh}
    if accuracy is not None:
        wanted["accuracy"] = read_accuracy(accuracy)
    from actuators.cli.past_jobs import remember, tell_expected
    from actuators.mechanics.ladder import Rung

    rung = Rung("fe", wanted.get("accuracy", 0.05), mesh)
    tell_expected(design, scene, rung)
    from actuators.mechanics.continuum import solve

    with Interruptible() as interrupted:
        response = solve(design, scene, progress=show_progress(), cancelled=interrupted, **wanted)
    remember(response, rung, is_first=True)
    return response


_COLUMNS: tuple[tuple[str, Callable[[PathPoint], float | None]], ...] = (
    ("p/kPa", lambda p: p.to_document()["pressure_kPa"]),
    ("bending/deg", lambda p: p.to_document()["bending_angle_deg"]),
    ("tip turn/deg", lambda p: p.to_document()["tip_rotation_deg"]),
    ("tip x1/mm", lambda p: p.to_document()["tip_mm"][0]),
    ("x2/mm", lambda p: p.to_document()["tip_mm"][1]),
    ("x3/mm", lambda p: p.to_document()["tip_mm"][2]),
    ("curvature/(1/m)", lambda p: p.to_document()["curvature_per_m"]),
    ("torsion/(1/m)", lambda p: p.to_document()["torsion_per_m"]),
    ("cavity/ml", lambda p: p.to_document()["cavity_volume_ml"]),
    ("plate/N", lambda p: p.to_document()["plate_force_N"]),
    ("cylinder/N", lambda p: p.to_document()["cylinder_force_N"]),
    ("contact/kPa", lambda p: p.to_document()["max_contact_pressure_kPa"]),
    ("stretch", lambda p: p.to_document()["max_principal_stretch"]),
)


def _print(response: Response) -> None:
    rows = [[_rounded(column(point)) for _, column in _COLUMNS] for point in response.path]
    known = [c for c in range(len(_COLUMNS)) if any(row[c] is not None for row in rows)]
    if rows:
        click.echo(table([_COLUMNS[c][0] for c in known], [[r[c] for c in known] for r in rows]))
    else:
        click.echo("No point of the path was found.")
    error = response.error_estimate
    click.echo(
        f"\nRung {response.rung}: {response.outcome.value}"
        + ("" if error is None else f", estimated error {percent(error)}{_others(response)}")
        + f", {response.wall_s:.3g} s"
        + (f", {response.unknowns} unknowns" if response.unknowns else "")
    )
    for sentence in (*([response.advice] if response.advice else []), *response.notes):
        click.echo(f"  {sentence}")
    for sentence in response.design.assumptions():
        click.echo(f"  Assumed: {sentence}")
    print_effects(response.effects)


def _others(response: Response) -> str:
    """Estimated errors of what is not the tip's displacement."""
    named = {"angle": "turn", "force": "force", "volume": "cavity growth",
             "limit_pressure": "limit pressure"}  # fmt: skip
    each = [
        f"{word} {percent(response.error_estimates[name])}"
        for name, word in named.items()
        if name in response.error_estimates
    ]
    return f" ({', '.join(each)})" if each else ""


def _rounded(value: float | None) -> float | None:
    # what rounding leaves of a zero is noise in a table
    return None if value is None else round(value, 4) + 0.0
