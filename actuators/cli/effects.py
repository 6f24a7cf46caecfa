"""Effects on the command line: forcing them, and the table of what was decided."""

from collections.abc import Sequence

import click

from actuators.cli.tables import table
from actuators.errors import SceneError
from actuators.mechanics.choices import NAMES, Choice, checked_choices
from actuators.mechanics.response import Effect
from actuators.mechanics.scene import Scene
from actuators.quantities import percent

effect_option = click.option(
    "--effect", "choices", multiple=True, metavar="NAME=on|off|auto",
    help=f"Force a physical effect on or off: {', '.join(NAMES)}.",
)  # fmt: skip


def with_choices(scene: Scene, choices: Sequence[str]) -> Scene:
    """The scene with ``NAME=on|off|auto`` in place of its own choices."""
    if not choices:
        return scene
    named: dict[str, str] = {}
    for text in choices:
        name, equals, choice = (part.strip() for part in text.partition("="))
        if not (equals and name and choice):
            raise SceneError(
                f"--effect is {text!r}; it must be a name and a choice, such as gravity=off.",
                field="effect", value=text, mend="Write for example --effect gravity=off.",
            )  # fmt: skip
        named[name] = choice
    checked = checked_choices(named)
    chosen: dict[str, Choice] = {name: checked.get(name, "auto") for name in named}
    return scene.choosing(**chosen)


def print_effects(effects: Sequence[Effect]) -> None:
    """One line an effect: on or off, what leaving it out would change, what it costs, why."""
    if not effects:
        return
    rows = [
        (
            effect.name.replace("_", " "),
            ("on" if effect.on else "off") + (" (forced)" if effect.forced != "auto" else ""),
            _percent(effect.estimated_change_percent),
            _short(effect.cost_s),
            effect.reason,
        )
        for effect in effects
    ]
    click.echo("\n" + table(["effect", "", "tip without/%", "costs/s", "why"], rows))
    if any(effect.estimated_change_percent is not None for effect in effects):
        click.echo(
            "tip without: how far the tip lies from where it would without the effect (with it, "
            "where it is off), estimated, in percent of its longest way from the straight body, "
            "sag included."
        )


def _percent(value: float | None) -> str | None:
    return None if value is None else percent(value / 100).removesuffix(" %")


def _short(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.2g}")
