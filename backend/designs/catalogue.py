"""Families and presets as the page lists them."""

from functools import cache

from actuators.design import FAMILIES, PRESETS, Design, Parameter
from backend.designs.schemas import FamilyInfo, ParameterInfo, PresetInfo


@cache
def families() -> list[FamilyInfo]:
    """Every family with its parameters."""
    return [
        FamilyInfo(family=name, title=kind.title, parameters=_parameters(kind))
        for name, kind in FAMILIES.items()
    ]


def _parameters(kind: type[Design]) -> list[ParameterInfo]:
    defaults = kind.from_document({}).to_document()
    return [_parameter(p, defaults[p.border_name]) for p in kind.parameters()]


def _parameter(p: Parameter, default: float | str) -> ParameterInfo:
    return ParameterInfo(
        name=p.name, border_name=p.border_name, label=p.label, symbol=p.symbol, group=p.group,
        kind=p.kind, unit=p.unit, lower=p.lower, upper=p.upper, step=p.step,
        choices=list(p.choices), help=p.help, source=p.source, assumed=p.assumed, default=default,
    )  # fmt: skip


@cache
def presets() -> list[PresetInfo]:
    """Every preset, complete."""
    return [
        PresetInfo(
            name=p.name, title=p.title, description=p.description, source=p.source,
            design=p.design.to_document(), pressure_to_kPa=p.pressure_to / 1e3,
        )
        for p in PRESETS.values()
    ]  # fmt: skip
