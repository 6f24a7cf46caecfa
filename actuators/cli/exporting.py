"""The command that writes files."""

import json
from dataclasses import replace
from pathlib import Path

import click

from actuators.cli.effects import effect_option, with_choices
from actuators.cli.reading import (
    change_option,
    check_mesh,
    read_accuracy,
    read_design,
    read_scene,
)
from actuators.cli.solving import Interruptible, show_progress
from actuators.cli.studio import answer, exit_code, json_option, strict_option
from actuators.cli.tables import table
from actuators.errors import QuestionError
from actuators.mechanics.response import Outcome


@click.command()
@click.argument("design")
@click.option(
    "--what",
    required=True,
    metavar="KIND,...",
    help="mould-svg, actuator-stl; for one scene: inp (deck for Abaqus and CalculiX), vtu (solves, "
    "then fields for ParaView).",
)
@click.option("--to", "folder", required=True, metavar="FOLDER", help="Folder to write into.")
@click.option("--pressure", metavar="QUANTITY", help="End of the pressure path, such as 30kPa.")
@click.option("--scene", "scene_file", metavar="FILE", help="Scene as a JSON file.")
@click.option("--accuracy", metavar="PERCENT", help="Wanted accuracy of vtu, such as 2%.")
@click.option(
    "--mesh",
    metavar="NAME|I,J,K",
    help="coarse, medium, fine, finest, or thin layers along X1, X2, X3.",
)
@click.option("--element", default="C3D20R", show_default=True, metavar="TYPE",
              help="Element of an inp deck: C3D20R, C3D20, C3D8.")  # fmt: skip
@change_option
@effect_option
@strict_option
@json_option
def export(
    design: str,
    what: str,
    folder: str,
    pressure: str | None,
    scene_file: str | None,
    accuracy: str | None,
    mesh: str | None,
    element: str,
    changes: tuple[str, ...],
    choices: tuple[str, ...],
    *,
    strict: bool,
    as_json: bool,
) -> int:
    """Write files of DESIGN (a preset or a JSON file); files of the same name are replaced.

    Exit code 0 where files were written, also of a path that ended early (with --strict: 3), 2 on
    bad input.
    """
    from actuators.export import ModelQuestion, notes, write

    chosen = read_design(design, changes)
    check_mesh(mesh, chosen)
    kinds = dict.fromkeys(kind.strip() for kind in what.split(","))
    # everything is made before anything is written: a bad kind leaves no half set of files
    question = None
    with Interruptible() as interrupted:
        if pressure is not None or scene_file is not None:
            question = ModelQuestion(
                with_choices(read_scene(pressure, scene_file, None), choices), mesh, element,
                progress=show_progress(), cancelled=interrupted, solving=True,
            )  # fmt: skip
            if accuracy is not None:
                question = replace(question, accuracy=read_accuracy(accuracy))
        made = {kind: write(chosen, kind, question) for kind in kinds}
    target = Path(folder)
    written: list[tuple[str, str, int]] = []
    try:
        target.mkdir(parents=True, exist_ok=True)
        for kind, files in made.items():
            for name, data in files.items():
                (target / name).write_bytes(data)
                written.append((name, kind, len(data)))
    except OSError as error:
        raise QuestionError(
            f"to is {folder!r}, where nothing can be written: {error.strerror}. "
            "Choose another folder.",
            field="to", value=folder, mend="Choose another folder.",
        ) from error  # fmt: skip
    remarks = [note for kind in kinds for note in notes(chosen, kind)]
    outcome = Outcome.CONVERGED
    if "vtu" in made:
        found = json.loads(made["vtu"]["answer.json"])
        outcome = Outcome(found["outcome"])
        if outcome is not Outcome.CONVERGED:
            remarks.append(f"vtu: {outcome.value}. {found['advice'] or ''}".rstrip())
    code = exit_code(outcome, strict=strict)
    if as_json:
        files = [{"name": name, "what": kind, "bytes": size} for name, kind, size in written]
        answer({"folder": str(target), "digest": chosen.digest, "files": files,
                "notes": remarks})  # fmt: skip
        return code
    click.echo(table(("file", "what", "bytes"), written))
    click.echo(f"\nin {target}")
    for remark in remarks:
        click.echo(f"  {remark}")
    return code
