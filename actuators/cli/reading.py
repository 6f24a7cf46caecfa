"""What commands read: designs by name or file, changes to them, scenes, JSON files."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

import click

from actuators.design import PRESETS, Design, parse_design, preset
from actuators.design.parameter import Parameter
from actuators.errors import DesignError, InputError, QuestionError, SceneError
from actuators.materials import material
from actuators.mechanics.scene import Scene
from actuators.quantities import parse_number, parse_quantity


def read_design(name: str, changes: Sequence[str] = ()) -> Design:
    """Design of a preset or a file, with ``name=quantity`` changes applied together."""
    looks_like_file = name.lower().endswith(".json") or "/" in name or Path(name).is_file()
    if name in PRESETS or not looks_like_file:
        design = preset(name).design
    else:
        document = read_json(name, field="design")
        # what `show --json` and `predict --json` print holds the design under its name
        inner = document.get("design")
        if "family" not in document and isinstance(inner, dict):
            document = cast("dict[str, Any]", inner)
        design = parse_design(document)
    if changes:
        design = design.changed(**dict(_change(text, design) for text in changes))
    for p in design.parameters():
        if p.kind == "material":
            material(getattr(design, p.name), field=p.name)
    return design


def _change(text: str, design: Design) -> tuple[str, Any]:
    """One ``name=quantity``: plain name and value in border units."""
    name, equals, given = text.partition("=")
    name, given = name.strip(), given.strip()
    if not (equals and name and given):
        raise DesignError(
            f"--set is {text!r}; it must be a name and a value, such as bottom_thickness=4mm.",
            field="set", value=text, mend="Write for example --set bottom_thickness=4mm.",
        )  # fmt: skip
    for p in design.parameters():
        if name == p.name or name == p.border_name:
            return p.name, _border_value(p, given, unit_in_name=name != p.name)
    return name, given  # Design.changed knows the near names


def _border_value(p: Parameter, given: str, *, unit_in_name: bool) -> Any:
    if p.kind in ("choice", "material"):
        return given
    if p.kind in ("count", "ratio"):
        return parse_number(given, field=p.name)
    if unit_in_name and given[-1].isdigit():
        given += p.unit
    dimension = "angle" if p.kind == "angle" else "length"
    value = parse_quantity(given, dimension, field=p.name) / p.si_per_unit
    return float(f"{value:.12g}")


def read_scene(pressure: str | None, file: str | None, steps: int | None) -> Scene:
    """Scene of a file, whose pressure and steps the options replace, or of the pressure alone.

    What an option replaces by another value is said on standard error.
    """
    if file is None and pressure is None:
        raise SceneError(
            "pressure is missing; give --pressure 30kPa or --scene FILE.",
            field="pressure", mend="Give --pressure 30kPa or --scene FILE.",
        )  # fmt: skip
    document: dict[str, Any] = {} if file is None else read_json(file, field="scene")
    key = "volume_ml" if "volume_ml" in document and pressure is None else "pressure_kPa"
    path = document.get(key, {})
    if isinstance(path, dict):
        given = dict(cast("dict[str, Any]", path))
        if pressure is not None:
            end = parse_quantity(pressure, "pressure", field="pressure") / 1e3
            _tell_replaced("--pressure", pressure, f"{key}.to", given.get("to"), end)
            given["to"] = end
        if steps is not None:
            _tell_replaced("--steps", str(steps), f"{key}.steps", given.get("steps"), steps)
            given["steps"] = steps
        document[key] = given
    return Scene.from_document(document)


def _tell_replaced(option: str, given: str, entry: str, before: Any, after: float) -> None:
    if before not in (None, "auto", after):
        click.echo(f"{option} {given} replaces {entry} {before} of the scene file.", err=True)


def read_accuracy(text: str) -> float:
    """``2%`` as a fraction; raises :class:`QuestionError` outside 0.01 % to 100 %."""
    accuracy = parse_quantity(text, "fraction", field="accuracy")
    if not 1e-4 <= accuracy <= 1.0:
        raise QuestionError(
            f"accuracy is {text.strip()!r}; it must lie between 0.01 % and 100 %. "
            "Write for example 5%.",
            field="accuracy", value=text, mend="Write for example 5%.",
        )  # fmt: skip
    return accuracy


def check_mesh(mesh: str | None, design: Design) -> None:
    """Raise :class:`QuestionError` for a mesh that cannot be made, before anything is solved."""
    if mesh is None:
        return
    from actuators.geometry import build_body
    from actuators.meshing.levels import layers_of

    layers_of(build_body(design), mesh)


change_option = click.option(
    "--set", "changes", multiple=True, metavar="NAME=QUANTITY",
    help="Change a parameter: bottom_thickness=4mm, top_material=ecoflex-00-50; a material may end "
    "in @incompressible (see `materials`).",
)  # fmt: skip


def read_json(path: str, *, field: str) -> dict[str, Any]:
    """An object of a JSON file; anything else raises :class:`InputError` about ``field``."""

    def refuse(message: str, mend: str) -> InputError:
        return InputError(f"{field} {path!r} {message} {mend}", field=field, value=path, mend=mend)

    def constant(text: str) -> float:
        raise refuse(f"holds {text}, which is not a number.", "Replace it by a finite number.")

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        document: dict[str, Any] = {}
        for key, value in pairs:
            if key in document:
                raise refuse(f"holds {key} twice.", "Keep one of the two.")
            document[key] = value
        return document

    try:
        text = Path(path).read_text(encoding="utf-8")
        document: Any = json.loads(text, parse_constant=constant, object_pairs_hook=unique)
    except FileNotFoundError as error:
        mend = "Check the path, or name a preset." if field == "design" else "Check the path."
        raise refuse("does not exist.", mend) from error
    except UnicodeDecodeError as error:
        raise refuse("is not text in UTF-8.", "Give a JSON file.") from error
    except (OSError, ValueError, RecursionError) as error:
        raise refuse(f"cannot be read: {error}.", "Give a JSON file.") from error
    if not isinstance(document, dict):
        raise refuse("does not hold an object.", "Give a JSON object: {...}.")
    return cast("dict[str, Any]", document)
