"""What a parameter of a design is: its label, unit, limits and source, beside the value itself."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from pydantic import Field
from pydantic.fields import FieldInfo

Kind = Literal["length", "angle", "count", "ratio", "choice", "material"]

BORDER_UNIT: Mapping[Kind, tuple[str, float]] = {
    # kind -> (unit at the border, SI value of one such unit)
    "length": ("mm", 1e-3),
    "angle": ("deg", 0.017453292519943295),
    "count": ("", 1.0),
    "ratio": ("", 1.0),
    "choice": ("", 1.0),
    "material": ("", 1.0),
}


@dataclass(frozen=True)
class Parameter:
    """One parameter of a family. ``lower``, ``upper`` and ``step`` are in border units."""

    name: str
    label: str
    symbol: str
    group: str
    kind: Kind
    unit: str
    lower: float | None
    upper: float | None
    step: float | None
    choices: tuple[str, ...]
    help: str
    source: str
    assumed: str

    @property
    def border_name(self) -> str:
        """Name in documents, with the unit: ``bottom_thickness_mm``."""
        return f"{self.name}_{self.unit}" if self.unit else self.name

    @property
    def si_per_unit(self) -> float:
        """SI value of one border unit."""
        return BORDER_UNIT[self.kind][1]


def parameter(
    default: Any,
    *,
    label: str,
    group: str,
    kind: Kind,
    symbol: str = "",
    lower: float | None = None,
    upper: float | None = None,
    step: float | None = None,
    choices: tuple[str, ...] = (),
    help: str = "",
    source: str = "",
    assumed: str = "",
) -> Any:
    """Declare a pydantic field that carries a :class:`Parameter`.

    ``default``, ``lower``, ``upper`` and ``step`` are given in border units (mm, degrees) and the
    default is stored in SI. ``assumed`` is a sentence, empty unless the sources do not give the
    dimension; it travels into every result.
    """
    scale = BORDER_UNIT[kind][1]
    value = default * scale if kind in ("length", "angle") else default
    return Field(
        default=value,
        json_schema_extra={
            "label": label, "group": group, "kind": kind, "symbol": symbol, "lower": lower,
            "upper": upper, "step": step, "choices": list(choices), "help": help,
            "source": source, "assumed": assumed,
        },
    )  # fmt: skip


def describe(name: str, field: FieldInfo) -> Parameter:
    """Read the :class:`Parameter` back from a pydantic field made by :func:`parameter`."""
    extra = field.json_schema_extra
    if not isinstance(extra, dict):
        raise TypeError(f"field {name} was not declared with parameter()")
    extra = dict(extra)
    kind: Any = extra["kind"]
    choices: Any = extra.pop("choices")
    rest: Any = extra
    return Parameter(name=name, unit=BORDER_UNIT[kind][0], choices=tuple(choices), **rest)
