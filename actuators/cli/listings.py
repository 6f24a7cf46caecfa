"""Commands that look things up: presets, materials, show."""

from typing import Any

import click

from actuators.cli.reading import change_option, read_design
from actuators.cli.studio import answer, json_option
from actuators.cli.tables import table
from actuators.design import PRESETS, Design
from actuators.design.parameter import Parameter


@click.command()
@json_option
def presets(*, as_json: bool) -> None:
    """List the actuators of the source papers."""
    if as_json:
        answer(
            [
                {"name": p.name, "title": p.title, "description": p.description,
                 "source": p.source, "pressure_to_kPa": p.pressure_to / 1e3,
                 "design": p.design.to_document()}
                for p in PRESETS.values()
            ]
        )  # fmt: skip
        return
    rows = [(p.name, f"{p.pressure_to / 1e3:g} kPa", p.description) for p in PRESETS.values()]
    click.echo(table(("preset", "up to", "what it is"), rows))


@click.command()
@json_option
def materials(*, as_json: bool) -> None:
    """List the rubbers that a design can name.

    KEY@incompressible names the same rubber, exactly incompressible; KEY@nu=0.4999, KEY@bulk=1e4
    (kappa/mu) and KEY@stiffness=10 (all stresses) change it, one after the other.
    """
    from actuators.materials import CATALOGUE

    if as_json:
        answer(
            [
                {"key": m.key, "name": m.name, "model": m.law.model,
                 "shear_modulus_kPa": m.shear_modulus / 1e3,
                 "youngs_modulus_kPa": m.youngs_modulus / 1e3,
                 "density_kg_m3": m.density, "source": m.source, "note": m.note,
                 "constants": m.law.to_document()}
                for m in CATALOGUE.values()
            ]
        )  # fmt: skip
        return
    rows = [
        (m.key, m.law.model, m.shear_modulus / 1e3, m.youngs_modulus / 1e3, m.density, m.source)
        for m in CATALOGUE.values()
    ]
    headings = ("material", "model", "mu/kPa", "E/kPa", "kg/m3", "source")
    click.echo(table(headings, rows))
    click.echo(
        "\nKEY@incompressible: the same rubber, exactly incompressible; KEY@nu=0.4999, "
        "KEY@bulk=1e4 (kappa/mu) and KEY@stiffness=10 (all stresses) change it."
    )


@click.command()
@click.argument("design")
@change_option
@json_option
def show(design: str, changes: tuple[str, ...], *, as_json: bool) -> None:
    """Show every parameter of DESIGN (a preset or a JSON file), its unit, limits and source."""
    from actuators.geometry.derived import derived

    chosen = read_design(design, changes)
    follows = derived(chosen)
    if as_json:
        answer(
            {
                "design": chosen.to_document(),
                "digest": chosen.digest,
                "parameters": [_document(p, chosen) for p in chosen.parameters()],
                "derived": [{"label": d.label, "value": d.value, "unit": d.unit} for d in follows],
                "assumptions": list(chosen.assumptions()),
            }
        )
        return
    click.echo(f"{chosen.title}, design {chosen.digest[:12]}\n")
    click.echo(table(("parameter", "symbol", "value", "limits", "source"), _rows(chosen)))
    click.echo()
    click.echo(table(("follows", "value", ""), [(d.label, d.value, d.unit) for d in follows]))
    if chosen.assumptions():
        click.echo("\nAssumed (*):")
        for sentence in chosen.assumptions():
            click.echo(f"  {sentence}")


def _rows(design: Design) -> list[tuple[str, str, str, str, str]]:
    return [
        (f"{p.name}{' *' if p.assumed else ''}", p.symbol, f"{_value(p, design)} {p.unit}".rstrip(),
         _limits(p), p.source)
        for p in design.parameters()
    ]  # fmt: skip


def _limits(p: Parameter) -> str:
    if p.choices:
        return ", ".join(p.choices)
    if p.lower is None or p.upper is None:
        return "see materials" if p.kind == "material" else ""
    return f"{p.lower:g} to {p.upper:g} {p.unit}".rstrip()


def _value(p: Parameter, design: Design) -> Any:
    value = design.to_document()[p.border_name]
    return f"{value:.6g}" if isinstance(value, float) else value


def _document(p: Parameter, design: Design) -> dict[str, Any]:
    return {
        "name": p.name, "label": p.label, "symbol": p.symbol, "group": p.group, "kind": p.kind,
        "value": design.to_document()[p.border_name], "unit": p.unit, "lower": p.lower,
        "upper": p.upper, "choices": list(p.choices), "help": p.help, "source": p.source,
        "assumed": p.assumed,
    }  # fmt: skip
